"""Seal the mistakes of a master for the student notebook.

They are the wrong trials whose comment is a sentence to the student. A trial is left out if its
signature is that of a right answer, or of another mistake with another sentence.
"""

import hashlib
import json
import os
import re
from contextlib import redirect_stdout

from trajlib.typesetting import plain
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import encode
from workbook.mistakes.sealing import seal
from workbook.mistakes.signature import AnswerType, NoSignature, arcs_as_piecewise, signatures
from workbook.notebooks.execution import in_child

#: A sentence to the student, and perhaps the number of a hint.
SENTENCE = re.compile(r"(?P<text>[A-Z].{10,}[.?])(?: \(hint (?P<hint>\d)\))?", re.S)
#: Seconds for the worked computations of a problem.
TIMEOUT = 600


def mistake_sentence(master, trial):
    """Return the sentence on a wrong trial with its hint in a second line, None if it has none.

    Formulas are plain text, for terminals; in HTML they are typeset (`trajlib.typesetting.typeset`).
    """
    match = SENTENCE.fullmatch(trial.comment)
    if match is None:
        return None
    hint = (
        f"\nHint {match['hint']}: {plain(master.hints[trial.name][int(match['hint']) - 1])}"
        if match["hint"]
        else ""
    )
    return plain(match["text"]) + hint


def mistakes_text(master):
    """Return the content of the file of mistakes, by running the master in a process of its own."""
    has_sentences = any(mistake_sentence(master, trial) for trial in master.trials["wrong"])
    answers = in_child(_run_and_seal, master, timeout=TIMEOUT) if has_sentences else {}
    return (
        json.dumps({"of": source_hash(master), "answers": answers}, indent=1, sort_keys=True) + "\n"
    )


def source_hash(master):
    """Return a hash of the number, the code and the sentences from which the mistakes are made."""
    parts = [
        master.number,
        master.code("data", "answer"),
        [
            [trial.name, trial.source, mistake_sentence(master, trial)]
            for trial in master.trials["wrong"]
        ],
    ]
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()[:16]


def seal_mistakes(master, reference, trials):
    """Return the sealed mistakes by answer.

    Parameters
    ----------
    master : Master
        The master.
    reference : dict
        The right values by answer.
    trials : list of (Trial, value)
        The wrong trials with their values.

    Returns
    -------
    dict
        For each answer with a sealed mistake its kind, its symbols and the sealed sentences.
    """
    mistakes = {}
    for name in master.answers:
        wrong = [
            (mistake_sentence(master, trial), value)
            for trial, value in trials
            if trial.name == name
        ]
        answer_type = answer_type_of(
            master, name, [reference[name], *(value for _, value in wrong)]
        )
        right = set(_signatures(reference[name], answer_type))
        sentences = {}
        for sentence, value in wrong:
            for form in _signatures_by_form(value, answer_type):
                if sentence and form and not right & set(form):
                    sentences.setdefault(form[0], set()).add(sentence)
        sealed = dict(
            seal(*only, f"{master.number} {name}", signature)
            for signature, only in sentences.items()
            if len(only) == 1
        )
        if sealed:
            mistakes[name] = {
                "kind": answer_type.kind,
                "symbols": answer_type.symbols,
                "told": sealed,
            }
    return mistakes


def answer_type_of(master, name, values):
    """Return the type of an answer with the symbols of its values, in their order."""
    answer = master.answers[name]
    kind = answer.kind.partition("(")[0].replace(" exact", "").strip()
    basis = " basis" if kind in ("list of vector", "dict") and "basis" in answer.text else ""
    symbols = {}
    for value in values:
        for symbol in sorted(_symbols(value), key=str):
            symbols.setdefault(symbol.name, _assumption(symbol))
    return AnswerType(kind + basis, symbols)


def _signatures(value, answer_type):
    try:
        return list(signatures(value, answer_type))
    except NoSignature:
        return []


def _signatures_by_form(value, answer_type):
    """Return the signatures of a value, and those of arcs as cases, in separate lists."""
    cases = [_signatures(form, answer_type) for form in arcs_as_piecewise(value, answer_type.kind)]
    whole_signatures = _signatures(value, answer_type)
    return [
        [signature for signature in whole_signatures if signature not in sum(cases, [])],
        *cases,
    ]


def _assumption(symbol):
    return "positive" if symbol.is_positive else "integer" if symbol.is_integer else ""


def _symbols(value):
    if isinstance(value, dict):
        value = [*value, *value.values()]
    if isinstance(value, (list, tuple, set, frozenset)):
        return set().union(*map(_symbols, value))
    return getattr(value, "free_symbols", set())


def _run_and_seal(master):
    os.environ.setdefault("MPLBACKEND", "Agg")
    names = {"__name__": "exercise"}
    with open(os.devnull, "w", encoding="utf-8") as nowhere, redirect_stdout(nowhere):
        for source in master.code("data"):
            exec(source, names)
        solved = dict(names)
        for source in master.code("answer"):
            exec(source, solved)
        reference = {name: solved[name] for name in master.answers}
        trials = [
            (trial, trial_value(trial, names | reference)) for trial in master.trials["wrong"]
        ]
    return seal_mistakes(master, as_received(reference), trials)


def trial_value(trial, names):
    """Return the value of a trial, run with data and worked answers, as checks receive it."""
    exec(trial.source, names)
    return as_received({trial.name: names[trial.name]})[trial.name]


def as_received(answers):
    """Return answers as checks receive them, encoded and decoded."""
    return {name: decode(encode(value)) for name, value in answers.items()}
