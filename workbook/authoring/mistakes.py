"""Seals the mistakes of a master for the students' copy: the wrong trials whose comment is a
sentence to the student.

A trial of which the signature is that of a right answer, or that of another mistake with another
sentence, stays without a name.
"""

import hashlib
import json
import re

from trajlib.typesetting import plain
from workbook.mistakes.sealing import seal
from workbook.mistakes.signature import Question, Unlike, in_cases, signatures
from workbook.notebooks.execution import in_child

#: A question or a pointer, and perhaps the number of the hint that belongs to it.
SENTENCE = re.compile(r"(?P<text>[A-Z].{10,}[.?])(?: \(hint (?P<hint>\d)\))?", re.S)
#: Minutes are enough for the worked computations of any problem.
PATIENCE = 600


def sentence(master, trial):
    """What the giver of a wrong trial reads, with its hint in a second line; None if its comment is
    only a note.

    Formulas are as one types them, since it is read in terminals too; HTML sets them
    (`trajlib.typesetting.typeset`).
    """
    said = SENTENCE.fullmatch(trial.comment)
    if said is None:
        return None
    hint = (
        f"\nHint {said['hint']}: {plain(master.hints[trial.name][int(said['hint']) - 1])}"
        if said["hint"]
        else ""
    )
    return plain(said["text"]) + hint


def text_of(master):
    """The text of the file of mistakes, by running data, answers and trials in a process of their
    own."""
    named = any(sentence(master, trial) for trial in master.trials["wrong"])
    answers = in_child(_sealed_in_child, master, timeout=PATIENCE) if named else {}
    return json.dumps({"of": origin(master), "answers": answers}, indent=1, sort_keys=True) + "\n"


def origin(master):
    """A hash of all that the mistakes are made of."""
    made_of = [
        master.code("data", "answer"),
        [[trial.name, trial.source, sentence(master, trial)] for trial in master.trials["wrong"]],
    ]
    return hashlib.sha256(json.dumps(made_of).encode()).hexdigest()[:16]


def sealed(master, reference, trials):
    """{answer: what the file says of it}; `reference` holds the right values, `trials` (trial,
    value) of wrong ones."""
    said = {}
    for name in master.answers:
        given = [(sentence(master, trial), value) for trial, value in trials if trial.name == name]
        question = question_of(master, name, [reference[name], *(value for _, value in given)])
        right, texts = set(_like(reference[name], question)), {}
        for text, like in (
            (text, like) for text, value in given for like in _each_like(value, question)
        ):
            if text and like and not right & set(like):
                texts.setdefault(like[0], set()).add(text)
        entries = (
            seal(*said_of, f"{master.number} {name}", like)
            for like, said_of in texts.items()
            if len(said_of) == 1
        )
        if told := dict(entries):
            said[name] = {"kind": question.kind, "symbols": question.symbols, "told": told}
    return said


def question_of(master, name, values):
    """What an answer is read as: its symbols are those of the values, the right one first."""
    answer = master.answers[name]
    kind = answer.kind.partition("(")[0].replace(" exact", "").strip()
    basis = " basis" if kind in ("list of vector", "dict") and "basis" in answer.text else ""
    symbols = {}
    for value in values:
        for symbol in sorted(_symbols(value), key=str):
            symbols.setdefault(symbol.name, _assumed(symbol))
    return Question(kind + basis, symbols)


def _like(value, question):
    try:
        return list(signatures(value, question))
    except Unlike:
        return []


def _each_like(value, question):
    """The signatures of a value, and of arcs those of the cases that they are for themselves."""
    cases = [_like(form, question) for form in in_cases(value, question.kind)]
    return [[one for one in _like(value, question) if one not in sum(cases, [])], *cases]


def _assumed(symbol):
    return "positive" if symbol.is_positive else "integer" if symbol.is_integer else ""


def _symbols(value):
    if isinstance(value, dict):
        value = [*value, *value.values()]
    if isinstance(value, (list, tuple, set, frozenset)):
        return set().union(*map(_symbols, value))
    return getattr(value, "free_symbols", set())


def _sealed_in_child(master):
    import os
    from contextlib import redirect_stdout

    os.environ.setdefault("MPLBACKEND", "Agg")
    names = {"__name__": "exercise"}
    with open(os.devnull, "w", encoding="utf-8") as nowhere, redirect_stdout(nowhere):
        for source in master.code("data"):
            exec(source, names)
        solved = dict(names)
        for source in master.code("answer"):
            exec(source, solved)
        reference = {name: solved[name] for name in master.answers}
        trials = [(trial, value_of(trial, names | reference)) for trial in master.trials["wrong"]]
    return sealed(master, received(reference), trials)


def value_of(trial, names):
    """The value of a trial that begins from data and worked answers, as a check receives it."""
    exec(trial.source, names)
    return received({trial.name: names[trial.name]})[trial.name]


def received(answers):
    from workbook.checks.contract.decoding import decode
    from workbook.checks.contract.encoding import encode

    return {name: decode(encode(value)) for name, value in answers.items()}
