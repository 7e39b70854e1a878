"""What the page's Python runs once; its memory afterwards is the image that each later start uses."""

import json
import sys
import traceback

sys.path.insert(0, "/library")


def execute():
    """Run the text that the page left in a file, in a fresh namespace, and leave its result."""
    with open("/run/code.py", encoding="utf-8") as file:
        source = file.read()
    namespace, error = {"__name__": "__main__"}, None
    try:
        exec(compile(source, "<page>", "exec"), namespace)
        result = json.dumps(namespace.get("result"))
    except BaseException:  # SystemExit too
        error, result = traceback.format_exc(limit=-3), "null"
    with open("/run/result.json", "w", encoding="utf-8") as file:
        file.write(f'{{"result": {result}, "error": {json.dumps(error)}}}')


def warm():
    """Load what most checks need, by a right and a wrong answer."""
    import scipy.integrate
    import scipy.linalg
    import scipy.optimize  # noqa: F401

    from workbook.display import show  # noqa: F401
    from workbook.page import run_cell

    data = "import sympy as sp; from workbook import checks; k, s = sp.symbols('k s', real=True)"
    check = "checks.report(a=checks.stability_region(a, s**2 + k*s + k - 1, [k]))"
    for answer in ("a = k > 1", "a = k > 0"):
        run_cell([data, answer], check, "1.15")


warm()
