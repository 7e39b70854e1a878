"""Each documented install line, run in a fresh environment, does what its reader would do next."""

import json
import re
import shlex
import shutil
import subprocess
import sys
import threading
from functools import partial
from http.server import ThreadingHTTPServer
from pathlib import Path

import pytest
from chromium import browser  # noqa: F401
from engine_page import QuietHandler
from own_problems import CONTROL, REACH, SUBSPACE, checks_of_the_guide, fill_in
from selenium.webdriver.common.keys import Keys

pytestmark = [pytest.mark.waits, pytest.mark.slow]
ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = [
    ROOT / "README.md",
    *sorted((ROOT / "book").glob("*.md")),
    *sorted((ROOT / "book" / "guides").glob("*.md")),
]
#: A line as the documents have it, and the name of the test below that runs it.
TRIED = {
    "-e .": "test_the_library_alone",
    '-e ".[workbook]"': "test_a_class_without_a_checkout",
    '"trajlib-0.2.0-py3-none-any.whl[workbook]"': "test_a_class_without_a_checkout",
    '"trajlib-0.2.0-py3-none-any.whl[wasm]"': "test_a_class_without_a_checkout",
    '"trajlib-0.2.0-py3-none-any.whl[author]"': "test_a_class_without_a_checkout",
    '-e ".[author]"': "test_a_checkout_with_lectures",
    '-e ".[live]"': "test_a_checkout_with_lectures",
    '-e ".[cluster]"': "test_a_checkout_for_a_cluster",
    '"trajlib[workbook] @ https': "test_install_guide.py",
}
COURSE = ("z3", "typer", "rich", "yaml", "flint", "ipywidgets", "distributed", "jupytext")
DOCTESTS = """
import doctest, importlib, pkgutil, trajlib
names = [module.name for module in pkgutil.walk_packages(trajlib.__path__, "trajlib.")]
# The example of a proof needs the extra `proof`; the others need the six dependencies alone.
proof = "trajlib.pontryagin.verification.proof"
results = [doctest.testmod(importlib.import_module(name)) for name in names if name != proof]
print(len(names), sum(result.attempted for result in results), sum(result.failed for result in results))
"""
RIGHT_1_15 = {
    "a_region": "sp.And(k1 > 0, k1*k2 > 1)",
    "b_region": "sp.And(k2 > 0, k1 > k2)",
    "c_region": "sp.And(k1 > 0, k2 > 0, k1*k2 < 1)",
    "d_region": "sp.And(k1 > 0, k2 > k1)",
    "e_region": "sp.And(k1 > 0, k2 > k1)",
}


class Environment:
    """A fresh virtual environment in `folder`, into which pip has installed one line."""

    def __init__(self, folder, line, cwd):
        self.folder = folder
        subprocess.run([sys.executable, "-m", "venv", folder], check=True, timeout=120)
        self.run("pip", "install", "--quiet", *line, cwd=cwd, timeout=600)

    def run(self, command, *arguments, cwd=None, timeout=300, code=0):
        done = subprocess.run(
            [self.folder / "bin" / command, *arguments],
            cwd=cwd or self.folder,
            capture_output=True,
            text=True,
            timeout=timeout,
        )
        assert done.returncode == code, done.stdout + done.stderr
        return done

    def python(self, code, **options):
        return self.run("python", "-c", code, **options).stdout


@pytest.fixture
def checkout(tmp_path):
    """The files that git tracks, in a folder of their own."""
    names = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True, timeout=60
    ).stdout
    for name in filter(None, names.decode().split("\0")):
        if not name.startswith("tests/") and (ROOT / name).is_file():
            copy = tmp_path / "checkout" / name
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, copy)
    return tmp_path / "checkout"


def test_every_documented_line_is_tried():
    found = {
        line
        for path in DOCUMENTS
        for line in re.findall(
            r"pip install ((?:-e )?\"?[.\w-]+(?:\[[\w,]+\])?\"?(?: @ https)?)",
            path.read_text(encoding="utf-8"),
        )
        if "trajlib" in line or line.startswith("-e")
    }
    assert found - {"trajlib"} <= set(TRIED)
    beside = {path.name for path in Path(__file__).parent.iterdir()}
    assert all(name in globals() or name in beside for name in TRIED.values())


def test_the_library_alone(tmp_path, checkout):
    environment = Environment(tmp_path / "env", ["-e", "."], checkout)
    present = environment.python(
        f"import importlib.util; print([n for n in {COURSE} if importlib.util.find_spec(n)])"
    )
    assert present == "[]\n", "the library needs its six dependencies and nothing else"
    modules, examples, failures = map(int, environment.python(DOCTESTS).split()[-3:])
    assert modules > 100 and examples > 400 and failures == 0
    missing = environment.run("workbook", "problems", code=2).stderr
    assert "trajlib[workbook]" in missing and missing.count("\n") == 1


@pytest.mark.timeout(1800)  # Python may have to be compiled to WebAssembly
def test_a_class_without_a_checkout(tmp_path, browser):  # noqa: F811
    subprocess.run(
        [
            sys.executable,
            "-m",
            "pip",
            "wheel",
            "--quiet",
            "--no-deps",
            "--wheel-dir",
            tmp_path,
            ROOT,
        ],
        check=True,
        timeout=300,
    )
    [wheel] = tmp_path.glob("trajlib-*.whl")
    environment = Environment(tmp_path / "env", [f"{wheel.name}[workbook]"], tmp_path)
    environment.run("workbook", "exercises", "1.15", "--to", "mine", cwd=tmp_path)
    path = tmp_path / "mine" / "ch1" / "p15.ipynb"
    notebook = json.loads(path.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        for name, answer in RIGHT_1_15.items():
            cell["source"] = "".join(cell["source"]).replace(f"{name} = ...", f"{name} = {answer}")
    path.write_text(json.dumps(notebook), encoding="utf-8")
    assert "5 of 5 right" in environment.run("workbook", "check", path, cwd=tmp_path).stdout
    assert "Evening 4" in environment.run("workbook", "route", "engineer", cwd=tmp_path).stdout

    handed_in = tmp_path / "submitted" / "ada" / "hw1"
    handed_in.mkdir(parents=True)
    shutil.copy(path, handed_in)
    grade = ["workbook", "grade", "submitted", "--out", "graded", "--sandbox", "wasm"]
    refused = environment.run(*grade, cwd=tmp_path, code=2).stderr
    assert "trajlib[wasm]" in refused and refused.count("\n") == 1
    environment.run("pip", "install", "--quiet", f"{wheel.name}[wasm]", cwd=tmp_path, timeout=600)
    environment.run(*grade, cwd=tmp_path, timeout=1500)
    assert '"5.00"' in (tmp_path / "graded" / "hw1" / "grades.csv").read_text("utf-8-sig")

    site = follow_the_guide(environment, tmp_path)
    answer_on_the_pages(site, browser)


#: The region of each of five students, and what is on the page that he gets back.
REGIONS = {
    "ada": ("(k_p > 0) & (k_d > 0)", "Did you forget the torque of gravity?"),
    "ben": ("(k_p > 2) & (k_d > 0)", "right"),
    "cleo": ("k_p > gravity", "Do oscillations die out without damping?"),
    "dan": ("...", "missing"),
    "eve": ("sp.Min(k_p - gravity, k_d) > 0", "right"),
}


def follow_the_guide(environment, tmp_path):
    """Run the lines of the guide on courses, with its check and three more problems; return the site."""
    folder, printed = tmp_path, ""
    guide = (ROOT / "book" / "guides" / "own_course.md").read_text(encoding="utf-8")
    for command, *arguments in map(shlex.split, re.findall(r"^\$ (.+)", guide, re.M)):
        if command == "cd":
            folder /= arguments[0]
            (folder / "checks.py").write_text(checks_of_the_guide(), encoding="utf-8")
            for number, problem in (
                ("robotics.2", SUBSPACE),
                ("robotics.3", CONTROL),
                ("robotics.4", REACH),
            ):
                written = environment.run("workbook", "new", number, cwd=folder).stdout
                fill_in(*(folder / name for name in written.splitlines()[:2]), *problem)
            continue
        if arguments[0] == "grade":
            handed_out = folder / "assignments" / "hw1" / "chrobotics-p01.ipynb"
            text = handed_out.read_text(encoding="utf-8")
            for student, (region, _) in REGIONS.items():
                sent = folder / "submitted" / student / "hw1" / handed_out.name
                sent.parent.mkdir(parents=True)
                sent.write_text(text.replace("a_region = ...", f"a_region = {region}"))
        printed += environment.run(command, *arguments, cwd=folder, timeout=600).stdout
    assert "robotics.1: proved" in printed and "4 of 4 rows proved" in printed
    assert environment.run("workbook", "prove", cwd=folder).stdout.count(": proved") == 4
    for student, (_, told) in REGIONS.items():
        page = folder / "graded" / "hw1" / "feedback" / f"{student}.html"
        assert told in page.read_text(encoding="utf-8")
    return folder / "_build" / "html"


#: CasADi is not in a page: what needs it is judged by the notebook, and the page says so.
NOT_HERE = "a_control unchecked: this check runs in the notebook"
#: Of each page its file, an answer, a wrong and a right one, and what the page says of each.
BOXES = [
    (
        "p01",
        "a_region",
        ("k_p > gravity", "without damping?"),
        ("(k_p > 2) & (k_d > 0)", "✓ a_region right"),
    ),
    ("p02", "a_basis", ("[[1, 0]]", "the one that is measured?"), ("[[0, 7]]", "✓ a_basis right")),
    ("p03", "a_control", ("6*L*t", NOT_HERE), ("6*L - 12*L*t", NOT_HERE)),
]


def answer_on_the_pages(site, chromium):
    """Give wrong and right answers in the boxes of the site's pages, whose own Python judges them."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(QuietHandler, directory=str(site)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    allow = {"source": "localStorage['workbook/python'] = 'true'"}
    chromium.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", allow)
    for file, name, *answers in BOXES:
        address = f"http://127.0.0.1:{server.server_port}/solutions/chrobotics/{file}.html"
        for answer, expected in answers:
            chromium.driver.get(address)
            chromium.find(f".answer-box [aria-label='{name}']").click()
            assert chromium.wait_for("document.activeElement.classList.contains('cm-content')")
            field = chromium.driver.switch_to.active_element
            field.send_keys(Keys.CONTROL + "a")
            field.send_keys(Keys.DELETE, f"{name} = {answer}")
            chromium.find(".answer-run").click()
            report = "document.querySelector('.answer-output .workbook-report')?.innerText"
            shown = " ".join((chromium.wait_for(report, 120) or "").split())
            assert expected in shown, (name, answer, shown)
    server.shutdown()
    server.server_close()


def test_a_checkout_with_lectures(tmp_path, checkout):
    environment = Environment(tmp_path / "env", ["-e", ".[author]"], checkout)
    proved = environment.run("workbook", "prove", "1.15", cwd=checkout).stdout
    assert "1.15: proved" in proved
    environment.run("pip", "install", "--quiet", "-e", ".[live]", cwd=checkout, timeout=600)
    solved = environment.run("workbook", "solve", "5.3", cwd=checkout).stdout
    assert "right" in solved and "wrong" not in solved, "whose proof needs python-flint"
    assert "fastest-motion" in environment.run("workbook", "live", cwd=checkout).stdout
    environment.run("jupyter", "lab", "--version")


def test_a_checkout_for_a_cluster(tmp_path, checkout):
    environment = Environment(tmp_path / "env", ["-e", ".[cluster]"], checkout)
    assert "--cluster" in environment.run("workbook", "grade", "--help", cwd=checkout).stdout
    environment.python("import workbook.grading.cluster.coordinator, distributed")
