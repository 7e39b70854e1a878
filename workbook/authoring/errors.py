"""What is told of a master that breaks its contract."""


class MasterError(ValueError):
    """A master breaks the contract; the message names the file, the line (from 1) and what was
    expected."""

    def __init__(self, path, line, said):
        super().__init__(f"{path}:{line}: {said}")
