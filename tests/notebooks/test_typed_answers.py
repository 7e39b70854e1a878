"""What people type is read and judged alike in a page, a notebook and on the command line."""

import nbformat
import pytest
from nbclient import NotebookClient
from typed_answers import TYPED

from workbook import page
from workbook.notebooks import exercises
from workbook.notebooks.execution import judge, run_notebook

EXERCISE = exercises.find("1.15")
(DATA,) = (source for _, source in EXERCISE.code("data"))
CHECK = EXERCISE.code("check")[0][1]
NAME = "a_region"


@pytest.mark.parametrize("typed, read, status, said", TYPED)
def test_a_page_reads_what_was_meant(typed, read, status, said):
    result = page.run_cell([DATA, typed], CHECK, names=["", NAME])
    assert result["verdicts"] == {NAME: status}
    assert result["read"] == ["", read]
    hints = [error["hint"] for error in result["errors"]]
    assert said in "\n".join([result["text"], *hints]).replace("\n", " ")


@pytest.mark.parametrize("typed, read, status, said", TYPED)
def test_the_command_and_the_grader_read_what_was_meant(typed, read, status, said):
    sources = EXERCISE.sources_to_run([DATA, typed, CHECK])
    run = run_notebook(sources, EXERCISE.about["answers"], timeout=60)
    verdicts = judge(EXERCISE.code("data", "check")[:2], run, EXERCISE.about["answers"])
    assert verdicts[NAME].status == status
    assert run.read == ((read,) if read else ())
    assert said in "\n".join([verdicts[NAME].message, *run.errors])


@pytest.fixture(scope="module")
def shown():
    """Return what a kernel shows below the cells of each row and of the check that follows them."""
    cells = ["from workbook.checks.contract import cell_watch", DATA]
    for typed, *_ in TYPED:
        cells += [typed, CHECK, f"globals().pop('{NAME}', None); cell_watch.forget();"]
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
    NotebookClient(notebook, allow_errors=True, timeout=60, kernel_name="python3").execute()
    rows = notebook.cells[2:]
    return [
        "\n".join(map(_text, rows[k].outputs + rows[k + 1].outputs)) for k in range(0, len(rows), 3)
    ]


def _text(output):
    if output.output_type == "stream":
        return output.text
    if output.output_type == "error":
        return "\n".join(output.traceback)
    return output["data"]["text/plain"]


@pytest.mark.parametrize("row", range(len(TYPED)))
def test_a_notebook_reads_what_was_meant(row, shown):
    _, read, status, said = TYPED[row]
    assert f" {NAME}: {status}: " in shown[row]
    assert said in shown[row].replace("\n", " ")
    assert (f"Read as: {read}" in shown[row]) if read else ("Read as" not in shown[row])


def test_expressions_are_given_to_answers_only_where_it_is_plain_which_is_which():
    names = ["a_region", "b_region"]

    def answered(*sources):
        return set(run_notebook([DATA, *sources], names, timeout=60).encoded)

    check = "# check of a_region, b_region"
    assert answered("k1 > 0", "k2 > 0", check) == {"a_region", "b_region"}
    assert answered("a_region = k1 > 0", "k2 > 0", check) == {"a_region", "b_region"}
    assert answered("k1 > 0", check) == set()
    assert answered("k1 > 0", "k1 > 1", "k1 > 2", check) == set()
    assert answered("# check of c_region", "k1 > 0", "print(k1)", "# check of b_region") == {
        "b_region"
    }
    # the stub still stands: the expression is something else
    run = run_notebook([DATA, "b_region = ...", "k1 > 0", "# check of b_region"], names, timeout=60)
    assert run.read == ()


def test_in_a_notebook_an_expression_in_the_cell_of_a_stub_is_that_answer():
    """JupyterLab and VS Code tell the kernel which cell runs."""
    from workbook.checks.contract import cell_watch

    class Shell:
        user_ns = {}

    class Result:
        error_before_exec = error_in_exec = None

        def __init__(self, cell, source):
            self.info = type("Info", (), {"cell_id": cell, "raw_cell": source})
            cell_watch.before_cell(Shell.user_ns, source)
            exec(source, Shell.user_ns)
            self.result = eval(source, Shell.user_ns) if "=" not in source else None

    cell_watch.forget()
    for cell, source in ("one", "a = ..."), ("two", "b = ..."), ("three", "7"), ("two", "3 + 4"):
        cell_watch._after_cell(Shell, Result(cell, source))
    cell_watch.forget()
    assert Shell.user_ns["a"] is ... and Shell.user_ns["b"] == 7
