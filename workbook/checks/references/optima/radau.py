"""Radau's collocation points, and their weights."""

import functools

import casadi as ca
import numpy as np


@functools.lru_cache
def radau(degree):
    """Radau's points with 0 before them; the derivatives there of the polynomials that are 1 at one
    of them; and for Gauss's sum with twice as many points triples (weight, these polynomials, those
    without the point 0)."""
    points = np.append(0, ca.collocation_points(degree, "radau"))

    def basis(among):
        return [
            np.poly1d(np.delete(among, j), True) / np.prod(among[j] - np.delete(among, j))
            for j in range(len(among))
        ]

    derivative = np.array([np.polyval(np.polyder(one), points[1:]) for one in basis(points)]).T
    places, weights = np.polynomial.legendre.leggauss(2 * degree)
    between = [
        (
            weight / 2,
            *([float(one(place)) for one in basis(among)] for among in (points, points[1:])),
        )
        for place, weight in zip((places + 1) / 2, weights)
    ]
    return points, derivative, between


@functools.lru_cache
def integrals(degree):
    """The integrals from 0 to each of Radau's points of the polynomials that are 1 at one of them
    and 0 at others."""
    points = radau(degree)[0][1:]
    basis = [
        np.poly1d(np.delete(points, j), True) / np.prod(points[j] - np.delete(points, j))
        for j in range(degree)
    ]
    return np.array([[np.polyval(np.polyint(one), point) for one in basis] for point in points])
