"""Submissions that change what the checks are made of."""

from hostile.attack import WRONG, Attack, gained, harmed_others

PATCHING = [
    Attack(
        "patches the check",
        "replaces the check by one that is content",
        "checks run where it was replaced",
        "checks run where no student's code ever ran",
        gained,
        (
            """
               from workbook.checks.contract.verdict import Verdict
               checks.stability_region = lambda *given: Verdict("right", "of course")
               """,
            WRONG,
        ),
    ),
    Attack(
        "patches the report",
        "replaces what collects the verdicts",
        "verdicts are collected where it was replaced",
        "verdicts are collected where no student's code ever ran",
        gained,
        (
            """
               from workbook.checks.contract import reporting
               from workbook.checks.contract.verdict import Verdict
               checks.report = lambda problem="", **given: reporting._collected.get().update(
                   {name: Verdict("right", "") for name in given})
               """,
            WRONG,
        ),
    ),
    Attack(
        "patches the decision",
        "replaces the function at the bottom of the check",
        "checks run where it was replaced",
        "checks run where no student's code ever ran",
        gained,
        (
            """
               import workbook.checks.stability.regions as regions
               regions.compare_region = lambda *given, **more: "as it should be"
               """,
            WRONG,
        ),
    ),
    Attack(
        "patches SymPy",
        "makes every polynomial another one",
        "the check computes with the patched library",
        "the judge has a SymPy of its own",
        gained,
        (
            """
               import sympy
               from workbook.checks.references import spectra
               sympy.Poly.all_coeffs = lambda self: [sympy.Integer(1), *sorted(self.free_symbols_in_domain, key=str)]
               spectra._spectrum.cache_clear()  # what was found for those before, with the true coefficients
               """,
            WRONG,
        ),
    ),
    Attack(
        "patches NumPy",
        "makes all numbers close to each other",
        "the comparison is made with the patched library",
        "the judge has a NumPy of its own",
        gained,
        ("import numpy\nnumpy.allclose = lambda *given, **more: True\na_region = [1.0, 2.0]",),
        marks="closeness",
    ),
    Attack(
        "patches builtins",
        "makes every distance zero",
        "the check measures with the patched function",
        "the judge has builtins of its own",
        gained,
        ("import builtins\nbuiltins.abs = lambda value: 0\na_region = 7.0",),
        marks="number",
    ),
    Attack(
        "patches for all who follow",
        "makes the check refuse whatever comes later",
        "the next students are marked in the same process",
        "every notebook has a process of its own",
        harmed_others,
        (
            """
               import workbook.checks.stability.regions as regions
               from workbook.checks.contract.verdict import Wrong
               def refuse(*given, **more):
                   raise Wrong("not for you")
               regions.compare_region = refuse
               """,
            WRONG,
        ),
    ),
    Attack(
        "replaces modules",
        "puts a module of its own in the place of workbook.checks",
        "the next import finds it",
        "imports of the judge find the real one",
        gained,
        (
            """
               import sys, types
               from workbook.checks.contract import reporting
               from workbook.checks.contract.verdict import Verdict
               checks = sys.modules["workbook.checks"] = types.ModuleType("workbook.checks")
               checks.stability_region = lambda *given: Verdict("right", "")
               from workbook.checks.contract.report import report
               checks.report, checks.collecting = report, reporting.collecting
               sys.modules["workbook"].checks = checks
               """,
            WRONG,
        ),
    ),
    Attack(
        "walks the stack",
        "looks for the grader's own variables in the frames below it, and sets its points",
        "the cell is run by the grader itself",
        "no frame of the judge is below it",
        gained,
        (
            """
               import sys
               frame = sys._getframe()
               while frame:
                   if "verdicts" in frame.f_locals:
                       from workbook.checks.contract.verdict import Verdict
                       frame.f_locals["verdicts"]["a_region"] = Verdict("right", "")
                       checks.report = lambda problem="", **given: None
                   frame = frame.f_back
               """,
            WRONG,
        ),
    ),
    Attack(
        "finds the verdicts",
        "finds the dictionary of verdicts among all objects",
        "it is in the same process",
        "verdicts are made in another process",
        gained,
        (
            """
               from workbook.checks.contract import reporting
               from workbook.checks.contract.verdict import Verdict
               reporting._collected.get()["a_region"] = Verdict("right", "")
               from workbook.checks.contract.report import report
               report.__code__ = (lambda **given: None).__code__
               """,
            WRONG,
        ),
    ),
    Attack(
        "replaces the check cell",
        "writes a check cell of its own",
        "the notebook's check cells are run as handed in",
        "check cells are always the pristine ones",
        gained,
        (
            """
               from workbook.checks.contract.verdict import Verdict
               checks.report(a_region=Verdict("right", "it is right"))
               checks.report = lambda problem="", **given: None
               """,
            WRONG,
        ),
    ),
    Attack(
        "changes the data",
        "replaces the polynomial by one whose region it knows",
        "the check cell finds the notebook's own data",
        "data are always the pristine ones",
        gained,
        ("a_poly = (s + k1)*(s + k2)", WRONG),
    ),
    Attack(
        "names a check of its own",
        "says in its metadata that its problem's checks are in a file which it hands in too",
        "the name is used as a path",
        "a number is a number, and checks are never read from submissions",
        gained,
        files=lambda folder: _with_own_checks(folder),
    ),
]


def _with_own_checks(folder):
    from hostile.attack import with_cells, write

    notebook = with_cells([WRONG])
    notebook["metadata"]["workbook"]["number"] = f"../{'/'.join(folder.parts[-3:])}/own"
    write(folder / "essay.ipynb", notebook)
    (folder / "own.py").write_text(
        "from workbook.checks.contract.verdict import "
        "Verdict\nchecks.report(a_region=Verdict('right', ''))"
    )
