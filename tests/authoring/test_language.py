"""Pages, messages and docstrings use the standard terms of the field, which the glossary lists."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
TEXTS = sorted(
    path
    for pattern in (
        "book/**/*.md",
        "solutions/ch*/p*.md",
        "solutions/ch*/p*.py",
        "workbook/**/*.py",
        "trajlib/**/*.py",
        "tests/checks/cases/**/*.py",
        "README.md",
    )
    for path in ROOT.glob(pattern)
)
#: A private phrase, and the row of the glossary with the term that stands for it. The phrases are
#: regular expressions; a space also matches a line break inside a comment.
PHRASES = {
    r"programme (motion|trajector(y|ie))s?": "nominal trajectory, desired motion",
    r"programme controls?": "nominal control, desired control",
    r"unseen (initial |real )?(states?|lines?|parts?|motions?|eigenvectors?|equilibria)": "unobservable motion",
    r"equations? in (the )?deviations?": "deviation equation",
    r"(position|place|point|state)s? of rest": "equilibrium, position of equilibrium",
    r"first approximation": "linearisation",
    r"equations? in variations": "variational equation",
    r"dispersion equations?": "covariance equation",
    r"criteri(on|a) of popov|popov's criteri(on|a)": "PBH test",
    r"kalman's criteri(on|a)": "Kalman rank test",
    r"cauchy(–| and |-)bunyakovsky": "Cauchy–Schwarz inequality",
    r"lost (eigenvalue|eigenvector|mode|motion|direction)s?": "uncontrollable (unobservable) eigenvalue",
    r"unseen (motion|mode|state|direction|subspace)s?": "unobservable motion",
    r"canonical form by (control|observation)": "controllable canonical form",
    r"(theorem|test|condition|polynomial|criterion|transversality) is silent": "critical case",
    r"(lives?|living) alone": "decoupled systems",
    r"(systems?|sticks?|equations?) (falls?|fall) apart": "decoupled systems",
    r"remembers? (itself|its past)": "coloured noise",
    r"(time|moment) of turning": "switching time",
    r"out of reach": "uncontrollable (unobservable) eigenvalue",
    r"rest points?": "equilibrium, position of equilibrium",
}
#: What may stand before "of" and a name, and names that are no persons.
KINDS = (
    r"(criteri(?:on|a)|theorem|lemma|tests?|method|equations?|functions?|filters?|conditions?|"
    r"formulas?|identity|inequality|phenomenon|bifurcation|rule|principle|observer|synthesis)"
)
EPONYM = re.compile(
    rf"\b{KINDS}\s+(?:#\s+)?of\s+(?:#\s+)?"
    r"(?!Theorem|Problem|Example|Definition|Section|Chapter|Greek|Python|Canvas|Moodle|Num|Sym|Sci|"
    r"Cas|Phi|Psi|Unicode|Matplotlib|Dask|La[tT])"
    r"[A-ZŁ][a-zéł]{2,}(?!['’]s)(?![\w'’])"
)
EXPECTATION = re.compile(
    r"(?<![A-Za-z\\_])M(?:\\[bB]ig)?\[\\?(?:mathring|int|\d?x|\d?u|q|r|e\b|z|\\Delta)"
)


def private(phrase):
    return re.compile(rf"\b(?:{phrase})\b".replace(" ", r"\s+(?:#:?\s+)?"), re.IGNORECASE)


#: Phrases for which any plain sentence is better.
ODD = (
    r"filters? believes?|are to each other as|back into step|whoever (is|has|wants|takes|knows|begins|starts)",
    r"at (every|each|any|a single|the first|the same) moment|believe it:",
    r"(knows?|know) nothing of|(lives?|living) by (itself|themselves)|goes its own way",
    r"(conditions?|laws?|criteri(on|a)|ranks?|determinant|matrix|filters?|observers?|equations?) "
    r"(asks?|tells?|wants?|knows?|demands?|believes?|forgets?)",
    r"no say in|equally dear|deaf to|blind for|live[sd]? apart|at one blow|gives? to nobody",
    r"eigenrows?|forms? of cauchy|gets? its sign turned|has this matrix an inverse",
    r"a observab(le|ility) (canonical|form|decomposition)",
    r"surfaces? of singular control|settled (filter|state)s?|too dear|dearer by|a unit of way",
    r"which signs? ha(s|ve)|(can|could) be had|ha(s|ve) no mean|at which rates?",
    r"costs? stands? (at|in|only)|stands? in \$H|with a dash for|way of the (ship|point|body)",
)
PRIVATE = [private(phrase) for phrase in (*PHRASES, *ODD)]


def private_phrases(text, _=""):
    """Yield (position, phrase) of all that is no standard term."""
    for pattern in (*PRIVATE, EPONYM, EXPECTATION):
        for match in pattern.finditer(text):
            yield match.start(), " ".join(match[0].split())


def test_texts_use_standard_terms(lint):
    assert len(TEXTS) > 1000
    assert lint(private_phrases, TEXTS) == []


def test_the_glossary_lists_the_standard_terms():
    glossary = (ROOT / "book" / "glossary.md").read_text(encoding="utf-8")
    terms = re.findall(r"^\| ([^|]+?) \| [^|]*[а-я]", glossary, re.M)
    assert set(PHRASES.values()) <= set(terms)
    assert terms == sorted(terms, key=lambda term: term.replace("–", "-").casefold())


@pytest.mark.parametrize(
    "text, phrases",
    [
        ("the equations in\ndeviations", ["equations in deviations"]),
        ("# the first\n    # approximation", ["first # approximation"]),
        ("by the criterion of Hurwitz", ["criterion of Hurwitz"]),
        ("the theorem of Cayley and Hamilton", ["theorem of Cayley"]),
        ("the method of Euler's time", []),
        ("the conditions of Theorem 1.4", []),
        ("where $M[q_i] = 0$", ["M[q"]),
        ("the system falls apart; whoever knows $x$", ["system falls apart", "whoever knows"]),
        ("The condition asks for more at every moment.", ["at every moment", "condition asks"]),
        ("The costate knows nothing of the\n# start.", ["knows nothing of"]),
        ("Which sign has the root? Any\n# margin can be had.", ["Which sign has", "can be had"]),
        ("the rate at which it decays; the question has no meaning", []),
        ("The cost stands at the end.\nIt is too dear.", ["too dear", "cost stands at"]),
        (
            "What stands in $H$ on the surface of\nsingular control?",
            ["surface of singular control", "stands in $H"],
        ),
        ("the first moment of $x$; a moment of force; the condition is open", []),
        ("The other terms had no\nsay in it; an eigenrow", ["no say in", "eigenrow"]),
        (
            "They are not equally dear.\nHas this matrix an inverse?",
            ["equally dear", "Has this matrix an inverse"],
        ),
        (
            "a observable canonical form by the form of Cauchy",
            ["form of Cauchy", "a observable canonical"],
        ),
        ("the system lives in the plane; an observable canonical form", []),
        ("the Hurwitz criterion; $E[q_i] = 0$; the rest of the proof", []),
    ],
)
def test_private_phrases_are_recognised(text, phrases):
    assert [phrase for _, phrase in private_phrases(text)] == phrases
