"""Oracles of the checks of filters: eigenvalues in any order, and again, are the same ones."""

from oracles.structure.linear_systems import same_numbers

ORACLES = {"error_eigenvalues": same_numbers}
