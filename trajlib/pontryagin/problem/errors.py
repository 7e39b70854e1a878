"""The errors of optimal control problems, one class for each reason.

Every message names what was asked, why it is impossible, and what to try.
"""

import re

from trajlib.pontryagin.problem.log import Log

# Up to the first end of a clause outside of parentheses.
SUMMARY = re.compile(r"(?:\([^()]*(?:\([^()]*\)[^()]*)*\)|[^(:;.]|[:;.](?!\s|$))*")


class PontryaginError(ValueError):
    """A well-formed problem has no extremal of the kind asked for; subclasses name the reason.

    Attributes
    ----------
    log : Log
        What `solve` had tried by then; empty where the error comes from elsewhere.
    """

    log = Log()

    @property
    def summary(self) -> str:
        """What is the case, in one sentence without its reasons, numbers and advice."""
        return SUMMARY.findall(str(self))[0]


class Infeasible(PontryaginError):
    """No admissible control leads to the target (in the given time); the message has the proof."""


class Unbounded(PontryaginError):
    """The cost has no minimum: it falls without bound, or its infimum is not attained."""


class Chattering(PontryaginError):
    """Switchings accumulate: the extremal has infinitely many arcs.

    Parameters
    ----------
    message : str
        What accumulates and where.
    numbers : Accumulation, optional
        The optimal cost and the ratio of successive arcs with their errors, where they are known;
        see `indirect.accumulation`.
    """

    def __init__(self, message, numbers=None):
        super().__init__(message)
        self.numbers = numbers


class WrongStructure(PontryaginError):
    """The arcs asked for cannot be joined to an extremal."""


class NotUnique(WrongStructure):
    """The maximum principle does not determine a control on an arc; several may be equally good."""


class NotConverged(PontryaginError):
    """No process was found or computed; nothing follows about the problem itself."""


class StartOnTarget(PontryaginError):
    """The initial state already satisfies the terminal conditions."""
