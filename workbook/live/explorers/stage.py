"""Pictures that move in a notebook: a Matplotlib figure of which only some artists are drawn anew
in each frame.

What stands (axes, words, regions) is drawn once and kept as pixels; a frame is these, the moving
artists on top, and a JPEG of the whole without coarser colours, which `ipywidgets.Image` shows.
`benchmarks/live.py` compares the ways: a frame takes 5 ms, drawn whole and as PNG 25 times as long,
as SVG 30 times; a PNG of the same pixels takes three times as long as the JPEG, and a BMP is twelve
times as large.

Clicks and strokes come from a transparent layer over the picture. Its handlers stand in its own
HTML and write where the pointer is into a hidden text field, which ipywidgets tells the kernel: no
other host is asked, and no package beside ipywidgets. While the kernel draws, ipywidgets holds back
all but the newest value: a slow frame is passed over, never waited for in a queue.
"""

import html
import io
from contextlib import contextmanager

import ipywidgets
import numpy as np

from trajlib import plotting
from trajlib.typesetting import typeset
from workbook.live.subjects import LiveError

WIDTH, DPI, QUALITY = 11.5, 100, 93
#: Where the pointer has been since it was pressed, in parts of the picture from its lower left
#: corner.
MOVED = """
if (event.type === 'pointerdown') { this.stroke = []; this.setPointerCapture(event.pointerId); }
else if (!(event.buttons & 1) || !this.stroke) return;
const box = this.getBoundingClientRect();
this.stroke.push(((event.clientX - box.left)/box.width).toFixed(4),
                 (1 - (event.clientY - box.top)/box.height).toFixed(4));
const told = this.closest('.workbook-explorer').querySelector('.workbook-pointer input');
told.value = [Math.round(event.timeStamp), ...this.stroke].join(' ');
told.dispatchEvent(new Event('input', {bubbles: true}));
event.preventDefault();
"""
STYLE = """<style>
.workbook-stage { position: relative; overflow: hidden; max-width: 1250px }
.workbook-stage img { width: 100%; height: auto; display: block }
.workbook-stage .widget-html { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0 }
.workbook-stage .widget-html-content, .workbook-layer { width: 100%; height: 100% }
.workbook-layer { cursor: crosshair; touch-action: none }
.workbook-explorer .widget-label, .workbook-explorer .widget-readout, .workbook-words { font-size: 18px }
.workbook-words { line-height: 1.4 }
</style>"""


class Stage:
    """A figure with `panels` axes side by side; `moving` says which artists of it move."""

    def __init__(self, panels=1, height=4.6, **given):
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        with plotting.style():
            self.figure = Figure(figsize=(WIDTH, height), dpi=DPI)
            self._canvas = FigureCanvasAgg(self.figure)
            self.axes = self.figure.subplots(1, panels, squeeze=False, **given)[0]
        self._moving, self._still = [], None

    def moving(self, *artists):
        """Artists that are drawn in each frame, those given later above the others; returns the
        last one."""
        for artist in artists:
            artist.set_animated(True)
            self._moving.append(artist)
        return artists[-1]

    def line(self, axes, *style, **look):
        """A moving line without points so far."""
        return self.moving(*axes.plot([], [], *style, **look))

    def frame(self):
        """The picture as it is now, a JPEG."""
        from PIL import Image

        if self._still is None:
            self._canvas.draw()
            self.figure.set_layout_engine("none")  # from here on the axes stay where they are
            self._still = self._canvas.copy_from_bbox(self.figure.bbox)
        self._canvas.restore_region(self._still)
        for artist in self._moving:
            artist.axes.draw_artist(artist)
        size, told = self._canvas.get_width_height(), io.BytesIO()
        Image.frombuffer("RGBA", size, self._canvas.buffer_rgba(), "raw", "RGBA", 0, 1).convert(
            "RGB"
        ).save(told, "jpeg", quality=QUALITY, subsampling=0)
        return told.getvalue()

    def at(self, x, y):
        """(the axes, points of shape (N, 2) in its data) where parts of the picture are; None
        beside all axes."""
        pixels = np.column_stack([x, y]) * self.figure.bbox.size
        for axes in self.axes:
            if axes.bbox.contains(*pixels[0]):
                return axes, axes.transData.inverted().transform(pixels)
        return None


class Explorer(ipywidgets.VBox):
    """A stage with its controls. `draw(**values of the controls)` puts the moving artists where
    they belong and returns a line of words; `pointed(axes, points)` says what a stroke does, of
    which the last point is where the pointer is.

    `controls`: {name: a widget with a value}; `beside`: widgets that stand with them; `words`: a
    line above. `frames` counts the pictures drawn so far, `pulled` says whether the pointer does
    anything.
    """

    def __init__(self, stage, controls, draw, pointed=None, words="", beside=()):
        self.stage, self.controls, self.frames = stage, controls, 0
        self._draw, self._pointed, self._waits = draw, pointed, False
        self._image = ipywidgets.Image(format="jpeg")
        self._words = ipywidgets.HTML()
        self._pointer = ipywidgets.Text(layout={"display": "none"})
        self._pointer.add_class("workbook-pointer")
        for control in controls.values():
            control.observe(self._changed, "value")
        self.pulled = pointed is not None
        if self.pulled:
            self._pointer.observe(self._touched, "value")
        handler = html.escape(" ".join(MOVED.split()), quote=True)
        layer = ipywidgets.HTML(
            f'<div class="workbook-layer" onpointerdown="{handler}" '
            f'onpointermove="{handler}"></div>'
            if self.pulled
            else ""
        )
        place = ipywidgets.Box([self._image, layer])
        place.add_class("workbook-stage")
        row = ipywidgets.HBox([*beside, *controls.values()], layout={"flex_flow": "row wrap"})
        about = ipywidgets.HTML(
            STYLE + (f'<div class="workbook-words">{typeset(words)}</div>' if words else "")
        )
        super().__init__([about, row, place, self._words, self._pointer])
        self.add_class("workbook-explorer")
        self.show()

    def show(self):
        """Draw a frame."""
        try:
            said = self._draw(**{name: control.value for name, control in self.controls.items()})
            self._image.value = self.stage.frame()
        except (ArithmeticError, ValueError, np.linalg.LinAlgError) as error:
            said = f"no picture here: {error}"
        self._words.value = f'<div class="workbook-words">{typeset(said or "")}</div>'
        self.frames += 1

    @contextmanager
    def together(self):
        """Several controls change, one frame is drawn."""
        self._waits = True
        try:
            yield
        finally:
            self._waits = False
        self.show()

    def set(self, **values):
        """Give controls their values; raises `LiveError` for an unknown one, and outside of its
        range."""
        with self.together():
            for name, value in values.items():
                self._set(name, value)

    def _set(self, name, value):
        if name not in self.controls:
            raise LiveError(
                f"there is no parameter {name}; there is {', '.join(self.controls) or 'none'}"
            )
        control = self.controls[name]
        try:
            value = float(value)
        except (TypeError, ValueError):
            raise LiveError(f"{name}: expected a number, got {value}") from None
        # a switch has neither
        low, high = getattr(control, "min", 0), getattr(control, "max", 1)
        if not low <= value <= high:
            raise LiveError(f"{name} = {value:g}: it goes from {low:g} to {high:g} here")
        control.value = type(control.value)(value)

    def _changed(self, _):
        if not self._waits:
            self.show()

    def _touched(self, change):
        _, *numbers = map(float, change["new"].split())
        found = self.stage.at(numbers[::2], numbers[1::2]) if numbers else None
        if found:
            with self.together():
                self._pointed(*found)


def slider(name, low, high, value, step=None):
    """A slider for a number, with 200 steps."""
    return ipywidgets.FloatSlider(
        value,
        min=low,
        max=high,
        step=step or (high - low) / 200,
        description=name,
        readout_format=".3g",
        layout={"width": "480px"},
    )


def near(control, value):
    """The value of a slider that is next to a number."""
    return float(np.clip(value, control.min, control.max))
