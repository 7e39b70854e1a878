"""Formulas in answers, hints and sentences on mistakes stand between dollars."""

import ast
import re
from pathlib import Path

import pytest

from trajlib.typesetting import plain
from workbook.authoring import master_paths
from workbook.authoring.front_matter import read_front_matter
from workbook.authoring.mistakes import mistake_sentence

pytestmark = pytest.mark.slow
MASTERS = master_paths(Path(__file__).resolve().parents[2] / "solutions")
#: What is set between dollars, code between backticks, a reference, an answer of no items; not
#: mathematics as typed.
SET = re.compile(r"\$[^$]*\$|`[^`]*`")
GREEK = "alpha|beta|gamma|delta|epsilon|lambda|mu|nu|xi|eta|psi|varphi|phi|omega|Omega|rho|sigma|tau|theta|kappa|pi"
TYPED = re.compile(
    rf"[\^*<>=$\\]|_\w|\b[A-Za-z]'(?!s\b)|\b[A-Za-z]\d|\b({GREEK})\b|\b(sqrt|exp|sin|cos|det)\("
)

#: What an answer is to be written in: "in $t$, $x_0$ and $T$"; names of code behind it tell what is
#: typed for them.
WRITTEN_IN = re.compile(
    r"(?<!\$ )\bin ((?>(?:(?:\$[^$]+\$|`\w+`)(?:, (?:and )?| and )?)+))(?! ?\(`)"
)


def texts(path):
    front, _ = read_front_matter(path, path.read_text(encoding="utf-8"))
    return [text.partition(":")[2] for text in front["answers"].values()] + sum(
        front["hints"].values(), []
    )


def not_set(sentences):
    """Return sentence -> the first mathematics in it that is typed and not set."""
    return {text: typed[0] for text in sentences if (typed := TYPED.search(SET.sub("", text)))}


def test_formulas_of_the_front_matter_are_typeset():
    found = {path.stem: faults for path in MASTERS if (faults := not_set(texts(path)))}
    assert not found, "put formulas between dollars, code between backticks"


def test_formulas_of_mistakes_are_typeset(masters):
    found = {}
    for master in masters:
        wrong = master.trials["wrong"]
        found |= {
            (master.path.stem, text): typed
            for text, typed in not_set(
                trial.comment for trial in wrong if mistake_sentence(master, trial)
            ).items()
        }
    assert not found, "put formulas between dollars, code between backticks"


def test_formulas_have_a_plain_form(masters):
    for master in masters:
        wrong = master.trials["wrong"]
        for text in [*texts(master.path), *(trial.comment for trial in wrong)]:
            left = re.search(r"[$\\`]|\b([dt]?frac(?![a-z])\w*|[lr]vert|mathrm)\b", plain(text))
            assert not left, (master.path.stem, text)


def test_variables_of_an_answer_have_their_names_in_code(masters):
    """A stub that asks for an answer in x0 has a symbol x0, and not x_0."""
    for master in masters:
        path = master.path
        nodes = [node for cell in master.code("data") for node in ast.walk(ast.parse(cell))]
        names = {node.id for node in nodes if isinstance(node, ast.Name)}
        front, _ = read_front_matter(path, path.read_text(encoding="utf-8"))
        variables = {
            plain(word)
            for text in front["answers"].values()
            for listed in WRITTEN_IN.findall(text)
            for word in re.findall(r"\$[^$]+\$|`\w+`", listed)
        }
        unknown = (
            {word for word in variables if word.isidentifier()} - names - set(front["answers"])
        )
        assert not unknown, path.stem


@pytest.mark.parametrize(
    "typed, found",
    [
        ("det(M s^2 + D s + K)", "^"),
        ("x1 and x2", "x1"),
        ("the rate x'", "x'"),
        ("2*k", "*"),
        ("psi_1", "_1"),
        ("all real beta", "beta"),
        ("for b > 0", ">"),
    ],
)
def test_plain_formulas_are_recognised(typed, found):
    assert TYPED.search(typed)[0].strip() in (found, typed.split("(")[0] + "(")


@pytest.mark.parametrize(
    "formula, typed",
    [
        (r"$\dot x_1 = -k_1 x_1$", "x1' = -k1 x1"),
        (r"$\ddot\psi$ and $\lambda^{-k}$", "psi'' and lambda^-k"),
        (r"$\exp(-\lambda_0 t) \leq 1/\sqrt{2}$", "exp(-lambda0 t) <= 1/sqrt(2)"),
        (r"$x^\top G x$, $x^*$", "x^T G x, x*"),
        (r"$u = \bar u$ for $\varepsilon \to \infty$", "u = ubar for epsilon -> oo"),
        (
            r"$\frac12u^2 \leq \frac{\cos y}{1 - \cos y}$, $\frac{\beta}{2}$",
            "1/2u^2 <= (cos y)/(1 - cos y), beta/2",
        ),
        (
            r"$\lvert y\rvert \le 1$, $\psi \equiv 0$, $a = \pm1$, $\sin\beta/\rho$, $\dot\psi$",
            "|y| <= 1, psi == 0, a = +-1, sin beta/rho, psi'",
        ),
        (r"in $\varrho_T$ and $\bar\omega$", "in rho_T and omegabar"),
        ("the basis of `a_unobservable_states`", "the basis of a_unobservable_states"),
    ],
)
def test_plain_form_of_formulas(formula, typed):
    assert plain(formula) == typed
