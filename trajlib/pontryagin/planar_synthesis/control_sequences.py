"""The structures of extremals: which controls follow one another, backwards from the target, as
numbered words.

A word is a sequence of modes (numbers of combinations of the controls' levels); it is known by its
last mode and the word before it, so that a whole fan of extremals carries one integer each.
"""

import numpy as np


class Words:
    """All words that have occurred: for each its last `mode`, its `parent` (-1 for none), its
    number of switchings `length`."""

    def __init__(self, modes):
        self._modes, self._known = modes, {}
        self.mode, self.parent, self.length = (np.empty(0, int) for _ in range(3))

    def after(self, word, mode):
        """The words that continue others by a mode, arrays of one shape; -1 continued is the mode
        alone."""
        word, mode = np.broadcast_arrays(word, mode)
        keys, place = np.unique((word + 1) * self._modes + mode, return_inverse=True)
        return np.array([self._number(int(key)) for key in keys], int)[place].reshape(word.shape)

    def sequence(self, word):
        """The modes of one word, a list."""
        modes = []
        while word >= 0:
            modes.append(int(self.mode[word]))
            word = self.parent[word]
        return modes[::-1]

    def prefixed(self, mode, word):
        """The words that begin with another mode, arrays of one shape."""
        pairs, place = np.unique(np.stack([mode, word]), axis=1, return_inverse=True)
        found = []
        for first, old in pairs.T:
            new = self._number(int(first))
            for following in self.sequence(old):
                new = self._number((new + 1) * self._modes + following)
            found.append(new)
        return np.array(found, int)[place.ravel()]

    def table(self, words):
        """The modes of words, one row each, shape (N, longest); the last one is repeated where a
        word is shorter."""
        kinds, place = np.unique(words, return_inverse=True)
        modes = [self.sequence(word) for word in kinds]
        longest = max(map(len, modes), default=1)
        return np.array([row + row[-1:] * (longest - len(row)) for row in modes], int).reshape(
            -1, longest
        )[place]

    def between(self, corners):
        """Which words occur in cells with words at their corners, shape (N, 3): (number of the
        cell, word) in pairs."""
        kinds, place = np.unique(np.sort(corners, axis=1), axis=0, return_inverse=True)
        groups = []
        for kind in kinds:
            least, found = self.length[kind].min(), set()
            for word in map(int, kind):
                while word >= 0 and self.length[word] >= least and word not in found:
                    found.add(word)
                    word = int(self.parent[word])
            groups.append(sorted(found, key=lambda word: (self.length[word], word)))
        sizes = np.array([len(group) for group in groups], int)
        place = place.ravel()
        pick = np.repeat(np.arange(place.size), sizes[place] if place.size else [])
        return pick, np.array([word for number in place for word in groups[number]], int)

    def _number(self, key):
        if key not in self._known:
            word, mode = divmod(key, self._modes)
            word -= 1
            self._known[key] = self.mode.size
            self.mode = np.append(self.mode, mode)
            self.parent = np.append(self.parent, word)
            self.length = np.append(self.length, self.length[word] + 1 if word >= 0 else 0)
        return self._known[key]
