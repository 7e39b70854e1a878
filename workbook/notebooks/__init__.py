"""Notebooks: find the exercises, run their cells, and see which modules they use."""
