"""Marks with remarks on the printed book are hidden until a reader asks for them; the folds are closed."""

SHOWN = "[...document.querySelectorAll('article .printed')].filter(mark => mark.checkVisibility()).length"
SWITCH = "document.querySelector('.printed-switch > input')"


def test_marks_are_shown_on_request_and_on_all_pages(browser, addresses):
    browser.open(f"{addresses['http']}/book/ch5/singular_example.html")
    assert browser.run(SHOWN) == 0
    assert browser.run("!document.querySelector('details.fold').open")
    browser.run(f"{SWITCH}.click()")
    assert browser.run(SHOWN) > 1
    browser.open(f"{addresses['http']}/book/ch1/hurwitz.html")
    assert browser.run(SHOWN) > 3 and browser.run(f"{SWITCH}.checked")
    browser.run(f"{SWITCH}.click()")
    assert browser.run(SHOWN) == 0
    browser.open(f"{addresses['http']}/book/ch5/singular_example.html")
    assert browser.run(SHOWN) == 0


def test_a_page_without_marks_has_no_switch(browser, addresses):
    browser.open(f"{addresses['http']}/book/glossary.html")
    assert browser.run(f"{SWITCH} === null")
