# %% wrong
control = a  # Is a constant force the cheapest? (hint 2)
control = 4 * a / sp.pi * sp.sin(t)  # Which costate vanishes at the end? (hint 1)
control = a * sp.cos(t)  # Does this force bring the mass to the position? (hint 3)
# Is this the force for a mass that is to be at rest at the end? (hint 1)
control = 4 * a * (sp.pi * sp.cos(t) - 2 * sp.sin(t)) / (sp.pi**2 - 4)
trajectory = a * sp.sin(t)  # Is the mass at rest at $t = 0$? (hint 1)
trajectory = a * (1 - sp.cos(t))  # Is this the motion under a constant force? (hint 1)
trajectory = 2 * a / sp.pi * t  # Which force does this motion need? (hint 1)
cost = sp.pi * a**2 / 2  # Is this the cost of a constant force? (hint 1)
cost = 2 * a**2 / sp.pi  # Was a factor lost in the integral of the square? (hint 1)
cost = 4 * a / sp.pi  # How does the cost grow with a? (hint 1)
# Is the control psi2, or a part of it? (hint 1)
costate = [4 * a / sp.pi * sp.sin(t), 4 * a / sp.pi * sp.cos(t)]
# Which costate vanishes at the end? (hint 1)
costate = [8 * a / sp.pi * sp.cos(t), -8 * a / sp.pi * sp.sin(t)]
# Which sign does psi1 have in the equation for psi2? (hint 1)
costate = [-8 * a / sp.pi * sp.sin(t), 8 * a / sp.pi * sp.cos(t)]
fixed_control = 4 * a / sp.pi * sp.cos(t)  # With which velocity does this force arrive? (hint 2)
# Which sign does the braking part have? (hint 2)
fixed_control = 4 * a * (sp.pi * sp.cos(t) + 2 * sp.sin(t)) / (sp.pi**2 - 4)
fixed_control = 2 * a * sp.cos(2 * t)  # Is this a solution of the adjoint equation? (hint 1)
fixed_cost = 4 * a**2 / sp.pi  # Can the additional condition be had for nothing? (hint 1)
# Was a factor lost with the inverse of the Gramian? (hint 1)
fixed_cost = 4 * a**2 / (sp.pi**2 - 4)

# %% right
control = 4 * a / sp.pi * sp.sin(sp.pi / 2 - t)  # the sine of the remaining time
control = 1.273 * a * sp.cos(t)  # decimals
# both states
trajectory = [
    2 * a * t * sp.sin(t) / sp.pi,
    2 * a * (sp.sin(t) + t * sp.cos(t)) / sp.pi,
]
cost = 1.2732 * a**2  # decimals
cost = (2 * a) ** 2 / sp.pi  # a square
# a column, other angles
costate = sp.Matrix(
    [8 * a * sp.cos(sp.pi / 2 - t) / sp.pi, 8 * a * (1 - 2 * sp.sin(t / 2) ** 2) / sp.pi]
)
# one cosine
fixed_control = 4 * a * sp.sqrt(sp.pi**2 + 4) * sp.cos(t + sp.atan(2 / sp.pi)) / (sp.pi**2 - 4)
fixed_cost = a**2 * (1 / (sp.pi - 2) + 1 / (sp.pi + 2)) * 2  # partial fractions
