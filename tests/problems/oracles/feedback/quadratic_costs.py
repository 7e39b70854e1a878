"""Oracles of the checks of quadratic costs: eigenvalues in any order, and again, are the same
ones."""

from oracles.structure.linear_systems import same_numbers

ORACLES = {"optimal_eigenvalues": same_numbers}
