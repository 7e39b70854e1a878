"""Draw the picture that links to the site are shown with: python book/preview.py."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

#: The size that sites which show links ask for, in inches of 100 pixels.
SIZE = (12, 6.3)


def draw():
    """Return the figure: the time-optimal synthesis of the double integrator, and the title."""
    figure = plt.figure(figsize=SIZE, facecolor="#fbfaf7")
    ax = figure.add_axes((0.5, 0.06, 0.47, 0.88))
    ax.set(xlim=(-4.5, 4.5), ylim=(-3.4, 3.4), xticks=[], yticks=[], facecolor="white")
    x2 = np.linspace(-3.4, 3.4, 300)
    curve = -x2 * np.abs(x2) / 2
    ax.fill_betweenx(x2, curve, 4.5, color="#e3f0f1")
    ax.plot(curve, x2, color="#0b6e7a", linestyle="--", linewidth=2.5)
    # from (2.5, 1) with u = -1 to the switching curve, then with u = 1 to the origin
    root = np.sqrt(0.5 + 2.5)
    t, left = np.linspace(0, 1 + root, 200), np.linspace(root, 0, 200)
    ax.plot(2.5 + t - t**2 / 2, 1 - t, color="#b4501e", linewidth=4)
    ax.plot(left**2 / 2, -left, color="#b4501e", linewidth=4)
    ax.plot([2.5], [1], "o", color="#b4501e", markersize=14)
    ax.plot([0], [0], "o", color="#1d2733", markersize=10)
    figure.text(0.04, 0.62, "Controlled Motion", fontsize=34, weight="bold", color="#1d2733")
    lines = "Stability, feedback, estimation\nand optimal control:\nproblems that check your answer"
    figure.text(0.04, 0.32, lines, fontsize=21, color="#4a5663", linespacing=1.5)
    return figure


if __name__ == "__main__":
    picture = Path(__file__).with_name("_static") / "preview.png"
    draw().savefig(picture, dpi=100, metadata={"Software": None})
