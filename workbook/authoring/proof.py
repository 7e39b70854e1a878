"""Prove a problem: its checks take what is right, and refuse what is wrong.

The worked answers are right, also in all other forms, and so are the right trials. The untouched
copy is missing. Every answer has a wrong trial, and each of these is wrong, which says more than
"unchecked" or "invalid", and changes no other verdict. Of the small changes of an answer, like slips
of the pen, a check refuses most; those that it takes are listed, since only their author can say
whether they are right as well, as a multiple of a basis vector is.
"""

import os
from contextlib import redirect_stdout
from dataclasses import dataclass

from workbook.authoring.judged_problem import JudgedProblem, data_of, encoded, worked_answers
from workbook.authoring.mutants import mutants
from workbook.checks.contract.decoding import decode
from workbook.checks.contract.encoding import encode
from workbook.checks.contract.verdict import MISSING, RIGHT, WRONG
from workbook.notebooks.execution import EndedEarly, TimeLimit, in_child

#: Seconds for the worked computations of a problem, and for all that is judged.
SOLVING, JUDGING = 120, 600
#: The share of the small changes of an answer that its check may take, if they are right as well.
MOST_ACCEPTED = 1 / 2


@dataclass(frozen=True)
class Proof:
    """The result of proving a problem.

    Attributes
    ----------
    number : str
        The problem.
    faults : list of str
        Why it is not proved, one line each; empty if it is.
    counts : dict of int
        How many answers, forms, right and wrong trials and small changes were judged.
    accepted : list of str
        The small changes of right answers that are right by the checks.
    """

    number: str
    faults: list
    counts: dict
    accepted: list

    @property
    def summary(self):
        """One line: whether it is proved, and what was judged."""
        judged = ", ".join(
            f"{count} {what.removesuffix('s') if count == 1 else what}"
            for what, count in self.counts.items()
        )
        return f"{'not proved' if self.faults else 'proved'}" + (f" ({judged})" if judged else "")


def prove(master):
    """Return the `Proof` of a master; its cells run in processes of their own."""
    try:
        answers = in_child(_quietly, _solved, master, timeout=SOLVING)
        found = in_child(_quietly, _found, master, answers, timeout=JUDGING)
    except TimeLimit as error:
        found = {"faults": [f"it takes too long: {error}"], "counts": {}, "accepted": []}
    except (EndedEarly, RuntimeError) as error:
        last = str(error).strip().rpartition("\n")[2]
        found = {"faults": [f"a cell fails: {last}"], "counts": {}, "accepted": []}
    return Proof(master.number, **found)


def untouched(problem):
    """Return the status of each answer of an untouched copy."""
    return {name: verdict.status for name, verdict in problem.judge({}).items()}


def wrong_trials(problem):
    """Return (wrong trials with their verdicts, what they change of other verdicts).

    One half of the answers is wrong, then the other, in every way. The rest stay right, which is
    verified in the first turn. A trial is a dictionary with answer, comment, value and verdict.
    """
    trials, changed, order = {}, [], list(problem.master.answers)
    for trial in trials_of(problem, "wrong"):
        trials.setdefault(trial["answer"], []).append(trial)
    for half in (order[::2], order[1::2]):
        for turn in range(max((len(trials[name]) for name in half if name in trials), default=0)):
            tried = {name: trials[name][turn] for name in half if turn < len(trials.get(name, ()))}
            values = {name: trial["value"] for name, trial in tried.items()}
            for name, verdict in problem.judge_among_right(
                tried if turn else order, values
            ).items():
                if name in tried:
                    tried[name]["verdict"] = verdict
                elif verdict.status != RIGHT:
                    changed.append(
                        f"{name} is {verdict.status} beside "
                        f"{[trial['comment'] for trial in tried.values()]}"
                    )
    return [trial for name in trials for trial in trials[name]], changed


def right_trials(problem):
    """Return the right trials with their verdicts, as `wrong_trials` does."""
    return [
        trial | {"verdict": problem.judge_one(trial["answer"], trial["value"])}
        for trial in trials_of(problem, "right")
    ]


def forms_refused(problem):
    """Return ({answer: names of its forms}, [(answer, form, value, verdict)] not taken for right)."""
    tried, refused = {}, []
    for name, value in problem.reference.items():
        # as it was received, since a check may have changed an object
        others = problem.forms(name, decode(encode(value)))
        tried[name] = list(others)
        for form, other in others.items():
            verdict = problem.judge_one(name, other)
            if verdict.status != RIGHT:
                refused.append((name, form, other, verdict))
    return tried, refused


def small_changes(problem):
    """Yield (answer, its right value with a small change, verdict)."""
    for name, reference in problem.reference.items():
        for mutant in mutants(reference, problem.master.answers[name].kind):
            yield name, mutant, problem.judge_one(name, mutant)


def trials_of(problem, role):
    """Return the trials of a role: answer, comment and value of each."""
    return [
        {"answer": trial.name, "comment": trial.comment, "value": value}
        for trial, value in zip(problem.master.trials[role], problem.given(role))
    ]


def _quietly(function, *args):
    os.environ.setdefault("MPLBACKEND", "Agg")
    with open(os.devnull, "w", encoding="utf-8") as nowhere, redirect_stdout(nowhere):
        return function(*args)


def _solved(master):
    return encoded(worked_answers(master, data_of(master)))


def _found(master, answers):
    """Return faults, counts and accepted changes as plain data."""
    problem = JudgedProblem(master, answers)
    faults = [
        f"{name}: the worked answer is {verdict.status}: {verdict.message}"
        for name, verdict in problem.judge(problem.reference).items()
        if verdict.status != RIGHT
    ]
    faults += [
        f"{name}: untouched it is {status}, not missing"
        for name, status in untouched(problem).items()
        if status != MISSING
    ]
    right, (wrong, changed), (forms, refused) = (
        right_trials(problem),
        wrong_trials(problem),
        forms_refused(problem),
    )
    faults += [
        f"{trial['answer']} = {trial['value']}: a {role} trial is {trial['verdict'].status}: "
        f"{trial['verdict'].message}"
        for role, trials in ((RIGHT, right), (WRONG, wrong))
        for trial in trials
        if trial["verdict"].status != role
    ]
    untried = master.answers.keys() - {trial["answer"] for trial in wrong}
    faults += [f"{name}: it has no wrong trial" for name in master.answers if name in untried]
    faults += changed
    faults += [
        f"{name}, {form}: {value} is {verdict.status}: {verdict.message}"
        for name, form, value, verdict in refused
    ]
    changes = list(small_changes(problem))
    taken = [(name, mutant) for name, mutant, verdict in changes if verdict.status == RIGHT]
    for name in master.answers:
        own, all_own = ([row[0] for row in rows].count(name) for rows in (taken, changes))
        if own > MOST_ACCEPTED * all_own:
            faults.append(f"{name}: its check takes {own} of {all_own} small changes for right")
    return {
        "faults": faults,
        "counts": {
            "answers": len(master.answers),
            "forms": sum(map(len, forms.values())),
            "right trials": len(right),
            "wrong trials": len(wrong),
            "small changes": len(changes),
        },
        "accepted": [f"{name} = {mutant}" for name, mutant in taken],
    }
