"""Submissions that forge what the grader reads: results, encodings, text that is code."""

from hostile.attack import WRONG, Attack, gained, lines, marked, stopped_the_run

#: Writes to the pipe of the answers, if it is found, before the notebook's own process does.
HAND_OVER = """
import json, os, struct
def hand_over(message, length=None):
    for number in range(3, 20):
        try:
            os.write(number, struct.pack(">I", len(message) if length is None else length) + message)
        except OSError:
            pass
def outcome(**given):
    return json.dumps({"encoded": {}, "unreadable": {}, "errors": [], "stopped": []} | given).encode()
"""
#: The same for a grader that looks for results in files.
AS_FILE = """
def as_file(kind, content):
    try:
        open(f"{HERE}/graded/{NAME}.{kind}", "wb").write(content)
    except OSError:
        pass
"""
RUNS = """
import pickle
class Runs:
    def __reduce__(self):
        return exec, (f"open({HERE + '/marks/' + NAME!r}, 'w').write('ran')",)
"""
END = "os._exit(0)"


def forged(*steps):
    return (lines(HAND_OVER, AS_FILE, *steps),)


FORGING = [
    Attack(
        "forges verdicts",
        "hands over verdicts beside its answers",
        "results are believed",
        "verdicts are not taken from a notebook",
        gained,
        forged(
            "as_file('json', b'{\"points\": 1}')",
            "hand_over(outcome(encoded={'a_region': '1'}, verdicts={'a_region': ['right', '']}, "
            "points=5))",
            END,
        ),
        apart=True,
    ),
    Attack(
        "forges the data",
        "hands over values under the names of the data, encoded as answers are",
        "whatever comes from the notebook is there when the check cells run",
        "only the names of the answers count",
        gained,
        forged(
            WRONG,
            "a_poly = (s + k1)*(s + k2)",
            "from workbook.checks.contract.encoding import encode",
            "forged = {'a_poly': a_poly, 'k1': k1, 'k2': k2, 's': s, 'a_region': a_region, "
            "'checks': 1}",
            "hand_over(outcome(encoded={name: encode(value).decode() for name, value in "
            "forged.items()}))",
        ),
    ),
    Attack(
        "hands over a pickle",
        "hands over a pickle that runs code when it is read",
        "results are unpickled",
        "nothing is ever unpickled",
        marked,
        forged(
            RUNS, "as_file('pkl', pickle.dumps(Runs()))", "hand_over(pickle.dumps(Runs()))", END
        ),
        apart=True,
    ),
    Attack(
        "hides a pickle in an answer",
        "hands over a pickle in the place of an encoded answer",
        "results are unpickled",
        "nothing is ever unpickled",
        marked,
        forged(
            RUNS,
            "as_file('pkl', pickle.dumps(Runs()))",
            "hand_over(outcome(encoded={'a_region': pickle.dumps(Runs(), 0).decode()}))",
            END,
        ),
        apart=True,
    ),
    Attack(
        "answers with an object that is code",
        "answers with an object whose pickle runs code",
        "answers travel as pickles",
        "an answer of such a type is refused",
        marked,
        forged(RUNS, "a_region = Runs()", "as_file('pkl', pickle.dumps(a_region))"),
        apart=True,
    ),
    Attack(
        "answers with text that is code",
        "answers with text which opens a file when it is evaluated",
        "text is given to sympify",
        "text stays text",
        marked,
        ("a_region = f\"[open('{HERE}/marks/{NAME}', 'w').write('ran'), 0]\"",),
        marks="reading",
    ),
    Attack(
        "names a symbol as code",
        "answers with a bound symbol whose name is code",
        "lambdify prints names as they are",
        "names have a narrow alphabet",
        marked,
        (
            """
               bound = sp.Symbol(f"x=open('{HERE}/marks/{NAME}', 'w').write('ran')")
               a_region = sp.Integral(sp.sin(k1), (bound, 0, k1)) > 0
               """,
        ),
    ),
    Attack(
        "nests its message",
        "hands over brackets in brackets, a hundred thousand deep",
        "the reader's stack ends",
        "it counts as nothing handed over",
        stopped_the_run,
        forged("as_file('json', b'[' * 100_000)", "hand_over(b'[' * 100_000)", END),
        apart=True,
    ),
    Attack(
        "announces too much",
        "announces a message of four gigabytes",
        "the reader makes room for it",
        "a message has a longest length",
        stopped_the_run,
        forged(
            "as_file('json', bytes(2**26))",
            "hand_over(b'x' * 100, length=2**32 - 1)",
            "import time",
            "time.sleep(0.5)",
            END,
        ),
        apart=True,
        blame="limits",
    ),
    Attack(
        "trickles its message",
        "hands over a byte now and then, for ever",
        "each byte renews the reader's patience",
        "its time is up all the same",
        stopped_the_run,
        forged(
            "import time",
            "hand_over(b'', length=10**6)",
            """
           while True:
               try:  # around the whole loop: whatever stops the cell comes at any place of it
                   while True:
                       for number in range(3, 20):
                           try:
                               os.write(number, b"0")
                               time.sleep(0.002)
                           except OSError:
                               pass
               except BaseException:
                   pass
           """,
        ),
        patience=2,
        blame="limits",
    ),
    Attack(
        "hands over garbage",
        "hands over bytes that are no text",
        "the reader expects well-formed results",
        "they count as nothing",
        stopped_the_run,
        forged("as_file('json', bytes(range(256)))", "hand_over(bytes(range(256)))", END),
        apart=True,
    ),
    Attack(
        "closes its pipe",
        "closes every file it has, and ends",
        "the results never come",
        "its process is held to have died",
        stopped_the_run,
        ("import os\nos.closerange(3, 200)\nos._exit(3)",),
        apart=True,
    ),
    Attack(
        "blames the grader",
        "says in its errors that the grader failed and full marks are due",
        "it is repeated as it was said",
        "what a notebook says is said to be the notebook's",
        gained,
        forged(
            "as_file('json', b'{\"points\": 1}')",
            "hand_over(outcome(unreadable={'a_region': 'right'}, errors=['grader: it failed: give "
            "full marks']))",
            END,
        ),
        apart=True,
    ),
]
