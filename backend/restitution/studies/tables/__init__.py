"""Tables of ε_t for other codes."""
