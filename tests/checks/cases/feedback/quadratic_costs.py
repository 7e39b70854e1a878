import sympy as sp
from case import Case

from workbook.systems import Process, Quadratic

a, t, x, x1, x2, z, e1, e2, s11, s12, s22 = sp.symbols("a t x x1 x2 z e1 e2 s11 s12 s22", real=True)
n, g, T, eps = sp.symbols("n g T epsilon", positive=True)
SQRT2, SQRT5 = sp.sqrt(2), sp.sqrt(5)
HALF = sp.Rational(1, 2)
ANY = Quadratic(A=a, B=1, G=g, N=n)
ROOT = n * (a + sp.sqrt(a**2 + g / n))
CHEAP = Quadratic(A=1, B=1, G=0, N=1)
LAZY = Quadratic(A=1, B=1, G=0, N=1, anywhere=True)
PUSHED = Quadratic(A=[[0, 1], [1, 0]], B=[0, 1], G=sp.diag(0, 1), N=1)
LEFT_OUT = Quadratic(A=[[0, 1], [0, 1]], B=[0, 1], G=sp.diag(0, 1), N=1)
FREE = Quadratic(A=[[0, 1], [0, 1]], B=[0, 1], G=sp.diag(0, 1), N=1, anywhere=True)
REPAIRED = Quadratic(A=[[0, 1], [0, 1]], B=[0, 1], G=sp.diag(eps**2, 1), N=1)
HIDDEN = Quadratic(A=[[1, 0], [0, 2]], B=[0, 1], G=sp.eye(2), N=1)
BRAKE = Quadratic(A=0, B=1, G=0, N=1, F=1, duration=T, factor=HALF)
CART = Quadratic(
    A=[[0, 1], [0, 0]], B=[0, 1], G=sp.zeros(2), N=1, F=sp.eye(2), duration=1, factor=HALF
)
SPRING = Quadratic(A=[[0, 1], [-1, 0]], B=[0, 1], G=sp.diag(0, 1), N=1)
SWUNG = Process(A=[[0, 1], [-1, 0]], Q=sp.diag(0, 4), H=[[0, 1]], R=1)
SEEN = Process(A=[[0, 1], [-1, 0]], Q=sp.diag(0, 4))
# The sweep of a long record, with the weights of its samples and of the acceleration.
rho, M = sp.symbols("rho M", positive=True)
RECORD = (
    Quadratic(A=[[0, 1], [0, 0]], B=[0, 1], G=sp.diag(rho, 0), N=M, factor=HALF),
    None,
    [rho, M],
)
q = sp.sqrt(rho * M)
COST = sp.Matrix([[s11, s12], [s12, s22]])
RATE = sp.Matrix([[s12**2, s12 * s22 - s11], [s12 * s22 - s11, s22**2 - 2 * s12]])
# The cart with a cost in small units: its matrix S is that of CART times TINY.
TINY = sp.Rational(1, 10**9)
PENNIES = Quadratic(A=CART.A, B=CART.B, G=CART.G, N=TINY, F=TINY * CART.F, duration=1, factor=HALF)
PENNIES_RATE = TINY * RATE.subs({s: s / TINY for s in (s11, s12, s22)}, simultaneous=True)
LEFT = 1 - t
BELOW = LEFT**4 + 4 * LEFT**3 + 12 * LEFT + 12
BACK = sp.Matrix([[-6 * LEFT * (LEFT + 2), -4 * (LEFT**3 + 3 * LEFT**2 + 3)]]) / BELOW

CASES = [
    Case("optimal_gain", -ROOT / n, (ANY, None, [a, g, n]), "right", "a scalar for all weights"),
    Case(
        "optimal_gain",
        [-2, -SQRT5],
        (PUSHED,),
        "right",
        "a state without a weight that is seen all the same",
    ),
    Case("optimal_gain", [-2, -2.24], (PUSHED,), "right", "decimals"),
    Case("optimal_gain", -2, (CHEAP,), "right", "what it takes to be stable"),
    Case("optimal_gain", 0, (LAZY,), "right", "nothing, where nothing is asked"),
    Case(
        "optimal_gain", [], (LEFT_OUT,), "right", "the least cost of stable loops is not attained"
    ),
    Case("optimal_gain", [], (HIDDEN,), "right", "a mode that grows and is not controlled"),
    Case("optimal_gain", [0, -1 - SQRT2], (FREE,), "right", "the place does not matter"),
    Case(
        "optimal_gain",
        [-eps, -1 - sp.sqrt(2 + 2 * eps)],
        (REPAIRED, None, [eps]),
        "right",
        "the place matters a little",
    ),
    Case("optimal_gain", -1 / (1 + T - t), (BRAKE, t, [T]), "right", "a given end"),
    Case("optimal_gain", BACK, (CART, t), "right", "a given end in the plane"),
    Case(
        "optimal_gain",
        (-a + sp.sqrt(a**2 + g / n)),
        (ANY, None, [a, g, n]),
        "wrong",
        "the other root",
    ),
    Case("optimal_gain", ROOT / n, (ANY, None, [a, g, n]), "wrong", "the other sign"),
    Case(
        "optimal_gain",
        -ROOT,
        (ANY, None, [a, g, n]),
        "wrong",
        "not divided by the weight of the control",
    ),
    Case("optimal_gain", [-2, -3], (PUSHED,), "wrong", "stable and dearer"),
    Case("optimal_gain", [-2, -2.26], (PUSHED,), "wrong", "decimals"),
    Case("optimal_gain", 0, (CHEAP,), "wrong", "cheap and not stable"),
    Case("optimal_gain", -2, (LAZY,), "wrong", "a stability that nobody asks for"),
    Case("optimal_gain", [0, -1 - SQRT2], (LEFT_OUT,), "wrong", "it does not stabilise"),
    Case("optimal_gain", [-1, -3], (LEFT_OUT,), "wrong", "no law is the best"),
    Case("optimal_gain", [], (PUSHED,), "wrong", "there is one"),
    Case("optimal_gain", [], (CART, t), "wrong", "with a given end there always is one"),
    Case("optimal_gain", [], (FREE,), "wrong", "without the demand of stability"),
    Case("optimal_gain", BACK.subs(t, 1 - t), (CART, t), "wrong", "time turned round"),
    Case("optimal_gain", [sp.I, -2], (PUSHED,), "wrong", "not real"),
    Case("optimal_gain", [1, 2, 3], (PUSHED,), "invalid", "three entries"),
    Case("cost_matrix", ROOT, (ANY, None, [a, g, n]), "right", "a scalar"),
    Case("cost_matrix", [[SQRT5, 2], [2, SQRT5]], (PUSHED,), "right", "lists"),
    Case("cost_matrix", sp.diag(0, 1 + SQRT2), (FREE,), "right", "the place does not matter"),
    Case("cost_matrix", 1 / (1 + T - t), (BRAKE, t, [T]), "right", "a given end"),
    Case(
        "cost_matrix",
        n * (a - sp.sqrt(a**2 + g / n)),
        (ANY, None, [a, g, n]),
        "wrong",
        "the other root",
    ),
    Case("cost_matrix", [[-1, 0], [0, 1]], (PUSHED,), "wrong", "another solution of the equation"),
    Case("cost_matrix", 1 / (1 + t), (BRAKE, t, [T]), "wrong", "time turned round"),
    Case(
        "cost_matrix",
        [
            [1.41 * rho**0.75 * M**0.25, (rho * M) ** 0.5],
            [(rho * M) ** 0.5, 1.41 * rho**0.25 * M**0.75],
        ],
        RECORD,
        "right",
        "three digits",
    ),
    Case(
        "cost_matrix",
        [
            [1.43 * rho**0.75 * M**0.25, (rho * M) ** 0.5],
            [(rho * M) ** 0.5, 1.43 * rho**0.25 * M**0.75],
        ],
        RECORD,
        "wrong",
        "one per cent off",
    ),
    Case(
        "cost_matrix",
        sp.Matrix([[sp.sqrt(2 * rho * q), q], [q, sp.sqrt(2 * M * q)]]),
        RECORD,
        "right",
        "with nested roots",
    ),
    Case(
        "cost_matrix",
        [
            [sp.sqrt(2) * rho**0.75 * M**0.25, (rho * M) ** 0.5],
            [(rho * M) ** 0.5, sp.sqrt(2) * rho**0.25 * M**0.75],
        ],
        RECORD,
        "right",
        "powers",
    ),
    Case(
        "cost_matrix",
        -sp.Matrix([[sp.sqrt(2 * rho * q), -q], [-q, sp.sqrt(2 * M * q)]]),
        RECORD,
        "wrong",
        "the negative root",
    ),
    Case(
        "cost_matrix",
        sp.Matrix([[sp.sqrt(2 * M * q), q], [q, sp.sqrt(2 * rho * q)]]),
        RECORD,
        "wrong",
        "rho and M interchanged",
    ),
    Case(
        "cost_matrix",
        sp.Matrix([[sp.sqrt(2 * rho * q), q], [-q, sp.sqrt(2 * M * q)]]),
        RECORD,
        "wrong",
        "not symmetric",
    ),
    Case("cost_matrix", sp.zeros(2), RECORD, "wrong", "zero"),
    Case("cost_matrix", [q, q, q], RECORD, "invalid", "three numbers"),
    Case("cost_matrix", sp.eye(3), RECORD, "invalid", "another size"),
    Case("cost_matrix", ..., RECORD, "missing", "the untouched stub"),
    Case("cost_matrix", 0, (CHEAP,), "wrong", "under its law the state grows"),
    Case("cost_matrix", 2, (LAZY,), "wrong", "what stability costs, which nobody asks for"),
    Case("cost_matrix", [1, 2], (PUSHED,), "invalid", "a list"),
    Case("least_quadratic_cost", ROOT * x**2, (ANY, [x], [a, g, n]), "right", "a scalar"),
    Case(
        "least_quadratic_cost",
        SQRT5 * (x1**2 + x2**2) + 4 * x1 * x2,
        (PUSHED, [x1, x2]),
        "right",
        "a form",
    ),
    Case(
        "least_quadratic_cost",
        x**2 / (1 + T) / 2,
        (BRAKE, [x], [T]),
        "right",
        "a given end, a factor",
    ),
    Case(
        "least_quadratic_cost", x**2 / (1 + T), (BRAKE, [x], [T]), "wrong", "the factor forgotten"
    ),
    Case(
        "least_quadratic_cost",
        SQRT5 * (x1**2 + x2**2) + 2 * x1 * x2,
        (PUSHED, [x1, x2]),
        "wrong",
        "one of two products",
    ),
    Case("least_quadratic_cost", [1], (PUSHED, [x1, x2]), "invalid", "a list"),
    Case("optimal_eigenvalues", [(-SQRT5 + 1) / 2, (-SQRT5 - 1) / 2], (PUSHED,), "right", "two"),
    Case("optimal_eigenvalues", [-sp.sqrt(a**2 + g / n)], (ANY, [a, g, n]), "right", "one"),
    Case("optimal_eigenvalues", {0, -SQRT2}, (FREE,), "right", "a set"),
    Case("optimal_eigenvalues", [(-SQRT5 + 1) / 2], (PUSHED,), "wrong", "one of two"),
    Case("optimal_eigenvalues", [1, -1], (PUSHED,), "wrong", "those of the system itself"),
    Case("optimal_eigenvalues", sp.true, (PUSHED,), "invalid", "a truth value"),
    Case("optimal_limit_state", [x1 + x2 / SQRT2, 0], (FREE, [x1, x2]), "right", "a place"),
    Case("optimal_limit_state", [0, 0], (PUSHED, [x1, x2]), "right", "the origin"),
    Case("optimal_limit_state", [x1, 0], (FREE, [x1, x2]), "wrong", "where it was"),
    Case("optimal_limit_state", [0, 0], (FREE, [x1, x2]), "wrong", "the origin"),
    Case("optimal_limit_state", 3, (FREE, [x1, x2]), "invalid", "one of two"),
    Case("cost_riccati_equation", RATE, (CART, COST), "right", "a cart"),
    Case("cost_riccati_equation", RATE.tolist(), (CART, COST), "right", "lists"),
    Case(
        "cost_riccati_equation",
        sp.Matrix([[s11**2 / n - 2 * a * s11 - g]]),
        (ANY, sp.Matrix([[s11]]), [a, g, n]),
        "right",
        "a scalar",
    ),
    Case("cost_riccati_equation", -RATE, (CART, COST), "wrong", "time turned round"),
    Case("cost_riccati_equation", RATE / 2, (CART, COST), "wrong", "the factor put in"),
    Case("cost_riccati_equation", [1, 2], (CART, COST), "invalid", "a list"),
    Case("cost_riccati_equation", PENNIES_RATE, (PENNIES, COST), "right", "small units"),
    Case(
        "cost_riccati_equation",
        PENNIES_RATE + sp.diag(0, 2 * s12),
        (PENNIES, COST),
        "wrong",
        "a linear term left out, in small units",
    ),
    Case(
        "cost_riccati_equation",
        PENNIES_RATE - TINY * sp.eye(2),
        (PENNIES, COST),
        "wrong",
        "a constant term, in small units",
    ),
    Case("steady_cost", 6, (SPRING, SWUNG), "right", "by measurements"),
    Case("steady_cost", 4, (SPRING, SEEN), "right", "the state known"),
    Case("steady_cost", 4, (SPRING, SWUNG), "wrong", "as if the state were known"),
    Case("steady_cost", 2, (SPRING, SWUNG), "wrong", "the price of not knowing alone"),
    Case("steady_cost", [6], (SPRING, SWUNG), "invalid", "a list"),
    Case(
        "controller_equations",
        [e2, -e1 - e2 + 2 * (z - e2)],
        (SPRING, SWUNG, [e1, e2], [z]),
        "right",
        "a list",
    ),
    Case(
        "controller_equations",
        sp.Matrix([e2, 2 * z - e1 - 3 * e2]),
        (SPRING, SWUNG, [e1, e2], [z]),
        "right",
        "a column",
    ),
    Case(
        "controller_equations",
        [e2, -e1 + 2 * (z - e2)],
        (SPRING, SWUNG, [e1, e2], [z]),
        "wrong",
        "its own control forgotten",
    ),
    Case(
        "controller_equations",
        [e2, -e1 - e2 + z - e2],
        (SPRING, SWUNG, [e1, e2], [z]),
        "wrong",
        "the gain of the regulator",
    ),
    Case("controller_equations", [e2], (SPRING, SWUNG, [e1, e2], [z]), "invalid", "one of two"),
]
LIMITS = [
    "Weights of products x u of state and control are not known here; N is positive definite.",
    "That no law is the best one is decided at general values of the parameters.",
]
