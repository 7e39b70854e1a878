"""Reference integral curves: a solution as a formula in time, initial state and parameters
(Bulychev, 2020).

The system x' = f(t, x, p), x(t_0) = x_0, with constant parameters p, is integrated once from every
node of a grid over x_0 and p. The curves are tabulated at nodes in time, and between all nodes the
table is interpolated by the tensor product of the fundamental polynomials of each axis,

    x(t, x_0, p) = sum_k sum_m x(t_k; x_{0,m}, p_m) L_k(t) prod_j L_{m_j}(x_0j) prod_i L_{m_i}(p_i),
    L_k(s) = prod_{q != k} (s - s_q)/(s_k - s_q).

These are (2.8)-(2.11) of the paper with a product over q in (2.11), where a sum is printed. Each
axis is evaluated in barycentric form; the derivative by time differentiates L_k(t).

How well this can go is told by the Lebesgue constant of the nodes, max over s of sum_k |L_k(s)|:
the error of interpolation is at most 1 + Lambda times that of the best polynomial, and errors of
the table are multiplied by no more than Lambda. It grows like (2/pi) ln n for n Chebyshev nodes,
and like 2^n/(e n ln n) for n equispaced ones.
"""

from dataclasses import dataclass, field

import numpy as np

#: The solver's own bound for the relative tolerance is slightly lower.
SHARPEST = 3e-14
#: A step that is shorter than this share of the time means that a curve cannot be continued.
SHORTEST = 1e-9
#: Curves that are integrated together, and points that are evaluated together: what fits into the
#: cache.
CURVES, POINTS = 1000, 4000
#: Share of the curves' size that errors of the table may reach between the nodes.
SPOILED = 1e-3


def chebyshev_nodes(c, d, n):
    """The n zeros of the Chebyshev polynomial of degree n, carried to [c, d], increasing: (2.12) of
    the paper.

    >>> chebyshev_nodes(-1, 1, 3).round(4).tolist()
    [-0.866, 0.0, 0.866]
    """
    if not (np.isfinite([c, d]).all() and c < d):
        raise ValueError(f"c, d: expected finite ends with c < d, got {c} and {d}")
    if n != int(n) or n < 1:
        raise ValueError(f"n: expected a number of nodes, one or more, got {n}")
    cosines = -np.cos(np.pi * (2 * np.arange(1, int(n) + 1) - 1) / (2 * int(n)))
    return (c + d) / 2 + (d - c) / 2 * np.where(np.abs(cosines) < 1e-16, 0, cosines)


def lebesgue_constant(nodes, low=None, high=None):
    """Greatest sum of |L_k(s)| over [low, high], the range of the nodes if left out: how much
    interpolation amplifies.

    Found on 50 places between neighbouring nodes, so it may be a thousandth too small.

    >>> round(lebesgue_constant(range(11)), 1), round(lebesgue_constant(chebyshev_nodes(0, 10, 11), 0, 10), 1)
    (29.9, 2.5)
    """
    nodes = _nodes(nodes, "nodes")
    low, high = nodes[0] if low is None else low, nodes[-1] if high is None else high
    if nodes.size == 1:
        return 1.0
    stops = np.unique(np.concatenate([[low], nodes[(nodes > low) & (nodes < high)], [high]]))
    places = (stops[:-1, None] + np.diff(stops)[:, None] * np.arange(51) / 50).ravel()
    return float(np.abs(_fundamental(nodes)(places)).sum(axis=1).max())


class ReferenceCurves:
    """The solution of x' = f(t, x, p) for all initial states and parameters of a box, by
    interpolation of curves.

    `f(t, x, p)` (without parameters `f(t, x)`) gives the n derivatives as a list; x and p are lists
    of arrays, one entry a curve, so it computes with NumPy's functions. `t_nodes`: K increasing
    times. `state_nodes`: n lists of nodes, one for each component of x_0; `param_nodes`: a list for
    each parameter. A list may hold a single node. `output(t, x, p)` gives what is measured, a list
    of functions of the state or one of them.

    `box`: pairs (low, high) for time, components and parameters in this order, in which the formula
    is to be used; the ranges of the nodes if left out (Chebyshev nodes do not reach the ends of
    theirs). The curves start at its first time. `domain(t, x, p)` is true where f is defined: a
    curve that leaves it is an error (ArithmeticError). `rtol`: relative tolerance of the
    integration; nodes that amplify it to a thousandth are refused (ValueError).

    >>> decay = ReferenceCurves(lambda t, x, p: [-p[0]*x[0]], chebyshev_nodes(0, 2, 9), [[0, 1]],
    ...                         [chebyshev_nodes(0.5, 1, 6)], box=[(0, 2), (0, 1), (0.5, 1)])
    >>> decay
    12 reference curves of 1 state, tabulated at 9 times; grid 2 (x) x 6 (p), Lebesgue constant 5.0
    >>> (x,) = decay([0.5, 1.5], [1.0], [0.7])
    >>> bool(abs(x - np.exp([-0.35, -1.05])).max() < 1e-6)
    True
    """

    def __init__(
        self,
        f,
        t_nodes,
        state_nodes,
        param_nodes=(),
        output=None,
        *,
        box=None,
        domain=None,
        rtol=1e-10,
    ):
        lists = [
            (t_nodes, "t_nodes", "t"),
            *_named(state_nodes, "state_nodes", "x0"),
            *_named(param_nodes, "param_nodes", "p"),
        ]
        self.n, self.parameters = len(state_nodes), len(param_nodes)
        if self.n == 0:
            raise ValueError(
                "state_nodes: expected a list of nodes for each component of the state, got none"
            )
        self.nodes = tuple(_nodes(nodes, name) for nodes, name, _ in lists)
        self.box = _box(box, self.nodes, [name for _, name, _ in lists])
        self._names = [short for _, _, short in lists]
        if not SHARPEST <= rtol < 1:
            raise ValueError(
                f"rtol: expected a relative tolerance between {SHARPEST:g} and 1, got {rtol}"
            )
        self._output = output
        self._flow = _Flow(f, domain, self.n, self.parameters, self.box[0][0], rtol)
        constants = [lebesgue_constant(nodes, *ends) for nodes, ends in zip(self.nodes, self.box)]
        #: Lebesgue constant of the whole: the product of those of the axes.
        self.lebesgue = float(np.prod(constants))
        if rtol * self.lebesgue > SPOILED:
            worst = int(np.argmax(constants))
            raise ValueError(
                f"{lists[worst][1]}: {self.nodes[worst].size} nodes amplify errors "
                f"{constants[worst]:.1e} "
                f"times, and with them those of the integration; take fewer, or chebyshev_nodes"
            )
        starts = np.meshgrid(*self.nodes[1:], indexing="ij")
        table = self._flow.states(self.nodes[0], np.array([axis.ravel() for axis in starts]))
        #: The states at all nodes, shape (n, K, nodes of x_0..., nodes of p...).
        self.table = table.reshape(self.n, self.nodes[0].size, *starts[0].shape)
        self._states = TensorInterpolant(self.nodes, self.box, self._names, self.n, self.table)

    def __call__(self, t, x0, p=(), *, extrapolate=False):
        """The states at the times `t` on the curves from `x0` with the parameters `p`: shape (n,
        ...).

        `t`, the n entries of `x0` and the entries of `p` are numbers or arrays that fit together
        (are broadcast). Places outside of the box are an error unless `extrapolate=True`.
        """
        return self._states(t, x0, p, extrapolate=extrapolate)

    def derivative(self, t, x0, p=(), order=1, *, extrapolate=False):
        """The derivative of this order by time, by differentiating L_k(t): shape (n, ...)."""
        return self._states.derivative(t, x0, p, order, extrapolate=extrapolate)

    def on_grid(self, axes, order=0, *, extrapolate=False):
        """The states, or their derivatives of this order by time, at all places of a grid: lists of
        times, of values for each component of x_0 and for each parameter; shape (n, times, ...)."""
        return self._states.on_grid(axes, order, extrapolate=extrapolate)

    def output(self, t, x0, p=(), *, extrapolate=False):
        """What is measured, phi of the interpolated states: (3.2) of the paper, shape (outputs,
        ...)."""
        x = self(t, x0, p, extrapolate=extrapolate)
        return self._measured(
            np.asarray(t, dtype=float), x, [np.asarray(value, dtype=float) for value in p]
        )

    @property
    def tabulated_output(self):
        """The other way, (3.7) of the paper: what is measured is tabulated and interpolated itself.
        It is called like the curves and has a `derivative`."""
        axes = np.meshgrid(*self.nodes, indexing="ij", sparse=True)
        table = self._measured(axes[0], self.table, axes[1 + self.n :])
        return TensorInterpolant(self.nodes, self.box, self._names, self.n, table)

    def defect(self, t, x0, p=(), *, extrapolate=False):
        """By how much the formula misses the differential equation, dx/dt - f(t, x, p): (1.3) of
        the paper, shape (n, ...)."""
        x = self(t, x0, p, extrapolate=extrapolate)
        rates = self._flow.rates(
            np.asarray(t, dtype=float), x, [np.asarray(value, dtype=float) for value in p]
        )
        return self.derivative(t, x0, p, extrapolate=extrapolate) - rates

    def integrated(self, t, x0, p=()):
        """The states at increasing times `t` by integration from `x0`, without interpolation: shape
        (n, times, ...).

        The entries of `x0` and `p` are numbers or arrays that fit together; their shape stands
        behind that of `t`.
        """
        t = _nodes(t, "t")
        starts = np.broadcast_arrays(*self._starts(x0, p))
        shape = starts[0].shape
        found = self._flow.states(t, np.array([start.ravel() for start in starts]))
        return found.reshape(self.n, t.size, *shape)

    def residual(self, grid, *, order=0):
        """The errors |formula - integration| on a grid: lists of times, of values for each
        component of x_0 and for each parameter, all in the box. Outputs are among what is compared.

        `order=1`: of the derivatives by time instead, which integration gives as f (outputs are
        left out).

        >>> curves = ReferenceCurves(lambda t, x: [x[1], -x[0]], np.linspace(0, 3, 7), [[0, 1], [0, 1]])
        >>> curves.residual([np.linspace(0, 3, 31), [0.5], [0, 0.25, 0.5]])
        component  greatest error  % there                      at
             x[0]       7.362e-05  0.02425  t = 2.8, x0 = 0.5, 0.5
             x[1]        8.15e-05  0.02086  t = 0.2, x0 = 0.5, 0.5
        """
        axes = [_nodes(axis, f"grid[{j}]") for j, axis in enumerate(grid)]
        if len(axes) != len(self.nodes):
            raise ValueError(
                f"grid: expected {len(self.nodes)} lists, for {', '.join(self._names)}, got "
                f"{len(axes)}"
            )
        if order not in (0, 1):
            raise ValueError(
                f"order: expected 0 for the states or 1 for their derivatives, got {order!r}"
            )
        shape = tuple(axis.size for axis in axes)
        mesh = np.meshgrid(*axes[1:], indexing="ij")
        exact = self._flow.states(axes[0], np.array([axis.ravel() for axis in mesh])).reshape(
            self.n, *shape
        )
        found = self.on_grid(axes, order)
        open_axes = np.meshgrid(*axes, indexing="ij", sparse=True)
        p, names = open_axes[1 + self.n :], [f"x[{i}]" for i in range(self.n)]
        if order == 1:
            exact, names = (
                self._flow.rates(open_axes[0], exact, p),
                [f"x'[{i}]" for i in range(self.n)],
            )
        elif self._output is not None:
            measured = [self._measured(open_axes[0], states, p) for states in (exact, found)]
            exact, found = (np.concatenate(pair) for pair in zip((exact, found), measured))
            names += [f"y[{i}]" for i in range(len(measured[0]))]
        return Residual(tuple(names), tuple(axes), self.n, np.abs(found - exact), exact)

    def plot(self, component=0, ax=None):
        """All reference curves of a component over time, with the nodes; returns the Axes."""
        import matplotlib.pyplot as plt

        from trajlib import plotting

        low, high = self.box[0]
        times = np.linspace(low, high, 200)
        values = self.on_grid([times, *self.nodes[1:]])[component].reshape(times.size, -1)
        with plotting.style():
            ax = plt.subplots()[1] if ax is None else ax
            ax.plot(times, values, "-", color=plotting.GREY, lw=0.7)
            table = self.table[component].reshape(self.nodes[0].size, -1)
            ax.plot(self.nodes[0], table, "o", ms=2.5, color=plotting.BLUE, ls="none")
            ax.set(xlabel="$t$", ylabel=f"$x_{{{component + 1}}}$")
        return ax

    def __repr__(self):
        counts = " x ".join(
            f"{nodes.size} ({'x' if j < self.n else 'p'})" for j, nodes in enumerate(self.nodes[1:])
        )
        total = int(np.prod([nodes.size for nodes in self.nodes[1:]]))
        return (
            f"{total} reference curve{'s' * (total > 1)} of {self.n} state{'s' * (self.n > 1)}, "
            "tabulated at "
            f"{self.nodes[0].size} times; grid {counts}, Lebesgue constant {self.lebesgue:.1f}"
        )

    def _starts(self, x0, p):
        if len(x0) != self.n or len(p) != self.parameters:
            raise ValueError(
                f"x0, p: expected {self.n} components and {self.parameters} parameters, got "
                f"{len(x0)} and {len(p)}"
            )
        return [np.asarray(value, dtype=float) for value in (*x0, *p)]

    def _measured(self, t, x, p):
        if self._output is None:
            raise ValueError(
                "output: these curves were made without one; give ReferenceCurves(..., output=phi)"
            )
        found = self._output(t, x, p) if self.parameters else self._output(t, x)
        found = (
            found if isinstance(found, (list, tuple)) or np.ndim(found) > np.ndim(x[0]) else [found]
        )
        return np.stack([np.broadcast_to(part, np.shape(x[0])) for part in found]).astype(float)


class _Flow:
    """The equations and their integration, all curves together."""

    def __init__(self, f, domain, n, parameters, begin, rtol):
        self.f, self.domain, self.n, self.parameters, self.begin, self.rtol = (
            f,
            domain,
            n,
            parameters,
            begin,
            rtol,
        )

    def rates(self, t, x, p):
        """f as one array of the shape of x."""
        try:
            rates = self.f(t, x, p) if self.parameters else self.f(t, x)
        except (TypeError, ValueError, IndexError) as reason:
            call = f"(t, x, p) with {self.parameters} parameters" if self.parameters else "(t, x)"
            raise type(reason)(
                f"f: it failed ({reason}); it is called as {call} and {self.n} components of the "
                "state, arrays, so it takes NumPy's functions and not those of math"
            ) from None
        if len(rates) != self.n:
            raise ValueError(
                f"f: expected {self.n} derivatives, one for each component of the state, got "
                f"{len(rates)}"
            )
        return np.stack([np.broadcast_to(rate, np.shape(x[0])) for rate in rates]).astype(float)

    def states(self, times, starts):
        """Shape (n, times, curves), from starts of shape (n + parameters, curves)."""
        if times[0] < self.begin:
            raise ValueError(f"t: the curves start at {self.begin:g}, {times[0]:g} is before that")
        parts = [
            self._together(times, starts[:, k : k + CURVES])
            for k in range(0, starts.shape[1], CURVES)
        ]
        return np.concatenate(parts, axis=2)

    def _together(self, times, starts):
        from scipy.integrate import DOP853

        x0, p = starts[: self.n], starts[self.n :]
        length, outside = times[-1] - self.begin, np.zeros(x0.shape[1], dtype=bool)

        def rates(t, y):
            x = y.reshape(x0.shape)
            with np.errstate(all="ignore"):
                found = self.rates(t, x, p)
                off = ~(np.isfinite(found).all(axis=0) & self._inside(t, x, p))
            if off.any():
                # of the last, the shortest trial those are left that are at the border
                outside[:] = off
            # A step that meets nan is refused by the solver and tried shorter, until it gives up at
            # the border.
            return np.where(off, np.nan, found).ravel()

        at_start = rates(self.begin, x0.ravel()).reshape(x0.shape)
        if outside.any():
            self._refuse(self.begin, starts, outside)
        found = np.empty((times.size, x0.size))
        found[times == self.begin] = x0.ravel()
        if length:
            sizes, moved = np.abs(x0).max(axis=1), np.abs(at_start).max(axis=1) * length
            sizes = np.where(sizes > 0, sizes, np.where(moved > 0, moved, 1.0))[:, None]
            # The solver bounds the mean square over all curves; each of them is to keep the
            # tolerance.
            share = self.rtol * x0.shape[1] ** -0.5
            with np.errstate(all="ignore"):
                solver = DOP853(
                    rates,
                    self.begin,
                    x0.ravel(),
                    times[-1],
                    rtol=max(share, SHARPEST),
                    atol=np.repeat(sizes, x0.shape[1]) * share,
                )
                while solver.status == "running":
                    outside[:] = False
                    solver.step()
                    stuck = solver.t < times[-1] and solver.step_size < SHORTEST * length
                    if stuck or solver.status == "failed":
                        x, speed = (part.reshape(x0.shape) for part in (solver.y, solver.f))
                        escaping = np.abs(speed / (np.abs(x) + sizes)).max(axis=0)
                        self._refuse(
                            solver.t,
                            starts,
                            outside if outside.any() else escaping == escaping.max(),
                        )
                    passed = (times > solver.t_old) & (times <= solver.t)
                    if passed.any():
                        found[passed] = solver.dense_output()(times[passed]).T
        return np.moveaxis(found.reshape(times.size, *x0.shape), 1, 0)

    def _inside(self, t, x, p):
        if self.domain is None:
            return True
        return self.domain(t, x, p) if self.parameters else self.domain(t, x)

    def _refuse(self, t, starts, which):
        start = starts[:, np.flatnonzero(which)[0]]
        names = [f"x0[{j}]" for j in range(self.n)] + [f"p[{j}]" for j in range(self.parameters)]
        at = ", ".join(f"{name} = {value:.6g}" for name, value in zip(names, start))
        raise ArithmeticError(
            f"f: the curve from {at} leaves the domain where f is defined, or escapes to infinity, "
            f"at t = {t:.6g}; narrow the box or end earlier"
        )


class TensorInterpolant:
    """A table on a grid of nodes, interpolated along every axis by fundamental polynomials; made by
    ReferenceCurves."""

    def __init__(self, nodes, box, names, n, table):
        self.nodes, self.box, self.table, self._names, self._n = nodes, box, table, names, n
        self._bases = [_fundamental(axis) for axis in nodes]

    def __call__(self, t, x0, p=(), *, extrapolate=False):
        """The values at times, initial states and parameters: shape (components, ...)."""
        return self.derivative(t, x0, p, 0, extrapolate=extrapolate)

    def derivative(self, t, x0, p=(), order=1, *, extrapolate=False):
        """Their derivative of this order by time."""
        if order != int(order) or order < 0:
            raise ValueError(f"order: expected a whole number, zero or more, got {order}")
        if len(x0) != self._n or len(p) != len(self.nodes) - 1 - self._n:
            raise ValueError(
                f"x0, p: expected {self._n} components and {len(self.nodes) - 1 - self._n} "
                f"parameters, got {len(x0)} and {len(p)}"
            )
        places = np.broadcast_arrays(*(np.asarray(part, dtype=float) for part in (t, *x0, *p)))
        shape = places[0].shape
        places = [part.ravel() for part in places]
        self._look(places, extrapolate)
        parts = [
            self._at([part[k : k + POINTS] for part in places], int(order))
            for k in range(0, max(places[0].size, 1), POINTS)
        ]
        return np.concatenate(parts, axis=1).reshape(-1, *shape)

    def on_grid(self, axes, order=0, *, extrapolate=False):
        """The values at all places of a grid, given by its axes: shape (components, times, ...)."""
        axes = [np.asarray(axis, dtype=float) for axis in axes]
        if len(axes) != len(self.nodes) or any(axis.ndim != 1 for axis in axes):
            raise ValueError(
                f"axes: expected {len(self.nodes)} lists, for {', '.join(self._names)}, got "
                f"{len(axes)}"
            )
        self._look(axes, extrapolate)
        found = self.table
        for row in self._rows(axes, order):
            found = np.tensordot(found, row, axes=(1, 1))
        return found

    def _rows(self, places, order):
        """The fundamental polynomials of each axis at the places, shapes (places, nodes)."""
        return [
            basis.derivative(place, order) if j == 0 and order else basis(place)
            for j, (basis, place) in enumerate(zip(self._bases, places))
        ]

    def _at(self, places, order):
        *others, last = self._rows(places, order)
        # from the last axis to the first
        found = np.tensordot(self.table, last, axes=(-1, 1))
        for row in others[::-1]:
            found = np.einsum("...kp,pk->...p", found, row)
        return found

    def _look(self, places, extrapolate):
        for place, (low, high), name in zip(places, self.box, self._names):
            if not np.isfinite(place).all():
                raise ValueError(
                    f"{name}: expected finite numbers, got {place[~np.isfinite(place)][0]}"
                )
            slack = 1e-12 * max(high - low, abs(low), abs(high))
            outside = (place < low - slack) | (place > high + slack)
            if outside.any() and not extrapolate:
                raise ValueError(
                    f"{name}: {place[outside][0]:g} lies outside of its interval [{low:g}, "
                    f"{high:g}]; polynomials go astray quickly there. Give extrapolate=True to "
                    "have it all the same"
                )


@dataclass(frozen=True, repr=False)
class Residual:
    """Errors of reference curves on a grid; what `residual` returns.

    `errors`, `exact`: shape (components, times, ...) over `axes`; `greatest`: for each component
    its largest error, where it is, as (t, x_0..., p...), and how many per cent of the exact value
    there.
    """

    names: tuple
    axes: tuple
    _n: int = field(repr=False)
    errors: np.ndarray
    exact: np.ndarray

    @property
    def greatest(self):
        found = []
        for errors, exact in zip(self.errors, self.exact):
            at = np.unravel_index(errors.argmax(), errors.shape)
            place = tuple(float(axis[k]) for axis, k in zip(self.axes, at))
            percent = 100 * errors[at] / abs(exact[at]) if exact[at] else np.inf
            found.append((float(errors[at]), place, float(percent)))
        return tuple(found)

    def _rows(self):
        for name, (error, place, percent) in zip(self.names, self.greatest):
            at = f"t = {place[0]:.5g}, x0 = {', '.join(f'{value:.5g}' for value in place[1 : 1 + self._n])}"
            if place[1 + self._n :]:
                at += f", p = {', '.join(f'{value:.5g}' for value in place[1 + self._n :])}"
            yield [name, f"{error:.4g}", f"{percent:.4g}", at]

    def __repr__(self):
        rows = [["component", "greatest error", "% there", "at"], *self._rows()]
        widths = [max(map(len, column)) for column in zip(*rows)]
        return "\n".join(
            "  ".join(cell.rjust(width) for cell, width in zip(row, widths)) for row in rows
        )

    def _repr_markdown_(self):
        heads = ["component", "greatest error", "% there", "at"]
        lines = [heads, [":---", "---:", "---:", ":---"], *self._rows()]
        return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _fundamental(nodes):
    """All fundamental polynomials of these nodes: places -> (places, nodes)."""
    from scipy.interpolate import BarycentricInterpolator

    gaps = np.subtract.outer(nodes, nodes) * (4 / np.ptp(nodes) if nodes.size > 1 else 1)
    np.fill_diagonal(gaps, 1)
    # Ours are the same in every run; the class would multiply in random order.
    return BarycentricInterpolator(nodes, np.eye(nodes.size), wi=1 / gaps.prod(axis=1))


def _named(lists, name, short):
    try:
        lists = [np.asarray(nodes, dtype=float) for nodes in lists]
    except (TypeError, ValueError):
        raise TypeError(
            f"{name}: expected a list of lists of numbers, one for each axis, got {lists!r}"
        ) from None
    if any(nodes.ndim != 1 for nodes in lists):
        raise ValueError(
            f"{name}: expected a list of nodes for each axis; a single axis is [nodes]"
        )
    return [(nodes, f"{name}[{j}]", f"{short}[{j}]") for j, nodes in enumerate(lists)]


def _nodes(nodes, name):
    nodes = np.asarray(nodes, dtype=float)
    if nodes.ndim != 1 or nodes.size == 0:
        raise ValueError(f"{name}: expected a list of numbers, got shape {nodes.shape}")
    if not np.isfinite(nodes).all():
        raise ValueError(f"{name}: entry {np.flatnonzero(~np.isfinite(nodes))[0]} is not finite")
    gaps = np.diff(nodes)
    close = np.flatnonzero(np.abs(gaps) <= 1e-12 * np.abs(nodes).max())
    if close.size:
        raise ValueError(
            f"{name}: {nodes[close[0]]:g} and {nodes[close[0] + 1]:g} coincide; all have to be "
            "different"
        )
    if (gaps < 0).any():
        k = int(np.flatnonzero(gaps < 0)[0])
        raise ValueError(
            f"{name}: expected increasing numbers, but {nodes[k]:g} is followed by {nodes[k + 1]:g}"
        )
    return nodes


def _box(box, nodes, names):
    if box is None:
        return tuple((float(axis[0]), float(axis[-1])) for axis in nodes)
    box = [tuple(float(end) for end in ends) for ends in box]
    if len(box) != len(nodes):
        raise ValueError(
            f"box: expected {len(nodes)} pairs, for {', '.join(names)}, got {len(box)}"
        )
    for (low, high), axis, name in zip(box, nodes, names):
        if not low <= axis[0] <= axis[-1] <= high:
            raise ValueError(
                f"box: the interval [{low:g}, {high:g}] does not hold all of {name}, which reach "
                f"from {axis[0]:g} to {axis[-1]:g}"
            )
    return tuple(box)
