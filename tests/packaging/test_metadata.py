"""The metadata of the distribution agree with what else describes it."""

import re
import tomllib
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
CITATION = yaml.safe_load((ROOT / "CITATION.cff").read_text("utf-8"))
SITE = yaml.safe_load((ROOT / "_config.yml").read_text("utf-8"))["html"]["baseurl"]


def test_authors_and_licence_agree():
    assert PROJECT["authors"] == CITATION["authors"]
    assert PROJECT["license"] == CITATION["license"]


def test_python_has_no_upper_bound_and_its_tested_versions_are_named():
    assert re.fullmatch(r">=3\.\d+", PROJECT["requires-python"])
    named = re.findall(r"Python :: (3\.\d+)$", "\n".join(PROJECT["classifiers"]), re.M)
    assert PROJECT["requires-python"] == f">={named[0]}"
    tested = f"Python {', '.join(named[:-1])} or {named[-1]}"
    for name in ("README.md", "Makefile", "book/guides/install.md"):
        assert tested in (ROOT / name).read_text("utf-8"), name


def test_addresses_are_those_of_the_citation_and_the_site():
    """While neither has an address, the metadata have none."""
    source = CITATION.get("repository-code", "")
    known = {"Source": source, "Issues": source, "Changelog": source, "Documentation": SITE}
    urls = PROJECT.get("urls", {})
    assert set(urls) == {name for name, address in known.items() if address}
    assert all(address.startswith(known[name]) for name, address in urls.items())
