# %% wrong
a_control = -sp.sign(x0)  # What happens when zero has been reached? (hint 2)
a_control = sp.sign(x0)  # Does this lead towards zero? (hint 1)
a_control = -x0 / T  # Should zero be reached only at the final time? (hint 1)
a_trajectory = x0 - t  # On which side of zero is the initial state? (hint 1)
a_trajectory = x0 - sp.sign(x0) * t  # What happens when zero has been reached? (hint 1)
a_trajectory = x0 * (1 - t / T)  # Does this motion go as fast as it may? (hint 1)
a_cost = sp.Abs(x0) ** 3 / 6  # Is zero always reached in time? (hint 1)
a_cost = x0**3 / 6  # Can the cost be negative? (hint 1)
a_cost = x0**2 * T / 2  # Is this the cost of not moving? (hint 1)
a_costate = 0  # Is $\psi$ zero before the motion has reached zero? (hint 1)
a_costate = -x0  # Is this a solution of the adjoint equation? (hint 1)
# Which sign must $\psi$ have for the control that leads to zero? (hint 1)
a_costate = sp.Piecewise((sp.sign(x0) * (sp.Abs(x0) - t) ** 2 / 2, t < sp.Abs(x0)), (0, True))
# Does this law stay within the bounds for large initial values? (hint 2)
b_law = -x * sp.tanh(T - t)
b_law = -sp.sign(x)  # Is this the law of item a? (hint 1)
# Is this the law for an infinite time? (hint 1)
b_law = sp.Piecewise((-x, sp.Abs(x) <= 1), (-sp.sign(x), True))
# Does the elapsed time matter, or the remaining time? (hint 1)
b_law = sp.Piecewise((-x * sp.tanh(t), sp.Abs(x * sp.tanh(t)) <= 1), (-sp.sign(x), True))
b_control = -x0 * sp.exp(-t)  # Is this the control for an infinite time? (hint 1)
b_control = -x0 * sp.cosh(T - t) / sp.sinh(T)  # What is the velocity at a free end? (hint 1)
b_control = -sp.sign(x0)  # Is this the control of item a? (hint 1)
b_trajectory = x0 * sp.exp(-t)  # Is this the motion for an infinite time? (hint 1)
b_trajectory = x0 * sp.sinh(T - t) / sp.sinh(T)  # Is the end given, or free? (hint 1)
b_trajectory = x0 * sp.cosh(t) / sp.cosh(T)  # Does this motion begin at the initial state? (hint 1)
b_cost = x0**2 / 2  # Is this the cost for an infinite time? (hint 1)
b_cost = x0**2 * sp.tanh(T)  # Was the factor in the cost forgotten? (hint 1)
b_cost = x0**2 * sp.coth(T) / 2  # Is this the cost with the end at zero? (hint 1)

# %% right
a_control = -sp.sign(x0) * sp.Heaviside(sp.Abs(x0) - t)  # with Heaviside's function
# both signs of the start apart
a_control = sp.Piecewise((-1, sp.And(x0 > 0, t < x0)), (1, sp.And(x0 < 0, t < -x0)), (0, True))
# cases
a_trajectory = sp.Piecewise((x0 - sp.sign(x0) * t, t < sp.Abs(x0)), (0, True))
# cases in T
a_cost = sp.Piecewise(
    (sp.Abs(x0) ** 3 / 6, sp.Abs(x0) <= T), (T * (3 * x0**2 - 3 * T * sp.Abs(x0) + T**2) / 6, True)
)
# with Max
a_costate = sp.sign(x0) * (sp.Max(sp.Abs(x0) - T, 0) ** 2 - sp.Max(sp.Abs(x0) - t, 0) ** 2) / 2
b_law = -sp.Max(-1, sp.Min(1, x * sp.tanh(T - t)))  # with Max and Min
b_control = -x0 * (sp.tanh(T) * sp.cosh(t) - sp.sinh(t))  # as a sum
b_trajectory = x0 * (sp.cosh(t) - sp.tanh(T) * sp.sinh(t))  # as a sum
b_cost = x0**2 * (sp.exp(2 * T) - 1) / (sp.exp(2 * T) + 1) / 2  # with exponentials
