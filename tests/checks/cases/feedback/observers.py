import sympy as sp
from case import Case

from workbook.systems import Linear

e1, e2, z, u, p, lam = (
    *sp.symbols("e1 e2 z u", real=True),
    sp.symbols("p", positive=True),
    sp.symbols("lambda"),
)
M = sp.Matrix
SADDLE = (Linear(M([[0, 1], [4, 0]]), M([0, 1]), M([[1, 0]])), [e1, e2], [z], [u])
FREE = (Linear(M([[0, 1], [4, 0]]), H=M([[2, -1]])), [e1, e2], [z])
OF_P = (Linear(M([[0, 1], [p, 0]]), M([0, 1]), M([[1, 0]])), [e1, e2], [z], [u])
TWO = (("polynomial", (lam + 2) * (lam + 5)), ("symbol", lam))
GOOD = [e2 + 3 * (z - e1), 4 * e1 + u + 7 * (z - e1)]
# y'' = w - y' is to follow y = t
y, v, w, t, k1, k2, l1, l2 = sp.symbols("y v w t k1 k2 l1 l2", real=True)
RUN = ([v, w - v], [y, v], [w], {y: t}, M([[1, 0]]), M([[k1, k2]]), M([l1, l2]), [e1, e2], t)
KEEPS, SEES = 1 + k1 * e1 + k2 * e2, l1 * (y - t - e1)
MODEL = [v, KEEPS - v, e2 + SEES, -e2 + k1 * e1 + k2 * e2 + l2 * (y - t - e1)]

CASES = [
    Case("closed_loop_equations", MODEL, RUN, "right", "as it stands"),
    Case("closed_loop_equations", [line.expand() for line in MODEL], RUN, "right", "expanded"),
    Case(
        "closed_loop_equations",
        [v, KEEPS - v, e2 + l1 * (y - e1), *MODEL[3:]],
        RUN,
        "wrong",
        "z instead of its deviation",
    ),
    Case(
        "closed_loop_equations",
        [v, KEEPS - 1 - v, *MODEL[2:]],
        RUN,
        "wrong",
        "without the control of the process",
    ),
    Case(
        "closed_loop_equations",
        [v, KEEPS - v, e2 - SEES, *MODEL[3:]],
        RUN,
        "wrong",
        "the correction reversed",
    ),
    Case(
        "closed_loop_equations",
        [v, 1 + k1 * (y - t) + k2 * (v - 1) - v, *MODEL[2:]],
        RUN,
        "wrong",
        "the state fed back",
    ),
    Case("closed_loop_equations", [v, sp.oo, *MODEL[2:]], RUN, "wrong", "infinite"),
    Case("closed_loop_equations", MODEL[:2], RUN, "invalid", "the plant alone"),
    Case("closed_loop_equations", [v, w - v, *MODEL[2:]], RUN, "invalid", "the control left open"),
    Case("observer_equations", GOOD, SADDLE, "right", "with the correction written out"),
    Case("observer_equations", M(GOOD).expand(), SADDLE, "right", "expanded, a column"),
    Case(
        "observer_equations",
        [e2 + 3 * (z - e1), 4 * z + u + 3 * (z - e1)],
        SADDLE,
        "right",
        "z in the place of e1",
    ),
    Case(
        "observer_equations",
        [e2 + 7 * (z - e1), 4 * e1 + u + 14.0 * (z - e1)],
        SADDLE,
        "right",
        "a polynomial",
        TWO,
    ),
    Case(
        "observer_equations",
        [e2 + z - e1, p * e1 + u + (1 + p) * (z - e1)],
        OF_P,
        "right",
        "for all values of p",
        (("parameters", [p]),),
    ),
    Case("observer_equations", [e2, 4 * e1 + u], SADDLE, "wrong", "a copy without a correction"),
    Case(
        "observer_equations",
        [e2 + 3 * (z - e1), 4 * e1 + 7 * (z - e1)],
        SADDLE,
        "wrong",
        "the control forgotten",
    ),
    Case(
        "observer_equations",
        [e2 + 3 * z, 4 * e1 + u + 7 * z],
        SADDLE,
        "wrong",
        "z instead of its difference",
    ),
    Case(
        "observer_equations",
        [e2 - 3 * (z - e1), 4 * e1 + u - 7 * (z - e1)],
        SADDLE,
        "wrong",
        "the correction reversed",
    ),
    Case(
        "observer_equations",
        [e2 + 3 * (z - e1) ** 2, 4 * e1 + u + 7 * (z - e1)],
        SADDLE,
        "wrong",
        "not linear",
    ),
    Case("observer_equations", GOOD, SADDLE, "wrong", "another polynomial", TWO),
    Case(
        "observer_equations",
        [e2 + 3.0 * (z - e1), 4.04 * e1 + u + 7 * (z - e1)],
        SADDLE,
        "wrong",
        "the plant one per cent off, in decimals",
    ),
    Case(
        "observer_equations",
        [e2 + 3.0 * (z - e1), 4 * e1 + 1.01 * u + 7 * (z - e1)],
        SADDLE,
        "wrong",
        "the control one per cent off",
    ),
    Case(
        "observer_equations",
        [e2 + 3 * (z - 2 * e1 + e2), 4 * e1 + 7 * (z - 2 * e1 + e2)],
        FREE,
        "wrong",
        "one unseen grows",
    ),
    Case("observer_equations", [e2 + sp.oo * z, 4 * e1], SADDLE, "wrong", "infinite"),
    Case("observer_equations", [e2], SADDLE, "invalid", "one equation"),
    Case("observer_equations", [sp.Symbol("x2"), 4 * e1], SADDLE, "invalid", "the state itself"),
]

LIMITS = [
    "Observers that are not linear in the estimate, z and u are refused.",
    "A complete model is compared at six random places, for fields that are linear.",
]
