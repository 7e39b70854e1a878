"""Find what can be presented to a class: a problem by its number, a lecture by its slug."""

from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

from workbook.course import courses
from workbook.live.errors import LiveError
from workbook.notebooks import exercises

#: Where the worked solutions are.
MASTERS = "they are in a checkout of the workbook, and in a course of one's own"


@dataclass(frozen=True)
class Presentation:
    """A problem or a lecture to present.

    Attributes
    ----------
    name : str
        Number of the problem or slug of the lecture.
    title : str
        Its title.
    problems : tuple of str
        Numbers of the problems whose answers the magics can name without a number.
    path : pathlib.Path
        The student notebook or the page of the lecture.
    is_lecture : bool
        Whether it is a lecture.
    """

    name: str
    title: str
    problems: tuple
    path: Path
    is_lecture: bool


def find_presentation(name):
    """Return the problem or lecture with a name such as "1.15" or "limit-cycles".

    Raises
    ------
    LiveError
        If there is none, or its masters are not here.
    """
    if "." in name:
        try:
            exercise, master = exercises.find(name), exercises.master_path(name)
        except exercises.UnknownExercise as error:
            raise LiveError(error) from None
        if not master.is_file():
            raise LiveError(f"the worked solution of {name} is not here: {MASTERS}")
        return Presentation(name, exercise.about["title"], (name,), exercise.path, is_lecture=False)
    lectures_by_name = {lecture.name: lecture for lecture in lectures()}
    if name not in lectures_by_name:
        similar = get_close_matches(name, lectures_by_name, cutoff=0.4)
        raise LiveError(
            f"there is no lecture {name}; "
            + (f"did you mean {' or '.join(similar)}?" if similar else "`workbook live` lists them")
        )
    return lectures_by_name[name]


def lectures():
    """Return the lectures of the workbook and the course, each in the order of their slugs.

    Raises
    ------
    LiveError
        If there are no masters here.
    """
    homes = courses()
    if not any(home.solutions.is_dir() for home in homes):
        raise LiveError(f"a lecture needs the worked solutions: {MASTERS}")
    return [
        _lecture(path)
        for home in homes
        for path in sorted(home.lectures.glob("*.md"))
        if path.stem != "index"
    ]


def _lecture(path):
    import yaml  # problems do not need it

    front_matter = yaml.safe_load(path.read_text(encoding="utf-8").split("---\n")[1])["lecture"]
    return Presentation(
        path.stem, front_matter["title"], tuple(front_matter["problems"]), path, is_lecture=True
    )
