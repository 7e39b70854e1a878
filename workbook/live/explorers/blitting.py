"""A Matplotlib figure whose moving artists alone are drawn anew in each frame (blitting).

Axes, texts and regions are drawn once and kept as pixels. A frame consists of these, the moving
artists on top, and a JPEG of the whole without chroma subsampling, which `ipywidgets.Image` shows.
`benchmarks/live.py` compares the ways: a frame takes 5 ms; a figure drawn whole and saved as PNG
takes 25 times as long, as SVG 30 times; a PNG of the same pixels takes three times as long as the
JPEG, and a BMP is twelve times as large.
"""

import io

import numpy as np

from trajlib import plotting

#: Width in inches, pixels per inch, JPEG quality.
WIDTH, DPI, QUALITY = 11.5, 100, 93


class BlittedFigure:
    """A figure whose moving artists are drawn anew in each frame.

    Parameters
    ----------
    panels : int
        Number of axes, side by side.
    height : float
        Height in inches.
    **options
        For `matplotlib.figure.Figure.subplots`.
    """

    def __init__(self, panels=1, height=4.6, **options):
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        with plotting.style():
            self.figure = Figure(figsize=(WIDTH, height), dpi=DPI)
            self._canvas = FigureCanvasAgg(self.figure)
            self.axes = self.figure.subplots(1, panels, squeeze=False, **options)[0]
        self._animated, self._background = [], None

    def animate(self, *artists):
        """Draw artists anew in each frame, above earlier ones; return the last one."""
        for artist in artists:
            artist.set_animated(True)
            self._animated.append(artist)
        return artists[-1]

    def line(self, axes, *style, **options):
        """Return a new moving line without points; arguments as for `Axes.plot`."""
        return self.animate(*axes.plot([], [], *style, **options))

    def frame(self):
        """Return the current picture as the bytes of a JPEG file."""
        from PIL import Image

        if self._background is None:
            self._canvas.draw()
            self.figure.set_layout_engine("none")  # the axes keep their positions
            self._background = self._canvas.copy_from_bbox(self.figure.bbox)
        self._canvas.restore_region(self._background)
        for artist in self._animated:
            artist.axes.draw_artist(artist)
        size, file = self._canvas.get_width_height(), io.BytesIO()
        Image.frombuffer("RGBA", size, self._canvas.buffer_rgba(), "raw", "RGBA", 0, 1).convert(
            "RGB"
        ).save(file, "jpeg", quality=QUALITY, subsampling=0)
        return file.getvalue()

    def locate(self, x, y):
        """Return the axes at points of the figure, and the points in its data coordinates.

        Parameters
        ----------
        x, y : array_like, shape (N,)
            Coordinates as fractions of the figure from its lower left corner.

        Returns
        -------
        (matplotlib.axes.Axes, ndarray of shape (N, 2)) or None
            The axes is that of the first point; None if this is outside all axes.
        """
        pixels = np.column_stack([x, y]) * self.figure.bbox.size
        for axes in self.axes:
            if axes.bbox.contains(*pixels[0]):
                return axes, axes.transData.inverted().transform(pixels)
        return None
