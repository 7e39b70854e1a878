"""A master to begin with: page and trials that are right in everything but what the problem is
about."""

import re
from pathlib import Path

from workbook.authoring.contract import master_file
from workbook.authoring.front_matter import read_front_matter
from workbook.authoring.master import master_paths
from workbook.authoring.trials import trials_file

#: Stands wherever the author has something to say; a test finds what is left of it.
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
    a_region: ["PLACEHOLDER Which sign have the coefficients?"]
---
# Problem NUMBER

```{index} NUMBER
```

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


def begin(solutions, number):
    """Write page and trials of a new problem below the folder `solutions`; returns their paths.

    Raises `ValueError` for what is no number of a problem, and `FileExistsError` if one of the
    files is there.
    """
    if not re.fullmatch(r"[1-9]\d*\.[1-9]\d*", number):
        raise ValueError(f"{number} is no number of a problem; write it like 2.30")
    page = Path(solutions) / master_file(number)
    texts = {page: PAGE, trials_file(page): TRIALS}
    for path in texts:
        if path.exists():
            raise FileExistsError(f"{path} is there already")
    said = {
        "NUMBER": number,
        "LABEL": number.replace(".", "-"),
        "SECTION": _section(solutions, page),
    }
    page.parent.mkdir(parents=True, exist_ok=True)
    for path, text in texts.items():
        path.write_text(
            re.sub("|".join(said), lambda found: said[found[0]], text), encoding="utf-8"
        )
    return tuple(texts)


def _section(solutions, page):
    """The section of the last problem before this one, or the first of the chapter."""
    before = [
        path
        for path in master_paths(solutions)
        if path.parent == page.parent and path.stem < page.stem
    ]
    if not before:
        return f"§{page.parent.name[2:]}.1"
    return read_front_matter(before[-1], before[-1].read_text(encoding="utf-8"))[0]["section"]
