"""Interactive figures of the built site: time of a frame, and what a page weighs for them.

A frame is a move of all parameters of a figure, as dragging makes it: formulas, trajectories, shapes
and the layout of the page. The bar is 33 ms in headless Chromium on two quiet cores.
Needs Chromium, and the site in _build/html (`make book`).
"""

import gzip
import shutil
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "browser"))
#: Median milliseconds of a frame of each figure, and the size of its declaration and picture.
MEASURE = """return [...document.querySelectorAll('.explorer')].map((box) => {
    const {explorer, dataset} = box, times = [];
    for (let n = 0; n < 61; n += 1) {
      const share = 0.3 + 0.4 * n / 60, began = performance.now();
      explorer.move(new Map(explorer.parameters.map(({limits: [low, high]}, k) => [k, low + share * (high - low)])));
      box.getBoundingClientRect();
      times.push(performance.now() - began);
    }
    return [box.querySelector('.explorer-question').textContent, times.sort((a, b) => a - b)[30], times[58],
            dataset.explorer + box.querySelector('img').src];
  });"""


def main(site=ROOT / "_build" / "html"):
    from chromium import Browser

    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        browser = Browser(
            shutil.which("chromium"), shutil.which("chromedriver"), f"{folder}/profile"
        )
        try:
            for page in sorted(site.glob("book/*.html")):
                if "data-explorer" in page.read_text(encoding="utf-8"):
                    measure(browser, site, page)
        finally:
            browser.driver.quit()


def measure(browser, site, page):
    browser.open(page.as_uri())
    figures = browser.driver.execute_script(MEASURE)
    for question, median, slowest, _ in figures:
        print(f"{median:6.1f} ms, 95 % under {slowest:5.1f} ms  {question}")
    assets = [(site / "_static" / name).read_text() for name in ("explorer.js", "explorer.css")]
    size = len(gzip.compress("".join([*(figure[3] for figure in figures), *assets]).encode()))
    print(f"{size / 1000:6.0f} kB compressed for {len(figures)} figures of {page.name}\n")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
