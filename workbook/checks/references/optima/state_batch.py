"""Batches of initial states, with what is known of each."""

import numpy as np


class StateBatch:
    """A batch of initial states, with columns of what is known of each."""

    def __init__(self, **columns):
        self.__dict__.update(columns)

    def take(self, rows):
        """Return the batch of these rows."""
        return StateBatch(**{name: column[rows] for name, column in self.__dict__.items()})

    @staticmethod
    def concatenated(parts):
        """Return one batch of several."""
        return StateBatch(
            **{
                name: np.concatenate([part.__dict__[name] for part in parts])
                for name in parts[0].__dict__
            }
        )


def rows_of(rows, *columns):
    """Return these rows of each column."""
    return [column[rows] for column in columns]


def directions(angles):
    """Return the unit vectors of angles, along a new last axis."""
    p = np.empty((*np.shape(angles), 2))
    np.cos(angles, out=p[..., 0])
    np.sin(angles, out=p[..., 1])
    return p
