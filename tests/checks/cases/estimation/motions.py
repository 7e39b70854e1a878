import sympy as sp
from case import Case

from trajlib.systems import Process

t = sp.Symbol("t", nonnegative=True)
k = sp.Symbol("k", integer=True, nonnegative=True)
a, q, m, P = sp.symbols("a q m P", positive=True)
DECAY = Process(A=-a, Q=q, mean=m, covariance=P)
WIENER = Process(A=0, Q=q, mean=m, covariance=P)
STEPS = Process(A=a, Q=q, mean=m, covariance=P, discrete=True)
CARTS = Process(A=[[0, 1], [0, 0]], Q=sp.diag(0, q), mean=[m, 1])
LINE = q*sp.Matrix([[t**3/3, t**2/2], [t**2/2, t]])
HALF = sp.Rational(1, 2)

CASES = [
    Case("mean_motion", m*sp.exp(-a*t), (DECAY, t, [a, q, m, P]), "right", "decay"),
    Case("mean_motion", [m + t, 1], (CARTS, t, [q, m]), "right", "a column"),
    Case("mean_motion", m*a**k, (STEPS, k, [a, q, m, P]), "right", "powers"),
    Case("mean_motion", m*sp.exp(a*t), (DECAY, t, [a, q, m, P]), "wrong", "growth"),
    Case("mean_motion", [m, 1], (CARTS, t, [q, m]), "wrong", "the motion forgotten"),
    Case("mean_motion", m, (CARTS, t, [q, m]), "invalid", "one of two"),
    Case("covariance_motion", P*sp.exp(-2*a*t) + q*(1 - sp.exp(-2*a*t))/(2*a), (DECAY, t, [a, q, m, P]), "right",
         "towards a limit"),
    Case("covariance_motion", P + q*t, (WIENER, t, [q, m, P]), "right", "in proportion to time"),
    Case("covariance_motion", LINE, (CARTS, t, [q, m]), "right", "a matrix"),
    Case("covariance_motion", P*a**(2*k) + q*(1 - a**(2*k))/(1 - a**2), (STEPS, k, [a, q, m, P]), "right",
         "a sum of powers"),
    Case("covariance_motion", q*t, (WIENER, t, [q, m, P]), "wrong", "the start forgotten"),
    Case("covariance_motion", P*sp.exp(-a*t) + q*(1 - sp.exp(-a*t))/a, (DECAY, t, [a, q, m, P]), "wrong",
         "at the rate of the mean"),
    Case("covariance_motion", LINE.subs(q, q**2), (CARTS, t, [q, m]), "wrong", "the intensity squared"),
    Case("covariance_motion", sp.diag(*LINE.diagonal()), (CARTS, t, [q, m]), "wrong", "the variances alone"),
    Case("covariance_motion", [1, 2, 3], (CARTS, t, [q, m]), "invalid", "a list"),
    Case("settled_covariance", q/(2*a), (DECAY, [a, q]), "right", "a number"),
    Case("settled_covariance", q/(1 - a**2), (STEPS, [a, q], a < 1), "right", "where it exists"),
    Case("settled_covariance", sp.Matrix([[HALF, 0], [0, HALF]]),
         (Process(A=[[0, 1], [-1, -1]], Q=sp.diag(0, 1)),), "right", "a damped oscillator"),
    Case("settled_covariance", q/a, (DECAY, [a, q]), "wrong", "a factor of two"),
    Case("settled_covariance", q/(1 - a), (STEPS, [a, q], a < 1), "wrong", "the rate of the mean"),
    Case("settled_covariance", "q/2", (DECAY, [a, q]), "invalid", "a word"),
]
LIMITS = ["A process that does not settle has no `settled_covariance`; whether it does is asked by `stability_region`."]
