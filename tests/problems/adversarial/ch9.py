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
]
