"""Checks of the research chapters: 6, reconstruction, and 7, solvability."""
