"""From the command to a cell that answers: `trajlib live 1.15` against plain `jupyter lab` with the same imports.

Both are driven as JupyterLab's page drives its server: the notebook is asked for, a kernel is started, the first cell
is sent to it. Cold is the first run after the files of the environment have left the system's cache, which only root
can see to; without it only warm runs are timed. The time that the browser takes to draw its page is in neither.
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
IMPORTS = ("import sympy as sp\nimport numpy as np\nimport matplotlib.pyplot as plt\nimport scipy.integrate\n"
           "from trajlib import checks, plotting, stability\nfrom trajlib.showing import show\n")
DATA = "k1, k2, s = sp.symbols('k1 k2 s', real=True)\na_poly = s**3 + k1*s**2 + k2*s + 1\na_poly\n"
PICTURE = "plotting.region(sp.And(k1 > 0, k1*k2 > 1), [k1, k2], (-2, 4), (-2, 4))\n"
JUDGED = "%check a_region = sp.And(k1 > 0, k1*k2 > 1)"


def main():
    ours, theirs = [], []
    for _ in range(RUNS):  # in turns, so that both meet the same machine
        ours.append(timed(live))
        theirs.append(timed(lab))
    for what in ("first cell", "first picture", "check"):
        mine = median(run[what] for run in ours)
        other = median(run[what] for run in theirs) if what in theirs[0] else None
        print(f"{what:14} trajlib live {mine:6.2f} s" + (f"   jupyter lab {other:6.2f} s   {other/mine:5.1f} times"
                                                         if other else ""))
    if os.geteuid() == 0 and forget_files():
        print(f"first cell, cold: trajlib live {timed(live)['first cell']:6.2f} s")
        forget_files()
        print(f"first cell, cold: jupyter lab  {timed(lab)['first cell']:6.2f} s")


def forget_files():
    try:
        os.sync()
        Path("/proc/sys/vm/drop_caches").write_text("3")
    except OSError:
        return False
    return True


def timed(start):
    with TemporaryDirectory() as folder:
        began = time.perf_counter()
        process, port, token, path = start(Path(folder))
        try:
            session = call(port, token, "/api/sessions", {"path": path, "name": path, "type": "notebook",
                                                          "kernel": {"name": "python3"}})
            place = f"ws://127.0.0.1:{port}/api/kernels/{session['kernel']['id']}/channels?token={token}"
            kernel = websocket.create_connection(place, timeout=120)
            run(kernel, IMPORTS + DATA)
            found = {"first cell": time.perf_counter() - began}
            found["first picture"] = seconds(run, kernel, PICTURE)
            if start is live:
                found["check"] = seconds(run, kernel, JUDGED)
            kernel.close()
        finally:
            process.send_signal(signal.SIGTERM)
            process.wait(60)
            process.stdout.close()
    return found


def seconds(function, *arguments):
    began = time.perf_counter()
    function(*arguments)
    return time.perf_counter() - began


def live(folder):
    process = subprocess.Popen([sys.executable, "-m", "trajlib.cli", "live", "1.15", "--no-browser", "--discard"],
                               cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True)
    found = re.search(r"127\.0\.0\.1:(\d+)/\S*token=(\w+)", process.stdout.readline())
    return process, found[1], found[2], "1.15.ipynb"


def lab(folder):
    token = secrets.token_hex(8)
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    (folder / "1.15.ipynb").write_bytes((ROOT / "exercises" / "ch1" / "p15.ipynb").read_bytes())
    process = subprocess.Popen([sys.executable, "-m", "jupyterlab", "--no-browser", f"--port={port}", "--allow-root",
                                f"--ServerApp.root_dir={folder}", f"--IdentityProvider.token={token}"],
                               cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL)
    end = time.monotonic() + 120
    while time.monotonic() < end:
        try:
            call(port, token, "/api/status")
            break
        except OSError:
            time.sleep(0.02)
    return process, port, token, "1.15.ipynb"


def call(port, token, path, body=None):
    request = urllib.request.Request(f"http://127.0.0.1:{port}{path}", json.dumps(body).encode() if body else None,
                                     {"Authorization": f"token {token}", "Content-Type": "application/json"})
    with urllib.request.urlopen(request, timeout=120) as answer:
        return json.load(answer)


def run(kernel, source):
    """Run a cell to its end; what it said of an error ends the benchmark."""
    asked = uuid.uuid4().hex
    kernel.send(json.dumps({
        "header": {"msg_id": asked, "username": "", "session": "benchmark", "msg_type": "execute_request",
                   "version": "5.3", "date": ""}, "parent_header": {}, "metadata": {}, "channel": "shell",
        "content": {"code": source, "silent": False, "store_history": True, "user_expressions": {},
                    "allow_stdin": False, "stop_on_error": True}, "buffers": []}))
    left = {"execute_reply", "idle"}
    while left:
        message = json.loads(kernel.recv())
        if message["parent_header"].get("msg_id") == asked:
            if message["msg_type"] == "error":
                sys.exit("\n".join(message["content"]["traceback"]))
            left -= {message["msg_type"], message["content"].get("execution_state")}


if __name__ == "__main__":
    main()
