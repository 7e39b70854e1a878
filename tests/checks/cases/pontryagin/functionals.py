import sympy as sp
from case import Case

from workbook.systems import Functional

t, T = sp.symbols("t T", positive=True)
x = sp.Function("x")
v = x(t).diff(t)
w = v.diff(t)
HALF = sp.Rational(1, 2)

GROWTH = Functional(v**2 + x(t) ** 2, x(t), (t, 0, 1), start=[1], final=-(x(1) ** 2))
ROOT = Functional(x(t) ** 2 * v**2, x(t), (t, 0, 1), start=[1], final=x(1) ** 2)
FALL = Functional(v**2 - x(t), x(t), (t, 0, T), start=[0], end=[2])
LOADED = Functional(t**2 * x(t) - v**2, x(t), (t, 0, 1), start=[0], end=[0], maximise=True)
BEAM = Functional(w**2 - 48 * x(t), x(t), (t, 0, 1), start=[0, 0])
TENSE = Functional(v**2 - x(t) ** 2, x(t), (t, 0, 5), start=[0], end=[0])
CHAIN = Functional(v**2 + 1, x(t), (t, 0, T), start=[0], end=[1])
PUSH = Functional(w**2 / 2, x(t), (t, 0, T), start=[0, 0], end=[6, 3])
PARABOLA = -(t**2) / 4 + (2 / T + T / 4) * t
BENT = t**4 - 4 * t**3 + 6 * t**2

CASES = [
    Case("extremum_motion", sp.exp(t), (GROWTH,), "right", "a free end with a cost"),
    Case(
        "extremum_motion", 2.718 ** sp.Symbol("t"), (GROWTH,), "right", "decimals, a plain symbol"
    ),
    Case(
        "extremum_motion", sp.sqrt(1 - t), (ROOT,), "right", "a velocity without bound at the end"
    ),
    Case("extremum_motion", PARABOLA, (FALL, [T]), "right", "with a parameter"),
    Case("extremum_motion", BENT, (BEAM,), "right", "second derivatives"),
    Case("extremum_motion", (t - t**4) / 24, (LOADED,), "right", "the greatest"),
    Case("extremum_motion", 2.745**t, (GROWTH,), "wrong", "decimals one per cent off"),
    Case("extremum_motion", sp.cosh(t), (GROWTH,), "wrong", "the natural condition forgotten"),
    Case(
        "extremum_motion",
        1 + (sp.E - 1) * t,
        (GROWTH,),
        "wrong",
        "both ends right, straight between",
    ),
    Case(
        "extremum_motion",
        sp.Piecewise((sp.exp(t), t < HALF), (sp.exp(t) + t - HALF, True)),
        (GROWTH,),
        "wrong",
        "a corner",
    ),
    Case("extremum_motion", sp.Integer(1), (ROOT,), "wrong", "at rest"),
    Case(
        "extremum_motion",
        sp.sqrt(1 - 2 * t),
        (ROOT,),
        "wrong",
        "no real number on a part of the way",
    ),
    Case(
        "extremum_motion",
        sp.Piecewise((sp.sqrt(1 - 2 * t), t < HALF), (0, True)),
        (ROOT,),
        "wrong",
        "stopped early",
    ),
    Case(
        "extremum_motion",
        -(t**2) / 4 + t,
        (FALL, [T]),
        "wrong",
        "right for one value of the parameter",
    ),
    Case("extremum_motion", BENT - t**2, (BEAM,), "wrong", "the natural condition of the velocity"),
    Case("extremum_motion", sp.Eq(x(t), sp.exp(t)), (GROWTH,), "invalid", "an equation"),
    Case("extremum_value", -1, (GROWTH,), "right", "a number"),
    Case("extremum_value", 0.25, (ROOT,), "right", "a decimal"),
    Case("extremum_value", 4 / T - T - T**3 / 48, (FALL, [T]), "right", "with a parameter"),
    Case("extremum_value", -1.1, (GROWTH,), "wrong", "less than there is"),
    Case("extremum_value", sp.Rational(1, 449), (LOADED,), "wrong", "less than the greatest"),
    Case("extremum_value", 4 / T - T, (FALL, [T]), "wrong", "a term lost"),
    Case("extremum_value", [1], (GROWTH,), "invalid", "a list"),
    Case("extremum_exists", "yes", (GROWTH,), "right", "convex for these ends"),
    Case("extremum_exists", False, (TENSE,), "right", "longer than half a period"),
    Case("extremum_exists", "no", (FALL, T), "right", "better and better with time"),
    Case("extremum_exists", "yes", (CHAIN, T), "right", "a best duration"),
    Case("extremum_exists", "no", (GROWTH,), "wrong", "convex for these ends"),
    Case("extremum_exists", "yes", (FALL, T), "wrong", "better and better with time"),
    Case("extremum_exists", "no", (CHAIN, T), "wrong", "a best duration"),
    Case("extremum_exists", 3, (GROWTH,), "invalid", "a number"),
    Case("stationary_duration", 6, (PUSH, T), "right", "an inflection"),
    Case("stationary_duration", 1, (CHAIN, T), "right", "a minimum"),
    Case("stationary_duration", 5.996, (PUSH, T), "right", "three digits at a double root"),
    Case("stationary_duration", 5.99, (PUSH, T), "wrong", "one less in the third digit"),
    Case("stationary_duration", 1.003, (CHAIN, T), "right", "three digits at a simple root"),
    Case("stationary_duration", 4, (PUSH, T), "wrong", "too early"),
    Case("stationary_duration", 1.05, (CHAIN, T), "wrong", "five percent late"),
    Case("stationary_duration", -1, (CHAIN, T), "wrong", "the other root"),
    Case("stationary_duration", T, (CHAIN, T), "invalid", "a symbol"),
]
LIMITS = [
    "A motion is varied in nine overlapping windows, as a whole, and at its free ends; with "
    "parameters for four sets of values.",
    "That there is a best motion is decided for integrands that are at most quadratic, on forty "
    "intervals; a best duration is looked for among fourteen from 0.2 to 80.",
    "A motion that is written with decimals may leave half a percent of the terms of the first "
    "variation.",
]
