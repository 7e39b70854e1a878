"""Import once, in the process that forks, what its children would otherwise import each for itself."""

import ast
import gc
import importlib
import re

from trajlib import exercises
from trajlib.dependencies import module_closure, path_of
from trajlib.grading.fingerprint import JUDGES

#: SymPy imports these inside its functions, when `solve`, `simplify`, `lambdify`, a derivative by a matrix or a set
#: first needs them.
SYMPY = ("sympy", "sympy.codegen.ast", "sympy.combinatorics", "sympy.integrals.heurisch",
         "sympy.integrals.manualintegrate", "sympy.integrals.risch", "sympy.matrices.expressions.applyfunc",
         "sympy.physics.units", "sympy.sets.handlers.functions", "sympy.sets.handlers.issubset", "sympy.sets.setexpr",
         "sympy.tensor.array.array_derivatives", "sympy.tensor.tensor")
#: For every notebook: the shell that runs its cells, and what writes and reads its answers.
ALWAYS = (*SYMPY, "numpy", "IPython.core.interactiveshell", "trajlib.checks.contract.sympy_codec")
#: What notebooks may use beside that.
LIBRARIES = ("casadi", "matplotlib.pyplot", "scipy.integrate", "scipy.interpolate", "scipy.linalg", "scipy.optimize")


def needed(problems, sources):
    """The modules, by name, that grading notebooks for these problems uses: each costs every run its time.

    `sources` are the notebooks' cells. They only choose among `LIBRARIES`, so nothing of theirs goes any further.
    """
    cells = [source for problem in problems for _, source in exercises.find(problem).code("data", "check")]
    ours = module_closure("\n".join([JUDGES, *cells]))
    loaded = {name for module in ours for name in _imports(path_of(module).read_text(encoding="utf-8"))}
    return [*ALWAYS, *(name for name in LIBRARIES if _uses(name, sources) or _computes(name) and name in loaded), *ours]


def _imports(source):
    """Names of all modules that code imports, also inside its functions."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield from (node.module, *(f"{node.module}.{alias.name}" for alias in node.names))


def _uses(name, sources):
    package, _, part = name.partition(".")
    # SciPy's parts are loaded one by one.
    pattern = re.compile(rf"\bscipy\b.*\b{part}\b" if package == "scipy" else rf"\b{package}\b")
    return any(pattern.search(source) for source in sources)


def _computes(name):
    """Whether checks use it: the pictures that their modules can also draw they do not."""
    return not name.startswith("matplotlib")


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
