'''Names for checks of one's own, in `checks.py` of a course or in a data cell.

A check is a function of the answer and of data. `judged` turns it into one that always returns a
verdict, whatever a student has assigned:

- a **claim** says as what the answer is read: `Expression`, `Matrix`, `Number` ... The names in it are
  those of the data whose symbols the answer may hold. What cannot be read is *invalid*, with a sentence.
- a **comparison** says what the answer has to be: the check yields `SameValue`, `SameEntries`,
  `SameTruth` ..., which know what decimals, symbols and infinite values count for. Or it raises
  `Wrong` with the property that fails, and `Invalid` for what is not of the type asked.
- what it returns is the sentence on a right answer.

`declared` is shorter still: a function returns the `Truth` at values of the symbols. Samples come from
`allowed_values`; `in_every_case` adds one for each case that an answer distinguishes. Data that cannot
be judged raise `UnsuitableData` with a sentence to the author; any other exception gives *unchecked*.

A message names the property that fails and the answer's own numbers, never the true value.

Before writing one, look for a check by what is asked: `book/guides/checks.md` has a table. If the
answer is an expression, a number or a matrix that a formula gives, `checks.same_expression`,
`same_value` and `same_matrix` compare with it.

Examples
--------
The Jacobian matrix of the position of a robot arm, with a property beside the entries:

>>> import sympy as sp
>>> from workbook.checks.authoring import Matrix, SameEntries, Wrong, allowed_values, judged
>>> @judged(Matrix("angles", "lengths", shape=lambda data: (len(data["position"]), len(data["angles"]))))
... def jacobian(claim, position, angles, lengths):
...     """Check the Jacobian matrix of a position with respect to joint angles."""
...     true = sp.Matrix(position).jacobian(angles)
...     if claim.rank() == 0:
...         raise Wrong("your matrix is zero, yet the arm moves when its joints turn")
...     for values in allowed_values([*angles, *lengths], sp.true, 6):
...         yield SameEntries(
...             claim,
...             sp.matrix2numpy(true.subs(values), dtype=float),
...             lambda numbers, i, j: f"entry ({i + 1}, {j + 1}) is not this partial derivative",
...             values,
...         )
...     return "its entries are the partial derivatives of the position"
>>> q, l = sp.symbols("q l", real=True)
>>> hand = [l * sp.cos(q), l * sp.sin(q)]
>>> jacobian([[-l * sp.sin(q)], [l * sp.cos(q)]], hand, [q], [l]).status
'right'
>>> jacobian([[l * sp.sin(q)], [l * sp.cos(q)]], hand, [q], [l]).message
'entry (1, 1) is not this partial derivative'
>>> jacobian(..., hand, [q], [l]).status, jacobian([1, 2, 3], hand, [q], [l]).status
('missing', 'invalid')

The same without a message of its own, declared by what is true at values of the symbols:

>>> from workbook.checks.authoring import Expression, Truth, at_symbols, declared
>>> @declared(
...     Expression("angles", "parameters"),
...     right="it is the distance of the hand from the base",
...     wrong="the distance of the hand from the base",
...     samples=at_symbols("angles"),
... )
... def reach(values, position, angles):
...     return Truth(float(sp.Matrix(position).norm().subs(values)))
>>> reach(sp.Abs(l), hand, [q], [l]).status, reach(l, hand, [q], [l]).status
('right', 'wrong')
>>> reach(l, hand, [q], [l], given=l > 0).status
'right'
'''

from workbook.checks.contract.claims import (
    Choice,
    Claim,
    ConditionOn,
    Expression,
    Expressions,
    Integer,
    Matrix,
    MatrixOrVector,
    Number,
    Parts,
    Table,
    Values,
    Vectors,
    YesNo,
)
from workbook.checks.contract.verdict import Invalid, UnsuitableData, Verdict, Wrong, judged
from workbook.checks.tools.comparisons import (
    SameEntries,
    SameMembers,
    SameNumbers,
    SameSides,
    SameTruth,
    SameValue,
    SameWord,
)
from workbook.checks.tools.declared import Truth, WrongEntry, at_symbols, declared
from workbook.checks.tools.samples import allowed_values, in_every_case

__all__ = [
    "Choice",
    "Claim",
    "ConditionOn",
    "Expression",
    "Expressions",
    "Integer",
    "Invalid",
    "Matrix",
    "MatrixOrVector",
    "Number",
    "Parts",
    "SameEntries",
    "SameMembers",
    "SameNumbers",
    "SameSides",
    "SameTruth",
    "SameValue",
    "SameWord",
    "Table",
    "Truth",
    "UnsuitableData",
    "Values",
    "Vectors",
    "Verdict",
    "Wrong",
    "WrongEntry",
    "YesNo",
    "allowed_values",
    "at_symbols",
    "declared",
    "in_every_case",
    "judged",
]
