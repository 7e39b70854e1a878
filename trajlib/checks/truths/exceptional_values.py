"""Where an answer with parameters fails though it is right in general: where a denominator, a pivot or a determinant of
it vanishes, at values of the parameters at which the truth is what it is elsewhere. All values are looked at, exactly.
"""

import itertools

import sympy as sp

from trajlib.checks.tools.conditions import compare, exactly, place_text

#: Answers longer than this are tried at values in general position alone.
MOST_OPERATIONS = 600


def judge_everywhere(matrix, parameters, given, undefined, dependent=None):
    """Raise `Wrong` at values of the parameters where a matrix is `undefined`, as the message says, or its columns are
    `dependent`, under the condition `given()`, which is asked for only if the matrix holds a parameter."""
    used = [p for p in parameters if matrix.has(p)]
    if not used or matrix.has(sp.nan, sp.zoo, sp.oo) or sp.count_ops(matrix) > MOST_OPERATIONS:
        return
    matrix = matrix.applyfunc(lambda entry: sp.cancel(sp.nsimplify(entry, rational=True))
                              if entry.is_rational_function(*used) else entry)
    conditions = {undefined: sp.And(*(sp.Ne(sp.denom(sp.together(entry)), 0) for entry in matrix))}
    if dependent:
        minors = (matrix.extract(list(rows), list(range(matrix.cols))).det(method="berkowitz")
                  for rows in itertools.combinations(range(matrix.rows), matrix.cols))
        conditions[dependent] = sp.Or(*(sp.Ne(sp.numer(sp.together(minor)), 0) for minor in minors))
    for failure, condition in conditions.items():
        if condition != sp.true:
            compare(condition, parameters, exactly(sp.true, given()),
                    lambda values, holds: f"{failure} for {place_text(values)}, where the answer is to serve too")
