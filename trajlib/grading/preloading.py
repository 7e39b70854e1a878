"""Import once, in the process that forks, what its children would otherwise import each for itself."""

import gc
import importlib

#: SymPy imports these inside its functions, when `solve`, `simplify`, `lambdify`, a derivative by a matrix or a set
#: first needs them.
SYMPY = ("sympy", "sympy.codegen.ast", "sympy.combinatorics", "sympy.integrals.heurisch",
         "sympy.integrals.manualintegrate", "sympy.integrals.risch",
         "sympy.matrices.expressions.applyfunc", "sympy.physics.units", "sympy.sets.handlers.functions",
         "sympy.sets.handlers.issubset",
         "sympy.sets.setexpr", "sympy.tensor.array.array_derivatives", "sympy.tensor.tensor")
#: What notebooks use beside it, the shell that runs their cells included.
NOTEBOOKS = ("casadi", "IPython.core.interactiveshell", "matplotlib.pyplot", "matplotlib_inline.config", "numpy",
             "scipy.integrate",
             "scipy.interpolate", "scipy.linalg", "scipy.optimize")


def preload(*modules, themes=()):
    """Import the modules and all public names of the themes of trajlib ("checks", "stability", ...).

    What is loaded then no longer concerns the collector of garbage, which would write to every object, and so copy the
    memory that a child shares with this process.
    """
    for name in modules:
        importlib.import_module(name)
    for theme in themes:
        home = importlib.import_module(f"trajlib.{theme}")
        for name in dir(home):  # lazy names too
            getattr(home, name)
    gc.collect()
    gc.freeze()
