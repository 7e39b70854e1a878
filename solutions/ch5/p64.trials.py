# %% wrong
# In which direction of time does this equation hold? (hint 1)
rate = sp.Matrix([[-(s12**2), s11 - s12 * s22], [s11 - s12 * s22, 2 * s12 - s22**2]])
# Is this the linear equation, with the square left out? (hint 1)
rate = sp.Matrix([[0, -s11], [-s11, -2 * s12]])
# Was A used instead of its transpose? (hint 2)
rate = sp.Matrix([[s12**2 - 2 * s12, s12 * s22 - s22], [s12 * s22 - s22, s22**2]])
# Does the running cost contain the state? (hint 2)
rate = sp.Matrix([[s12**2 - 1, s12 * s22 - s11], [s12 * s22 - s11, s22**2 - 2 * s12 - 1]])
# Is t the remaining time, or the time that has passed? (hint 1)
S = S.subs(t, horizon - t)
# Is this the terminal weight, without the factor that both terms of J have? (hint 1)
S = S / 2
# Does the cost of a state not depend on the remaining time? (hint 1)
S = sp.diag(*weights)
S = S.inv().applyfunc(sp.factor)  # Is this the inverse of the required matrix? (hint 2)
gain = [-entry for entry in gain]  # Which sign does a braking feedback $u = Kx$ have? (hint 1)
# Do these gains belong to the remaining time, or to the time that has passed? (hint 1)
gain = [entry.subs(t, horizon - t) for entry in gain]
gain = list(-S.row(0))  # Is this the first row of S? (hint 2)
# Is the gain at the initial time also right at the final time?
gain = [entry.subs(t, 0) for entry in gain]
gain = [0, 0]  # This is the limit for a long time. How long is the horizon? (hint 1)
cost = 2 * cost  # Was a factor in front of the cost lost? (hint 1)
# How often does a product occur in a quadratic form? (hint 1)
cost = (cost + cost.subs(x10, 0) + cost.subs(x20, 0)) / 2
# Is this the terminal cost if nothing moves? (hint 1)
cost = (weights[0] * x10**2 + weights[1] * x20**2) / 2
# Is this the cost without any control? (hint 1)
cost = (weights[0] * (x10 + horizon * x20) ** 2 + weights[1] * x20**2) / 2

# %% right
# the left-hand side of a symmetric product
rate = sp.Matrix([[s12**2, s12 * s22], [s12 * s22, s22**2]]) - sp.Matrix([[0, s11], [s11, 2 * s12]])
# the inverse of P
tau, first, last = horizon - t, *(1 / sp.Integer(weight) for weight in weights)
coupling = -last * tau - tau**2 / 2
S = sp.Matrix([[first + last * tau**2 + tau**3 / 3, coupling], [coupling, last + tau]]).inv()
gain = [sp.expand(sp.numer(-entry)) / sp.expand(sp.denom(entry)) for entry in S.row(1)]  # from S
# a sum of squares
(s11, s12), (_, s22) = S.subs(t, 0).tolist()
cost = s11 / 2 * (x10 + s12 / s11 * x20) ** 2 + (s22 - s12**2 / s11) / 2 * x20**2

# %% numbers
horizon, weights = [
    *[(1, [1, 1]), (2, [1, 1]), (1, [2, 1]), (2, [1, 2]), (1, [1, 3]), (3, [1, 1]), (1, [3, 2])],
    *[(2, [2, 1]), (1, [1, 2]), (2, [1, 3]), (1, [4, 1]), (2, [3, 1]), (1, [2, 3]), (3, [2, 1])],
]
shown = [
    r"\int_0^«horizon»u^2\,dt + "
    r"\frac12\big(«weights[0]*»x_1^2(«horizon») + «weights[1]*»x_2^2(«horizon»)\big)"
]
# the inverse of S obeys a linear equation
tau, first, last = horizon - t, *(1 / sp.Integer(weight) for weight in weights)
p12, p22 = -last * tau - tau**2 / 2, last + tau
P = sp.Matrix([[first + last * tau**2 + tau**3 / 3, p12], [p12, p22]])
S = P.inv().applyfunc(sp.factor)
gain = list(-S.row(1))
cost = sp.expand((sp.Matrix(start).T * S.subs(t, 0) * sp.Matrix(start))[0] / 2)
