"""Batches of initial states, with what is known of each."""

import numpy as np


class StateBatch:
    """Many starts side by side, with what is known of each."""

    def __init__(self, **columns):
        self.__dict__.update(columns)

    def take(self, which):
        return StateBatch(**{name: column[which] for name, column in self.__dict__.items()})

    @staticmethod
    def concatenated(parts):
        return StateBatch(
            **{
                name: np.concatenate([part.__dict__[name] for part in parts])
                for name in parts[0].__dict__
            }
        )


def rows_of(which, *columns):
    return [column[which] for column in columns]


def directions(angles):
    p = np.empty((*np.shape(angles), 2))
    np.cos(angles, out=p[..., 0])
    np.sin(angles, out=p[..., 1])
    return p
