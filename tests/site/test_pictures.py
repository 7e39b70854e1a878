"""Legends and colours of the pictures of the built pages, read from their SVG."""

import itertools
import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

XLINK = "{http://www.w3.org/1999/xlink}"
SVG = "{http://www.w3.org/2000/svg}"
COMMAND = re.compile(r"([MLQCZz])([^MLQCZz]*)")
#: The field of a phase portrait, axes and the like lie under everything, in grey.
GREY = re.compile(r"stroke: #([89a-f]\w)\1\1\b")
#: Of a legend's diagonal: where curves end at its edge, they may.
COVERED = 0.1


def lines(path):
    """Yield the polygons of a path, sampled at one point for each unit of length."""
    found = []
    for command, numbers in COMMAND.findall(path.get("d", "")):
        if command in "Zz":
            found[-1].append(found[-1][0])
            continue
        point = np.array(numbers.split()[-2:], dtype=float)
        if command == "M":
            found.append([])
        found[-1].append(point)
    for corners in found:
        for a, b in itertools.pairwise(corners):
            count = max(int(np.linalg.norm(b - a)), 1)
            yield (
                a + (b - a) * ((np.arange(count) + 0.5) / count)[:, None],
                np.linalg.norm(b - a) / count,
            )


def frame(group):
    """Return the box of the first patch of a group, (low, high), or None."""
    patch = next(
        (part for part in group.iter(f"{SVG}g") if part.get("id", "").startswith("patch_")), None
    )
    points = (
        []
        if patch is None
        else [points for path in patch.iter(f"{SVG}path") for points, _ in lines(path)]
    )
    return (
        (np.min(np.concatenate(points), axis=0), np.max(np.concatenate(points), axis=0))
        if points
        else None
    )


def covered(svg):
    """Yield for each framed legend the length of curves under it, in lengths of its diagonal."""
    groups = list(ElementTree.fromstring(svg).iter(f"{SVG}g"))
    legends = [frame(group) for group in groups if group.get("id", "").startswith("legend_")]
    curves = []
    for axes in groups if any(legends) else ():
        if axes.get("id", "").startswith("axes_"):
            window = frame(axes)
            for drawn in axes:
                if re.match(
                    "line2d_|LineCollection|QuadContourSet|PathCollection", drawn.get("id", "")
                ):
                    curves += [
                        (points, step, window)
                        for path in drawn.iter(f"{SVG}path")
                        if "stroke:" in path.get("style", "")
                        and "stroke: none" not in path.get("style")
                        and not GREY.search(path.get("style"))
                        for points, step in lines(path)
                    ]
    for low, high in filter(None, legends):
        length = sum(
            step
            * np.sum(
                np.all(
                    (points > np.maximum(low, window[0])) & (points < np.minimum(high, window[1])),
                    axis=1,
                )
            )
            for points, step, window in curves
        )
        yield length / np.linalg.norm(high - low)


def test_covered_length_of_curves(tmp_path):
    import matplotlib.pyplot as plt

    lengths = {}
    for position in ("upper left", "lower right"):
        with plt.rc_context({"svg.fonttype": "path"}):
            fig, ax = plt.subplots()
            ax.plot([0, 1], [0, 0.1], label="near the floor")
            ax.plot([0, 1, 1], [0, 0, 1], color="#b5b5b5")
            ax.set_ylim(0, 1)
            ax.legend(loc=position)
            fig.savefig(tmp_path / "one.svg")
            plt.close(fig)
        [lengths[position]] = covered((tmp_path / "one.svg").read_text(encoding="utf-8"))
    assert lengths["upper left"] == 0 and lengths["lower right"] > 2 * COVERED


@pytest.fixture(scope="module")
def pictures(editions):
    """Return page and file -> the text of a picture."""
    pages = [
        page
        for pattern in ("solutions/ch*/p*.html", "book/**/*.html")
        for page in editions.full.glob(pattern)
    ]
    return {
        f"{page.name}: {name}": Path(page.parent, name).read_text(encoding="utf-8")
        for page in sorted(pages)
        for name in re.findall(r'<img [^>]*src="([^"]*\.svg)"', page.read_text(encoding="utf-8"))
    }


def test_no_legend_covers_a_curve(pictures):
    faults, seen = {}, 0
    for name, svg in pictures.items():
        shares = list(covered(svg))
        seen += len(shares)
        if any(share > COVERED for share in shares):
            faults[name] = [round(float(share), 2) for share in shares]
    assert seen > 200 and not faults


#: Properties of a style that a printer without colours keeps.
STYLE = re.compile(
    r"(stroke-dasharray|stroke-width|fill|stroke|opacity|fill-opacity|stroke-opacity): ([^;]+)"
)
#: The least visible difference of two greys, of 255.
VISIBLE = 60


def legend_styles(svg):
    """Yield for each legend the styles of its entries: [(style without colours, colours)]."""
    for group in ElementTree.fromstring(svg).iter(f"{SVG}g"):
        if group.get("id", "").startswith("legend_"):
            entries = [
                part
                for part in group
                if re.match("line2d_|patch_|LineCollection|PathCollection", part.get("id", ""))
            ]
            yield [style_of(part) for part in entries[1:] or entries]


def style_of(entry):
    kept, colours = [], []
    for part in entry.iter():
        if part.tag in (f"{SVG}path", f"{SVG}use"):
            style = dict(STYLE.findall(part.get("style", "")))
            inks = [style.pop(name, "none") for name in ("stroke", "fill")]
            colours += [ink for ink in inks if ink.startswith("#")]
            plain = [
                ink if ink in ("none", "#ffffff") or ink.startswith("url") else "ink"
                for ink in inks
            ]
            # a marker is defined once
            kept.append((sorted(style.items()), plain, part.get(f"{XLINK}href")))
    return kept, colours


def indistinguishable(entries):
    """Return pairs of entries that differ in their colours alone, and not in their brightness."""
    return [
        (first, second)
        for j, (second, inks) in enumerate(entries)
        for first, others in entries[:j]
        if first == second
        and inks != others
        and abs(brightness(inks) - brightness(others)) < VISIBLE
    ]


def brightness(colours):
    shares = [0.3, 0.59, 0.11]
    return np.mean(
        [
            np.dot(shares, [int(ink[k : k + 2], 16) for k in (1, 3, 5)])
            for ink in colours or ["#000000"]
        ]
    )


def test_entries_of_a_legend_differ_without_colours(pictures):
    """They differ by dashes, widths, markers or hatchings, for readers without colours."""
    legends = {name: list(legend_styles(svg)) for name, svg in pictures.items()}
    assert sum(len(entries) for found in legends.values() for entries in found) > 500
    assert not {
        name: found for name, found in legends.items() if any(map(indistinguishable, found))
    }


def test_indistinguishable_entries(tmp_path):
    import matplotlib.pyplot as plt

    for line_style, pairs in (("--", 0), ("-", 1)):
        fig, ax = plt.subplots()
        ax.plot([0, 1], [0, 1], "-", color="#0072B2", label="one")
        ax.plot([0, 1], [1, 0], line_style, color="#D55E00", label="two")
        ax.legend(loc="upper center")
        fig.savefig(tmp_path / "two.svg")
        plt.close(fig)
        [entries] = legend_styles((tmp_path / "two.svg").read_text(encoding="utf-8"))
        assert len(entries) == 2 and len(indistinguishable(entries)) == pairs


#: The ground of a figure or of its axes in white; labels may have one, which hides what is behind them.
GROUND = re.compile(
    r'<g id="(figure|axes)_\d+">\s*<g id="patch_\d+">\s*<path d="[^"]*"[^>]*style="fill: #ffffff"'
)
STYLE_SHEET = Path(__file__).resolve().parents[2] / "workbook" / "site" / "static" / "problems.css"


def test_pictures_have_no_ground_and_the_ink_and_font_of_the_page(pictures):
    """Formulas have the font of TeX, as in the page."""
    assert not [name for name, svg in pictures.items() if GROUND.search(svg) or "#000000" in svg]
    fonts = [set(re.findall(r'<path id="([A-Za-z0-9]+)-', svg)) for svg in pictures.values()]
    with_words = [names for names in fonts if names & {"WorkbookSans", "DejaVuSans"}]
    assert len(with_words) > 200
    assert sum("WorkbookSans" not in names for names in with_words) < len(with_words) / 20


@pytest.fixture(scope="module")
def look():
    """Return the colours of the page in a theme, and the colour that a picture's has in it."""
    text = STYLE_SHEET.read_text(encoding="utf-8")
    invert, brightness = map(
        float, re.search(r"invert\((.*?)\) hue-rotate\(180deg\) brightness\((.*?)\)", text).groups()
    )
    # the matrix of CSS for half a turn of the hue
    turn = np.array([[-0.574, 1.43, 0.144], [0.426, 0.43, 0.144], [0.426, 1.43, -0.856]])

    def dark(colour):
        return np.clip(
            brightness * np.clip(turn @ (invert + (1 - 2 * invert) * colour), 0, 1), 0, 1
        )

    def page(theme):
        start = text.index(f'data-theme="{theme}"')
        return {
            name: colour_of(re.search(rf"--{name}: (#\w+);", text[start:])[1])
            for name in ("ink", "paper", "card")
        }

    return {"light": (page("light"), lambda colour: colour), "dark": (page("dark"), dark)}


def colour_of(code):
    return np.array([int(code[k : k + 2], 16) / 255 for k in (1, 3, 5)])


def contrast(first, second):
    """Return the contrast of two colours by WCAG 2."""
    low, high = sorted(
        0.05 + np.array([0.2126, 0.7152, 0.0722]) @ linear(c) for c in (first, second)
    )
    return high / low


def curves(svg):
    """Yield the colours of lines and markers in axes, but for the grey field under them."""
    for group in ElementTree.fromstring(svg).iter(f"{SVG}g"):
        if re.match("line2d_|LineCollection", group.get("id", "")):
            for part in group.iter(f"{SVG}path"):
                style = dict(STYLE.findall(part.get("style", "")))
                colour = style.get("stroke", "none")
                if colour.startswith("#") and not GREY.search(f"stroke: {colour}"):
                    yield colour


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_colours_of_curves_have_a_contrast_of_3_to_the_page(pictures, look, theme):
    page, shown = look[theme]
    drawn = {colour for svg in pictures.values() for colour in curves(svg)} - {"#ffffff"}
    ratios = {colour: contrast(shown(colour_of(colour)), page["paper"]) for colour in drawn}
    assert len(ratios) > 10
    assert {colour: round(float(ratio), 2) for colour, ratio in ratios.items() if ratio < 3} == {}


def test_the_dark_theme_shows_pictures_in_its_ink_on_its_paper(look):
    page, shown = look["dark"]
    ink = look["light"][0]["ink"]
    assert np.abs(shown(ink) - page["ink"]).max() < 0.03
    assert np.abs(shown(np.ones(3)) - page["paper"]).max() < 0.03


#: Linear maps of linear colours for readers without one kind of cone (Machado and others 2009).
BLINDNESS = {
    "red": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "green": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    "blue": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
}  # fmt: skip


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("cones", BLINDNESS)
def test_the_colours_of_the_library_differ_for_colour_blind_readers(look, theme, cones):
    """By 10 in CIELAB, about five times the least visible difference of two neighbouring fields."""
    from trajlib import plotting

    _, shown = look[theme]
    names = ("BLUE", "RED", "GREEN", "ORANGE", "SKY", "PURPLE", "BLACK")
    labs = [
        lab(BLINDNESS[cones] @ linear(shown(colour_of(getattr(plotting, name))))) for name in names
    ]
    for (first, a), (second, b) in itertools.combinations(zip(names, labs, strict=True), 2):
        assert np.linalg.norm(a - b) > 10, (first, second)


def linear(colour):
    return np.where(colour <= 0.04045, colour / 12.92, ((colour + 0.055) / 1.055) ** 2.4)


def lab(colour):
    """Return the CIELAB coordinates of a linear sRGB colour under daylight."""
    to_xyz = np.array(
        [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
    )
    x, y, z = np.cbrt(np.clip(to_xyz @ colour / [0.9505, 1, 1.089], 1e-3, None))
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])
