"""The look of a page of each kind: light and dark, on screen and on paper, on a phone, tablet and desktop."""

import pytest

PAGES = [
    "book/index.html",
    "book/progress.html",
    "book/ch5.html",
    "book/ch1/hurwitz.html",
    "book/ch9/figures.html",
    "book/glossary.html",
    "book/guides/student.html",
    "book/lectures.html",
    "book/library/structure.html",
    "solutions/ch1/p15.html",
]
WIDTHS = [390, 768, 1400]
#: What is printed is as wide as its paper: the text of A5, of A4, and of a large sheet.
PAPERS = dict(zip(WIDTHS, [480, 718, 1400], strict=True))
#: Faults of the page as it is shown: too wide, cut off, text whose contrast to its ground is below 4.5, and
#: grounds behind pictures. On paper nothing scrolls, and no text stands before the page's title.
FAULTS = """(paper => {
    const numbers = text => (text.match(/[\\d.]+/g) || [0, 0, 0, 0]).map(Number);
    const over = ([r, g, b, alpha = 1], ground) => [r, g, b].map((c, k) => c * alpha + ground[k] * (1 - alpha));
    const grounds = new Map([[null, [255, 255, 255]]]);
    const ground = e => {
        if (!grounds.has(e))
            grounds.set(e, over(numbers(getComputedStyle(e).backgroundColor), ground(e.parentElement)));
        return grounds.get(e); };
    const linear = c => (c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
    const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
    const contrast = (ink, paper) => {
        const [dark, light] = [ink, paper].map(luminance).sort((a, b) => a - b);
        return (light + 0.05) / (dark + 0.05); };
    const faults = [], fault = (kind, e) => faults.push(kind + ': ' + e.outerHTML.slice(0, 110));
    const root = document.documentElement, title = [...document.querySelectorAll('h1')].find(e => e.checkVisibility());
    if (root.scrollWidth > root.clientWidth) faults.push(root.scrollWidth + ' px wide');
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), range = document.createRange();
    const inked = new Set();
    while (texts.nextNode()) {
        const text = texts.currentNode, e = text.parentElement;
        if (!text.data.trim() || e.closest('script, style, noscript, mjx-assistive-mml')
            || !e.checkVisibility({opacityProperty: true, visibilityProperty: true})) continue;
        range.selectNodeContents(text);
        const box = range.getBoundingClientRect();
        if (box.width < 2 || box.height < 2 || box.right < 0 || box.bottom + scrollY < 0) continue;
        if (paper && box.bottom <= title.getBoundingClientRect().top) fault('before the title', e);
        if (inked.has(e)) continue;
        inked.add(e);
        const paint = numbers(getComputedStyle(e)[e.closest('svg') ? 'fill' : 'color']);
        const ratio = contrast(over(paint, ground(e)), ground(e));
        if (ratio < 4.5) fault('contrast ' + ratio.toFixed(2), e);
    }
    for (const e of document.querySelectorAll('article *')) {
        const cuts = paper ? ['hidden', 'clip', 'auto', 'scroll'] : ['hidden', 'clip'];
        if (e.clientWidth > 2 && e.scrollWidth > e.clientWidth + 1 && e.checkVisibility()
            && cuts.includes(getComputedStyle(e).overflowX) && !e.closest('mjx-assistive-mml, svg'))
            fault('cut', e);
    }
    for (const e of document.querySelectorAll('article :is(figure, .tile, .cell_output) img'))
        if (numbers(getComputedStyle(e).backgroundColor)[3] !== 0
            || (getComputedStyle(e).filter !== 'none') !== (root.dataset.theme === 'dark')) fault('ground', e);
    return faults; })"""


@pytest.fixture
def show(browser):
    """Return a function that shows the open page in a theme and a medium, and restore the light screen."""

    def show(theme, medium):
        # a browser that prints says so before, and the page may then change its theme
        browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": medium})
        browser.show_theme(theme)
        if medium == "print":
            browser.driver.execute_script("dispatchEvent(new Event('beforeprint'))")

    yield show
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    browser.forget()
    browser.resize(1280, 900)


@pytest.mark.parametrize("page", PAGES)
def test_every_theme_medium_and_width(browser, addresses, show, page):
    browser.open(f"{addresses['http']}/{page}")
    browser.run("document.querySelectorAll('article details').forEach(fold => fold.open = true)")
    faults = {}
    for width in WIDTHS:
        for medium in ("screen", "print"):
            narrow = width == WIDTHS[0] and medium == "screen"
            browser.resize(width if medium == "screen" else PAPERS[width], 900, phone=narrow)
            for theme in ("light", "dark"):
                show(theme, medium)
                faults[width, theme, medium] = browser.run(
                    f"{FAULTS}({str(medium == 'print').lower()})"
                )
    assert {state: found for state, found in faults.items() if found} == {}


@pytest.mark.parametrize("width", WIDTHS)
def test_the_search_in_both_themes(browser, addresses, show, search_for, width):
    browser.resize(width, 900, phone=width == WIDTHS[0])
    browser.open(f"{addresses['http']}/book/index.html")
    search_for("criterion")
    for theme in ("light", "dark"):
        show(theme, "screen")
        assert browser.run(f"{FAULTS}(false)") == []


def test_faults_are_found(browser, addresses, show):
    browser.resize(390, 900, phone=True)
    browser.open(f"{addresses['http']}/solutions/ch1/p15.html")
    browser.driver.execute_script("""document.querySelector('article h1').insertAdjacentHTML('afterend',
        `<p style="color: #888">pale</p>
        <pre style="overflow: hidden; white-space: pre !important">${'x'.repeat(200)}</pre>
        <div style="width: 500px; height: 2px"></div>
        <figure><img style="background: #fff !important" src="data:,"></figure>`);
        document.body.insertAdjacentHTML('afterbegin', '<p>contents</p>')""")
    show("light", "print")
    faults = browser.run(f"{FAULTS}(true)")
    for kind in (
        "contrast 3.5",
        "cut: <pre",
        "px wide",
        "before the title: <p>contents",
        "ground: <img",
    ):
        assert any(kind in fault for fault in faults), kind
