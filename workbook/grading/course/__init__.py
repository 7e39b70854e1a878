"""A course: who, what is handed out, what was handed in, when, and the grades."""
