"""Write the scaffold of a problem, to be filled in, or of a course with one complete problem."""

import re
from pathlib import Path

from workbook import course
from workbook.authoring.front_matter import read_front_matter
from workbook.authoring.master import master_paths
from workbook.authoring.trials import trials_file
from workbook.notebooks import exercises
from workbook.numbering import read_number

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


COURSE = """\
title = "TITLE"
name = "NAME"  # its chapters are NAME, or NAME1, NAME2, ...
# credit = "TITLE, University of Nowhere, 2026"  # the last cell of each notebook
# workbook = ">=0.2,<0.3"  # the versions that the problems were proved with
# site = "https://..."  # where notebooks link to
# wheel = "https://..."  # where students get the workbook
"""
CONF = """\
# The site: `workbook page` once, then `sphinx-build . _build/html` (extras site and page).
project = html_title = "TITLE"
extensions = ["workbook.site"]
html_theme = "sphinx_book_theme"
# With "solutions" here in place of "exercises" the site has no solutions.
exclude_patterns = ["_build", "assignments", "exercises", "graded", "submitted", "variants"]
"""
INDEX = """\
# TITLE

```{problem-list}
```

```{toctree}
:hidden:
:glob:

*/ch*/p*
```
"""
FIRST_PAGE = """\
---
jupytext:
  text_representation: {extension: .md, format_name: myst}
kernelspec: {name: python3, display_name: Python 3, language: python}
problem:
  number: "NUMBER"
  title: A pendulum held upright by a motor
  section: Stability
  level: core
  topics: [PD control]
  answers:
    a_region: "condition: the real gains $k_p$, $k_d$ for which $q = 0$ is asymptotically stable"
  hints:
    a_region: ["Which term has the factor $q$ besides the one with the gain?"]
---
# Problem NUMBER

```{exercise-start} A pendulum held upright by a motor
:label: ex-LABEL
:nonumber:
```
A motor at the joint of a pendulum has the torque $-k_p q - k_d\\dot q$, where $q$ is the angle from the upper position.
Near this position

$$\\ddot q + k_d\\dot q + (k_p - 2)q = 0.$$

a) For which gains is $q = 0$ asymptotically stable?

```{code-cell}
:tags: [data]
import sympy as sp
from workbook import checks

gravity = 2
k_p, k_d, s = sp.symbols("k_p k_d s", real=True)
a_poly = s**2 + k_d*s + k_p - gravity
```

```{exercise-end}
```

```{solution-start} ex-LABEL
:label: sol-LABEL-a
:class: dropdown
```
**a)** A polynomial of degree two is Hurwitz if and only if its coefficients have the same sign. The first is 1, so
$k_d > 0$ and $k_p > 2$: the gain has to exceed the torque of gravity.

```{code-cell}
:tags: [answer]
a_region = sp.And(*(coefficient > 0 for coefficient in sp.Poly(a_poly, s).all_coeffs()[1:]))
```

```{solution-end}
```

```{code-cell}
:tags: [check]
checks.report(a_region=checks.stability_region(a_region, a_poly, [k_p, k_d]))
```
"""
FIRST_TRIALS = """\
# %% wrong
a_region = (k_p > 0) & (k_d > 0)  # Did you forget the torque of gravity? (hint 1)
a_region = (k_p >= gravity) & (k_d > 0)  # What becomes of a small deviation if both torques balance?
a_region = k_p > gravity  # Do oscillations die out without damping?

# %% right
a_region = sp.Min(k_p - gravity, k_d) > 0  # as one minimum

# %% numbers
gravity = [2, 3, 5, 7, 11]
shown = [r"(k_p - «gravity»)q", r"k_p > «gravity»"]
a_region = (k_d > 0) & (k_p > gravity)
"""


def new_course(folder):
    """Begin a course in a folder: its `workbook.toml`, one complete problem, and a site.

    Parameters
    ----------
    folder : path_like
        The folder, which may not be a course yet; the word of its chapters is made of its name.

    Returns
    -------
    paths : list of pathlib.Path
        The files that were written.
    number : str
        The number of the problem.

    Raises
    ------
    ValueError
        If the folder's name has no letters to make a word of.
    FileExistsError
        If one of the files exists.
    """
    folder = Path(folder)
    name = "".join(re.findall("[a-z]", folder.resolve().name.lower()))[:20]
    if len(name) < 2:
        raise ValueError(
            f"{folder}: the folder of a course has a name with letters, such as robotics"
        )
    number = read_number(f"{name}.1")
    page = folder / "solutions" / number.file(".md")
    values = {
        "NUMBER": number.base,
        "LABEL": number.label,
        "NAME": name,
        "TITLE": folder.resolve().name.replace('"', ""),
    }
    texts = {
        folder / course.FILE: COURSE,
        folder / "conf.py": CONF,
        folder / "index.md": INDEX,
        page: FIRST_PAGE,
        trials_file(page): FIRST_TRIALS,
    }
    return _written(texts, values), number.base


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
    parts = read_number(number)
    if not parts or parts.row or any(part.startswith("0") for part in parts):
        raise ValueError(f"{number} is no number of a problem; write it like 2.30 or rob.1")
    home = exercises.home_of(number)
    home.validate_new(number)
    page = Path(solutions) / parts.file(".md")
    texts = {page: PAGE, trials_file(page): TRIALS}
    values = {
        "NUMBER": number,
        "LABEL": parts.label,
        "SECTION": _section(solutions, page) or home.section_of(parts.chapter),
    }
    return tuple(_written(texts, values))


def _written(texts, values):
    """Write files with values in place of their names; return their paths."""
    for path in texts:
        if path.exists():
            raise FileExistsError(f"{path} is there already")
    for path, text in texts.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(
            re.sub("|".join(values), lambda match: values[match[0]], text), encoding="utf-8"
        )
    return list(texts)


def _section(solutions, page):
    """Return the section of the last problem of the chapter before this one, "" if there is none."""
    before = [
        path
        for path in master_paths(solutions)
        if path.parent == page.parent and path.stem < page.stem
    ]
    if not before:
        return ""
    return read_front_matter(before[-1], before[-1].read_text(encoding="utf-8"))[0]["section"]
