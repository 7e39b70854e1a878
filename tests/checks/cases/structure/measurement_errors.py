import numpy as np
import sympy as sp
from case import Case

from workbook.systems import WithError

w, k, t = sp.symbols("omega k t", real=True)
z, z1, z2 = sp.symbols("z z1 z2", real=True)
FIRST = sp.Matrix([[1, 0]])
ONE, ZERO_RATE = sp.Matrix([[1]]), sp.Matrix([[0]])
# A body on a line, its place measured with a constant error: place and error are confused, the
# speed is found.
FREE = (WithError(sp.Matrix([[0, 1], [0, 0]]), H=FIRST, S=ZERO_RATE, c=ONE, start=[1]),)
# The same with an error e^t.
GROWING = (WithError(sp.Matrix([[0, 1], [0, 0]]), H=FIRST, S=ONE, c=ONE, start=[1]),)
# x1' = 4 x1, x2' = k x2 with z = x1 + x2 + C e^(4t)
MODES = (WithError(sp.diag(4, k), H=sp.Matrix([[1, 1]]), S=sp.Matrix([[4]]), c=ONE, start=[1]),)
# An oscillator of frequency 2 and an error C sin(omega t), then C cos(omega t).
SPRING, TURNING = sp.Matrix([[0, 2], [-2, 0]]), sp.Matrix([[0, w], [-w, 0]])
SINE = (WithError(SPRING, H=FIRST, S=TURNING, c=FIRST, start=[0, 1]),)
COSINE = (WithError(SPRING, H=FIRST, S=TURNING, c=FIRST, start=[1, 0]),)
# Two modes and an error C e^(kt)
DECAY = (WithError(sp.diag(-1, 3), H=sp.Matrix([[1, 2]]), S=sp.Matrix([[k]]), c=ONE, start=[1]),)
BOTH = sp.And(sp.Ne(w, 0), sp.Ne(w**2, 4))
PAIR = sp.diag(SPRING, TURNING)
RATE = sp.diag(SPRING, sp.Matrix([[0, 1], [-(w**2), 0]]))

CASES = [
    Case("observable", "no", FREE, "right", "the place and the error are confused"),
    Case("observable", True, GROWING, "right", "an exponential is no uniform motion"),
    Case("observable", True, FREE, "wrong", "rows of the state alone"),
    Case("observable", False, GROWING, "wrong", "an error thought to spoil all"),
    Case("observable", 2, FREE, "invalid", "a number"),
    Case("observable", ..., FREE, "missing", "the untouched stub"),
    Case("unobservable_states", [[1, 0, -1]], FREE, "right", "a place hidden by an error"),
    Case("unobservable_states", [-2.0, 0, 2.0], FREE, "right", "floats, without the outer list"),
    Case("unobservable_states", [], GROWING, "right", "none"),
    Case("unobservable_states", [[1, 0, 1]], FREE, "wrong", "the sign of the error"),
    Case("unobservable_states", [[0, 0, 1]], FREE, "wrong", "the error alone"),
    Case("unobservable_states", [[1, 0, -1], [2, 0, -2]], FREE, "wrong", "one vector twice"),
    Case("unobservable_states", [[0, 0, 0]], FREE, "wrong", "zero"),
    Case("unobservable_states", [], FREE, "wrong", "none where there is one"),
    Case("unobservable_states", [[1, 0, -1]], GROWING, "wrong", "one where there is none"),
    Case("unobservable_states", [[1, 0]], FREE, "invalid", "without the error"),
    Case("unobservable_states", [[sp.nan, 0, -1]], FREE, "invalid", "an undefined component"),
    Case(
        "observable_parameters",
        BOTH,
        (*SINE, [w]),
        "right",
        "the resonance and the error that is not there",
    ),
    Case(
        "observable_parameters",
        sp.Ne(sp.Abs(w), 2),
        (*COSINE, [w]),
        "right",
        "a cosine does not vanish at zero frequency",
    ),
    Case(
        "observable_parameters",
        sp.And(sp.Ne(k, -1), sp.Ne(k, 3)),
        (*DECAY, [k]),
        "right",
        "the two rates of the motion",
    ),
    Case(
        "observable_parameters", sp.Ne(w**2, 4), (*SINE, [w]), "wrong", "zero frequency overlooked"
    ),
    Case(
        "observable_parameters",
        BOTH,
        (*COSINE, [w]),
        "wrong",
        "zero frequency excluded for a cosine",
    ),
    Case(
        "observable_parameters",
        sp.And(BOTH, sp.Ne(w, sp.sqrt(2))),
        (*SINE, [w]),
        "wrong",
        "an irrational value too many",
    ),
    Case("observable_parameters", k < -1, (*DECAY, [k]), "wrong", "errors that decay faster alone"),
    Case("observable_parameters", w + 1, (*SINE, [w]), "invalid", "no condition"),
    Case(
        "observable_parameters",
        sp.Ne(w**2, 4),
        (*SINE, [w], "state"),
        "right",
        "the state is found where the error vanishes",
    ),
    Case("observable_parameters", sp.false, (*MODES, [k], "state"), "right", "for no value"),
    Case(
        "observable_parameters",
        BOTH,
        (*SINE, [w], "state"),
        "wrong",
        "what holds for both together",
    ),
    Case(
        "observable_parameters", sp.true, (*SINE, [w], "state"), "wrong", "the resonance overlooked"
    ),
    Case("observable_parameters", 3, (*SINE, [w], "state"), "invalid", "a number"),
    Case(
        "observable_parameters",
        BOTH,
        (*SINE, [w], "error"),
        "right",
        "neither at the resonance nor at zero",
    ),
    Case("observable_parameters", sp.Ne(w**2, 4), (*COSINE, [w], "error"), "right", "a cosine"),
    Case(
        "observable_parameters", sp.Ne(w**2, 4), (*SINE, [w], "error"), "wrong", "zero overlooked"
    ),
    Case(
        "observable_parameters",
        sp.Ne(w, 0),
        (*SINE, [w], "error"),
        "wrong",
        "the resonance overlooked",
    ),
    Case("observable_parameters", "always", (*SINE, [w], "error"), "invalid", "a word"),
    Case(
        "unobservable_states_at",
        {0: [[0, 0, 1]], 2: [[0, 1, -1]], -2: [[0, 1, 1]]},
        (*SINE, w),
        "right",
        "three values",
    ),
    Case(
        "unobservable_states_at",
        {2.0: [1, 0, -1.0], -2.0: [sp.Matrix([2, 0, -2])]},
        (*COSINE, w),
        "right",
        "floats and columns",
    ),
    Case(
        "unobservable_states_at",
        {2: [[0, 1, -1]], -2: [[0, 1, 1]]},
        (*SINE, w),
        "wrong",
        "a value forgotten",
    ),
    Case(
        "unobservable_states_at",
        {0: [[0, 0, 1]], 2: [[0, 1, -1], [1, 0, 0]], -2: [[0, 1, 1]]},
        (*SINE, w),
        "wrong",
        "as if the phase of the error were free",
    ),
    Case(
        "unobservable_states_at",
        {2: [[1, 0, -1]], -2: [[1, 0, -1]], 0: [[0, 0, 1]]},
        (*COSINE, w),
        "wrong",
        "a value too many",
    ),
    Case(
        "unobservable_states_at",
        {2: [[1, 0, -1]], sp.Float("2.001"): [[1, 0, -1]], -2: [[1, 0, -1]]},
        (*COSINE, w),
        "wrong",
        "one value twice",
    ),
    Case("unobservable_states_at", [[0, 0, 1]], (*SINE, w), "invalid", "without the values"),
    Case(
        "augmented_system",
        [PAIR, sp.Matrix([[1, 0, 1, 0]])],
        (*SINE, [w]),
        "right",
        "sine and cosine",
    ),
    Case(
        "augmented_system",
        [RATE, [1, 0, 3, 0]],
        (*SINE, [w]),
        "right",
        "a third of the error and its rate, the row flat",
    ),
    Case(
        "augmented_system",
        [[[0, 1, 0], [0, 0, 0], [0, 0, 0]], [[1, 0, -1]]],
        FREE,
        "right",
        "the error with the other sign",
    ),
    Case(
        "augmented_system",
        (np.diag([-1.0, 3.0, 0]), np.array([[1, 2, 1]])),
        (DECAY[0].subs(k, 0),),
        "right",
        "arrays",
    ),
    Case(
        "augmented_system",
        [PAIR, np.array([1.0, 0, 1, 0])],
        (*SINE, [w]),
        "right",
        "a row as an array",
    ),
    Case(
        "augmented_system",
        [PAIR, sp.Matrix([1, 0, 1, 0])],
        (*SINE, [w]),
        "right",
        "a row written as a column",
    ),
    Case(
        "augmented_system",
        [PAIR, sp.Matrix([[1, 0, 0, 0]])],
        (*SINE, [w]),
        "wrong",
        "no error in z",
    ),
    Case(
        "augmented_system",
        [sp.diag(SPRING, w), sp.Matrix([[1, 0, 1]])],
        (*SINE, [w]),
        "wrong",
        "one coordinate for a sine",
    ),
    Case(
        "augmented_system",
        [sp.diag(PAIR, 0), sp.Matrix([[1, 0, 1, 0, 0]])],
        (*SINE, [w]),
        "wrong",
        "a coordinate that is not needed",
    ),
    Case(
        "augmented_system",
        [PAIR.T, sp.Matrix([[1, 0, 1, 0]])],
        (*SINE, [w]),
        "wrong",
        "the motion transposed",
    ),
    Case(
        "augmented_system",
        [sp.Matrix([[0, 1, 1], [0, 0, 0], [0, 0, 0]]), sp.Matrix([[1, 0, 1]])],
        FREE,
        "wrong",
        "an error that pushes",
    ),
    Case(
        "augmented_system",
        [sp.Matrix([[0, 1, 0], [0, 0, 0], [1, 0, 0]]), sp.Matrix([[1, 0, 1]])],
        FREE,
        "wrong",
        "a motion that makes errors",
    ),
    Case(
        "augmented_system",
        [sp.diag(FREE[0].A, 1), sp.Matrix([[1, 0, 1]])],
        FREE,
        "wrong",
        "a growing error for a constant",
    ),
    Case(
        "augmented_system",
        [sp.diag(FREE[0].A, 0.01), sp.Matrix([[1.0, 0, 1]])],
        FREE,
        "wrong",
        "an error that grows slowly, in decimals",
    ),
    Case(
        "augmented_system",
        [sp.diag(FREE[0].A, 0), sp.Matrix([[2, 0, 1]])],
        FREE,
        "wrong",
        "another output of the motion",
    ),
    Case("augmented_system", [FREE[0].A, FIRST], FREE, "invalid", "nothing added"),
    Case("augmented_system", sp.diag(FREE[0].A, 0), FREE, "invalid", "without the output"),
    Case(
        "augmented_system",
        [sp.diag(FREE[0].A, 0), sp.Matrix([[1, 0]])],
        FREE,
        "invalid",
        "an output of the motion alone",
    ),
    Case(
        "augmented_system",
        [sp.diag(FREE[0].A, sp.nan), sp.Matrix([[1, 0, 1]])],
        FREE,
        "invalid",
        "an undefined entry",
    ),
    Case(
        "amplitude_from_output",
        z2 * sp.exp(-t),
        (*GROWING, [z, z1, z2], t),
        "right",
        "the second derivative sees the error alone",
    ),
    Case(
        "amplitude_from_output",
        z2 / sp.exp(t) + 0 * z,
        (*GROWING, [z, z1, z2], t),
        "right",
        "another form",
    ),
    Case("amplitude_from_output", z2, (*GROWING, [z, z1, z2], t), "wrong", "its growth forgotten"),
    Case(
        "amplitude_from_output",
        z2 - z,
        (*GROWING, [z, z1, z2], t),
        "wrong",
        "a combination that keeps the motion",
    ),
    Case(
        "amplitude_from_output",
        sp.Piecewise((z2 * sp.exp(-t), z > 0)),
        (*GROWING, [z, z1, z2], t),
        "wrong",
        "undefined for half of all",
    ),
    Case("amplitude_from_output", k, (*GROWING, [z, z1, z2], t), "invalid", "a foreign symbol"),
]
LIMITS = [
    "The start of the error for C = 1 has to be rational, and so have the exceptional values of a "
    "parameter: matters of the problem."
]
