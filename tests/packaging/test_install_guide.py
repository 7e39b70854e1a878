"""The page *Install*: its blocks for a shell are run in a fresh folder, the others are marked."""

import functools
import http.server
import os
import re
import subprocess
import sys
import threading
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "grading"))
from guide import like, steps

from workbook.notebooks import exercises

pytestmark = [pytest.mark.waits, pytest.mark.slow]
ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "book" / "guides" / "install.md").read_text("utf-8")
SECTIONS = {part.split("\n")[0]: part for part in TEXT.split("\n## ")[1:]}
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```", re.DOTALL | re.MULTILINE)


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """Return the wheel, which is alone in its folder."""
    folder = tmp_path_factory.mktemp("downloads")
    pip = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", folder]
    subprocess.run([*pip, ROOT], check=True, timeout=300)
    [wheel] = folder.glob("*.whl")
    return wheel


def run(command, folder, code=0):
    """Run a line as in a new terminal, which knows no environment of Python."""
    tools = [str(Path(sys.executable).parent), str(folder / "bin"), os.environ["PATH"]]
    own = {"UV_TOOL_DIR": str(folder / "tools"), "UV_TOOL_BIN_DIR": str(folder / "bin")}
    done = subprocess.run(
        ["bash", "-c", command],
        cwd=folder,
        env=os.environ | own | {"PATH": os.pathsep.join(tools[1:] + tools[:1]), "COLUMNS": "120"},
        capture_output=True,
        text=True,
        timeout=600,
    )
    assert done.returncode == code, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


def test_what_is_not_run_is_marked():
    for title, text in SECTIONS.items():
        kinds = {kind for kind, _ in BLOCK.findall(text)}
        is_marked = "*not tested" in text.lower()
        assert is_marked == bool(kinds - {"console", "python"}), title


@pytest.mark.parametrize(
    "title", [title for title, text in SECTIONS.items() if "```console" in text]
)
def test_the_lines_of_a_system(title, wheel, tmp_path):
    (tmp_path / wheel.name).symlink_to(wheel)
    for _, command, shown in steps("\n".join(m[0] for m in BLOCK.finditer(SECTIONS[title]))):
        printed = run(command, tmp_path, code=int(" check " in command))
        assert not shown or like(shown, printed), printed
    path = tmp_path / "my-folder" / "ch1" / "p15.ipynb"
    assert path.read_bytes() == exercises.find("1.15").path.read_bytes()


def test_the_line_of_a_notebook_elsewhere(wheel, tmp_path):
    [(_, line)] = BLOCK.findall(SECTIONS["JupyterHub and Google Colab"])
    handler = functools.partial(http.server.SimpleHTTPRequestHandler, directory=str(wheel.parent))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_port}"
        line = line.replace("https://workbook.example/wheels", address).lstrip("%")
        run("python3 -m venv .venv", tmp_path)
        run(f".venv/bin/{line}", tmp_path)
        server.shutdown()
    assert "1.15" in run(".venv/bin/workbook problems", tmp_path)
