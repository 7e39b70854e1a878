"""Docstrings as the pages of the library show them.

numpydoc turns the sections of a docstring into reStructuredText, whose blocks (paragraphs, lists,
fields, examples) Docutils reads. The words in them stay plain text, as `help` prints them: a star,
a bar or an underscore is no markup, code stands between backquotes, and formulas are typeset.
"""

import re
from html import escape

from docutils import nodes
from docutils.parsers.rst import Parser
from docutils.utils import Reporter, new_document

from trajlib.typesetting import typeset

#: What numpydoc adds to a docstring: names in bold type, and roles.
NAME = re.compile(r"\*\*(?P<name>.+?)\*\*(?= : |$)")
ROLE = re.compile(r":\w+:(?=`)|(?<=\w) <[\w.~]+>(?=`)")
CODE = re.compile(r"(`+)(.+?)\1", re.S)


class PlainInliner:
    """The inline parser that Docutils calls: formulas and `code` are the only markup."""

    def init_customizations(self, settings):
        pass

    def parse(self, text, lineno, memo, parent):
        """Return the nodes of a text and no messages."""
        text = re.sub(r"\\(.)", r"\1", ROLE.sub("", text))
        if name := NAME.match(text):
            # Docutils takes the type of an argument from the plain text behind its name.
            kind = text[name.end() :]
            return [nodes.strong("", name["name"]), *([nodes.Text(kind)] if kind else [])], []
        return spans(text), []


def parse(text, document):
    """Return the nodes of reStructuredText whose words are plain text."""
    parsed = new_document(document["source"], document.settings)
    # The blocks of a docstring are words too: an unusual indentation in them is no fault of the book.
    parsed.reporter = Reporter(document["source"], report_level=Reporter.SEVERE_LEVEL, halt_level=5)
    Parser(inliner=PlainInliner()).parse(text, parsed)
    for message in list(parsed.findall(nodes.system_message)):
        message.parent.remove(message)
    for quote in list(parsed.findall(nodes.block_quote)):
        _show_formulas(quote)
    return parsed.children


def spans(text):
    """Return the nodes of a line of words: formulas typeset, and the `code` between them."""
    found, end = [], 0
    for code in CODE.finditer(text):
        found += [*_words(text[end : code.start()]), nodes.literal("", code[2])]
        end = code.end()
    return [*found, *_words(text[end:])]


def _words(text):
    if not text:
        return []
    html = typeset(text)
    return [nodes.Text(text) if html == escape(text) else nodes.raw("", html, format="html")]


def _show_formulas(quote):
    """Replace an indented block of formulas, in which lines count, by a literal block."""
    if all(isinstance(part, nodes.paragraph) for part in quote):
        text = "\n\n".join(part.rawsource for part in quote)
        quote.replace_self(nodes.literal_block(text, text, language="text"))
