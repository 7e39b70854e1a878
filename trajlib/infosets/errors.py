"""The error of a set that has become empty."""


class EmptyInformationSet(ValueError):
    """No state agrees with all measurements: one of them, or a bound of the model, is wrong.
    `time`: of the measurement that left nothing."""

    def __init__(self, time):
        self.time = time
        super().__init__(
            f"no state agrees with the measurement at t = {time:g} and those before it: a bound on "
            "its error, on k or on mu is too small, or the set had lost the true state before"
        )
