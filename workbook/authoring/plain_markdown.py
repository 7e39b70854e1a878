"""Convert the book's MyST Markdown into Markdown that any Jupyter shows.

Directives become headings, quotes and formulas; references become the texts that they show.
"""

import re

from workbook.numbering import NUMBER

DIRECTIVE = re.compile(
    r"^(?P<fence>`{3,}|:{3,})\{(?P<name>[\w:-]+)\}[ "
    r"\t]*(?P<argument>[^\n]*)\n(?P<body>.*?)^(?P=fence)[ \t]*$\n?",
    re.M | re.S,
)
OPTIONS = re.compile(r"(?:^:[\w-]+:.*\n)+", re.M)
REMOVED = {"index", "exercise-end", "solution-start", "solution-end"}
#: A third derivative, for which VS Code's KaTeX shows an error in red before version 0.16.
THIRD_DERIVATIVE = re.compile(r"\\dddot\s*(?:\{(\w+)\}|(\w|\\[a-z]+))")
#: A reference during the conversion, as text and address; the separators occur in no text.
REFERENCE = re.compile("\x02(.*?)\x03(.*?)\x04", re.S)
#: The end of the text before a new sentence.
SENTENCE_END = re.compile(r"(?<!e\.g)(?<!i\.e)(?<!cf)[.!?][)\"”*]*\s+$")
#: The end of the text before a new paragraph or list item.
PARAGRAPH_START = re.compile(
    r"(\A|\n[>\s]*\n|\n(?=[>\s]*([-*+|]|\d+\.) ))[>\s]*(([-*+|]|\d+\.) +)?\**$"
)


def plain_markdown(text, links=None, number=""):
    """Convert MyST Markdown into plain Markdown and list the references in it.

    Parameters
    ----------
    text : str
        MyST Markdown of a page of the book.
    links : Links, optional
        Addresses of the labels; without it no reference is listed.
    number : str
        Number of the problem, for the heading of its exercise.

    Returns
    -------
    text : str
        Plain Markdown, in which references are words without links.
    references : list of (str, str)
        (words, address below the site's root) of each reference, in the order of the text.
    """

    def url(label):
        return links.url(label) if links else None

    text = _without_directives(text, number)
    # the heading of the exercise repeats it, with the title
    text = re.sub(rf"^# Problem {NUMBER.pattern}$", "", text, flags=re.M)
    text = re.sub(r"^\([\w-]+\)=\n", "", text, flags=re.M)
    text = re.sub(r"\[([^\]]+)\]\(#([\w-]+)\)", lambda m: _reference(m[1], url(m[2])), text)
    text = re.sub(
        r"\{(?:ref|numref|prf:ref)\}`([^`<]+?)\s*<([\w-]+)>`",
        lambda m: _reference(m[1], url(m[2])),
        text,
    )
    text = re.sub(
        r"\{eq\}`eq-([\w-]+)`",
        lambda m: _reference(
            f"({_tag(m[1])})", url(f"eq-{m[1]}") if re.fullmatch(r"[a-z]*\d*-\d+", m[1]) else None
        ),
        text,
    )
    text = re.sub(
        rf"\{{problem\}}`({NUMBER.pattern})`",
        lambda m: f"{'Pp'[not _starts_sentence(m.string[: m.start()])]}roblem {m[1]}",
        text,
    )
    text = re.sub(r"\{cite(?::\w)?\}`[^`]*`", "", text)
    # remarks on the printed book
    text = re.sub(r"^\{printed\}`[^`]*`\s*| \{printed\}`[^`]*`", "", text, flags=re.M)
    text = re.sub(r"\{[\w:]+\}`([^`<]+?)(?:\s*<[^>]*>)?`", r"\1", text)
    text = THIRD_DERIVATIVE.sub(lambda m: rf"\overset{{\ldots}}{{{m[1] or m[2]}}}", text)
    text = re.sub(r"\n{3,}", "\n\n", text).strip()
    return REFERENCE.sub(r"\1", text), [match.groups() for match in REFERENCE.finditer(text)]


def _starts_sentence(before):
    return bool(SENTENCE_END.search(before) or PARAGRAPH_START.search(before))


def _reference(text, url):
    return text if url is None else f"\x02{text}\x03{url}\x04"


def _without_directives(text, number):
    return DIRECTIVE.sub(lambda match: _directive(match, number), text)


def _directive(match, number):
    name, argument = match["name"], match["argument"].strip()
    options = OPTIONS.match(match["body"])
    body = match["body"][options.end() :] if options else match["body"]
    label = re.search(r":label:\s*(\S+)", options[0]) if options else None
    if name in REMOVED:
        return ""
    if name == "exercise-start":
        return f"# Problem {number}. {argument}\n"
    if name == "math":
        tag = rf" \tag{{{_tag(label[1].removeprefix('eq-'))}}}" if label else ""
        return f"$$\n{body.strip()}{tag}\n$$\n"
    if name in ("figure", "image"):
        return f"*{body.strip()}*\n" if body.strip() else ""
    heading = argument or name.removeprefix("prf:").capitalize()
    quoted = "\n".join(
        f"> {line}".rstrip() for line in _without_directives(body, number).strip().split("\n")
    )
    return f"> **{heading}**\n>\n{quoted}\n"


def _tag(label):
    """Return the number of a label, 1.15a for 1-15-a."""
    chapter, *parts = label.split("-")
    return ".".join([chapter, "".join(parts)]) if parts else chapter
