"""Former names of answers, under which notebooks that were handed out before still work.

Checks, grades and pages take the value of the former name where the present one has none.
"""

import re

#: {words of a name: its former ones}; an item's letter stands before, the name of a measurement behind.
FORMER = {
    "unobservable_states": "unseen",
    "unobservable_displacements": "unseen",
    "unobservable_variance": "unseen",
    "unobservable_change": "unseen",
    "unobservable_eigenvalues": "lost",
    "uncontrollable_eigenvalues": "lost",
    "uncontrollable_rows": "lost",
    "motion_observable": "seen",
}
RENAMED = re.compile(rf"\b((?:[a-z]|equal)_)?({'|'.join(FORMER)})(_z\d)?\b", re.ASCII)


def with_former_names(text):
    """Return code with the former names of answers, or the former name of one.

    >>> with_former_names("a_unobservable_states_z1"), with_former_names("a_region")
    ('a_unseen_z1', 'a_region')
    """
    return RENAMED.sub(lambda name: f"{name[1] or ''}{FORMER[name[2]]}{name[3] or ''}", text)


def adopt(namespace, names):
    """Give answers without a value that of their former names.

    Parameters
    ----------
    namespace : dict
        The notebook's names.
    names : iterable of str
        Names of answers.
    """
    for name in names:
        former = namespace.get(with_former_names(name), ...)
        if former is not ... and namespace.get(name, ...) is ...:
            namespace[name] = former
