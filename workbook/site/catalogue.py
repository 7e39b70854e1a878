"""The problems of the edition that is being built.

A problem's page is its master, solutions/ch1/p15.md, or in the student edition the notebook
exercises/ch1/p15.ipynb. What the site includes decides which of the two is built.
"""

from dataclasses import dataclass
from pathlib import Path

from sphinx.errors import ExtensionError

from workbook.authoring import MasterError
from workbook.authoring.front_matter import read_front_matter
from workbook.authoring.study_time import minutes, study_time
from workbook.notebooks import exercises
from workbook.numbering import number_of_file, read_number

FOLDERS = ("solutions", "exercises")


@dataclass(frozen=True)
class Problem:
    """The front matter of a problem; `answers`: name -> (kind, meaning), `hints`: name -> texts."""

    page: str
    number: str
    title: str
    section: str
    level: str
    topics: tuple
    answers: dict
    hints: dict
    core: tuple = ()
    varies: bool = False

    @property
    def order(self):
        return read_number(self.number).order

    @property
    def chapter(self):
        return read_number(self.number).chapter

    @property
    def label(self):
        """Return the label of its exercise, ex-1-15."""
        return "ex-" + read_number(self.number).label

    @property
    def notebook(self):
        """Return the path of the student's notebook, in the repository and on the site."""
        return self.page.replace("solutions/", "exercises/", 1) + ".ipynb"

    @property
    def minutes(self):
        """Return the estimated minutes for all answers, to five minutes."""
        return 5 * round(minutes(self.level, len(self.answers)) / 5)

    @property
    def study_time(self):
        return study_time(self.level, self.answers, self.core)

    @property
    def solved(self):
        """Return whether the page holds the solution."""
        return self.page.startswith("solutions/")


def read(page, path):
    """Return the problem whose page `page` is the file `path`."""
    path = Path(path)
    about = exercises.read(path).about if path.suffix == ".ipynb" else _front_matter(path)
    return Problem(
        page,
        about["number"],
        about["title"],
        about["section"],
        about["level"],
        tuple(about["topics"]),
        {name: _answer(answer) for name, answer in about["answers"].items()},
        {name: list(texts) for name, texts in about["hints"].items()},
        tuple(about.get("core", ())),
        _varies(path.parents[2], page),
    )


def _is_problem(page):
    folder, _, file = page.partition("/")
    return folder in FOLDERS and file.count("/") == 1 and number_of_file(file) is not None


def _varies(root, page):
    """Return whether the problem of a page has rows of numbers, which its trials hold."""
    trials = root / f"{page.replace('exercises/', 'solutions/', 1)}.trials.py"
    return trials.exists() and "\n# %% numbers" in trials.read_text(encoding="utf-8")


def of(env):
    """Return the catalogue of a build: page -> Problem, in the order of the numbers."""
    return env.workbook_catalogue


def _front_matter(path):
    try:
        front_matter, _ = read_front_matter(path, path.read_text(encoding="utf-8"))
    except MasterError as error:
        raise ExtensionError(str(error)) from None
    return front_matter


def _answer(answer):
    if isinstance(answer, dict):
        return answer["kind"], answer["text"]
    kind, _, meaning = answer.partition(":")
    return kind.strip(), meaning.strip()


def _load(app, env, added, changed, removed):
    """Read all problems before any page; return the pages that list problems if one changed."""
    found = [read(page, env.doc2path(page)) for page in sorted(env.found_docs) if _is_problem(page)]
    previous = getattr(env, "workbook_catalogue", {})
    env.workbook_catalogue = {
        problem.page: problem for problem in sorted(found, key=lambda problem: problem.order)
    }
    if env.workbook_catalogue == previous:
        return []
    return sorted(getattr(env, "workbook_listings", set()) & env.found_docs)


def setup(app):
    app.connect("env-get-outdated", _load, priority=100)
