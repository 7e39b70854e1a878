import sympy as sp
from case import Case

b = sp.symbols("beta", real=True)
W, r = sp.symbols("Omega r0", positive=True)
M = sp.Matrix
Z, E, o = sp.zeros(2), sp.eye(2), M([[0, 0]])
# Loses exactly lambda = -1; loses the pair of the factor lambda^2 - 3; loses nothing.
GYRO = (M([[3, 0], [0, 1]]), M([[0, -1], [1, 0]]), M([[-2, 1], [1, -1]]), o, M([[1, 2]]))
PAIR = (M([[2, 1], [1, 1]]), Z, M([[-5, 0], [0, 6]]), M([[1, 3]]), o)
SEEN = (M([[2, 1], [1, 2]]), Z, M([[0, -1], [-1, 0]]), M([[1, 0]]), M([[1, 0]]))
# One equation of the first order: M is singular.
SINGULAR = (M([[3, 0], [0, 0]]), M([[0, -1], [1, 1]]), M([[-2, 1], [1, -1]]), o, M([[1, 2]]))
# Motion near a circular orbit.
ORBIT = (E, M([[0, 2 * W / r], [-2 * W * r, 0]]), M([[0, 0], [0, -3 * W**2]]))
ALONG, ACROSS = (*ORBIT, M([[1, 0]]), o, [W, r]), (*ORBIT, M([[0, 1]]), o, [W, r])
TANGENT, NORMAL = (*ORBIT, M([1, 0]), [W, r]), (*ORBIT, M([0, 1]), [W, r])
VALUE = (M([[1, 1], [1, 2]]), Z, M([[1, 1], [3, b]]), M([1, 3]), [b])
FREE = (E, Z, M([[1, 0], [0, b]]), M([1, 1]), [b])
DRIVEN = (M([[2, 1], [1, 3]]), Z, M([[3, 1], [1, -2]]), M([2, 1]))

CASES = [
    Case("mechanical_observable", "yes", SEEN, "right", "the rank is full everywhere"),
    Case("mechanical_observable", "no", GYRO, "right", "one value is lost"),
    Case("mechanical_observable", True, SINGULAR, "right", "M is singular"),
    Case("mechanical_observable", True, ALONG, "right", "for all positive values of the parameters"),
    Case("mechanical_observable", False, ACROSS, "right", "for none"),
    Case("mechanical_observable", "yes", PAIR, "wrong", "irrational values overlooked"),
    Case("mechanical_observable", "no", SEEN, "wrong", "the opposite"),
    Case("mechanical_observable", "yes", ACROSS, "wrong", "the root 0 overlooked"),
    Case("mechanical_observable", ..., SEEN, "missing", "the untouched stub"),
    Case("mechanical_observable", -1, GYRO, "invalid", "the value that is lost"),
    Case("mechanical_lost_eigenvalues", [-1], GYRO, "right", "one value"),
    Case("mechanical_lost_eigenvalues", {sp.sqrt(3), -sp.sqrt(3)}, PAIR, "right", "an irrational pair"),
    Case("mechanical_lost_eigenvalues", [1.73, -1.73], PAIR, "right", "decimals"),
    Case("mechanical_lost_eigenvalues", [0], ACROSS, "right", "with parameters"),
    Case("mechanical_lost_eigenvalues", [], SEEN, "right", "none"),
    Case("mechanical_lost_eigenvalues", [sp.sqrt(3)], PAIR, "wrong", "one of the pair"),
    Case("mechanical_lost_eigenvalues", [-1, 1], GYRO, "wrong", "a root that is seen, or none at all"),
    Case("mechanical_lost_eigenvalues", [3], PAIR, "wrong", "the square"),
    Case("mechanical_lost_eigenvalues", [], GYRO, "wrong", "overlooked"),
    Case("mechanical_lost_eigenvalues", True, GYRO, "invalid", "yes"),
    Case("mechanical_controllable", "yes", DRIVEN, "right", "the rank is full everywhere"),
    Case("mechanical_controllable", "yes", TANGENT, "right", "for all positive values of the parameters"),
    Case("mechanical_controllable", "no", NORMAL, "right", "for none"),
    Case("mechanical_controllable", "no", VALUE, "right", "not for all values"),
    Case("mechanical_controllable", "no", DRIVEN, "wrong", "the opposite"),
    Case("mechanical_controllable", "yes", VALUE, "wrong", "one value overlooked"),
    Case("mechanical_controllable", sp.Ne(b, 3), VALUE, "invalid", "the condition where yes or no is asked"),
    Case("mechanical_controllable_parameters", sp.Ne(b, 3), VALUE, "right", "one value left out"),
    Case("mechanical_controllable_parameters", sp.Ne(sp.Symbol("beta"), 1), FREE, "right",
         "equal frequencies, a plain symbol"),
    Case("mechanical_controllable_parameters", sp.S.Reals - sp.FiniteSet(3), VALUE, "right", "a set"),
    Case("mechanical_controllable_parameters", sp.Ne(b, 0), VALUE, "wrong", "another value"),
    Case("mechanical_controllable_parameters", b > 1, FREE, "wrong", "one side only"),
    Case("mechanical_controllable_parameters", True, FREE, "wrong", "the value overlooked"),
    Case("mechanical_controllable_parameters", [b, 3], VALUE, "invalid", "a list of numbers"),
    Case("mechanical_uncontrolled_eigenvalues", [0], NORMAL, "right", "with parameters"),
    Case("mechanical_uncontrolled_eigenvalues", [], TANGENT, "right", "none"),
    Case("mechanical_uncontrolled_eigenvalues", sp.S.EmptySet, DRIVEN, "right", "none, as the empty set"),
    Case("mechanical_uncontrolled_eigenvalues", [sp.I * W], NORMAL, "wrong", "a root that is controlled"),
    Case("mechanical_uncontrolled_eigenvalues", [], NORMAL, "wrong", "overlooked"),
    Case("mechanical_uncontrolled_eigenvalues", "0", NORMAL, "invalid", "text"),
]
LIMITS = [
    "Where M is singular for some values of the parameters, these values are left out; where it is singular for all, "
    "only systems "
    "without parameters are judged.",
    "Values of lambda that depend on parameters are compared at six values of them in general position.",
]
