"""Mutation run: change one token of the library, run the nearest tests, list what none notices.

A mutant is a copy of trajlib in which one token of a function is changed: a comparison, an
arithmetic operator, a number or truth value, a sign, `not`, `and` or `or`, a returned value, or
the order of two arguments. Its nearest tests are those that ran the changed line in a first run
without changes, the quickest first, up to `--budget` seconds; tests marked slow are left out.

How to read it. Killed: a test failed, or the processor time ran out, as in a loop without end.
Survived: all nearest tests passed. Either the change is equivalent (a bound that no number meets, a
better starting value, a tolerance within its leeway), or an assertion is missing: it belongs into
the nearest test file. Not run: no nearest test runs the line. The share of killed mutants
compares two runs of one sample only; the list of survivors is the result.

    .venv/bin/python benchmarks/mutations.py --sample 200 --seed 1
    .venv/bin/python benchmarks/mutations.py --only feedback --contexts _build/feedback.json

With `--only` the tests nearest to that folder are run. With `--contexts` the first run, some minutes
a folder, is noted in a file and not repeated; delete the file when tests or library change.
Everything happens in a temporary copy of the tree.
"""

import argparse
import ast
import copy
import json
import os
import random
import resource
import shutil
import signal
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
#: The folders of trajlib, and beside their doctests the test files nearest to each.
NEAREST = {
    "feedback": ["test_feedback*", "test_riccati_verdicts*", "test_state_space*"],
    "estimation": ["test_estimation*", "test_riccati*", "test_state_space*"],
    "structure": ["test_structure*", "test_state_space*"],
    "pontryagin/verification": [
        "test_pontryagin_certificate*",
        "test_pontryagin_proof*",
        "test_pontryagin_verdicts*",
    ],
}
#: Imported once, before the processes of the mutants are forked.
LIBRARIES = (
    *("casadi", "control", "flint", "hypothesis", "matplotlib.pyplot", "pandas", "pytest"),
    *("scipy.integrate", "scipy.interpolate", "scipy.linalg", "scipy.optimize", "scipy.signal"),
    *("_pytest.doctest", "xdist.plugin"),
)
#: Arguments of pytest; what is imported before is not rewritten, which it would warn of.
PYTEST = "-q -n 0 --noconftest -p no:cacheprovider -W ignore::pytest.PytestAssertRewriteWarning"
#: Calls of a function in a test whose lines are noted; bytes that a mutant may ask for.
CALLS, MEMORY = 50, 2**33
OPERATORS = {
    ast.Lt: (ast.LtE, ast.GtE),
    ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.LtE),
    ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
    ast.Add: (ast.Sub,),
    ast.Sub: (ast.Add,),
    ast.Mult: (ast.Div,),
    ast.Div: (ast.Mult,),
    ast.FloorDiv: (ast.Mult,),
    ast.Mod: (ast.Mult,),
    ast.Pow: (ast.Mult,),
    ast.And: (ast.Or,),
    ast.Or: (ast.And,),
}


def changes(node):
    """Yield functions that change one token of a node in place."""
    match node:
        case ast.Compare():
            for k, operator in enumerate(node.ops):
                for other in OPERATORS[type(operator)]:
                    yield lambda one, k=k, other=other: one.ops.__setitem__(k, other())
        case ast.BinOp(op=ast.MatMult()):
            yield lambda one: one.__dict__.update(left=one.right, right=one.left)
        case ast.BinOp() | ast.BoolOp() | ast.AugAssign() if type(node.op) in OPERATORS:
            for other in OPERATORS[type(node.op)]:
                yield lambda one, other=other: setattr(one, "op", other())
        case ast.UnaryOp(op=ast.USub()):
            yield lambda one: setattr(one, "op", ast.UAdd())
        case ast.UnaryOp(op=ast.Not()):  # the truth value without it
            yield lambda one: setattr(one, "operand", ast.UnaryOp(ast.Not(), one.operand))
        case ast.Constant(value=bool()):
            yield lambda one: setattr(one, "value", not one.value)
        case ast.Constant(value=int()):
            yield lambda one: setattr(one, "value", one.value + 1)
        case ast.Constant(value=float()):
            yield lambda one: setattr(one, "value", 2 * one.value or 1.0)
        case ast.Return(value=ast.Tuple(elts=[_, _, *_])):
            yield lambda one: _swap(one.value.elts)
        case ast.Return(value=ast.expr()) if ast.unparse(node.value) != "None":
            yield lambda one: setattr(one, "value", ast.Constant(None))
        case ast.Call(func=ast.Name(id="isinstance" | "max" | "min")):
            pass
        case ast.Call(args=[first, second, *_]) if ast.dump(first) != ast.dump(second):
            if not isinstance(first, ast.Starred) and not isinstance(second, ast.Starred):
                yield lambda one: _swap(one.args)


def _swap(nodes):
    nodes[0], nodes[1] = nodes[1], nodes[0]


def sites(tree):
    """Yield (index of a node in `ast.walk`, index of a change, lines of its statement)."""
    statement, inside = {}, set()
    for node in ast.walk(tree):  # parents before children
        if isinstance(node, ast.stmt):
            body = getattr(node, "body", None)
            last = node.end_lineno if not body or _is_function(node) else body[0].lineno - 1
            statement[node] = node.lineno, max(last, node.lineno)
        if _is_function(node):
            inside.add(node)
        for child in ast.iter_child_nodes(node):
            # texts of errors, decorators and types are no rules
            skipped = isinstance(node, ast.Raise | ast.arg) or (
                _is_function(node) and (child in node.decorator_list or child is node.returns)
            )
            if node in inside and not skipped:
                inside.add(child)
            statement.setdefault(child, statement.get(node))
    for index, node in enumerate(ast.walk(tree)):
        if node in inside:
            for number, _ in enumerate(changes(node)):
                yield index, number, statement[node]


def _is_function(node):
    return isinstance(node, ast.FunctionDef)


def mutant(source, index, number):
    """Return the changed source, the line, and the change as it is read."""
    tree = ast.parse(source)
    node = list(ast.walk(tree))[index]
    before = copy.deepcopy(node)
    list(changes(node))[number](node)
    texts = (" ".join(ast.unparse(one).split()) for one in (before, node))
    return ast.unparse(tree), node.lineno, "  ->  ".join(texts)


class Contexts:
    """Note which tests run which lines of the folders, and how long they take (a pytest plugin).

    Of a function the first `CALLS` calls in a test count: tracing all takes many times as long.
    """

    def __init__(self, root):
        self.prefixes = tuple(f"{root}/trajlib/{folder}/" for folder in NEAREST)
        self.start, self.lines, self.calls, self.tests = len(str(root)) + 1, set(), Counter(), []

    def _line(self, frame, event, argument):
        self.lines.add((frame.f_code.co_filename, frame.f_lineno))
        return self._line

    def _call(self, frame, event, argument):
        if frame.f_code.co_filename.startswith(self.prefixes):
            self.calls[frame.f_code] += 1
            if self.calls[frame.f_code] <= CALLS:
                return self._line
        return None

    def pytest_runtest_call(self, item):
        self.lines.clear()
        self.calls.clear()
        sys.settrace(self._call)

    def pytest_runtest_logreport(self, report):
        if report.when == "call":
            sys.settrace(None)
            if report.passed and self.lines:
                lines = [f"{file[self.start :]}:{line}" for file, line in self.lines]
                self.tests.append((report.duration, report.nodeid, lines))


def in_child(function, limit=resource.RLIM_INFINITY):
    """Return the exit code of a function in a process of its own, or the signal, negative."""
    child = os.fork()
    if child == 0:
        resource.setrlimit(resource.RLIMIT_CPU, (limit, resource.RLIM_INFINITY))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        signal.signal(signal.SIGXCPU, signal.SIG_DFL)
        try:
            with open(os.devnull, "w") as nowhere:
                os.dup2(nowhere.fileno(), 1)
                os.dup2(nowhere.fileno(), 2)
                os._exit(function())
        finally:  # never into what the parent would clear away
            os._exit(1)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def pytest_run(*arguments, plugins=()):
    import pytest

    return int(pytest.main([*PYTEST.split(), *arguments], plugins=list(plugins)))


def note_contexts(root, folders, file):
    plugin = Contexts(root)
    paths = [f"trajlib/{folder}" for folder in folders]
    for pattern in (pattern for folder in folders for pattern in NEAREST[folder]):
        paths += sorted(map(str, Path("tests/library").glob(f"{pattern}.py")))
    pytest_run("-m", "not slow", *dict.fromkeys(paths), plugins=[plugin])
    file.write_text(json.dumps(sorted(plugin.tests)))
    return 0


def copied_tree():
    root = Path(tempfile.mkdtemp(prefix="mutations-"))
    for name in ("trajlib", "tests/library", "workbook"):
        shutil.copytree(ROOT / name, root / name, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "pyproject.toml", root)
    return root


def nearest(tests, name, lines, budget):
    """Return the quickest tests that run one of the lines, and their seconds."""
    wanted, found, total = {f"{name}:{k}" for k in range(lines[0], lines[1] + 1)}, [], 0.0
    for seconds, test, ran in tests:
        if not wanted.isdisjoint(ran) and total + seconds <= budget:
            found.append(test)
            total += seconds
    return found, total


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--sample", type=int, default=100, metavar="N")
    parser.add_argument("--seed", type=int, default=0, metavar="S")
    parser.add_argument("--only", choices=NEAREST, metavar="FOLDER")
    parser.add_argument("--budget", type=float, default=20, metavar="SECONDS")
    parser.add_argument("--contexts", type=lambda text: Path(text).resolve(), metavar="FILE")
    options = parser.parse_args()
    root = copied_tree()
    try:
        run(root, options)
    finally:
        shutil.rmtree(root)


def run(root, options):
    os.chdir(root)
    os.environ |= {"PYTHONPATH": str(root), "MPLBACKEND": "Agg", "OPENBLAS_NUM_THREADS": "1"}
    sys.path[:0] = [str(root), str(root / "tests" / "library")]
    for library in LIBRARIES:
        __import__(library)
    assert not [name for name in sys.modules if name.startswith("trajlib")]
    contexts = options.contexts or root / "contexts.json"
    folders = [options.only] if options.only else list(NEAREST)
    if not contexts.exists() and in_child(lambda: note_contexts(root, folders, contexts)):
        sys.exit("the first run broke off")
    tests = [(seconds, test, set(ran)) for seconds, test, ran in json.loads(contexts.read_text())]

    sources = {
        str(path): path.read_text()
        for folder in folders
        for path in sorted(Path("trajlib", folder).glob("*.py"))
    }
    every = [(name, *site) for name, source in sources.items() for site in sites(ast.parse(source))]
    chosen = random.Random(options.seed).sample(every, min(options.sample, len(every)))
    print(f"{len(chosen)} of {len(every)} mutants, {len(tests)} tests", flush=True)
    sys.dont_write_bytecode = True  # two mutants of one second would share theirs
    verdicts, began = Counter(), time.monotonic()
    try:
        for name, *site in chosen:
            verdict, text = judged(name, sources[name], *site, tests, options.budget)
            verdicts[verdict] += 1
            if verdict != "killed":
                print(f"{verdict:9} {text}", flush=True)
    except KeyboardInterrupt:
        print("interrupted", end=": ")
    print(*(f"{count} {verdict}" for verdict, count in verdicts.items()), sep=", ", end="")
    print(f"; {time.monotonic() - began:.0f} seconds")


def judged(name, source, index, number, lines, tests, budget):
    """Return what became of a mutant, and where and what the change is."""
    changed, line, change = mutant(source, index, number)
    near, seconds = nearest(tests, name, lines, budget)
    verdict = "not run"
    if near:
        file = Path(name)
        file.write_text(changed)
        failed = in_child(lambda: pytest_run("-x", *near), int(10 + 4 * seconds))
        file.write_text(source)
        verdict = "killed" if failed else "survived"
    return verdict, f"{name}:{line}  {change}"


if __name__ == "__main__":
    main()
