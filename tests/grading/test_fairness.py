"""Edits in good faith cost nothing, and students are not blamed for others' faults."""

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

from workbook.grading.course import submissions
from workbook.grading.pool.grader import Grader, Task, _missing_data_cells
from workbook.grading.sandbox.limits import Limits
from workbook.grading.sandbox.preloading import ALWAYS
from workbook.grading.sandbox.sandbox import Sandbox
from workbook.notebooks import exercises

EXERCISE = exercises.find("1.15")
NAMES = list(EXERCISE.about["answers"])


@pytest.fixture(scope="module")
def grader():
    with Grader(Sandbox(Limits(cpu_seconds=20, wall_seconds=200))) as ready:
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
    """Return the notebook as handed out with right answers."""
    return notebook("1.15", RIGHT_1_15)


def by_tag(nb, tag):
    return [cell for cell in nb["cells"] if cell["metadata"].get("tags") == [tag]]


def graded(grader, nb, folder, name="ch1-p15.ipynb"):
    """Return the judgement on a notebook, read from a file as it is submitted.

    `nb` may be bytes.
    """
    path = folder / "submitted" / "ada" / "hw" / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(nb if isinstance(nb, bytes) else json.dumps(nb).encode())
    (submission,) = submissions.find(folder / "submitted")
    assert submission.trouble == "" and submission.problem == "1.15"
    return grader.grade(Task("1.15", True, EXERCISE.sources_to_run(submission.cells)))


def full_marks(result):
    return {
        name: verdict["status"] for name, verdict in result["verdicts"].items()
    } == dict.fromkeys(NAMES, "right")


# Each of these gives a changed notebook; all of them keep full marks.


def as_handed_out(nb):
    pass


def check_cells_deleted(nb):
    nb["cells"] = [cell for cell in nb["cells"] if cell not in by_tag(nb, "check")]


def data_cell_deleted(nb):
    nb["cells"] = [cell for cell in nb["cells"] if cell not in by_tag(nb, "data")]


def data_cell_at_the_end(nb):
    (data,) = by_tag(nb, "data")
    nb["cells"].remove(data)
    nb["cells"].append(data)


def cells_in_reverse_order(nb):
    nb["cells"].reverse()


def helper_below_its_use(nb):
    answers = by_tag(nb, "answer")
    answers[0]["source"] = "a_region = both(k1 > 0, product)"
    answers[1]["source"] += "\nproduct = last_but_one > 1"
    nb["cells"] += [
        code("def both(*parts): return sp.And(*parts)"),
        code("last_but_one = k1*k2"),
    ]
    nb["cells"].append(nb["cells"].pop(nb["cells"].index(answers[1])))


def all_cells_doubled(nb):
    nb["cells"] = [twin for cell in nb["cells"] for twin in (cell, copy.deepcopy(cell))]


def untouched_copy_below(nb):
    nb["cells"] += [code(stub) for _, stub in EXERCISE.code("answer")]


def untouched_copy_above(nb):
    nb["cells"][:0] = [code(stub) for _, stub in EXERCISE.code("answer")]


def everything_in_one_cell(nb):
    nb["cells"] = [code("\n".join(f"{name} = {text}" for name, text in RIGHT_1_15.items()))]


def answers_split_over_cells(nb):
    cell = by_tag(nb, "answer")[0]
    k = nb["cells"].index(cell)
    nb["cells"][k : k + 1] = [
        code("first = k1 > 0"),
        code("second = k1*k2 > 1"),
        code("a_region = sp.And(first, second)"),
    ]


def typed_into_check_cells(nb):
    for cell, (name, text) in zip(by_tag(nb, "check"), RIGHT_1_15.items()):
        cell["source"] = f"{name} = {text}\n" + "".join(cell["source"])
    for cell in by_tag(nb, "answer"):
        nb["cells"].remove(cell)


def check_cell_reformatted_and_failing(nb):
    for cell in by_tag(nb, "check"):
        cell["source"] = "print('checking')\n" + "".join(cell["source"]).replace(
            "checks.report", "checks.reprot"
        )


def tags_and_metadata_lost(nb):
    nb["metadata"] = {}
    for cell in nb["cells"]:
        cell["metadata"] = {}


def sources_as_lists_and_windows_lines(nb):
    for cell in nb["cells"]:
        cell["source"] = "".join(cell["source"]).replace("\n", "\r\n").splitlines(keepends=True)


def saved_by_another_editor(nb):
    nb.update(nbformat=4, nbformat_minor=2)
    for cell in nb["cells"]:
        cell.pop("id", None)
        cell["metadata"] = {"collapsed": False, "scrolled": True, "trusted": "x"}
    nb["metadata"]["kernelspec"] = {"name": "sagemath", "language": "sage"}


def huge_outputs(nb):
    for cell in by_tag(nb, "answer"):
        cell["outputs"] = [
            {"output_type": "display_data", "data": {"image/png": "A" * 10**6}, "metadata": {}}
        ]


def last_value_by_its_underscore(nb):
    cell = by_tag(nb, "answer")[0]
    k = nb["cells"].index(cell)
    nb["cells"][k : k + 1] = [code("sp.And(k1 > 0, k1*k2 > 1)"), code("a_region = _")]


def module_written_by_a_cell(nb):
    cell = by_tag(nb, "answer")[0]
    nb["cells"].insert(
        nb["cells"].index(cell), code("%%writefile mine.py\ndef both(p, q): return p & q")
    )
    cell["source"] = "from mine import both\na_region = both(k1 > 0, k1*k2 > 1)"


def first(source):
    """Return a change: one more cell at the top."""

    def change(nb):
        nb["cells"].insert(0, code(source))

    change.__name__ = "first_" + source
    return change


def in_the_answer_cell(source):
    """Return a change: lines above the answer, in its own cell."""

    def change(nb):
        cell = by_tag(nb, "answer")[0]
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
def test_harmless_edits_of_a_notebook_cost_nothing(grader, tmp_path, change):
    nb = answered()
    change(nb)
    result = graded(grader, nb, tmp_path)
    assert full_marks(result), result
    assert all(remark.startswith("notebook: ") for remark in result["remarks"])


@pytest.mark.parametrize(
    "name", ["1.15.ipynb", "ch1-p15 (copy 2).ipynb", "1_15-final.ipynb", "ch1-p15.IPYNB"]
)
def test_names_of_files_cost_nothing(grader, tmp_path, name):
    nb = answered()
    tags_and_metadata_lost(nb)
    assert full_marks(graded(grader, nb, tmp_path, name))


def test_a_byte_order_mark_costs_nothing(grader, tmp_path):
    assert full_marks(graded(grader, b"\xef\xbb\xbf" + json.dumps(answered()).encode(), tmp_path))


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
def test_other_forms_cost_nothing(grader, tmp_path, form):
    result = graded(grader, notebook("1.15", RIGHT_1_15 | {"a_region": FORMS[form]}), tmp_path)
    assert full_marks(result), result["verdicts"]["a_region"]


def test_a_bad_answer_costs_only_itself(grader, tmp_path):
    result = graded(
        grader, notebook("1.15", RIGHT_1_15 | {"b_region": "1/0", "c_region": "object()"}), tmp_path
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


def test_a_check_cell_that_raises_its_verdict_is_no_error(grader, tmp_path):
    """A changed check cell runs with the notebook; only the judge reports answers not right."""
    nb = notebook("1.15", {"a_region": "k1 > 0"})
    for cell in by_tag(nb, "check"):
        cell["source"] = "".join(cell["source"]) + "  # mine"
    assert graded(grader, nb, tmp_path)["remarks"] == ()


def test_a_later_answer_counts(grader, tmp_path):
    """The last assignment counts that is not a stub."""
    nb = notebook("1.15", RIGHT_1_15 | {"a_region": "k1 > 5"})
    nb["cells"] += [code(f"a_region = {RIGHT_1_15['a_region']}"), code("a_region = ...")]
    assert full_marks(graded(grader, nb, tmp_path))


def _keep_busy():
    # Linux may share processors among sessions first: one for all would leave the notebook half of
    # them
    os.setsid()
    give_up = time.monotonic() + 60
    while time.monotonic() < give_up:
        pass


def test_a_slow_machine_costs_nothing(tmp_path):
    """Time is what the notebook computes, not wall time while the machine is busy."""
    seconds = 2.0
    nb = answered()
    # A cell may take half of the time that is left.
    in_the_answer_cell(f"import time\nwhile time.process_time() < {0.3 * seconds}: pass")(nb)
    others = [
        multiprocessing.get_context("fork").Process(target=_keep_busy, daemon=True)
        for _ in range(6)
    ]
    with Grader(Sandbox(Limits(cpu_seconds=seconds, wall_seconds=60), modules=ALWAYS)) as grader:
        for other in others:
            other.start()
        try:
            began = time.monotonic()
            result = graded(grader, nb, tmp_path)
        finally:
            for other in others:
                other.kill()
                other.join(timeout=30)
    assert full_marks(result), result
    assert time.monotonic() - began > 0.5 * seconds


def test_data_cells_run_first_and_once():
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
        assert _missing_data_cells(EXERCISE, begins_with_them) == []
    for lacks in (
        [],
        ["a_region = k1 > 0"],
        ["a_region = k1 > 0", data],
        [data + "\nk1 = 1", ""],
        [f"import os\n{data}"],
        ["pass", data],
        handed_out[:1],
    ):
        assert _missing_data_cells(EXERCISE, lacks) == [data.strip()]
