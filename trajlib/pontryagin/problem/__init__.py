"""The statement of an optimal control problem, its conditions in symbols, and its numeric form."""
