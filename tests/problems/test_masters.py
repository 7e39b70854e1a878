"""Every master keeps its promise: the reference is right, the untouched copy missing, wrong answers are wrong, other
right forms right, and no mutant passes that an independent oracle does not prove right."""

import ast
import time
from pathlib import Path

import pytest
from harness import Workbench, apart, called_functions, check_calls
from mutants import mutants
from nonsense import NOT_ASKED, nonsense
from oracles import is_right

from trajlib.checks.encoding import decode, encode
from trajlib.masters import master_paths, read

ROOT = Path(__file__).resolve().parents[2]
PATHS = master_paths(ROOT / "solutions")
#: Seconds that the verdict on one answer may take, by chapter (design: speed matters where people wait).
VERDICT_SECONDS = {"5": 3.0}
#: Options of checks that may be written as numbers in a check cell.
TOLERANCES = {"tolerance", "horizon"}
#: Solvers of other libraries that an answer and its check must not share.
SOLVERS = ("trajlib.", "control", "casadi", "scipy.linalg", "scipy.optimize", "sympy.solvers")

@pytest.fixture(params=PATHS, ids=lambda path: f"{path.parent.name[2:]}.{int(path.stem[1:])}")
def master(request):
    return read(request.param)


def test_the_reference_is_right_and_crosses_the_encoder(master):
    found = apart(_reference, master)
    assert found["verdicts"] == dict.fromkeys(master.answers, "right"), found["messages"]
    slow = {name: seconds for name, seconds in found["seconds"].items()
            if seconds > VERDICT_SECONDS.get(master.number.split(".")[0], 1.0)}
    assert not slow, f"verdicts that take too long: {slow}"


def _reference(master):
    bench = Workbench(master)
    answers = {name: decode(encode(value)) for name, value in bench.reference.items()}
    bench.judge({})  # imports; nothing is known of the answers yet, as at a student's first check
    seconds = {}
    for name, value in answers.items():
        start = time.process_time()  # not the clock on the wall: other tests run on the same machine
        bench.judge_one(name, value)
        seconds[name] = time.process_time() - start
    verdicts = bench.judge(answers)
    return {"verdicts": {name: v.status for name, v in verdicts.items()}, "seconds": seconds,
            "messages": {name: v.message for name, v in verdicts.items()}}


def test_the_untouched_copy_is_missing(master):
    assert apart(_untouched, master) == dict.fromkeys(master.answers, "missing")


def _untouched(master):
    return {name: v.status for name, v in Workbench(master).judge({}).items()}


def test_wrong_cells_are_wrong_and_harm_no_other_answer(master):
    assert {name for name, _, _ in master.trials("wrong")} == set(master.answers), "every answer needs a wrong cell"
    found = apart(_trials, master, "wrong")
    assert found and [trial for trial in found if trial["status"] != "wrong" or trial["others"]] == []
    for trial in found:
        assert len(trial["message"]) > 20 and trial["reference"] not in trial["message"], trial


def test_right_cells_are_right(master):
    forms = [name for name, _, _ in master.trials("right")]
    few = [name for name, answer in master.answers.items()
           if forms.count(name) < 2 and not answer.kind.startswith(("choice", "yes/no"))]
    assert not few, f"these answers need two cells tagged right: {few}"
    assert [trial for trial in apart(_trials, master, "right") if trial["status"] != "right"] == []


def _trials(master, role):
    bench, found = Workbench(master), []
    for name, source, comment in master.trials(role):
        value = decode(encode(bench.try_cell(source)[name]))
        verdicts = bench.judge_beside(name, value) if role == "wrong" else {name: bench.judge_one(name, value)}
        found.append({"answer": name, "comment": comment, "status": verdicts[name].status,
                      "message": verdicts[name].message, "reference": f"= {bench.reference[name]}",
                      "others": [other for other, v in verdicts.items() if other != name and v.status != "right"]})
    return found


def test_no_mutant_passes_that_is_not_proved_right(master, record_property):
    found = apart(_mutants, master)
    record_property("mutants", found["count"])
    record_property("equivalent", found["equivalent"])
    assert found["passed"] == [], "accepted, though not proved right"
    assert found["refused"] == [], "proved right, yet not accepted"
    record_property("without value", found["without value"])
    assert found["taken for answers"] == [], "infinite or undefined, yet not refused"


def _mutants(master):
    bench = Workbench(master)
    result = {"count": 0, "equivalent": 0, "passed": [], "refused": [], "without value": 0, "taken for answers": []}
    for name, reference in bench.reference.items():
        check, arguments, options = bench.check_arguments(name)
        kind = master.answers[name].kind
        for mutant in mutants(reference, kind):
            right = is_right(mutant, reference, check, arguments, options, kind)
            verdict = bench.judge_one(name, mutant)
            result["count"] += 1
            result["equivalent"] += right
            if verdict.status == "right" and not right:
                result["passed"].append(f"{name} = {mutant}")
            if verdict.status != "right" and right:
                result["refused"].append(f"{name} = {mutant}: {verdict.status}: {verdict.message}")
        # Not one of these is a value, so no oracle is asked: each has to be told that it is none, and not left unchecked.
        for what, mutant in nonsense(reference, [*arguments, *options.values()]):
            verdict = bench.judge_one(name, mutant)
            result["without value"] += 1
            where = what.removeprefix("defined for ").removesuffix(" alone")
            not_asked = verdict.status == "right" and (master.number, where) in NOT_ASKED
            if verdict.status not in ("wrong", "invalid") and not not_asked:
                result["taken for answers"].append(f"{name}, {what}: {verdict.status}: {verdict.message}")
    return result


def test_check_cells_hold_no_answers(master):
    data = {node.id for source in master.code("data") for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Name)}
    for source in master.code("check"):
        for name, call in check_calls(source).items():
            assert ast.unparse(call.func).startswith("checks.") and ast.unparse(call.args[0]) == name
            for node in ast.walk(call):
                assert not isinstance(node, (ast.Lambda, ast.BinOp, ast.Compare, ast.BoolOp, ast.Subscript)), ast.unparse(node)
                if isinstance(node, ast.Call):
                    assert node is call, f"a call inside a check's arguments: {ast.unparse(node)}"
                if isinstance(node, ast.Name):
                    assert node.id in data | set(master.answers) | {"checks"}, f"{node.id} is neither data nor an answer"
                if isinstance(node, ast.Constant):
                    (keyword,) = [k for k in call.keywords if k.value is node] or [None]
                    assert keyword is not None and keyword.arg in TOLERANCES, f"a literal in a check: {ast.unparse(node)}"


def test_answer_and_check_share_no_solver(master):
    assert apart(_shared, master) == []


def _shared(master):
    namespace = Workbench(master).data | {}
    answered, checked = set(), set()
    for source in master.code("answer"):
        direct, within = called_functions(source, "answer", namespace)
        answered |= within | direct
    with_checks = {call for call in answered if call[0].startswith("trajlib.checks")}
    from trajlib import checks
    with checks.collecting():
        for source in master.code("check"):
            direct, within = called_functions(source, "check", namespace)
            checked |= within | direct
    shared = {call for call in answered & checked if call[0].startswith(SOLVERS)} - with_checks
    lazy = {call for call in shared if call[0] == "trajlib._lazy"}
    return sorted(f"{module}.{name}" for module, name in shared - lazy) + sorted(f"the answer uses a check: {c}" for c in with_checks if c[1] != "<module>")
