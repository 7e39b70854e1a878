"""Sanitising: make foreign text safe for terminals, pages and databases.

Control characters, and characters that are none, become escapes such as `\\x1b`.
"""

import os
import re
import unicodedata

#: Control characters, halves of characters, separators of lines and paragraphs.
ESCAPED_CATEGORIES = {"Cc", "Cs", "Zl", "Zp"}
#: Characters that reverse the direction of the text after them.
DIRECTION_MARKS = {chr(k) for k in (*range(0x202A, 0x202F), *range(0x2066, 0x206A))}

#: Names that Windows keeps for devices, with any suffix; what it has in no name, or not at the end.
DEVICE = re.compile(r"\A(con|prn|aux|nul|com\d|lpt\d)(?=\.|$)", re.IGNORECASE)
NOT_IN_NAMES = re.compile(r'[<>:"/\\|?*\x00-\x1f]|[. ](?=[. ]*$)')


def sanitise(text, keep=""):
    """Return the text with escapes for what cannot be shown, except characters in `keep`."""
    return "".join(
        c.encode("unicode_escape").decode() if _is_unsafe(c) and c not in keep else c for c in text
    )


def sanitise_name(path):
    """Return a file name as safe text, different for different names.

    So a backslash, which begins an escape, is doubled too.
    """
    return sanitise(os.fsencode(path).replace(b"\\", b"\\\\").decode("utf-8", "backslashreplace"))


def normalise_name(path):
    """Return the name of a student's or homework's folder in one form of Unicode (NFC).

    Systems differ in whether a letter with an accent is one character or two.
    """
    return unicodedata.normalize("NFC", sanitise_name(path))


def portable_name(name):
    """Return a name that a file can have on every system, this one where it can have it.

    >>> portable_name("aux.ipynb"), portable_name("a: b?.ipynb"), portable_name("p15.ipynb")
    ('aux_.ipynb', 'a_ b_.ipynb', 'p15.ipynb')
    """
    return DEVICE.sub(r"\1_", NOT_IN_NAMES.sub("_", name))


def _is_unsafe(character):
    return unicodedata.category(character) in ESCAPED_CATEGORIES or character in DIRECTION_MARKS
