"""Cut the text of a lecture into slides of at most forty words."""

import re

from workbook.live.steps import paragraphs

#: What a hall reads while somebody speaks.
MOST_WORDS = 40
#: A slide of fewer words gets more from the one before it.
FEWEST_WORDS = 10
HEADING = re.compile(r"#{1,3} [^\n]*\n*")
FORMULA = re.compile(r"\$\$.*?\$\$|\$[^$]*\$", re.S)
#: Blanks within a formula do not end a sentence; they stand as this meanwhile.
JOINT = "\0"
SENTENCE_END = re.compile(r"(?<=[.?!])(?<!e\.g\.)(?<!i\.e\.)(?<!cf\.)\s+|(?<=[.?!]\*\*)\s+")
LIST_ITEM = re.compile(r"\n(?=[-*] |\d+\. )")
BLANK_LINES = re.compile(r"\n{2,}")


def word_count(text):
    """Return the number of words that a slide shows, a formula being one; titles do not count."""
    words = HEADING.sub("", FORMULA.sub(" x ", text)).split()
    return sum(any(letter.isalnum() for letter in word) for word in words)


def slide_texts(text):
    """Cut Markdown into slides: whole paragraphs where they fit, else sentences with their lists.

    Parameters
    ----------
    text : str
        A title, if any, and the paragraphs below it.

    Returns
    -------
    list of str
        The texts of the slides; only a sentence that has too many words itself exceeds the limit.
    """
    title = HEADING.match(text)
    body = paragraphs(text[title.end() :] if title else text)
    slides = _packed(body, MOST_WORDS)
    # no short sentence is left alone: as many slides, the last of which has more of the text
    for most in range(MOST_WORDS - 1, 0, -1):
        shorter = _packed(body, most)
        if not slides or word_count(slides[-1]) >= FEWEST_WORDS or len(shorter) > len(slides):
            break
        slides = shorter
    if title:
        slides[:1] = ["\n\n".join([title[0].strip(), *slides[:1]])]
    return slides


def _packed(body, most):
    """Return slides of at most so many words, where the pieces of the paragraphs allow it."""
    slides = []
    for paragraph in body:
        pieces = [paragraph] if word_count(paragraph) <= most else _pieces(paragraph)
        for k, piece in enumerate(pieces):
            joint = "\n\n" if k == 0 else "" if piece.startswith("\n") else " "
            joined = slides[-1] + joint + piece if slides else piece
            if slides and word_count(joined) <= most:
                slides[-1] = joined
            else:
                slides.append(piece.strip())
    return slides


def _pieces(paragraph):
    """Split a paragraph into sentences, each with the formulas and the list that belong to it."""
    pieces = []
    for block in BLANK_LINES.split(FORMULA.sub(_hide_blanks, paragraph)):
        if block.startswith("$$") and pieces:
            pieces[-1] += "\n\n" + block
            continue
        items = LIST_ITEM.split(block)
        sentences = [] if _is_list(items[0]) else SENTENCE_END.split(items.pop(0))
        if sentences:
            # a sentence may go on below a formula
            _append(pieces, sentences[0], "\n\n", joined=sentences[0][0].islower())
            pieces += sentences[1:]
        if items:
            _append_list(pieces, items, "\n" if sentences else "\n\n")
    return [piece.replace(JOINT + "n", "\n").replace(JOINT + "s", " ") for piece in pieces]


def _append(pieces, text, joint, joined):
    """Append a text to the last piece, if it is to be joined and fits there, or as a new one."""
    if joined and pieces and word_count(pieces[-1] + joint + text) <= MOST_WORDS:
        pieces[-1] += joint + text
    else:
        pieces.append(joint + text if pieces else text)


def _append_list(pieces, items, joint):
    """Append a list to the sentence above it, as a piece of its own, or in parts."""
    whole = "\n".join(items)
    if word_count(whole) <= MOST_WORDS:
        _append(pieces, whole, joint, joined=True)
    else:
        pieces += [joint + items[0], *("\n" + item for item in items[1:])]


def _hide_blanks(formula):
    return formula[0].replace("\n", JOINT + "n").replace(" ", JOINT + "s")


def _is_list(item):
    return re.match(r"[-*] |\d+\. ", item) is not None
