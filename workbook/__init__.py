"""The course on top of `trajlib`: checks, notebooks, grading, authoring and lectures.

The command is `workbook` (`workbook.cli`).
"""

from workbook import hooks


def _find_mistake(problem, answer, value):
    # mistakes load with the first wrong answer
    from workbook.mistakes import find_mistake

    return find_mistake(problem, answer, value)


# Mistakes stand above the checks, whose report names them.
hooks.find_mistake = _find_mistake
