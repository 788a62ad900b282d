"""Tables of ε_t in the languages of other codes."""
