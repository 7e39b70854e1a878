"""Checks of observers and feedbacks: closed loops, what no gain changes, equations of observers."""
