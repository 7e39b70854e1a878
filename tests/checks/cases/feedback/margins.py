import sympy as sp
from case import Case

mu, a = sp.symbols("mu", positive=True), sp.symbols("a", real=True)
k1, k2 = sp.symbols("k1 k2", real=True)
M = sp.Matrix
SADDLE, PUSH, PLACE = M([[0, 1], [4, 0]]), M([0, 1]), M([[1, 0]])
HIDES_DECAY, HIDES_GROWTH = M([[2, 1]]), M([[2, -1]])
# u moves the growing mode (1, 2) alone, then the decaying one
ALONG_GROWTH, ALONG_DECAY = M([1, 2]), M([1, -2])
SPIRAL = sp.diag(3, M([[-1, 2], [-2, -1]]))
UPRIGHT, FLAT = M([k1, k2]), M([[k1, k2]])
STATIC = (M([[0, 1], [-2, 3]]), PUSH, M([[k1]]), [k1], M([[1, 1]]))
# at a = 0 the control does not reach the mode e^(-2t), at a = 1 not e^(t)
OF_A = (sp.diag(1, -2), M([a - 1, a]), mu, [a])
ERROR = (("S", M([[0]])), ("c", M([[1]])))
# z = x + a x' of x'' = x hides e^(-t) at a = 1 and e^t at a = -1
SEEN_BY_A = (M([[0, 1], [1, 0]]), M([[1, a]]), mu, [a])

CASES = [
    Case("observer_region", (k1 > 0) & (k2 > 4), (SADDLE, PLACE, UPRIGHT, [k1, k2]), "right", "Hurwitz"),
    Case("observer_region", sp.And(k1 > 0, k2 - 4 > 0), (SADDLE, PLACE, UPRIGHT, [k1, k2]), "right", "another form"),
    Case("observer_region", sp.false, (SADDLE, HIDES_GROWTH, UPRIGHT, [k1, k2]), "right", "never"),
    Case("observer_region", (k1 > 0) & (k2 > 0), (SADDLE, PLACE, UPRIGHT, [k1, k2]), "wrong", "the system forgotten"),
    Case("observer_region", (k1 < 0) & (k2 < -4), (SADDLE, PLACE, UPRIGHT, [k1, k2]), "wrong", "signs"),
    Case("observer_region", k1 + k2, (SADDLE, PLACE, UPRIGHT, [k1, k2]), "invalid", "no condition"),
    Case("feedback_region", (k1 < -4) & (k2 < 0), (SADDLE, PUSH, FLAT, [k1, k2]), "right", "a plane of gains"),
    Case("feedback_region", k1 < -3, STATIC, "right", "a static feedback"),
    Case("feedback_region", k1 < 2, STATIC, "wrong", "the last coefficient alone"),
    Case("feedback_region", (k1 > 4) & (k2 > 0), (SADDLE, PUSH, FLAT, [k1, k2]), "wrong", "u = -Kx"),
    Case("feedback_region", "all", STATIC, "invalid", "a word"),
    Case("observer_margins", sp.true, (SADDLE, PLACE, mu), "right", "every margin"),
    Case("observer_margins", mu > 0, (SADDLE, PLACE, mu), "right", "the same as a condition"),
    Case("observer_margins", mu <= 2, (SADDLE, HIDES_DECAY, mu), "right", "a hidden mode, its own margin included"),
    Case("observer_margins", sp.false, (SADDLE, HIDES_GROWTH, mu), "right", "none at all"),
    Case("observer_margins", mu < 2, (SADDLE, HIDES_DECAY, mu), "wrong", "its own margin left out"),
    Case("observer_margins", sp.true, (SADDLE, HIDES_DECAY, mu), "wrong", "the hidden mode overlooked"),
    Case("observer_margins", mu <= 2, (SADDLE, PLACE, mu), "wrong", "the margin of the free motion"),
    Case("observer_margins", 2, (SADDLE, HIDES_DECAY, mu), "invalid", "a number"),
    Case("feedback_margins", mu <= 2, (SADDLE, ALONG_GROWTH, mu), "right", "a fixed mode that decays"),
    Case("feedback_margins", mu <= 1, (SPIRAL, M([1, 0, 0]), mu), "right", "a pair of them"),
    Case("feedback_margins", sp.false, (SADDLE, ALONG_DECAY, mu), "right", "a growing one"),
    Case("feedback_margins", mu <= 2, (SADDLE, ALONG_DECAY, mu), "wrong", "the wrong mode"),
    Case("feedback_margins", mu >= 2, (SADDLE, ALONG_GROWTH, mu), "wrong", "the other side"),
    Case("feedback_margins", sp.Ne(a, 1) & (sp.Ne(a, 0) | (mu <= 2)), OF_A, "right", "exceptional values"),
    Case("feedback_margins", sp.Ne(a, 1) & sp.Or(a > 0, a < 0, mu - 2 <= 0), OF_A, "right", "in another form"),
    Case("feedback_margins", sp.Ne(a, 1) & sp.Ne(a, 0), OF_A, "wrong", "a mode that decays refused"),
    Case("feedback_margins", sp.Ne(a, 1) & (sp.Ne(a, 0) | (mu < 2)), OF_A, "wrong", "the greatest margin left out"),
    Case("feedback_margins", sp.Ne(a, 0) | (mu <= 2), OF_A, "wrong", "a growing mode overlooked"),
    Case("feedback_margins", sp.true, OF_A, "wrong", "all overlooked"),
    Case("feedback_margins", ["2"], (SADDLE, ALONG_GROWTH, mu), "invalid", "a word"),
    Case("estimate_margins", mu <= 2, (SADDLE, PUSH, HIDES_DECAY, mu), "right", "the observer sets the limit"),
    Case("estimate_margins", sp.true, (SADDLE, PUSH, PLACE, mu), "right", "no limit"),
    Case("estimate_margins", sp.false, (SADDLE, PUSH, HIDES_GROWTH, mu), "right", "no observer"),
    Case("estimate_margins", sp.true, (SADDLE, PUSH, PLACE, mu), "right", "an error that is seen", ERROR),
    Case("estimate_margins", sp.false, (M([[0, 1], [0, -1]]), PUSH, PLACE, mu), "right", "an error that is not", ERROR),
    Case("estimate_margins", sp.true, (SADDLE, PUSH, HIDES_DECAY, mu), "wrong", "the control alone looked at"),
    Case("estimate_margins", mu <= 2, (SADDLE, ALONG_DECAY, HIDES_DECAY, mu), "wrong", "the output alone looked at"),
    Case("estimate_margins", mu, (SADDLE, PUSH, PLACE, mu), "invalid", "no condition"),
    Case("observer_margins", sp.Ne(a, -1) & (sp.Ne(a, 1) | (mu <= 1)), SEEN_BY_A, "right", "exceptional values"),
    Case("observer_margins", sp.Ne(a, -1) & sp.Ne(a, 1), SEEN_BY_A, "wrong", "a mode that decays refused"),
    Case("observer_obstacle", {2: [1, 2]}, (SADDLE, HIDES_GROWTH), "right", "the growing mode"),
    Case("observer_obstacle", {2.0: M([0.5, 1.0])}, (SADDLE, HIDES_GROWTH), "right", "decimals, a column"),
    Case("observer_obstacle", {}, (SADDLE, HIDES_DECAY), "right", "the hidden mode decays"),
    Case("observer_obstacle", {1: [-a, 1]}, (sp.eye(2), M([[1, a]]), [a]), "right", "for every value of a parameter"),
    Case("observer_obstacle", {-2: [1, -2]}, (SADDLE, HIDES_DECAY), "wrong", "a mode that decays"),
    Case("observer_obstacle", {2: [1, -2]}, (SADDLE, HIDES_GROWTH), "wrong", "no eigenvector"),
    Case("observer_obstacle", {2: [1, 2]}, (SADDLE, PLACE), "wrong", "a mode that is seen"),
    Case("observer_obstacle", {2: [0, 0]}, (SADDLE, HIDES_GROWTH), "wrong", "zero"),
    Case("observer_obstacle", {}, (SADDLE, HIDES_GROWTH), "wrong", "there is one"),
    Case("observer_obstacle", {1: [1, -1/a]}, (sp.eye(2), M([[1, a]]), [a]), "wrong", "without a value at a = 0"),
    Case("observer_obstacle", {1: [a, -a**2]}, (sp.eye(2), M([[1, a]]), [a]), "wrong", "zero at a = 0"),
    Case("observer_obstacle", {2: [1, 2.02]}, (SADDLE, HIDES_GROWTH), "wrong", "one per cent off"),
    Case("observer_obstacle", {2.02: [1, 2]}, (SADDLE, HIDES_GROWTH), "wrong", "the rate one per cent off"),
    Case("observer_obstacle", {1: [-a*(a**2 - 2), a**2 - 2]}, (sp.eye(2), M([[1, a]]), [a]), "wrong",
         "zero at the root of 2"),
    Case("observer_obstacle", [2, 1, 2], (SADDLE, HIDES_GROWTH), "invalid", "a list"),
    Case("observer_obstacle", {2: [1, 2, 3]}, (SADDLE, HIDES_GROWTH), "invalid", "three components"),
]

LIMITS = ["The margin of a mode without parameters is exact; "
          "those of modes that depend on parameters are tried at samples."]
