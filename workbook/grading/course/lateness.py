"""Late rule: the share of its points that a late attempt keeps."""

import math
from dataclasses import dataclass

DAY = 86400


@dataclass(frozen=True)
class LateRule:
    """What lateness costs.

    Parameters
    ----------
    per_day : float
        The share of the points that each day begun after the due date takes, from 0 to 1.
    floor : float
        The share that is kept in any case until the cut-off.
    cutoff_days : float or None
        After how many days nothing is kept; None is never.
    """

    per_day: float
    floor: float = 0.0
    cutoff_days: float | None = None

    def share(self, seconds):
        """Return the share of its points that an attempt keeps, so many seconds after the date.

        >>> LateRule(0.25, floor=0.4, cutoff_days=7).share(DAY), LateRule(0.25).share(DAY + 1)
        (0.75, 0.5)
        """
        if seconds <= 0:
            return 1.0
        if self.is_cut_off(seconds):
            return 0.0
        return max(1.0 - self.per_day * days_begun(seconds), self.floor, 0.0)

    def is_cut_off(self, seconds):
        """Return whether nothing is kept any more."""
        return self.cutoff_days is not None and seconds > self.cutoff_days * DAY


def days_begun(seconds):
    """Return how many days have begun."""
    return math.ceil(seconds / DAY)
