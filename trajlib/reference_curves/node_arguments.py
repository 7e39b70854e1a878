"""Reading of nodes and of the box in which the formula is used."""

import numpy as np

from trajlib._arguments.arrays import read_array


def read_axes(lists, name, short):
    """Return (nodes, name, short name) for each axis."""
    try:
        lists = [read_array(nodes, name, "a list of numbers for each axis") for nodes in lists]
    except TypeError:
        raise TypeError(
            f"{name}: expected a list of lists of numbers, one for each axis, got {lists!r}"
        ) from None
    if any(nodes.ndim != 1 for nodes in lists):
        raise ValueError(
            f"{name}: expected a list of nodes for each axis; a single axis is [nodes]"
        )
    return [(nodes, f"{name}[{j}]", f"{short}[{j}]") for j, nodes in enumerate(lists)]


def read_nodes(nodes, name):
    """Return distinct increasing finite numbers."""
    nodes = read_array(nodes, name, "a list of numbers")
    if nodes.ndim != 1 or nodes.size == 0:
        raise ValueError(f"{name}: expected a list of numbers, got shape {nodes.shape}")
    if not np.isfinite(nodes).all():
        raise ValueError(f"{name}: entry {np.flatnonzero(~np.isfinite(nodes))[0]} is not finite")
    gaps = np.diff(nodes)
    close = np.flatnonzero(np.abs(gaps) <= 1e-12 * np.abs(nodes).max())
    if close.size:
        raise ValueError(
            f"{name}: {nodes[close[0]]:g} and {nodes[close[0] + 1]:g} coincide; all have to be "
            "different"
        )
    if (gaps < 0).any():
        k = int(np.flatnonzero(gaps < 0)[0])
        raise ValueError(
            f"{name}: expected increasing numbers, but {nodes[k]:g} is followed by {nodes[k + 1]:g}"
        )
    return nodes


def read_box(box, nodes, names):
    """Return the intervals of all axes, which must contain their nodes."""
    if box is None:
        return tuple((float(axis[0]), float(axis[-1])) for axis in nodes)
    box = [tuple(float(end) for end in ends) for ends in box]
    if len(box) != len(nodes):
        raise ValueError(
            f"box: expected {len(nodes)} pairs, for {', '.join(names)}, got {len(box)}"
        )
    for (low, high), axis, name in zip(box, nodes, names):
        if not low <= axis[0] <= axis[-1] <= high:
            raise ValueError(
                f"box: the interval [{low:g}, {high:g}] does not hold all of {name}, which reach "
                f"from {axis[0]:g} to {axis[-1]:g}"
            )
    return tuple(box)
