"""Every theorem of the theory pages names its hypotheses and has a cell at the edge of one."""

import re
import tomllib
from pathlib import Path

BOOK = Path(__file__).resolve().parents[2] / "book"
HYPOTHESES = tomllib.loads((BOOK / "hypotheses.toml").read_text(encoding="utf-8"))
PAGES = {
    path: path.read_text(encoding="utf-8")
    for folder in (*BOOK.glob("ch[0-9]"), BOOK / "errata")
    for path in sorted(folder.glob("*.md"))
}
THEOREM = re.compile(
    r"^`{3,}\{prf:(?:theorem|lemma|proposition|corollary)\}.*\n:label: (\S+)$", re.M
)
STATED = {label for text in PAGES.values() for label in THEOREM.findall(text)}
TARGET = re.compile(r"^\(([\w-]+)\)=\n", re.M)
#: A comment of a cell begins with one number sign, like the title of a page, but a section with two.
END = re.compile(r"^\([\w-]+\)=$|^##+ |^`{3,}\{prf:", re.M)
REASONS = "not needed: ", "gives meaning: ", "not decided: "


def passages(text):
    """Return label -> what follows it, up to the next label or heading."""
    return {
        target[1]: END.split(re.sub(r"^#.*\n", "", text[target.end() :]), maxsplit=1)[0]
        for target in TARGET.finditer(text)
    }


PASSAGES = {label: passage for text in PAGES.values() for label, passage in passages(text).items()}


def cells(theorem):
    """The labels that the hypotheses of a theorem name."""
    values = (re.sub(f"^(?:{'|'.join(REASONS)})", "", v) for v in HYPOTHESES[theorem].values())
    return [value for value in values if " " not in value]


def test_every_theorem_is_listed():
    assert len(STATED) > 50
    assert HYPOTHESES.keys() == STATED


def test_a_theorem_has_a_cell_at_the_edge_of_a_hypothesis():
    named = {theorem: cells(theorem) for theorem in HYPOTHESES}
    assert [theorem for theorem, labels in named.items() if not labels] == []
    assert [
        label for label in sum(named.values(), []) if "```{code-cell}" not in PASSAGES[label]
    ] == []


def test_a_hypothesis_has_a_counterexample_or_a_reason():
    assert [
        f"{theorem}: {hypothesis}"
        for theorem, hypotheses in HYPOTHESES.items()
        for hypothesis, value in hypotheses.items()
        if " " in value and not re.match(rf"(?:{'|'.join(REASONS)}).{{6}}", value)
    ] == []


def test_every_passage_at_an_edge_is_named():
    named = {label for theorem in HYPOTHESES for label in cells(theorem)}
    assert {label for label in PASSAGES if label.startswith("edge-")} <= named
