"""Extremals of x' = f0(x) + f1(x) u, u_- <= u <= u_+, integrated backwards from the target, all at once.

With reversed time tau = t_k - t

    dx/dtau = -f,   dpsi/dtau = (df/dx)^T psi,   u = u_+ where phi = psi^T f1 > 0,  u_- where phi < 0.

The derivative of the switching function does not contain the control, phi' = psi^T (Df1 f0 - Df0 f1): it tells the
control where phi starts from zero, and serves Newton's method that finds the moments of switching. Steps are taken by
extrapolation of the midpoint rule (Gragg, Bulirsch, Stoer) with four columns, that is, with order 8; at a switching the
step is divided.
"""
import numpy as np
import sympy as sp

#: Numbers of substeps of the extrapolated midpoint rule.
COLUMNS = (2, 4, 6, 8)
#: For so many steps an extremal that has met the target again is followed further, for neighbours that live longer:
#: the cells between them have to reach as far as these.
BEYOND = 4


class Plant:
    """The numeric right-hand sides of a planar system that is affine in its scalar control; states are arrays of shape
    (2, N)."""

    def __init__(self, field, state, control, bounds):
        x, psi = sp.Matrix(state), sp.Matrix(sp.symbols("psi_1:3"))
        f = sp.Matrix(field)
        self.low, self.high = map(float, bounds)
        drift, input_field = f.subs(control, 0), f.diff(control)
        bracket = input_field.jacobian(x)*drift - drift.jacobian(x)*input_field
        costate = f.jacobian(x).T*psi
        arguments = [*state, *psi, control]
        self._rate = stacked(arguments, [*(-f), *costate])
        self._drift, self._input = stacked(state, drift), stacked(state, input_field)
        self._bracket = stacked(state, bracket)
        #: det(f1, [f0, f1]): extremals can be singular only where it vanishes.
        self.singular = sp.simplify(sp.Matrix.hstack(input_field, bracket).det())
        self.singular_at = stacked(state, [self.singular])

    def velocity(self, x, sign):
        """x' for the control u_+ where `sign` > 0, u_- elsewhere; shape (2, N)."""
        return self._drift(*x) + self._input(*x)*self.control(sign)

    def control(self, sign):
        return np.where(np.asarray(sign) > 0, self.high, self.low)

    def switching(self, z):
        """phi = psi^T f1; z holds x and psi, shape (4, N)."""
        return (z[2:]*self._input(*z[:2])).sum(axis=0)

    def switching_rate(self, z):
        """dphi/dt, the same for every control."""
        return (z[2:]*self._bracket(*z[:2])).sum(axis=0)

    def greatest_rate(self, x, psi):
        """max over u of psi^T f(x, u)."""
        phi = (psi*self._input(*x)).sum(axis=0)
        return (psi*self._drift(*x)).sum(axis=0) + np.maximum(phi*self.low, phi*self.high)

    def first_sign(self, z):
        """+1 or -1 for the control just before the end; 0 where phi and its derivative vanish."""
        phi, scale = self.switching(z), np.hypot(*z[2:])*(1e-300 + np.hypot(*self._input(*z[:2])))
        before = np.where(np.abs(phi) > 1e-9*scale, phi, -self.switching_rate(z))
        return np.where(np.abs(before) > 1e-12*np.hypot(*z[2:]), np.sign(before), 0).astype(int)

    def step(self, z, sign, h):
        """One step of length `h` (a number or one a column) backwards in time with the control held."""
        with np.errstate(over="ignore", invalid="ignore"):      # what runs away to infinity leaves the box
            return self._extrapolated(z, self.control(sign), h)

    def _extrapolated(self, z, u, h):
        table = []
        first = self._rate(*z, u)
        for n in COLUMNS:
            d = h/n
            before, now = z, z + d*first
            for _ in range(n - 1):
                before, now = now, before + 2*d*self._rate(*now, u)
            row = [(before + now + d*self._rate(*now, u))/2]
            for k, earlier in enumerate(table[-1] if table else []):
                row.append(row[k] + (row[k] - earlier)/((n/COLUMNS[len(table) - k - 1])**2 - 1))
            table.append(row)
        return table[-1][-1]

    def advance(self, z, sign, h):
        """A step in which the control switches where phi changes its sign.

        Returns z and sign at its end, and the switchings on the way: (columns, share of time h gone, z there).
        """
        h = np.broadcast_to(np.asarray(h, dtype=float), sign.shape)
        gone, switchings = np.zeros(sign.shape), []
        start, sign = z, sign.copy()
        end = self.step(start, sign, h)
        for _ in range(4):
            late = np.flatnonzero(sign*self.switching(end) < 0)
            if not late.size:
                break
            when, there = self._first_zero(start[:, late], sign[late], (h - gone)[late], end[:, late])
            start = start.copy()
            start[:, late], gone[late] = there, gone[late] + when
            sign[late] *= -1
            switchings.append((late, gone[late], there))
            end = end.copy()
            end[:, late] = self.step(there, sign[late], h[late] - gone[late])
        return end, sign, switchings

    def _first_zero(self, z, sign, h, end):
        """Newton's method for phi = 0 in the step, with bisection where it would leave the bracket."""
        low, high = np.zeros(h.shape), h.copy()
        value, there = self.switching(end), end
        when = h.copy()
        for _ in range(40):
            slope = -self.switching_rate(there)
            with np.errstate(all="ignore"):
                new = when - value/slope
            bad = ~((new >= low) & (new <= high))
            new[bad] = ((low + high)/2)[bad]
            done = (np.abs(new - when) < 1e-13*h).all()
            when = new
            there = self.step(z, sign, when)
            if done:
                break
            value = self.switching(there)
            beyond = sign*value < 0
            low, high = np.where(beyond, low, when), np.where(beyond, when, high)
        return when, there


class Fan:
    """Extremals for the parameters s of a family of ends, on a grid of reversed times; `add` puts more between them.

    `path`, `costate`: shape (K + 1, 2, N), nan some steps after an extremal has died. `sign`, `count`: of the control,
    and the number of switchings so far, (K + 1, N). `switchings`: rows index of the extremal, tau, x1, x2. `life`: the
    last step at which it lives; `dead`: 1 if it then met the target again, 2 if it left the box. `cut`: when it stops
    to be optimal (set by `cut_at_overlaps`).
    """

    def __init__(self, plant, target, ends, horizon, steps, box):
        self.plant, self.target, self.ends = plant, target, ends
        self.times = np.linspace(0, horizon, steps + 1)
        self.box = box
        self.s = np.empty(0)
        self.flip = 1
        self._clear()

    def _clear(self):
        count = self.times.size
        self.path, self.costate = np.empty((count, 2, 0)), np.empty((count, 2, 0))
        self.sign, self.count = np.empty((count, 0), int), np.empty((count, 0), int)
        self.life, self.dead = np.empty(0, int), np.empty(0, int)
        self.switchings = np.empty((4, 0))

    def start(self, s):
        """z = (x, psi) at the end and the sign of the control before it."""
        z = np.vstack([self.ends.point(s), self.flip*self.ends.costate(s)])
        return z, self.plant.first_sign(z)

    def add(self, s):
        """Integrate extremals for more values of the parameter; the fan stays sorted by s."""
        s = np.asarray(s, dtype=float)
        path, costate, sign, number, life, dead, switchings = self._integrate(s)
        order = np.argsort(np.append(self.s, s), kind="stable")
        place = np.empty(order.size, int)
        place[order] = np.arange(order.size)
        old = self.switchings.copy()
        old[0] = place[old[0].astype(int)]
        switchings[0] = place[switchings[0].astype(int) + self.s.size]
        self.switchings = np.hstack([old, switchings])
        self.s = np.append(self.s, s)[order]
        self.path = np.concatenate([self.path, path], axis=2)[:, :, order]
        self.costate = np.concatenate([self.costate, costate], axis=2)[:, :, order]
        self.sign = np.concatenate([self.sign, sign], axis=1)[:, order]
        self.count = np.concatenate([self.count, number], axis=1)[:, order]
        self.life = np.append(self.life, life)[order]
        self.dead = np.append(self.dead, dead)[order]

    def _integrate(self, s):
        count = self.times.size
        z, sign = self.start(s)
        path, costate = np.full((count, 2, s.size), np.nan), np.full((count, 2, s.size), np.nan)
        signs, number = np.zeros((count, s.size), int), np.zeros((count, s.size), int)
        path[0], costate[0], signs[0] = z[:2], z[2:], sign
        # Where phi and its derivative vanish the extremal is singular; where the velocity is zero it never leaves.
        speed = np.hypot(*self.plant.velocity(z[:2], sign))
        active = (sign != 0) & (speed > 1e-12*(1 + np.nanmax(speed, initial=0)))
        life, dead = np.where(active, count - 1, 0), np.where(active, 0, 1)
        found = []
        h = self.times[1]
        (left, right), (bottom, top) = self.box
        for k in range(1, count):
            now = np.flatnonzero(active)
            if not now.size:
                break
            z_new, sign_new, switched = self.plant.advance(z[:, now], sign[now], h)
            z[:, now], sign[now] = z_new, sign_new
            number[k] = number[k - 1]
            for which, gone, there in switched:
                number[k, now[which]] += 1
                found.append(np.vstack([now[which], self.times[k - 1] + gone, there[:2]]))
            path[k][:, now], costate[k][:, now], signs[k, now] = z_new[:2], z_new[2:], sign_new
            x1, x2 = z_new[:2]
            met = self.target.outside(z_new[:2], self.ends.side) <= 0
            lost = ~((x1 >= left) & (x1 <= right) & (x2 >= bottom) & (x2 <= top))
            ended = (met | lost) & (dead[now] == 0)
            life[now[ended]] = k - 1
            dead[now[ended]] = np.where(met, 1, 2)[ended]
            active[now[lost | (k - life[now] >= BEYOND)]] = False
        return path, costate, signs, number, life, dead, np.hstack([np.empty((4, 0)), *found])

    def flow(self, s, tau):
        """State, costate and sign of the control at the reversed times `tau` on the extremals `s`, one to one."""
        s, tau = np.atleast_1d(np.asarray(s, float)), np.atleast_1d(np.asarray(tau, float))
        z, sign = self.start(np.clip(s, self.ends.low, self.ends.high))
        steps = self._long_steps(tau)
        for _ in range(steps):
            z, sign, _ = self.plant.advance(z, sign, tau/steps)
        return z, sign

    def arcs(self, s, tau, first, switchings):
        """Extremals with a given structure: first control `first` (+1, -1) backwards, then `switchings` switchings.

        The last arc begins at the last switching, wherever this is, and ends at `tau`, also if that is earlier: so the
        end is a smooth function of s and tau, to which Newton's method can be applied. Returns z, the sign of the
        control of the last arc and the reversed time of its begin; nan where there are not so many switchings.
        """
        z, _ = self.start(s)
        sign, begin = first.copy(), np.zeros(s.size)
        stride = 2*self.times[1]
        longest = self.times[-1] + 4*stride
        for n in range(switchings.max(initial=0)):
            waiting = np.flatnonzero(switchings > n)
            while waiting.size:
                now = z[:, waiting]
                end = self.plant.step(now, sign[waiting], stride)
                crossed = sign[waiting]*self.plant.switching(end) < 0
                ready = waiting[crossed]
                if ready.size:
                    when, there = self.plant._first_zero(now[:, crossed], sign[ready], np.full(ready.size, stride),
                                                         end[:, crossed])
                    z[:, ready], sign[ready] = there, -sign[ready]
                    begin[ready] += when
                waiting = waiting[~crossed]
                z[:, waiting] = end[:, ~crossed]
                begin[waiting] += stride
                lost = ~(begin[waiting] < longest)
                begin[waiting[lost]] = np.nan
                waiting = waiting[~lost]
        rest = tau - begin
        steps = self._long_steps(rest[np.isfinite(rest)])
        for _ in range(steps):
            z = self.plant.step(z, sign, rest/steps)
        return z, sign, begin

    def _long_steps(self, tau):
        """The grid of times is finer than the accuracy of the steps asks for."""
        return max(int(np.ceil(np.abs(tau).max(initial=0)/(2*self.times[1]))), 1)


def stacked(arguments, expressions):
    """A NumPy function with values of shape (len(expressions), N), also for constants."""
    # The module itself, not its name, for which SymPy would import all that NumPy has, which takes half a second.
    raw = sp.lambdify(list(arguments), list(expressions), [np], cse=True)

    def value(*numbers):
        parts = raw(*numbers)
        shape = np.broadcast(*numbers).shape
        result = np.empty((len(parts), *shape))
        for k, part in enumerate(parts):
            result[k] = part
        return result

    return value
