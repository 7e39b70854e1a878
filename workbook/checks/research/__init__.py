"""Checks of the research chapters: 6, reconstruction, 7, solvability, 8, interpolation and
invariance, 9, information sets."""
