"""Oracles of the checks of filters and processes: eigenvalues in any order, and again, are the same ones."""

from oracles.structure.linear_systems import same_numbers

ORACLES = {"covariance_exponents": same_numbers, "error_eigenvalues": same_numbers}
