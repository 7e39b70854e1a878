"""What can go wrong with an optimal control problem, each with a name of its own.

Every message says what was asked, why it cannot be, and what to try.
"""


class PontryaginError(ValueError):
    """A well-formed problem without the extremal that was asked for; the classes below say why."""


class Infeasible(PontryaginError):
    """No admissible control leads to the target (in the time given), by a proof that the message
    names."""


class Unbounded(PontryaginError):
    """The cost has no minimum: it falls without bound, or its infimum is not attained."""


class Chattering(PontryaginError):
    """Switchings accumulate: the extremal has infinitely many arcs.

    `numbers`: the optimal cost and the ratio of the arcs with their errors,
    `accumulation.Accumulation`; None where there are none.
    """

    def __init__(self, message, numbers=None):
        super().__init__(message)
        self.numbers = numbers


class WrongStructure(PontryaginError):
    """The arcs asked for cannot be joined to an extremal."""


class NotUnique(WrongStructure):
    """The maximum principle leaves a control open on an arc: several controls may be equally
    good."""


class NotConverged(PontryaginError):
    """No process was found, or none could be computed; nothing follows about the problem itself."""


class StartOnTarget(PontryaginError):
    """The initial state already satisfies the terminal conditions."""
