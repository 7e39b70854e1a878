import numpy as np
import sympy as sp
from case import Case

from workbook.systems import Linear, WithError

lam, b1, b2, a, p = *sp.symbols("lambda beta1 beta2 a", real=True), sp.symbols("p", positive=True)
M = sp.Matrix
# x1' = x2, x2' = 4 x1 + u
SADDLE, PUSH, PLACE = M([[0, 1], [4, 0]]), M([0, 1]), M([[1, 0]])
# its output 2 x1 + x2 does not show e^(-2t), its output 2 x1 - x2 not e^(2t)
HIDES_DECAY, HIDES_GROWTH = M([[2, 1]]), M([[2, -1]])
WANTED = {"parameters": [b1, b2], "polynomial": lam**2 + b1 * lam + b2, "symbol": lam}
FIXED = {"polynomial": (lam + 2) * (lam + 5), "symbol": lam}
BY_PLACE, PUSHED = (Linear(SADDLE, H=PLACE),), (Linear(SADDLE, PUSH),)
WITHOUT_DECAY, WITHOUT_GROWTH = (Linear(SADDLE, H=HIDES_DECAY),), (Linear(SADDLE, H=HIDES_GROWTH),)
OF_A = (Linear(M([[0, 1], [a, 0]]), H=PLACE),)
APART, TOGETHER = (
    (Linear(M([[0, 0], [0, -1]]), M([1, 0])),),
    (Linear(M([[1, -2], [a, -2]]), M([1, 0])),),
)
UNSTABLE = M([[0, 1], [-2, 3]])
STATIC, STATIC_PLACE = (Linear(UNSTABLE, PUSH, M([[1, 1]])),), (Linear(UNSTABLE, PUSH, PLACE),)
LOOP = (Linear(SADDLE, PUSH, PLACE),)
BIASED = (WithError(SADDLE, PUSH, PLACE, S=M([[0]]), c=M([[1]])),)


def row(check, answer, data, verdict, note, **options):
    return Case(check, answer, data, verdict, note, tuple(options.items()))


CASES = [
    row("observer_gain", [3, 7], BY_PLACE, "right", "a flat list"),
    row(
        "observer_gain",
        M([[1, 4.001]]),
        BY_PLACE,
        "right",
        "another gain, lying down, close to the border",
    ),
    row("observer_gain", M([b1, b2 + 4]), BY_PLACE, "right", "a polynomial with symbols", **WANTED),
    row("observer_gain", M([7, 14]), BY_PLACE, "right", "a polynomial of numbers", **FIXED),
    row("observer_gain", [7.0, 14.0], BY_PLACE, "right", "decimals", **FIXED),
    row("observer_gain", [1.75, 1.75], WITHOUT_DECAY, "wrong", "half of what is needed", **FIXED),
    row(
        "observer_gain", M([0, 7]), WITHOUT_DECAY, "right", "one of many for a hidden mode", **FIXED
    ),
    row("observer_gain", M([3, 1]), WITHOUT_DECAY, "right", "another one of them", **FIXED),
    row("observer_gain", [4, 8], BY_PLACE, "right", "the degree exactly, a double root", degree=2),
    row(
        "observer_gain",
        [0, 4, 14],
        (Linear(M([[0, 1, 0], [0, 0, 1], [-3, 1, 3]]), H=M([[2, 2, 0]])),),
        "right",
        "the margin of a mode that is fixed",
        degree=1,
    ),
    row(
        "observer_gain",
        M([4.0, 8.01]),
        BY_PLACE,
        "right",
        "the margin within three digits",
        degree=2,
    ),
    row("observer_gain", [], WITHOUT_GROWTH, "right", "there is none"),
    row("observer_gain", [], WITHOUT_DECAY, "right", "none has this degree", degree=3),
    row("observer_gain", [], WITHOUT_DECAY, "right", "not every polynomial", **WANTED),
    row("observer_gain", M([]), WITHOUT_DECAY, "right", "an empty matrix", **WANTED),
    row("observer_gain", np.array([]), WITHOUT_DECAY, "right", "an empty array", **WANTED),
    row("observer_gain", M([]), BY_PLACE, "wrong", "an empty matrix, and there is one"),
    row(
        "observer_gain",
        [p + 1, p + 5],
        BY_PLACE,
        "right",
        "for all values of a parameter",
        parameters=[p],
    ),
    row("observer_gain", [1, a + 1], OF_A, "right", "a parameter of the system", parameters=[a]),
    row("observer_gain", [0, 7], BY_PLACE, "wrong", "an oscillation of the error"),
    row("observer_gain", [3, 4], BY_PLACE, "wrong", "a zero eigenvalue"),
    row("observer_gain", [-3, -7], BY_PLACE, "wrong", "the sign of u = Kx"),
    row("observer_gain", M([b1, b2]), BY_PLACE, "wrong", "the system forgotten", **WANTED),
    row("observer_gain", M([14, 7]), BY_PLACE, "wrong", "the entries exchanged", **FIXED),
    row("observer_gain", [4, 7], BY_PLACE, "wrong", "short of the degree", degree=2),
    row("observer_gain", [3, 7], WITHOUT_GROWTH, "wrong", "there is none"),
    row("observer_gain", [], BY_PLACE, "wrong", "there are many"),
    row(
        "observer_gain",
        [p, p - 5],
        BY_PLACE,
        "wrong",
        "for some values of a parameter",
        parameters=[p],
    ),
    row(
        "observer_gain",
        [1, 1 / a + 1],
        OF_A,
        "wrong",
        "a gain without a value at a = 0",
        parameters=[a],
    ),
    row("observer_gain", [sp.I, 7], BY_PLACE, "wrong", "not real"),
    row("observer_gain", [sp.oo, 7], BY_PLACE, "wrong", "infinite"),
    row("observer_gain", [3, 7, 1], BY_PLACE, "invalid", "three entries"),
    row("observer_gain", 3, BY_PLACE, "invalid", "a number"),
    row("observer_gain", [sp.Symbol("q"), 7], BY_PLACE, "invalid", "a foreign symbol"),
    row("feedback_gain", [-5, -1], PUSHED, "right", "a flat list"),
    row("feedback_gain", M([[-14, -7]]), PUSHED, "right", "a polynomial", **FIXED),
    row("feedback_gain", M([-4 - b2, -b1]), PUSHED, "right", "upright, in symbols", **WANTED),
    row("feedback_gain", [-4], STATIC, "right", "static"),
    row("feedback_gain", [], STATIC_PLACE, "right", "no static feedback of the place will do"),
    row(
        "feedback_gain",
        [],
        (Linear(sp.diag(1, -1), M([0, 1])),),
        "right",
        "a growing mode uncontrollable",
    ),
    row(
        "feedback_gain",
        [1 / (a - 1) - 2, 0],
        APART,
        "wrong",
        "not for all a in between",
        parameters=[a],
        given=sp.Ne(a, 1),
    ),
    row(
        "feedback_gain",
        [-1 - 1 / (a - 1) ** 2, 0],
        APART,
        "right",
        "but where it is asked",
        parameters=[a],
        given=sp.Ne(a, 1),
    ),
    row("feedback_gain", [5, 1], PUSHED, "wrong", "u = -Kx"),
    row("feedback_gain", [-3], STATIC, "wrong", "on the border"),
    row("feedback_gain", [], STATIC, "wrong", "there is one"),
    row(
        "feedback_gain",
        [],
        (Linear(M([[0, 1], [p, 0]]), PUSH, PLACE),),
        "right",
        "none of the place, for any p",
        parameters=[p],
    ),
    row(
        "feedback_gain",
        [],
        (Linear(M([[0, 1], [-p, 3]]), PUSH, M([[1, 1]])),),
        "wrong",
        "there is one for every p",
        parameters=[p],
    ),
    row(
        "feedback_gain",
        [-2, 2 - 1 / a],
        TOGETHER,
        "wrong",
        "a pole that the spectrum hides",
        parameters=[a],
    ),
    row(
        "feedback_gain",
        [-2 - 3 * sp.Abs(a), 2],
        TOGETHER,
        "right",
        "with a modulus",
        parameters=[a],
    ),
    row(
        "feedback_gain",
        [3 * sp.Abs(a) - 2, 2],
        TOGETHER,
        "wrong",
        "the same, growing",
        parameters=[a],
    ),
    row("feedback_gain", [-5, -1, 0], PUSHED, "invalid", "three entries"),
    row("observer_feedback_gains", [[-5, -1], [3, 7]], LOOP, "right", "lists"),
    row(
        "observer_feedback_gains",
        [M([[-13, -6]]), M([9, 40])],
        LOOP,
        "right",
        "a degree of stability",
        degree=2,
    ),
    row(
        "observer_feedback_gains",
        [[-5, -1], [3, 8, 1]],
        BIASED,
        "wrong",
        "the sign of the correction of the error",
    ),
    row(
        "observer_feedback_gains",
        [[-5, -1], [10, 15, -4]],
        BIASED,
        "right",
        "the error of the measurement estimated too",
    ),
    row(
        "observer_feedback_gains",
        [],
        (Linear(SADDLE, PUSH, HIDES_GROWTH),),
        "right",
        "nothing to be done",
    ),
    row("observer_feedback_gains", [[3, 7], [-5, -1]], LOOP, "wrong", "exchanged"),
    row("observer_feedback_gains", [[-5, -1], [3, 2]], LOOP, "wrong", "the observer diverges"),
    row("observer_feedback_gains", [[-3, -1], [3, 7]], LOOP, "wrong", "the feedback is too weak"),
    row("observer_feedback_gains", [], LOOP, "wrong", "there are many"),
    row("observer_feedback_gains", [[-5, -1]], LOOP, "invalid", "one gain"),
    row("observer_feedback_gains", [[-5, -1], [3, 7]], BIASED, "invalid", "without the error"),
]

LIMITS = [
    "Where a margin is asked for, each decimal of a gain may shift the spectrum by what half a "
    "unit of its third digit does.",
    "That no static feedback stabilises is decided for few entries; with many it is tried at "
    "points.",
]
