"""What can go wrong with an optimal control problem, each with a name of its own.

Every message says what was asked, why it cannot be, and what to try.
"""


class PontryaginError(ValueError):
    """A well-formed problem without the extremal that was asked for; the classes below say why."""


class Infeasible(PontryaginError):
    """No admissible control leads to the target (in the time given), by a proof that the message names."""


class Unbounded(PontryaginError):
    """The cost has no minimum: it falls without bound, or its infimum is not attained."""


class Chattering(PontryaginError):
    """Switchings accumulate: the extremal has infinitely many arcs."""


class WrongStructure(PontryaginError):
    """The arcs asked for cannot be joined to an extremal."""


class NotConverged(PontryaginError):
    """No process was found, or none could be computed; nothing follows about the problem itself."""


class StartOnTarget(PontryaginError):
    """The initial state already satisfies the terminal conditions."""
