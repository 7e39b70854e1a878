"""Checks of algebra that need no data of a problem."""
