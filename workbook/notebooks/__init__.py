"""Notebooks: make, find and run them, and find the modules that they use."""
