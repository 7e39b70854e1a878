"""Grading on a Dask cluster: the same grades as on one machine, and no less safe.

The cluster has several processes, which the tests also kill.
"""

import concurrent.futures
import json
import os
import re
import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
import threading
import time
from contextlib import closing
from dataclasses import asdict
from functools import partial
from pathlib import Path

import distributed
import pytest

sys.path.insert(0, str(Path(__file__).parent))
from classroom import RIGHT_1_15, hand_in
from clusters import CERTIFICATES, COMMANDS, a_cluster, command_of
from guide import like
from test_nothing_lost import count, grades, outliving, submit_a_course

from workbook.grading.cluster import connection, coordinator, dask_worker
from workbook.grading.course import course
from workbook.grading.course.options import GradingOptions
from workbook.grading.pool import grader
from workbook.grading.sandbox.limits import Limits, SandboxUnavailableError
from workbook.grading.sandbox.preloading import ALWAYS
from workbook.notebooks import exercises

ROOT = Path(__file__).resolve().parents[2]
ALIKE = os.environ | {"COLUMNS": "200", "NO_COLOR": "1", "TERM": "dumb"}


@pytest.fixture(scope="module")
def dask(tmp_path_factory):
    """A scheduler and two workers with TLS, by the commands of the guide."""
    with a_cluster(tmp_path_factory.mktemp("cluster")) as made:
        for command, _ in COMMANDS:
            if command.startswith(("openssl", "for name")):
                subprocess.run(
                    ["bash", "-ec", command],
                    cwd=made.here,
                    check=True,
                    capture_output=True,
                    timeout=60,
                )
            elif command.startswith("dask scheduler"):
                made.start(command)
            elif command.startswith("dask worker"):
                made.wait_for(made.start(command), 2)
        yield made


@pytest.fixture(scope="module")
def submitted(dask):
    submit_a_course(dask.here)
    return dask.here / "submitted"


@pytest.fixture(scope="module")
def expected(submitted, tmp_path_factory):
    """The grades of one machine."""
    out = tmp_path_factory.mktemp("alone")
    course.grade(GradingOptions(submitted, out, processes=2))
    return grades(out)


def start(dask, out):
    heeding = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)
    options = () if dask.scheme == "tcp" else CERTIFICATES
    command = [
        sys.executable,
        "-m",
        "workbook.cli",
        "grade",
        "submitted",
        "--out",
        str(out),
        "--cluster",
        dask.address,
        *options,
    ]
    return subprocess.Popen(
        command,
        cwd=dask.here,
        env=ALIKE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=heeding,
    )


def wait_for_results(process, out, number):
    """Wait until so many are stored.

    The first two need no worker: they are not notebooks.
    """
    give_up = time.monotonic() + 60
    while count(out) < number and process.poll() is None and time.monotonic() < give_up:
        time.sleep(0.005)


def our_cluster(dask, **options):
    return coordinator.Cluster(
        dask.address,
        *(dask.here / name for name in ("ca.pem", "grader.pem", "grader-key.pem")),
        **options,
    )


def a_task(key, problem="1.15", answers=RIGHT_1_15):
    exercise = exercises.find(problem)
    sources = [source for _, source in exercise.code("data")] + [
        f"{name} = {text}" for name, text in answers.items()
    ]
    return grader.Task(problem, True, sources, key=key, names=list(exercise.about["answers"]))


# As on one machine


def test_the_commands_of_the_guide_grade_as_one_machine_does(dask, submitted, expected):
    (command, shown) = COMMANDS[-1]
    assert (
        command.startswith("workbook grade")
        and [known for known, _ in COMMANDS[:4]]
        and len(COMMANDS) == 5
    )
    path = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
    done = subprocess.run(
        ["bash", "-c", dask.as_here(command)],
        cwd=dask.here,
        env=ALIKE | {"PATH": path},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=120,
    )
    assert done.returncode == 0 and like(shown, done.stdout), done.stdout
    assert len(expected) == 12 and grades(dask.here / "graded") == expected
    assert not outliving(dask.grading_processes()), "grading processes are left on the workers"


@pytest.mark.slow
def test_processes_that_are_killed_cost_nothing(dask, expected, tmp_path):
    # The grader is killed,
    process = start(dask, tmp_path)
    wait_for_results(process, tmp_path, 3)
    process.kill()
    process.communicate(timeout=60)
    before = count(tmp_path)
    # then it is asked to stop,
    process = start(dask, tmp_path)
    wait_for_results(process, tmp_path, before + 1)
    assert 12 > count(tmp_path) > before >= 3, "a result was lost"
    os.killpg(process.pid, signal.SIGINT)
    _, output = process.communicate(timeout=60)
    assert process.returncode == 130 and "Traceback" not in output, output
    assert (
        output.strip().split("\n")[-1]
        == "workbook: stopped; what is graded is stored, and the same command goes on from there"
    )
    # and then a worker is killed.
    before, victim = count(tmp_path), dask.workers()[0]
    process = start(dask, tmp_path)
    wait_for_results(process, tmp_path, before + 1)
    os.kill(victim, signal.SIGKILL)
    _, output = process.communicate(timeout=120)
    assert process.returncode == 0 and "Traceback" not in output, output
    assert grades(tmp_path) == expected and victim not in dask.workers()


def test_all_processes_end_with_the_grader(dask):
    def begun():
        return {
            process_key
            for process_key in dask.grading_processes() - before
            if b"forkserver.main" in command_of(process_key[0])
        }

    before = (
        dask.grading_processes()
    )  # a killed grader's processes end by themselves, a little later
    endless = a_task(1, answers={"a_region": "[None for _ in iter(int, 1)]"})
    with closing(our_cluster(dask).grade_all([a_task(0), endless], grader.Settings())) as results:
        key, result = next(results)
        assert key == 0 and {verdict["status"] for verdict in result["verdicts"].values()} == {
            "right"
        }
        assert begun()
    assert not outliving(dask.grading_processes() - before)


# Workers that cannot grade


def copied_library(folder, path, old, new):
    """Copy both packages and the exercises with one text changed; return the folder."""
    for package in ("trajlib", "workbook"):
        shutil.copytree(
            ROOT / package, folder / package, ignore=shutil.ignore_patterns("__pycache__")
        )
    shutil.copytree(ROOT / "exercises" / "ch1", folder / "exercises" / "ch1")
    text = (folder / path).read_text(encoding="utf-8")
    assert old in text
    (folder / path).write_text(text.replace(old, new, 1), encoding="utf-8")
    return str(folder)


def test_another_library_on_a_worker_is_named_before_anything_is_graded(dask, submitted, tmp_path):
    changed = copied_library(
        tmp_path / "changed",
        "exercises/ch1/p15.ipynb",
        "checks.stability_region",
        "checks. stability_region",
    )
    worker = dask.add_worker(PYTHONPATH=changed)
    process = start(dask, tmp_path / "out")
    _, output = process.communicate(timeout=60)
    dask.remove(worker)
    assert process.returncode == 2, output
    last = output.strip().split("\n")[-1]
    assert re.fullmatch(
        r"workbook: worker tls://127.0.0.1:\d+: its problem 1.15 is another one than here: .*", last
    ), output
    assert "Traceback" not in output
    assert {row[0] for row in grades(tmp_path / "out")} == {"gil", "hal"}, (
        "whose files are no notebooks, for which no worker is asked"
    )


def test_a_worker_without_a_sandbox_refuses(dask, tmp_path):
    bare = tmp_path / "bin"
    bare.mkdir()
    for name in ("dask", "python3"):
        (bare / name).symlink_to(Path(sys.executable).parent / name)
    worker = dask.add_worker(PATH=str(bare))
    with pytest.raises(
        SandboxUnavailableError, match=r"worker tls://127.0.0.1:\d+: bubblewrap is not installed"
    ):
        next(our_cluster(dask).grade_all([a_task(0)], grader.Settings()))
    dask.remove(worker)


@pytest.mark.parametrize(
    "changes, message",
    [
        ({"sympy": "1.12"}, r"it has sympy 1\.\d+(\.\d+)?, and this machine 1\.12"),
        ({"casadi": None}, r"it has casadi 3\.\S+, and this machine \(none\)"),
        ({"workbook": "0"}, "its workbook is another one than here"),
        ({"problem 1.15": "0"}, "its problem 1.15 is another one than here"),
        ({"problem 99.1": "0"}, "its problem 99.1 is another one than here"),
        ({"problem 2.4~999": "0"}, r"2\.4~999 is not there: run `workbook variants 2\.4` in"),
    ],
)
def test_the_part_of_the_library_that_differs_is_named(changes, message, monkeypatch):
    versions = dask_worker.library_versions(["1.15"])
    monkeypatch.setattr(dask_worker, "_library_versions_now", dask_worker.library_versions)
    dask_worker._require_same_library(versions)
    with pytest.raises(dask_worker.UnfitWorkerError, match=message):
        dask_worker._require_same_library(versions | changes)


def test_the_library_that_counts_is_all_that_grades():
    """It has all modules that run and judge a notebook, and those below its checks."""
    from workbook.notebooks.dependencies import module_closure

    closure = module_closure("import workbook.grading.cluster.dask_worker")
    assert {
        f"workbook.{name}"
        for name in (
            "notebooks.cells",
            "notebooks.execution",
            "notebooks.exercises",
            "checks.contract.encoding",
            "checks.contract.verdict",
            "grading.cluster.dask_worker",
            "grading.sandbox.forked_worker",
            "grading.sandbox.forkserver",
            "grading.sandbox.framing",
            "grading.pool.grader",
            "grading.sandbox.isolation",
            "grading.pool.judging",
            "grading.sandbox.notebook_worker",
            "grading.sandbox.sandbox",
            "grading.sandbox.seccomp",
            "grading.sandbox.system_calls",
            "grading.sandbox.watchdog",
            "grading.pool.worker_pool",
        )
    } <= closure.keys()


# Hostile notebooks: the cluster's ports, its keys, its processes


REACH = """
import glob, os, socket
found = []
for port in PORTS:
    try:
        socket.create_connection(("127.0.0.1", port), timeout=1).close()
        found.append("port")
    except OSError:
        pass
for path in FILES:
    try:
        found.append("key" if "PRIVATE KEY" in open(path).read() else "")
    except OSError:
        pass
for path in glob.glob("/proc/[0-9]*/cmdline"):
    try:
        found.append("process" if b"dask" in open(path, "rb").read() else "")
    except OSError:
        pass
for number in WORKERS:
    try:
        os.kill(number, 0)
        found.append("signal")
    except OSError:
        pass
"""


@pytest.mark.parametrize("trusting", [True, False], ids=["unguarded", "guarded"])
def test_a_notebook_reaches_nothing_of_the_cluster(dask, tmp_path, trusting):
    """Without a sandbox it reaches the scheduler, the workers and their key; inside, nothing."""
    ports = [dask.port, *(int(address.rpartition(":")[2]) for address in addresses(dask))]
    facts = f"PORTS, FILES, WORKERS = {ports}, {[str(dask.here / 'worker-key.pem')]}, {dask.workers()}\n"
    path = hand_in(
        tmp_path,
        "mallory",
        "1.15",
        {"b_region": RIGHT_1_15["b_region"], "a_region": "' '.join(sorted(set(found)))"},
    )
    notebook = json.loads(path.read_text())
    position = next(
        k for k, cell in enumerate(notebook["cells"]) if cell["metadata"].get("tags") == ["answer"]
    )
    notebook["cells"].insert(
        position,
        {
            "cell_type": "code",
            "metadata": {},
            "source": facts + REACH,
            "outputs": [],
            "execution_count": None,
        },
    )
    path.write_text(json.dumps(notebook))
    course.grade(
        GradingOptions(tmp_path / "submitted", tmp_path / "out", trusting=trusting),
        cluster=our_cluster(dask),
    )
    with closing(sqlite3.connect(tmp_path / "out" / "grades.sqlite")) as database:
        ((answers, verdicts, remarks),) = database.execute(
            "SELECT answers, verdicts, remarks FROM result"
        )
    reached = set(json.loads(answers)["a_region"].replace("'", "").split())
    assert reached == ({"key", "port", "process", "signal"} if trusting else set()), (
        answers,
        remarks,
    )
    assert json.loads(verdicts)["b_region"][0] == "right"


def test_a_key_that_notebooks_could_read_is_refused(monkeypatch, tmp_path):
    class Worker:
        local_directory = str(tmp_path)

        class security:
            tls_worker_key, tls_worker_cert = "/usr/bin/env", None

    monkeypatch.setattr(distributed, "get_worker", Worker)
    with pytest.raises(
        dask_worker.UnfitWorkerError,
        match="it keeps /usr/bin/env in /usr, which every notebook can read",
    ):
        dask_worker._require_hidden_files()
    Worker.security.tls_worker_key = str(tmp_path / "key.pem")
    dask_worker._require_hidden_files()


def addresses(dask):
    security = distributed.Security(
        **{
            f"tls_{name}": str(dask.here / file)
            for name, file in (
                ("ca_file", "ca.pem"),
                ("client_cert", "grader.pem"),
                ("client_key", "grader-key.pem"),
            )
        }
    )
    with distributed.Client(dask.address, security=security, set_as_default=False) as client:
        return list(client.nthreads())


# Without certificates, and invalid options


def test_plain_tcp_works_with_a_warning(tmp_path):
    with a_cluster(tmp_path, "tcp") as plain:
        plain.start(f"dask scheduler --host 127.0.0.1 --port {plain.port} --no-dashboard")
        plain.add_worker("--no-nanny --nthreads 1")
        hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
        process = start(plain, tmp_path / "out")
        _, output = process.communicate(timeout=60)
        assert (
            process.returncode == 0
            and f"{plain.address} is not encrypted: who can reach it can read and change grades"
            in output
        )
        assert '"ada","5.00"' in (tmp_path / "out" / "hw1" / "grades.csv").read_text(
            encoding="utf-8"
        )


@pytest.mark.parametrize(
    "address, message",
    [
        (
            "scheduler",
            "scheduler is not the address of a scheduler, which looks like tls://host:8786",
        ),
        ("http://host:8786", "is not the address of a scheduler"),
        ("tls://host", "is not the address of a scheduler"),
        ("tls://:8786", "is not the address of a scheduler"),
        ("tls://host:87867", "is not the address of a scheduler"),
        ("tls://host:8786/x", "is not the address of a scheduler"),
        ("", "is not the address of a scheduler"),
        ("tls://host:8786", "needs certificates; --tls-ca-file names a file of them"),
    ],
)
def test_an_invalid_address_is_refused(address, message):
    with pytest.raises(connection.ClusterError, match=re.escape(message)):
        coordinator.Cluster(address).check()


def test_certificates_that_cannot_be_used_are_refused(dask, tmp_path):
    def files(ca="ca.pem", cert="grader.pem", key="grader-key.pem"):
        return coordinator.Cluster(dask.address, dask.here / ca, dask.here / cert, dask.here / key)

    files().check()
    with pytest.raises(
        connection.ClusterError, match="--tls-key .*nowhere.pem: there is no such file"
    ):
        files(key="nowhere.pem").check()
    with pytest.raises(
        connection.ClusterError, match="these certificates cannot be used: .*KEY_VALUES_MISMATCH"
    ):
        files(cert="worker.pem").check()
    subprocess.run(
        [
            "openssl",
            "req",
            "-x509",
            "-newkey",
            "ed25519",
            "-nodes",
            "-subj",
            "/CN=x",
            "-keyout",
            "key.pem",
            "-out",
            "x.pem",
        ],
        cwd=tmp_path,
        check=True,
        capture_output=True,
        timeout=60,
    )
    with pytest.raises(
        connection.ClusterError,
        match="no scheduler can be reached at tls://127.0.0.1:.*signed by the same CA",
    ):
        next(
            files(cert=tmp_path / "x.pem", key=tmp_path / "key.pem").grade_all(
                [a_task(0)], grader.Settings()
            )
        )


@pytest.mark.parametrize("seconds", [0.2, 1.5])
def test_no_server_at_the_address(monkeypatch, seconds):
    """However Dask's last attempt ended before the time was up."""
    monkeypatch.setattr(connection, "CONNECT_SECONDS", seconds)
    with pytest.raises(
        connection.ClusterError,
        match="no scheduler can be reached at tcp://127.0.0.1:1: .*refused",
    ):
        next(coordinator.Cluster("tcp://127.0.0.1:1").grade_all([a_task(0)], grader.Settings()))


def test_another_server_at_the_address(tmp_path):
    """The command ends, although Dask would wait for ever for a reply."""
    hand_in(tmp_path, "ada", "1.15", RIGHT_1_15)
    shorter = (
        "from workbook import cli\nfrom workbook.grading.cluster import connection\n"
        "connection.CONNECT_SECONDS = 1\ncli.main()"
    )
    with socket.create_server(("127.0.0.1", 0)) as silent:
        address = f"tcp://127.0.0.1:{silent.getsockname()[1]}"
        done = subprocess.run(
            [
                sys.executable,
                "-c",
                shorter,
                "grade",
                "submitted",
                "--out",
                "graded",
                "--cluster",
                address,
            ],
            cwd=tmp_path,
            env=ALIKE,
            capture_output=True,
            text=True,
            timeout=100,
        )
    assert (
        done.returncode == 2
        and "something listens there, but gives no answer within 1 s" in done.stderr
        and "Traceback" not in done.stderr
    )


def test_without_dask_the_error_is_one_line(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(
        connection.ClusterError,
        match="needs Dask, which is not installed here: pip install 'trajlib.cluster.'",
    ):
        coordinator.Cluster("tls://host:8786").check()


@pytest.mark.parametrize(
    "options, message",
    [
        (("--cluster", "nowhere"), "nowhere is not the address of a scheduler"),
        (("--cluster", "tcp://127.0.0.1:1", "--processes", "2"), "--processes is for this machine"),
        (("--tls-key", "x"), "--tls-ca-file, --tls-cert and --tls-key are for --cluster"),
    ],
)
def test_bad_options_end_in_one_line_and_code_2(tmp_path, options, message):
    (tmp_path / "submitted").mkdir()
    done = subprocess.run(
        [sys.executable, "-m", "workbook.cli", "grade", "submitted", "--out", "graded", *options],
        cwd=tmp_path,
        env=ALIKE,
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert (
        done.returncode == 2
        and message in done.stderr
        and len(done.stderr.strip().split("\n")) == 1
    ), done.stderr
    assert not (tmp_path / "graded").exists()


def test_grading_on_one_machine_loads_nothing_of_dask():
    code = (
        "import sys, workbook.cli, workbook.grading.commands, workbook.grading.pool.worker_pool, "
        "workbook.grading.sandbox.notebook_worker, workbook.grading.cluster.coordinator\n"
        "print([name for name in sys.modules if name.split('.')[0] in ('dask', 'distributed')])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.stdout.strip() == "[]", done


# Inside a worker


def test_a_worker_process_ends_with_its_thread_and_not_with_others(monkeypatch):
    """The kernel's death signal comes when the thread that started the child ends."""
    monkeypatch.setattr(dask_worker, "_require_same_library", lambda expected: None)
    monkeypatch.setattr(dask_worker, "_require_hidden_files", lambda: None)
    settings = grader.Settings(modules={"notebooks": ALWAYS, "checks": []})
    order = json.dumps(
        {"run": "x", "library": {}, "workers": 1, "settings": asdict(settings)}
    ).encode()
    with concurrent.futures.ThreadPoolExecutor(1) as lasting:
        assert lasting.submit(dask_worker.prepare, order).result() == b"{}"
        (worker,) = dask_worker._all
        passing = threading.Thread(target=dask_worker.prepare, args=(order,))
        passing.start()
        passing.join(timeout=60)
        (other,) = dask_worker._all - {worker}
        give_up = time.monotonic() + 60
        while other.alive() and time.monotonic() < give_up:
            time.sleep(0.01)
        assert worker.alive() and not other.alive()
        # Arguments and results are bytes; the worker process is the same one, and the result has
        # its limits.
        reply = json.loads(lasting.submit(dask_worker.grade, order, a_task(0).to_json()).result())
        assert (
            reply["result"]["final"] == "yes"
            and reply["limits"]["memory_megabytes"] <= Limits().memory_megabytes
        )
        assert worker.alive() and dask_worker._all == {worker, other}
        dask_worker._end_run("x")
        assert not worker.alive() and not dask_worker._all
        # A worker that was slow to start finds that the run has ended.
        assert (
            b"the run has ended" in lasting.submit(dask_worker.prepare, order).result()
            and not dask_worker._all
        )
