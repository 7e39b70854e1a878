# %% wrong
limit = 2 * limit  # Does an entry of the noise enter twice? (hint 1)
limit = limit[0, 0] * sp.eye(2)  # Is the speed as large as the position? (hint 2)
limit = sp.diag(limit[1, 1], limit[0, 0])  # Were the two coordinates interchanged?
limit = sp.zeros(2)  # The free motion decays. What is the effect of the noise? (hint 1)
# Is there one exponential only? (hint 1)
slow = max(process.A.eigenvals())
motion = limit * (1 - sp.exp(2 * slow * t))
# An impulse changes x and its rate. Was their correlation left out? (hint 2)
motion = sp.diag(motion[0, 0], motion[1, 1])
motion = limit  # What is the value of this matrix at $t = 0$?

# %% right
# by the matrix exponential
E = (process.A * t).exp()
motion = limit - E * limit * E.T

# %% numbers
stiffness, friction = [
    (p * q, p + q)
    for p, q in [
        *[(2, 3), (1, 2), (1, 3), (1, 4), (1, 5), (2, 4), (2, 5), (2, 6)],
        *[(3, 4), (3, 5), (3, 6), (4, 5), (4, 6), (5, 6)],
    ]
]
shown = [r"\ddot x + «friction*»\dot x + «stiffness*»x = q"]
limit = sp.diag(sp.Rational(1, 2 * stiffness * friction), sp.Rational(1, 2 * friction))
s = sp.Symbol("s")
slow, fast = sorted(process.A.eigenvals(), reverse=True)
push = (sp.exp(slow * s) - sp.exp(fast * s)) / (slow - fast)
pushes = sp.Matrix([push, push.diff(s)])
motion = (pushes * pushes.T).applyfunc(lambda e: sp.integrate(sp.expand(e), (s, 0, t)))
