"""Sealed sentences open with the wrong answer only."""

import base64

from workbook.mistakes.sealing import find, seal

SENTENCE = "Is this what comes out if friction is forgotten?\nHint 1: Write the second law down."


def test_the_wrong_answer_opens_the_sentence():
    sealed = dict([seal(SENTENCE, "1.15 a_region", b"mine")])
    assert find(sealed, "1.15 a_region", [b"other", b"mine"]) == SENTENCE
    assert (
        find(sealed, "1.15 a_region", [b"other"]) == find(sealed, "1.15 b_region", [b"mine"]) == ""
    )
    assert find(sealed, "1.16 a_region", [b"mine"]) == ""


def test_answers_and_sentences_are_not_readable():
    ((name, text),) = sealed = [seal(SENTENCE, "1.15 a_region", b"mine")]
    for shown in (name.encode(), text.encode(), base64.b64decode(text)):
        assert not any(word in shown for word in (b"mine", b"friction", b"Hint", b"Is this"))
    assert (
        sealed[0]
        != seal(SENTENCE, "1.15 b_region", b"mine")
        != seal(SENTENCE, "1.16 b_region", b"mine")
    )
    assert seal(SENTENCE, "1.15 a_region", b"mine") == sealed[0]


def test_equal_sentences_are_sealed_differently():
    (_, one), (_, other) = (
        seal(SENTENCE, "1.15 a_region", b"mine"),
        seal(SENTENCE, "1.15 a_region", b"yours"),
    )
    assert base64.b64decode(one)[:4] != base64.b64decode(other)[:4]
