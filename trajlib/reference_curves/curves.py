"""The solution of a differential equation as a formula, by interpolation of its curves."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from trajlib import plotting
from trajlib._arguments.arrays import read_array
from trajlib._arguments.numbers import read_seconds, read_times
from trajlib._typing import ArrayLike
from trajlib.reference_curves.integration import SHARPEST, Flow
from trajlib.reference_curves.interpolation import TensorInterpolant, lebesgue_constant
from trajlib.reference_curves.node_arguments import read_axes, read_box, read_nodes
from trajlib.reference_curves.residuals import Residual

if TYPE_CHECKING:
    from matplotlib.axes import Axes


#: Advice where two times are equal.
_APART = "nodes have to be different"
#: Share of the curves' size that errors of the table may reach between the nodes.
SPOILED = 1e-3


class ReferenceCurves:
    """Interpolated solution of x' = f(t, x, p) for all initial states and parameters in a box.

    Parameters
    ----------
    f : callable
        f(t, x, p), without parameters f(t, x), returns the n derivatives as a list; x and p are
        lists of arrays, one entry a curve, so f uses NumPy's functions.
    t_nodes : array_like
        K increasing times; dates become seconds since the first of them.
    state_nodes : sequence of array_like
        Nodes for each of the n components of x_0; a single node is allowed.
    param_nodes : sequence of array_like
        Nodes for each parameter.
    output : callable, optional
        output(t, x, p) returns the measured functions of the state, a list or a single one.
    box : sequence of tuple, optional
        Intervals (low, high) for time, components and parameters in this order, in which the
        formula is used; the ranges of the nodes if left out (Chebyshev nodes do not reach the ends
        of theirs). The curves start at its first time.
    domain : callable, optional
        domain(t, x, p) is true where f is defined.
    rtol : float
        Relative tolerance of the integration.
    method : {"DOP853", "Radau"}
        Explicit or implicit method of integration. For stiff systems, whose fast motions die out
        long before the slow ones, the implicit one.
    max_evaluations : int
        Evaluations of f after which an integration is given up.

    Attributes
    ----------
    table : ndarray
        States at all nodes, shape (n, K, nodes of x_0..., nodes of p...).
    lebesgue : float
        Product of the Lebesgue constants of the axes.

    Raises
    ------
    ArithmeticError
        If a curve leaves the domain or escapes to infinity, or max_evaluations are not enough.
    ValueError
        If arguments do not fit or the nodes amplify `rtol` to a thousandth.

    Examples
    --------
    >>> from trajlib.reference_curves import chebyshev_nodes
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
        f: Callable,
        t_nodes: ArrayLike,
        state_nodes: Sequence,
        param_nodes: Sequence = (),
        output: Callable | None = None,
        *,
        box: Sequence | None = None,
        domain: Callable | None = None,
        rtol: float = 1e-10,
        method: str = "DOP853",
        max_evaluations: int = 50_000,
    ) -> None:
        lists = [
            (read_times(t_nodes, "t_nodes", repeated=_APART), "t_nodes", "t"),
            *read_axes(state_nodes, "state_nodes", "x0"),
            *read_axes(param_nodes, "param_nodes", "p"),
        ]
        self.n, self.parameters = len(state_nodes), len(param_nodes)
        if self.n == 0:
            raise ValueError(
                "state_nodes: expected a list of nodes for each component of the state, got none"
            )
        self.nodes = tuple(read_nodes(nodes, name) for nodes, name, _ in lists)
        self.box = read_box(box, self.nodes, [name for _, name, _ in lists])
        self._names = [short for _, _, short in lists]
        if not SHARPEST <= rtol < 1:
            raise ValueError(
                f"rtol: expected a relative tolerance between {SHARPEST:g} and 1, got {rtol}"
            )
        self._output = output
        self._flow = Flow(
            f, domain, self.n, self.parameters, self.box[0][0], rtol, method, max_evaluations
        )
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

    def __call__(
        self, t: ArrayLike, x0: Sequence, p: Sequence = (), *, extrapolate: bool = False
    ) -> np.ndarray:
        """Return the states at the times `t` on the curves from `x0` with the parameters `p`.

        Parameters
        ----------
        t : array_like
            Times.
        x0 : sequence of array_like
            n components of the initial state. These, `t` and `p` are numbers or arrays that
            broadcast.
        p : sequence of array_like
            Parameters.
        extrapolate : bool
            Whether points outside the box are allowed; otherwise they are an error.

        Returns
        -------
        ndarray, shape (n, ...)
        """
        return self._states(t, x0, p, extrapolate=extrapolate)

    def derivative(
        self,
        t: ArrayLike,
        x0: Sequence,
        p: Sequence = (),
        order: int = 1,
        *,
        extrapolate: bool = False,
    ) -> np.ndarray:
        """Return a time derivative of the states, by differentiating L_k(t).

        Parameters
        ----------
        t, x0, p, extrapolate
            As in a call of the curves.
        order : int
            Order of the derivative.

        Returns
        -------
        ndarray, shape (n, ...)
        """
        return self._states.derivative(t, x0, p, order, extrapolate=extrapolate)

    def on_grid(self, axes: Sequence, order: int = 0, *, extrapolate: bool = False) -> np.ndarray:
        """Return the states, or a time derivative, at all points of a grid.

        Parameters
        ----------
        axes : sequence of array_like
            Times, values for each component of x_0 and for each parameter.
        order : int
            Order of the derivative by time.
        extrapolate : bool
            Whether points outside the box are allowed.

        Returns
        -------
        ndarray, shape (n, times, ...)
        """
        return self._states.on_grid(axes, order, extrapolate=extrapolate)

    def output(
        self, t: ArrayLike, x0: Sequence, p: Sequence = (), *, extrapolate: bool = False
    ) -> np.ndarray:
        """Return the measured functions of the interpolated states.

        Parameters
        ----------
        t, x0, p, extrapolate
            As in a call of the curves.

        Returns
        -------
        ndarray, shape (outputs, ...)

        Raises
        ------
        ValueError
            If the curves were made without `output`.

        Notes
        -----
        Source: (3.2) of the paper.
        """
        x = self(t, x0, p, extrapolate=extrapolate)
        return self._measured(
            read_seconds(t, "t"), x, [read_array(value, "p", "numbers") for value in p]
        )

    @property
    def tabulated_output(self) -> TensorInterpolant:
        """Interpolant of the measured functions themselves, tabulated at the nodes.

        It is called like the curves and has a `derivative`. Source: (3.7) of the paper.
        """
        axes = np.meshgrid(*self.nodes, indexing="ij", sparse=True)
        table = self._measured(axes[0], self.table, axes[1 + self.n :])
        return TensorInterpolant(self.nodes, self.box, self._names, self.n, table)

    def defect(
        self, t: ArrayLike, x0: Sequence, p: Sequence = (), *, extrapolate: bool = False
    ) -> np.ndarray:
        """Return the defect of the formula in the differential equation, dx/dt - f(t, x, p).

        Parameters
        ----------
        t, x0, p, extrapolate
            As in a call of the curves.

        Returns
        -------
        ndarray, shape (n, ...)

        Notes
        -----
        Source: (1.3) of the paper.
        """
        x = self(t, x0, p, extrapolate=extrapolate)
        rates = self._flow.rates(
            read_seconds(t, "t"), x, [read_array(value, "p", "numbers") for value in p]
        )
        return self.derivative(t, x0, p, extrapolate=extrapolate) - rates

    def integrated(self, t: ArrayLike, x0: Sequence, p: Sequence = ()) -> np.ndarray:
        """Return the states by integration, without interpolation.

        Parameters
        ----------
        t : array_like
            Increasing times.
        x0, p : sequence of array_like
            Initial state and parameters, numbers or arrays that broadcast.

        Returns
        -------
        ndarray, shape (n, times, ...)
            The shape of `x0` and `p` follows that of `t`.
        """
        t = read_nodes(read_seconds(t, "t"), "t")
        starts = np.broadcast_arrays(*self._starts(x0, p))
        shape = starts[0].shape
        states = self._flow.states(t, np.array([start.ravel() for start in starts]))
        return states.reshape(self.n, t.size, *shape)

    def residual(self, grid: Sequence, *, order: int = 0) -> Residual:
        """Return the errors |formula - integration| on a grid in the box.

        Parameters
        ----------
        grid : sequence of array_like
            Times, values for each component of x_0 and for each parameter.
        order : int
            0 for states and outputs; 1 for the time derivatives of the states, which integration
            gives as f.

        Returns
        -------
        Residual

        Examples
        --------
        >>> curves = ReferenceCurves(lambda t, x: [x[1], -x[0]], np.linspace(0, 3, 7), [[0, 1], [0, 1]])
        >>> curves.residual([np.linspace(0, 3, 31), [0.5], [0, 0.25, 0.5]])
        component  greatest error  % there                      at
             x[0]       7.362e-05  0.02425  t = 2.8, x0 = 0.5, 0.5
             x[1]        8.15e-05  0.02086  t = 0.2, x0 = 0.5, 0.5
        """
        axes = [read_nodes(axis, f"grid[{j}]") for j, axis in enumerate(grid)]
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
        approximate = self.on_grid(axes, order)
        open_axes = np.meshgrid(*axes, indexing="ij", sparse=True)
        p, names = open_axes[1 + self.n :], [f"x[{i}]" for i in range(self.n)]
        if order == 1:
            exact, names = (
                self._flow.rates(open_axes[0], exact, p),
                [f"x'[{i}]" for i in range(self.n)],
            )
        elif self._output is not None:
            measured = [self._measured(open_axes[0], states, p) for states in (exact, approximate)]
            exact, approximate = (
                np.concatenate(pair) for pair in zip((exact, approximate), measured)
            )
            names += [f"y[{i}]" for i in range(len(measured[0]))]
        return Residual(tuple(names), tuple(axes), self.n, np.abs(approximate - exact), exact)

    def plot(self, component: int = 0, ax: Axes | None = None) -> Axes:
        """Draw all reference curves of a component over time, with the nodes.

        Parameters
        ----------
        component : int
            Index of the component.
        ax : matplotlib.axes.Axes, optional
            Axes to draw on; new ones if left out.

        Returns
        -------
        matplotlib.axes.Axes
        """
        import matplotlib.pyplot as plt

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
        return [read_array(value, "x0, p", "numbers") for value in (*x0, *p)]

    def _measured(self, t, x, p):
        if self._output is None:
            raise ValueError(
                "output: these curves were made without one; give ReferenceCurves(..., output=phi)"
            )
        values = self._output(t, x, p) if self.parameters else self._output(t, x)
        values = (
            values
            if isinstance(values, (list, tuple)) or np.ndim(values) > np.ndim(x[0])
            else [values]
        )
        return np.stack([np.broadcast_to(part, np.shape(x[0])) for part in values]).astype(float)
