"""Rewriting of typed text: what is changed, what never is, and the time that it takes."""

import re
import time
import unicodedata

import pytest

from workbook.checks.contract.typed_code import SIGNS, read_typed, similar_name

READ = {
    "a = x₁² ≤ 3": "a = x1**2 <= 3",
    "a = x⁻¹·2": "a = x**-1*2",
    "a = 2·π ≥ x": "a = 2*sp.pi >= x",
    "a = √2·x + √(x²+1) − √x₁": "a = sp.sqrt(2)*x + sp.sqrt(x**2+1) - sp.sqrt(x1)",
    "a = “unstable”": 'a = "unstable"',
    "a = x²³ + ∞": "a = x**23 + sp.oo",
    "a\u00a0= （x，y）": "a = (x,y)",
    "a = $k_{12}^2 > 0$": "a = k12**2 > 0",
    "a\u200b = 3": "a = 3",
    "# ≥ “\na = 'k₁ ≥ 0', x²  # x²": "# ≥ “\na = 'k₁ ≥ 0', x**2  # x²",
    'a = """\n≥ \' ²""", x ≥ 0': 'a = """\n≥ \' ²""", x >= 0',
}
UNCHANGED = [
    *("a = 'k₁ ≥ 0'  # x²", "к1 = 3", "π = 3", "a = k1·k2", "a = x\n"),  # is Python
    *("a = sp.sin²(x)", "a = √x²", "a = x²y", "a = (≥", "a = f(x", "%matplotlib inline", "a = ∫x"),
    "$\\alpha$",
    "\0 ≥",
    "a = \ud800 ≥",
]


@pytest.mark.parametrize("typed", READ)
def test_what_python_cannot_read_is_read_as_it_was_meant(typed):
    assert read_typed(typed) == READ[typed]
    assert read_typed(READ[typed]) == READ[typed]


@pytest.mark.parametrize("typed", UNCHANGED)
def test_python_and_what_cannot_be_read_stay_as_they_are(typed):
    assert read_typed(typed) == typed


#: What a sign is read as, by words of its name in Unicode; full-width forms are their ASCII forms.
MEANINGS = {
    r"LESS-THAN": "<=",
    r"GREATER-THAN": ">=",
    r"MINUS|DASH": "-",
    r"DOT|BULLET|ASTERISK|MULTIPLICATION": "*",
    r"DIVISION|SLASH": "/",
    r"DOUBLE .*QUOTATION": '"',
    r"SINGLE .*QUOTATION": "'",
    r"^(NO-BREAK|EN|EM|THIN|NARROW NO-BREAK) SPACE": " ",
    r"ZERO WIDTH|WORD JOINER": "",
    r"INFINITY": "sp.oo",
}


def meaning(sign):
    if "FULLWIDTH" in unicodedata.name(sign):
        return unicodedata.normalize("NFKC", sign)
    (code,) = {code for words, code in MEANINGS.items() if re.search(words, unicodedata.name(sign))}
    return code


def test_each_sign_has_the_meaning_of_its_name_in_unicode():
    assert len(SIGNS) > 120
    assert {sign: code for sign, code in SIGNS.items() if meaning(sign) != code} == {}


def test_no_sign_is_python():
    for sign in SIGNS:
        with pytest.raises(SyntaxError):
            compile(f"a = [x, 1{sign}2]" if sign not in "\u200b" else f"a{sign}", "", "exec")


@pytest.mark.parametrize(
    "pattern",
    *[
        [
            "²{}x",
            "² {}(",
            "⁻²{}",
            "√{}",
            "√x{}",
            "'\"\\{}",
            '"""{}',
            "k₁{}",
            "$a_1{}",
            '"\\{}',
            "({}²",
        ]
    ],
)
def test_the_time_grows_with_the_length_and_no_faster(pattern):
    def seconds(length):
        body = pattern.partition("{}")[0] or pattern[0]
        text = pattern.format(body * length)
        began = time.process_time()
        read_typed(text)
        return time.process_time() - began

    # a square would be 64 times the time
    assert seconds(80_000) < 25 * max(min(seconds(10_000) for _ in range(3)), 2e-3)


@pytest.mark.parametrize(
    "typed, names, meant",
    [
        ("a_regoin", ["a_region", "b_region"], "a_region"),
        ("a_rgion", ["a_region", "b_region"], "a_region"),
        ("b_region", ["a_region", "c_region"], ""),  # one letter, of two names
        ("region", ["a_region"], "a_region"),
        ("region", ["a_region", "b_region"], ""),
        ("A_Region", ["a_region"], "a_region"),
        ("k_1", ["k1", "k2"], "k1"),
        ("к1", ["k1", "k2"], "k1"),
        ("k3", ["k1", "k2"], ""),
        ("a_gain1", ["a_gain2"], ""),
        ("xx", ["x"], ""),
    ],
)
def test_a_similar_name_is_found_where_there_is_one(typed, names, meant):
    assert similar_name(typed, names) == meant
