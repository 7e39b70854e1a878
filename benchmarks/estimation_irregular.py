"""Measurements at irregular moments: `trajlib.estimation.filter_measurements` side by side with
cd-dynamax.

A side-by-side check first: the same record goes to both, and the numbers are compared; whose they
are nearer to is told by the recursion in 40 digits. cd-dynamax integrates the equations of the
moments between measurements (Dormand-Prince 5); "default" is its constant step of 0.01, "tight" the
same method with its step under control, relative tolerance 1e-12. Both in float64. Differences of
means are in standard deviations of the error, those of covariances in products of two of them. Run
by estimation.py.
"""

from typing import NamedTuple

import numpy as np

NAME = "cd-dynamax"
SETTINGS = ("default", "tight")
# What cd-dynamax 0.5.0 adds to the diagonal of the matrix it inverts for the gain, whatever the
# tolerances.
ADDED = 1e-9


class Problem(NamedTuple):
    title: str
    A: tuple
    Q: tuple
    mean: tuple
    P: tuple
    seed: int


ONE = ((1.0,),)
PROBLEMS = {
    "integrator": Problem(
        "x'' = q, as in 4.26",
        ((0.0, 1.0), (0.0, 0.0)),
        ((0.0, 0.0), (0.0, 1.0)),
        (1.0, 1.0),
        ((1.0, 0.0), (0.0, 1.0)),
        1,
    ),
    "oscillator": Problem(
        "x'' + 0.4x' + 4x = q, as in 4.17",
        ((0.0, 1.0), (-4.0, -0.4)),
        ((0.0, 0.0), (0.0, 1.0)),
        (1.0, 0.0),
        ((1.0, 0.0), (0.0, 1.0)),
        2,
    ),
    "unstable": Problem("x' = x + q, as in 4.32", ONE, ONE, (1.0,), ONE, 3),
    "stiff": Problem(
        "x'' + 1000x' + x = q, beside the three",
        ((0.0, 1.0), (-1.0, -1000.0)),
        ((0.0, 0.0), (0.0, 1e6)),
        (1.0, 0.0),
        ((1.0, 0.0), (0.0, 1.0)),
        4,
    ),
}
COUNT, MEAN_GAP, SPREAD = 40, 0.3, 0.25


def moments():
    """When it is measured: at 0 and after gaps at random, from a hundredth to more than two
    seconds."""
    gaps = np.random.default_rng(9).exponential(MEAN_GAP, COUNT - 1).round(2) + 0.01
    return np.concatenate([[0.0], np.cumsum(gaps)]).round(2)


def seen(problem):
    """H and R: the first component, with the variance SPREAD."""
    return np.eye(1, len(problem.A)), np.array([[SPREAD]])


def records():
    from trajlib.estimation import Moments, simulate_continuous

    return {
        name: simulate_continuous(
            one.A,
            one.Q,
            Moments(np.array(one.mean), np.array(one.P)),
            moments(),
            1,
            one.seed,
            *seen(one),
        ).measurements[0]
        for name, one in PROBLEMS.items()
    }


def peer(folder, seconds):
    """Run in the peers' environment: means and covariances to a file; returns the seconds of whole
    runs."""
    import jax

    jax.config.update("jax_enable_x64", True)
    import diffrax
    import jax.numpy as jnp
    from cd_dynamax import KFHyperParams, ParamsCDLGSSM, cdlgssm_filter
    from cd_dynamax.src.continuous_discrete_linear_gaussian_ssm.inference import (
        ParamsCDLGSSMDynamics,
        ParamsLGSSMEmissions,
        ParamsLGSSMInitial,
    )

    control = {"stepsize_controller": diffrax.PIDController(rtol=1e-12, atol=1e-14)}
    settings = dict(zip(SETTINGS, (KFHyperParams(), KFHyperParams(diffeqsolve_settings=control))))
    data, times, taken, found = (
        np.load(folder / "records.npz"),
        jnp.array(moments())[:, None],
        {},
        {},
    )
    for name, one in PROBLEMS.items():
        H, R = seen(one)
        A, Q, mean, P = (jnp.array(part) for part in (one.A, one.Q, one.mean, one.P))
        model = ParamsCDLGSSM(
            ParamsLGSSMInitial(mean, P),
            ParamsCDLGSSMDynamics(
                weights=A,
                bias=None,
                input_weights=None,
                diffusion_coefficient=jnp.eye(len(A)),
                diffusion_cov=Q,
            ),
            ParamsLGSSMEmissions(
                weights=jnp.array(H), bias=None, input_weights=None, cov=jnp.array(R)
            ),
        )
        for setting, hyper in settings.items():
            run = jax.jit(
                lambda z, model=model, hyper=hyper: cdlgssm_filter(
                    model, z, times, filter_hyperparams=hyper, warn=False
                )
            )
            z = jnp.array(data[name])
            run(z).filtered_means.block_until_ready()  # compiles
            taken[f"{name} {setting}"] = seconds(
                lambda: run(z).filtered_means.block_until_ready(), 5
            )
            filtered = run(z)
            found[f"{name} {setting} means"] = filtered.filtered_means
            found[f"{name} {setting} covariances"] = filtered.filtered_covariances
    np.savez(folder / f"{NAME}.npz", **found)
    return taken


def own(problem, z):
    """The run of `filter_measurements` as arrays."""
    from trajlib.estimation import Measurement, Moments, filter_measurements

    H, R = seen(problem)
    start = Moments(np.array(problem.mean), np.array(problem.P))
    run = filter_measurements(
        np.array(problem.A),
        np.array(problem.Q),
        start,
        [Measurement(time, row, H, R) for time, row in zip(moments(), z)],
    )
    return (
        np.array([after.mean for after in run.after], dtype=float).reshape(COUNT, -1),
        np.array([after.covariance for after in run.after], dtype=float),
    )


def in_digits(problem, z, added=0):
    """Means and covariances in 40 digits; `added` to the spread that the gain is computed with."""
    import mpmath

    with mpmath.workdps(40):
        n = len(problem.A)
        A, Q, P = (mpmath.matrix(part) for part in (problem.A, problem.Q, problem.P))
        mean, since, found = mpmath.matrix(problem.mean), mpmath.mpf(0), []
        both = mpmath.zeros(2 * n)
        both[:n, :n], both[:n, n:], both[n:, n:] = A, Q, -A.T
        for time, row in zip(moments(), z):
            # Van Loan: the upper blocks of e^{Mt} are e^{At} and (the noise) e^{-A't}.
            time = mpmath.mpf(str(time))
            with mpmath.workdps(1200 if np.abs(problem.A).max() > 100 else 40):
                power = mpmath.expm(both * (time - since))
                reach = power[:n, :n]
                noise = power[:n, n:] * reach.T
            mean, P = reach * mean, reach * P * reach.T + noise
            spread = P[0, 0] + SPREAD
            gain = P[:, 0] / (spread + added)
            mean, P = (
                mean + gain * (mpmath.mpf(float(row[0])) - mean[0]),
                P - spread * gain * gain.T,
            )
            since = time
            found.append(
                (np.array(mean.tolist(), dtype=float).ravel(), np.array(P.tolist(), dtype=float))
            )
    return tuple(np.array(column) for column in zip(*found))


def apart(one, other):
    """Largest difference of means, in standard deviations, and of covariances, in products of two,
    of `other`."""
    deviations = np.sqrt(np.einsum("kii->ki", other[1]))
    return (
        np.abs((one[0] - other[0]) / deviations).max(),
        np.abs((one[1] - other[1]) / (deviations[:, :, None] * deviations[:, None, :])).max(),
    )


def side_by_side(folder, asked, seconds):
    """Print the differences and the ratios of times; `asked` runs `peer` in the peers'
    environment."""
    data = records()
    np.savez(folder / "records.npz", **data)
    taken = asked(NAME)
    known = np.load(folder / f"{NAME}.npz")
    print(f"\n{COUNT} measurements at irregular moments; differences as mean / covariance")
    for name, one in PROBLEMS.items():
        z = data[name]
        mine, exact, changed = own(one, z), in_digits(one, z), in_digits(one, z, ADDED)
        time = seconds(lambda: own(one, z), 5)
        print(f"{one.title}\n    {'trajlib, from 40 digits':46}{pair(mine, exact)}")
        for setting in SETTINGS:
            theirs = [known[f"{name} {setting} {what}"] for what in ("means", "covariances")]
            other = taken[f"{name} {setting}"]
            print(
                f"    {f'{NAME}, {setting}, from trajlib':46}{pair(theirs, mine)}\n"
                f"    {f'    from 40 digits with its {ADDED:g} in the gain':46}{pair(theirs, changed)}\n"
                f"    {'    a whole run: time of trajlib by its own':46}{time / other:.2g} "
                f"({time * 1e3:.3g} ms by {other * 1e3:.3g} ms)",
                flush=True,
            )


def pair(one, other):
    return " / ".join(
        f"{value:.1e}" if np.isfinite(value) else "not finite" for value in apart(one, other)
    )
