"""Reading of python-control's StateSpace in place of matrices, and of python-control's keywords."""

from trajlib._arguments.matrices import is_state_space


def is_discrete(system):
    """Whether this is a StateSpace in discrete time: its `dt` is True or a step, not 0 or None."""
    return is_state_space(system) and bool(system.dt)
