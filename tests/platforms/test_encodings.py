"""Text is UTF-8 in files, which name it, and in pipes: the encoding of the system's language is another."""

import ast
import io
from pathlib import Path

import pytest

from workbook.__main__ import write_utf8

ROOT = Path(__file__).resolve().parents[2]
#: How many positional arguments stand before the encoding.
BEFORE = {"open": 3, "read_text": 0, "write_text": 1, "fdopen": 3, "NamedTemporaryFile": 2}
#: The modes of files of bytes.
BINARY = {"rb", "wb", "xb", "ab", "r+b", "w+b"}
#: Whose function `open` is another.
OTHERS = {"Interval", "browser", "build_opener", "os", "tarfile", "webbrowser"}


def without_encoding(source):
    """Yield the lines of the calls that open a text file and do not name its encoding."""
    for call in ast.walk(ast.parse(source)):
        if not isinstance(call, ast.Call):
            continue
        name, owner = getattr(call.func, "id", ""), None
        if isinstance(call.func, ast.Attribute):
            of = call.func.value.func if isinstance(call.func.value, ast.Call) else call.func.value
            name, owner = call.func.attr, ast.unparse(of).split(".")[-1]
        if name in BEFORE and owner not in OTHERS:
            values = [*call.args, *(keyword.value for keyword in call.keywords)]
            modes = {value.value for value in values if isinstance(value, ast.Constant)}
            named = any(keyword.arg == "encoding" for keyword in call.keywords)
            if not (named or len(call.args) > BEFORE[name] or modes & BINARY):
                yield call.lineno


def test_what_is_found():
    text = (
        "open(p)\nopen(p, 'rb')\nopen(p, encoding='utf-8')\np.read_text()\np.write_text(t, 'utf-8')"
    )
    assert list(without_encoding(text)) == [1, 4]


def test_every_text_file_is_utf_8():
    found = [
        f"{path.relative_to(ROOT)}:{line}"
        for folder in ("trajlib", "workbook", "book")
        for path in (ROOT / folder).rglob("*.py")
        if path.parent != ROOT / "workbook" / "grading" / "sandbox"  # for Linux only
        for line in without_encoding(path.read_text("utf-8"))
    ]
    assert found == []


@pytest.mark.parametrize("encoding", ["cp1251", "cp1252", "cp866", "ascii"])
@pytest.mark.parametrize("is_terminal", [False, True])
def test_output(encoding, is_terminal):
    written = io.BytesIO()
    stream = io.TextIOWrapper(written, encoding=encoding)
    stream.isatty = lambda: is_terminal
    write_utf8(stream, None)  # Windows has no stream where a program has no console
    print("✓ §1.2 \udce9", file=stream, flush=True)
    text = written.getvalue().decode(encoding if is_terminal else "utf-8")
    assert text.split()[0] == ("?" if is_terminal else "✓") and text.strip().endswith("?")
