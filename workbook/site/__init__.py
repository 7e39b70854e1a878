"""A Sphinx extension for the pages of problems: `extensions = ["workbook.site"]`.

It reads masters, solutions/chrob/p01.md, or student notebooks, exercises/chrob/p01.ipynb, below the folder of
`conf.py`. The workbook's own site uses it, and so does any other that Sphinx or Jupyter Book 1 builds.

catalogue         the problems of the edition that is being built, from their front matter
problem_pages     a problem's page: title, chips, download, answers and hints, labels for both editions
listings          the list of all problems and the index by topic, made from the catalogue
downloads         the notebooks of students and of pages
common_mistakes   wrong answers with their verdicts, folded after the checks of solved problems
answer_boxes      boxes for answers that are checked in the page
folding           statements; solutions, hints and code folded with the browser's own <details>
figures           pictures with their number, their caption and alternative text
explorers         interactive figures: their script, once, on the pages that have one
cell_output       formulas typeset in what cells print

Its scripts and styles are in static/; the boxes are shown where `workbook page` packed Python for them.
"""

from pathlib import Path

from workbook.display import explorer
from workbook.site import (
    answer_boxes,
    catalogue,
    cell_output,
    common_mistakes,
    downloads,
    explorers,
    figures,
    folding,
    listings,
    problem_pages,
)

EXTENSIONS = (
    catalogue,
    problem_pages,
    listings,
    downloads,
    common_mistakes,
    answer_boxes,
    folding,
    figures,
    explorers,
    cell_output,
)
#: Scripts and styles, of the pages and of interactive figures.
STATIC = [Path(package).parent / "static" for package in (__file__, explorer.__file__)]
#: Of MyST's Markdown, what masters and notebooks use.
MARKDOWN = {"amsmath", "attrs_inline", "colon_fence", "deflist", "dollarmath", "tasklist"}
NOTEBOOKS = "exercises/*/*.ipynb"


def _configure(app, config):
    config.html_static_path[:0] = map(str, STATIC)
    config.myst_enable_extensions = MARKDOWN.union(config.myst_enable_extensions)
    config.nb_merge_streams = True
    config.nb_render_markdown_format = "myst"  # results that mix words and formulas
    # a stub has no output; the reader's own are those of the boxes
    config.nb_execution_excludepatterns = {NOTEBOOKS, *config.nb_execution_excludepatterns}


def setup(app):
    for name in ("myst_nb", "sphinx_exercise", "sphinx_proof"):
        app.setup_extension(name)
    app.connect("config-inited", _configure, priority=100)
    app.add_css_file("problems.css", priority=700)  # after those of the extensions above
    for extension in EXTENSIONS:
        extension.setup(app)
    return {"env_version": 1, "parallel_read_safe": True, "parallel_write_safe": True}
