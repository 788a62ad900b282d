"""Collisions of real bodies, in SI units."""
