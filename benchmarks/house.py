"""Print how large the house is and how long its paths are, beside the figures of known libraries.

    python benchmarks/house.py            # both parts, in about half a minute
    python benchmarks/house.py --size     # the lines only

Lines of code are those with a token of code: no comments, docstrings and blank lines. A path is what one action calls
of `trajlib` and `workbook`, in this process and in those that it forks: calls, different functions, files. Everything
is imported, and the action done once with other numbers, before it is counted. Comprehensions and generator
expressions are no functions of their own, so that all versions of Python count the same.
"""

import ast
import contextlib
import io
import json
import os
import sys
import tempfile
import tokenize
from collections import Counter
from pathlib import Path

from workbook.notebooks import execution

ROOT = Path(__file__).resolve().parents[1]
OWN = ("trajlib", "workbook")
#: Lines of code, counted once when the bars were set.
OTHERS = "python-control 13,400; diffrax 10,500; OptimalControl.jl with its packages 25,800; nbgrader 12,400"
NO_CODE = {
    *(tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT),
    *(tokenize.ENCODING, tokenize.ENDMARKER),
}
DOCUMENTED = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)


def lines(path):
    """Return (lines of code, lines of docstrings) of a file of Python."""
    text = path.read_text(encoding="utf-8")
    explained = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, DOCUMENTED) and ast.get_docstring(node, clean=False) is not None:
            explained |= {*range(node.body[0].lineno, node.body[0].end_lineno + 1)}
    code = {
        number
        for token in tokenize.generate_tokens(io.StringIO(text).readline)
        if token.type not in NO_CODE
        for number in range(token.start[0], token.end[0] + 1)
    }
    return len(code - explained), len(explained)


def tests_in(path):
    """Return how many functions of tests a file has."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return sum(
        isinstance(n, ast.FunctionDef) and n.name.startswith("test_") for n in ast.walk(tree)
    )


def print_sizes():
    print(f"{'':28}{'files':>8}{'code':>9}{'docstrings':>12}{'tests':>8}")
    parts = (
        *OWN,
        "workbook/checks",
        "workbook/grading",
        "tests",
        "tests/checks/cases",
        "benchmarks",
    )
    for part in parts:
        files = sorted((ROOT / part).rglob("*.py"))
        code, explained = map(sum, zip(*map(lines, files)))
        tests = sum(map(tests_in, files)) or ""
        print(f"{part:28}{len(files):8}{code:9,}{explained:12,}{tests:>8}")
    print(f"lines of code of others: {OTHERS}")


class Calls:
    """Counts calls of functions in the packages `inside` of a folder, by (file, function)."""

    def __init__(self, root, inside):
        self.counted = Counter()
        self._inside = tuple(f"{Path(root) / name}{os.sep}" for name in inside)

    def _profile(self, frame, event, _):
        code = frame.f_code
        if (
            event == "call"
            and code.co_filename.startswith(self._inside)
            and not code.co_name.startswith("<")
        ):
            self.counted[code.co_filename, code.co_qualname, code.co_firstlineno] += 1

    @contextlib.contextmanager
    def counting(self):
        """Count in this process and in the children of `workbook.notebooks.execution`."""
        serve = execution._serve
        with tempfile.TemporaryDirectory() as folder:

            def serve_and_write(sender, function, args):
                def counted(*args):
                    self.counted.clear()  # of the parent
                    result = function(*args)
                    path = Path(folder, f"{os.getpid()}.json")
                    path.write_text(json.dumps([*self.counted.items()]))
                    return result

                serve(sender, counted, args)

            execution._serve = serve_and_write
            sys.setprofile(self._profile)
            try:
                yield
            finally:
                sys.setprofile(None)
                execution._serve = serve
            for path in Path(folder).iterdir():
                self.counted.update({tuple(key): n for key, n in json.loads(path.read_text())})

    def __str__(self):
        files = {file for file, *_ in self.counted}
        return f"{self.counted.total():7,}{len(self.counted):11}{len(files):8}"


def gain():
    """Design a floating gain for 2 states and 2 controls."""
    from trajlib.feedback import lqr

    return lambda number: lqr(
        [[0.0, 1.0], [-number, -0.5]],
        [[1.0, 0.0], [0.0, 1.0]],
        Q=[[1, 0], [0, 1]],
        R=[[1, 0], [0, 1]],
    )


def verdict():
    """Judge a wrong answer in a check cell's place: a region of stability of problem 1.15."""
    import sympy as sp

    from workbook import checks

    k1, k2, s = sp.symbols("k1 k2 s", real=True)
    polynomial = s**3 + k1 * s**2 + k2 * s + 1
    return lambda number: checks.stability_region(sp.And(k1 > 0, k2 > number), polynomial, [k1, k2])


def extremal():
    """Find the fastest transfer of a cart."""
    import sympy as sp

    from trajlib.pontryagin import Problem

    x1, x2, u = sp.symbols("x1 x2 u")
    return lambda number: Problem(
        {x1: x2, x2: u}, {u: (-1, 1)}, {x1: number, x2: 0}, terminal=[x1, x2]
    ).solve()


def checked_notebook():
    """Run `workbook check` on a notebook with right answers."""
    from workbook.authoring import read_master
    from workbook.cli import app

    def check(number):
        master = read_master(ROOT / "solutions" / f"ch{number}" / "p03.md")
        notebook = json.loads(master.exercise.read_text(encoding="utf-8"))
        roles = [cell.get("metadata", {}).get("tags", []) for cell in notebook["cells"]]
        first_check = roles.index(["check"])
        answers = {"cell_type": "code", "source": "\n".join(master.code("answer")), "metadata": {}}
        notebook["cells"].insert(first_check, answers)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "p03.ipynb")
            path.write_text(json.dumps(notebook), encoding="utf-8")
            with contextlib.redirect_stdout(io.StringIO()) as out:
                app(["check", str(path), "--json"], standalone_mode=False)
            assert out.getvalue().count('"right"') == len(master.answers), out.getvalue()

    return check


def student_notebook():
    """Read a master and make the student's notebook of it."""
    from workbook.authoring import Links, read_master
    from workbook.authoring.student_notebook import baseurl, student_notebook

    links = Links(ROOT, baseurl(ROOT))
    return lambda number: student_notebook(
        read_master(ROOT / "solutions" / f"ch{number}" / "p03.md"), links
    )


#: What is done: the action, with which numbers first and then, and what others need for the same.
ACTIONS = {
    "floating lqr, 2 x 2": (gain, 3, 2, "python-control: 11 calls of 6 functions"),
    "a judged wrong answer": (verdict, 1, 0, ""),
    "Problem.solve": (extremal, 2, 1, ""),
    "workbook check": (checked_notebook, 2, 1, ""),
    "a student's notebook": (student_notebook, 2, 1, ""),
}


def print_paths():
    print(f"\n{'':28}{'calls':>7}{'functions':>11}{'files':>8}")
    for name, (prepare, first, then, others) in ACTIONS.items():
        action = prepare()
        action(first)
        calls = Calls(ROOT, OWN)
        with calls.counting():
            action(then)
        print(f"{name:28}{calls}   {others}")


if __name__ == "__main__":
    print_sizes()
    if "--size" not in sys.argv[1:]:
        print_paths()
