# %% wrong
# Are the two arcs interchanged? Where does the spring give energy to the mass? (hint 1)
control = sp.Piecewise((u_min, t < sp.pi / (2 * sp.sqrt(u_min))), (u_max, True))
control = u_max  # Should the spring stay stiff on the way out, too? (hint 1)
control = u_min  # Should the spring be soft on the way in, too? (hint 1)
# Does this switching time belong to the frequency of the soft spring? (hint 2)
control = sp.Piecewise((u_max, t < sp.pi / (2 * sp.sqrt(u_min))), (u_min, True))
# Is the stiffness the frequency? (hint 2)
control = sp.Piecewise((u_max, t < sp.pi / (2 * u_max)), (u_min, True))
trajectory = sp.cos(sp.sqrt(u_max) * t)  # Does the stiffness stay the same? (hint 1)
trajectory = -sp.sin(sp.sqrt(u_max) * t)  # Does this motion start at the initial state? (hint 1)
# Is the amplitude of the second arc that of the first? Look at the velocities. (hint 1)
trajectory = sp.Piecewise(
    (sp.cos(sp.sqrt(u_max) * t), t < sp.pi / (2 * sp.sqrt(u_max))),
    (-sp.sin(sp.sqrt(u_min) * (t - sp.pi / (2 * sp.sqrt(u_max)))), True),
)
duration = sp.pi / sp.sqrt(u_max)  # Does the stiff spring act all the time? (hint 1)
duration = sp.pi / sp.sqrt(u_min)  # Does the soft spring act all the time? (hint 1)
# Are these halves of oscillations, not quarters? (hint 1)
duration = sp.pi * (1 / sp.sqrt(u_min) + 1 / sp.sqrt(u_max))
# Is the mean of the frequencies the right one? (hint 1)
duration = 2 * sp.pi / (sp.sqrt(u_min) + sp.sqrt(u_max))
cost = -1  # Is the amplitude kept, as with a constant spring? (hint 1)
cost = sp.sqrt(u_max / u_min)  # On which side does the mass come to rest? (hint 1)
cost = -u_max / u_min  # Does the energy give the velocity or its square? (hint 1)
cost = -sp.sqrt(u_min / u_max)  # Is this the nearest equilibrium? (hint 1)
# Does H grow with u where it should? Look at the sign of the costate at the end. (hint 1)
costate = [
    -sp.sqrt(u_max / u_min) * sp.cos(sp.sqrt(u_max) * t),
    sp.sqrt(u_max / u_min) * sp.sin(sp.sqrt(u_max) * t) / sp.sqrt(u_max),
]
# Was the switching forgotten? (hint 3)
costate = [sp.cos(sp.sqrt(u_max) * t), -sp.sin(sp.sqrt(u_max) * t) / sp.sqrt(u_max)]
costate = [0, 0]  # Can $\lambda_0$ be 1 with costates that vanish? (hint 1)

# %% right
# a list of arcs
control = [
    [u_max, sp.pi / (2 * sp.sqrt(u_max))],
    [u_min, sp.pi / 2 * (1 / sp.sqrt(u_min) + 1 / sp.sqrt(u_max))],
]
# with Heaviside's function
control = u_max + (u_min - u_max) * sp.Heaviside(t - sp.pi / (2 * sp.sqrt(u_max)))
# both states, the cosine of a shifted time
trajectory = [
    sp.Piecewise(
        (sp.cos(sp.sqrt(u_max) * t), t < sp.pi / (2 * sp.sqrt(u_max))),
        (
            sp.sqrt(u_max / u_min)
            * sp.cos(sp.sqrt(u_min) * (t - sp.pi / (2 * sp.sqrt(u_max))) + sp.pi / 2),
            True,
        ),
    ),
    sp.Piecewise(
        (-sp.sqrt(u_max) * sp.sin(sp.sqrt(u_max) * t), t < sp.pi / (2 * sp.sqrt(u_max))),
        (
            -sp.sqrt(u_max)
            * sp.sin(sp.sqrt(u_min) * (t - sp.pi / (2 * sp.sqrt(u_max))) + sp.pi / 2),
            True,
        ),
    ),
]
# over a common denominator
duration = sp.pi * (sp.sqrt(u_min) + sp.sqrt(u_max)) / (2 * sp.sqrt(u_min * u_max))
cost = -sp.sqrt(u_max) / sp.sqrt(u_min)  # two roots
cost = -sp.exp(sp.log(u_max / u_min) / 2)  # through logarithms
# a column, with the sine of a shifted time
costate = sp.Matrix(
    [
        sp.Piecewise(
            (
                sp.sqrt(u_max / u_min) * sp.sin(sp.pi / 2 - sp.sqrt(u_max) * t),
                t < sp.pi / (2 * sp.sqrt(u_max)),
            ),
            (-sp.sin(sp.sqrt(u_min) * (t - sp.pi / (2 * sp.sqrt(u_max)))), True),
        ),
        sp.Piecewise(
            (-sp.sin(sp.sqrt(u_max) * t) / sp.sqrt(u_min), t < sp.pi / (2 * sp.sqrt(u_max))),
            (-sp.cos(sp.sqrt(u_min) * (t - sp.pi / (2 * sp.sqrt(u_max)))) / sp.sqrt(u_min), True),
        ),
    ]
)
