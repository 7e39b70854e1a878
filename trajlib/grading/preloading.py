"""Import once, in the process that forks, what its children would otherwise import each for itself."""

import gc
import importlib
import re
from contextlib import suppress

from trajlib import exercises
from trajlib._lazy import home_of
from trajlib.dependencies import module_closure, path_of
from trajlib.grading.fingerprint import JUDGES

#: SymPy imports these inside its functions, when `solve`, `simplify`, `lambdify`, a derivative by a matrix or a set
#: first needs them.
SYMPY = ("sympy", "sympy.assumptions.wrapper", "sympy.codegen.ast", "sympy.combinatorics", "sympy.integrals.heurisch",
         "sympy.integrals.manualintegrate", "sympy.integrals.risch", "sympy.matrices.expressions.applyfunc",
         "sympy.physics.units", "sympy.sets.handlers.functions", "sympy.sets.handlers.issubset", "sympy.sets.setexpr",
         "sympy.tensor.array.array_derivatives", "sympy.tensor.tensor")
#: For every notebook: the shell that runs its cells, and what writes and reads its answers.
ALWAYS = (*SYMPY, "numpy", "IPython.core.interactiveshell", "trajlib.checks.contract.sympy_codec")
#: What notebooks and checks may use beside that.
LIBRARIES = ("casadi", "matplotlib.pyplot", "scipy.integrate", "scipy.interpolate", "scipy.linalg", "scipy.optimize",
             "z3")
#: Packages of trajlib from which notebooks may take functions.
THEMES = ("estimation", "feedback", "pontryagin", "reconstruction", "solvability", "stability", "structure")


def needed(problems, sources):
    """The modules, by name, that grading notebooks for these problems uses: each costs every run its time.

    `sources` are the notebooks' cells. They only choose among `LIBRARIES` and the public names of `THEMES`, so nothing
    of theirs goes any further.
    """
    cells = [source for problem in problems for _, source in exercises.find(problem).code("data", "check")]
    ours = module_closure("\n".join([JUDGES, *cells]))
    imports = [line for module in ours for line in _IMPORT.findall(path_of(module).read_text(encoding="utf-8"))]
    used = [name for name in LIBRARIES if _uses(name, sources) or _computes(name) and _uses(name, imports)]
    return [*ALWAYS, *used, *ours, *_functions(sources)]


#: A line that imports, also inside a function.
_IMPORT = re.compile(r"^ *(?:import|from) .*", re.MULTILINE)


def _uses(name, sources):
    package, _, part = name.partition(".")
    # SciPy's parts are loaded one by one.
    pattern = re.compile(rf"\bscipy\b.*\b{part}\b" if package == "scipy" else rf"\b{package}\b")
    return any(pattern.search(source) for source in sources)


def _functions(sources):
    """The modules that hold the functions of trajlib which cells name."""
    words = {word for source in sources for word in re.findall(r"\w+", source)}
    return sorted({home_of(package, name) for theme in THEMES if theme in words
                   for package in [f"trajlib.{theme}"] for name in dir(importlib.import_module(package))
                   if name in words})


def _computes(name):
    """Whether checks use it: the pictures that their modules can also draw they do not."""
    return not name.startswith("matplotlib")


def preload(*modules, themes=()):
    """Import the modules and all public names of the themes of trajlib ("checks", "stability", ...).

    What is loaded no longer concerns the collector of garbage, which would write to every object, and so copy the
    memory that a child shares with this process. While it is loaded, hardly any of it is garbage.
    """
    gc.disable()
    for name in modules:
        with suppress(ModuleNotFoundError):  # z3 is not to be had everywhere
            importlib.import_module(name)
    for theme in themes:
        home = importlib.import_module(f"trajlib.{theme}")
        for name in dir(home):  # lazy names too
            getattr(home, name)
    gc.freeze()
    gc.enable()
