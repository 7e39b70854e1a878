import sympy as sp
from case import Case

x, y, f, s, u, w, t = sp.symbols("x y varphi s u w t", real=True)
V, g, c = sp.symbols("V g c", positive=True)

# A cart: place x, y, direction f, speed s; u drives it, w turns it.
CART = (
    [s * sp.cos(f), s * sp.sin(f), w / s, u - c * s],
    [x, y, f, s],
    [c, V],
    {x: V * t, y: 0, s: V},
)
DRIVE, ALONG = (*CART, [u, w], t), (*CART[:2], CART[3], CART[2])

CASES = [
    Case(
        "nominal_motion",
        {"x": V * t, "y": 0, "varphi": 0, "s": V, "u": c * V, "w": 0},
        DRIVE,
        "right",
        "a dict by names",
    ),
    Case("nominal_motion", [V * t, 0, 0, V, c * V, 0], DRIVE, "right", "a list, the controls last"),
    Case(
        "nominal_motion",
        sp.Matrix([sp.Symbol("V") * sp.Symbol("t"), 0, 2 * sp.pi, V, c * V, 0]),
        DRIVE,
        "right",
        "a column; the direction after a full turn",
    ),
    Case("nominal_motion", [V * t, 0, 0, V, 0, 0], DRIVE, "wrong", "the drive forgotten"),
    Case(
        "nominal_motion",
        [V * t, 0, sp.pi, V, c * V, 0],
        DRIVE,
        "wrong",
        "the direction turned round",
    ),
    Case(
        "nominal_motion",
        [V * t + 1, 0, 0, V, c * V, 0],
        DRIVE,
        "wrong",
        "another start than prescribed",
    ),
    Case("nominal_motion", ..., DRIVE, "missing", "the untouched stub"),
    Case(
        "nominal_motion",
        {"x": V * t, "y": 0, "varphi": 0, "s": V, "u": ..., "w": 0},
        DRIVE,
        "missing",
        "half of it",
    ),
    Case("nominal_motion", [V * t, 0, 0, V], DRIVE, "invalid", "without controls"),
    Case("nominal_motion", {"x": V * t}, DRIVE, "invalid", "names missing"),
    Case(
        "linearisation",
        [[0, 0, 0, 1], [0, 0, V, 0], [0, 0, 0, 0], [0, 0, 0, -c]],
        ALONG,
        "right",
        "nested lists",
    ),
    Case(
        "linearisation",
        sp.Matrix([[0, 0, 0, 1], [0, 0, V, 0], [0, 0, 0, 0 * V], [0, 0, 0, -sp.Symbol("c")]]),
        ALONG,
        "right",
        "a matrix, a plain symbol",
    ),
    Case(
        "linearisation",
        [[0, 0, 0, 1], [0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, -c]],
        ALONG,
        "wrong",
        "the drift to the side lost",
    ),
    Case(
        "linearisation",
        [[0, 0, 0, 1], [0, 0, V, 0], [0, 0, 0, 0], [0, 0, 0, c]],
        ALONG,
        "wrong",
        "a sign",
    ),
    Case("linearisation", ..., ALONG, "missing", "the untouched stub"),
    Case("linearisation", [[0, 0], [0, V]], ALONG, "invalid", "the wrong shape"),
    Case(
        "linearisation",
        [[0, 0, 0, 1], [0, 0, s, 0], [0, 0, 0, 0], [0, 0, 0, -c]],
        ALONG,
        "invalid",
        "the program not put in",
    ),
    Case(
        "input_matrix",
        [[0, 0], [0, 0], [0, 1 / V], [1, 0]],
        (*CART, [u, w]),
        "right",
        "nested lists",
    ),
    Case(
        "input_matrix",
        sp.Matrix([[0, 0], [0, 0], [1 / V, 0], [0, 1]]),
        (*CART, [w, u]),
        "right",
        "the controls in the order of the data",
    ),
    Case(
        "input_matrix",
        [[0, 0], [0, 0], [0, 1], [1, 0]],
        (*CART, [u, w]),
        "wrong",
        "a coefficient lost",
    ),
    Case(
        "input_matrix",
        [[0, 0], [0, 0], [1 / V, 0], [0, 1]],
        (*CART, [u, w]),
        "wrong",
        "the columns exchanged",
    ),
    Case("input_matrix", ..., (*CART, [u, w]), "missing", "the untouched stub"),
    Case("input_matrix", [0, 0, 0, 1], (*CART, [u, w]), "invalid", "one column"),
]
LIMITS = [
    "A program motion is judged at six random times and sets of parameters.",
    "What a program leaves open has to be constant along it for the deviation equations to be "
    "judged.",
]
