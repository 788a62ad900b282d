"""Commands, and how they write to a terminal."""
