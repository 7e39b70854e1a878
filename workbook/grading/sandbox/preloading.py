"""Preloading: import modules once, in the process that forks, rather than in each child."""

import ctypes
import gc
import importlib.util
import io
import re
import sys
from contextlib import contextmanager, suppress

from trajlib._lazy import home_of
from workbook.notebooks import exercises
from workbook.notebooks.dependencies import module_closure, module_path

#: The modules that run a notebook's cells, and read and judge what they hand over.
JUDGING_MODULES = "import workbook.notebooks.cells, workbook.grading.pool.judging"
#: SymPy imports these inside its functions, when `solve`, `simplify`, `lambdify`, a derivative with
#: respect to a matrix, or a set first needs them.
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
#: For every notebook: also the shell that runs its cells, and the codec of its answers.
ALWAYS = (*SYMPY, "numpy", "IPython.core.interactiveshell", "workbook.checks.contract.sympy_codec")
#: Libraries that notebooks and checks may use in addition.
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


def modules_for(problems, sources):
    """Return the names of modules that notebooks for these problems, and judging them, use.

    Each module costs every run its time of import, and every fork a little. The notebooks only
    choose among `LIBRARIES` and the public names of `THEMES`: nothing else of them goes any
    further.

    Parameters
    ----------
    problems : collection of str
        Their numbers.
    sources : sequence of str
        The cells of the notebooks.

    Returns
    -------
    dict
        "notebooks": names of modules; "checks": names of those that only judging uses.
    """
    data, checks = (
        [source for problem in problems for _, source in exercises.find(problem).code(role)]
        for role in ("data", "check")
    )
    functions = [f"import {module}" for module in _modules_of_names(sources)]
    notebooks = _with_libraries(["import workbook.notebooks.cells", *data, *functions], sources)
    return {
        "notebooks": [*ALWAYS, *notebooks],
        "checks": [
            name
            for name in _with_libraries([JUDGING_MODULES, *data, *checks])
            if name not in notebooks
        ],
    }


def _with_libraries(cells, sources=()):
    """Return our modules that cells import, and the libraries that they or `sources` use."""
    modules = module_closure("\n".join(cells))
    imports = [
        line
        for module in modules
        for line in _IMPORT.findall(module_path(module).read_text(encoding="utf-8"))
    ]
    return [
        name
        for name in LIBRARIES
        if _uses(name, sources) or (_is_for_computing(name) and _uses(name, imports))
    ] + [*modules]


#: A line that imports, also inside a function.
_IMPORT = re.compile(r"^ *(?:import|from) .*", re.MULTILINE)


def _uses(name, sources):
    """Return whether a source names a library; of SciPy, a part after the name in one line."""
    package, _, part = name.partition(".")
    named, part_named = re.compile(rf"\b{package}\b"), re.compile(rf"\b{part}\b")
    if package != "scipy":  # whose parts are loaded one by one
        return any(named.search(source) for source in sources)
    # Two searches: one pattern for both would begin again at each of a million `scipy`.
    return any(
        (first := named.search(line)) and part_named.search(line, first.end())
        for source in sources
        if package in source
        for line in source.split("\n")
    )


def _modules_of_names(sources):
    """Return the modules of trajlib that define the public names which cells use."""
    words = {word for source in sources for word in re.findall(r"\w+", source)}
    return sorted(
        {
            home_of(package, name)
            for package in THEMES
            if package.split(".")[1] in words
            for name in dir(importlib.import_module(package))
            if name in words
        }
    )


def _is_for_computing(name):
    """Return whether checks use a library: they do not draw the pictures of their modules."""
    return not name.startswith("matplotlib")


def preload(*modules, packages=()):
    """Import modules, and all public names of packages such as "workbook.checks"."""
    with freeze_new_objects():
        for name in modules:
            if name.startswith("scipy."):
                _import_lazily(*NAMED_BY_SCIPY)
            with suppress(ModuleNotFoundError):  # z3 is not available everywhere
                importlib.import_module(name)
        for package in packages:
            home = importlib.import_module(package)
            for name in dir(home):  # lazy names too
                getattr(home, name)


@contextmanager
def freeze_new_objects():
    """Freeze the objects made in this block, so that garbage collection no longer visits them.

    A collection writes to every object, and so copies memory that a child shares with its parent.
    Within the block none runs: hardly any of these objects is garbage, and looking for it takes a
    fifth of the time of imports, and half of the time of parsing pages.
    """
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        gc.enable()
        gc.set_threshold(GC_THRESHOLD)


def warm_up_matplotlib(file_format):
    """Draw a picture, which loads fonts, the grammar of formulas, and the writer of the format."""
    from matplotlib.figure import Figure

    figure = Figure()
    figure.subplots().set_title("$x$")
    figure.savefig(io.BytesIO(), format=file_format, bbox_inches="tight")


#: Modules that SciPy's parts import but hardly ever use: a third of the time of their import.
NAMED_BY_SCIPY = ("numpy.f2py", "numpy.testing", "scipy.spatial")


def _import_lazily(*names):
    """Let modules load at the first access to one of their attributes."""
    for name in names:
        if name not in sys.modules:
            spec = importlib.util.find_spec(name)
            spec.loader = importlib.util.LazyLoader(spec.loader)
            sys.modules[name] = module = importlib.util.module_from_spec(spec)
            package, _, part = name.rpartition(".")
            setattr(sys.modules[package], part, module)
            spec.loader.exec_module(module)


#: Number of new container objects that starts a garbage collection. Formulas are many small ones
#: that end soon, by reference counting: Python's 700 cost the proofs of problems about a twentieth
#: of their time.
GC_THRESHOLD = 100_000
#: Bytes of a huge page, and the advice to make small pages into such (Linux 6.1).
HUGE_PAGE, MADV_COLLAPSE = 2**21, 25


def collapse_into_huge_pages():
    """Move this process's memory into huge pages, where the kernel allows it.

    A fork copies the page table, which has one entry for a huge page and five hundred for the same
    memory in small ones. Where a child writes, it still gets a small page of its own. This takes as
    long as some dozens of forks, so it is for a process that forks for each notebook.
    """
    # only for Linux, as the rest of this module is not
    from workbook.grading.sandbox.system_calls import system_call

    with suppress(OSError), open("/proc/self/maps", encoding="utf-8") as file:  # not Linux
        for line in file.readlines():
            addresses, rights, _, _, inode, *_ = line.split()
            begin, end = (int(address, 16) for address in addresses.split("-"))
            begin, end = -(-begin // HUGE_PAGE) * HUGE_PAGE, end // HUGE_PAGE * HUGE_PAGE
            if rights == "rw-p" and inode == "0" and begin < end:
                with suppress(OSError):
                    system_call(
                        "madvise",
                        ctypes.c_void_p(begin),
                        ctypes.c_size_t(end - begin),
                        MADV_COLLAPSE,
                    )
