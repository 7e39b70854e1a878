"""Radau collocation points and their weights."""

import functools

import numpy as np

from trajlib._lazy import casadi as ca


@functools.lru_cache
def radau(degree):
    """Return the Radau points with 0 before them, derivatives there, and the weights between them.

    The derivatives are those of the polynomials that are 1 at one of the points. The third are, for
    Gauss's sum with twice as many points, triples (weight, these polynomials, those without point 0).
    """
    points = np.append(0, ca.collocation_points(degree, "radau"))

    def basis(among):
        return [
            np.poly1d(np.delete(among, j), True) / np.prod(among[j] - np.delete(among, j))
            for j in range(len(among))
        ]

    derivative = np.array([np.polyval(np.polyder(p), points[1:]) for p in basis(points)]).T
    gauss_points, weights = np.polynomial.legendre.leggauss(2 * degree)
    between = [
        (
            weight / 2,
            *(
                [float(polynomial(point)) for polynomial in basis(among)]
                for among in (points, points[1:])
            ),
        )
        for point, weight in zip((gauss_points + 1) / 2, weights)
    ]
    return points, derivative, between


@functools.lru_cache
def integrals(degree):
    """Return integrals from 0 to the Radau points of polynomials that are 1 at one of them."""
    return np.linalg.inv(radau(degree)[1][:, 1:])
