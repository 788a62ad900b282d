"""Every way to get ε_t, one module each, one signature; `planner` picks by tolerance."""
