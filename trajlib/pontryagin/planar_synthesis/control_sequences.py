"""The structures of extremals: which controls follow one another, backwards from the target, as
numbered words.

A word is a sequence of modes (numbers of combinations of the controls' levels); it is known by its
last mode and the word before it, so that a whole fan of extremals carries one integer each.
"""

import numpy as np


class ControlSequences:
    """All words that have occurred: for each its last `mode`, its `parent` (-1 for none), its
    number of switchings `length`."""

    def __init__(self, modes):
        self._modes, self._known = modes, {}
        self.mode, self.parent, self.length = (np.empty(0, int) for _ in range(3))

    def after(self, sequence, mode):
        """The words that continue others by a mode, arrays of one shape; -1 continued is the mode
        alone."""
        sequence, mode = np.broadcast_arrays(sequence, mode)
        keys, inverse = np.unique((sequence + 1) * self._modes + mode, return_inverse=True)
        return np.array([self._number(int(key)) for key in keys], int)[inverse].reshape(
            sequence.shape
        )

    def modes_of(self, sequence):
        """The modes of one word, a list."""
        modes = []
        while sequence >= 0:
            modes.append(int(self.mode[sequence]))
            sequence = self.parent[sequence]
        return modes[::-1]

    def prefixed(self, mode, sequence):
        """The words that begin with another mode, arrays of one shape."""
        pairs, inverse = np.unique(np.stack([mode, sequence]), axis=1, return_inverse=True)
        result = []
        for first, old in pairs.T:
            new = self._number(int(first))
            for following in self.modes_of(old):
                new = self._number((new + 1) * self._modes + following)
            result.append(new)
        return np.array(result, int)[inverse.ravel()]

    def table(self, sequences):
        """The modes of words, one row each, shape (N, longest); the last one is repeated where a
        word is shorter."""
        kinds, inverse = np.unique(sequences, return_inverse=True)
        modes = [self.modes_of(sequence) for sequence in kinds]
        longest = max(map(len, modes), default=1)
        return np.array([row + row[-1:] * (longest - len(row)) for row in modes], int).reshape(
            -1, longest
        )[inverse]

    def between(self, corners):
        """Which words occur in cells with words at their corners, shape (N, 3): (number of the
        cell, word) in pairs."""
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
        if key not in self._known:
            sequence, mode = divmod(key, self._modes)
            sequence -= 1
            self._known[key] = self.mode.size
            self.mode = np.append(self.mode, mode)
            self.parent = np.append(self.parent, sequence)
            self.length = np.append(self.length, self.length[sequence] + 1 if sequence >= 0 else 0)
        return self._known[key]
