"""Error for a set that has become empty."""


class EmptyInformationSet(ValueError):
    """Raised if no state is compatible with all measurements.

    One of the measurements, or a bound of the model, is wrong.

    Parameters
    ----------
    time : float
        Time of the measurement after which the set is empty.
    """

    def __init__(self, time: float) -> None:
        self.time = time
        super().__init__(
            f"no state agrees with the measurement at t = {time:g} and those before it: a bound on "
            "its error, on k or on mu is too small, or the set had lost the true state before"
        )
