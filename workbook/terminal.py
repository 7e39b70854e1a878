"""What the commands share: the console, --course, --json and the error that a user can fix."""

import functools
import inspect
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from workbook import course

#: Formulas and file names are printed as they are, without colours, line breaks and pictures for
#: words such as :skull:.
console = Console(highlight=False, soft_wrap=True, emoji=False)
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON document instead of text.")]
CourseFolder = Annotated[
    Path | None,
    typer.Option(
        "--course", help="Folder of a course; default: the nearest above with workbook.toml."
    ),
]


class UserError(Exception):
    """An error that the user can fix; its message is the whole output."""


class CourseCommands(typer.Typer):
    """Commands that have the option --course."""

    def command(self, *args, **options):
        register = super().command(*args, **options)
        return lambda function: register(_in_course(function))


def _in_course(command):
    """Return a command with a further option, which names the course before the command runs."""

    @functools.wraps(command)
    def with_course(*args, course_folder=None, **options):
        if course_folder is not None:
            course.enter(course_folder)
        return command(*args, **options)

    option = inspect.Parameter(
        "course_folder", inspect.Parameter.KEYWORD_ONLY, default=None, annotation=CourseFolder
    )
    signature = inspect.signature(command)
    parameters = [*signature.parameters.values(), option]
    with_course.__signature__ = signature.replace(parameters=parameters)
    with_course.__annotations__ = command.__annotations__ | {option.name: CourseFolder}
    return with_course
