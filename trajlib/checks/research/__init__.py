"""Checks of the research chapters: 6, reconstruction, 7, solvability, 8, interpolation and invariance, and 9, information
sets."""
