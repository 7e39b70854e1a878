"""Convex targets of the plane by their support functions: points, segments, lines, strips,
ellipses, parabolas."""

import numpy as np
import sympy as sp

from workbook.checks.contract.verdict import UnsuitableData


class ConvexTarget:
    """A convex set D = {g <= 0}, or the hull of points, by its support function, for each case."""

    def __init__(self, target, state, names, cases):
        target = list(target) if isinstance(target, (list, tuple, sp.MatrixBase)) else [target]
        zero = dict.fromkeys(state, 0)
        self.g, self.point = None, len(target) == 2 and isinstance(target[0], sp.Expr)
        if all(isinstance(part, (list, tuple, sp.Tuple)) for part in target):
            corners = [[[float(v) for v in corner] for corner in target]] * len(cases)
        elif len(target) == 2:
            rows = sp.Matrix([sp.sympify(part) for part in target])
            corner = rows.jacobian(state).inv() * -rows.subs(zero)
            corners = [[[float(v.subs(dict(zip(names, case)))) for v in corner]] for case in cases]
        else:
            self._curve(sp.sympify(target[0]), state, names, cases, zero)
            return
        self.kind, self._corners = "hull", np.array(corners)

    @classmethod
    def points(cls, points):
        """Return a target of a single point for each case, given by numbers."""
        target = cls.__new__(cls)
        target.g, target.point, target.kind = None, True, "hull"
        target._corners = np.asarray(points, dtype=float)[:, None, :]
        return target

    def corner(self, case):
        """Return the target that is a point."""
        return self._corners[case, 0]

    def _curve(self, g, state, names, cases, zero):
        hessian, gradient = sp.hessian(g, state), sp.Matrix([g.diff(v) for v in state])
        if any(v.free_symbols & set(state) for v in hessian):
            raise UnsuitableData("a target of degree one or two is expected")
        gradient, constant = gradient.subs(zero), g.subs(zero)
        numbers = [
            [
                np.array(sp.Matrix(part).subs(dict(zip(names, case))), dtype=float)
                for part in (hessian, gradient, [constant])
            ]
            for case in cases
        ]
        sign = -1.0 if np.linalg.eigvalsh(numbers[0][0]).min() < -1e-12 else 1.0
        self._H, self._c, self._d = (sign * np.array([n[k] for n in numbers]) for k in range(3))
        self._c, self._d = self._c[:, :, 0], self._d[:, 0, 0]
        self.g = lambda x, case: (
            np.einsum("ni,nij,nj->n", x, self._H[case], x) / 2
            + (self._c[case] * x).sum(axis=1)
            + self._d[case]
        )
        self.slope = lambda x, case: np.einsum("nij,nj->ni", self._H[case], x) + self._c[case]
        values, vectors = np.linalg.eigh(self._H[0])
        if values.max() < 1e-12:
            self.kind = "line"
        elif values.min() > 1e-12:
            self.kind = "ellipse"
            self._inverse = np.linalg.inv(self._H)
            self._centre = -np.einsum("nij,nj->ni", self._inverse, self._c)
            self._level = np.maximum(-self.g(self._centre, np.arange(len(cases))), 0)
        else:
            self._curved_direction, self._axis = vectors[:, 1], vectors[:, 0]
            self.kind = "parabola" if abs(self._c @ self._axis).min() > 1e-12 else "strip"

    def inside(self, x, case):
        """Return which starts lie inside D, whose border is the target."""
        return (
            np.zeros(len(x), dtype=bool)
            if self.g is None or self.kind == "line"
            else self.g(x, case) < 0
        )

    def angles(self):
        """Return the directions to be tried as (angles, spacing); spacing 0 if no others matter."""
        if self.kind in ("line", "strip"):
            normal = self._c[0] if self.kind == "line" else self._curved_direction
            first = np.arctan2(normal[1], normal[0])
            return np.array([first, first + np.pi]), 0.0
        if self.kind == "parabola":
            axis = self._axis * np.sign(self._c[0] @ self._axis)
            middle, count = np.arctan2(axis[1], axis[0]), 96
            return middle + np.pi * ((np.arange(count) + 0.5) / count - 0.5), np.pi / count
        return np.arange(112) * (2 * np.pi / 112), 2 * np.pi / 112

    def support(self, p, case, start):
        """Return sup p.y over D, for rows of directions.

        A line has D on its other side, seen from the rows `start`.
        """
        if self.kind == "hull":
            return np.einsum("nki,ni->nk", self._corners[case], p).max(axis=1)
        if self.kind == "line":
            side = np.sign(self.g(start, case))
            c, d = self._c[case] * side[:, None], self._d[case] * side
            size = np.linalg.norm(c, axis=1)
            return np.where((c * p).sum(axis=1) > 0.999 * size, -d / size, np.inf)
        if self.kind == "ellipse":
            quadratic_form = np.einsum("ni,nij,nj->n", p, self._inverse[case], p)
            return (p * self._centre[case]).sum(axis=1) + np.sqrt(
                2 * self._level[case] * quadratic_form
            )
        curved_component = p @ self._curved_direction
        curvature = np.einsum(
            "i,nij,j->n", self._curved_direction, self._H[case], self._curved_direction
        )
        bend = self._c[case] @ self._curved_direction
        if self.kind == "strip":
            middle = -bend / curvature
            width = np.sqrt(np.maximum(middle**2 - 2 * self._d[case] / curvature, 0))
            return curved_component * middle + width
        with np.errstate(all="ignore"):
            scale = (p @ self._axis) / (self._c[case] @ self._axis)
            return np.where(
                scale > 0,
                (curved_component - scale * bend) ** 2 / (2 * scale * curvature)
                - scale * self._d[case],
                np.inf,
            )

    def around(self, random, case, count):
        """Return random points near the target, on both sides."""
        if self.kind == "hull":
            corners = self._corners[case]
            weights = random.dirichlet(np.ones(corners.shape[0]), count)
            return weights @ corners + random.normal(scale=0.4, size=(count, 2))
        angle = random.uniform(0, 2 * np.pi, count)
        p = np.column_stack([np.cos(angle), np.sin(angle)])
        if self.kind == "ellipse":
            q = p @ self._inverse[case]
            boundary_points = (
                self._centre[case]
                + q
                * np.sqrt(2 * self._level[case] / np.maximum((p * q).sum(axis=1), 1e-12))[:, None]
            )
            return (
                self._centre[case]
                + (boundary_points - self._centre[case]) * random.uniform(0.5, 1.6, count)[:, None]
                + 0.02 * p
            )
        if self.kind == "line":
            c = self._c[case]
            tangent = np.array([-c[1], c[0]]) / np.linalg.norm(c)
            boundary_points = (-self._d[case] / (c @ c)) * c + np.outer(
                random.normal(scale=2, size=count), tangent
            )
            return boundary_points + random.normal(scale=0.5, size=(count, 2))
        curved_component = random.uniform(-2.5, 2.5, count)
        middle = (
            (self._c[case] @ self._curved_direction) * curved_component
            + 0.5
            * (self._curved_direction @ self._H[case] @ self._curved_direction)
            * curved_component**2
            + self._d[case]
        )
        slope = self._c[case] @ self._axis
        axis_component = (
            -middle / slope if self.kind == "parabola" else random.normal(scale=3, size=count)
        )
        return (
            np.outer(curved_component, self._curved_direction)
            + np.outer(axis_component, self._axis)
            + random.normal(scale=0.4, size=(count, 2))
        )
