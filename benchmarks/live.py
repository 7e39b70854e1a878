"""Start of `workbook live 1.15` against plain `jupyter lab`.

Both servers are driven as JupyterLab's page drives them: the notebook is requested, a kernel is
started, the first cell is sent to it. A cold start is the first one after the files of the
environment have left the system's cache, which needs root; without it only warm starts are timed.
The time that the browser takes to draw its page is not included.
"""

import json
import os
import re
import secrets
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
