"""Judge the wrong trials of stale problems, for the common mistakes on their pages.

`_build/mistakes/ch1/p15.json` lists, for each check cell of a problem and each of its answers, two to
four wrong trials: the answer as typed, the message of its check, and the question of the trial. Where
the message names a point of a plane of parameters, a picture beside the file shows it with the
answer's region and the right one.

A problem is stale if its code or its trials changed, or a module of ours that they load (also
indirectly), or requirements.txt, or this file. Files of problems that left the book are removed.
"""

import ast
import hashlib
import io
import json
import os
import re
import sys
from contextlib import redirect_stdout
from dataclasses import asdict, dataclass
from pathlib import Path

import sympy as sp
from execute import EXECUTION, for_page, import_for, modules_loaded, run_in_parallel, shared_digest
from kernel import set_up_pictures
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanAtom, BooleanFunction

from workbook import checks
from workbook.authoring.master import master_paths, read_master
from workbook.authoring.mistakes import as_received, mistake_sentence
from workbook.authoring.trials import trials_file
from workbook.checks.contract.check_cells import reported_names, with_one_answer
from workbook.checks.contract.encoding import describe
from workbook.checks.contract.verdict import WRONG

#: How many mistakes the page shows of each answer, where there are so many.
LEAST, MOST = 2, 4
NUMBER = re.compile(r"-?\d[\w./]*")
#: The value of a symbol in a message.
VALUE = re.compile(r"(\w+) = (-?\d+(?:\.\d+)?(?:e-?\d+)?(?:/\d+)?)(?=[,;:]? )")
#: Symbols are of SymPy's type Boolean, too.
CONDITIONS = (Relational, BooleanFunction, BooleanAtom)
INEQUALITIES = (sp.Gt, sp.Ge, sp.Lt, sp.Le)


@dataclass(frozen=True)
class Mistake:
    """A wrong answer as typed, the message of its check, the trial's question, a picture as SVG."""

    code: str
    message: str
    question: str
    picture: str = ""


@dataclass(frozen=True)
class Problem:
    """A master with the file of its mistakes, their fingerprint, and the modules of ours it loads."""

    master: object
    file: object
    fingerprint: str
    modules: tuple


def main(root):
    """Bring the mistakes of the book at `root` up to date; return the exit code."""
    folder = root / "_build" / "mistakes"
    paths, state = master_paths(root / "solutions"), folder / "state"
    digest = _digest(root, paths)
    if state.exists() and state.read_text("utf-8") == digest:
        print("no trial has changed, all common mistakes are up to date")
        return 0
    problems = [_problem(read_master(path), folder) for path in paths]
    for leftover in set(folder.glob("ch*/*.json")) - {problem.file for problem in problems}:
        leftover.unlink()
    stale = [problem for problem in problems if not _is_fresh(problem)]
    print(f"the trials of {len(stale)} of {len(problems)} problems are to be judged")
    import_for(stale)
    failures = []
    for problem, (listed, failure) in run_in_parallel(judge, stale):
        if failure:
            failures.append(f"problem {problem.master.number}, {failure}")
        else:
            write(problem, listed)
    for failure in sorted(failures):
        print(failure, file=sys.stderr)
    if not failures:
        folder.mkdir(parents=True, exist_ok=True)
        state.write_text(digest, encoding="utf-8")
    return 1 if failures else 0


def write(problem, listed):
    """Write the mistakes of a problem, and their pictures beside: p15-a_region-1.svg."""
    problem.file.parent.mkdir(parents=True, exist_ok=True)
    for leftover in problem.file.parent.glob(f"{problem.file.stem}-*.svg"):
        leftover.unlink()
    for answer in (answer for answers in listed for answer in answers):
        for number, mistake in enumerate(answer["mistakes"], start=1):
            if picture := mistake["picture"]:
                mistake["picture"] = f"{problem.file.stem}-{answer['answer']}-{number}.svg"
                problem.file.with_name(mistake["picture"]).write_text(picture, encoding="utf-8")
    content = {"of": problem.fingerprint, "checks": listed}
    problem.file.write_text(json.dumps(content, ensure_ascii=False), encoding="utf-8")


def judge(problem):
    """Return the mistakes of a problem, and None or what failed."""
    try:
        return Judge(problem.master).mistakes(), None
    except Exception as error:
        return None, f"{type(error).__name__}: {error}"


class Judge:
    """Judges the trials of a master; its own answers are computed only where they are needed."""

    def __init__(self, master):
        self._master, self._solved = master, None
        self._data = {"__name__": "exercise"}
        self._run("data", self._data)

    def mistakes(self):
        """Return for each check cell a list of its answers, each with its mistakes as dicts."""
        return [
            [
                {"answer": name, "mistakes": [*map(asdict, select(self._judged(cell, name)))]}
                for name in reported_names(cell)
            ]
            for cell in self._master.code("check")
        ]

    def _judged(self, cell, name):
        check = with_one_answer(cell, name)
        trials = [trial for trial in self._master.trials["wrong"] if trial.name == name]
        return [self._mistake(trial, check) for trial in trials if self._question(trial)]

    def _mistake(self, trial, check):
        needs_answers = self._uses_answers(trial.source) or self._uses_answers(check, trial.name)
        names = self._data | (self._solution() if needs_answers else {})
        exec(trial.source, names)
        value = as_received({trial.name: names[trial.name]})[trial.name]
        with checks.collecting() as verdicts:
            exec(check, names | {trial.name: value})
        verdict = verdicts[trial.name]
        if verdict.status != WRONG:
            raise ValueError(f"a wrong trial of {trial.name} is {verdict.status}: {trial.source}")
        return Mistake(
            self._typed(trial, value),
            verdict.message,
            self._question(trial),
            self._picture(trial.name, value, verdict.message),
        )

    def _question(self, trial):
        """Return the question of a trial without its hint, which the page shows elsewhere."""
        return (mistake_sentence(self._master, trial) or "").partition("\n")[0]

    def _typed(self, trial, value):
        """Return the trial as a student types it: its code if it is one statement of data alone."""
        if len(ast.parse(trial.source).body) == 1 and not self._uses_answers(trial.source):
            return trial.source.strip()
        text = " ".join(describe(value).split()).replace("[ ", "[")  # a matrix is on one line
        return f"{trial.name} = {text}"

    def _uses_answers(self, source, besides=None):
        loaded = {
            node.id
            for node in ast.walk(ast.parse(source))
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
        }
        return bool(loaded & (self._master.answers.keys() - {besides}))

    def _solution(self):
        """Return the worked answers."""
        if self._solved is None:
            names = dict(self._data)
            self._run("answer", names)
            self._solved = {name: names[name] for name in self._master.answers}
        return self._solved

    def _run(self, role, names):
        with open(os.devnull, "w", encoding="utf-8") as nowhere, redirect_stdout(nowhere):
            for source in self._master.code(role):
                exec(source, names)

    def _picture(self, name, value, message):
        """Return the picture of a counterexample in a plane as SVG, "" if it is none."""
        point = dict(VALUE.findall(message))
        if len(point) != 2 or not is_region(value, point):
            return ""
        right = as_received({name: self._solution()[name]})[name]
        return draw(value, right, point) if is_region(right, point) else ""


def select(judged):
    """Return two to four mistakes in their order: the first of each message, whatever its numbers."""
    first = {}
    for mistake in judged:
        first.setdefault(NUMBER.sub("", mistake.message), mistake)
    selected = list(first.values())[:MOST]
    others = [mistake for mistake in judged if mistake not in selected]
    selected += others[: max(LEAST - len(selected), 0)]
    return [mistake for mistake in judged if mistake in selected]


def is_region(value, names):
    """Return whether an answer is a condition that compares two symbols of these names."""
    condition = _condition(value)
    return (
        isinstance(condition, CONDITIONS)
        and {symbol.name for symbol in condition.free_symbols} <= set(names)
        and all(isinstance(atom, INEQUALITIES) for atom in condition.atoms(Relational))
        and not condition.has(sp.Not)
    )


def draw(answer, right, point):
    """Return a picture of the answer's region, the right one, and the point {name: text} in both."""
    import matplotlib.pyplot as plt

    from trajlib import plotting

    symbols = [sp.Symbol(name, real=True) for name in point]
    x, y = (float(sp.Rational(text)) for text in point.values())
    ranges = [(-half, half) for half in (max(2, 1.6 * abs(x)), max(2, 1.6 * abs(y)))]
    set_up_pictures()  # in a process of its own
    with plotting.style():
        figure, axes = plt.subplots(1, 2, figsize=(6.2, 3.1), layout="constrained")
        for ax, region, title in zip(axes, (answer, right), ("this answer", "right answer")):
            plotting.region(_plain(_condition(region), symbols), symbols, *ranges, ax=ax)
            ax.plot([x], [y], "o", color="#a3262c", markersize=8, zorder=5)
            ax.set_title(title)
        drawn = io.StringIO()
        figure.savefig(drawn, format="svg", bbox_inches="tight", metadata={"Date": None})
        plt.close(figure)
    return for_page(drawn.getvalue())


def _condition(value):
    """Return a list of conditions as one; other values as they are."""
    is_list = isinstance(value, (list, tuple)) and all(
        isinstance(part, CONDITIONS) for part in value
    )
    return sp.And(*value) if is_list else value


def _plain(condition, symbols):
    """Return a condition in these symbols, whatever assumptions its own have."""
    own = {symbol.name: symbol for symbol in condition.free_symbols}
    return condition.xreplace({own[s.name]: s for s in symbols if s.name in own})


def _problem(master, folder):
    trials = [(trial.name, trial.source, trial.comment) for trial in master.trials["wrong"]]
    code = [*master.code("data", "answer", "check"), *(source for _, source, _ in trials)]
    modules = modules_loaded(code)
    parts = json.dumps([code, trials, modules, _shared(master.path.parents[2])])
    file = folder / master.path.parent.name / f"{master.path.stem}.json"
    return Problem(master, file, hashlib.sha256(parts.encode()).hexdigest(), tuple(modules))


def _is_fresh(problem):
    return (
        problem.file.exists()
        and json.loads(problem.file.read_text("utf-8"))["of"] == problem.fingerprint
    )


def _shared(root):
    """Return one hash of what all problems depend on beside their modules."""
    files = (root / "requirements.txt", *EXECUTION, Path(__file__))
    texts = b"".join(path.read_bytes() for path in files)
    return hashlib.sha256(texts).hexdigest() + sys.version


def _digest(root, paths):
    """Return one hash of everything that the mistakes may depend on."""
    combined = hashlib.sha256(f"{shared_digest(root)}{_shared(root)}".encode())
    for path in paths:
        for file in (path, trials_file(path)):
            combined.update(f"{file}\n".encode() + file.read_bytes())
    return combined.hexdigest()
