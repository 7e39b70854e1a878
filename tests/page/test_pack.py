"""Packing: the lean file keeps all code but that of the packages left out."""

import hashlib
import tomllib

import pytest
from engine_page import ROOT

from workbook.engine import lean, pack

SOURCES, ENGINE = ROOT / "book" / "engine", ROOT / "workbook" / "engine"


def section(number, body):
    return bytes([number]) + lean._encoded(len(body)) + body


def text(name):
    return lean._encoded(len(name)) + name.encode()


def module(names):
    """Return a module of one imported function and, for each name, one that returns 42."""
    body = b"\x00\x41\x2a\x0b"
    functions = b"".join(lean._encoded(len(body)) + body for _ in names)
    table = b"".join(lean._encoded(k) + text(name) for k, name in enumerate(["host", *names]))
    table = lean._encoded(len(names) + 1) + table
    return b"\0asm\1\0\0\0" + b"".join(
        (
            section(lean.IMPORT, b"\x01" + text("host") + text("call") + b"\x00\x00"),
            section(lean.CODE, lean._encoded(len(names)) + functions),
            section(lean.CUSTOM, text("name") + bytes([1]) + lean._encoded(len(table)) + table),
        )
    )


NAMES = [
    "PyInit_etree", "__pyx_pw_4lxml_5etree_1f", "helper", "__pyx_pw_4lxml_5etree_3g",
    "PyInit_lib", "__pyx_pw_6pandas_1f", "std::vector<int>::push_back(int)",
    "_GLOBAL__sub_I_x.cpp", "__pyx_pw_6pandas_3g", "__pyx_pw_5scipy_1f",
    "__pyx_pw_7sklearn_1f", "__pyx_pw_11statsmodels_1f", "main",
]  # fmt: skip


def bodies(wasm):
    code = next(body for number, body in lean._sections(wasm) if number == lean.CODE)
    count, position = lean._number(code, 0)
    for _ in range(count):
        size, start = lean._number(code, position)
        yield code[start : start + size]
        position = start + size


def test_only_the_code_of_packages_left_out_goes():
    kept = dict(zip(NAMES, bodies(lean.lean(module(NAMES)))))
    trapping = [name for name in NAMES if kept[name] == lean.UNREACHABLE[1:]]
    assert trapping == [
        "__pyx_pw_4lxml_5etree_1f", "helper", "__pyx_pw_4lxml_5etree_3g", "__pyx_pw_6pandas_1f",
        "__pyx_pw_6pandas_3g", "__pyx_pw_7sklearn_1f", "__pyx_pw_11statsmodels_1f",
    ]  # fmt: skip
    assert kept["_GLOBAL__sub_I_x.cpp"] == lean.NOTHING[1:]
    assert kept["std::vector<int>::push_back(int)"] == kept["main"] == b"\x00\x41\x2a\x0b"
    assert b"etree" not in lean.lean(module(NAMES))


def test_code_of_a_package_that_is_kept_is_never_removed():
    with pytest.raises(ValueError, match="a package that is kept"):
        lean.lean(module([*NAMES, "__pyx_pw_6pandas_5h"]))


def test_another_version_of_the_file_is_refused(tmp_path):
    (tmp_path / "python.wasm").write_bytes(b"other")
    with pytest.raises(SystemExit, match="SHA-256 differs"):
        pack._verified(tmp_path / "python.wasm")


def test_the_library_holds_no_solution_and_no_grader():
    import io
    import tarfile

    names = tarfile.open(fileobj=io.BytesIO(pack.library())).getnames()
    assert "workbook/page.py" in names and "trajlib/__init__.py" in names
    outside = ("workbook/grading", "workbook/site", "workbook/engine")
    assert not [name for name in names if name.startswith(outside)]
    assert all(
        name.startswith(("trajlib/", "workbook/")) and name.endswith(".py") for name in names
    )


def test_the_bundle_is_built_from_its_sources():
    sources = b"".join(path.read_bytes() for path in sorted((SOURCES / "src").iterdir()))
    script = (ENGINE / "engine.js").read_text(encoding="utf-8")
    assert hashlib.sha256(sources).hexdigest() in script.split("\n")[0]
    with open(SOURCES / "vendored.toml", "rb") as file:
        versions = [f"{part['package']}@{part['version']}" for part in tomllib.load(file).values()]
    command = (SOURCES / "build.sh").read_text(encoding="utf-8")
    assert [version for version in versions if version not in command] == []


def test_without_the_extra_the_message_names_it(tmp_path, monkeypatch):
    monkeypatch.setattr(pack.importlib.util, "find_spec", lambda name: None)
    with pytest.raises(ModuleNotFoundError, match=r"trajlib\[page\]"):
        pack.pack(tmp_path / "run")
    assert not (tmp_path / "run").exists()
