"""The built files: links, sources, ids; the student edition holds no solutions."""

import re
import zipfile
from pathlib import Path
from urllib.parse import unquote, urldefrag, urlsplit

import given_away
import pytest

from workbook import authoring

ROOT = Path(__file__).resolve().parents[2]
LOADING = {
    "script": "src",
    "img": "src",
    "iframe": "src",
    "source": "src",
    "video": "src",
    "audio": "src",
    "embed": "src",
    "object": "data",
    "link": "href",
}
CSS_LOADS = re.compile(r"""(?:url\(\s*|@import\s+)["']?(?:https?:)?//[^"')\s]+""")
JS_LOADS = re.compile(
    r"""(?:\bsrc\s*=|\bimport\s*\(?|\bimportScripts\(|\bfetch\()\s*["'`](?:https?:)?//[^"'`]+"""
)


def test_every_internal_link_leads_somewhere(pages):
    root, parsed = pages
    anchors = {
        path: {tag[key] for key in ("id", "name") for tag in page.find_all(attrs={key: True})}
        for path, page in parsed.items()
    }
    dead = []
    for path, page in parsed.items():
        for _tag, address in _addresses(page):
            if urlsplit(address).scheme or address.startswith("//"):
                continue
            target, anchor = urldefrag(address)
            file = (path.parent / unquote(urlsplit(target).path)).resolve() if target else path
            if file.is_dir():
                file /= "index.html"
            if not file.is_relative_to(root) or not file.is_file():
                dead.append(f"{path.relative_to(root)}: {address} (no such file)")
            elif anchor and file.suffix == ".html" and unquote(anchor) not in anchors[file]:
                dead.append(f"{path.relative_to(root)}: {address} (no such id in the page)")
    assert not dead, "\n".join(dead)


def test_nothing_is_loaded_from_another_host(pages):
    root, parsed = pages
    foreign = [
        f"{path.relative_to(root)}: {address}"
        for path, page in parsed.items()
        for name, key in LOADING.items()
        for tag in page.find_all(name, attrs={key: True})
        if re.match(r"(?:https?:)?//", address := tag[key])
    ]
    for path, page in parsed.items():
        inline = "\n".join(tag.get_text() for tag in page.find_all(["script", "style"]))
        foreign += [
            f"{path.relative_to(root)}: {load}"
            for load in JS_LOADS.findall(inline) + CSS_LOADS.findall(inline)
        ]
        # Jupyter Book defines a constant of this name in every page, though nothing uses it.
        foreign += [f"{path.relative_to(root)}: thebe"] if "thebe" in inline else []
    for pattern, loads in (("*.css", CSS_LOADS), ("*.js", JS_LOADS)):
        for path in root.rglob(pattern):
            foreign += [
                f"{path.relative_to(root)}: {load}"
                for load in loads.findall(path.read_text(encoding="utf-8"))
            ]
    assert not foreign, "\n".join(foreign)


def test_an_id_occurs_once_in_a_page(pages):
    root, parsed = pages
    for path, page in parsed.items():
        ids = [tag["id"] for tag in page.find_all(id=True)]
        assert len(ids) == len(set(ids)), (
            f"{path.relative_to(root)}: {sorted({name for name in ids if ids.count(name) > 1})}"
        )


def test_sources_are_not_served(pages):
    root, _ = pages
    assert not (root / "_sources").exists()
    assert not [path for path in root.rglob("*") if path.suffix == ".md" or ".trials" in path.name]
    wheels = list(root.glob("wheels/*.whl"))
    assert wheels
    for wheel in wheels:
        names = set(zipfile.ZipFile(wheel).namelist()) - {"workbook/_exercises/README.md"}
        assert not [
            name for name in names if "solutions/" in name or name.endswith((".md", ".trials.py"))
        ]


def test_every_problem_is_listed_under_its_number_and_topics(pages):
    root, parsed = pages
    for path, page in parsed.items():
        if re.fullmatch(
            r"(solutions|exercises)/ch\d+/p\d+\.html", path.relative_to(root).as_posix()
        ):
            number = f"{path.parent.name[2:]}.{int(path.stem[1:])}"
            listed = parsed[root / "book" / "problems.html"].find("a", string=number)
            assert (root / "book" / listed["href"]).resolve() == path
            topics = page.select("details.topics:not([open]) .problem-chips a")
            assert topics, path  # folded: a topic may name the result
            for topic in topics:
                file, anchor = urldefrag(topic["href"])
                term = parsed[(path.parent / file).resolve()].find(id=anchor)
                assert number in term.find_next("dd").get_text()


@pytest.mark.parametrize("pages", ["student"], indirect=True)
def test_the_student_edition_holds_no_solution(pages):
    root, parsed = pages
    assert not (root / "solutions").exists()
    for master in authoring.read_all(ROOT / "solutions"):
        copy = root / master.exercise.relative_to(ROOT)
        page = parsed[copy.with_suffix(".html")]
        shown = page.get_text() + copy.read_text(encoding="utf-8")
        assert not page.select("details.solution")
        for line in _lines([*master.code("answer", "figure"), *_trials(master)]) - _lines(
            master.code("data", "check")
        ):
            assert line not in shown, f"{master.number}: {line}"


def test_no_text_of_the_student_edition_is_the_right_side_of_a_worked_answer(editions):
    """Also of its archives, its wheel and the Python of its pages, which holds the library."""
    answers = given_away.worked_answers(authoring.read_all(ROOT / "solutions"))
    assert len(answers) > 800
    assert given_away.given_away(given_away.texts_below(editions.student), answers) == []
    # what is allowed stands there: a row that is no longer needed goes
    texts = "".join(text for _, text in given_away.texts_below(editions.student))
    assert [text for text in given_away.ALLOWED if text not in texts] == []


def test_the_student_edition_has_every_problem(editions):
    def problems(root, folder):
        return {path.relative_to(root / folder) for path in (root / folder).rglob("p*.html")}

    assert problems(editions.student, "exercises") == problems(editions.full, "solutions") != set()


def _addresses(page):
    for name, key in [*LOADING.items(), ("a", "href")]:
        for tag in page.find_all(name, attrs={key: True}):
            yield tag, tag[key]


def _trials(master):
    return [trial.source for trials in master.trials.values() for trial in trials]


def _lines(sources):
    """Return the characteristic lines of cells; imports and short lines occur everywhere."""
    lines = (line.strip() for source in sources for line in source.splitlines())
    return {
        line
        for line in lines
        if len(line) > 25 and not line.startswith(("import ", "from ", "with plotting"))
    }
