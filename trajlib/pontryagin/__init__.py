"""Pontryagin's maximum principle: chapter 5 of the problem book as functions.

A problem is stated once, in SymPy (`Problem`). `conditions()` derives what a textbook would write
down; `solve()` finds an extremal (direct transcription, arcs, multiple shooting) whose
`certificate()` is computed from the trajectory alone; `synthesis` computes planar syntheses.
`euler_equation`, `natural_conditions` and their neighbours are the calculus of variations;
`problems` has problems with known solutions. Every name is loaded on first use.

Conventions, those of the book: H = psi^T f - lambda_0 f_0 is maximised by the optimal control, psi'
= -dH/dy, lambda_0 >= 0, and H = 0 along the extremal when the final time is free.

The fastest transfer of x1'' = u, |u| <= 1, from rest at x1 = 1 to rest at the origin takes two units
of time:

>>> import sympy as sp
>>> from trajlib.pontryagin import Problem
>>> x1, x2, u = sp.symbols("x1 x2 u")
>>> cart = Problem({x1: x2, x2: u}, {u: (-1, 1)}, {x1: 1, x2: 0}, terminal=[x1, x2])
>>> extremal = cart.solve()
>>> round(extremal.duration, 9)
2.0
"""

from trajlib._lazy import lazy_names

# No module or package of this folder is called like a name it exports: importing it would put the
# module in the place of the function. So `synthesis` lies in `planar_synthesis`.
_EXPORTS = {
    "optimal_control": ["Problem"],
    "phase": ["Phase"],
    "phased_problem": ["PhasedProblem"],
    "phased_extremal": ["ExtremalPhase", "PhasedExtremal"],
    "functionals": [
        "control_problem",
        "end_conditions",
        "euler_equation",
        "functional_value",
        "momenta",
        "natural_conditions",
    ],
    "problem.derivation": ["Conditions"],
    "direct.process": ["DirectProcess"],
    "indirect.extremal": ["Extremal"],
    "indirect.explanation": ["ExplainedStep", "Explanation"],
    "indirect.comparison": ["Comparison", "compare"],
    "verification.certificate": ["Certificate", "certify"],
    "verification.proof": ["Proof"],
    "verification.ball_arithmetic": ["Enclosure"],
    "problem.errors": [
        "PontryaginError",
        "Infeasible",
        "Unbounded",
        "Chattering",
        "WrongStructure",
        "NotUnique",
        "NotConverged",
        "StartOnTarget",
    ],
    "problem.elimination": ["ControlField"],
    "problem.log": ["Log", "LogEntry"],
    "registry": ["KnownProblem", "problems"],
    "problem.state_constraints": ["StateConstraint"],
    "planar_synthesis.synthesis": ["Synthesis"],
    "planar_synthesis.construction": ["synthesis"],
}
__getattr__, __dir__, __all__ = lazy_names(__name__, _EXPORTS)
