"""Reference curves of the rocket of chapter 8 against integrating each motion anew, and weights of
an invariant estimate by reflections against the formulas with inverses: the time of each, and how
far the answers are apart.
"""

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp
from stopwatch import seconds

from trajlib.invariant import InvariantEstimator, value
from trajlib.reference_curves import ReferenceCurves

RUNS, POINTS, MOTIONS = 5, 100_000, 40


def rocket(t, x, p):
    (z1, z2), (eta,) = x, p
    return [-9.80665 / z2, 2290 * eta / (1 - eta * t) - 9.80665 * np.tanh(z1)]


def family():
    starts = np.log(np.tan(np.pi / 4 + np.radians([50, 60, 70, 80]) / 2))
    return ReferenceCurves(
        rocket, 7 * np.arange(11), [starts, np.arange(100, 201, 20)], [np.linspace(0.006, 0.01, 5)]
    )


def integrate(t, z1, z2, eta):
    return solve_ivp(
        lambda s, x: rocket(s, x, [eta]), (0, t), [z1, z2], method="DOP853", rtol=1e-6
    ).y[:, -1]


def by_inverses(Psi, Theta, o):
    Z = np.eye(Psi.shape[1]) - Theta.T @ np.linalg.inv(Theta @ Theta.T) @ Theta
    return Z @ Psi.T @ np.linalg.inv(Psi @ Z @ Psi.T) @ o


def main():
    curves = family()
    random = np.random.default_rng(0)
    t, z1, z2, eta = (low + (high - low) * random.random(POINTS) for low, high in curves.box)
    table = seconds(family, RUNS)
    ours = seconds(lambda: curves(t, [z1, z2], [eta]), RUNS) / POINTS
    some = list(zip(t, z1, z2, eta))[:MOTIONS]
    peer = seconds(lambda: [integrate(*place) for place in some], RUNS) / MOTIONS
    found, exact = (
        curves(t[:MOTIONS], [z1[:MOTIONS], z2[:MOTIONS]], [eta[:MOTIONS]]),
        np.transpose([integrate(*place) for place in some]),
    )
    apart = np.abs(found - exact).max(axis=1)
    print(
        f"120 curves: {1e3 * table:.1f} ms; a point {1e6 * ours:.1f} us, solve_ivp "
        f"{1e6 * peer:.0f} us, {peer / ours:.0f} "
        f"times as long; greatest differences {apart[0]:.1e} in z1, {apart[1]:.1e} m/s"
    )

    time = sp.Symbol("t")
    for degree in (2, 6):
        basis, nuisance = (
            [time**k for k in range(degree + 1)],
            [sp.sin(0.64 * time), sp.exp(-0.07 * time)],
        )
        window = InvariantEstimator(np.arange(21.0), basis, nuisance)
        o = 10.0 ** np.arange(degree + 1)
        made = seconds(lambda: InvariantEstimator(np.arange(21.0), basis, nuisance), RUNS)
        ours, peer = (
            seconds(lambda: window.weights(value(10)), RUNS),
            seconds(lambda: by_inverses(window.Psi, window.Theta, o), RUNS),
        )
        missed = [
            np.abs(np.vstack([window.Psi, window.Theta]) @ P - np.append(o, [0, 0])).max()
            / np.abs(o).max()
            for P in (window.weights(value(10)), by_inverses(window.Psi, window.Theta, o))
        ]
        print(
            f"weights, degree {degree}: {1e6 * ours:.0f} us once the window is made "
            f"({1e6 * made:.0f} us), with inverses {1e6 * peer:.0f} us; conditions missed by "
            f"{missed[0]:.0e} and {missed[1]:.0e} of the greatest"
        )


if __name__ == "__main__":
    main()
