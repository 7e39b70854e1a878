"""What a person meant by code that Python cannot read: signs of a formula, look-alike letters, slips.

`read_typed` is the one place where a student's text is rewritten, for pages, notebooks and the
command alike. It changes nothing that is valid Python, and returns valid Python or the text as it
was. Names that Python accepts but that are not those of the data (`к1` with a Cyrillic letter, `k_1`,
`a_regoin`) are not rewritten: `similar_name` finds the name that was meant, for a message. The time
that both take grows with the length of the text and no faster.
"""

import ast
import re
import unicodedata
import warnings

#: What stands for one character outside of texts and comments.
SIGNS = {
    **dict.fromkeys("≤⩽≦", "<="),
    **dict.fromkeys("≥⩾≧", ">="),
    **dict.fromkeys("−–—", "-"),
    **dict.fromkeys("·⋅∙×∗", "*"),
    **dict.fromkeys("÷∕⁄", "/"),
    **dict.fromkeys("“”„«»", '"'),
    **dict.fromkeys("‘’‚", "'"),
    # spaces of a word processor, and marks without width that come with copied text
    **dict.fromkeys("\u00a0\u2002\u2003\u2009\u202f", " "),
    **dict.fromkeys("\u200b\u200c\u200d\u2060\ufeff", ""),
    "∞": "sp.oo",
    # full-width forms
    **{chr(code + 0xFEE0): chr(code) for code in range(0x21, 0x7F)},
}
DIGITS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻₀₁₂₃₄₅₆₇₈₉", "0123456789+-0123456789")
#: Letters of the Cyrillic and Greek alphabets that look like these Latin ones.
LOOKALIKES = str.maketrans(
    "АВЕКМНОРСТХаекорсухіјѕΑΒΕΖΗΙΚΜΝΟΡΤΥΧονρ", "ABEKMHOPCTXaekopcyxijsABEZHIKMNOPTYXovp"
)
TEXT_OR_COMMENT = "|".join(
    [
        r'"""(?s:.*?)(?:"""|\Z)',
        r"'''(?s:.*?)(?:'''|\Z)",
        r'"(?:[^"\\\n]|\\.)*"?',
        r"'(?:[^'\\\n]|\\.)*'?",
        r"\#[^\n]*",
    ]
)
SUPERSCRIPTS, SUBSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹", "₀₁₂₃₄₅₆₇₈₉"
WRITTEN = re.compile(
    rf"(?P<kept>{TEXT_OR_COMMENT})"
    r"|\$(?P<formula>[^$\n]*)\$"
    # sin²(x) is left as it is; the whole run of digits or nothing, or the time would grow with its square
    rf"|(?<![{SUPERSCRIPTS}])(?P<power>[⁺⁻]?[{SUPERSCRIPTS}]+)(?!\w|\s*\()"
    rf"|(?P<digits>[{SUBSCRIPTS}]+)"
    # the root of x² may be that of x or of x²: it is left as it is
    rf"|√(?P<radicand>[^\W{SUPERSCRIPTS}]+|(?=\())(?![{SUPERSCRIPTS}\w.])"
    r"|(?<!\w)(?P<pi>π)(?!\w)"
    rf"|(?P<sign>[{re.escape(''.join(SIGNS))}])"
)
#: Of a formula between dollars.
SUBSCRIPT = re.compile(r"(?<=[A-Za-z])_(?:\{(\w+)\}|(\w))")
#: Names shorter than this are not compared letter by letter: k1 and k2 are no slips.
SHORTEST = 4


def read_typed(source):
    """Return the Python that was meant by the text of a cell, or the text as it is.

    Parameters
    ----------
    source : str
        A cell. Valid Python is returned unchanged, as is what cannot be read.

    Returns
    -------
    str
        Valid Python if it is not `source`.

    Examples
    --------
    >>> read_typed("a_region = k₁ ≥ 0")
    'a_region = k1 >= 0'
    >>> read_typed("a = x² − √(x + 1)·2")
    'a = x**2 - sp.sqrt(x + 1)*2'
    >>> read_typed("$k_1>0$")
    'k1>0'
    >>> read_typed("name = 'k₁ ≥ 0'"), read_typed("a = (≥")
    ("name = 'k₁ ≥ 0'", 'a = (≥')
    """
    if not WRITTEN.search(source) or is_python(source):
        return source
    read = WRITTEN.sub(_meant, source)
    return read if read != source and is_python(read) else source


def _meant(match):
    kind, text = match.lastgroup, match[match.lastgroup]
    if kind == "kept":
        return text
    if kind == "formula":
        plain = WRITTEN.sub(_meant, text)
        return SUBSCRIPT.sub(lambda index: index[1] or index[2], plain).replace("^", "**")
    if kind == "power":
        return "**" + text.translate(DIGITS).lstrip("+")
    if kind == "radicand":
        return f"sp.sqrt({text.translate(DIGITS)})" if text else "sp.sqrt"
    return {"digits": text.translate(DIGITS), "pi": "sp.pi"}.get(kind) or SIGNS[text]


def is_python(source):
    """Return whether Python can read a cell."""
    return _body(source) is not None


def expression_in(source):
    """Return the text of a cell's one expression, "" for another cell and for `name == ...`."""
    node = _only_expression(source)
    return (ast.get_source_segment(source, node) or "") if node and not _compared(node) else ""


def compared_name(source):
    """Return the name of a cell `name == ...`, in which an assignment was meant, or ""."""
    node = _only_expression(source)
    return _compared(node) if node else ""


def _only_expression(source):
    body = _body(source)
    is_one = body is not None and len(body) == 1 and isinstance(body[0], ast.Expr)
    return body[0].value if is_one else None


def _compared(node):
    return (
        node.left.id
        if isinstance(node, ast.Compare)
        and isinstance(node.left, ast.Name)
        and isinstance(node.ops[0], ast.Eq)
        else ""
    )


def _body(source):
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # SyntaxWarning, which the cell itself will show
            return ast.parse(source).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def similar_name(name, names):
    """Return the one of `names` that was meant by another name, or "" if it is none or several.

    It is the same but for look-alike letters, case and underscores; or it differs in one letter that
    is left out, added, changed or swapped with the next; or it has an item's letter before it.

    >>> similar_name("a_regoin", ["a_region", "b_region"]), similar_name("k_1", ["k1", "k2"])
    ('a_region', 'k1')
    >>> similar_name("k3", ["k1", "k2"])
    ''
    """
    for is_similar in (_looks_like, _is_slip_of, _lacks_item):
        found = [other for other in names if other != name and is_similar(name, other)]
        if found:
            return found[0] if len(found) == 1 else ""
    return ""


def skeleton(name):
    """Return a name with Latin letters in place of those that look like them.

    >>> skeleton("к₁") == "k1"
    True
    """
    return unicodedata.normalize("NFKC", name).translate(LOOKALIKES)


def foreign_letters(name):
    """Return the letters of a name that only look Latin.

    >>> foreign_letters("к1")
    'к'
    """
    return "".join(letter for letter in name if letter.translate(LOOKALIKES) != letter)


def alphabet(letter):
    """Return "Cyrillic" or "Greek"."""
    return unicodedata.name(letter).split()[0].capitalize()


def _looks_like(name, other):
    def plain(word):
        return skeleton(word).casefold().replace("_", "")

    return plain(name) == plain(other)


def _is_slip_of(name, other):
    if min(len(name), len(other)) < SHORTEST:
        return False
    same = _common(name, other)
    name, other = name[same:], other[same:]
    same = _common(name[::-1], other[::-1])
    name, other = name[: len(name) - same], other[: len(other) - same]
    is_swap = len(name) == 2 and name == other[::-1]
    return ((len(name) <= 1 and len(other) <= 1) or is_swap) and (name + other).isalpha()


def _common(name, other):
    """Return how many letters two names have in common at their beginnings."""
    return next(
        (k for k, (a, b) in enumerate(zip(name, other)) if a != b), min(len(name), len(other))
    )


def _lacks_item(name, other):
    item, _, rest = other.partition("_")
    return len(item) == 1 and rest == name
