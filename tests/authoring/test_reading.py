"""Reading a master validates its contract; errors name file, line and what was expected."""

from contextlib import nullcontext
from pathlib import Path

import pytest

from workbook.authoring import MasterError, read_master
from workbook.authoring.contract import validate_front_matter

ROOT = Path(__file__).resolve().parents[2]
GOOD = (ROOT / "solutions" / "ch1" / "p15.md").read_text(encoding="utf-8")
TRIALS = (ROOT / "solutions" / "ch1" / "p15.trials.py").read_text(encoding="utf-8")


@pytest.fixture
def write_master(tmp_path):
    """Writes 1.15 somewhere else, page and trials; returns where."""

    def write(page=GOOD, trials=TRIALS, name="ch1/p15.md"):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(page, encoding="utf-8")
        path.with_suffix(".trials.py").write_text(trials, encoding="utf-8")
        return path

    return write


def test_a_master_is_read():
    master = read_master(ROOT / "solutions" / "ch1" / "p15.md")
    assert (master.number, master.section, master.level) == ("1.15", "§1.2", "core")
    assert list(master.answers) == ["a_region", "b_region", "c_region", "d_region", "e_region"]
    assert master.answers["a_region"].kind == "condition" and not master.answers["a_region"].exact
    assert master.exercise == ROOT / "exercises" / "ch1" / "p15.ipynb"
    assert len(master.code("check")) == 5 and all(
        "checks.report" in source for source in master.code("check")
    )
    name, source, comment = master.trials["wrong"][0]
    assert name == "a_region" and comment.startswith("Are positive coefficients enough")
    assert source == "a_region = sp.And(k1 > 0, k2 > 0)"


def test_the_core_of_a_problem(write_master):
    assert read_master(write_master(GOOD)).core == ()
    assert read_master(
        write_master(GOOD.replace("level: core", "level: core\n  core: [a, d]"))
    ).core == (
        "a",
        "d",
    )


@pytest.mark.parametrize(
    "level, count, core, message",
    [
        ("core", 12, None, ""),
        ("core", 13, None, "advanced at least"),
        ("advanced", 13, None, ""),
        ("advanced", 16, None, "problem.core names the items"),
        ("advanced", 16, ["a"], ""),
    ],
)
def test_a_long_problem_names_its_core(level, count, core, message):
    names = [f"{'abcd'[k % 4]}_{k}" for k in range(count)]
    front = {
        "number": "1.15",
        "title": "t",
        "section": "s",
        "level": level,
        "topics": ["t"],
        "answers": dict.fromkeys(names, "number: n"),
        "hints": {name: ["Why?"] for name in names},
    }
    front |= {"core": core} if core else {}
    expected = pytest.raises(MasterError, match=message) if message else nullcontext()
    with expected:
        validate_front_matter(Path("ch1/p15.md"), front, {(): 1})


def line_of(text, part):
    return text[: text.index(part)].count("\n") + 1


@pytest.mark.parametrize(
    "old, new, message",
    [
        ('number: "1.15"', "number: 1.15", "quoted"),
        ('number: "1.15"', 'number: "1.16"', "ch1/p16.md"),
        ("level: core", "level: easy", "core, advanced, starred"),
        ("level: core", "level: core\n  core: a", "core is a list"),
        ("level: core", "level: core\n  core: [a, z]", "z is none"),
        ("level: core", "level: core\n  core: [a, b, c]", "at most half of its answers"),
        (
            "title: Stability regions in the plane of two parameters",
            "title: [Stability]",
            "title is a text",
        ),
        ("  title: Stability regions in the plane of two parameters\n", "", "title"),
        ('a_region: "condition: the', 'a_region: "kind of set, the', "TYPE"),
        (":tags: [data]", ":tags: [date]", "exactly one role"),
        (":tags: [data]", ":tags: [data, check]", "exactly one role"),
        (":tags: [data]", ":tags: [wrong, skip-execution, remove-cell]", "exactly one role"),
        (
            "b_region = sp.And(k2 > 0, k1 > k2)",
            "pass",
            "assign every answer once; none does so with b_region",
        ),
        (
            "checks.report(b_region=",
            "checks.report(a_region=",
            "report every answer once; a_region stands here and",
        ),
        ("checks.report(b_region=", "checks.report(b_regoin=", "did you mean b_region"),
        ('    b_region: ["The leading', '    z_region: ["The leading', "hints"),
        ('b_region: ["The leading', 'b_region: "The leading" # ["', "a list of texts"),
        ("a_poly = s**3", "a_region = s**3", "a data cell assigns"),
        ("a_poly = s**3", "a_poly = = s**3", "no Python"),
        (
            "checks.stability_region(b_region",
            "checks.stability_regoin(b_region",
            "did you mean stability_region",
        ),
        ("(b_region, b_poly", "(b_region, b_pol", "b_pol is neither .* did you mean b_poly"),
        (
            "{solution-start} ex-1-15",
            "{solution-start} ex-1-15 a",
            "a solution begins with .solution-start. ex-1-15",
        ),
        ("```{solution-start}", "## Item a\n\n```{solution-start}", "one heading, its title"),
    ],
)
def test_a_broken_contract_is_an_error(write_master, old, new, message):
    assert old in GOOD
    with pytest.raises(MasterError, match=message) as raised:
        read_master(write_master(GOOD.replace(old, new, 1)))
    assert "ch1/p15.md:" in str(raised.value) and "\n" not in str(raised.value)


@pytest.mark.parametrize(
    "old, new, message",
    [
        ("  title: Stability", "  title: Regions: stability", "mapping values are not allowed"),
        ("topics: [Hurwitz", "topics: [[Hurwitz", "expected"),
        ("  level: core", "\tlevel: core", "not YAML"),
        ("  level: core", "  level: core\n  level: core", "level stands twice"),
        ("problem:\n", "problems:\n", "needs problem:"),
        ("---\njupytext", "jupytext", "opens with"),
        ("---\njupytext", "---\n\x07jupytext", "not YAML"),
    ],
)
def test_malformed_front_matter_is_an_error_of_one_line(write_master, old, new, message):
    assert old in GOOD
    with pytest.raises(MasterError, match=message) as raised:
        read_master(write_master(GOOD.replace(old, new, 1)))
    assert "ch1/p15.md:" in str(raised.value) and "\n" not in str(raised.value)


DRAWING = """```{code-cell}
:tags: [drawing]
from workbook.display import Drawing

d = Drawing((0, 1), (0, 1))
d
```
"""


@pytest.mark.parametrize(
    "fence, below, message",
    [
        ("```{exercise-end}", "*A sheet.*\n\n", ""),
        ("```{exercise-end}", "*A sheet\nof $x^*$.*\n\nThe text goes on.\n\n", ""),
        ("```{exercise-end}", "", "under a drawing stands its caption"),
        ("```{exercise-end}", "A sheet.\n\n", "under a drawing stands its caption"),
        ("```{exercise-end}", "**A sheet.**\n\n", "under a drawing stands its caption"),
        ("```{solution-end}", "*A sheet.*\n\n", "a drawing belongs to the statement"),
    ],
)
def test_a_drawing_stands_in_the_statement_with_its_caption(write_master, fence, below, message):
    page = GOOD.replace(fence, DRAWING + below + fence, 1)
    if message:
        with pytest.raises(
            MasterError,
            match=rf"p15\.md:{line_of(page, 'from workbook.display import Drawing')}: {message}",
        ):
            read_master(write_master(page))
    else:
        assert len(read_master(write_master(page)).code("drawing")) == 1


@pytest.mark.parametrize(
    "old, new, expected",
    [
        ("  level: core", "  level: easy", "  level"),
        ("  title: Stability", "  title: Regions: stability", "  title"),
        ("  level: core\n", "  level: core\n  level: starred\n", "  level: starred"),
        ('    b_region: "condition', '    b_region: "cond', "    b_region"),
        (
            "checks.stability_region(b_region",
            "checks.stability_regoin(b_region",
            "checks.report(b_region",
        ),
        ("b_poly = s**3", "b_poly = = s**3", "b_poly = ="),
    ],
)
def test_errors_name_the_line(write_master, old, new, expected):
    page = GOOD.replace(old, new, 1)
    with pytest.raises(MasterError, match=rf"p15\.md:{line_of(page, expected)}: "):
        read_master(write_master(page))


def test_page_and_trials_are_required(write_master):
    path = write_master()
    assert read_master(path).trials == read_master(ROOT / "solutions" / "ch1" / "p15.md").trials
    path.with_suffix(".trials.py").unlink()
    with pytest.raises(MasterError, match=r"p15\.trials\.py:1: "):
        read_master(path)
    with pytest.raises(MasterError, match=r"p16\.md:1: "):
        read_master(path.with_name("p16.md"))
