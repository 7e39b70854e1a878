"""Oracles of the checks of observers and feedbacks."""
