"""`make release`: what disagrees is named; the distributions are whole, from what is committed."""

import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "book"))

from release import clone, disagreements, distributions  # noqa: E402

FILES = (
    "pyproject.toml",
    "CITATION.cff",
    "CHANGELOG.md",
    "trajlib/__init__.py",
    "book/guides/install.md",
)


def test_versions_of_the_checkout_agree():
    assert [fault for fault in disagreements(ROOT) if "has version" in fault] == []


@pytest.fixture
def released(tmp_path):
    """Copies of the files that name the version, as on the day of a release."""
    for name in FILES:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    rewrite(tmp_path / "CHANGELOG.md", r"^## (\S+) \(.*\)", r"## \1 (2026-12-01)")
    rewrite(tmp_path / "CITATION.cff", r"^date-released: .*", "date-released: 2026-12-01")
    return tmp_path


def rewrite(path, pattern, by):
    """Replace the first match of a pattern, which begins a line or not."""
    text, count = re.subn(pattern, by, path.read_text("utf-8"), count=1, flags=re.M)
    assert count == 1
    path.write_text(text, "utf-8")


def test_a_release_agrees(released):
    assert disagreements(released) == []


@pytest.mark.parametrize(
    ("name", "pattern", "by", "fault"),
    [
        ("trajlib/__init__.py", '__version__ = ".*"', '__version__ = "9.9"', "has version 9.9"),
        ("CITATION.cff", "^version: .*", "version: 9.9.1", "has version 9.9.1"),
        ("CHANGELOG.md", r"^## \S+", "## 9.9", "has version 9.9"),
        ("book/guides/install.md", r"trajlib-[\d.]+-py3", "trajlib-9.9-py3", "has version 9.9"),
        ("CHANGELOG.md", r"\(2026-12-01\)", "(unreleased)", "unreleased, CITATION.cff 2026-12-01"),
        ("CITATION.cff", "2026-12-01", "2026-12-02", "2026-12-01, CITATION.cff 2026-12-02"),
    ],
)
def test_what_disagrees_is_named(released, name, pattern, by, fault):
    rewrite(released / name, pattern, by)
    [found] = disagreements(released)
    assert name in found and fault in found


@pytest.mark.slow
def test_distributions_of_a_clone(tmp_path):
    folder = tmp_path / "clone"
    clone(ROOT, folder)
    distributions(folder)
    [wheel], [sdist] = (list((folder / "dist").glob(form)) for form in ("*.whl", "*.tar.gz"))
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    with tarfile.open(sdist) as archive:
        sources = {name.partition("/")[2] for name in archive.getnames()}
    tracked = subprocess.run(
        ["git", "ls-files", "trajlib", "workbook", "exercises"],
        cwd=folder,
        check=True,
        capture_output=True,
        text=True,
    ).stdout.splitlines()
    assert len(tracked) > 1000 and set(tracked) <= sources
    assert {re.sub("^exercises/", "workbook/_exercises/", name) for name in tracked} <= names
    assert not {name for name in names | sources if ".trials" in name or "solutions/" in name}
