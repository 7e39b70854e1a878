"""Start of `workbook live 1.15` against plain `jupyter lab`, and frames of the explorers.

Both servers are driven as JupyterLab's page drives them: the notebook is requested, a kernel is
started, the first cell is sent to it. A cold start is the first one after the files of the
environment have left the system's cache, which needs root; without it only warm starts are timed.
The time that the browser takes to draw its page is not included.

A frame is measured in core-seconds of the kernel, which do not depend on the load of the machine,
and as pictures a second in the browser while a pointer moves (needs Chromium; `--frames` times
frames only). The bar is 20 a second. The formats of a frame are compared on one picture.
"""

import json
import os
import re
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import time
import urllib.request
import uuid
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

import websocket

ROOT = Path(__file__).resolve().parents[1]
RUNS = 5
#: What a lecture's first cells ask for, by hand in a kernel that has nothing.
IMPORTS = (
    "import sympy as sp\nimport numpy as np\nimport matplotlib.pyplot as plt\nimport "
    "scipy.integrate\n"
    "from trajlib import plotting, stability\nfrom workbook import checks\nfrom workbook.display "
    "import show\n"
)
DATA = "k1, k2, s = sp.symbols('k1 k2 s', real=True)\na_poly = s**3 + k1*s**2 + k2*s + 1\na_poly\n"
PICTURE = "plotting.region(sp.And(k1 > 0, k1*k2 > 1), [k1, k2], (-2, 4), (-2, 4))\n"
CHECK = "%check a_region = sp.And(k1 > 0, k1*k2 > 1)"


def main():
    if "--frames" not in sys.argv:
        start_times()
    frame_formats()
    frames_in_kernel()
    frames_in_browser()


def start_times():
    workbook_runs, jupyter_runs = [], []
    for _ in range(RUNS):  # in turns, so that both meet the same machine
        workbook_runs.append(time_lecture(live))
        jupyter_runs.append(time_lecture(lab))
    for what in ("first cell", "first picture", "check"):
        workbook_time = median(run[what] for run in workbook_runs)
        jupyter_time = (
            median(run[what] for run in jupyter_runs) if what in jupyter_runs[0] else None
        )
        print(
            f"{what:14} workbook live {workbook_time:6.2f} s"
            + (
                f"   jupyter lab {jupyter_time:6.2f} s   {jupyter_time / workbook_time:5.1f} times"
                if jupyter_time
                else ""
            )
        )
    if os.geteuid() == 0 and drop_file_caches():
        print(f"first cell, cold: workbook live {time_lecture(live)['first cell']:6.2f} s")
        drop_file_caches()
        print(f"first cell, cold: jupyter lab  {time_lecture(lab)['first cell']:6.2f} s")


#: Explorers that the kernel draws, with the parameters that are moved.
EXPLORERS = {
    "phase_portrait 1.4": "epsilon",
    "distance_to_unobservable": "alpha",
    "manual_control": None,
}
FRAMES = 40


def frames_in_kernel():
    """Core-seconds of one frame, by a slider and by the pointer, and of opening the explorer."""
    from workbook.live.explorers import explore

    print(
        "\nexplorer                 opens       by slider   by pointer   (core-seconds in the "
        "kernel)"
    )
    for arguments, parameter in EXPLORERS.items():
        began = time.process_time()
        explorer = explore(arguments)
        opened = time.process_time() - began
        by_slider = "-"
        if parameter:
            control = explorer.controls[parameter]
            positions = [
                type(control.value)(control.min + (control.max - control.min) * (k + 0.5) / FRAMES)
                for k in range(FRAMES)
            ]
            seconds_of_frame = core_seconds(
                explorer, lambda position: setattr(control, "value", position), positions
            )
            by_slider = f"{seconds_of_frame * 1e3:.1f} ms"
        by_pointer = "-"
        if explorer.follows_pointer:
            positions = [
                f"{k} {0.2 + 0.2 * k / FRAMES:.4f} {0.3 + 0.4 * k / FRAMES:.4f}"
                for k in range(FRAMES)
            ]
            moves = core_seconds(
                explorer, lambda position: setattr(explorer._pointer, "value", position), positions
            )
            by_pointer = f"{moves * 1e3:.1f} ms"
        print(f"{arguments:22} {opened:6.2f} s {by_slider:>14} {by_pointer:>12}")


def core_seconds(explorer, move, positions):
    """Of a frame, or nan where the moves draw none."""
    move(positions[0])
    frames, began = explorer.frames, time.process_time()
    for position in positions[1:]:
        move(position)
    return (
        (time.process_time() - began) / (explorer.frames - frames)
        if explorer.frames > frames
        else float("nan")
    )


def frame_formats():
    """Time the formats of one picture, drawn whole and by its moving parts."""
    import io

    from PIL import Image

    from workbook.live.explorers import explore

    explorer = explore("phase_portrait 1.4")
    figure, canvas = explorer.figure.figure, explorer.figure._canvas
    picture = Image.frombuffer(
        "RGBA", canvas.get_width_height(), canvas.buffer_rgba(), "raw", "RGBA", 0, 1
    )

    def saved(form, **options):
        file = io.BytesIO()
        picture.convert("RGB").save(file, form, **options)
        return len(file.getvalue())

    def whole(form):
        file = io.BytesIO()
        figure.savefig(file, format=form)
        return len(file.getvalue())

    ways = {
        "moving parts, JPEG (ours)": lambda: len(explorer.figure.frame()),
        "of this the JPEG": lambda: saved("jpeg", quality=93, subsampling=0),
        "the PNG instead": lambda: saved("png", compress_level=1),
        "the BMP instead": lambda: saved("bmp"),
        "whole figure, PNG": lambda: whole("png"),
        "whole figure, SVG": lambda: whole("svg"),
    }
    for name, way in ways.items():
        runs = 3 if "whole" in name else 20
        size = way()
        began = time.process_time()
        for _ in range(runs):
            way()
        print(
            f"{name:26} {(time.process_time() - began) / runs * 1e3:7.1f} ms {size / 1e3:7.0f} kB"
        )


def frames_in_browser():
    """Count the frames that a page loads in a second while a pointer moves over it."""
    sys.path.insert(0, str(ROOT / "tests" / "browser"))
    from chromium import Browser
    from selenium.webdriver import ActionChains
    from selenium.webdriver.common.keys import Keys

    if not (shutil.which("chromium") and shutil.which("chromedriver")):
        return
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        process, port, token, path = live(Path(folder))
        browser = Browser(
            shutil.which("chromium"), shutil.which("chromedriver"), f"{folder}/profile"
        )
        try:
            for arguments in EXPLORERS:
                notebook = call(port, token, f"/api/contents/{path}")["content"]
                notebook["cells"] = [
                    {
                        "cell_type": "code",
                        "id": "one",
                        "execution_count": None,
                        "metadata": {},
                        "outputs": [],
                        "source": f"%explore {arguments}",
                    }
                ]
                call(
                    port,
                    token,
                    f"/api/contents/{path}",
                    {"type": "notebook", "content": notebook},
                    "PUT",
                )
                browser.open("about:blank")
                browser.open(f"http://127.0.0.1:{port}/doc/tree/{path}?token={token}&reset")
                idle = "document.querySelector('.jp-Notebook-ExecutionIndicator')?.dataset.status === 'idle'"
                browser.wait_for(
                    "document.querySelector('.jp-NotebookPanel .cm-content')?.offsetParent", 60
                )
                browser.wait_for(idle, 60)
                time.sleep(2)
                browser.find(".jp-NotebookPanel .jp-CodeCell .cm-content").click()
                ActionChains(browser.driver).key_down(Keys.SHIFT).send_keys(Keys.ENTER).key_up(
                    Keys.SHIFT
                ).perform()
                browser.wait_for(
                    "document.querySelector('.workbook-figure img')?.naturalWidth > 100", 60
                )
                browser.wait_for(idle, 60)
                print(
                    f"{arguments:22} {browser.driver.execute_async_script(COUNT_FRAMES):5.1f} frames a "
                    "second in the browser"
                )
        finally:
            browser.driver.quit()
            end(process)


#: Moves a pressed pointer over the layer for four seconds, or the slider where the pointer does
#: nothing.
COUNT_FRAMES = """
const done = arguments[0], layer = document.querySelector('.workbook-layer');
const image = document.querySelector('.workbook-figure img'), box = image.getBoundingClientRect();
const handle = document.querySelector('.workbook-explorer .noUi-handle'), began = performance.now();
let frames = 0;
image.addEventListener('load', () => frames++);
function step() {
  const t = (performance.now() - began)/1000;
  if (t > 4) return done(frames/4);
  if (layer) {
    layer.stroke = [];
    layer.dispatchEvent(new PointerEvent('pointermove', {bubbles: true, buttons: 1,
      clientX: box.left + (0.25 + 0.15*Math.sin(3*t))*box.width,
      clientY: box.top + (0.45 + 0.25*Math.cos(2*t))*box.height}));
  } else {
    handle.dispatchEvent(new KeyboardEvent('keydown', {key: t % 2 < 1 ? 'ArrowRight' : 'ArrowLeft'}));
  }
  requestAnimationFrame(step);
}
step();"""


def drop_file_caches():
    try:
        os.sync()
        Path("/proc/sys/vm/drop_caches").write_text("3")
    except OSError:
        return False
    return True


def time_lecture(start):
    with TemporaryDirectory() as folder:
        began = time.perf_counter()
        process, port, token, path = start(Path(folder))
        try:
            session = call(
                port,
                token,
                "/api/sessions",
                {"path": path, "name": path, "type": "notebook", "kernel": {"name": "python3"}},
            )
            address = f"ws://127.0.0.1:{port}/api/kernels/{session['kernel']['id']}/channels?token={token}"
            kernel = websocket.create_connection(address, timeout=120)
            run(kernel, IMPORTS + DATA)
            times = {"first cell": time.perf_counter() - began}
            times["first picture"] = seconds(run, kernel, PICTURE)
            if start is live:
                times["check"] = seconds(run, kernel, CHECK)
            kernel.close()
        finally:
            end(process)
    return times


def end(process):
    process.send_signal(signal.SIGTERM)
    process.wait(60)
    process.stdout.close()


def seconds(function, *arguments):
    began = time.perf_counter()
    function(*arguments)
    return time.perf_counter() - began


def live(folder):
    process = subprocess.Popen(
        [sys.executable, "-m", "workbook.cli", "live", "1.15", "--no-browser", "--discard"],
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        text=True,
    )
    match = re.search(r"127\.0\.0\.1:(\d+)/\S*token=(\w+)", process.stdout.readline())
    return process, match[1], match[2], "1.15.ipynb"


def lab(folder):
    token = secrets.token_hex(8)
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    (folder / "1.15.ipynb").write_bytes((ROOT / "exercises" / "ch1" / "p15.ipynb").read_bytes())
    process = subprocess.Popen(
        [
            sys.executable,
            "-m",
            "jupyterlab",
            "--no-browser",
            f"--port={port}",
            "--allow-root",
            f"--ServerApp.root_dir={folder}",
            f"--IdentityProvider.token={token}",
        ],
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )
    end = time.monotonic() + 120
    while time.monotonic() < end:
        try:
            call(port, token, "/api/status")
            break
        except OSError:
            time.sleep(0.02)
    return process, port, token, "1.15.ipynb"


def call(port, token, path, body=None, method=None):
    request = urllib.request.Request(
        f"http://127.0.0.1:{port}{path}",
        json.dumps(body).encode() if body else None,
        {"Authorization": f"token {token}", "Content-Type": "application/json"},
        method=method,
    )
    with urllib.request.urlopen(request, timeout=120) as answer:
        return json.load(answer)


def run(kernel, source):
    """Run a cell to its end; what it said of an error ends the benchmark."""
    message_id = uuid.uuid4().hex
    kernel.send(
        json.dumps(
            {
                "header": {
                    "msg_id": message_id,
                    "username": "",
                    "session": "benchmark",
                    "msg_type": "execute_request",
                    "version": "5.3",
                    "date": "",
                },
                "parent_header": {},
                "metadata": {},
                "channel": "shell",
                "content": {
                    "code": source,
                    "silent": False,
                    "store_history": True,
                    "user_expressions": {},
                    "allow_stdin": False,
                    "stop_on_error": True,
                },
                "buffers": [],
            }
        )
    )
    left = {"execute_reply", "idle"}
    while left:
        message = json.loads(kernel.recv())
        if message["parent_header"].get("msg_id") == message_id:
            if message["msg_type"] == "error":
                sys.exit("\n".join(message["content"]["traceback"]))
            left -= {message["msg_type"], message["content"].get("execution_state")}


if __name__ == "__main__":
    main()
