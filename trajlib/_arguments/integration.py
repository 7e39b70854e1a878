"""Reading of the options of integrations that a caller chooses, and their budget."""

from trajlib._arguments.numbers import read_count

#: Explicit and implicit method, names of SciPy.
METHODS = ("DOP853", "Radau")


def read_method(method):
    """Return one of the two methods."""
    if method not in METHODS:
        raise ValueError(
            f'method: expected "DOP853" or, for stiff systems, "Radau", got {method!r}'
        )
    return method


class Budget:
    """Count of evaluations with a limit."""

    def __init__(self, limit, method) -> None:
        self.limit, self.method = read_count(limit, "max_evaluations", 1), method
        self.count = 0

    def spend(self, t):
        """Count an evaluation at the time t; raise ArithmeticError if too many were needed."""
        self.count += 1
        if self.count > self.limit:
            advice = (
                "" if self.method == "Radau" else 'take method="Radau" if the system is stiff, '
            )
            raise ArithmeticError(
                f"f: {self.limit} evaluations have brought the integration to t = {t:g} only; "
                f"{advice}end earlier, or allow larger rtol or max_evaluations"
            )
