"""Types of arguments in the signatures of public functions."""

from collections.abc import Sequence
from typing import Any, TypeAlias

import sympy as sp

#: A SymPy matrix, a list of rows, a scalar (all exact) or a NumPy array (floats); in place of A also
#: python-control's StateSpace.
MatrixLike: TypeAlias = Any
#: A matrix of a result: SymPy's if the input was exact, a NumPy array otherwise.
Matrix: TypeAlias = Any
#: An expression or a number.
ExprLike: TypeAlias = sp.Expr | float
#: Several expressions: a list, a tuple or a matrix with one column.
Expressions: TypeAlias = Sequence[sp.Expr] | sp.MatrixBase
#: A polynomial: an expression, a Poly, or the coefficients with the highest power first.
PolynomialLike: TypeAlias = sp.Expr | sp.Poly | Sequence[ExprLike]
#: One symbol or several.
Symbols: TypeAlias = sp.Symbol | Sequence[sp.Symbol]
