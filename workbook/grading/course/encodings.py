"""Encodings: text of which nobody says how it is encoded, as spreadsheets and archivers write it.

Of several encodings the first counts in which the bytes are text. In UTF-8 hardly anything else can
be read; in others there is to be no control character, no word of both Latin and Cyrillic letters,
no letter beside a symbol, and in a Russian one some Cyrillic letter.
"""

import re
from contextlib import suppress

#: Encodings that nobody uses without a Cyrillic letter.
RUSSIAN = {"cp866", "cp1251"}
CONTROL = r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f]"
LATIN, CYRILLIC = r"[A-Za-z\xc0-\u024f]", r"[\u0400-\u04ff]"
#: Such as currencies, fractions and parts of boxes; quotation marks and dashes touch letters.
SYMBOL = (
    r"[\xa2-\xaa\xac-\xb6\xb8-\xba\xbc-\xbf\xd7\xf7\u2020\u2021\u2030\u20ac\u2122\u2219-\u25ff]"
)
#: What stands between words only.
INSIDE = r"[\u201a\u201c-\u201e\u2022\u2026\u2116]"
NO_TEXT = re.compile(
    f"{CONTROL}|{LATIN}{CYRILLIC}|{CYRILLIC}{LATIN}|{SYMBOL}{CYRILLIC}|{CYRILLIC}{SYMBOL}"
    f"|{SYMBOL}{LATIN}|{LATIN}{SYMBOL}|{LATIN}{INSIDE}{LATIN}"
)


def decoded(data, encodings):
    """Return (text, the first of `encodings` in which `data` is one); ("", None) if none is.

    >>> decoded("Иванов;Müller".encode("cp1251", "ignore"), ["utf-8", "cp1251"])
    ('Иванов;Mller', 'cp1251')
    >>> decoded("Müller".encode("cp1252"), ["utf-8", "cp1251", "cp1252"])
    ('Müller', 'cp1252')
    """
    for encoding in encodings:
        with suppress(UnicodeDecodeError):
            text = data.decode(encoding)
            if "\0" not in text and (encoding.startswith("utf") or _is_text(text, encoding)):
                return text, encoding
    return "", None


def _is_text(text, encoding):
    is_written_in = encoding not in RUSSIAN or re.search(CYRILLIC, text)
    return bool(is_written_in) and not NO_TEXT.search(text)
