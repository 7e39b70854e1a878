"""The magics in a kernel of their own, as JupyterLab asks them."""

import json
import os
from types import SimpleNamespace

import pytest
from jupyter_client.manager import start_new_kernel

from workbook.live import LiveError
from workbook.live.catch_up import cells_above
from workbook.live.lab import write_settings
from workbook.live.magics import is_lecture_magic

pytestmark = pytest.mark.slow


class Kernel:
    """`run` gives what a cell shows: text of all kinds, and which cell it puts below."""

    def __init__(self, client):
        self._client = client

    def run(self, source):
        shown, pictures = [], []
        message_id = self._client.execute(source)
        while True:
            message = self._client.get_iopub_msg(timeout=60)
            if message["parent_header"].get("msg_id") != message_id:
                continue
            kind, content = message["msg_type"], message["content"]
            if kind == "status" and content["execution_state"] == "idle":
                break
            if kind == "stream":
                shown.append(content["text"])
            elif kind in ("display_data", "execute_result"):
                shown.append(content["data"].get("text/markdown") or content["data"]["text/plain"])
                pictures += [form for form in content["data"] if form.startswith("image/")]
            elif kind == "error":
                shown.append("\n".join(content["traceback"]))
        while (reply := self._client.get_shell_msg(timeout=60))["parent_header"].get(
            "msg_id"
        ) != message_id:
            pass
        reply = reply["content"]
        below = [
            message["text"]
            for message in reply.get("payload", [])
            if message["source"] == "set_next_input"
        ]
        return "\n".join(shown).strip(), (below or [""])[0], pictures


@pytest.fixture(scope="module")
def running(tmp_path_factory):
    folder = tmp_path_factory.mktemp("lecture")
    environment = os.environ | write_settings(folder) | {"WORKBOOK_LIVE_PROBLEMS": "1.15"}
    environment.pop("MPLBACKEND", None)
    manager, client = start_new_kernel(kernel_name="python3", env=environment, cwd=str(folder))
    kernel = Kernel(client)
    # by itself
    assert (
        "one step more" in kernel.run("print(get_ipython().find_line_magic('answer').__doc__)")[0]
    )
    yield kernel
    client.stop_channels()
    manager.shutdown_kernel(now=True)


@pytest.fixture
def kernel(running, request):
    """The kernel as a lecture begins it."""
    running.run("%reset -f")
    running.run(
        f"import os; os.environ['WORKBOOK_LIVE_PROBLEMS'] = {getattr(request, 'param', '1.15')!r}\n"
        "__import__('workbook.live').live.load_ipython_extension(get_ipython())\ndel os"
    )
    return running


def test_an_answer_goes_step_by_step_from_idea_to_caption(kernel):
    below = "%answer a_region"
    seen, code, pictures = [], [], []
    for _ in range(12):
        if not below:
            break
        shown, below, drawn = kernel.run(below)
        pictures += drawn
        if below and not below.startswith("%answer"):
            code.append(below)
        seen.append(shown)
    assert "Hurwitz matrix" in seen[0] and "k_1k_2 > 1" in seen[2]
    assert len(code) == 2 and "a_region = sp.And" in code[0] and "plotting.region" in code[1]
    assert pictures and seen[-1].startswith("*Left: the region of item a.")
    assert "that is all of a_region" in kernel.run("%answer a_region")[0]
    assert kernel.run("%check a_region")[0].startswith("✓ a_region: right")
    # item e draws what c and d have found: nobody has to have gone through them
    for _ in range(10):
        shown, below, drawn = kernel.run("%answer e_region")
        if "axes" in below:
            break
    assert "run now: c_region, d_region" in shown
    assert kernel.run(below)[2] == ["image/png"]


def test_check_judges_in_one_line(kernel):
    kernel.run("import sympy as sp\nk1, k2 = sp.symbols('k1 k2', real=True)")
    shown, below, _ = kernel.run("%check a_region = sp.And(k1 > 0, k1*k2 > 1)")
    assert shown.startswith("✓ a_region: right") and not below
    shown = kernel.run("%check a_region = sp.And(k1 > 0, k2 > 0)")[0]
    assert (
        shown.startswith("✗ a_region: wrong: the point k1 = 1, k2 = 1/2")
        and "Which minor was not" in shown
    )
    assert kernel.run("%check b_region")[0] == "… b_region: missing: not answered yet"
    assert "cannot be computed: NameError" in kernel.run("%check a_region = And(k1 > 0)")[0]
    assert "write what is to be judged" in kernel.run("%check a_region =")[0]
    assert "? a_region: invalid" in kernel.run("%check a_region = lambda k: k")[0]


def test_hints_appear_one_by_one(kernel):
    first, second, third = (kernel.run("%hint a_region")[0] for _ in range(3))
    assert "Hint 1" in first and "Hint 2" not in first
    assert "Hint 1" in second and "Hint 2" in second and third == second


def test_mistakes_have_a_counterexample(kernel):
    shown = [kernel.run("%mistake a_region") for _ in range(4)]
    assert (
        "a_region = sp.And(k1 > 0, k2 > 0)" in shown[0][0]
        and "the point k1 = 1, k2 = 1/2" in shown[0][0]
    )
    assert shown[0][2] == shown[1][2] == ["image/png"]
    # it differs from the truth on a line alone, which is no place for a cross
    assert shown[2][2] == []
    assert shown[3] == shown[0]  # round again
    assert "leading minors:" not in shown[0][0]  # what the worked cells show is not shown


@pytest.mark.parametrize(
    "line, message",
    [
        ("%answer a_regon", "there is no answer a_regon; there is a_region"),
        ("%hint", "name an answer; there is a_region"),
        ("%mistake 1.15 a_region b_region", "one answer at a time"),
        ("%mistake a_region b_region", "there is no problem a_region"),
        ("%check 9.99 a_region", "no problem 9.99"),
        ("%poll a_regon", "there is no answer a_regon; there is a_region"),
        ("%poll a_region 3 4", "there are 4 answers here"),
        ("%poll", "name an answer; there is a_region"),
        ("%explore nothing", "there is no explorer nothing"),
        ("%explore region_of_stability 1.15 a k1=99", "k1: expected a number from -2 to 4, got 99"),
    ],
)
def test_bad_input_ends_in_one_line(kernel, line, message):
    shown = kernel.run(line)[0]
    assert message in shown and len(shown.splitlines()) == 1


@pytest.mark.parametrize("kernel", ["1.15 1.16"], indirect=True)
def test_with_several_problems_the_number_is_needed(kernel):
    shown = kernel.run("%hint a_region")[0]
    assert "a_region is an answer of 1.15 and of 1.16; say which: 1.15 a_region" in shown
    assert "Hint 1" in kernel.run("%hint 1.16 a_region")[0]
    assert "Hint 1" in kernel.run("%hint 1.17 a_region")[0]  # of any problem


def test_catchup_with_a_name_works_up_to_it(kernel):
    assert kernel.run("%catchup c_region")[0] == "3 cells run"
    assert kernel.run("print(b_region == (k2 > 0) & (k1 > k2))")[0] == "True"
    assert "NameError" in kernel.run("c_region")[0]
    assert "%catchup belongs into a cell" in kernel.run("%catchup")[0]


def test_catchup_reads_the_cells_above_from_the_saved_notebook(tmp_path, monkeypatch):
    cells = [
        ("a", "code", "x = 1"),
        ("b", "markdown", "words"),
        ("c", "code", "%answer a_region"),
        ("d", "code", "%catchup"),
        ("e", "code", "x = 2"),
    ]
    notebook = {
        "cells": [
            {"id": name, "cell_type": kind, "source": [source]} for name, kind, source in cells
        ]
    }
    (tmp_path / "lecture.ipynb").write_text(json.dumps(notebook), encoding="utf-8")
    monkeypatch.setenv("JPY_SESSION_NAME", str(tmp_path / "lecture.ipynb"))

    def shell(cell):
        return SimpleNamespace(
            kernel=SimpleNamespace(get_parent=lambda: {"metadata": {"cellId": cell}})
        )

    above = cells_above(shell("d"))
    assert above == ["x = 1", "%answer a_region"] and [
        is_lecture_magic(source) for source in above
    ] == [
        False,
        True,
    ]
    with pytest.raises(LiveError, match="not saved yet"):
        cells_above(shell("new"))
