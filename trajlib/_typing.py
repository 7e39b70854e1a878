"""Types of arguments and results, which are exact (SymPy) or in floats (NumPy).

SymPy has no type information, and arguments are read and checked at run time, so all of these are
`Any` to mypy; the names inform the reader.
"""

from typing import Any, TypeAlias

#: A number, or an expression with symbols.
ScalarLike: TypeAlias = Any
#: A SymPy matrix, a nested list (both exact), an array, or a scalar for a 1 x 1 matrix.
MatrixLike: TypeAlias = Any
#: Anything that `numpy.asarray` converts to an array of numbers.
ArrayLike: TypeAlias = Any
#: `sympy.Expr` for exact arguments, `float` otherwise.
Scalar: TypeAlias = Any
#: `sympy.Matrix` for exact arguments, `numpy.ndarray` otherwise.
Matrix: TypeAlias = Any
#: An expression or a number.
ExprLike: TypeAlias = Any
#: Several expressions: a list, a tuple or a matrix with one column.
Expressions: TypeAlias = Any
#: A polynomial: an expression, a Poly, or the coefficients with the highest power first.
PolynomialLike: TypeAlias = Any
#: One symbol or several.
Symbols: TypeAlias = Any
