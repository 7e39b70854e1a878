"""Variants: a problem with the numbers of another row, proved before it is handed out.

A row is proved if the right answers for it are judged right and all foreseen mistakes wrong, if no
coefficient vanishes and no answer grows long, if the answers on the site, which are those of row 0,
earn at most a stated share, and if the row has few right answers in common with each earlier row.
Only a proved row has a notebook in variants/ of its course, where `exercises.find` finds it by its
name, such as 2.4~17. A proof is made again when the page, its trials or a module of ours behind them
changes.
"""

import hashlib
import json
import os
import re
from contextlib import redirect_stdout
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from pathlib import Path

import sympy as sp

from workbook.authoring.errors import MasterError
from workbook.authoring.links import Links
from workbook.authoring.master import read_master
from workbook.authoring.mistakes import as_received, seal_mistakes, trial_value
from workbook.authoring.numbers import (
    NumbersError,
    phrases,
    read_numbers,
    row_texts,
    run_cells,
    with_row,
)
from workbook.authoring.student_notebook import baseurl, student_notebook
from workbook.authoring.trials import trials_file
from workbook.checks.contract.check_cells import reported_names
from workbook.checks.contract.encoding import encode
from workbook.checks.contract.verdict import RIGHT, WRONG
from workbook.mistakes import mistakes_file
from workbook.notebooks import exercises
from workbook.notebooks.dependencies import module_closure
from workbook.notebooks.execution import Child, judge_answers
from workbook.numbering import read_number

#: What the answers of the site may earn, unless the section sets `site_share`.
SHARE = 1 / 3
#: What two rows may have in common of the answers that vary.
SHARED = 1 / 5
#: Seconds for the proof of one row.
TIMEOUT = 600


@dataclass(frozen=True)
class Proof:
    """The result of proving a row.

    Attributes
    ----------
    name : str
        Name of the variant, such as 2.4~17.
    faults : tuple of str
        Why the row cannot be handed out; empty if it can.
    site_share : float
        The share of the answers that the site's answers get right.
    shared : float
        The greatest share of the answers that vary that the row and an earlier one have in common.
    """

    name: str
    faults: tuple
    site_share: float
    shared: float


class Variants:
    """All rows of a problem, and the right answers for each of them.

    Parameters
    ----------
    master : Master
        The problem; its data cells are run in this process.

    Raises
    ------
    MasterError
        If its section of numbers cannot be used.
    """

    def __init__(self, master):
        self.master, self.numbers = master, read_numbers(master)
        self._names = {}
        self._site_phrases = phrases(self.names(0))
        page = _shown_text(master)
        if missing := [text for text in self._site_phrases if text not in page]:
            raise MasterError(
                trials_file(master.path), 1, f"the page has no phrase {', '.join(missing)}"
            )

    def data(self, row):
        """Return the data cells with the numbers of a row."""
        return [with_row(cell, self.numbers, row) for cell in self.master.code("data")]

    def names(self, row):
        """Return the names after the data cells and the section with the numbers of a row."""
        return dict(self._cached_names(row)[1])

    def data_names(self, row):
        """Return the names after the data cells alone."""
        return dict(self._cached_names(row)[0])

    def _cached_names(self, row):
        if row not in self._names:  # a data cell may take long
            data = run_cells(self.data(row))
            names = dict(data)
            exec(self.numbers.source, names)
            self._names[row] = data, names
        return self._names[row]

    def variant(self, row):
        """Return the master with the numbers of a row; row 0 is the master itself.

        Raises
        ------
        NumbersError
            If a coefficient is 0, or two phrases that look alike in row 0 differ in this row.
        """
        pairs = list(zip(self._site_phrases, phrases(self.names(row))))
        texts = dict(pairs)
        if set(texts.items()) != set(pairs):
            raise NumbersError("two phrases are the same in row 0 and differ in this row")
        pattern = re.compile(
            "|".join(map(re.escape, sorted(texts, key=len, reverse=True))) or r"(?!)"
        )
        master = self.master

        def shown(text):
            return pattern.sub(lambda match: texts[match[0]], text)

        data = iter(self.data(row))
        return replace(
            master,
            number=f"{master.number}~{row}" if row else master.number,
            title=shown(master.title),
            answers={k: replace(v, text=shown(v.text)) for k, v in master.answers.items()},
            hints={name: tuple(map(shown, hints)) for name, hints in master.hints.items()},
            cells=tuple(
                cell
                if cell.role in ("answer", "figure", "check")
                else replace(cell, source=shown(next(data) if cell.role == "data" else cell.source))
                for cell in master.cells
            ),
        )

    def reference(self, row, worked):
        """Return the right answers for a row: those of the section, else the worked ones."""
        names = self.names(row)
        return as_received({name: names.get(name, worked[name]) for name in self.master.answers})

    def most_shared(self, row):
        """Return which earlier row shares most of the answers that vary with a row, and the share.

        Right values are compared, not judged, since the checks would take minutes.
        """
        forms = self._forms
        varying = [name for name in forms[0] if len({form[name] for form in forms}) > 1]
        counts = [sum(forms[row][n] == form[n] for n in varying) for form in forms[:row]]
        most = max(counts)
        return counts.index(most), most / max(len(varying), 1)

    @cached_property
    def _forms(self):
        """The right answers that depend on the numbers, by row, in a form to be compared."""
        rows = map(self.names, range(len(self.numbers.rows)))
        return [
            {name: encode(_normal(names[name])) for name in self.master.answers if name in names}
            for names in rows
        ]


def variants_of(root, number):
    """Return the `Variants` of a problem in the folder of a course."""
    return Variants(read_master(Path(root) / "solutions" / read_number(number).file(".md")))


def prove(root, number, rows=None):
    """Prove rows of a problem, and write the notebook of each proved one.

    Parameters
    ----------
    root : path_like
        The folder of the course.
    number : str
        The problem.
    rows : iterable of int, optional
        The rows; by default all but row 0.

    Yields
    ------
    Proof
        Of each row, in order.

    Raises
    ------
    MasterError
        If the problem cannot vary.
    """
    variants = variants_of(root, number)
    key = _proof_key(variants.master)
    rows = list(range(1, len(variants.numbers.rows)) if rows is None else rows)
    results = {row: _stored_proof(variants, row, key) for row in rows}
    missing = [row for row in rows if results[row] is None]
    child = Child(_prove_rows, variants.master, str(root), missing) if missing else None
    try:
        for row in rows:
            if results[row] is None:
                proof, notebook, mistakes = child.result(TIMEOUT)
                results[row] = Proof(**proof | {"faults": tuple(proof["faults"])})
                _store(results[row], key, notebook, mistakes)
            yield results[row]
    finally:
        if child is not None:
            child.end()


def _normal(value):
    """Return a value with products expanded, and with three digits where these are accepted."""
    if isinstance(value, sp.MatrixBase):
        value = value.tolist()
    if isinstance(value, dict):
        return {_normal(key): _normal(part) for key, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [_normal(part) for part in value]
    if isinstance(value, sp.Expr) and not value.is_Integer:
        return sp.expand(value) if value.free_symbols else sp.N(value, 3)
    return value


def _shown_text(master):
    """Return all texts of a master that phrases may change."""
    cells = [cell.source for cell in master.cells if cell.role in ("", "data", "drawing")]
    answers = [answer.text for answer in master.answers.values()]
    return "\n".join([master.title, *cells, *answers, *sum(map(list, master.hints.values()), [])])


def _proof_key(master):
    """Return a hash of all that proofs depend on: page, trials, and modules of ours."""
    texts = [path.read_text("utf-8") for path in (master.path, trials_file(master.path))]
    code = ["from workbook.authoring import variants", *master.code("data", "answer", "check")]
    closure = module_closure("\n".join(code))
    return hashlib.sha256(json.dumps([texts, closure]).encode()).hexdigest()


def _stored_proof(variants, row, key):
    """Return the stored `Proof` of a proved row, None if there is none that still holds."""
    notebook = exercises.path_of(f"{variants.master.number}~{row}")
    if not notebook.is_file():
        return None
    stored = json.loads(mistakes_file(notebook).read_text(encoding="utf-8"))
    return Proof(**stored["proof"] | {"faults": ()}) if stored["of"] == key else None


def _store(proof, key, notebook, mistakes):
    path = exercises.path_of(proof.name)
    if proof.faults:
        path.unlink(missing_ok=True)
        mistakes_file(path).unlink(missing_ok=True)
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    stored = {"of": key, "answers": mistakes, "proof": asdict(proof)}
    # the notebook last, since it says that the row is proved
    for file, text in {mistakes_file(path): json.dumps(stored, indent=1), path: notebook}.items():
        temporary = file.with_name(f"{file.name}.{os.getpid()}")
        temporary.write_text(text, encoding="utf-8")
        temporary.replace(file)


def _prove_rows(master, root, rows):
    """Yield (proof, notebook, sealed mistakes) of rows, as plain data, in a child process."""
    os.environ.setdefault("MPLBACKEND", "Agg")
    with open(os.devnull, "w", encoding="utf-8") as nowhere, redirect_stdout(nowhere):
        variants, worked = Variants(master), run_cells(master.code("data", "answer"))
        site = as_received({name: worked[name] for name in master.answers})
        links = Links(Path(root), baseurl(Path(root)))
        for row in rows:
            proof, mistakes = _prove_row(variants, row, site)
            notebook = "" if proof.faults else _notebook_text(variants.variant(row), links)
            yield asdict(proof), notebook, mistakes


def _notebook_text(master, links):
    return json.dumps(student_notebook(master, links), indent=1, ensure_ascii=False) + "\n"


def _prove_row(variants, row, site):
    """Return (`Proof`, sealed mistakes) of a row, given the answers of row 0."""
    name = f"{variants.master.number}~{row}"
    try:
        master = variants.variant(row)
    except NumbersError as error:
        return Proof(name, (str(error),), 1.0, 1.0), {}
    other, shared = variants.most_shared(row)
    reference = variants.reference(row, site)
    data = variants.data_names(row)
    judged = _Judged(master, data)
    faults = [
        f"{answer}: the right answer is {status}"
        for answer, status in judged.statuses(reference).items()
        if status != RIGHT
    ]
    trials = {
        role: [(trial, trial_value(trial, data | reference)) for trial in master.trials[role]]
        for role in ("right", "wrong")
    }
    for role, expected in (("right", RIGHT), ("wrong", WRONG)):
        for trial, value in trials[role]:
            if (status := judged.status(trial.name, value)) != expected:
                faults.append(f"{trial.name}: {trial.source} is {status}")
    faults += _grown(reference, site) + _vanished(variants.numbers, row)
    site_share = judged.share(site)
    allowed = float(variants.names(row).get("site_share", SHARE))
    if site_share > allowed + 1e-9:
        faults.append(f"the answers of the site earn {site_share:.2f}, more than {allowed:.2f}")
    if shared > SHARED + 1e-9:
        faults.append(
            f"it shares {shared:.2f} of the answers that vary with row {other}, more than {SHARED:.2f}"
        )
    mistakes = {} if faults else seal_mistakes(master, reference, trials["wrong"])
    return Proof(name, tuple(faults), site_share, shared), mistakes


class _Judged:
    """Judges answers by the check cells of a master after its data cells."""

    def __init__(self, master, data):
        self._names, self._data = list(master.answers), data
        self._cells = [("check", source) for source in master.code("check")]
        self._cell_of = {name: cell for cell in self._cells for name in reported_names(cell[1])}

    def statuses(self, answers):
        """Return the status of each answer."""
        return self._judge(self._cells, answers, self._names)

    def status(self, name, value):
        """Return the status of one answer, by its check cell alone."""
        return self._judge([self._cell_of[name]], {name: value}, [name])[name]

    def share(self, answers):
        """Return the share of answers that are right."""
        statuses = list(self.statuses(answers).values())
        return statuses.count(RIGHT) / len(statuses)

    def _judge(self, cells, answers, names):
        values = dict.fromkeys(self._names, ...) | answers
        verdicts = judge_answers(cells, lambda: values, names, dict(self._data))
        return {name: status for name, (status, *_) in verdicts.items()}


def _grown(reference, site):
    """Return the faults of answers that are more than about twice as long as those of row 0."""
    lengths = {name: (len(str(value)), len(str(site[name]))) for name, value in reference.items()}
    return [
        f"{name}: the right answer has {own} letters, that of row 0 only {first}"
        for name, (own, first) in lengths.items()
        if own > 2 * first + 10
    ]


def _vanished(numbers, row):
    """Return the faults of single numbers that are 0 although those of row 0 are not."""
    first, own = row_texts(numbers.rows[0]), row_texts(numbers.rows[row])
    return [
        f"{name} is 0"
        for name, value, before in zip(numbers.names, own, first)
        if value == "0" != before
    ]
