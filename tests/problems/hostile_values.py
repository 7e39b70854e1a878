"""Values that a student's process could hand over instead of answers, under Python's own audit.

They are code, values that are no numbers, things of a wrong kind.
"""

import json
import re
import sys
from contextlib import suppress

import scipy.optimize  # noqa: F401, so that nothing is left to be imported under the watch
import sympy as sp

from workbook.checks.contract.encoding import encode
from workbook.checks.contract.verdict import RIGHT, UNCHECKED
from workbook.grading.pool import judging
from workbook.notebooks.execution import decoded


class AuditWatch:
    """Records what the process does that it must not, by Python's own audit."""

    #: Unpickling, starting programs, calling out, changing files.
    FORBIDDEN = (
        "pickle.find_class",
        "os.system",
        "os.exec",
        "os.posix_spawn",
        "os.fork",
        "subprocess.Popen",
        "socket.connect",
        "ctypes.dlopen",
        "os.remove",
        "os.rename",
        "os.mkdir",
        "os.chmod",
        "shutil.rmtree",
        "os.putenv",
    )

    def __init__(self):
        self.events = []
        sys.addaudithook(self._note)

    def _note(self, event, arguments):
        if event in self.FORBIDDEN:
            self.events.append(f"{event} {arguments!r:.200}")
        elif event == "compile" and arguments[0] is not None:
            # Code is made of our own cells, and of expressions by lambdify, whose names have a
            # narrow alphabet.
            if not str(arguments[1]).startswith(
                ("<data cell>", "<check cell>", "<lambdifygenerated-", "<string>")
            ):
                self.events.append(f"compile {arguments!r:.200}")
            if "MARK" in (
                arguments[0].decode(errors="replace")
                if isinstance(arguments[0], bytes)
                else str(arguments[0])
            ):
                self.events.append(f"compile of foreign text {arguments!r:.200}")
        elif event == "open" and isinstance(arguments[1], str) and set("wax+") & set(arguments[1]):
            self.events.append(f"open {arguments!r:.200}")
        elif event == "import" and "MARK" in str(arguments):
            self.events.append(f"import {arguments!r:.200}")

    def seen(self):
        """Return the events since the last call."""
        events, self.events = self.events, []
        return sorted(set(events))


PAYLOADS = [
    "__import__('os').system('true MARK')",
    "MARK",
    "exec('MARK = 1')",
    "().__class__.__base__.__subclasses__()[MARK]",
    "k1 > 0 if MARK else 1",
    "lambda: MARK",
    "x=open('MARK', 'w')",
    "import MARK",
    "{MARK}",
    "%MARK",
    "Symbol('MARK')",
    "S('MARK')",
    "cos\nMARK",
    "'\"MARK",
    "\\MARK",
]
#: By problem, what is right although it looks like nothing: there are no such angles in 1.6, and
#: where a system is observable (or controllable) no state is unseen and no eigenvalue lost; no
#: parameter makes that of 2.24 d controllable; where there is no observer there is no gain.
#: Eigenvalues may come as a dictionary with their multiplicities.
EMPTY_AND_RIGHT = {
    **dict.fromkeys(
        ["2.3", "2.5", "2.14", "2.24", "3.1", "3.2", "3.16", "3.17", "3.18", "3.24", "4.3", "5.67"],
        [[], ()],
    ),
    **dict.fromkeys(["1.6", "2.6", "2.7", "2.26", "2.32", "2.37"], [[], (), {}]),
}
NOTHING = [
    float("nan"),
    float("inf"),
    -float("inf"),
    sp.nan,
    sp.zoo,
    sp.oo,
    -sp.oo,
    complex(float("nan"), 1),
    10**1999,
    [],
    {},
    (),
    "",
    "right",
    [sp.nan] * 2,
    sp.Matrix([[sp.nan, sp.nan], [sp.nan, sp.nan]]),
    [[float("nan")] * 2] * 2,
    sp.Eq(sp.Symbol("k1"), sp.nan, evaluate=False),
    {"right": "right"},
]


def judge_hostile_values(problem):
    """Return {kind of values: events and verdicts that must not be}.

    It comes last in its process, since an audit hook cannot be removed.
    """
    problem.judge({})  # what the check cells import, they have imported
    watch = AuditWatch()
    non_numbers = [
        encode(value).decode()
        for value in NOTHING
        if value not in EMPTY_AND_RIGHT.get(problem.master.number, ())
    ]
    return {
        "texts": _right(problem, texts()) + watch.seen(),
        "nothing": _right(problem, non_numbers) + watch.seen(),
        "odd": _odd(problem) + watch.seen(),
    }


def _right(problem, encoded):
    """Return the encoded values judged right, each given for every answer of the problem."""
    return [
        f"{name} = {text:.300} is right"
        for text in encoded
        for name, verdict in _judged(problem, dict.fromkeys(problem.master.answers, text)).items()
        if verdict.status == RIGHT
    ]


def _judged(problem, encoded):
    """Return verdicts on encoded answers that came as a message of a student's process."""
    message = json.dumps({"encoded": encoded, "unreadable": {}, "errors": [], "stopped": []})
    read, unreadable, *_ = judging._parse(message.encode(), list(problem.master.answers))
    return problem.judge(decoded(read, unreadable, list(problem.master.answers)))


def texts():
    """Yield texts that are code, as strings and wherever a text can occur in an encoding."""
    for payload in PAYLOADS:
        symbol = {"kind": "Symbol", "name": payload, "assumptions": {}}
        written = json.loads(encode(sp.Symbol("q")))
        for node in (
            payload,
            [payload],
            {"kind": payload},
            symbol,
            written | {"name": payload},
            {"kind": "dict", "items": [[payload, payload]]},
            {
                "kind": "Integral",
                "args": [written, {"kind": "Tuple", "args": [written | {"name": payload}, 0, 1]}],
            },
            {"kind": "float", "value": payload},
            {"kind": "array", "dtype": payload, "shape": [1], "data": payload},
        ):
            yield json.dumps(node, ensure_ascii=False, sort_keys=True, separators=(",", ":"))


def odd_answers(symbol):
    """Return values that can be written down and answer nothing, in a symbol of the data.

    Another symbol would be refused by its name.
    """
    x = sp.Symbol(symbol)
    function = sp.Lambda(x, x**2)
    return {
        "text": "x",
        "none": {"none": "none"},
        "number": 3,
        "not real": sp.sqrt(-1 - x**2) > 0,
        "function": function,
        "functions": [function, function],
        "images": sp.ImageSet(function, sp.S.Integers),
        "delta": sp.DiracDelta(x),
        "condition on delta": sp.DiracDelta(x) > 0,
        "gamma": sp.gamma(x) > 0,
        "equal matrices": sp.Eq(sp.Matrix([x]), sp.Matrix([1])),
    }


def _odd(problem):
    """Return verdicts on odd answers that must not be: our failure, or an example that is right."""
    symbol = next(
        (value.name for value in problem.data.values() if isinstance(value, sp.Symbol)), "x"
    )
    failures, examples = [], {name: set() for name in problem.master.answers}
    for what, value in odd_answers(symbol).items():
        encoded = dict.fromkeys(problem.master.answers, encode(value).decode())
        for name, verdict in _judged(problem, encoded).items():
            if verdict.status == UNCHECKED:
                failures.append(f"{name}, {what}: {verdict.message}")
            elif verdict.status != RIGHT:
                examples[name] |= set(re.findall(r"such as (.+?)(?:, got|;|$)", verdict.message))
    for name, quoted in examples.items():
        for example in {part for text in quoted for part in (text, *text.split(" or "))}:
            with suppress(Exception):  # words rather than an example
                if problem.judge_one(name, sp.sympify(example, locals={"sp": sp})).status == RIGHT:
                    failures.append(f"{name} is told as an example what is right: {example}")
    return failures
