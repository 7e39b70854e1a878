"""Animations on the static site play, pause and follow the slider, also from the disk."""

import time
from pathlib import Path

import numpy as np
import pytest

from workbook.display import Animation

STATIC = Path(__file__).resolve().parents[2] / "book" / "_static"
PAGES = [
    "book/ch1/limit_cycles.html",
    "book/ch1/nominal_motion.html",
    "book/ch2/observability.html",
    "book/ch3/observers.html",
    "book/ch3/output_feedback.html",
    "book/ch4/discrete_filter.html",
    "book/ch4/random_processes.html",
    "book/ch5/other_costs.html",
    "book/ch5/synthesis.html",
    "solutions/ch1/p05.html",
    "solutions/ch1/p10.html",
    *(
        f"book/lectures/{slug}.html"
        for slug in ("fastest-motion", "balanced-by-an-estimate", "kalman-filter")
    ),
]
AT = "Number(document.querySelector('.animation-controls input').value)"


@pytest.fixture
def browser(moving_browser):
    return moving_browser


@pytest.fixture
def page(tmp_path):
    """A page with nothing but an animation of four seconds."""
    t = np.linspace(0, 4, 81)
    animation = Animation(t, "A point on a circle.")
    plane = animation.panel((-1.2, 1.2), (-1.2, 1.2), "x", "y")
    plane.trail(np.cos(t), np.sin(t))
    plane.dot(np.cos(t), np.sin(t))
    (tmp_path / "page.html").write_text(
        '<!doctype html><html lang="en"><head><title>An animation</title><script '
        f'src="{STATIC.as_uri()}/animations.js">'
        f"</script></head><body>{animation._repr_html_()}</body></html>",
        encoding="utf-8",
    )
    return (tmp_path / "page.html").as_uri()


def test_it_plays_pauses_and_follows_the_slider(browser, page):
    from selenium.webdriver.common.keys import Keys

    browser.open(page)
    button = browser.find(".animation button")
    assert button.accessible_name == "Play" and browser.run(AT) == 0
    position = "document.querySelector('.animation circle').getAttribute('cx')"
    before = browser.run(position)
    time.sleep(0.5)
    assert browser.run(AT) == 0  # it does not start by itself
    button.send_keys(Keys.SPACE)
    assert button.accessible_name == "Pause"
    assert browser.wait_for(f"{AT} > 5") and browser.run(position) != before
    button.send_keys(Keys.SPACE)
    paused_at = browser.run(AT)
    time.sleep(0.5)
    assert browser.run(AT) == paused_at and button.accessible_name == "Play"
    slider = browser.find(".animation input")
    assert slider.accessible_name == "Time of the motion"
    slider.send_keys(Keys.END)
    assert browser.run(AT) == 80
    assert browser.run("document.querySelector('.animation output').value") == "t = 4.00"
    button.click()  # at the end it starts again
    assert browser.wait_for(f"{AT} > 2 && {AT} < 60")
    assert browser.wait_for(f"{AT} == 80", 20) and button.accessible_name == "Play"
    assert browser.errors() == [] and browser.foreign_requests() == []


def test_reduced_motion_goes_on_by_steps(browser, page):
    emulate = "Emulation.setEmulatedMedia"
    browser.driver.execute_cdp_cmd(
        emulate, {"features": [{"name": "prefers-reduced-motion", "value": "reduce"}]}
    )
    try:
        browser.open(page)
        button = browser.find(".animation button")
        assert button.accessible_name == "Next step"
        button.click()
        first = browser.run(AT)
        time.sleep(0.5)
        assert browser.run(AT) == first > 0
        button.click()
        assert browser.run(AT) == 2 * first
    finally:
        browser.driver.execute_cdp_cmd(emulate, {"features": []})


@pytest.mark.parametrize("name", PAGES)
def test_animations_of_the_site_move_and_are_small(browser, addresses, editions, name):
    from selenium.webdriver.common.keys import Keys

    browser.open(f"{addresses['file']}/{name}")
    sizes = browser.run(
        "[...document.querySelectorAll('.animation')].map(box => box.outerHTML.length)"
    )
    assert sizes and sum(sizes) + (STATIC / "animations.js").stat().st_size <= 60_000
    browser.run("document.querySelectorAll('details.dropdown').forEach(fold => fold.open = true)")
    # its still may be near to its end
    browser.find(".animation input").send_keys(Keys.HOME)
    # at once: a driver's click takes a while on a long page
    press = "document.querySelector('.animation button').click()"
    browser.run(press)
    assert browser.wait_for(f"{AT} > 2")
    browser.run(press)
    paused_at = browser.run(AT)
    time.sleep(0.3)
    assert browser.run(AT) == paused_at
    assert browser.errors() == [] and browser.foreign_requests() == []
