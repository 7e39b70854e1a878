"""Checks of moments, least squares, random processes and filters."""
