"""What can be shown to a class: a problem by its number, a lecture by its slug."""

from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

from workbook.notebooks import exercises


class LiveError(ValueError):
    """Something the lecturer can mend; the message is the whole output, of a cell too."""

    def _render_traceback_(self):
        return [str(self)]


@dataclass(frozen=True)
class Subject:
    """`word` is what the command was given, `problems` the numbers whose answers the magics
    know."""

    word: str
    title: str
    problems: tuple
    path: Path
    is_lecture: bool


def find(word):
    """The problem or lecture that a word such as "1.15" or "limit-cycles" names; raises
    `LiveError`."""
    _hold_checkout()
    if word[:1].isdigit():
        try:
            exercise = exercises.find(word)
        except exercises.UnknownExercise as error:
            raise LiveError(error) from None
        return Subject(word, exercise.about["title"], (word,), exercise.path, is_lecture=False)
    known = {lecture.word: lecture for lecture in lectures()}
    if word not in known:
        near = get_close_matches(word, known, cutoff=0.4)
        raise LiveError(
            f"there is no lecture {word}; "
            + (f"did you mean {' or '.join(near)}?" if near else "`workbook live` lists them")
        )
    return known[word]


def lectures():
    """The lectures in book/lectures/, by their slugs."""
    _hold_checkout()
    return [
        _lecture(path)
        for path in sorted((exercises.CHECKOUT / "book" / "lectures").glob("*.md"))
        if path.stem != "index"
    ]


def _lecture(path):
    import yaml

    head = path.read_text(encoding="utf-8").split("---\n")[1]
    said = yaml.safe_load(head)["lecture"]
    return Subject(path.stem, said["title"], tuple(said["problems"]), path, is_lecture=True)


def _hold_checkout():
    if not (exercises.CHECKOUT / "solutions").is_dir():
        raise LiveError(
            "a lecture needs a checkout of the workbook: the worked solutions are only there"
        )
