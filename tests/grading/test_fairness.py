"""What students do to notebooks in good faith costs them nothing, and what is not their fault is
never laid to them."""

import copy
import json
import multiprocessing
import os
import sys
import time
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import RIGHT_1_15, notebook

from workbook.grading import submissions
from workbook.grading.grader import Bench, _lacking
from workbook.grading.preloading import ALWAYS
from workbook.grading.sandbox import Limits
from workbook.notebooks import exercises

EXERCISE = exercises.find("1.15")
NAMES = list(EXERCISE.about["answers"])


@pytest.fixture(scope="module")
def bench():
    with Bench(Limits(cpu_seconds=20, wall_seconds=200)) as ready:
        yield ready


def code(source, **metadata):
    return {
        "cell_type": "code",
        "metadata": metadata,
        "source": source,
        "outputs": [],
        "execution_count": None,
    }


def answered():
    """The notebook as handed out, rightly answered: cells by role in a dict, and the notebook."""
    return notebook("1.15", RIGHT_1_15)


def by_tag(given, tag):
    return [cell for cell in given["cells"] if cell["metadata"].get("tags") == [tag]]


def graded(bench, given, folder, name="ch1-p15.ipynb"):
    """Judgement on a notebook, by way of a file as it is submitted; `given` may be bytes."""
    path = folder / "submitted" / "ada" / "hw" / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(given if isinstance(given, bytes) else json.dumps(given).encode())
    (found,) = submissions.find(folder / "submitted")
    assert found.trouble == "" and found.problem == "1.15"
    return bench.grade({"problem": "1.15", "sources": EXERCISE.sources_to_run(found.cells)})


def full_marks(result):
    return {
        name: verdict["status"] for name, verdict in result["verdicts"].items()
    } == dict.fromkeys(NAMES, "right")


# Each of these gives a changed notebook; all of them keep full marks.


def as_handed_out(given):
    pass


def check_cells_deleted(given):
    given["cells"] = [cell for cell in given["cells"] if cell not in by_tag(given, "check")]


def data_cell_deleted(given):
    given["cells"] = [cell for cell in given["cells"] if cell not in by_tag(given, "data")]


def data_cell_at_the_end(given):
    (data,) = by_tag(given, "data")
    given["cells"].remove(data)
    given["cells"].append(data)


def cells_in_reverse_order(given):
    given["cells"].reverse()


def helper_below_its_use(given):
    answers = by_tag(given, "answer")
    answers[0]["source"] = "a_region = both(k1 > 0, product)"
    answers[1]["source"] += "\nproduct = last_but_one > 1"
    given["cells"] += [
        code("def both(*parts): return sp.And(*parts)"),
        code("last_but_one = k1*k2"),
    ]
    given["cells"].append(given["cells"].pop(given["cells"].index(answers[1])))


def all_cells_doubled(given):
    given["cells"] = [twin for cell in given["cells"] for twin in (cell, copy.deepcopy(cell))]


def untouched_copy_below(given):
    given["cells"] += [code(stub) for _, stub in EXERCISE.code("answer")]


def untouched_copy_above(given):
    given["cells"][:0] = [code(stub) for _, stub in EXERCISE.code("answer")]


def everything_in_one_cell(given):
    given["cells"] = [code("\n".join(f"{name} = {text}" for name, text in RIGHT_1_15.items()))]


def answers_split_over_cells(given):
    cell = by_tag(given, "answer")[0]
    place = given["cells"].index(cell)
    given["cells"][place : place + 1] = [
        code("first = k1 > 0"),
        code("second = k1*k2 > 1"),
        code("a_region = sp.And(first, second)"),
    ]


def typed_into_check_cells(given):
    for cell, (name, text) in zip(by_tag(given, "check"), RIGHT_1_15.items()):
        cell["source"] = f"{name} = {text}\n" + "".join(cell["source"])
    for cell in by_tag(given, "answer"):
        given["cells"].remove(cell)


def check_cell_reformatted_and_failing(given):
    for cell in by_tag(given, "check"):
        cell["source"] = "print('checking')\n" + "".join(cell["source"]).replace(
            "checks.report", "checks.reprot"
        )


def tags_and_metadata_lost(given):
    given["metadata"] = {}
    for cell in given["cells"]:
        cell["metadata"] = {}


def sources_as_lists_and_windows_lines(given):
    for cell in given["cells"]:
        cell["source"] = "".join(cell["source"]).replace("\n", "\r\n").splitlines(keepends=True)


def saved_by_another_editor(given):
    given.update(nbformat=4, nbformat_minor=2)
    for _k, cell in enumerate(given["cells"]):
        cell.pop("id", None)
        cell["metadata"] = {"collapsed": False, "scrolled": True, "trusted": "x"}
    given["metadata"]["kernelspec"] = {"name": "sagemath", "language": "sage"}


def huge_outputs(given):
    for cell in by_tag(given, "answer"):
        cell["outputs"] = [
            {"output_type": "display_data", "data": {"image/png": "A" * 10**6}, "metadata": {}}
        ]


def last_value_by_its_underscore(given):
    cell = by_tag(given, "answer")[0]
    place = given["cells"].index(cell)
    given["cells"][place : place + 1] = [code("sp.And(k1 > 0, k1*k2 > 1)"), code("a_region = _")]


def module_written_by_a_cell(given):
    cell = by_tag(given, "answer")[0]
    given["cells"].insert(
        given["cells"].index(cell), code("%%writefile mine.py\ndef both(p, q): return p & q")
    )
    cell["source"] = "from mine import both\na_region = both(k1 > 0, k1*k2 > 1)"


def first(source):
    """A change: one more cell on top."""

    def change(given):
        given["cells"].insert(0, code(source))

    change.__name__ = "first_" + source
    return change


def in_the_answer_cell(source):
    """A change: lines above the answer, in its own cell."""

    def change(given):
        cell = by_tag(given, "answer")[0]
        cell["source"] = source + "\n" + "".join(cell["source"])

    change.__name__ = "above_" + source
    return change


CHANGES = [
    as_handed_out,
    check_cells_deleted,
    data_cell_deleted,
    data_cell_at_the_end,
    cells_in_reverse_order,
    helper_below_its_use,
    all_cells_doubled,
    untouched_copy_below,
    untouched_copy_above,
    everything_in_one_cell,
    answers_split_over_cells,
    typed_into_check_cells,
    check_cell_reformatted_and_failing,
    tags_and_metadata_lost,
    sources_as_lists_and_windows_lines,
    saved_by_another_editor,
    huge_outputs,
    last_value_by_its_underscore,
    module_written_by_a_cell,
    *map(
        in_the_answer_cell,
        (
            "%matplotlib inline",
            "%matplotlib widget",
            "%matplotlib notebook",
            "%pylab inline",
            "!ls",
            "files = !ls /",
            "!nonsense",
            "!pip install nothing",
            "%pip install nothing",
            "%config InlineBackend.figure_format = 'svg'",
            "%load_ext autoreload\n%autoreload 2",
            "import warnings\nwarnings.warn('!' * 99)",
            "import sys\nprint('trouble', file=sys.stderr)\nsys.stderr.flush()",
            "import logging\nlogging.error('trouble')",
            "print('x' * 10**6)",
            "import matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.show()",
            "from IPython.display import display, Markdown\ndisplay(Markdown('x'), k1)",
            "sp.init_printing()",
            "import asyncio\nawait asyncio.sleep(0)",
            "?sp.And",
            "import numpy as np\nnp.float64(1) / 0",
            "k1\nk2;",
            "from trajlib.stability import *",
            "from concurrent.futures import "
            "ThreadPoolExecutor\nlist(ThreadPoolExecutor(8).map(abs, range(99)))",
            "import multiprocessing\nwith multiprocessing.Pool(4) as pool: pool.map(abs, "
            "range(99))",
            "import subprocess\nsubprocess.run(['ls'], check=True)",
            "import subprocess, sys\nsubprocess.run(['ls'], stdout=sys.stdout, check=True)",
            "import sys\nsys.stdout.encoding.upper()",
            "import tempfile\ntempfile.NamedTemporaryFile().write(b'x' * 10**6)",
            "open('notes.txt', 'w').write('x')\nopen('notes.txt').read()",
        ),
    ),
    in_the_answer_cell("%%time\nx = 1"),
    *map(
        first,
        (
            "1/0",
            "import nothing",
            "syntax error",
            "input('How are you?')",
            "exit()",
            "import sys\nsys.exit(1)",
            "raise KeyboardInterrupt",
            "%%bash\nls",
            "%nomagic",
            "%%html\n<b>x</b>",
            "import os\nos.chdir('/usr')",
            "x = bytearray(10**11)",
            "def f(): return f()\nf()",
            "from google.colab import drive",
            "a_region = None",
            "del a_region",
            "%reset -f",
            "import signal\nsignal.alarm(0)",
            "import matplotlib\nmatplotlib.use('TkAgg')\nimport matplotlib.pyplot as "
            "plt\nplt.figure()",
        ),
    ),
]


@pytest.mark.parametrize(
    "change", CHANGES, ids=lambda change: change.__name__.replace("\n", "; ")[:60]
)
def test_costs_nothing(bench, tmp_path, change):
    given = answered()
    change(given)
    result = graded(bench, given, tmp_path)
    assert full_marks(result), result
    assert all(remark.startswith("notebook: ") for remark in result["remarks"])


@pytest.mark.parametrize(
    "name", ["1.15.ipynb", "ch1-p15 (copy 2).ipynb", "1_15-final.ipynb", "ch1-p15.IPYNB"]
)
def test_names_cost_nothing(bench, tmp_path, name):
    given = answered()
    tags_and_metadata_lost(given)
    assert full_marks(graded(bench, given, tmp_path, name))


def test_a_byte_order_mark_costs_nothing(bench, tmp_path):
    assert full_marks(graded(bench, b"\xef\xbb\xbf" + json.dumps(answered()).encode(), tmp_path))


FORMS = {
    "a list of conditions": "[k1 > 0, k1*k2 > 1]",
    "turned round": "sp.And(0 < k1, 1 < k1*k2)",
    "another formula": "sp.And(k1 > 0, k2 > 1/k1)",
    "symbols without assumptions": "(lambda p, q: sp.And(p > 0, p*q > 1))(*sp.symbols('k1 k2'))",
    "redundant": "sp.And(k1 > 0, k2 > 0, k1*k2 - 1 > 0, k1 + k2 > 0)",
    "decimals": "sp.And(k1 > 0.0, k1*k2 > 1.0)",
    "negated": "sp.Not(sp.Or(k1 <= 0, k1*k2 <= 1))",
    "computed by the library": "__import__('trajlib.stability', fromlist=['*']).stability_conditions(a_poly, [k1, "
    "k2], symbol=s).region",
}


@pytest.mark.parametrize("form", FORMS)
def test_other_forms_cost_nothing(bench, tmp_path, form):
    result = graded(bench, notebook("1.15", RIGHT_1_15 | {"a_region": FORMS[form]}), tmp_path)
    assert full_marks(result), result["verdicts"]["a_region"]


def test_one_bad_answer_costs_itself(bench, tmp_path):
    result = graded(
        bench, notebook("1.15", RIGHT_1_15 | {"b_region": "1/0", "c_region": "object()"}), tmp_path
    )
    assert {name: verdict["status"] for name, verdict in result["verdicts"].items()} == {
        "a_region": "right",
        "b_region": "missing",
        "c_region": "invalid",
        "d_region": "right",
        "e_region": "right",
    }
    assert result["remarks"] == ("notebook: code cell 5: ZeroDivisionError: division by zero",), (
        "numbered as in the notebook"
    )


def test_a_verdict_in_the_sandbox_is_no_error(bench, tmp_path):
    """A check cell that was changed runs with the notebook; that its answers are not right yet is
    said once, by the judge."""
    given = notebook("1.15", {"a_region": "k1 > 0"})
    for cell in by_tag(given, "check"):
        cell["source"] = "".join(cell["source"]) + "  # mine"
    assert graded(bench, given, tmp_path)["remarks"] == ()


def test_a_later_answer_counts(bench, tmp_path):
    """The last assignment that is no stub."""
    given = notebook("1.15", RIGHT_1_15 | {"a_region": "k1 > 5"})
    given["cells"] += [code(f"a_region = {RIGHT_1_15['a_region']}"), code("a_region = ...")]
    assert full_marks(graded(bench, given, tmp_path))


def _keep_busy():
    # Linux may share processors among sessions first: one for all would leave the notebook half of
    # them
    os.setsid()
    give_up = time.monotonic() + 60
    while time.monotonic() < give_up:
        pass


def test_a_slow_machine_costs_nothing(tmp_path):
    """Time is what the notebook computes, not what the clock says while others keep the machine
    busy."""
    seconds = 2.0
    given = answered()
    # A cell may take half of the time that is left.
    in_the_answer_cell(f"import time\nwhile time.process_time() < {0.3 * seconds}: pass")(given)
    others = [
        multiprocessing.get_context("fork").Process(target=_keep_busy, daemon=True)
        for _ in range(6)
    ]
    with Bench(Limits(cpu_seconds=seconds, wall_seconds=60), modules=ALWAYS) as bench:
        for other in others:
            other.start()
        try:
            began = time.monotonic()
            result = graded(bench, given, tmp_path)
        finally:
            for other in others:
                other.kill()
                other.join(timeout=30)
    assert full_marks(result), result
    assert time.monotonic() - began > 0.5 * seconds


def test_data_cells_run_once_where_they_stand_first_and_ahead_of_all_else_where_not():
    (data,) = [source for _, source in EXERCISE.code("data")]
    handed_out = [source for _, source in EXERCISE.cells]
    assert handed_out[0] != data, "a cell that says how to get the library stands first"
    for begins_with_them in (
        handed_out,
        handed_out[:2],
        [data, "a_region = k1 > 0"],
        [data + "\n"],
        [data, data],
    ):
        assert _lacking(EXERCISE, begins_with_them) == []
    for lacks in (
        [],
        ["a_region = k1 > 0"],
        ["a_region = k1 > 0", data],
        [data + "\nk1 = 1", ""],
        [f"import os\n{data}"],
        ["pass", data],
        handed_out[:1],
    ):
        assert _lacking(EXERCISE, lacks) == [data.strip()]
