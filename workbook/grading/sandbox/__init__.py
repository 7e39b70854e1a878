"""Run a student's notebook so that it can reach nothing but its own answers."""
