"""Animations: the content of the page, and the errors."""

import json
from xml.etree import ElementTree

import numpy as np
import pytest
from bs4 import BeautifulSoup

from workbook.display.animations import SIZE, Animation

T = np.linspace(0, 2, 5)


def circle(**options):
    animation = Animation(T, "A <point> on a circle.", **options)
    plane = animation.panel((-1, 1), (-1, 1), "x", "y")
    plane.curve([0, 1], [0, 1], dashed=True)
    plane.trail(np.cos(T), np.sin(T))
    plane.dot(np.cos(T), np.sin(T))
    plane.rod(0, 0, np.cos(T), np.sin(T))
    return animation


def test_the_page_holds_every_frame_and_shows_one():
    box = BeautifulSoup(circle(still=4)._repr_html_(), "html.parser").find(class_="animation")
    data = json.loads(box["data-animation"])
    assert data["times"] == [0, 0.5, 1, 1.5, 2] and data["still"] == 4
    assert [part["kind"] for part in data["parts"]] == ["trail", "dot", "rod"]
    # (1, 0) of the square from -1 to 1
    assert data["parts"][1]["points"][:2] == [SIZE, SIZE / 2]
    assert len(data["parts"][2]["points"]) == 4 * len(T)
    svg = box.svg
    assert svg.parent["role"] == "img" and svg.parent["aria-label"] == "A <point> on a circle."
    assert (
        float(svg.circle["cx"]) == data["parts"][1]["points"][8] and len(svg.select(".moving")) == 3
    )


def test_the_still_frame_is_a_picture():
    animation = circle(still=1)
    animation.panel((0, 1), (0, 1), "t")
    picture = ElementTree.fromstring(animation._repr_svg_())
    html_circle = BeautifulSoup(animation._repr_html_(), "html.parser").circle
    assert [mark.attrib["cx"] for mark in picture.iter() if mark.tag.endswith("circle")] == [
        html_circle["cx"]
    ]
    assert len([part for part in picture if part.tag.endswith("g")]) == 2


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: Animation([0, 0], "w"), "increasing"),
        (lambda: Animation([0], "w"), "at least two"),
        (lambda: Animation(T, "w", speed=0), "speed"),
        (lambda: circle().panel((1, 1), (0, 1)), "low < high"),
        (lambda: circle().panel((0, 1), (0, 1)).dot([1, 2], 0), "each of the 5 frames"),
        (lambda: circle().panel((0, 1), (0, 1)).dot(np.nan, 0), "finite"),
    ],
)
def test_bad_input_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()
