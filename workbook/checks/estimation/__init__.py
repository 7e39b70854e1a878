"""Judges moments, least squares, random processes and their filters."""
