"""Integration of all reference curves together, with the domain of the equations checked."""

import numpy as np

#: The solver's own bound for the relative tolerance is slightly lower.
SHARPEST = 3e-14
#: A step that is shorter than this share of the time means that a curve cannot be continued.
SHORTEST = 1e-9
#: Curves that are integrated together: what fits into the cache.
CURVES = 1000


class Flow:
    """Equations of motion and their integration, all curves together."""

    def __init__(self, f, domain, n, parameters, begin, rtol) -> None:
        self.f, self.domain, self.n, self.parameters, self.begin, self.rtol = (
            f,
            domain,
            n,
            parameters,
            begin,
            rtol,
        )

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
        from scipy.integrate import DOP853

        x0, p = starts[: self.n], starts[self.n :]
        length, outside = times[-1] - self.begin, np.zeros(x0.shape[1], dtype=bool)

        def rates(t, y):
            x = y.reshape(x0.shape)
            with np.errstate(all="ignore"):
                derivatives = self.rates(t, x, p)
                undefined = ~(np.isfinite(derivatives).all(axis=0) & self._inside(t, x, p))
            if undefined.any():
                # after the last, shortest trial these are the curves at the border
                outside[:] = undefined
            # The solver refuses a step with nan and tries a shorter one, until it fails at the
            # border.
            return np.where(undefined, np.nan, derivatives).ravel()

        at_start = rates(self.begin, x0.ravel()).reshape(x0.shape)
        if outside.any():
            self._raise_left_domain(self.begin, starts, outside)
        states = np.empty((times.size, x0.size))
        states[times == self.begin] = x0.ravel()
        if length:
            sizes, travel = np.abs(x0).max(axis=1), np.abs(at_start).max(axis=1) * length
            sizes = np.where(sizes > 0, sizes, np.where(travel > 0, travel, 1.0))[:, None]
            # The solver bounds the mean square over all curves; each of them has to keep the
            # tolerance.
            tolerance = self.rtol * x0.shape[1] ** -0.5
            with np.errstate(all="ignore"):
                solver = DOP853(
                    rates,
                    self.begin,
                    x0.ravel(),
                    times[-1],
                    rtol=max(tolerance, SHARPEST),
                    atol=np.repeat(sizes, x0.shape[1]) * tolerance,
                )
                while solver.status == "running":
                    outside[:] = False
                    solver.step()
                    stalled = solver.t < times[-1] and solver.step_size < SHORTEST * length
                    if stalled or solver.status == "failed":
                        x, speed = (part.reshape(x0.shape) for part in (solver.y, solver.f))
                        escaping = np.abs(speed / (np.abs(x) + sizes)).max(axis=0)
                        self._raise_left_domain(
                            solver.t,
                            starts,
                            outside if outside.any() else escaping == escaping.max(),
                        )
                    now = (times > solver.t_old) & (times <= solver.t)
                    if now.any():
                        states[now] = solver.dense_output()(times[now]).T
        return np.moveaxis(states.reshape(times.size, *x0.shape), 1, 0)

    def _inside(self, t, x, p):
        if self.domain is None:
            return True
        return self.domain(t, x, p) if self.parameters else self.domain(t, x)

    def _raise_left_domain(self, t, starts, which):
        start = starts[:, np.flatnonzero(which)[0]]
        names = [f"x0[{j}]" for j in range(self.n)] + [f"p[{j}]" for j in range(self.parameters)]
        at = ", ".join(f"{name} = {value:.6g}" for name, value in zip(names, start))
        raise ArithmeticError(
            f"f: the curve from {at} leaves the domain where f is defined, or escapes to infinity, "
            f"at t = {t:.6g}; narrow the box or end earlier"
        )
