"""A plain Sphinx site of a course: pages of problems in both editions, with and without the engine."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from bs4 import BeautifulSoup
from own_problems import CONTROL, SUBSPACE, fill_in

from workbook import course
from workbook.authoring import new_course, new_problem

ROOT = Path(__file__).resolve().parents[2]
ENGINE = ROOT / "tests" / "site" / "native_engine.js"


@pytest.fixture(scope="module")
def robotics(tmp_path_factory):
    folder = tmp_path_factory.mktemp("lecturer") / "robotics"
    new_course(folder)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(course.VARIABLE, str(folder))
        for number, problem in ("robotics.2", SUBSPACE), ("robotics.3", CONTROL):
            fill_in(*new_problem(folder / "solutions", number), *problem)
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-m", "workbook", "exercises"]
    subprocess.run(command, cwd=folder, env=environment, check=True, timeout=120)
    yield folder
    course.read.cache_clear()


def site_of(robotics, folder, left_out="exercises"):
    """Build the site of a copy of the course, whose pages are not executed; a warning ends it."""
    shutil.copytree(robotics, folder / "robotics")
    settings = folder / "robotics" / "conf.py"
    text = settings.read_text(encoding="utf-8")
    settings.write_text(text.replace('"exercises"', f'"{left_out}"'), encoding="utf-8")
    if left_out == "exercises":
        engine = folder / "robotics" / "_build" / "run"
        engine.mkdir(parents=True)
        shutil.copy(ENGINE, engine / "engine.js")
    options = ["-q", "-n", "-W", "--keep-going", "-D", "nb_execution_mode=off"]
    done = subprocess.run(
        [sys.executable, "-m", "sphinx", *options, folder / "robotics", folder / "html"],
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return folder / "html"


def page_of(site, page):
    return BeautifulSoup((site / f"{page}.html").read_text(encoding="utf-8"), "html.parser")


def test_pages_with_solutions_and_boxes(robotics, tmp_path):
    site = site_of(robotics, tmp_path)
    for k, name in enumerate(("a_region", "a_basis", "a_control"), start=1):
        page = page_of(site, f"solutions/chrobotics/p0{k}")
        assert page.h1.get_text().startswith(f"robotics.{k} ")
        assert page.select_one(".answer-box textarea")["data-name"] == name
        assert page.select_one("details.solution")
        assert not page.select(".problem-chips .topic a"), "there is no index by topic"
        notebook = site / page.select_one("script[data-notebook]")["data-notebook"].lstrip("./")
        first, second = notebook.read_text(encoding="utf-8").splitlines()
        assert json.loads(first.partition(" = ")[2].rstrip(";"))["nbformat"] == 4
        sealed = json.loads(second.removeprefix("window.workbookMistakes = ").rstrip(";"))
        assert list(sealed) == [f"robotics.{k}"] and list(sealed[f"robotics.{k}"]) == [name]
        assert notebook.with_suffix("").is_file()  # the notebook itself, for download
    assert len(page_of(site, "index").select("table.problem-list tbody tr")) == 3
    assert (site / "run" / "engine.js").is_file() and (site / "_static" / "problems.css").is_file()


def test_pages_without_solutions_and_without_boxes(robotics, tmp_path):
    site = site_of(robotics, tmp_path, left_out="solutions")
    assert not (site / "solutions").exists() and not (site / "run").exists()
    page = page_of(site, "exercises/chrobotics/p01")
    assert page.select_one(".problem-head") and page.select_one(".tag_answer")
    assert not page.select(".answer-box, details.solution")
    assert not list(site.rglob("*.ipynb.js"))
