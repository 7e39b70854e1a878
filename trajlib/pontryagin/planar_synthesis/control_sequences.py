"""Control sequences: the modes of extremals, backwards from the target, as numbers.

A mode is a combination of the controls' levels. A sequence of modes is identified by its last mode
and the sequence before it, so that a whole fan of extremals needs one integer for each.
"""

import numpy as np


class ControlSequences:
    """All sequences that have occurred, numbered.

    Attributes
    ----------
    mode, parent, length : ndarray of int
        For each sequence its last mode, the sequence before it (-1 for none), its number of
        switchings.
    """

    def __init__(self, modes):
        self._modes, self._known = modes, {}
        self.mode, self.parent, self.length = (np.empty(0, int) for _ in range(3))

    def after(self, sequence, mode):
        """Return the sequences continued by a mode; -1 continued is the mode alone."""
        sequence, mode = np.broadcast_arrays(sequence, mode)
        keys, inverse = np.unique((sequence + 1) * self._modes + mode, return_inverse=True)
        return np.array([self._number(int(key)) for key in keys], int)[inverse].reshape(
            sequence.shape
        )

    def modes_of(self, sequence):
        """Return the modes of one sequence, a list."""
        modes = []
        while sequence >= 0:
            modes.append(int(self.mode[sequence]))
            sequence = self.parent[sequence]
        return modes[::-1]

    def prefixed(self, mode, sequence):
        """Return the sequences that begin with another mode, arrays of one shape."""
        pairs, inverse = np.unique(np.stack([mode, sequence]), axis=1, return_inverse=True)
        result = []
        for first, old in pairs.T:
            new = self._number(int(first))
            for following in self.modes_of(old):
                new = self._number((new + 1) * self._modes + following)
            result.append(new)
        return np.array(result, int)[inverse.ravel()]

    def table(self, sequences):
        """Return the modes of sequences, one row each, the last one repeated in shorter ones."""
        kinds, inverse = np.unique(sequences, return_inverse=True)
        modes = [self.modes_of(sequence) for sequence in kinds]
        longest = max(map(len, modes), default=1)
        return np.array([row + row[-1:] * (longest - len(row)) for row in modes], int).reshape(
            -1, longest
        )[inverse]

    def between(self, corners):
        """Return pairs (number of the cell, sequence) of all that occur in cells.

        `corners`: the sequences at the corners of the cells, shape (N, 3).
        """
        kinds, inverse = np.unique(np.sort(corners, axis=1), axis=0, return_inverse=True)
        groups = []
        for kind in kinds:
            least, result = self.length[kind].min(), set()
            for sequence in map(int, kind):
                while sequence >= 0 and self.length[sequence] >= least and sequence not in result:
                    result.add(sequence)
                    sequence = int(self.parent[sequence])
            groups.append(sorted(result, key=lambda sequence: (self.length[sequence], sequence)))
        sizes = np.array([len(group) for group in groups], int)
        inverse = inverse.ravel()
        pick = np.repeat(np.arange(inverse.size), sizes[inverse] if inverse.size else [])
        return pick, np.array([sequence for number in inverse for sequence in groups[number]], int)

    def _number(self, key):
        """Return the number of a key, a new one if it has not occurred."""
        if key not in self._known:
            sequence, mode = divmod(key, self._modes)
            sequence -= 1
            self._known[key] = self.mode.size
            self.mode = np.append(self.mode, mode)
            self.parent = np.append(self.parent, sequence)
            self.length = np.append(self.length, self.length[sequence] + 1 if sequence >= 0 else 0)
        return self._known[key]
