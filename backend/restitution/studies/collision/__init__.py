"""Collisions in scaled units: one, many, along a line, over a plane, over time."""
