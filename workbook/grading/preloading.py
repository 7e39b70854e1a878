"""Import once, in the process that forks, what its children would otherwise import each for
itself."""

import ctypes
import gc
import importlib.util
import io
import re
import sys
from contextlib import contextmanager, suppress

from trajlib._lazy import home_of
from workbook.grading.fingerprint import JUDGES
from workbook.grading.isolation import system_call
from workbook.notebooks import exercises
from workbook.notebooks.dependencies import module_closure, module_path

#: SymPy imports these inside its functions, when `solve`, `simplify`, `lambdify`, a derivative by a
#: matrix or a set first needs them.
SYMPY = (
    "sympy",
    "sympy.assumptions.wrapper",
    "sympy.codegen.ast",
    "sympy.combinatorics",
    "sympy.integrals.heurisch",
    "sympy.integrals.manualintegrate",
    "sympy.integrals.risch",
    "sympy.matrices.expressions.applyfunc",
    "sympy.physics.units",
    "sympy.sets.handlers.functions",
    "sympy.sets.handlers.issubset",
    "sympy.sets.setexpr",
    "sympy.tensor.array.array_derivatives",
    "sympy.tensor.tensor",
)
#: For every notebook: the shell that runs its cells, and what writes and reads its answers.
ALWAYS = (*SYMPY, "numpy", "IPython.core.interactiveshell", "workbook.checks.contract.sympy_codec")
#: What notebooks and checks may use beside that.
LIBRARIES = (
    "casadi",
    "matplotlib.pyplot",
    "scipy.integrate",
    "scipy.interpolate",
    "scipy.linalg",
    "scipy.optimize",
    "z3",
)
#: Packages and modules of trajlib from which notebooks may take functions.
THEMES = tuple(
    f"trajlib.{theme}"
    for theme in (
        "estimation",
        "feedback",
        "infosets",
        "invariant",
        "pontryagin",
        "reconstruction",
        "reference_curves",
        "solvability",
        "stability",
        "structure",
    )
)


def needed(problems, sources):
    """{"notebooks": the modules, by name, that notebooks for these problems use, "checks": those
    that judging them uses besides}: each costs every run its time, and each fork of its process.

    `sources` are the notebooks' cells. They only choose among `LIBRARIES` and the public names of
    `THEMES`, so nothing of theirs goes any further.
    """
    data, checks = (
        [source for problem in problems for _, source in exercises.find(problem).code(role)]
        for role in ("data", "check")
    )
    functions = [f"import {module}" for module in _functions(sources)]
    notebooks = _with_libraries(["import workbook.notebooks.cells", *data, *functions], sources)
    return {
        "notebooks": [*ALWAYS, *notebooks],
        "checks": [
            name for name in _with_libraries([JUDGES, *data, *checks]) if name not in notebooks
        ],
    }


def _with_libraries(cells, sources=()):
    """Our modules under some cells, and the libraries that these use, or that `sources` do."""
    ours = module_closure("\n".join(cells))
    imports = [
        line
        for module in ours
        for line in _IMPORT.findall(module_path(module).read_text(encoding="utf-8"))
    ]
    return [
        name
        for name in LIBRARIES
        if _uses(name, sources) or (_computes(name) and _uses(name, imports))
    ] + [*ours]


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
    # a theme of a single module is the home of all its names
    return sorted(
        {
            home_of(package, name) or package
            for package in THEMES
            if package.split(".")[1] in words
            for name in dir(importlib.import_module(package))
            if name in words
        }
    )


def _computes(name):
    """Whether checks use it: the pictures that their modules can also draw they do not."""
    return not name.startswith("matplotlib")


def preload(*modules, packages=()):
    """Import the modules and all public names of packages ("workbook.checks", "trajlib.stability",
    ...)."""
    with what_stays():
        for name in modules:
            if name.startswith("scipy."):
                _at_first_use(*NAMED_BY_SCIPY)
            with suppress(ModuleNotFoundError):  # z3 is not to be had everywhere
                importlib.import_module(name)
        for package in packages:
            home = importlib.import_module(package)
            for name in dir(home):  # lazy names too
                getattr(home, name)


@contextmanager
def what_stays():
    """What is made within no longer concerns the collector of garbage, which would write to every
    object, and so copy the memory that a child shares with this process. While it is made, hardly
    any of it is garbage: to look for that takes a fifth of the time of imports, and half of that of
    parsing pages."""
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        gc.enable()
        gc.set_threshold(CONTAINERS)


def draw_once(form):
    """The first picture of a process loads its fonts, the grammar of formulas, and what writes its
    form."""
    from matplotlib.figure import Figure

    figure = Figure()
    figure.subplots().set_title("$x$")
    figure.savefig(io.BytesIO(), format=form, bbox_inches="tight")


#: What SciPy's parts name when they are imported, of which hardly anybody ever uses anything: a
#: third of their time.
NAMED_BY_SCIPY = ("numpy.f2py", "numpy.testing", "scipy.spatial")


def _at_first_use(*names):
    """Let modules be loaded when something of them is asked for."""
    for name in names:
        if name not in sys.modules:
            spec = importlib.util.find_spec(name)
            spec.loader = importlib.util.LazyLoader(spec.loader)
            sys.modules[name] = module = importlib.util.module_from_spec(spec)
            package, _, part = name.rpartition(".")
            setattr(sys.modules[package], part, module)
            spec.loader.exec_module(module)


#: After how many new containers the collector looks for garbage. Formulas are many small ones that
#: live shortly and are no garbage when they end: Python's 700 cost the proofs of problems about a
#: twentieth of their time.
CONTAINERS = 100_000
#: Bytes of a huge page, and the advice to make such of small ones (Linux 6.1).
HUGE_PAGE, MADV_COLLAPSE = 2**21, 25


def into_huge_pages():
    """Hold what is loaded in huge pages, where the kernel will: a fork copies the table of all
    pages, and where they are huge it has an entry for every five hundred. Where a child writes, it
    gets a small page of its own as before.

    That takes as long as some dozens of forks: for a process from which one is forked for each
    notebook.
    """
    with suppress(OSError), open("/proc/self/maps") as file:  # not Linux
        for line in file.readlines():
            place, rights, _, _, inode, *_ = line.split()
            begin, end = (int(each, 16) for each in place.split("-"))
            begin, end = -(-begin // HUGE_PAGE) * HUGE_PAGE, end // HUGE_PAGE * HUGE_PAGE
            if rights == "rw-p" and inode == "0" and begin < end:
                with suppress(OSError):
                    system_call(
                        "madvise",
                        ctypes.c_void_p(begin),
                        ctypes.c_size_t(end - begin),
                        MADV_COLLAPSE,
                    )
