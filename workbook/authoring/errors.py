"""The error for a master that breaks its contract."""


class MasterError(ValueError):
    """A master breaks its contract.

    Parameters
    ----------
    path : path_like
        File of the master.
    line : int
        Line number, from 1.
    expected : str
        What was expected there.
    """

    def __init__(self, path, line, expected):
        super().__init__(f"{path}:{line}: {expected}")
