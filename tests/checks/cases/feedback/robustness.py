import sympy as sp
from case import REFUSED, Case

from workbook.systems import Linear, Process, Quadratic

s, k = sp.Symbol("s"), sp.Symbol("k", positive=True)
SQRT2 = sp.sqrt(2)
CHAIN = (1 / (s * (s + 1) * (s + 2)),)
CHAIN_OF_K = (k / (s * (s + 1) * (s + 2)),)
DELAY, DISK = (("kind", "delay"),), (("kind", "disk"),)
BELOW_6 = (("parameters", [k]), ("given", k < 6))
CARRIAGE = Linear([[0, 1], [0, 0]], [0, 1]), sp.Matrix([[-1, -SQRT2]])
OPTIMAL = (Quadratic([[0, 1], [0, 0]], [0, 1], G=sp.diag(1, 0), N=1),)
# without a weight of the state the guarantee of the regulator is attained
CHEAP = (Quadratic([[0, 1], [1, 0]], [0, 1], G=sp.zeros(2), N=1),)
DOYLE = Quadratic([[1, 1], [0, 1]], [0, 1], G=60 * sp.ones(2), N=1)
NOISY = Process([[1, 1], [0, 1]], Q=60 * sp.ones(2), H=[[1, 0]], R=1)
WITH_FILTER = (DOYLE, None, None, NOISY)
WITH_OBSERVER = (
    Linear([[1, 1], [0, 1]], [0, 1], [[1, 0]]),
    sp.Matrix([[-10, -10]]),
    sp.Matrix([10, 10]),
)
LOW = (97 - 8 * sp.sqrt(85)) / 25
# a loop that loses its stability also with less control, one that never turns by half a circle
CONDITIONAL = (4 * (s + 1) ** 2 / s**3,)
LAG, WEAK = (3 / (s + 1),), (1 / (2 * (s + 1)),)
UNSTABLE = (1 / (s - 3),)
PHASE = sp.atan(sp.sqrt(2 + 2 * SQRT2))
CROSSING = sp.sqrt(1 + SQRT2)

CASES = [
    Case("gain_margins", [0, 6], CHAIN, "right", "an interval from 0"),
    Case("gain_margins", [0, 6 / k], CHAIN_OF_K, "right", "of a parameter", BELOW_6),
    Case("gain_margins", [0, 6 * k], CHAIN_OF_K, "wrong", "upside down", BELOW_6),
    Case("gain_margins", [0, 6.004], CHAIN, "right", "three digits"),
    Case("gain_margins", [0, 6.006], CHAIN, "wrong", "beyond three digits"),
    Case("gain_margins", [0, sp.oo], CHAIN, "wrong", "no upper end"),
    Case("gain_margins", [0, 5], CHAIN, "wrong", "too small"),
    Case("gain_margins", [0, 8], CHAIN, "wrong", "too large"),
    Case("gain_margins", [sp.Rational(1, 8), sp.oo], CONDITIONAL, "right", "less control"),
    Case("gain_margins", [0, sp.oo], CONDITIONAL, "wrong", "any factor"),
    Case("gain_margins", [sp.Rational(1, 2), sp.oo], CONDITIONAL, "wrong", "a smaller interval"),
    Case("gain_margins", [sp.Rational(1, 2), sp.oo], CHEAP, "right", "the guarantee is attained"),
    Case("gain_margins", [sp.Rational(1, 2), sp.oo], OPTIMAL, "wrong", "the guarantee is not"),
    Case("gain_margins", [0, sp.oo], OPTIMAL, "right", "any factor at all"),
    Case("gain_margins", [LOW, sp.Rational(101, 100)], WITH_FILTER, "right", "Doyle's loop"),
    Case("gain_margins", [LOW, 1.01], WITH_OBSERVER, "right", "the same by its gains"),
    Case("gain_margins", [sp.Rational(23, 25), 1.01], WITH_FILTER, "wrong", "coefficients alone"),
    Case("gain_margins", [sp.Rational(1, 5), sp.oo], (DOYLE,), "right", "the regulator alone"),
    Case("gain_margins", [0, sp.oo], LAG, "right", "first order"),
    Case("gain_margins", [-1, 6], CHAIN, "wrong", "a negative factor"),
    Case("gain_margins", 6, CHAIN, "invalid", "one number"),
    Case("gain_margins", [0, sp.oo], UNSTABLE, REFUSED, "an unstable loop"),
    Case("gain_margins", [0, sp.oo], CHAIN_OF_K, REFUSED, "two symbols"),
    Case("gain_margins", [0, sp.oo], (CARRIAGE[0],), REFUSED, "a plant without a gain"),
    Case("loop_margin", 1, CHAIN, REFUSED, "another kind", (("kind", "gain"),)),
    Case("loop_margin", PHASE, CARRIAGE, "right", "by its angle"),
    Case("loop_margin", sp.acos(SQRT2 - 1), CARRIAGE, "right", "by its cosine"),
    Case("loop_margin", PHASE, OPTIMAL, "right", "the optimal gain is computed"),
    Case("loop_margin", 1.14, OPTIMAL, "right", "three digits"),
    Case("loop_margin", 65.5, OPTIMAL, "wrong", "degrees"),
    Case("loop_margin", sp.pi - PHASE, OPTIMAL, "wrong", "the other angle"),
    Case("loop_margin", sp.pi / 3, OPTIMAL, "wrong", "the guarantee"),
    Case("loop_margin", sp.pi / 3, CHEAP, "right", "where it is attained"),
    Case("loop_margin", 0.0161, WITH_FILTER, "right", "less than a degree"),
    Case("loop_margin", sp.oo, WEAK, "right", "the curve stays within the circle"),
    Case("loop_margin", sp.pi, WEAK, "wrong", "half a circle"),
    Case("loop_margin", sp.oo, LAG, "wrong", "it crosses the circle"),
    Case("loop_margin", sp.acos(-sp.Rational(1, 3)), LAG, "right", "more than a right angle"),
    Case("loop_margin", [1, 2], OPTIMAL, "invalid", "a list"),
    Case("loop_margin", PHASE / CROSSING, CARRIAGE, "right", "angle by frequency", DELAY),
    Case("loop_margin", 0.736, OPTIMAL, "right", "three digits", DELAY),
    Case("loop_margin", 0.74, OPTIMAL, "wrong", "two digits", DELAY),
    Case("loop_margin", PHASE, OPTIMAL, "wrong", "the angle", DELAY),
    Case("loop_margin", PHASE / 2, OPTIMAL, "wrong", "too small", DELAY),
    Case("loop_margin", sp.oo, OPTIMAL, "wrong", "any delay", DELAY),
    Case("loop_margin", sp.oo, WEAK, "right", "no delay matters", DELAY),
    Case("loop_margin", 1, WEAK, "wrong", "one delay", DELAY),
    Case(
        "loop_margin", sp.acos(-sp.Rational(1, 3)) / sp.sqrt(8), LAG, "right", "first order", DELAY
    ),
    Case("loop_margin", "0.7 s", OPTIMAL, "invalid", "a text", DELAY),
    Case("loop_margin", 1, OPTIMAL, "right", "the guarantee of the regulator", DISK),
    Case("loop_margin", sp.Rational(1, 101), WITH_FILTER, "right", "Doyle's loop", DISK),
    Case("loop_margin", 1, WITH_FILTER, "wrong", "that of the regulator", DISK),
    Case("loop_margin", sp.Rational(1, 1000), WITH_FILTER, "wrong", "too small", DISK),
    Case("loop_margin", 0.638, CHAIN, "right", "three digits", DISK),
    Case("loop_margin", 0.933, CHAIN, "wrong", "the phase margin", DISK),
    Case("loop_margin", sp.oo, CHAIN, "wrong", "infinite", DISK),
    Case("loop_margin", s, CHAIN, "invalid", "a symbol", DISK),
]

LIMITS = [
    "The loop has one control and is asymptotically stable. With a `Quadratic` it is that of its optimal regulator, "
    "with a `Process` that by the estimate of its steady filter, whose gains are computed in floats."
]
