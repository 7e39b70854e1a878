"""Each hostile submission succeeds in an unguarded grader and fails in ours.

In ours it gains nothing, harms no other student and stops nothing.
"""

import os
import sys
from pathlib import Path

import platformdirs
import pytest

sys.path.insert(0, str(Path(__file__).parents[1]))
from classroom import RIGHT_1_15, notebook
from hostile import naive, ours
from hostile.attack import SECRET
from hostile.course import a_course, seen_by_naive, seen_by_ours
from hostile.table import ATTACKS

from workbook.grading.sandbox.isolation import PACKAGE

HONEST = ("a-honest", "z-honest")
#: How many attacks stand between two honest students.
APART = 8


def test_at_least_forty_attacks():
    assert len({attack.name for attack in ATTACKS}) == len(ATTACKS) >= 40
    assert all(attack.attempts and attack.unguarded and attack.after for attack in ATTACKS)


@pytest.mark.parametrize("attack", ATTACKS, ids=lambda attack: attack.name.replace(" ", "-"))
def test_attack_succeeds_unguarded(attack):
    with a_course() as course:
        for student in HONEST:
            course.hand_in_honestly(student)
        course.hand_in("mallory", attack)
        course.open_to_all()
        finished = naive.run(course.here, attack.apart, attack.marks, attack.patience)
        seen = seen_by_naive(course, "mallory", HONEST, finished)
        assert attack.success(seen), (
            f"this would prove nothing, since it fails where nothing guards: {seen}\n"
            + (course.here / "output.txt").read_text(errors="replace")[-1500:]
        )


@pytest.mark.slow
@pytest.mark.timeout(1800)  # where Python is to be compiled to WebAssembly first
@pytest.mark.parametrize("wasm", [False, True], ids=["bubblewrap", "wasm"])
def test_no_attack_succeeds_guarded(wasm):
    """All attacks in one run, with honest students before, between and after.

    In WebAssembly a sample of them; `make test-sandboxes` takes all.
    """
    sample = wasm and not os.environ.get("WORKBOOK_ALL_PROBLEMS")
    attacks = ATTACKS[::4] if sample else ATTACKS
    with a_course() as course:
        honest = {}
        for k, attack in enumerate(attacks):
            course.hand_in(f"m{k:03}", attack)
            if k % APART == 0:
                honest[f"m{k:03}-honest"] = len(RIGHT_1_15)
        honest |= dict.fromkeys(HONEST, len(RIGHT_1_15))
        for student in honest:
            course.hand_in_honestly(student, notebook("1.15", RIGHT_1_15))
        course.open_to_all()
        before = _files(course.here)
        environment = {"COURSE_SECRET": SECRET, "HOME": str(course.here / "home")}
        if wasm:  # the compiled Python is this user's, and no secret
            cache = platformdirs.user_cache_path("workbook", appauthor=False)
            environment["XDG_CACHE_HOME"] = str(cache.parent)
        finished = ours.run(course.here, environment, wasm, timeout=1500 if wasm else 400)
        output = (course.here / "output.txt").read_text(errors="replace")
        assert finished, output[-3000:]

        results = ours.results(course.here)
        failures = [
            f"honest {name}: {results.get(name)}" for name in honest if not _full(results.get(name))
        ]
        for k, attack in enumerate(attacks):
            failures += _failures(
                attack,
                results.get(f"m{k:03}", []),
                seen_by_ours(course, results, f"m{k:03}", honest, finished),
                wasm,
            )
        after = _files(course.here)
        failures += [f"changed: {path}" for path in before if after.get(path) != before[path]]
        failures += [f"planted: {path}" for path in PACKAGE.glob("m0*")]
        failures += [
            f"new: {path}"
            for path in after.keys() - before.keys()
            if path.parts[0] not in ("graded", "output.txt")
        ]
        assert not failures, "\n".join(failures) + "\n" + output[-3000:]


def _failures(attack, results, seen, wasm):
    """Return what is not as it must be after an attack.

    In WebAssembly a notebook may wait for a machine with Linux, and what ends it may be another
    thing.
    """
    failures = []
    if attack.success(seen):
        failures.append(f"succeeded: {seen}")
    if seen.points or SECRET in seen.text:
        failures.append(f"has points or secrets: {seen}")
    remarks = [remark for result in results for remark in result["remarks"]]
    blamed = (
        "notebook: ",
        "limits: ",
        *(["grader: this notebook waits for a machine with Linux"] if wasm else []),
    )
    if not all(remark.startswith(blamed) for remark in remarks):
        failures.append(f"the grader is blamed, or nobody: {remarks}")
    if (
        not wasm
        and attack.blame
        and not any(remark.startswith(attack.blame) for remark in remarks)
        and not _told(results)
    ):
        failures.append(f"nobody says that it is the affair of the {attack.blame}: {results}")
    if not results:
        failures.append("was not graded")
    return [f"{attack.name}: {failure}" for failure in failures]


def _told(results):
    """Return whether a verdict other than `missing` says what is wrong with an answer."""
    return any(
        status in ("wrong", "invalid")
        for result in results
        for status, *_ in result["verdicts"].values()
    )


def _full(results):
    return (
        results is not None
        and len(results) == 1
        and {status for status, *_ in results[0]["verdicts"].values()} == {"right"}
    )


def _files(here):
    """Return everything in the course's folder with its content, if that is not too large."""
    return {
        path.relative_to(here): path.read_bytes()
        if path.is_file() and path.stat().st_size < 10**7
        else None
        for path in here.rglob("*")
        if not path.is_symlink()
    }
