"""What gains can do at all: the region of those that stabilise, the margins that can be had, and what stands in the
way.

A margin mu is that of Definition 1.5, Re lambda <= -mu for all eigenvalues.
"""

import sympy as sp

from trajlib.checks.contract import coercion
from trajlib.checks.contract.tolerance import EXACT
from trajlib.checks.contract.verdict import Invalid, Wrong, judged
from trajlib.checks.tools.conditions import compare, exactly, place_text
from trajlib.checks.tools.samples import in_every_case
from trajlib.checks.tools.values import matrix_at, number_at, uncertain_entries
from trajlib.checks.tools.wording import number_text, where_text
from trajlib.checks.truths.exceptional_values import judge_everywhere
from trajlib.checks.truths.fixed_modes import ON_BORDER, greatest_margin, margins_with_parameters, slower_than
from trajlib.checks.truths.pairs import pair_of
from trajlib.checks.truths.spectra import compare_region


@judged
def observer_region(answer, A, H, gain, parameters, margin=0):
    """The condition on `parameters` under which the errors of the observer with this gain decay, A - LH.

    `gain` is a matrix of symbols; with a margin its border counts either way.
    """
    return compare_region(answer, A - gain*H, parameters, "convergent", margin)


@judged
def feedback_region(answer, A, B, gain, parameters, H=None, margin=0):
    """The condition on `parameters` under which u = Kx, with H the static feedback u = Kz, stabilises.

    `gain` is a matrix of symbols; with a margin its border counts either way.
    """
    return compare_region(answer, A + B*gain*(sp.eye(A.rows) if H is None else H), parameters, "stable", margin)


@judged
def observer_margins(answer, A, H, mu, parameters=()):
    """The condition on mu > 0 under which some observer has the margin mu; false if there is no asymptotic observer.

    With parameters the condition is on mu and these, so it also says for which values there is no observer.
    """
    return _judge_margins(answer, A, H, mu, parameters, "observer")


@judged
def feedback_margins(answer, A, B, mu, parameters=()):
    """The condition on mu > 0 under which some feedback u = Kx has the margin mu; false if there is none at all.

    With parameters as in `observer_margins`.
    """
    return _judge_margins(answer, A.T, B.T, mu, parameters, "feedback")


@judged
def estimate_margins(answer, A, B, H, mu, S=None, c=None):
    """The condition on mu > 0 under which some feedback by an estimate has the margin mu, its errors included.

    With S and c the measurement has an error c w, w' = S w, that is estimated too.
    """
    observed, output = (A, H) if S is None else (sp.diag(A, S), H.row_join(c))
    greatest = [greatest_margin(pair) for pair in (pair_of(A.T, B.T), pair_of(observed, output))]
    return compare_margins(answer, [mu], up_to(mu, *greatest), "feedback by an estimate")


def _judge_margins(answer, A, H, mu, parameters, what):
    truth = margins_with_parameters(A, H, mu, parameters) if parameters else up_to(mu, greatest_margin(pair_of(A, H)))
    return compare_margins(answer, [*parameters, mu], truth, what)


def up_to(mu, *greatest):
    """The `Truth` that mu is at most the least of the margins; those that are None set no bound."""
    bounds = [margin for margin in greatest if margin is not None]
    return exactly(mu <= min(bounds, key=float) if bounds else sp.true)


def compare_margins(answer, symbols, truth, what):
    def told(values, holds):
        if holds:
            return f"your condition does not hold for {place_text(values)}, yet some {what} has this margin"
        return f"your condition holds for {place_text(values)}, yet no {what} has this margin"

    return f"these are the margins that some {what} has: {compare(answer, symbols, truth, told)}"


@judged
def observer_obstacle(answer, A, H, parameters=()):
    """A motion that forbids an asymptotic observer, {lambda: v}: A v = lambda v, H v = 0, Re lambda >= 0; {} if none.

    With parameters: for all their values, zero too where it is allowed.
    """
    if not isinstance(answer, dict):
        raise Invalid("expected a dictionary {lambda: v}, an empty one if nothing stands in the way")
    pair = pair_of(A, H, parameters)
    claims = {coercion.as_expression(value, parameters): sp.Matrix(coercion.as_expressions(vector, parameters, A.rows))
              for value, vector in answer.items()}
    if not claims:
        if slower_than(0, pair):
            raise Wrong("there is a mode that does not decay and that no gain changes")
        return "every mode that no gain changes decays"
    places = [values for values, _ in pair.samples]
    zero = {p: sp.Integer(0) for p in parameters}
    if parameters and not any(p.is_nonzero for p in parameters) and not sp.Matrix.vstack(A, H).subs(zero).has(sp.zoo):
        places.append(zero)
    for value, vector in claims.items():
        for values in in_every_case(places, [value, vector]):
            _hold_mode(value, vector, A, H, values, where_text(values))
        judge_everywhere(vector, parameters, lambda: sp.true, "your vector v is undefined", "your vector v is zero")
    return "it is a mode that does not decay, and nothing can be done about it: A v = lambda v"


def _hold_mode(value, vector, A, H, values, where):
    root, column = number_at(value, values, "your lambda"), matrix_at(vector, values)
    matrix, output = matrix_at(A, values), matrix_at(H, values)
    if not abs(column).max() > 0:
        raise Wrong(f"your vector v is zero{where}")
    open_, (open_root,) = uncertain_entries(vector, values), *uncertain_entries(sp.Matrix([value]), values)
    image = matrix @ column
    size = (abs(matrix) @ abs(column)).max() + abs(root)*abs(column).max()
    left_open = abs(matrix) @ open_ + abs(root)*open_ + open_root*abs(column)
    if not (abs(image - root*column) <= EXACT*size + left_open).all():
        raise Wrong(f"v and lambda = {number_text(root)} do not satisfy A v = lambda v{where}")
    shown = abs(output) @ abs(column)
    if not (abs(output @ column) <= EXACT*shown + abs(output) @ open_).all():
        k = int(abs(output @ column).argmax())
        raise Wrong(f"the output shows it: H v has the component {number_text((output @ column)[k, 0])}{where}, not 0")
    if not root.real > -ON_BORDER:
        raise Wrong(f"a mode with lambda = {number_text(root)} decays{where}, and forbids nothing")
