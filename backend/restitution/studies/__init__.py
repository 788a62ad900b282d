"""What a scene shows, and no more: frozen dataclasses of arrays."""
