"""What the commands share: the console, the option --json and the error that a user can fix."""

from typing import Annotated

import typer
from rich.console import Console

#: Formulas and file names are printed as they are, without colours, line breaks and pictures for
#: words such as :skull:.
console = Console(highlight=False, soft_wrap=True, emoji=False)
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON document instead of text.")]


class UserError(Exception):
    """An error that the user can fix; its message is the whole output."""
