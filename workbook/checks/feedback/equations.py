"""Feedback for one equation of any order with one control and one output, a `Scalar`.

Its state-space forms are y' = Ay + Bu, x = Cy, z = Hy; the feedback is by the estimate of such a
state, which the student chooses.

For such a form x^(k) = C A^k y + sum over j < k of C A^(k-1-j) B u^(j), and y, u, u', ... may have
any values at one time. The form is right if these satisfy the equation and give z, and if x, x', ...,
x^(n-1) determine y: then the equation and the form have the same motions. A form with the right transfer
function alone need not have all of them.

No check here is declared by a reference: any state-space form is right.
"""

import numpy as np

from workbook.checks.contract.claims import Claim, MatrixOrVector
from workbook.checks.contract.coercion import as_matrix
from workbook.checks.contract.tolerance import EXACT
from workbook.checks.contract.verdict import Invalid, UnsuitableData, Wrong, judged
from workbook.checks.feedback.loops import Requirement
from workbook.checks.references.fixed_modes import common_degree
from workbook.checks.references.pairs import pair_of
from workbook.checks.tools.comparisons import SameSides
from workbook.checks.tools.values import entry_uncertainties, matrix_at, perturbed_arrays
from workbook.checks.tools.wording import number_text


class StateForm(Claim):
    """A list of matrices A, B, C, ... of one state space.

    A is square, a matrix named in ROWS is a row, any other a column.
    """

    ROWS = "CHK"

    def read(self, answer, data):
        if not isinstance(answer, (list, tuple)) or len(answer) != len(self.names):
            raise Invalid(
                f"expected a list of {len(self.names)} matrices, [{', '.join(self.names)}]"
            )
        A = as_matrix(answer[0])
        if A.rows != A.cols:
            raise Invalid(f"expected a square matrix A, got the shape {A.shape}")
        return [
            A,
            *(
                MatrixOrVector.coerce(part, (), (1, A.rows) if name in self.ROWS else (A.rows, 1))
                for name, part in zip(self.names[1:], answer[1:])
            ),
        ]


@judged(StateForm("A", "B", "C", "H"))
def state_space_form(claim, equation):
    """Check a state-space form [A, B, C, H] of one equation.

    The form is y' = Ay + Bu, x = Cy, z = Hy, of the order of the equation: in any coordinates,
    with all motions x(t), z(t) of the equation and no others.

    Can decide when the coefficients are exact. Any coordinates are accepted.

    Examples
    --------
    >>> from workbook.systems import Scalar
    >>> s = sp.Symbol("s")
    >>> equation = Scalar(left=s**2 - 1, right=1, measured=1, symbol=s)
    >>> checks.state_space_form([[[0, 1], [1, 0]], [0, 1], [1, 0], [1, 0]], equation).status
    'right'
    >>> checks.state_space_form([[[0, 1], [-1, 0]], [0, 1], [1, 0], [1, 0]], equation).status
    'wrong'
    """
    yield from _comparisons(claim, equation)
    return "its motions are those of the equation, all of them, and z is what is measured"


@judged(StateForm("A", "B", "C", "H", "K", "L"))
def equation_gains(claim, equation):
    """Check a state-space form with gains, the list [A, B, C, H, K, L].

    The form is that of `state_space_form`, the feedback u = K e, e' = Ae + Bu + L(z - He). The
    gains have to stabilise and, where a mode that no gain changes bounds the degree of stability, to do so
    with the greatest one.

    Can decide when the coefficients are exact. Any coordinates and any stabilising gains are
    accepted, unless a mode bounds the degree of stability.

    Examples
    --------
    >>> from workbook.systems import Scalar
    >>> s = sp.Symbol("s")
    >>> equation = Scalar(left=s**2 - 1, right=1, measured=1, symbol=s)
    >>> form = [[[0, 1], [1, 0]], [0, 1], [1, 0], [1, 0]]
    >>> checks.equation_gains([*form, [-2, -2], [2, 2]], equation).status
    'right'
    >>> checks.equation_gains([*form, [-2, 0], [2, 2]], equation).status
    'wrong'
    """
    *form, K, L = claim
    A, B, _, H = form
    yield from _comparisons(form, equation)
    greatest = common_degree(equation)
    if greatest is not None and greatest <= 0:
        raise UnsuitableData("no feedback stabilises this equation")
    requirement = Requirement(degree=greatest or 0)
    requirement.judge(lambda gain: A + B * gain, K, "the matrix A + BK of the loop")
    message = requirement.judge(lambda gain: A - gain * H, L, "the matrix A - LH of the errors")
    return f"{message}, and so do those of A + BK"


def _comparisons(form, equation):
    n = equation.order
    parts = [matrix_at(part, {}) for part in form]
    if any(part.imag.any() for part in parts):
        raise Wrong("an entry of your form is not real")
    A, B, C, H = (part.real for part in parts)
    if len(A) != n:
        raise Wrong(
            f"the equation is of order {n}: so many initial values, of x, x', ..., can be chosen; "
            f"your form has {len(A)}"
        )
    left, right, measured = (
        np.array([*map(float, row), *[0.0] * (n + 1 - len(row))]) for row in equation.coefficients
    )

    def motions(A, B, C):
        """Return the matrices whose row k gives x^(k) as a combination of y, and of u, u', ..."""
        on_state = np.vstack([C @ np.linalg.matrix_power(A, k) for k in range(n + 1)])
        responses = [*(on_state @ B)[::-1, 0], *[0.0] * n]
        return on_state, np.array([responses[n + 1 - k : 2 * n + 1 - k] for k in range(n + 1)])

    def sides(A, B, C, H):
        on_state, on_control = motions(A, B, C)
        return left @ on_state, left @ on_control, measured @ on_state - H[0]

    on_state, on_control = motions(A, B, C)
    coefficients = left @ on_state, left @ on_control, measured @ on_state
    sizes = (
        max(abs(left) @ abs(on_state)),
        max(abs(left) @ abs(on_control)) + max(abs(right)),
        max(abs(measured) @ abs(on_state) + abs(H[0])),
    )
    exact = sides(A, B, C, H)
    uncertainties = [entry_uncertainties(part, {}) for part in form]
    perturbed = [sides(*parts) for parts in perturbed_arrays((A, B, C, H), uncertainties)]
    allowed = [
        EXACT * size + sum(abs(changed[k] - exact[k]) for changed in perturbed)
        for k, size in enumerate(sizes)
    ]
    yield SameSides(
        coefficients[0],
        0,
        allowed[0],
        lambda point: (
            f"the motion of your form without control from y{point[0] + 1} = 1, the others zero, "
            "does not satisfy the equation: at t = 0 its left-hand side is "
            f"{number_text(coefficients[0][point])}"
        ),
        1,
    )
    yield SameSides(
        coefficients[1],
        right[:-1],
        allowed[1],
        lambda point: (
            f"from rest your form does not satisfy the equation: u{_primes(point[0])} enters its "
            f"left-hand side with the coefficient {number_text(coefficients[1][point])}, its right-hand "
            f"side with {number_text(right[point])}"
        ),
        1,
    )
    if pair_of(form[0], form[2]).unobservable[0]:
        raise Wrong(
            "your form satisfies the equation, but does not have all its motions: x = Cy stays "
            "zero from some states other than zero, so that fewer initial values of x, x', ... "
            "can be chosen than the equation allows"
        )
    yield SameSides(
        H[0],
        coefficients[2],
        allowed[2],
        lambda point: (
            f"z is not what is measured: at y{point[0] + 1} = 1, the others zero, your row H gives "
            f"{number_text(H[0][point])}, and x and its derivatives {number_text(coefficients[2][point])}"
        ),
        1,
    )


def _primes(order):
    return "'" * order if order < 4 else f"^({order})"
