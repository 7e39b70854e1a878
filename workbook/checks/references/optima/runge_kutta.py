"""The classical method of Runge and Kutta."""


def rk4(field, t, y, h):
    """Return the state after a step of the classical method of Runge and Kutta."""
    a = field(t, y)
    b = field(t + h / 2, y + h / 2 * a)
    c = field(t + h / 2, y + h / 2 * b)
    d = field(t + h, y + h * c)
    return y + h / 6 * (a + 2 * b + 2 * c + d)
