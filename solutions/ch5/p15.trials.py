# %% wrong
# Are the two arcs interchanged? Where does the spring take energy from the mass? (hint 1)
control = sp.Piecewise((u_max, t < sp.pi / (2 * sp.sqrt(u_max))), (u_min, True))
control = u_max  # Should the spring be stiff on the way out, too? (hint 1)
control = u_min  # Should the spring stay soft on the way back, too? (hint 1)
# Does the switching time belong to the frequency of the way out? (hint 1)
control = sp.Piecewise((u_min, t < sp.pi / (2 * sp.sqrt(u_max))), (u_max, True))
# Is the stiffness the frequency? (hint 2)
control = sp.Piecewise((u_min, t < sp.pi / (2 * u_min)), (u_max, True))
# Does the stiffness stay the same? (hint 1)
trajectory = sp.sin(sp.sqrt(u_min) * t) / sp.sqrt(u_min)
trajectory = sp.sin(sp.sqrt(u_min) * t)  # Is the initial velocity the given one? (hint 1)
# Does the mass reverse at the same position on both arcs? (hint 1)
trajectory = sp.Piecewise(
    (sp.sin(sp.sqrt(u_min) * t) / sp.sqrt(u_min), t < sp.pi / (2 * sp.sqrt(u_min))),
    (sp.cos(sp.sqrt(u_max) * (t - sp.pi / (2 * sp.sqrt(u_min)))) / sp.sqrt(u_max), True),
)
duration = sp.pi / sp.sqrt(u_max)  # Does the stiff spring act all the time? (hint 1)
duration = sp.pi / sp.sqrt(u_min)  # Does the soft spring act all the time? (hint 1)
# Are these halves of oscillations, not quarters? (hint 1)
duration = sp.pi * (1 / sp.sqrt(u_min) + 1 / sp.sqrt(u_max))
cost = -1  # Is the speed kept, as with a constant spring? (hint 1)
cost = sp.sqrt(u_max / u_min)  # In which direction does the mass return? (hint 1)
cost = -u_max / u_min  # Does the energy give the velocity or its square? (hint 1)
cost = -sp.sqrt(u_min / u_max)  # Is this the slowest return? (hint 1)
# Are these the costates of a cost with the other sign? (hint 1)
costate = [
    -sp.sqrt(u_max) * sp.sin(sp.sqrt(u_min) * t),
    -sp.sqrt(u_max / u_min) * sp.cos(sp.sqrt(u_min) * t),
]
# Was the switching forgotten? (hint 3)
costate = [
    sp.sqrt(u_max) * sp.sin(sp.sqrt(u_min) * t),
    sp.sqrt(u_max / u_min) * sp.cos(sp.sqrt(u_min) * t),
]
costate = [sp.Integer(-1), t]  # Which of the two costates is given at the end? (hint 1)

# %% right
# a list of arcs
control = [
    [u_min, sp.pi / (2 * sp.sqrt(u_min))],
    [u_max, sp.pi / 2 * (1 / sp.sqrt(u_min) + 1 / sp.sqrt(u_max))],
]
# with Heaviside's function
control = u_min + (u_max - u_min) * sp.Heaviside(t - sp.pi / (2 * sp.sqrt(u_min)))
# the sine of a shifted time
trajectory = sp.Piecewise(
    (sp.cos(sp.sqrt(u_min) * t - sp.pi / 2) / sp.sqrt(u_min), t < sp.pi / (2 * sp.sqrt(u_min))),
    (
        sp.sin(sp.pi / 2 - sp.sqrt(u_max) * (t - sp.pi / (2 * sp.sqrt(u_min)))) / sp.sqrt(u_min),
        True,
    ),
)
# over a common denominator
duration = sp.pi * (sp.sqrt(u_min) + sp.sqrt(u_max)) / (2 * sp.sqrt(u_min * u_max))
cost = -sp.sqrt(u_max) / sp.sqrt(u_min)  # two roots
cost = -sp.exp(sp.log(u_max / u_min) / 2)  # through logarithms
# a column
costate = sp.Matrix(
    [
        sp.Piecewise(
            (
                sp.sqrt(u_max) * sp.cos(sp.sqrt(u_min) * t - sp.pi / 2),
                t < sp.pi / (2 * sp.sqrt(u_min)),
            ),
            (sp.sqrt(u_max) * sp.cos(sp.sqrt(u_max) * (t - sp.pi / (2 * sp.sqrt(u_min)))), True),
        ),
        sp.Piecewise(
            (
                sp.sqrt(u_max) * sp.cos(sp.sqrt(u_min) * t) / sp.sqrt(u_min),
                t < sp.pi / (2 * sp.sqrt(u_min)),
            ),
            (sp.sin(sp.sqrt(u_max) * (sp.pi / (2 * sp.sqrt(u_min)) - t)), True),
        ),
    ]
)
