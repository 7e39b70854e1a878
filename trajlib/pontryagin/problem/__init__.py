"""Optimal control problems: statement, conditions in symbols, numeric form."""
