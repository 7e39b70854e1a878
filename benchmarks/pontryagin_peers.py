"""The problems of `pontryagin.py`, and how each peer solves them; runs in the peers' environment.

`python pontryagin_peers.py PEER PROBLEM GUESS` (of the time) prints {"cost", "times", "controls",
"seconds", "again"}: times and controls of the solution (the controls constant on intervals for CasADi
and rockit), seconds from the bare statement, the package being imported, and the processor time of a
second solution in the same process.
"""

import json
import sys
import time
from dataclasses import dataclass
from math import cos, exp, pi, sin, sqrt


@dataclass(frozen=True)
class Case:
    """min of int f_0 dt, x' = f(x, u), |u| <= 1, start and end given (None: free); free time if
    `duration` is None; with its solution. Without `levels` the switching times are not compared;
    `guess`: of the time, for the peers."""

    field: object
    density: object
    start: tuple
    end: tuple
    duration: float | None
    # the control on the arcs in turn; "line" for one that joins its neighbours linearly
    levels: tuple
    switchings: tuple
    cost: float
    guess: float | None = None

    @property
    def fixed(self):
        """(component, value) of the ends that are given."""
        return [(i, end) for i, end in enumerate(self.end) if end is not None]

    @property
    def ways(self):
        """(start, end) of the straight lines that are a guess of the states."""
        return [(begin, begin if end is None else end) for begin, end in zip(self.start, self.end)]


def oscillator(damping, lengths):
    """To the origin, backwards from it: arcs of these lengths, last first, with u = 1 on the
    last."""
    w = sqrt(1 - damping**2 / 4)
    x, y, u = 0.0, 0.0, 1.0
    for s in lengths:
        # x'' + d x' + x = u, backwards for the time s: about x = u a spiral with the decay d/2.
        p, q = x - u, y
        c, g, grow = cos(w * s), sin(w * s) / w, exp(damping * s / 2)
        x, y, u = (
            u + grow * (p * c - (q + damping / 2 * p) * g),
            grow * (q * c + (p + damping / 2 * q) * g),
            -u,
        )
    times = []
    for s in lengths[:0:-1]:
        times.append(s + (times[-1] if times else 0.0))
    levels = tuple(1.0 if (len(lengths) - i) % 2 else -1.0 for i in range(len(lengths)))
    return Case(
        lambda x, u: (x[1], -x[0] - damping * x[1] + u),
        lambda x, u: 1,
        (x, y),
        (0.0, 0.0),
        None,
        levels,
        tuple(times),
        sum(lengths),
    )


def plane(x, u):
    return x[1], u


def goddard(x, u):
    """Goddard's rocket (COPS), the thrust from 0 to 3.5."""
    h, v, m = x
    thrust, drag = 1.75 * (1 + u), 310 * v**2 * exponential(-500 * (h - 1))
    return v, (thrust - drag) / m - 1 / h**2, -2 * thrust


def exponential(z):
    """For the numbers and symbols of every peer."""
    if type(z).__module__.startswith("sympy"):
        import sympy as library
    else:
        import numpy as library
    return library.exp(z)


r, c = sqrt(1.08), sqrt(3 * (2.1**2 / 4 - 1))
CASES = {
    "double integrator": Case(
        plane, lambda x, u: 1, (1.0, 0.4), (0.0, 0.0), None, (-1.0, 1.0), (0.4 + r,), 0.4 + 2 * r
    ),
    "turnpike": Case(
        lambda x, u: (u,),
        lambda x, u: x[0] ** 2,
        (0.83,),
        (0.41,),
        2.0,
        (-1.0, 0.0, 1.0),
        (0.83, 1.59),
        (0.83**3 + 0.41**3) / 3,
    ),
    "oscillator": oscillator(0.0, [1.0, pi, 2.0]),
    "damped oscillator": oscillator(1.0, [0.9, 2 * pi / sqrt(3), 1.4]),
    "saturated quadratic": Case(
        plane,
        lambda x, u: u**2,
        (1.0, 0.0),
        (0.0, 0.0),
        2.1,
        (-1.0, "line", 1.0),
        (1.05 - c, 1.05 + c),
        2.1 - 4 * c / 3,
    ),
    # The height by the feedback law of the singular surface, from an integration of its own.
    "Goddard": Case(
        goddard,
        lambda x, u: -x[1],
        (1.0, 0.0, 1.0),
        (None, None, 0.6),
        None,
        (),
        (),
        1 - 1.0128369183174954,
        guess=0.2,
    ),
}
N = 100
# A user's guesses of the time, for the peers alone: the next is taken where one leads nowhere.
# States: the straight line.
GUESSES = (3.0, 1.0, 6.0, 9.0)


def casadi_rk4():
    import casadi as ca

    def solve(case, guess_time):
        n = len(case.start)
        x, u, h = ca.SX.sym("x", n), ca.SX.sym("u"), ca.SX.sym("h")
        states = ca.vertsplit(x)  # a column of CasADi cannot be unpacked
        rate = ca.Function(
            "f", [x, u], [ca.vertcat(*case.field(states, u)), case.density(states, u)]
        )
        (k1, c1), (k2, c2) = rate(x, u), rate(x + h / 2 * rate(x, u)[0], u)
        k3, c3 = rate(x + h / 2 * k2, u)
        k4, c4 = rate(x + h * k3, u)
        step = ca.Function(
            "F",
            [x, u, h],
            [x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), h / 6 * (c1 + 2 * c2 + 2 * c3 + c4)],
        )
        opti = ca.Opti()
        X, U, T = opti.variable(n, N + 1), opti.variable(1, N), opti.variable()
        end, cost = step.map(N)(X[:, :-1], U, ca.repmat(T / N, 1, N))
        opti.minimize(ca.sum2(cost))
        opti.subject_to(X[:, 1:] == end)
        opti.subject_to(opti.bounded(-1, U, 1))
        opti.subject_to(X[:, 0] == ca.DM(case.start))
        for i, end in case.fixed:
            opti.subject_to(X[i, -1] == end)
        opti.subject_to(T == case.duration if case.duration else opti.bounded(0.01, T, 100))
        opti.set_initial(T, case.duration or guess_time)
        opti.set_initial(
            X, ca.DM([[a + (b - a) * i / N for i in range(N + 1)] for a, b in case.ways])
        )
        opti.solver(
            "ipopt",
            {"expand": True, "print_time": False},
            {"print_level": 0, "sb": "yes", "tol": 1e-10},
        )
        found = opti.solve()
        T = float(found.value(T))
        return (
            float(found.value(opti.f)),
            [T * i / N for i in range(N + 1)],
            list(map(float, found.value(U))),
        )

    return solve


def rockit():
    from rockit import FreeTime, MultipleShooting, Ocp

    def solve(case, guess_time):
        ocp = Ocp(t0=0, T=case.duration or FreeTime(guess_time))
        x, u = [ocp.state() for _ in case.start], ocp.control()
        for i, end in case.fixed:
            ocp.subject_to(ocp.at_tf(x[i]) == end)
        for one, rate, (begin, end) in zip(x, case.field(x, u), case.ways):
            ocp.set_der(one, rate)
            ocp.subject_to(ocp.at_t0(one) == begin)
            ocp.set_initial(one, begin + (end - begin) * ocp.t / (case.duration or guess_time))
        ocp.add_objective(
            ocp.integral(case.density(x, u)) if case.duration or case.guess else ocp.T
        )
        ocp.subject_to(-1 <= (u <= 1))
        ocp.solver(
            "ipopt",
            {"ipopt.tol": 1e-10, "ipopt.print_level": 0, "ipopt.sb": "yes", "print_time": False},
        )
        ocp.method(MultipleShooting(N=N, intg="rk"))
        found = ocp.solve()
        t, values = found.sample(u, grid="control")
        return float(found.value(ocp.objective)), list(map(float, t)), list(map(float, values[:N]))

    return solve


def yapss(segments=10, points=10):
    from yapss import Problem

    def solve(case, guess_time):
        n = len(case.start)
        p = Problem(name="case", nx=[n], nu=[1], nq=[1])
        low, guess = p.bounds.phase[0], p.guess.phase[0]

        def objective(a):
            a.objective = a.phase[0].integral[0]

        def continuous(a):
            x, (u,) = a.phase[0].state, a.phase[0].control
            a.phase[0].dynamics[:] = case.field(x, u)
            a.phase[0].integrand[:] = (case.density(x, u) + 0 * u,)

        p.functions.objective, p.functions.continuous = objective, continuous
        low.initial_time.lower = low.initial_time.upper = 0
        low.final_time.lower, low.final_time.upper = (
            (case.duration,) * 2 if case.duration else (0.01, 100)
        )
        low.initial_state.lower[:] = low.initial_state.upper[:] = case.start
        for i, end in case.fixed:
            low.final_state.lower[i] = low.final_state.upper[i] = end
        low.control.lower[:], low.control.upper[:] = -1, 1
        guess.time = [0, case.duration or guess_time]
        guess.state, guess.control = list(map(list, case.ways)), [[0, 0]]
        p.derivatives.method, p.derivatives.order = "auto", "second"
        p.mesh.phase[0].collocation_points, p.mesh.phase[0].fraction = (
            segments * (points,),
            segments * (1 / segments,),
        )
        p.ipopt_options.print_level, p.ipopt_options.tol = 0, 1e-10
        found = p.solve()
        phase = found.phase[0]
        times = phase.time_c if hasattr(phase, "time_c") else phase.time
        return float(found.objective), list(map(float, times)), list(map(float, phase.control[0]))

    return solve


def dymos():
    import os

    os.environ["OPENMDAO_REPORTS"] = "0"
    import dymos as dm
    import numpy as np
    import openmdao.api as om

    def solve(case, guess_time):
        names = [f"x{i}" for i in range(len(case.start))]

        class Rates(om.ExplicitComponent):
            def initialize(self):
                self.options.declare("num_nodes", types=int)

            def setup(self):
                nodes = self.options["num_nodes"]
                for name in [*names, "u"]:
                    self.add_input(name, np.ones(nodes))
                for name in [*names, "J"]:
                    self.add_output(name + "_rate", np.ones(nodes))
                self.declare_partials("*", "*", method="cs")
                self.declare_coloring(wrt="*", method="cs", show_summary=False, show_sparsity=False)

            def compute(self, inputs, outputs):
                x, u = [inputs[name] for name in names], inputs["u"]
                for name, rate in zip(names, case.field(x, u)):
                    outputs[name + "_rate"] = rate
                outputs["J_rate"] = case.density(x, u) + 0 * u

        p = om.Problem(reports=None)
        p.driver = om.ScipyOptimizeDriver(optimizer="SLSQP", tol=1e-9, maxiter=500, disp=False)
        p.driver.declare_coloring(show_summary=False, show_sparsity=False)
        trajectory = p.model.add_subsystem("traj", dm.Trajectory())
        phase = dm.Phase(ode_class=Rates, transcription=dm.Radau(num_segments=30, order=3))
        trajectory.add_phase("p", phase)
        if case.duration:
            phase.set_time_options(fix_initial=True, fix_duration=True)
        else:
            phase.set_time_options(fix_initial=True, duration_bounds=(0.1, 100))
        for name, end in zip(names, case.end):
            phase.add_state(
                name,
                fix_initial=True,
                fix_final=end is not None,
                rate_source=name + "_rate",
                targets=[name],
            )
        phase.add_state("J", fix_initial=True, rate_source="J_rate")
        phase.add_control(
            "u", lower=-1, upper=1, continuity=False, rate_continuity=False, targets=["u"]
        )
        phase.add_objective("J", loc="final")
        p.setup()
        phase.set_time_val(0, case.duration or guess_time)
        for name, way in zip(names, case.ways):
            phase.set_state_val(name, way)
        phase.set_state_val("J", [0, 1])
        phase.set_control_val("u", [0, 0])
        dm.run_problem(p, run_driver=True, simulate=False)
        if not p.driver.result.success:
            raise RuntimeError("SLSQP did not converge")
        times, u = (p.get_val(f"traj.p.timeseries.{name}").ravel() for name in ("time", "u"))
        return float(p.get_val("traj.p.timeseries.J")[-1, 0]), times.tolist(), u.tolist()

    return solve


PEERS = {
    "CasADi, RK4, N = 100": casadi_rk4,
    "rockit, multiple shooting, N = 100": rockit,
    "YAPSS, LGL 10 x 10": yapss,
    "YAPSS, LGL 40 x 10": lambda: yapss(40, 10),
    "dymos, Radau 30 x 3, SLSQP": dymos,
}


def main():
    peer, case, guess_time = sys.argv[1:]
    solve = PEERS[peer]()
    start = time.perf_counter()
    cost, times, controls = solve(CASES[case], float(guess_time))
    seconds, start = time.perf_counter() - start, time.process_time()
    solve(CASES[case], float(guess_time))
    result = {"cost": cost, "times": times, "controls": controls, "seconds": seconds}
    print("\n" + json.dumps(result | {"again": time.process_time() - start}))


if __name__ == "__main__":
    main()
