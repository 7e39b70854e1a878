"""Submissions that end processes: their own, the grader's, or all."""

from hostile.attack import WRONG, Attack, gained, graded_twice, harmed_others, stopped_the_run

ENDINGS = [
    Attack(
        "exits",
        "calls sys.exit",
        "the grader that runs the cell exits",
        "only the cell ends",
        stopped_the_run,
        ("import sys\nsys.exit(0)", WRONG),
    ),
    Attack(
        "exits at once",
        "calls os._exit",
        "the grader that runs the cell exits",
        "only its own process ends",
        harmed_others,
        ("import os\nos._exit(0)", WRONG),
    ),
    Attack(
        "exits with marks",
        "writes a result file and exits before the real one is written",
        "an exit code of 0 counts as success",
        "results are never taken from a file",
        gained,
        (
            "import os\nopen(HERE + '/graded/' + NAME + '.json', 'w').write('{\"points\": "
            "1}')\nos._exit(0)",
        ),
        apart=True,
    ),
    Attack(
        "kills its parent",
        "sends SIGKILL to the process that started it",
        "it has the same user",
        "its parent cannot be named from inside",
        stopped_the_run,
        ("import os, signal\nos.kill(os.getppid(), signal.SIGKILL)", WRONG),
        apart=True,
    ),
    Attack(
        "kills its group",
        "sends SIGKILL to its process group",
        "the grader is in it",
        "it is alone in its session",
        stopped_the_run,
        ("import os, signal\nos.killpg(0, signal.SIGKILL)", WRONG),
        apart=True,
    ),
    Attack(
        "stops its parent",
        "sends SIGSTOP to the process that started it",
        "it waits for ever",
        "its parent cannot be named from inside",
        stopped_the_run,
        ("import os, signal\nos.kill(os.getppid(), signal.SIGSTOP)", WRONG),
        apart=True,
        patience=3,
    ),
    Attack(
        "sets an alarm",
        "asks for a signal that kills the process a little later",
        "by then another student is being marked",
        "only its own process could die of it",
        stopped_the_run,
        ("import signal\nsignal.setitimer(signal.ITIMER_REAL, 0.02)", WRONG),
    ),
    Attack(
        "has the kernel kill it",
        "lowers its own limit on computing and goes past it",
        "the kernel kills the grader that runs the cell",
        "limits are the grader's to set",
        stopped_the_run,
        (
            """
               import resource
               try:
                   resource.setrlimit(resource.RLIMIT_CPU, (1, 1))
               finally:
                   for _ in range(10**8): pass
               """,
            WRONG,
        ),
        blame="limits",
    ),
    Attack(
        "ignores signals",
        "ignores whatever asks it to end, and goes on",
        "asking politely does not end it",
        "it is not asked",
        stopped_the_run,
        (
            """
        import signal, time
        for number in range(1, 65):
            try:
                signal.signal(number, signal.SIG_IGN)
            except (OSError, ValueError):
                pass
        while True: time.sleep(1)
        """,
            WRONG,
        ),
        patience=2,
        blame="limits",
    ),
    Attack(
        "doubles itself",
        "forks and lets both go on",
        "both write results",
        "one of them is heard",
        graded_twice,
        ("import os\nos.fork()", WRONG),
    ),
    Attack(
        "crashes",
        "reads from address zero",
        "the grader that runs the cell crashes",
        "only its own process crashes",
        stopped_the_run,
        ("import ctypes\nctypes.string_at(0)", WRONG),
    ),
    Attack(
        "raises what cannot be told",
        "raises an exception whose text is an error, and one with half a character",
        "writing the report fails",
        "the error is told without asking it",
        stopped_the_run,
        (
            """
               class Untold(BaseException):
                   def __str__(self): raise SystemExit
                   __repr__ = __str__
               raise Untold
               """,
            "raise ValueError('\\ud800')",
            WRONG,
        ),
    ),
]
