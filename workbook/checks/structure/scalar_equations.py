"""Scalar equations equivalent to x' = A x + b u.

An equation is of order n, between y = c x, the control and their derivatives.

At one instant x, u, u', ... may have any values, and the system then determines y, y', ..., y^(n).
An equation is right if it is linear with constant coefficients, of order n, and satisfied by
all of these values, so neither the arrangement of its sides nor a factor matters. Where y is not
given as a combination of x it is the first coordinate of the controllable canonical form (2.4): the
combination with y' = xi2, y'' = xi3, ..., into whose n-th derivative the control enters with the
coefficient 1, and not before.

No check here is declared by a reference: any arrangement of an equation is right.
"""

import numpy as np
import sympy as sp
from sympy.core.function import AppliedUndef

from workbook.checks.contract.claims import Expressions
from workbook.checks.contract.tolerance import EXACT, agree, relative_tolerance
from workbook.checks.contract.verdict import Invalid, UnsuitableData, Wrong, judged
from workbook.checks.references.exceptional_values import judge_where_generic
from workbook.checks.references.invariant_subspaces import chain
from workbook.checks.references.records import controlled_pair, observed_pair
from workbook.checks.tools.samples import general_values, in_every_case
from workbook.checks.tools.values import entry_uncertainties, number_at, numbers_at, uncertainty_at
from workbook.checks.tools.wording import number_text, where_text

LARGEST_ORDER = 12


@judged(system="Linear with controls")
def scalar_equation(answer, system, motion, control, parameters=()):
    """Check the equation of order n between the control and y.

    Here y is the output or else the first coordinate of the controllable canonical form (2.4);
    `motion` and `control` are functions of time such as y(t), u(t).

    Can decide when the equation is linear in y, the control and their derivatives; it is tried at
    random states and controls.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> t = sp.Symbol("t")
    >>> y, u = sp.Function("y")(t), sp.Function("u")(t)
    >>> cart = Linear(A=[[0, 1], [0, -1]], B=[[0], [1]])
    >>> checks.scalar_equation(sp.Eq(y.diff(t, 2) + y.diff(t), u), cart, y, u).status
    'right'
    >>> checks.scalar_equation(sp.Eq(y.diff(t, 2), u), cart, y, u).status
    'wrong'
    """
    claim, canonical = _LinearEquation(answer, motion, control, parameters), not system.H
    for values in general_values(list(parameters)):
        numeric_system = system.subs(values)
        row = (
            _first_coordinate(numeric_system.A, numeric_system.B) if canonical else numeric_system.H
        )
        claim.judge(numeric_system.A, numeric_system.B, row, values, canonical=canonical)
    pair = controlled_pair(system, parameters) if canonical else observed_pair(system, parameters)
    claim.judge_where_generic(pair)
    return "it is linear, of the order of the system, and " + (
        "the first canonical coordinate satisfies it at random states and controls"
        if canonical
        else "satisfied at random states and controls"
    )


@judged(Expressions("parameters", length="system.A"), system="Linear with controls")
def canonical_coordinate(claim, system, parameters=()):
    """Check the row c for which y = c x is the first coordinate of the canonical form (2.4).

    The row has n entries; the form is that by control, with one control.

    Can decide when the entries are exact numbers, or rational functions of the parameters.

    Examples
    --------
    >>> from workbook.systems import Linear
    >>> plant = Linear(A=[[0, 1], [2, 1]], B=[[0], [3]])
    >>> checks.canonical_coordinate([sp.Rational(1, 3), 0], plant).status
    'right'
    >>> checks.canonical_coordinate([1, 0], plant).status
    'wrong'
    """
    for values in in_every_case(general_values(list(parameters)), claim):
        A, b = system.A.subs(values), system.B.subs(values)
        row = numbers_at(claim, values, [f"coefficient of x{k}" for k in range(1, A.rows + 1)])
        true = _floats(_first_coordinate(A, b))[0]
        uncertain = [uncertainty_at(entry, values) for entry in claim]
        if not agree(row, true, claim, np.linalg.norm(true), uncertain=uncertain).all():
            _explain_row(
                row, _floats(A), _floats(b)[:, 0], relative_tolerance(claim), where_text(values)
            )
    return "the control enters the last derivative alone, with the coefficient 1"


def _explain_row(row, A, b, tolerance, where):
    """Raise `Wrong` on the derivative of y = `row` x that the control enters too early.

    If there is none, it enters the last one with a coefficient other than 1.
    """
    n = len(row)
    for order in range(1, n + 1):
        coefficient = row @ b
        if order == n or not abs(coefficient) <= tolerance * np.linalg.norm(row) * np.linalg.norm(
            b
        ):
            raise Wrong(
                f"the control enters {_derivative('y', order)} with the coefficient "
                f"{number_text(coefficient)}{where}; in the form "
                "(2.4) " + ("it is 1" if order == n else f"it enters {_derivative('y', n)} first")
            )
        row = row @ A


class _LinearEquation:
    """An equation as left - right = sum of a_k y^(k) + sum of b_k u^(k), a_k, b_k in parameters."""

    def __init__(self, answer, motion, control, parameters):
        (self.time,), self.names = motion.args, (motion.func.__name__, control.func.__name__)

        self.derivatives = [
            [sp.Dummy(f"{name}{k}") for k in range(LARGEST_ORDER + 1)] for name in self.names
        ]
        substitutions = {
            function.diff(self.time, k): symbol
            for function, symbols in zip((motion, control), self.derivatives)
            for k, symbol in enumerate(symbols)
        }
        left, right = (
            self._in_data_symbols(side, motion, control, parameters).xreplace(substitutions)
            for side in self._sides(answer)
        )
        difference = sp.expand(left - right)
        self.coefficients = [
            [self._coefficient(difference, symbol) for symbol in symbols]
            for symbols in self.derivatives
        ]
        constant = difference.xreplace(dict.fromkeys(sum(self.derivatives, []), sp.S.Zero))
        if constant.has(sp.nan, sp.zoo, sp.oo, -sp.oo, self.time) or sp.simplify(constant) != 0:
            raise Wrong(
                f"beside the terms with {self.names[0]}, {self.names[1]} and their derivatives "
                "your equation has a term without any of them, so that it fails at rest without control"
            )

    def judge_where_generic(self, pair):
        """Judge that the equation is defined and keeps its order for all parameters."""
        undefined = "your equation is undefined"
        dropped = "the highest derivative falls out of your equation"
        of_motion, of_control = self.coefficients
        judge_where_generic(sp.Matrix([of_motion + of_control]), pair, undefined)
        judge_where_generic(sp.Matrix([of_motion[pair.order]]), pair, undefined, dropped)

    def judge(self, A, b, c, values, canonical=False):
        """Judge that the equation has the order of the system and holds for y = c x.

        The matrices are exact numbers; `values` are the parameters, for messages.
        """
        n, where = A.rows, where_text(values)
        numbers = [
            [number_at(a, values, "a coefficient of your equation") if a != 0 else 0 for a in row]
            for row in self.coefficients
        ]
        self.uncertain = [
            entry_uncertainties(sp.Matrix([row]), values)[0] for row in self.coefficients
        ]
        size = max(abs(a) for row in numbers for a in row)
        present = [[k for k, a in enumerate(row) if abs(a) > 1e-9 * size] for row in numbers]
        y, _u = self.names
        if not present[0] or max(present[0]) != n:
            order = f"its highest derivative of {y} is of order {max(present[0], default=0)}"
            raise Wrong(
                f"the equation has to be of order {n}, as the system is; "
                + (order if present[0] else f"{y} does not occur in it")
            )
        highest = max(max(present[1], default=0), n - 1)
        rows = chain(c, A, n + 1)
        observability = sp.Matrix.vstack(*rows[:n])
        if observability.det() == 0:
            raise UnsuitableData("y does not determine the state: its equation is not the system")
        # y^(k) in terms of x and of u, u', ..., u^(highest)
        driven = sp.Matrix(
            n + 1, highest + 1, lambda k, j: (rows[k - 1 - j] * b)[0] if j < k else 0
        )
        output_map = np.array(sp.Matrix.vstack(*rows).row_join(driven).tolist(), dtype=float)
        # The states at which all but one of y, ..., y^(n-1), u, u', ... vanish: no other term can
        # cancel a wrong one there.
        inverse = observability.inv()
        states = np.array(
            (inverse.row_join(-inverse * driven[:n, :]))
            .col_join(sp.zeros(highest + 1, n).row_join(sp.eye(highest + 1)))
            .tolist(),
            dtype=float,
        )
        failing = [k for k, state in enumerate(states.T) if self._fails(numbers, output_map, state)]
        if failing:
            self._explain(numbers, output_map, highest, failing, where, canonical, present[1])

    def _explain(self, numbers, output_map, highest, failing, where, canonical, controls):
        n, (y, u) = len(output_map) - 1, self.names
        if failing[0] >= n and canonical:
            if max(controls, default=0) > 0:
                raise Wrong(
                    f"a derivative of {u} stands in your equation{where}; into that of the first "
                    f"coordinate of the form (2.4) {u} enters alone"
                )
            if controls:
                raise Wrong(
                    f"without control your equation is right{where}, but {u} has the wrong "
                    f"coefficient; in the form (2.4) {u} enters the last equation with the "
                    f"coefficient 1, and {y} is the first coordinate of that form and no multiple of it"
                )
        random, unforced = np.random.default_rng(220), failing[0] < n
        for _ in range(20):
            size = n + highest + 1
            state = random.integers(1, 6, size) * random.choice((-1.0, 1.0), size)
            if unforced:
                state[n:] = 0
            if self._fails(numbers, output_map, state):
                break
        x = ", ".join(map(number_text, state[:n]))
        controls = [f"{_derivative(u, k)} = {number_text(s)}" for k, s in enumerate(state[n:])]
        control = f"{u} = 0" if unforced else ", ".join(controls)
        hint = "" if unforced else "without control it is right; "
        raise Wrong(
            f"{hint}at x = ({x}) and {control}{where} the derivatives of {y} do not satisfy your "
            "equation"
        )

    def _terms(self, numbers, output_map, state):
        n, (of_motion, of_control) = len(output_map) - 1, map(np.array, numbers)
        motion = of_motion[: n + 1] * (output_map @ state)
        return np.concatenate([motion, of_control[: len(state) - n] * state[n:]])

    def _fails(self, numbers, output_map, state):
        terms = self._terms(numbers, output_map, state)
        uncertainties = self._terms(self.uncertain, output_map, state)
        return not abs(sum(terms)) <= EXACT * sum(abs(terms)) + sum(abs(uncertainties))

    def _sides(self, answer):
        if isinstance(answer, sp.Eq):
            sides = answer.args
        elif isinstance(answer, sp.Expr) and answer.has(AppliedUndef):
            sides = (answer, sp.S.Zero)  # an expression stands for expression = 0
        else:
            y, u = (f"{name}({self.time})" for name in self.names)
            raise Invalid(
                f"expected an equation `sp.Eq(left, right)` between `{y}`, `{u}` and their "
                "derivatives, "
                f"such as `{y}.diff({self.time})`; with `==` Python compares the sides at once"
            )
        undefined = sp.nan, sp.zoo, sp.oo, -sp.oo
        if not all(
            isinstance(side, sp.Expr)
            and not (isinstance(side, sp.MatrixBase) or side.has(*undefined))
            for side in sides
        ):
            raise Invalid(
                "both sides of the equation have to be expressions, without anything undefined or "
                "infinite"
            )
        return sides

    def _in_data_symbols(self, side, motion, control, parameters):
        """Return a side in the functions and symbols of the data, with derivatives carried out."""
        known = {str(part): part for part in (motion, control, *parameters, self.time)}
        names = {s: s.name for s in side.free_symbols}
        names |= {function: str(function) for function in side.atoms(AppliedUndef)}
        if foreign := {*names.values()} - known.keys():
            raise Invalid(
                f"the equation contains {', '.join(sorted(foreign))}; expected only "
                f"{', '.join([*known][:-1])} and derivatives with respect to {self.time}"
            )
        side = side.xreplace({part: known[name] for part, name in names.items()})
        counts = (pair for d in side.atoms(sp.Derivative) for pair in d.variable_count)
        if any(v != self.time or not count.is_Integer for v, count in counts):
            raise Invalid(
                f"a derivative is not one with respect to {self.time}, a definite number of times"
            )
        side = self._differentiated(side)
        if any(d.derivative_count > LARGEST_ORDER for d in side.atoms(sp.Derivative)) or side.has(
            sp.Integral
        ):
            raise Invalid(
                "expected an equation without integrals, with derivatives up to the order "
                f"{LARGEST_ORDER}"
            )
        return side

    def _differentiated(self, expression):
        """Carry out the derivatives of sums and multiples.

        SymPy's own `doit` may take minutes for powers and products.
        """
        if not expression.has(sp.Derivative):
            return expression
        if not isinstance(expression, sp.Derivative):
            return expression.func(*map(self._differentiated, expression.args))
        if isinstance(expression.expr, AppliedUndef):
            return expression
        terms = []
        for term in sp.Add.make_args(sp.expand(self._differentiated(expression.expr))):
            factor, function = term.as_independent(AppliedUndef, sp.Derivative, as_Add=False)
            if factor.has(self.time) or not (
                function == 1 or isinstance(function, (AppliedUndef, sp.Derivative))
            ):
                raise Wrong(self._not_linear())
            if function != 1:
                terms.append(factor * function.diff((self.time, expression.derivative_count)))
        return sp.Add(*terms)

    def _not_linear(self):
        return (
            f"your equation is not linear with constant coefficients in {self.names[0]}, "
            f"{self.names[1]} and their derivatives"
        )

    def _coefficient(self, difference, symbol):
        if not difference.has(symbol):
            return sp.S.Zero
        coefficient, derivatives = sp.diff(difference, symbol), sum(self.derivatives, [])
        if coefficient.has(*derivatives, self.time):
            coefficient = sp.simplify(coefficient)
        if coefficient.has(*derivatives, self.time):
            raise Wrong(
                self._not_linear()
                if coefficient.has(*derivatives)
                else f"a coefficient of your equation depends on {self.time}; those of the system do not"
            )
        return coefficient


def _first_coordinate(A, b):
    """Return the row c with c b = c A b = ... = 0 and c A^(n-1) b = 1."""
    W = sp.Matrix.vstack(*chain(b.T, A.T, A.rows))
    if W.det() == 0:
        raise UnsuitableData("there is no canonical form: the control does not reach every state")
    return W.LUsolve(sp.Matrix([0] * (A.rows - 1) + [1])).T


def _floats(matrix):
    return np.array(matrix.tolist(), dtype=float)


def _derivative(name, k):
    return name + "'" * k if k < 4 else f"{name}^({k})"
