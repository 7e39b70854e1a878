"""Chapter 9: information sets."""

from adversarial import right, wrong

ROWS = [
    wrong("9.1", "a_tight", "[0, w, 2*w, w, 0, -w*(1 + w)/(1.01 + w)]", "nearly the last one"),
    wrong("9.1", "a_tight", "[0, w, 2*w, w, 0, -1]", "the width taken for one"),
    wrong("9.1", "a_tight", "[w, w, 2*w, w, w, -w]", "only the third side moved"),
    wrong("9.1", "a_tight", "[0, w, 2*w, w, 0, -w][::-1]", "in the other direction round"),
    right("9.1", "a_tight", "[0*w, w, w + w, w, w - w, w - 2*w]", "sums of neighbours"),
    wrong("9.1", "b_common", "sp.And(c <= 3*w, c >= w)", "as if the strip had to miss the origin"),
    wrong("9.1", "b_common", "c**2 < 9*w**2", "without the last place, squared"),
    wrong("9.1", "b_common", "c <= 2.9*w", "a tenth too few"),
    wrong("9.1", "b_common", "sp.Ne(c, 4*w)", "all but one"),
    right("9.1", "b_common", "c**2 <= 9*w**2", "squared, for positive numbers"),
    right("9.1", "b_common", "w >= c/3", "solved for the width"),
    right("9.1", "b_common", "sp.log(c/w) <= sp.log(3)", "by logarithms"),
    wrong(
        "9.1", "c_tight", "[d, sp.sqrt(2)*d, d, d, 0, 0, 0, d]", "the south-east not of length 1"
    ),
    wrong(
        "9.1",
        "c_tight",
        "[d, sp.sqrt(2)*d, d, d/sp.sqrt(2), 0, -sp.sqrt(2)*d, 0, d/sp.sqrt(2)]",
        "the corner opposite to the north-east",
    ),
    right(
        "9.1",
        "c_tight",
        "[d, sp.sqrt(d**2 + d**2), d, d*sp.sin(sp.pi/4), 0, 0, 0, d*sp.sin(sp.pi/4)]",
        "a diagonal",
    ),
    right("9.1", "c_tight", "[d, 1.414*d, d, 0.7071*d, 0, 0, 0, 0.7071*d]", "four digits"),
    wrong("9.2", "a_greatest", "D/T + 0.505*a*T", "one per cent off"),
    wrong("9.2", "a_greatest", "D/T + (a + b)*T/2", "the length of the interval added"),
    wrong("9.2", "a_greatest", "sp.sqrt((D/T)**2 + a*D)", "the square of the speed, by the way"),
    wrong("9.2", "a_greatest", "D/T + a*T/2 - sp.Max(0, 1 - T)", "less for short times"),
    right("9.2", "a_greatest", "sp.Max(D/T, D/T + a*T/2)", "a maximum"),
    wrong("9.2", "a_least", "D/T - b*T/2 - (a - b)*T/100", "nearly"),
    wrong("9.2", "a_least", "-D/T + b*T/2", "the sign of all"),
    right("9.2", "a_least", "sp.Abs(D/T - b*T/2)", "its absolute value: the speed is positive"),
    wrong("9.2", "b_first", "D/T + b*T**2/2", "a way added to a speed"),
    right("9.2", "b_first", "(D/T - b*T/2) + b*T", "by the end"),
    wrong("9.3", "a_forecast", "[a]*8", "the initial square without normals"),
    wrong(
        "9.3",
        "a_forecast",
        "[6.66*a, 6.24*a, 3*a, -0.57*a, -3.83*a, -0.586*a, 3*a, 6.24*a]",
        "one value three per cent off",
    ),
    right(
        "9.3",
        "a_forecast",
        "[6.657*a, 6.243*a, 3*a, -0.5858*a, -3.828*a, -0.5858*a, 3*a, 6.243*a]",
        "four digits",
    ),
    wrong(
        "9.3",
        "b_measured",
        "[6.657*a, 6.243*a, 3*a, -2.243*a, -6*a, -4.95*a, -a, 4*a]",
        "one side left loose",
    ),
    wrong("9.3", "c_east", "c <= 5*a", "far too high"),
    wrong(
        "9.3",
        "c_east",
        "sp.And((2*sp.sqrt(2) - 1)*a < c, c < (2*sp.sqrt(2) + 3)*a)",
        "without the squares that touch",
    ),
    right("9.3", "c_east", "(c/a - 2*sp.sqrt(2) - 1)**2 <= 4", "squared"),
    wrong("9.4", "a_east", "1 - sp.cos(theta) + theta**4/100", "a hundredth of the fourth power"),
    right("9.4", "a_east", "sp.sin(theta)*sp.tan(theta/2)", "by half the angle"),
    wrong("9.4", "b_north", "theta**2 - theta**4/12 + theta**6/100", "a wrong series"),
    right("9.4", "b_north", "sp.Abs(2*sp.cos(theta) - 2)", "an absolute value"),
    wrong("9.4", "c_covered", "t < s/(2*delta)", "without the sections that touch"),
    wrong("9.4", "c_covered", "t <= 0.49*s/delta", "two per cent too few"),
    right("9.4", "c_covered", "2*sp.log(2*t*delta/s) <= 0", "by logarithms"),
    wrong("9.5", "a_adjoint", "[0, 0, V*py*sp.sin(psi), 0]", "half of the third alone"),
    wrong("9.5", "b_controls", "[sp.sign(ppsi*V), mu2]", "the acceleration all the time"),
    right(
        "9.5", "b_controls", "[sp.sign(ppsi*V), sp.Piecewise((mu1, pV < 0), (mu2, True))]", "the cases in the other order"
    ),
    wrong("9.5", "c_long", "sp.Max(T - phi, sp.sin(phi))", "the greater part alone"),
    right("9.5", "c_long", "sp.cos(sp.pi/2 - phi) + sp.Abs(T - phi)", "an absolute value"),
    wrong("9.5", "d_short", "sp.sin(phi)*sp.sin(T)", "a product"),
    right(
        "9.5", "d_short", "sp.sin(phi)*(1 - sp.cos(T)) + sp.cos(phi)*sp.sin(T)", "east and north"
    ),
    wrong("9.5", "e_section", "2*(1 - sp.cos(T/2))", "the formula for short flights"),
    right("9.5", "e_section", "T - 1.1416", "five digits"),
]
