"""Submissions with numbers and expressions that break a judge or are accepted by mistake."""

from hostile.attack import Attack, gained, stopped_the_run

FIGURES = [
    Attack(
        "is no number",
        "answers with NaN",
        "`abs(answer - key) > tolerance` is False for NaN",
        "NaN is no answer",
        gained,
        (
            """
        a_region = float("nan")
        b_region = sp.nan
        c_region = [float("nan")]*3
        d_region = sp.Eq(k1, sp.nan, evaluate=False)
        e_region = sp.Matrix([sp.nan])
        """,
        ),
        marks="number",
    ),
    Attack(
        "is infinite",
        "answers with infinity",
        "infinity over infinity is NaN, which passes",
        "infinity is no answer",
        gained,
        (
            """
        a_region = float("inf")
        b_region = sp.oo
        c_region = -sp.oo
        d_region = sp.Gt(k1, -sp.oo, evaluate=False)
        e_region = sp.Gt(sp.zoo, k1, evaluate=False)
        """,
        ),
        marks="ratio",
    ),
    Attack(
        "is a huge integer",
        "answers with an integer of a million digits",
        "writing it down fails",
        "digits are bounded",
        stopped_the_run,
        ("a_region = 10**1_000_000",),
    ),
    Attack(
        "is deeply nested",
        "answers with an expression nested ten thousand deep",
        "printing it uses up the stack",
        "depth is bounded",
        stopped_the_run,
        (
            """
               a_region = k1
               for _ in range(10_000):
                   a_region = sp.sin(a_region, evaluate=False)
               """,
        ),
        marks="key",
    ),
    Attack(
        "is a tower of powers",
        "answers with a number that is small to write and impossible to compute",
        "the check computes it",
        "magnitude is bounded",
        stopped_the_run,
        (
            "a_region = sp.Gt(k1, sp.Pow(10, sp.Pow(10, 9, evaluate=False), evaluate=False), "
            "evaluate=False)",
        ),
        patience=4,
        blame="",
    ),
    Attack(
        "explodes when it is expanded",
        "answers with a condition of a few symbols which the check expands without end",
        "the check has no limit",
        "judging has a limit, and only this answer is unchecked",
        stopped_the_run,
        ("a_region = (1 + k1 + k2)**1500 * (2 + k1 - k2)**1500 * (3 + 2*k1 + k2)**1500 > 0",),
        patience=4,
        blame="",
    ),
    Attack(
        "explodes when it is put together",
        "answers with a sum of fractions whose common denominator is enormous",
        "the check has no limit",
        "judging has a limit, and only this answer is unchecked",
        stopped_the_run,
        ("a_region = sum((k1 + n)/(k2**n + n*k1 + 1)**20 for n in range(1, 40)) > 0",),
        patience=4,
        blame="",
    ),
]
