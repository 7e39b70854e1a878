import sympy as sp
from case import Case

from workbook.systems import Linear, WithError

mu, a = sp.symbols("mu", positive=True), sp.symbols("a", real=True)
k1, k2 = sp.symbols("k1 k2", real=True)
M = sp.Matrix
SADDLE, PUSH, PLACE = M([[0, 1], [4, 0]]), M([0, 1]), M([[1, 0]])
HIDES_DECAY, HIDES_GROWTH = M([[2, 1]]), M([[2, -1]])
# u moves the growing mode (1, 2) alone, then the decaying one
ALONG_GROWTH, ALONG_DECAY = M([1, 2]), M([1, -2])
SPIRAL = sp.diag(3, M([[-1, 2], [-2, -1]]))
UPRIGHT, FLAT = M([k1, k2]), M([[k1, k2]])
STATIC = (Linear(M([[0, 1], [-2, 3]]), PUSH, M([[1, 1]])), M([[k1]]), [k1])
# at a = 0 the control does not reach the mode e^(-2t), at a = 1 not e^(t)
OF_A = (Linear(sp.diag(1, -2), M([a - 1, a])), mu, [a])
BY_PLACE, WITHOUT_DECAY, WITHOUT_GROWTH = (
    Linear(SADDLE, H=row) for row in (PLACE, HIDES_DECAY, HIDES_GROWTH)
)
PUSHED, GROWTH_MOVED, DECAY_MOVED = (
    Linear(SADDLE, column) for column in (PUSH, ALONG_GROWTH, ALONG_DECAY)
)
LOOP, EQUAL = Linear(SADDLE, PUSH, PLACE), Linear(sp.eye(2), H=M([[1, a]]))
CONSTANT = {"S": M([[0]]), "c": M([[1]])}
ERRING, CONFUSED = (
    WithError(SADDLE, PUSH, PLACE, **CONSTANT),
    WithError(M([[0, 1], [0, -1]]), PUSH, PLACE, **CONSTANT),
)
# z = x + a x' of x'' = x hides e^(-t) at a = 1 and e^t at a = -1
SEEN_BY_A = (Linear(M([[0, 1], [1, 0]]), H=M([[1, a]])), mu, [a])

CASES = [
    Case("gain_region", (k1 > 0) & (k2 > 4), (BY_PLACE, UPRIGHT, [k1, k2]), "right", "Hurwitz"),
    Case(
        "gain_region",
        sp.And(k1 > 0, k2 - 4 > 0),
        (BY_PLACE, UPRIGHT, [k1, k2]),
        "right",
        "another form",
    ),
    Case("gain_region", sp.false, (WITHOUT_GROWTH, UPRIGHT, [k1, k2]), "right", "never"),
    Case(
        "gain_region",
        (k1 > 0) & (k2 > 0),
        (BY_PLACE, UPRIGHT, [k1, k2]),
        "wrong",
        "the system forgotten",
    ),
    Case("gain_region", (k1 < 0) & (k2 < -4), (BY_PLACE, UPRIGHT, [k1, k2]), "wrong", "signs"),
    Case("gain_region", k1 + k2, (BY_PLACE, UPRIGHT, [k1, k2]), "invalid", "no condition"),
    Case(
        "gain_region", (k1 < -4) & (k2 < 0), (PUSHED, FLAT, [k1, k2]), "right", "a plane of gains"
    ),
    Case("gain_region", k1 < -3, STATIC, "right", "a static feedback"),
    Case("gain_region", k1 < 2, STATIC, "wrong", "the last coefficient alone"),
    Case("gain_region", (k1 > 4) & (k2 > 0), (PUSHED, FLAT, [k1, k2]), "wrong", "u = -Kx"),
    Case("gain_region", "all", STATIC, "invalid", "a word"),
    Case("possible_degrees", sp.true, (BY_PLACE, mu), "right", "every degree"),
    Case("possible_degrees", mu > 0, (BY_PLACE, mu), "right", "the same as a condition"),
    Case(
        "possible_degrees",
        mu <= 2,
        (WITHOUT_DECAY, mu),
        "right",
        "a hidden mode, its own degree included",
    ),
    Case("possible_degrees", sp.false, (WITHOUT_GROWTH, mu), "right", "none at all"),
    Case("possible_degrees", mu < 2, (WITHOUT_DECAY, mu), "wrong", "its own degree left out"),
    Case("possible_degrees", sp.true, (WITHOUT_DECAY, mu), "wrong", "the hidden mode overlooked"),
    Case("possible_degrees", mu <= 2, (BY_PLACE, mu), "wrong", "the degree of the free motion"),
    Case("possible_degrees", 2, (WITHOUT_DECAY, mu), "invalid", "a number"),
    Case("possible_degrees", mu <= 2.004, (GROWTH_MOVED, mu), "right", "a border in decimals"),
    Case("possible_degrees", mu < 2.004, (GROWTH_MOVED, mu), "wrong", "it belongs to the set"),
    Case("possible_degrees", mu <= 2.006, (GROWTH_MOVED, mu), "wrong", "beyond three digits"),
    Case("possible_degrees", mu <= 2, (GROWTH_MOVED, mu), "right", "a fixed mode that decays"),
    Case(
        "possible_degrees", mu <= 1, (Linear(SPIRAL, M([1, 0, 0])), mu), "right", "a pair of them"
    ),
    Case("possible_degrees", sp.false, (DECAY_MOVED, mu), "right", "a growing one"),
    Case("possible_degrees", mu <= 2, (DECAY_MOVED, mu), "wrong", "the wrong mode"),
    Case("possible_degrees", mu >= 2, (GROWTH_MOVED, mu), "wrong", "the other side"),
    Case(
        "possible_degrees",
        sp.Ne(a, 1) & (sp.Ne(a, 0) | (mu <= 2)),
        OF_A,
        "right",
        "exceptional values",
    ),
    Case(
        "possible_degrees",
        sp.Ne(a, 1) & sp.Or(a > 0, a < 0, mu - 2 <= 0),
        OF_A,
        "right",
        "in another form",
    ),
    Case(
        "possible_degrees", sp.Ne(a, 1) & sp.Ne(a, 0), OF_A, "wrong", "a mode that decays refused"
    ),
    Case(
        "possible_degrees",
        sp.Ne(a, 1) & (sp.Ne(a, 0) | (mu < 2)),
        OF_A,
        "wrong",
        "the greatest degree left out",
    ),
    Case(
        "possible_degrees",
        sp.Ne(a, 1) & (sp.Ne(a, 0) | (mu <= 2)) & sp.Ne(a**3, 2),
        OF_A,
        "wrong",
        "one irrational value left out",
    ),
    Case("possible_degrees", sp.Ne(a, 0) | (mu <= 2), OF_A, "wrong", "a growing mode overlooked"),
    Case("possible_degrees", sp.true, OF_A, "wrong", "all overlooked"),
    Case("possible_degrees", ["2"], (GROWTH_MOVED, mu), "invalid", "a word"),
    Case(
        "possible_degrees",
        mu <= 2,
        (Linear(SADDLE, PUSH, HIDES_DECAY), mu),
        "right",
        "the observer sets the limit",
    ),
    Case("possible_degrees", sp.true, (LOOP, mu), "right", "no limit"),
    Case(
        "possible_degrees",
        sp.false,
        (Linear(SADDLE, PUSH, HIDES_GROWTH), mu),
        "right",
        "no observer",
    ),
    Case("possible_degrees", sp.true, (ERRING, mu), "right", "an error that is seen"),
    Case("possible_degrees", sp.false, (CONFUSED, mu), "right", "an error that is not"),
    Case(
        "possible_degrees",
        sp.true,
        (Linear(SADDLE, PUSH, HIDES_DECAY), mu),
        "wrong",
        "the control alone looked at",
    ),
    Case(
        "possible_degrees",
        mu <= 2,
        (Linear(SADDLE, ALONG_DECAY, HIDES_DECAY), mu),
        "wrong",
        "the output alone looked at",
    ),
    Case("possible_degrees", mu, (LOOP, mu), "invalid", "no condition"),
    Case(
        "possible_degrees",
        sp.Ne(a, -1) & (sp.Ne(a, 1) | (mu <= 1)),
        SEEN_BY_A,
        "right",
        "exceptional values",
    ),
    Case(
        "possible_degrees",
        sp.Ne(a, -1) & sp.Ne(a, 1),
        SEEN_BY_A,
        "wrong",
        "a mode that decays refused",
    ),
    Case("undetectable_mode", {2: [1, 2]}, (WITHOUT_GROWTH,), "right", "the growing mode"),
    Case(
        "undetectable_mode", {2.0: M([0.5, 1.0])}, (WITHOUT_GROWTH,), "right", "decimals, a column"
    ),
    Case("undetectable_mode", {}, (WITHOUT_DECAY,), "right", "the hidden mode decays"),
    Case(
        "undetectable_mode", {1: [-a, 1]}, (EQUAL, [a]), "right", "for every value of a parameter"
    ),
    Case("undetectable_mode", {-2: [1, -2]}, (WITHOUT_DECAY,), "wrong", "a mode that decays"),
    Case("undetectable_mode", {2: [1, -2]}, (WITHOUT_GROWTH,), "wrong", "no eigenvector"),
    Case("undetectable_mode", {2: [1, 2]}, (BY_PLACE,), "wrong", "a mode that is seen"),
    Case("undetectable_mode", {2: [0, 0]}, (WITHOUT_GROWTH,), "wrong", "zero"),
    Case("undetectable_mode", {}, (WITHOUT_GROWTH,), "wrong", "there is one"),
    Case("undetectable_mode", {1: [1, -1 / a]}, (EQUAL, [a]), "wrong", "without a value at a = 0"),
    Case("undetectable_mode", {1: [a, -(a**2)]}, (EQUAL, [a]), "wrong", "zero at a = 0"),
    Case("undetectable_mode", {2: [1, 2.02]}, (WITHOUT_GROWTH,), "wrong", "one per cent off"),
    Case(
        "undetectable_mode", {2.02: [1, 2]}, (WITHOUT_GROWTH,), "wrong", "the rate one per cent off"
    ),
    Case(
        "undetectable_mode",
        {1: [-a * (a**2 - 2), a**2 - 2]},
        (EQUAL, [a]),
        "wrong",
        "zero at the root of 2",
    ),
    Case("undetectable_mode", [2, 1, 2], (WITHOUT_GROWTH,), "invalid", "a list"),
    Case("undetectable_mode", {2: [1, 2, 3]}, (WITHOUT_GROWTH,), "invalid", "three components"),
]

LIMITS = [
    "The degree of a mode without parameters is exact; "
    "those of modes that depend on parameters are tried at samples."
]
