"""A figure that the kernel draws, for what no formula gives: a blitted figure with controls, which follows the pointer.

Clicks and strokes come from a transparent layer over the picture. Its handlers, in its own HTML,
write the coordinates of the pointer into a hidden text field, and ipywidgets sends them to the
kernel: no other host and no package beside ipywidgets is needed. While the kernel draws, ipywidgets
keeps the newest value only, so that frames are skipped and no queue grows.
"""

import html
from contextlib import contextmanager

import ipywidgets
import numpy as np

from trajlib.typesetting import typeset
from workbook.live.callbacks import ErrorLine
from workbook.live.errors import LiveError

#: Handler: records the points since the pointer was pressed, as fractions of the picture from its
#: lower left corner.
POINTER_HANDLER = """
if (event.type === 'pointerdown') { this.stroke = []; this.setPointerCapture(event.pointerId); }
else if (!(event.buttons & 1) || !this.stroke) return;
const box = this.getBoundingClientRect();
this.stroke.push(((event.clientX - box.left)/box.width).toFixed(4),
                 (1 - (event.clientY - box.top)/box.height).toFixed(4));
const field = this.closest('.workbook-explorer').querySelector('.workbook-pointer input');
field.value = [Math.round(event.timeStamp), ...this.stroke].join(' ');
field.dispatchEvent(new Event('input', {bubbles: true}));
event.preventDefault();
"""
STYLE = """<style>
.workbook-figure { position: relative; overflow: hidden; max-width: 1250px }
.workbook-figure img { width: 100%; height: auto; display: block }
.workbook-figure .widget-html { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0 }
.workbook-figure .widget-html-content, .workbook-layer { width: 100%; height: 100% }
.workbook-layer { cursor: crosshair; touch-action: none }
.workbook-explorer .widget-label, .workbook-explorer .widget-readout, .workbook-text { font-size: 18px }
.workbook-text { line-height: 1.4 }
</style>"""


class KernelFigure(ipywidgets.VBox):
    """A figure with its controls.

    Parameters
    ----------
    figure : BlittedFigure
        The figure.
    controls : dict of ipywidgets.Widget
        Widgets with a value, by name.
    draw : callable
        `draw(**values of the controls)` updates the moving artists and returns a line of text.
    on_stroke : callable, optional
        `on_stroke(axes, points)` is called while the pointer is pressed; the last of the points,
        in data coordinates, is where the pointer is.
    title : str
        A line above the figure.
    extra_widgets : sequence of ipywidgets.Widget
        Widgets that stand beside the controls.

    Attributes
    ----------
    error : ErrorLine
        The error of the last frame or stroke, in one line.
    frames : int
        Number of frames drawn so far.
    follows_pointer : bool
        Whether there is an `on_stroke`.
    """

    def __init__(self, figure, controls, draw, on_stroke=None, title="", extra_widgets=()):
        self.figure, self.controls, self.frames = figure, controls, 0
        self._draw, self._on_stroke, self._suspended = draw, on_stroke, False
        self._image = ipywidgets.Image(format="jpeg")
        self.error = ErrorLine()
        self._text = ipywidgets.HTML()
        self._pointer = ipywidgets.Text(layout={"display": "none"})
        self._pointer.add_class("workbook-pointer")
        for control in controls.values():
            control.observe(self._on_change, "value")
        self.follows_pointer = on_stroke is not None
        if self.follows_pointer:
            self._pointer.observe(self.error.guard(self._on_pointer), "value")
        handler = html.escape(" ".join(POINTER_HANDLER.split()), quote=True)
        layer = ipywidgets.HTML(
            f'<div class="workbook-layer" onpointerdown="{handler}" '
            f'onpointermove="{handler}"></div>'
            if self.follows_pointer
            else ""
        )
        picture = ipywidgets.Box([self._image, layer])
        picture.add_class("workbook-figure")
        row = ipywidgets.HBox(
            [*extra_widgets, *controls.values()], layout={"flex_flow": "row wrap"}
        )
        head = ipywidgets.HTML(
            STYLE + (f'<div class="workbook-text">{typeset(title)}</div>' if title else "")
        )
        super().__init__([head, row, picture, self._text, self.error, self._pointer])
        self.add_class("workbook-explorer")
        self.show()

    def show(self):
        """Draw a frame; where it cannot be drawn, the error is shown in one line."""
        self.error.guard(self._show)()
        self.frames += 1

    def _show(self):
        text = self._draw(**{name: control.value for name, control in self.controls.items()})
        self._image.value = self.figure.frame()
        self._text.value = f'<div class="workbook-text">{typeset(text or "")}</div>'

    @contextmanager
    def together(self):
        """Change several controls within the context and draw one frame."""
        self._suspended = True
        try:
            yield
        finally:
            self._suspended = False
        self.show()

    def set(self, **values):
        """Set controls by name.

        Raises
        ------
        LiveError
            If there is no such control, or the value is no number in its range.
        """
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
        # a toggle button has no range
        low, high = getattr(control, "min", 0), getattr(control, "max", 1)
        if not low <= value <= high:
            raise LiveError(f"{name} = {value:g}: it goes from {low:g} to {high:g} here")
        control.value = type(control.value)(value)

    def _on_change(self, _):
        if not self._suspended:
            self.show()

    def _on_pointer(self, change):
        _, *numbers = map(float, change["new"].split())
        located = self.figure.locate(numbers[::2], numbers[1::2]) if numbers else None
        if located:
            with self.together():
                self._on_stroke(*located)


def slider(name, low, high, value, step=None):
    """Return a slider for a number, with 200 steps if `step` is not set."""
    return ipywidgets.FloatSlider(
        value,
        min=low,
        max=high,
        step=step or (high - low) / 200,
        description=name,
        readout_format=".3g",
        layout={"width": "480px"},
    )


def nearest_value(control, value):
    """Return the number in the range of a slider that is nearest to a number."""
    return float(np.clip(value, control.min, control.max))
