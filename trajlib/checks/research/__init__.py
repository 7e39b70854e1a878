"""Checks of the research chapters: 6, reconstruction, 7, solvability, and 8, interpolation and invariance."""
