"""Optima of time, by support functions: they know no law and no shooting."""
