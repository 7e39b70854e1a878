"""The classical Runge-Kutta method of order four."""


def rk4(field, t, y, h):
    """Return the state after a step of the classical Runge-Kutta method."""
    a = field(t, y)
    b = field(t + h / 2, y + h / 2 * a)
    c = field(t + h / 2, y + h / 2 * b)
    d = field(t + h, y + h * c)
    return y + h / 6 * (a + 2 * b + 2 * c + d)


def steered(field, controls, y, h):
    """Return the state after a step of y' = field(y, u), u given at its beginning, middle and end."""
    begin, middle, end = controls
    a = field(y, begin)
    b = field(y + h / 2 * a, middle)
    c = field(y + h / 2 * b, middle)
    d = field(y + h * c, end)
    return y + h / 6 * (a + 2 * b + 2 * c + d)
