"""Judge a master and its trials; the page's Python and a native one run this same text."""

import ast
import contextlib
import io
import json
import sys
import time


def judged_problem(cells, trials, answers=None):
    """Return [what, status, message, seconds] of each answer of a master and of each trial.

    Parameters
    ----------
    cells : list of (str, str)
        (role, source) of its data, answer and check cells, in order.
    trials : list of (str, str, str)
        (role, name of the answer, source).
    answers : dict of str, optional
        Encoded answers, for those whose cells fail because they compute with CasADi.
    """
    from workbook.checks import collecting
    from workbook.checks.contract.decoding import decode

    namespace, judges, rows = {"__name__": "__main__"}, {}, []
    for role, source in cells:
        if role == "check":
            for name in reported(source).keys() & (answers or {}).keys() - namespace.keys():
                namespace[name] = decode(answers[name].encode())
        started = time.perf_counter()
        with collecting() as verdicts, _silent():
            failure = _run(source, namespace)
        if failure and role != "answer":
            rows.append([f"{role} cell", "failed", failure, 0])
        seconds = (time.perf_counter() - started) / max(len(verdicts), 1)
        rows += [
            ["cell " + name, verdict.status, verdict.message, seconds]
            for name, verdict in verdicts.items()
        ]
        if role == "check":
            judges.update(reported(source))
    # a worked solution may use a name of the data for something else
    data = {"__name__": "__main__"}
    reference = {name: namespace[name] for name in judges if name in namespace}
    with _silent():
        for role, source in cells:
            if role == "data":
                _run(source, data)
    for number, (role, name, source) in enumerate(trials):
        names = data | reference
        with _silent():
            failure = _run(source, names)
            started = time.perf_counter()
            failure = failure or _run(f"verdict = {judges[name]}", names)
        seconds, verdict = time.perf_counter() - started, names.get("verdict")
        row = ["failed", failure] if failure else [verdict.status, verdict.message]
        rows.append([f"{role} trial {number} {name}", *row, seconds])
    return rows


def _run(source, namespace):
    try:
        exec(compile(source, "<cell>", "exec"), namespace)
    except Exception as error:
        return f"{type(error).__name__}: {error}"


def reported(source):
    """Return the expression of each answer in a check cell."""
    return {
        keyword.arg: ast.unparse(keyword.value)
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "checks.report"
        for keyword in node.keywords
    }


def _silent():
    stack = contextlib.ExitStack()
    stack.enter_context(contextlib.redirect_stdout(io.StringIO()))
    stack.enter_context(contextlib.redirect_stderr(io.StringIO()))
    return stack


def encoded_answers(cells):
    """Return the encoded answers of a master whose check cells run."""
    from workbook.checks import collecting
    from workbook.checks.contract.encoding import encode

    namespace = {"__name__": "__main__"}
    with collecting() as verdicts, _silent():
        for _, source in cells:
            _run(source, namespace)
    return {name: encode(namespace[name]).decode() for name in verdicts}


if __name__ == "__main__":  # natively: FUNCTION, and the libraries that are to be absent
    for library in sys.argv[2:]:
        sys.modules[library] = None
    print(json.dumps(globals()[sys.argv[1]](*json.load(sys.stdin))), file=sys.__stdout__)
