"""Grading inside Gradescope: a bundle to upload, and what runs there for each submission."""
