"""Foreign text made fit for terminals, pages and databases: what is no character, or would move a
cursor, becomes an escape."""

import os
import unicodedata

#: Control characters, halves of characters, separators of lines and paragraphs.
UNFIT = {"Cc", "Cs", "Zl", "Zp"}
#: Characters that reverse the direction of the text after them.
TURNING = {chr(k) for k in (*range(0x202A, 0x202F), *range(0x2066, 0x206A))}


def printable(text, keep=""):
    """The text with escapes such as `\\x1b` for what cannot be shown, but for characters in
    `keep`."""
    return "".join(
        c.encode("unicode_escape").decode() if _unfit(c) and c not in keep else c for c in text
    )


def printable_name(path):
    """A file name as printable text, different for different names: the backslash that begins an
    escape is doubled too."""
    return printable(os.fsencode(path).replace(b"\\", b"\\\\").decode("utf-8", "backslashreplace"))


def person_or_homework(path):
    """The name of a folder that is a student's or a homework's: a letter with its accent is one
    letter, however a system spells it."""
    return unicodedata.normalize("NFC", printable_name(path))


def _unfit(character):
    return unicodedata.category(character) in UNFIT or character in TURNING
