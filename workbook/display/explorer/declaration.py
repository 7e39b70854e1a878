"""What an interactive figure consists of.

An `Explorer` is a list of steps, each computed from the earlier ones, and a row of panels that draw
them. A step is a scalar (a parameter, a quantity, the last value of a series) or a series: rows of
named columns, such as the states of a trajectory at its times.

>>> import sympy as sp
>>> x, v, t, delta = sp.symbols("x v t delta")
>>> figure = Explorer("How much damping does it take?", "A damped oscillator and its phase plane.")
>>> figure.parameter(x, 2, (-3, 3))
>>> figure.parameter(v, 0, (-3, 3))
>>> figure.parameter(delta, 0.3, (0, 2), label="damping δ")
>>> motion = figure.trajectory([x, v], [v, -x - delta * v], [x, v], 20)
>>> plane = figure.panel("x", "v", (-3, 3), (-3, 3))
>>> plane.line(motion, x, v)
>>> plane.point(x, v)
>>> figure
Explorer of 1 panel: A damped oscillator and its phase plane.
"""

import numpy as np
import sympy as sp

from workbook.display.explorer.formulas import Formula, pretty
from workbook.display.explorer.page import html
from workbook.display.explorer.panels import Panel
from workbook.display.explorer.sentences import Sentence
from workbook.display.explorer.steps import Parameter, Series, Step, numbers, with_values
from workbook.display.explorer.still import draw

__all__ = ["Explorer"]

#: Points of a series, unless its declaration says otherwise.
TRAJECTORY_POINTS, CURVE_POINTS = 400, 200
#: Points along an axis from which equilibria are sought.
EQUILIBRIA_GRID = 11


class Explorer:
    """An interactive figure.

    Parameters
    ----------
    question : str
        The question that moving something answers, shown above the panels.
    description : str
        A sentence for readers who cannot see the panels.

    Notes
    -----
    In a notebook and in the site the same script computes and draws; no kernel is needed. Without
    JavaScript and on paper a static picture stands in its place. MATLAB's Live Editor has sliders
    (``uislider``), which need a running MATLAB.
    """

    def __init__(self, question, description):
        self.question, self.description = question, description
        self.parameters, self.scalars, self.steps = [], [], []
        self.series, self.panels, self.sentences = [], [], []
        self._inputs = {}  # name of a scalar -> the parameters on which it depends

    # Scalars

    def parameter(self, symbol, value, limits, label=None, step=None, play=None):
        """Add a scalar that the reader sets.

        It has a slider, unless a point of a panel is dragged to set it.

        Parameters
        ----------
        symbol : sympy.Symbol
            The parameter.
        value : float
            Its first value.
        limits : (float, float)
            Its least and largest value.
        label : str, optional
            Text beside the slider; without it the symbol.
        step : float, optional
            Step of the slider; without it a two-hundredth of its range.
        play : float, optional
            Seconds in which a button moves the slider over its range. Where the system is set to
            reduced motion, the button goes on by a step.

        Raises
        ------
        ValueError
            If the symbol has a value already; see `Parameter`.
        """
        low, high = (float(limit) for limit in limits)
        step = (high - low) / 200 if step is None else float(step)
        label = label or pretty(symbol)
        self._define(symbol, frozenset([str(symbol)]))
        self.parameters.append(Parameter(symbol, float(value), (low, high), label, step, play))
        self.steps.append(Step("parameter", {}, {}, frozenset([str(symbol)])))

    def quantity(self, symbol, value):
        """Define a scalar by an expression in the scalars so far.

        Parameters
        ----------
        symbol : sympy.Symbol
            The scalar.
        value : sympy.Expr
            The expression.

        Raises
        ------
        ValueError
            If the symbol has a value already or the expression contains an unknown symbol.
        """
        formulas = {"value": [self._formula("value", value)]}
        self._define(symbol, self._inputs_of(formulas))
        self._add("quantity", formulas, {})

    # Series

    def trajectory(self, states, rates, initial, end, time=None, points=TRAJECTORY_POINTS):
        """Add the solution of an initial value problem from time 0.

        Parameters
        ----------
        states : sequence of sympy.Symbol, length n
            Symbols of the states; in `rates` and in what is drawn they stand for the columns.
        rates : sequence of sympy.Expr, length n
            Right-hand sides, in the states, the time and the scalars so far. They should be smooth
            along the solution: it is computed with fixed steps.
        initial : sequence of sympy.Expr, length n
            Initial states, in the scalars so far.
        end : sympy.Expr or float
            Final time; it may be negative.
        time : sympy.Symbol, optional
            Symbol of the time; without it ``t``.
        points : int
            Number of steps.

        Returns
        -------
        Series
            Its columns are the time and the states. It ends early where a state exceeds 1e6.

        Raises
        ------
        ValueError
            If the lengths differ or an expression contains an unknown symbol.
        """
        columns = (time or sp.Symbol("t"), *states)
        if not len(states) == len(rates) == len(initial):
            raise ValueError(
                f"rates, initial: expected one for each of the {len(states)} states, "
                f"got {len(rates)} and {len(initial)}"
            )
        formulas = {
            "rates": [self._formula("rates", rate, columns) for rate in rates],
            "initial": [self._formula("initial", value) for value in initial],
            "end": [self._formula("end", end)],
        }
        return self._add("trajectory", formulas, {"points": points}, columns)

    def recursion(self, states, updates, initial, steps, index=None, data=None):
        """Add the rows of a recursion, such as the steps of a filter.

        Parameters
        ----------
        states : sequence of sympy.Symbol, length n
            Symbols of the states.
        updates : sequence of sympy.Expr, length n
            The next states, in the states, the index of the step they lead to, the data at that
            index and the scalars so far.
        initial : sequence of sympy.Expr, length n
            Initial states, in the scalars so far.
        steps : int
            Number of steps.
        index : sympy.Symbol, optional
            Symbol of the index 0, 1, ..., `steps`; without it ``n``.
        data : dict of sympy.Symbol to array_like of shape (steps + 1,), optional
            Given numbers for each index, such as measurements.

        Returns
        -------
        Series
            Its columns are the index, the states and the data.

        Raises
        ------
        ValueError
            If lengths differ or an expression contains an unknown symbol.
        """
        data = {symbol: numbers("data", values) for symbol, values in (data or {}).items()}
        columns = (index or sp.Symbol("n"), *states, *data)
        if not len(states) == len(updates) == len(initial):
            raise ValueError(f"updates, initial: expected one for each of the {len(states)} states")
        if any(len(values) != steps + 1 for values in data.values()):
            raise ValueError(f"data: expected {steps + 1} numbers for each symbol")
        formulas = {
            "updates": [self._formula("updates", value, columns) for value in updates],
            "initial": [self._formula("initial", value) for value in initial],
        }
        constants = {"steps": steps, "data": list(data.values())}
        return self._add("recursion", formulas, constants, columns)

    def curve(self, symbol, low, high, points=CURVE_POINTS):
        """Add a column of equally spaced values, along which expressions are drawn.

        Parameters
        ----------
        symbol : sympy.Symbol
            The column.
        low, high : sympy.Expr or float
            Its first and last value, in the scalars so far.
        points : int
            Number of intervals.

        Returns
        -------
        Series
            Its only column is the symbol.

        Raises
        ------
        ValueError
            If an expression contains an unknown symbol.
        """
        formulas = {"low": [self._formula("low", low)], "high": [self._formula("high", high)]}
        return self._add("curve", formulas, {"points": points}, (symbol,))

    def table(self, data):
        """Add given numbers, such as a curve that was computed beforehand.

        Parameters
        ----------
        data : dict of sympy.Symbol to array_like of shape (N,)
            The columns.

        Returns
        -------
        Series
            Its columns are the symbols of `data`.

        Raises
        ------
        ValueError
            If the columns differ in length or are not finite.
        """
        columns = [numbers("data", values) for values in data.values()]
        if len({len(column) for column in columns}) != 1:
            raise ValueError("data: expected columns of one length")
        return self._add("table", {}, {"data": columns}, tuple(data))

    def roots(self, polynomial, variable):
        """Add the roots of a polynomial.

        Parameters
        ----------
        polynomial : sympy.Expr
            A polynomial in `variable`; its coefficients are real expressions in the scalars so far.
        variable : sympy.Symbol
            Its variable.

        Returns
        -------
        Series
            Its columns are the real symbols ``Re`` and ``Im``; a row is a root. A leading
            coefficient that vanishes takes a root away.

        Raises
        ------
        ValueError
            If it is no polynomial, or a coefficient contains an unknown symbol.
        """
        try:
            coefficients = sp.Poly(polynomial, variable).all_coeffs()
        except sp.PolynomialError as error:
            raise ValueError(f"polynomial: expected one in {variable}, got {polynomial}") from error
        formulas = {"coefficients": [self._formula("polynomial", value) for value in coefficients]}
        return self._add("roots", formulas, {}, sp.symbols("Re Im", real=True))

    def equilibria(self, states, rates, x_range, y_range):
        """Add the equilibria of a planar field that Newton's method finds from a grid of points.

        Parameters
        ----------
        states : (sympy.Symbol, sympy.Symbol)
            Symbols of the states.
        rates : (sympy.Expr, sympy.Expr)
            Right-hand sides, in the states and the scalars so far.
        x_range, y_range : (float, float)
            The window in which equilibria are sought.

        Returns
        -------
        Series
            Its columns are the states; a row is an equilibrium.

        Raises
        ------
        ValueError
            If an expression contains an unknown symbol.
        """
        slopes = sp.Matrix(list(rates)).jacobian(list(states))
        formulas = {
            role: [self._formula("rates", value, states) for value in values]
            for role, values in (("rates", rates), ("slopes", slopes))
        }
        ranges = [tuple(map(float, limits)) for limits in (x_range, y_range)]
        grid = np.meshgrid(*(np.linspace(*limits, EQUILIBRIA_GRID + 2)[1:-1] for limits in ranges))
        constants = {"ranges": ranges, "data": [part.ravel() for part in grid]}
        return self._add("equilibria", formulas, constants, states)

    # What is shown

    def panel(self, x, y, x_range, y_range, height=1.0, below=False):
        """Add a panel to the right of the others.

        Parameters
        ----------
        x, y : sympy.Symbol or str
            The coordinates; regions and fields are expressions in these symbols. A y axis with
            the name "" has no numbers.
        x_range, y_range : (float, float)
            Ranges (low, high) of the axes.
        height : float
            Height of the panel, as a multiple of its width.
        below : bool
            Whether it stands below the previous panel.

        Returns
        -------
        Panel
            The panel, to draw on.

        Raises
        ------
        ValueError
            If a range is empty.
        """
        panel = Panel(self, (x, y), (x_range, y_range), height, below and bool(self.panels))
        self.panels.append(panel)
        return panel

    def sentence(self, *cases):
        """Add a sentence that says what is seen.

        Parameters
        ----------
        *cases : (sympy.Boolean, str)
            Conditions in the scalars, each with its text; the first that holds is shown. In the
            text, the name of a scalar between braces stands for its value in three digits.

        Raises
        ------
        ValueError
            If no condition is always true, or a text names an unknown scalar.
        """
        self.sentences.append(Sentence(self, cases))

    def _formula(self, argument, value, columns=()):
        """Return an expression of the figure as a `Formula`."""
        return Formula(argument, value, self.scalars, columns)

    def _inputs_of(self, formulas, series=()):
        """Return the names of the parameters on which formulas by role and series depend."""
        names = {name for role in formulas.values() for formula in role for name in formula.scalars}
        return frozenset().union(
            *(self._inputs[name] for name in names), *(column.inputs for column in series)
        )

    def _dragged(self):
        """Return the names of the parameters that a point sets, not a slider."""
        return {name for panel in self.panels for name in panel.dragged}

    def set(self, **values):
        """Set the first values of parameters.

        Parameters
        ----------
        **values : float or str
            Values by the names of the parameters.

        Raises
        ------
        ValueError
            If there is no such parameter, or the value is no number between its limits.
        """
        self.parameters = with_values(self.parameters, values)

    def plot(self, **values):
        """Draw the static picture.

        Parameters
        ----------
        **values : float
            Values of parameters by name; the others have their first values.

        Returns
        -------
        matplotlib.figure.Figure
            The picture.

        Raises
        ------
        ValueError
            If there is no such parameter.
        """
        return draw(self, values)

    def _define(self, symbol, inputs):
        if not isinstance(symbol, sp.Symbol):
            raise ValueError(f"symbol: expected a symbol of SymPy, got {symbol!r}")
        if str(symbol) in self._inputs:
            raise ValueError(f"symbol: {symbol} has a value already")
        self._inputs[str(symbol)] = inputs
        self.scalars.append(symbol)

    def _add(self, kind, formulas, constants, columns=None, series=()):
        step = Step(kind, formulas, constants, self._inputs_of(formulas, series))
        self.steps.append(step)
        if columns is None:
            return None
        self.series.append(Series(self, len(self.series), tuple(columns), step.inputs))
        return self.series[-1]

    def _reduce(self, series, kind, symbol, value):
        formulas = {"value": [self._formula("value", value, series.columns)]}
        self._define(symbol, self._inputs_of(formulas, [series]))
        self._add(kind, formulas, {"series": series.index}, series=[series])

    def __repr__(self):
        count = len(self.panels)
        return f"Explorer of {count} panel{'s' * (count != 1)}: {self.description}"

    def _repr_html_(self):
        return html(self)
