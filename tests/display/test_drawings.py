"""The shapes of drawings: positions and directions; global settings stay unchanged."""

import subprocess
import sys

import numpy as np
import pytest

from workbook.display import Drawing, along

SHEET = (-2, 2), (-1, 1)


def inked_pixels(drawing):
    """Return where the sheet is not white, with rows from below, 100 points an inch."""
    from io import BytesIO

    from matplotlib.image import imread

    return (imread(BytesIO(drawing.png(100)))[::-1, :, :3] < 0.97).any(axis=2)


def has_ink(picture, point):
    """Whether there is ink at a point of the sheet, or beside it."""
    return around(picture, point, 2).any()


def around(picture, point, reach):
    x, y = (round(100 * (c - low)) for c, (low, _) in zip(point, SHEET))
    return picture[y - reach : y + reach, x - reach : x + reach]


def drawn(name, *arguments, **options):
    drawing = Drawing(*SHEET)
    getattr(drawing, name)(*arguments, **options)
    return inked_pixels(drawing)


def test_pyplot_and_settings_stay_unchanged():
    code = (
        "import sys; from workbook.display import Drawing; assert 'matplotlib' not in "
        "sys.modules; import matplotlib; before = dict(matplotlib.rcParams); d = Drawing((0, 1), "
        "(0, 1)); d.label((0.5, 0.5), '$x$'); d.png(); d._repr_svg_(); assert "
        "dict(matplotlib.rcParams) == before; assert 'matplotlib.pyplot' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=120)


def test_the_same_drawing_is_the_same_file():
    def shown():
        drawing = Drawing(*SHEET)
        drawing.spring((-1, 0), (1, 0))
        drawing.angle((0, 0), 0, 60, 0.8, r"$\varphi$")
        return drawing._repr_svg_(), drawing.png()

    assert shown() == shown()


def test_a_unit_is_an_inch():
    assert inked_pixels(Drawing(*SHEET)).shape == (200, 400)


def test_along_measures_from_the_x_axis_counterclockwise():
    assert np.allclose(along((1, 2), 2, 90), (1, 4))
    assert np.allclose(along((0, 0), 2, -60), (1, -np.sqrt(3)))


@pytest.mark.parametrize(
    "name, arguments, ink, white",
    [
        ("rod", [(-1, 0), (1, 0.5)], [(0, 0.25)], [(0, -0.25)]),
        ("reference", [(-1, 0), (1, 0)], [(-0.98, 0)], [(0, 0.2)]),
        ("mass", [(1, 0.5)], [(1, 0.5), (1.08, 0.5)], [(1.2, 0.5)]),
        ("hinge", [(1, 0.5)], [(1.055, 0.5)], [(1.15, 0.5)]),
        ("disc", [(0, 0), 0.5], [(0.5, 0), (0, 0)], [(0.6, 0)]),
        ("box", [(0, 0), 2, 0.4], [(0.99, 0.19)], [(0.99, 0.3), (1.1, 0)]),
        ("box", [(0, 0), 2, 0.4, 90], [(0.19, 0.97)], [(0.99, 0.19)]),
        ("shape", [[(0, 0), (1, 0), (1, 0.2)], (-1, 0), 90, 0.5], [(-1, 0.25)], [(-0.6, 0)]),
        ("cart", [0.5, -0.6], [(0.5, -0.2), (0.17, -0.48)], [(0.5, -0.55), (0.5, 0.1)]),
        ("ground", [(-1, 0), (1, 0)], [(0, 0), (0.15, -0.05)], [(0, 0.1)]),
        ("ground", [(-1, 0), (1, 0), True], [(0, 0)], [(0, -0.1), (0.15, -0.06)]),
        ("spring", [(-1, 0), (1, 0)], [(-0.9, 0), (0.9, 0)], [(0, 0.2), (0, -0.2)]),
        (
            "damper",
            [(-1, 0), (1, 0)],
            [(-0.9, 0), (0.9, 0), (-0.24, 0.1), (0.08, 0)],
            [(0.32, 0.07), (-0.1, 0)],
        ),
        ("arc", [(0, 0), 0.8, 0, 90], [along((0, 0), 0.8, 45)], [along((0, 0), 0.8, -45)]),
        (
            "dimension",
            [(-1, 0), (1, 0), "", 90, 0.4],
            [(0.5, 0.4), (-1, 0.2)],
            [(0.5, -0.4), (0, 0)],
        ),
        ("dimension", [(-1, 0), (1, 0), "", 90, -0.4], [(0.5, -0.4), (1, -0.2)], [(0.5, 0.4)]),
    ],
)
def test_shapes_have_ink_where_expected(name, arguments, ink, white):
    picture = drawn(name, *arguments)
    assert [point for point in ink if not has_ink(picture, point)] == []
    assert [point for point in white if has_ink(picture, point)] == []


@pytest.mark.parametrize("name", ["axis", "velocity", "acceleration", "force"])
def test_an_arrow_has_its_head_at_its_end(name):
    columns = drawn(name, (-1, 0), (1, 0)).sum(axis=0)  # how thick it is, from left to right
    head, shaft = columns[285:298], columns[110:250]
    assert columns[:97].sum() == 0 and columns[305:].sum() == 0
    assert head.max() > shaft.max() and columns[105] == shaft.min()


@pytest.mark.parametrize("start, end", [(0, 90), (90, 0), (-90, -30), (-30, -90)])
def test_the_arrow_of_an_angle_is_at_its_end(start, end):
    picture = drawn("angle", (0, 0), start, end, 0.7, "")
    inwards = np.sign(end - start) * 5  # the middle of the head
    head, tail = (
        around(picture, along((0, 0), 0.7, turn), 5).sum()
        for turn in (end - inwards, start + inwards)
    )
    assert head > 1.5 * tail > 0
    assert has_ink(picture, along((0, 0), 0.7, (start + end) / 2))
    assert not has_ink(picture, along((0, 0), 0.7, (start + end) / 2 + 180))


@pytest.mark.parametrize(
    "side, x, y", [(0, 1, 0), (90, 0, 1), (180, -1, 0), (-90, 0, -1), (45, 1, 1)]
)
def test_a_label_is_on_its_side(side, x, y):
    rows, columns = np.nonzero(drawn("label", (0, 0), "$M$", side))
    middle = columns.mean() - 200, rows.mean() - 100
    assert [0 if abs(c) < 4 else np.sign(c) for c in middle] == [x, y]
    assert not has_ink(drawn("label", (0, 0), "$M$", side), (0, 0))


def test_later_shapes_are_above_earlier_ones():
    drawing = Drawing(*SHEET)
    drawing.rod((-1, 0), (1, 0))
    drawing.box((0, 0), 1, 0.5)
    drawing.hinge((0, 0))
    picture = inked_pixels(drawing)
    assert picture[100, 120] and not picture[100, 200]
