"""Integration of all reference curves together, with the domain of the equations checked."""

import numpy as np

#: The solver's own bound for the relative tolerance is slightly lower.
SHARPEST = 3e-14
#: A step that is shorter than this share of the time means that a curve cannot be continued.
SHORTEST = 1e-9
#: Curves that are integrated together: what fits into the cache.
CURVES = 1000


class Flow:
    """The equations and their integration, all curves together."""

    def __init__(self, f, domain, n, parameters, begin, rtol):
        self.f, self.domain, self.n, self.parameters, self.begin, self.rtol = (
            f,
            domain,
            n,
            parameters,
            begin,
            rtol,
        )

    def rates(self, t, x, p):
        """f as one array of the shape of x."""
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
        """Shape (n, times, curves), from starts of shape (n + parameters, curves)."""
        if times[0] < self.begin:
            raise ValueError(f"t: the curves start at {self.begin:g}, {times[0]:g} is before that")
        parts = [
            self._together(times, starts[:, k : k + CURVES])
            for k in range(0, starts.shape[1], CURVES)
        ]
        return np.concatenate(parts, axis=2)

    def _together(self, times, starts):
        from scipy.integrate import DOP853

        x0, p = starts[: self.n], starts[self.n :]
        length, outside = times[-1] - self.begin, np.zeros(x0.shape[1], dtype=bool)

        def rates(t, y):
            x = y.reshape(x0.shape)
            with np.errstate(all="ignore"):
                found = self.rates(t, x, p)
                off = ~(np.isfinite(found).all(axis=0) & self._inside(t, x, p))
            if off.any():
                # of the last, the shortest trial those are left that are at the border
                outside[:] = off
            # A step that meets nan is refused by the solver and tried shorter, until it gives up at
            # the border.
            return np.where(off, np.nan, found).ravel()

        at_start = rates(self.begin, x0.ravel()).reshape(x0.shape)
        if outside.any():
            self._refuse(self.begin, starts, outside)
        found = np.empty((times.size, x0.size))
        found[times == self.begin] = x0.ravel()
        if length:
            sizes, moved = np.abs(x0).max(axis=1), np.abs(at_start).max(axis=1) * length
            sizes = np.where(sizes > 0, sizes, np.where(moved > 0, moved, 1.0))[:, None]
            # The solver bounds the mean square over all curves; each of them is to keep the
            # tolerance.
            share = self.rtol * x0.shape[1] ** -0.5
            with np.errstate(all="ignore"):
                solver = DOP853(
                    rates,
                    self.begin,
                    x0.ravel(),
                    times[-1],
                    rtol=max(share, SHARPEST),
                    atol=np.repeat(sizes, x0.shape[1]) * share,
                )
                while solver.status == "running":
                    outside[:] = False
                    solver.step()
                    stuck = solver.t < times[-1] and solver.step_size < SHORTEST * length
                    if stuck or solver.status == "failed":
                        x, speed = (part.reshape(x0.shape) for part in (solver.y, solver.f))
                        escaping = np.abs(speed / (np.abs(x) + sizes)).max(axis=0)
                        self._refuse(
                            solver.t,
                            starts,
                            outside if outside.any() else escaping == escaping.max(),
                        )
                    passed = (times > solver.t_old) & (times <= solver.t)
                    if passed.any():
                        found[passed] = solver.dense_output()(times[passed]).T
        return np.moveaxis(found.reshape(times.size, *x0.shape), 1, 0)

    def _inside(self, t, x, p):
        if self.domain is None:
            return True
        return self.domain(t, x, p) if self.parameters else self.domain(t, x)

    def _refuse(self, t, starts, which):
        start = starts[:, np.flatnonzero(which)[0]]
        names = [f"x0[{j}]" for j in range(self.n)] + [f"p[{j}]" for j in range(self.parameters)]
        at = ", ".join(f"{name} = {value:.6g}" for name, value in zip(names, start))
        raise ArithmeticError(
            f"f: the curve from {at} leaves the domain where f is defined, or escapes to infinity, "
            f"at t = {t:.6g}; narrow the box or end earlier"
        )
