"""Pictures of the runs of filters and smoothers."""

from __future__ import annotations

from itertools import cycle

import numpy as np

from trajlib import plotting
from trajlib._arguments.arrays import read_array


def plot_states(times, estimates, covariances, truth, label, rows=0):
    """Draw each state with its band on Axes below one another; `rows` more Axes stay empty."""
    import matplotlib.pyplot as plt

    n = estimates.shape[1]
    if truth is not None:
        truth = read_array(truth, "truth", "states as numbers")
        if truth.shape != estimates.shape:
            raise ValueError(f"truth: expected the shape {estimates.shape}, got {truth.shape}")
    deviations = np.sqrt(np.maximum(np.einsum("kii->ki", covariances), 0))
    with plotting.style():
        figure, axes = plt.subplots(
            n + rows, 1, sharex=True, squeeze=False, figsize=(6, 1.3 + 1.5 * (n + rows))
        )
        axes = axes[:, 0]
        for i, ax in enumerate(axes[:n]):
            plotting.estimate(times, estimates[:, i], deviations[:, i], ax, label)
            if truth is not None:
                ax.plot(times, truth[:, i], color=plotting.BLACK, ls="--", label="true")
            ax.set_ylabel(rf"$x_{{{i + 1}}}$")
        axes[0].legend()
        axes[-1].set_xlabel("time")
        figure.align_ylabels()
    return axes


def plot_innovations(times, innovations, covariances, ax):
    """Draw the innovations, each in units of its standard deviation, and the lines of two of these."""
    deviations = np.sqrt(np.einsum("kii->ki", covariances))
    with plotting.style():
        for i, marker in zip(range(innovations.shape[1]), cycle("osD^vP*")):
            label = rf"$\nu_{{{i + 1}}}/\sigma_{{{i + 1}}}$"
            ax.plot(
                times, innovations[:, i] / deviations[:, i], marker, ms=3.5, ls="none", label=label
            )
        for side in (-2, 2):
            ax.axhline(side, color=plotting.GREY, lw=0.8)
        ax.set_ylabel("innovations")
        ax.legend()
