"""Explorers of formulas that are built once, before the class comes, with their compiled formulas."""

from copy import copy
from functools import cache, wraps


def built_once(build):
    """Return the function with its figures kept by its arguments; it returns copies to set."""
    original = cache(build)

    @wraps(build)
    def figure(*arguments, **options):
        return copy(original(*arguments, **options))

    return figure
