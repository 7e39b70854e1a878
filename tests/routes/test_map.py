"""The map of the sections can be read: no arrow goes up or through a box, and names fit."""

import re
import sys
import xml.etree.ElementTree as ET
from pathlib import Path
from textwrap import wrap

import numpy as np

from workbook.routes.course import course

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "book" / "_ext"))
from workbook_site.routes import BOX, LINE, STEP, path_of, picture_of  # noqa: E402

SECTIONS = {label: section for label, section in course().sections.items() if section.at}


def _points(path):
    """Return points on a path of the commands M, C and V."""
    points = []
    for command, numbers in re.findall(r"([MCV])([^MCV]*)", path):
        numbers = np.array([float(number) for number in numbers.split()])
        if command == "M":
            points.append(numbers)
        elif command == "V":
            points.append(np.array([points[-1][0], *numbers]))
        else:
            t = np.linspace(0, 1, 200)[:, None]
            corners = [points[-1], *numbers.reshape(3, 2)]
            weights = (1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t**2, t**3
            points.extend(sum(w * corner for w, corner in zip(weights, corners, strict=True)))
    return np.array(points)


def test_arrows_lead_down_and_through_no_box():
    taken = {section.at for section in SECTIONS.values()}
    for need, label in course().edges:
        start, end = SECTIONS[need].at, SECTIONS[label].at
        assert end[1] > start[1], (need, label)
        points = _points(path_of(start, end, taken))
        assert (np.diff(points[:, 1]) >= 0).all()
        for other, section in SECTIONS.items():
            if other in (need, label):
                continue
            corner = np.array(section.at) * STEP
            inside = (points > corner).all(axis=1) & (points < corner + np.array(BOX)).all(axis=1)
            assert not inside.any(), f"from {need} to {label} through {other}"


def test_names_fit_into_their_boxes():
    for section in SECTIONS.values():
        lines = wrap(section.name, LINE)
        assert len(lines) <= 2 and max(map(len, lines)) <= LINE, section.name


def test_the_picture_has_a_link_for_each_section_and_a_path_for_each_edge():
    picture = picture_of(course(), lambda section: f"../{section.page}.html?a=1&b=2")
    svg = ET.fromstring(picture).find("svg")
    links = svg.findall("a")
    assert [link.get("href") for link in links] == [
        f"../{section.page}.html?a=1&b=2" for section in SECTIONS.values()
    ]
    shown = ["".join(span.text for span in link.iter("tspan")) for link in links]
    names = [section.name for section in SECTIONS.values()]
    assert [text.replace(" ", "") for text in shown] == [name.replace(" ", "") for name in names]
    assert len(svg.find("g").findall("path")) == len(course().edges)
    assert svg.find("title").text
    assert "fill" not in picture and "stroke" not in picture  # colours are those of the theme
