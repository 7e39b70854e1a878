"""Make a release: `make release`, or `python book/release.py` in a checkout of what is committed.

It refuses while files disagree on the version or its date, or changes are not committed. Then it makes
all that is published in a fresh clone, _build/release, with an environment of its own, and lists it.
"""

import hashlib
import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parent.parent
#: The newest entry of the changelog: its version and date.
ENTRY = re.compile(r"^## (\S+) \((.*)\)$", re.MULTILINE)
#: What the steps make, below the clone.
PUBLISHED = ("dist/*.whl", "dist/*.tar.gz", "_build/pdf/*.pdf", "_build/bundle/*.zip")


def disagreements(root):
    """Return sentences on the files of a checkout that disagree with pyproject.toml, or have no date."""

    def text(name):
        return (root / name).read_text(encoding="utf-8")

    version = tomllib.loads(text("pyproject.toml"))["project"]["version"]
    citation = yaml.safe_load(text("CITATION.cff"))
    newest, date = ENTRY.search(text("CHANGELOG.md")).groups()
    versions = {
        "trajlib/__init__.py": re.findall(r'__version__ = "(.*)"', text("trajlib/__init__.py")),
        "CITATION.cff": [citation["version"]],
        "CHANGELOG.md": [newest],
        "book/guides/install.md": re.findall(
            r"trajlib-([\d.]+)-py3", text("book/guides/install.md")
        ),
    }
    found = [
        f"{name} has version {other}, pyproject.toml {version}"
        for name, others in versions.items()
        for other in dict.fromkeys(others)
        if other != version
    ]
    if str(citation["date-released"]) != date:
        found.append(
            f"CHANGELOG.md dates {newest} {date}, CITATION.cff {citation['date-released']}"
        )
    return found


def clone(root, folder):
    """Clone what is committed into a folder, in place of what was there."""
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run(["git", "clone", "--quiet", "--no-hardlinks", root, folder], check=True)


def distributions(root):
    """Build the sdist of a checkout, and from it the wheel, in the folder dist/ of the checkout."""
    build = [sys.executable, "-m", "uv", "build", "--quiet", "--out-dir", root / "dist", root]
    subprocess.run(build, check=True)


def main():
    """Make a release; return the exit code."""
    changes = subprocess.run(
        ["git", "status", "--porcelain"], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout
    faults = disagreements(ROOT) + (["changes are not committed"] if changes else [])
    if faults:
        print("No release yet:", *faults, sep="\n  ", file=sys.stderr)
        return 2
    folder = ROOT / "_build" / "release"
    clone(ROOT, folder)
    distributions(folder)
    # the variables of this make are not for that one
    own = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
    for target in ("pdf", "bundle"):  # each makes the site
        subprocess.run(["make", target], cwd=folder, env=own, check=True)
    version = ENTRY.search((folder / "CHANGELOG.md").read_text(encoding="utf-8"))[1]
    print(f"Publish, with the entry {version} of CHANGELOG.md:")
    print(f"  the tag v{version} at", _commit(folder))
    print(f"  the site, the files in {folder / '_build' / 'html'}")
    for path in (path for pattern in PUBLISHED for path in sorted(folder.glob(pattern))):
        print(f"  {path}\n    sha256 {hashlib.sha256(path.read_bytes()).hexdigest()}")
    return 0


def _commit(folder):
    head = ["git", "rev-parse", "HEAD"]
    return subprocess.run(head, cwd=folder, check=True, capture_output=True, text=True).stdout[:12]


if __name__ == "__main__":
    sys.exit(main())
