"""Planar syntheses, by extremals that are integrated backwards from the target."""
