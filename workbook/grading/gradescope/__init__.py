"""The same grading inside Gradescope: a bundle to upload, and what runs there for each
submission."""
