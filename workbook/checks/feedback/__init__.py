"""Checks of observers and feedbacks."""
