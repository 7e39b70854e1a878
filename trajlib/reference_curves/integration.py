"""Integration of all reference curves together, with the domain of the equations checked."""

import numpy as np

from trajlib._arguments.integration import Budget, read_method

#: The solver's own bound for the relative tolerance is slightly lower.
SHARPEST = 3e-14
#: A step that is shorter than this share of the time means that a curve cannot be continued.
SHORTEST = 1e-9
#: Curves that are integrated together: what fits into the cache.
CURVES = 1000


class Flow:
    """Equations of motion and their integration, all curves together."""

    def __init__(self, f, domain, n, parameters, begin, rtol, method, max_evaluations) -> None:
        self.f, self.domain, self.n, self.parameters = f, domain, n, parameters
        self.begin, self.rtol, self.method = begin, rtol, read_method(method)
        self.max_evaluations = max_evaluations

    def rates(self, t, x, p):
        """Return f as one array of the shape of x."""
        try:
            rates = self.f(t, x, p) if self.parameters else self.f(t, x)
        except (TypeError, ValueError, IndexError) as reason:
            call = f"(t, x, p) with {self.parameters} parameters" if self.parameters else "(t, x)"
            raise type(reason)(
                f"f: it failed ({reason}); it is called as {call} and {self.n} components of the "
                "state, arrays, so it takes NumPy's functions and not those of math"
            ) from None
        if len(rates) != self.n:
            raise ValueError(
                f"f: expected {self.n} derivatives, one for each component of the state, got "
                f"{len(rates)}"
            )
        return np.stack([np.broadcast_to(rate, np.shape(x[0])) for rate in rates]).astype(float)

    def states(self, times, starts):
        """Return states, shape (n, times, curves), from starts, shape (n + parameters, curves)."""
        if times[0] < self.begin:
            raise ValueError(f"t: the curves start at {self.begin:g}, {times[0]:g} is before that")
        parts = [
            self._integrate_batch(times, starts[:, k : k + CURVES])
            for k in range(0, starts.shape[1], CURVES)
        ]
        return np.concatenate(parts, axis=2)

    def _integrate_batch(self, times, starts):
        x0 = starts[: self.n]
        length, equations = times[-1] - self.begin, _Batch(self, starts)
        at_start = equations(self.begin, x0.ravel()).reshape(x0.shape)
        if equations.outside.any():
            self._raise_left_domain(self.begin, starts, equations.outside)
        states = np.empty((times.size, x0.size))
        states[times == self.begin] = x0.ravel()
        if length:
            sizes, travel = np.abs(x0).max(axis=1), np.abs(at_start).max(axis=1) * length
            sizes = np.where(sizes > 0, sizes, np.where(travel > 0, travel, 1.0))[:, None]
            later = times > self.begin
            states[later] = equations.integrate(times[later], sizes)
        return np.moveaxis(states.reshape(times.size, *x0.shape), 1, 0)

    def _inside(self, t, x, p):
        if self.domain is None:
            return True
        return self.domain(t, x, p) if self.parameters else self.domain(t, x)

    def _raise_left_domain(self, t, starts, outside):
        start = starts[:, np.flatnonzero(outside)[0]]
        names = [f"x0[{j}]" for j in range(self.n)] + [f"p[{j}]" for j in range(self.parameters)]
        at = ", ".join(f"{name} = {value:.6g}" for name, value in zip(names, start))
        raise ArithmeticError(
            f"f: the curve from {at} leaves the domain where f is defined, or escapes to infinity, "
            f"at t = {t:.6g}; narrow the box or end earlier"
        )


class _Batch:
    """Equations of some curves, one vector for all of their states, and their integration."""

    def __init__(self, flow, starts) -> None:
        self.flow, self.starts = flow, starts
        self.x0, self.p = starts[: flow.n], starts[flow.n :]
        self.outside = np.zeros(starts.shape[1], dtype=bool)
        self.budget = Budget(flow.max_evaluations, flow.method)

    def __call__(self, t, y):
        self.budget.spend(t)
        x = y.reshape(self.x0.shape)
        with np.errstate(all="ignore"):
            derivatives = self.flow.rates(t, x, self.p)
            undefined = ~(np.isfinite(derivatives).all(axis=0) & self.flow._inside(t, x, self.p))
        if undefined.any():
            # after the last, shortest trial these are the curves at the border
            self.outside[:] = undefined
        # The solver refuses a step with nan and tries a shorter one, until it fails at the border.
        return np.where(undefined, np.nan, derivatives).ravel()

    def integrate(self, times, sizes):
        """Return the states at increasing times after the initial one, shape (times, states)."""
        if self.flow.method == "DOP853":
            return self._leg(self.flow.begin, self.x0.ravel(), times, sizes, times[-1])
        # Between the steps of an implicit method its states are known to the third order only.
        states, begin, state = [], self.flow.begin, self.x0.ravel()
        for end in times:
            state = self._leg(begin, state, np.array([end]), sizes, times[-1])[0]
            states.append(state)
            begin = end
        return np.array(states)

    def _leg(self, begin, state, times, sizes, last):
        states, length = np.empty((times.size, state.size)), last - self.flow.begin
        with np.errstate(all="ignore"):
            solver = self._solver(begin, state, times[-1], sizes)
            while solver.status == "running":
                self.outside[:] = False
                solver.step()
                stalled = solver.t < times[-1] and solver.step_size < SHORTEST * length
                if stalled or solver.status == "failed":
                    self._raise_stopped(solver, sizes)
                now = (times > solver.t_old) & (times <= solver.t)
                if now.any():
                    states[now] = solver.dense_output()(times[now]).T
        return states

    def _solver(self, begin, state, end, sizes):
        from scipy import integrate, sparse

        n, curves = self.x0.shape
        # The solver bounds the mean square over all curves; each of them has to keep the tolerance.
        tolerance = self.flow.rtol * curves**-0.5
        options = {
            "rtol": max(tolerance, SHARPEST),
            "atol": np.repeat(sizes, curves) * tolerance,
        }
        if self.flow.method == "Radau":
            # a curve does not depend on another
            options["jac_sparsity"] = sparse.kron(np.ones((n, n)), sparse.eye(curves))
        return getattr(integrate, self.flow.method)(self, begin, state, end, **options)

    def _raise_stopped(self, solver, sizes):
        x, speed = (part.reshape(self.x0.shape) for part in (solver.y, solver.f))
        escaping = np.abs(speed / (np.abs(x) + sizes)).max(axis=0)
        self.flow._raise_left_domain(
            solver.t,
            self.starts,
            self.outside if self.outside.any() else escaping == escaping.max(),
        )
