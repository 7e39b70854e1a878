"""Where the text of a lecture is cut into slides."""

import pytest

from workbook.live.slide_texts import MOST_WORDS, slide_texts, word_count

LONG = "This sentence has a dozen words and says nothing at all here."
FULL = " ".join([LONG] * 3)
QUESTION = "Does the estimate of the speed change?"
OPTIONS = "1. no; 2. only its ellipse gets narrower; 3. only its guess moves; 4. both."
LIST = (
    "- A *real* root passes through $0$.\n- A *pair* passes through $\\pm i\\omega$, two equations."
)


@pytest.mark.parametrize(
    "text, slides",
    [
        (f"# T\n\n{LONG} {LONG}", [f"# T\n\n{LONG} {LONG}"]),
        (f"{FULL} {LONG}", [FULL, LONG]),
        # a short sentence is not left alone
        (f"{FULL} {QUESTION}", [f"{LONG} {LONG}", f"{LONG} {QUESTION}"]),
        # the options of a vote stand below its question
        (f"{FULL} {QUESTION}\n\n{OPTIONS}", [FULL, f"{QUESTION}\n\n{OPTIONS}"]),
        # a list stays together, with the sentence above it
        (f"{FULL} Two ways:\n\n{LIST}", [FULL, f"Two ways:\n\n{LIST}"]),
        (f"{FULL} Two ways:\n{LIST}", [FULL, f"Two ways:\n{LIST}"]),
        # a sentence goes on below its formula
        (
            f"{FULL} Its least value\n\n$$\na + b\n$$\n\nis the smallest change after which it is "
            "lost.",
            [
                FULL,
                "Its least value\n\n$$\na + b\n$$\n\nis the smallest change after which it is lost.",
            ],
        ),
        # a list that fills a slide is cut between its items
        (
            "\n".join(f"- {LONG} {LONG}" for _ in range(3)),
            [f"- {LONG} {LONG}", f"- {LONG} {LONG}", f"- {LONG} {LONG}"],
        ),
    ],
)
def test_slides_keep_together_what_belongs_together(text, slides):
    assert slide_texts(text) == slides
    assert all(word_count(slide) <= MOST_WORDS for slide in slides)
