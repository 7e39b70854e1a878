# %% wrong
# In which direction of time does this equation run? (hint 1)
rate = sp.Matrix([[-(s12**2), s11 - s12 * s22], [s11 - s12 * s22, 2 * s12 - s22**2]])
# Is this the linear equation, with the square left out? (hint 1)
rate = sp.Matrix([[0, -s11], [-s11, -2 * s12]])
# Was A put in the place of its transpose? (hint 2)
rate = sp.Matrix([[s12**2 - 2 * s12, s12 * s22 - s22], [s12 * s22 - s22, s22**2]])
# Is the state paid for on the way? (hint 2)
rate = sp.Matrix([[s12**2 - 1, s12 * s22 - s11], [s12 * s22 - s11, s22**2 - 2 * s12 - 1]])
# Is this the cost with t left, instead of the time from t to the end? (hint 1)
S = S.subs(t, horizon - t)
# Is the price of the end this one, without the factor that both terms of J have? (hint 1)
S = S / 2
# Does the price of a state not change with the time that is left? (hint 1)
S = sp.diag(*weights)
S = S.inv().applyfunc(sp.factor)  # Is this the inverse of the matrix that was asked for? (hint 2)
gain = [-entry for entry in gain]  # Which sign has a feedback $u = Kx$ that brakes? (hint 1)
# Do these gains belong to the time that is left, or to the time that has gone? (hint 1)
gain = [entry.subs(t, horizon - t) for entry in gain]
gain = list(-S.row(0))  # Is this the first row of S? (hint 2)
# Is the gain at the initial time also right at the final time?
gain = [entry.subs(t, 0) for entry in gain]
gain = [0, 0]  # The limit for very much time: how much is there? (hint 1)
cost = 2 * cost  # Was a factor before the cost lost? (hint 1)
# How often does a product occur in a quadratic form? (hint 1)
cost = (cost + cost.subs(x10, 0) + cost.subs(x20, 0)) / 2
# Is this what is paid at the end if nothing moves? (hint 1)
cost = (weights[0] * x10**2 + weights[1] * x20**2) / 2
# Is this the price without any control? (hint 1)
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
