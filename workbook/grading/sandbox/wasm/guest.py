"""Runs inside WebAssembly: a notebook's cells, by the workbook's own `run_cells`.

The host calls `boot` once; the memory afterwards is the image from which each notebook starts, with
`run`. Messages to the host begin with one of the letters below. They are as trustworthy as the
notebook: the answers are judged outside, and the others only make the notebook wait or run again.
"""

import ast
import importlib.machinery
import io
import json
import logging
import re
import sys
import time
import types

#: Messages: the cell that begins; the answers; a module that is not here; something else missing.
CELL, ANSWERS, MODULE, MISSING = b"C", b"A", b"M", b"L"
#: Line magics that change nothing but what is shown, or which libraries there are.
WITHOUT_EFFECT = ("autoreload", "conda", "config", "load_ext", "matplotlib", "pip", "precision")
#: Cell magics around a cell that runs as it would without them.
AROUND = ("%%capture", "%%time")
#: Modules that have fewer functions here than elsewhere.
OF_THE_SYSTEM = ("_socket", "os", "posix", "select", "signal", "socket", "time")
#: What the first cell of a notebook imports to see that it is there; hardly any notebook uses z3.
SETUP_IMPORT = "import workbook.checks, z3"
#: Packages of Jupyter whose names show something and have no values.
ONLY_SHOWING = ("IPython",)


def boot():
    """Import what most notebooks need, use it once, and prepare for the rest."""
    logging.getLogger("matplotlib.font_manager").disabled = True  # it cannot keep its list
    import matplotlib.pyplot as plt
    import scipy.integrate
    import scipy.linalg
    import scipy.optimize  # noqa: F401

    from workbook.checks.contract.encoding import encode
    from workbook.checks.contract.reporting import collecting
    from workbook.notebooks import cells

    data = "import sympy as sp; from workbook import checks; k, s = sp.symbols('k s', real=True)"
    check = "checks.report(a=checks.stability_region(a, s**2 + k*s + k - 1, [k]))"
    for answer in ("a = k > 1", "a = k > 0"):
        namespace = {}
        with collecting():
            exec("\n".join([data, answer, check]), namespace)
        encode(namespace["a"])
    plt.close(plt.figure())
    vars(cells)["open"] = lambda *_, **__: Discarding()  # there is no /dev/null
    sys.meta_path.append(MissingModules())  # at last, so that the libraries above found no IPython


def run(request):
    """Run a notebook; its answers leave as a message to the host.

    Parameters
    ----------
    request : str
        JSON of an object with "sources", "names" and "before" as of `run_cells`; "timed": numbers
        of cells, from 1, that are stopped after "seconds"; "left out": numbers of cells that are
        not run, but count as stopped.
    """
    from workbook.notebooks import cells  # loaded by `boot`

    request = json.loads(request)
    cells._prepared.append(Shell(request, cells.CellTimeout))
    result = cells.run_cells(request["sources"], request["names"], before=request["before"])
    tell(ANSWERS + json.dumps(result).encode())


def tell(message):
    """Send bytes to the host by the only function that this guest gets from it."""
    import _host  # the guest has it

    _host.call(message)


class Shell:
    """As much of IPython's shell as `run_cells` needs."""

    def __init__(self, request, timeout):
        main = types.ModuleType("__main__")
        sys.modules["__main__"] = main
        self.user_ns = main.__dict__
        self.user_ns.update(display=lambda *_, **__: None, get_ipython=lambda: None)
        self._request, self._timeout, self._count = request, timeout, 0
        self._numbers = {source: k for k, source in enumerate(request["sources"], start=1)}

    def run_cell(self, source, store_history=False):
        """Run a cell; return an object with its errors and its value, as IPython does."""
        number = self._numbers.get(source, 0)  # the last of several that are the same
        self._count += 1
        outcome = types.SimpleNamespace(error_before_exec=None, error_in_exec=None, result=None)
        if number in self._request["left out"]:
            outcome.error_in_exec = self._timeout()
            return outcome
        is_timed = number in self._request["timed"]
        tell(CELL + (f"{number} timed" if is_timed else f"{number}").encode())
        if SETUP_IMPORT in source:
            source = source.replace(SETUP_IMPORT, SETUP_IMPORT.partition(",")[0])
            self.user_ns["z3"] = Absent("z3")
        name = f"<cell {self._count}>"
        try:
            body = parsed(source, name).body
        except BaseException as error:
            outcome.error_before_exec = error
            return outcome
        last = body.pop() if body and isinstance(body[-1], ast.Expr) else None
        try:
            if is_timed:
                self._stop_after(self._request["seconds"])
            exec(compile(ast.Module(body, []), name, "exec"), self.user_ns)
            if last is not None:
                value = eval(compile(ast.Expression(last.value), name, "eval"), self.user_ns)
                if value is not None:
                    self.user_ns["_"] = outcome.result = value
        except BaseException as error:
            outcome.error_in_exec = error
            if of_this_system(error):
                tell(MISSING + type(error).__name__.encode())
        finally:
            sys.settrace(None)
        return outcome

    def _stop_after(self, seconds):
        """Let the lines of code that run from now on raise the timeout when the time is over."""
        end = time.monotonic() + seconds

        def trace(*_):
            if time.monotonic() > end:
                raise self._timeout
            return trace

        sys.settrace(trace)


def parsed(source, name):
    """Return the syntax tree of a cell, without its magics."""
    from workbook.checks.contract.typed_code import read_typed  # loaded by `boot`

    try:
        return ast.parse(source, name)
    except SyntaxError:
        return ast.parse(read_typed(without_magics(source)), name)


def without_magics(source):
    """Return a cell without what only IPython understands; tell the host of what has an effect.

    >>> without_magics("%matplotlib inline\\n%time x = 1")
    'pass\\nx = 1'
    """
    first, _, rest = source.lstrip().partition("\n")
    if first.startswith("%%"):
        if first.split()[0] not in AROUND:
            tell(MISSING + first.split()[0].encode())
        return rest
    return "\n".join(map(_line_without_magic, source.split("\n")))


def _line_without_magic(line):
    indent, code = re.fullmatch(r"([ \t]*)(.*)", line, re.DOTALL).groups()
    if timed := re.match(r"%time\b[ \t]*(.*)", code):
        return indent + timed[1]
    if magic := re.match(r"%(\w+)|!(\w*)|\w+ *= *[%!]", code):
        if not set(WITHOUT_EFFECT) & set(magic.groups()):
            tell(MISSING + magic[0].encode())
        return indent + "pass"
    return indent + "pass" if code.startswith("?") or code.rstrip().endswith("?") else line


def of_this_system(error):
    """Return whether an error may come from what this system does not have.

    There are no folders to write to, no threads, no processes and no network.
    """
    if isinstance(error, AttributeError):
        return getattr(error.obj, "__name__", "") in OF_THE_SYSTEM
    if isinstance(error, RuntimeError):
        return "can't start new thread" in str(error)
    return isinstance(error, OSError) and not isinstance(error, FileNotFoundError)


class MissingModules:
    """Asked last: tells the host which modules a notebook, or the library for it, did not find."""

    def find_spec(self, name, path=None, target=None):
        """Return a stand-in for a package that only shows; None for other modules."""
        package = name.partition(".")[0]
        if package in ONLY_SHOWING:
            return importlib.machinery.ModuleSpec(name, self, is_package=True)
        frame = sys._getframe(1)
        while frame is not None and "importlib" in frame.f_code.co_filename:
            frame = frame.f_back
        by = frame.f_code.co_filename if frame is not None else ""
        if by.startswith("<cell ") or "/trajlib/" in by:
            tell(MODULE + package.encode())
        return None

    def create_module(self, spec):
        """Return a module all of whose names do nothing."""
        return OnlyShowing(spec.name)

    def exec_module(self, module):
        """Do nothing."""


class Absent(types.ModuleType):
    """A module that is not here, which matters only to a notebook that uses it."""

    def __getattr__(self, name):
        tell(MODULE + self.__name__.encode())
        raise ModuleNotFoundError(f"No module named {self.__name__!r}", name=self.__name__)


class OnlyShowing(types.ModuleType):
    """A module whose functions and classes do nothing."""

    __path__: list[str] = []

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *_, **__: None


class Discarding(io.StringIO):
    """Keeps nothing of what is written."""

    def write(self, text):
        """Return how much was written."""
        return len(text)
