"""Write the scaffold of a new problem: a valid page with its trials, to be filled in."""

import re
from pathlib import Path

from workbook.authoring.contract import master_file
from workbook.authoring.front_matter import read_front_matter
from workbook.authoring.master import master_paths
from workbook.authoring.trials import trials_file

#: The last problem that the problem book has in each of its chapters.
LAST_PRINTED = {1: 18, 2: 37, 3: 26, 4: 43, 5: 70}
#: Stands where the author has to write; a test finds what is left of it.
PLACEHOLDER = "PLACEHOLDER"

PAGE = """\
---
jupytext:
  text_representation: {extension: .md, format_name: myst}
kernelspec: {name: python3, display_name: Python 3, language: python}
problem:
  number: "NUMBER"
  title: PLACEHOLDER title of problem NUMBER
  section: "SECTION"
  level: core
  topics: [PLACEHOLDER topic]
  answers:
    a_region: "condition: PLACEHOLDER the real $k$ for which the zero solution is asymptotically stable"
  hints:
    a_region: ["PLACEHOLDER What signs do the coefficients have?"]
---
# Problem NUMBER

```{exercise-start} PLACEHOLDER title of problem NUMBER
:label: ex-LABEL
:nonumber:
```
PLACEHOLDER Find where the zero solution is asymptotically stable:

a) $\\quad\\ddot x + k\\dot x + x = 0.$

```{code-cell}
:tags: [data]
import sympy as sp
from workbook import checks

k, s = sp.symbols("k s", real=True)
a_poly = s**2 + k*s + 1
```

```{exercise-end}
```

```{solution-start} ex-LABEL
:label: sol-LABEL-a
:class: dropdown
```
**a)** PLACEHOLDER The reasoning, by hand, to the result. The code then confirms it.

```{code-cell}
:tags: [answer]
a_region = k > 0
```

```{solution-end}
```

```{code-cell}
:tags: [check]
checks.report(a_region=checks.stability_region(a_region, a_poly, [k]))
```
"""

TRIALS = """\
# %% wrong
a_region = k >= 0  # PLACEHOLDER Do motions on the border come back? (hint 1)

# %% right
a_region = sp.Ne(k, 0) & (k >= 0)  # PLACEHOLDER the border taken out again
"""


def new_problem(solutions, number):
    """Write page and trials of a new problem.

    Parameters
    ----------
    solutions : path_like
        Folder of the masters.
    number : str
        Number of the problem, such as "2.30".

    Returns
    -------
    page, trials : pathlib.Path
        The files that were written.

    Raises
    ------
    ValueError
        If the number is malformed, or is none that the problem book has in one of its chapters.
    FileExistsError
        If one of the files exists.
    """
    if not re.fullmatch(r"[1-9]\d*\.[1-9]\d*", number):
        raise ValueError(f"{number} is no number of a problem; write it like 2.30")
    chapter, problem = map(int, number.split("."))
    if problem > LAST_PRINTED.get(chapter, problem):
        raise ValueError(
            f"chapter {chapter} of the problem book ends with problem {chapter}.{LAST_PRINTED[chapter]}: "
            f"a new problem belongs to a chapter from {max(LAST_PRINTED) + 1} on"
        )
    page = Path(solutions) / master_file(number)
    texts = {page: PAGE, trials_file(page): TRIALS}
    for path in texts:
        if path.exists():
            raise FileExistsError(f"{path} is there already")
    values = {
        "NUMBER": number,
        "LABEL": number.replace(".", "-"),
        "SECTION": _section(solutions, page),
    }
    page.parent.mkdir(parents=True, exist_ok=True)
    for path, text in texts.items():
        path.write_text(
            re.sub("|".join(values), lambda match: values[match[0]], text), encoding="utf-8"
        )
    return tuple(texts)


def _section(solutions, page):
    """Return the section of the last problem before this one, or the first of the chapter."""
    before = [
        path
        for path in master_paths(solutions)
        if path.parent == page.parent and path.stem < page.stem
    ]
    if not before:
        return f"§{page.parent.name[2:]}.1"
    return read_front_matter(before[-1], before[-1].read_text(encoding="utf-8"))[0]["section"]
