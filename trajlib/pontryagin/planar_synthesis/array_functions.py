"""SymPy expressions as NumPy functions of arrays."""

import numpy as np
import sympy as sp


def array_function(arguments, expressions):
    """Return a NumPy function with values of shape (len(expressions), N), also for constants."""
    # The module itself, not its name, for which SymPy would import all names of NumPy, which takes
    # half a second.
    raw = sp.lambdify(list(arguments), list(expressions), [np], cse=True)

    def value(*numbers):
        rows = raw(*numbers)
        shape = np.broadcast(*numbers).shape
        result = np.empty((len(rows), *shape))
        for k, row in enumerate(rows):
            result[k] = row
        return result

    return value
