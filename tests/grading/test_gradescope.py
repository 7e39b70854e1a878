"""The Gradescope bundle, in a container like Gradescope's.

Its /autograder is a folder of the test's, root is root. setup.sh runs there as it would at
Gradescope, except that pip finds the libraries as wheels made of those installed here, not on the
network, and that the system's own programs (apt-get, useradd) only record their arguments.
"""

import base64
import csv
import hashlib
import io
import json
import os
import shutil
import socket
import stat
import subprocess
import sys
import zipfile
from datetime import datetime
from importlib import metadata
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

sys.path.insert(0, str(Path(__file__).parent))
from classroom import RIGHT_1_15, notebook, write_assignment

from workbook.authoring import read_all, read_master
from workbook.authoring.mistakes import mistake_sentence
from workbook.cli import app
from workbook.grading.course import assignment as assignments
from workbook.grading.course.assignment import AssignmentError
from workbook.grading.gradescope import autograder, bundle
from workbook.numbering import read_number

HOMEWORK = (
    'title = "Homework 1"\nproblems = ["1.15", "1.17"]\ndue = 2020-01-01T00:00:00Z\nattempts = '
    '3\n[points]\n"1.15" = 10\n'
)
HALF = RIGHT_1_15 | {"a_region": "k1 > 0"}
#: A user id that is free on this machine.
STUDENT = 61234
PYTHON = f"python3.{sys.version_info.minor}"
USER_ADDED = "useradd --system --no-create-home --shell /usr/sbin/nologin workbook-student\n"


@pytest.fixture(scope="module")
def archive(tmp_path_factory):
    folder = tmp_path_factory.mktemp("homework")
    write_assignment(folder, HOMEWORK)
    bundle.make(folder / "assignments", "hw1", folder / "bundle.zip")
    return folder / "bundle.zip"


# The bundle


def test_contents_of_the_bundle(archive):
    with zipfile.ZipFile(archive) as bundled:
        assert sorted(bundled.namelist()) == sorted(
            [
                "setup.sh",
                "run_autograder",
                "assignment.toml",
                "constraints.txt",
                wheel_name(bundled),
            ]
        )
        for name in ("setup.sh", "run_autograder"):
            assert stat.S_IMODE(bundled.getinfo(name).external_attr >> 16) == 0o755
            assert bundled.read(name).startswith(b"#!/usr/bin/env bash\n")
            subprocess.run(["bash", "-n"], input=bundled.read(name), check=True, timeout=30)
        assert (
            "sympy==" in bundled.read("constraints.txt").decode()
            and "trajlib" not in bundled.read("constraints.txt").decode()
        )
        with zipfile.ZipFile(io.BytesIO(bundled.read(wheel_name(bundled)))) as wheel:
            names = wheel.namelist()
            assert {name for name in names if name.endswith(".ipynb")} == {
                "workbook/_exercises/ch1/p15.ipynb",
                "workbook/_exercises/ch1/p17.ipynb",
            }
            assert "workbook/grading/gradescope/autograder.py" in names
            assert {
                name.replace(".ipynb", ".mistakes") for name in names if name.endswith(".ipynb")
            } <= set(names)
            assert not any(
                "solutions/" in name or name.endswith((".md", ".trials.py")) for name in names
            )
            (record,) = [name for name in names if name.endswith("RECORD")]
            listed = {
                row[0]: row[1] for row in csv.reader(io.StringIO(wheel.read(record).decode()))
            }
            assert set(listed) == set(names)
            for name, recorded in listed.items():
                digest = (
                    base64.urlsafe_b64encode(hashlib.sha256(wheel.read(name)).digest())
                    .rstrip(b"=")
                    .decode()
                )
                assert name == record or recorded == f"sha256={digest}"
            text = "\n".join(wheel.read(name).decode() for name in names if name.endswith(".ipynb"))
            everything = b"\n".join(map(wheel.read, names)).decode(errors="replace")
    for number in ("1.15", "1.17"):
        for source in read_master(
            Path(__file__).resolve().parents[2] / "solutions" / read_number(number).file(".md")
        ).code("answer"):
            assert source not in text
    for master in read_all(Path(__file__).resolve().parents[2] / "solutions"):
        # Neither the value nor the sentence on it can be read anywhere.
        for trial in master.trials["wrong"]:
            value = trial.source.rpartition("\n")[2].partition("=")[2].strip()
            message = mistake_sentence(master, trial) or trial.comment
            assert message.partition("\n")[0] not in everything
            assert len(value) < 16 or f"{trial.name} = {value}" not in everything


def test_the_same_homework_makes_the_same_bundle(archive, tmp_path):
    bundle.make(archive.parent / "assignments", "hw1", tmp_path / "again.zip")
    assert (tmp_path / "again.zip").read_bytes() == archive.read_bytes()


def test_errors_of_making_a_bundle(archive, tmp_path):
    with pytest.raises(AssignmentError, match="No such file"):
        bundle.make(archive.parent / "assignments", "hw2", tmp_path / "bundle.zip")
    with pytest.raises(AssignmentError, match="takes a .zip"):
        bundle.make(archive.parent / "assignments", "hw1", tmp_path / "bundle.tar")


def wheel_name(bundled):
    (name,) = [name for name in bundled.namelist() if name.endswith(".whl")]
    return name


# Which attempt counts


@pytest.mark.parametrize(
    "rule, earlier, now, points, message",
    [
        ('attempt = "best"', [], 3.0, 3.0, ""),
        ('attempt = "best"', [5.0, 1.0], 3.0, 5.0, "1.15: an earlier attempt of yours counts: 5 p"),
        ('attempt = "best"', [2.0], 3.0, 3.0, ""),
        ('attempt = "last"', [5.0], 3.0, 3.0, ""),
        ('attempt = "last"', [5.0], None, 5.0, "1.15: an earlier attempt of yours counts: 5 p"),
        ('attempt = "best"', [None, None], 3.0, 3.0, ""),
        (
            'attempt = "best"\nattempts = 2',
            [1.0, 2.0],
            5.0,
            2.0,
            "1.15: this is attempt 3; the first 2 count: 2 points",
        ),
        (
            'attempt = "last"\nattempts = 2',
            [4.0, None, 2.0],
            5.0,
            2.0,
            "1.15: this is attempt 3; the first 2 count: 2 points",
        ),
    ],
)
@pytest.mark.parametrize("kept", [False, True])
def test_which_attempt_counts(tmp_path, rule, earlier, now, points, message, kept):
    """Nothing is said of points with an answer that only the grading judges."""
    text = f'{rule}\nproblems = ["1.15", "1.17"]\nkept_for_grading = {["1.15.e_region"] * kept}'
    homework = assignments.read(write_assignment(tmp_path, text))
    by_problem = [{"1.15": p} if p is not None else {} for p in [*earlier, now]]
    counted, sentences = autograder.counting_points(homework, by_problem[:-1], by_problem[-1])
    said = " ".join(sentences)
    assert counted == points
    if not kept:
        assert message in said and bool(message) == bool(sentences)
    else:
        assert "points" not in said and "earlier" not in said


def test_each_problem_has_its_best_attempt_as_in_a_course(tmp_path):
    homework = assignments.read(write_assignment(tmp_path, 'problems = ["1.15", "1.17"]'))
    earlier = [{"1.15": 4.0, "1.17": 0.0}, {"1.17": 1.5}]
    counted, sentences = autograder.counting_points(homework, earlier, {"1.15": 3.0, "1.17": 2.0})
    assert counted == 6 and sentences == ["1.15: an earlier attempt of yours counts: 4 points."]


POLICY = (
    'problems = ["1.15", "1.17"]\ndue = 2026-10-01T23:59:00+03:00\n[late]\nper_day = 0.1\n'
    '[early]\ndays = 7\nshare = 1.1\n[by_hand]\nsketch = {points = 2, text = "on paper"}\n'
    '[labels]\nslow = ["bob@uni.example", "cid"]\n[extensions]\nslow = 2026-10-04T23:59:00+03:00\n'
    '[exemptions]\n"ann@uni.example" = ["1.17"]\n'
)


@pytest.mark.parametrize(
    "metadata, student, submitted, earlier",
    [
        ("", "student", None, []),
        ("[]", "student", None, []),
        ('{"users": [{"email": "Ann@Uni.example"}]}', "ann@uni.example", None, []),
        (
            '{"users": [{"email": "x@uni.example"}, {"email": "bob@uni.example"}], '
            '"created_at": "2026-10-01T13:59:00.5-07:00", "previous_submissions": [1]}',
            "bob@uni.example",
            1790888340.5,
            [],
        ),
        ('{"created_at": "yesterday", "users": []}', "student", None, []),
    ],
)
def test_what_gradescope_says_of_a_submission(tmp_path, metadata, student, submitted, earlier):
    homework = assignments.read(write_assignment(tmp_path, POLICY))
    (tmp_path / "about.json").write_text(metadata)
    read = autograder.read_metadata(tmp_path / "about.json", homework.policy)
    assert read == autograder.HandIn(student, submitted, earlier)
    assert autograder.read_metadata(tmp_path / "no.json", homework.policy).student == "student"


def test_earlier_submissions_are_those_that_were_graded(tmp_path):
    homework = assignments.read(write_assignment(tmp_path, POLICY))
    graded = {
        "tests": [
            {"name": "1.15 a_region", "score": "1.5", "output": "right: it holds"},
            {"name": "1.15 b_region", "score": None, "output": "unchecked: the check failed"},
            {"name": "1.17 a_region", "score": 0, "output": autograder.NOT_TRIED[0]},
        ]
    }
    failed = {"score": 0, "output": "The grader itself failed"}
    previous = [{"results": graded}, {"results": failed}, {"results": None}]
    (tmp_path / "about.json").write_text(json.dumps({"previous_submissions": previous}))
    read = autograder.read_metadata(tmp_path / "about.json", homework.policy)
    assert read.earlier == [{"1.15": 1.5}]


@pytest.mark.parametrize(
    "student, submitted, sentences",
    [
        ("bob@uni.example", "2026-10-04T23:00:00+03:00", []),
        ("dan@uni.example", "2026-10-02T23:00:00+03:00", ["1 day after the due date"]),
        ("dan@uni.example", "2026-09-20T23:00:00+03:00", ["right answers have 1.1 times"]),
        ("dan@uni.example", None, ["not known when"]),
        ("ann@uni.example", "2026-10-01T23:00:00+03:00", ["Not asked of you: 1.17;"]),
    ],
)
def test_the_policy_is_told(tmp_path, student, submitted, sentences):
    homework = assignments.read(write_assignment(tmp_path, POLICY)).automatic
    seconds = datetime.fromisoformat(submitted).timestamp() if submitted else None
    notes = autograder.policy_notes(homework, autograder.HandIn(student, seconds, []))
    assert len(notes) == len(sentences)
    assert all(words in note for words, note in zip(sentences, notes))


def test_what_gradescope_cannot_do_is_named(tmp_path, capsys):
    policy = POLICY.replace("due =", "grace_days = 3\nbudget.notebooks = 9\ndue =", 1)
    assert policy != POLICY
    write_assignment(tmp_path, policy)
    command = ["assignment", "gradescope", "hw1", "--out", str(tmp_path / "b.zip")]
    app([*command, "--assignments", str(tmp_path / "assignments")], standalone_mode=False)
    output = capsys.readouterr().out
    assert "an autograder for hw1, 7 points;" in output
    for words in (
        "points by hand are given at Gradescope: sketch (2)",
        "extensions, exemptions and labels do not reach cid\n",
        "allow late submissions: lateness, bonus and extensions count as assignment.toml says",
        "grace_days of the course are not applied there",
        "[budget] does not hold there",
    ):
        assert words in output


def test_the_limits_of_all_notebooks_fit_gradescopes_timeout():
    for count in (0, 1, 3, 10):
        limits, bounds = autograder._limits(count)
        # Judging at most: the whole notebook three times its bound on the clock; answers alone are
        # rare.
        assert max(count, 1) * (limits.wall_seconds + 3 * bounds.seconds) <= autograder.SECONDS + 1


# In the container


def as_root():
    """Return the prefix that runs a command as root: nothing, or sudo without a password."""
    if os.getuid() == 0:
        return []
    if (
        shutil.which("sudo")
        and subprocess.run(["sudo", "-n", "true"], capture_output=True, timeout=30).returncode == 0
    ):
        return ["sudo", "-n"]
    return None


@pytest.fixture(scope="module")
def installed(archive, tmp_path_factory):
    """/opt/workbook as setup.sh makes it, with the bundle's wheel and the libraries of here."""
    if shutil.which("bwrap") is None or as_root() is None:
        (pytest.fail if os.environ.get("CI") == "true" else pytest.skip)(
            "the mock container needs bubblewrap and root"
        )
    folder, outside = tmp_path_factory.mktemp("opt"), tmp_path_factory.mktemp("outside")
    wheels = tmp_path_factory.mktemp("wheels")
    folder.chmod(0o755)  # as a folder in /opt is
    for name in sorted(requirements("trajlib", "workbook") - {"trajlib"}):
        put_into_wheel(metadata.distribution(name), wheels)
    programs(outside, PYTHON)
    # The real one is found behind one that only root can run.
    (outside / PYTHON).chmod(0o700)
    container = Container(outside / "autograder", folder, archive)
    done = container.run(
        "/autograder/source/setup.sh",
        writable=True,
        shown={outside, wheels},
        environment={
            "PATH": f"{outside}:{sys.base_prefix}/bin:/usr/bin:/bin",
            "PIP_NO_INDEX": "1",
            "PIP_FIND_LINKS": str(wheels),
        },
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert (outside / "log").read_text().startswith(USER_ADDED)
    assert done.stdout.endswith("a notebook can be run as the user workbook-student\n")
    shutil.rmtree(wheels)
    return folder


def requirements(distribution, extra):
    """Return a distribution and all its requirements, with one extra of its own."""
    names, waiting = set(), [distribution]
    while waiting:
        name = canonicalize_name(waiting.pop())
        if name not in names:
            names.add(name)
            environment = {"extra": extra if name == distribution else ""}
            waiting += [
                requirement.name
                for requirement in map(Requirement, metadata.distribution(name).requires or ())
                if requirement.marker is None or requirement.marker.evaluate(environment)
            ]
    return names


def put_into_wheel(distribution, folder):
    """Write an installed distribution as a wheel again.

    It lacks scripts, files beside the packages, and its own tests, which would take longest to
    compile.
    """
    about = distribution.read_text("WHEEL")
    tags = [line.removeprefix("Tag: ") for line in about.split("\n") if line.startswith("Tag: ")]
    name = canonicalize_name(distribution.name).replace("-", "_")
    with zipfile.ZipFile(folder / f"{name}-{distribution.version}-{tags[-1]}.whl", "w") as wheel:
        for file in distribution.files:
            if (
                not {"..", "tests"} & set(file.parts)
                and file.suffix != ".pyc"
                and file.name not in ("RECORD", "direct_url.json")
            ):
                wheel.write(file.locate(), file.as_posix())
        (info_folder,) = {
            file.parts[0] for file in distribution.files if file.parts[0].endswith(".dist-info")
        }
        wheel.writestr(f"{info_folder}/RECORD", "".join(f"{file},,\n" for file in wheel.namelist()))


class Container:
    """Gradescope's file system as an autograder sees it, with `/autograder` at `root`."""

    def __init__(self, root, installed, archive):
        self.root, self._installed = root, installed
        for name in ("source", "submission", "results"):
            (root / name).mkdir(parents=True)
        with zipfile.ZipFile(archive) as bundled:
            bundled.extractall(root / "source")
        shutil.copy(root / "source" / "run_autograder", root / "run_autograder")
        for path in (root / "run_autograder", root / "source" / "setup.sh"):
            path.chmod(0o755)  # extracting by Python drops the bit that the archive has
        self.metadata([])
        passwd = root.parent / "passwd"
        passwd.write_text(
            f"root:x:0:0::/root:/bin/sh\nworkbook-student:x:{STUDENT}:{STUDENT}::/:/usr/sbin/nologin\n"
        )

    def metadata(self, previous):
        about = {
            "id": 1,
            "users": [{"email": "secret@uni.example", "id": 1, "name": "Ann"}],
            "previous_submissions": previous,
        }
        (self.root / "submission_metadata.json").write_text(json.dumps(about))

    def submit(self, name, content):
        path = self.root / "submission" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(
            content if isinstance(content, str) else json.dumps(content), encoding="utf-8"
        )

    def run(
        self, *command, writable=False, shown=(), environment={"PATH": "/usr/bin:/bin:/usr/sbin"}
    ):
        """Run a command in the container and return the process.

        During setup its /opt/workbook is `writable`; more folders are `shown`, writable too.
        """
        writing, shown = (
            shown,
            {Path(sys.base_prefix), Path(os.path.realpath(sys.base_prefix)), *shown},
        )
        shown = sorted(path for path in shown if not path.is_relative_to("/usr"))
        # Folders on the way are open to all there, as in any container with its interpreter in
        # /usr.
        ways = sorted(
            {
                way
                for path in [*shown, Path("/opt/workbook")]
                for way in path.parents
                if way != Path("/")
            }
        )
        ways = [word for way in ways for word in ("--perms", "0755", "--dir", str(way))]
        binds = [
            *ways,
            *(
                word
                for path in shown
                for word in ("--bind" if path in writing else "--ro-bind", str(path), str(path))
            ),
        ]
        variables = [
            word for name, value in environment.items() for word in ("--setenv", name, value)
        ]
        return subprocess.run(
            [
                *as_root(),
                "bwrap",
                "--unshare-pid",
                "--die-with-parent",
                "--cap-add",
                "ALL",
                "--clearenv",
                *variables,
                "--ro-bind",
                "/usr",
                "/usr",
                "--symlink",
                "usr/lib",
                "/lib",
                "--symlink",
                "usr/lib64",
                "/lib64",
                "--symlink",
                "usr/bin",
                "/bin",
                "--ro-bind-try",
                "/etc/alternatives",
                "/etc/alternatives",
                "--ro-bind-try",
                "/etc/ld.so.cache",
                "/etc/ld.so.cache",
                "--ro-bind",
                str(self.root.parent / "passwd"),
                "/etc/passwd",
                "--proc",
                "/proc",
                "--dev",
                "/dev",
                "--perms",
                "1777",
                "--tmpfs",
                "/tmp",
                *binds,
                "--bind" if writable else "--ro-bind",
                str(self._installed),
                "/opt/workbook",
                "--bind",
                str(self.root),
                "/autograder",
                "--chdir",
                "/",
                *command,
            ],
            capture_output=True,
            text=True,
            timeout=300,
        )

    def grade(self):
        """Run the autograder; return its results and output."""
        done = self.run("/autograder/run_autograder")
        assert done.returncode == 0, done.stderr
        return self.results(), done

    def results(self):
        # Read as root: the autograder has closed the folder to others.
        done = subprocess.run(
            [*as_root(), "cat", str(self.root / "results" / "results.json")],
            capture_output=True,
            check=True,
            timeout=60,
        )
        return json.loads(done.stdout)


@pytest.fixture
def container(tmp_path, installed, archive):
    yield Container(tmp_path / "autograder", installed, archive)
    if os.getuid() != 0:
        subprocess.run(
            [*as_root(), "chown", "-R", str(os.getuid()), str(tmp_path)], check=True, timeout=60
        )


def test_a_submission(container):
    container.submit("ch1-p15.ipynb", notebook("1.15", HALF))
    container.submit("ch1-p17.ipynb", notebook("1.17", {}))
    container.submit("notes.ipynb", "{}")
    result, done = container.grade()
    assert done.stderr == ""
    assert result["score"] == 8 and len(result["tests"]) == 7, result["output"]
    assert [test["name"] for test in result["tests"]][:2] == ["1.15 a_region", "1.15 b_region"]
    assert [test["status"] for test in result["tests"]] == [
        "failed",
        *["passed"] * 4,
        "failed",
        "failed",
    ]
    output = result["tests"][0]["output"]
    assert output.startswith("wrong: ") and output.endswith(
        "\nThe notebook has 2 hints to this answer."
    )
    assert result["tests"][5]["output"].startswith("missing: not answered yet")
    assert "left aside: notes.ipynb" in result["output"] and 0 < result["execution_time"] < 200
    assert result["visibility"] == "visible" and result["stdout_visibility"] == "hidden"


def test_an_earlier_better_attempt_counts(container):
    tests = [{"name": "1.15 a_region", "score": 9.5, "output": "right: it holds"}]
    container.metadata([{"submission_time": "2026-01-01T00:00:00Z", "results": {"tests": tests}}])
    container.submit("folder/ch1-p15.ipynb", notebook("1.15", HALF))
    result, _ = container.grade()
    assert (
        result["score"] == 9.5
        and "1.15: an earlier attempt of yours counts: 9.5 points." in result["output"]
    )


def test_of_what_is_handed_in_at_once_one_notebook_counts(container):
    container.submit("ch1-p15 (1).ipynb", notebook("1.15", RIGHT_1_15))
    container.submit("ch1-p15.ipynb", notebook("1.15", HALF))
    result, _ = container.grade()
    assert result["score"] == 8
    assert "left aside: ch1-p15 (1).ipynb: of what is handed in at once" in result["output"]


def test_lateness_is_that_of_the_assignment(container):
    source = container.root / "source" / "assignment.toml"
    source.write_text(f"{HOMEWORK}[late]\nper_day = 0.1\n")
    about = json.loads((container.root / "submission_metadata.json").read_text())
    about["created_at"] = "2020-01-01T12:00:00Z"
    (container.root / "submission_metadata.json").write_text(json.dumps(about))
    container.submit("ch1-p15.ipynb", notebook("1.15", HALF))
    result, _ = container.grade()
    assert result["score"] == pytest.approx(0.9 * 8)
    assert "Handed in 1 day after the due date" in result["output"]


def test_a_submission_without_a_notebook(container):
    container.submit("report.txt", "my report")
    container.submit("ch1-p15.ipynb", "no notebook")
    (container.root / "submission" / "ch1-p17.ipynb").symlink_to(
        "/autograder/source/assignment.toml"
    )
    result, _ = container.grade()
    assert result["score"] == 0 and {test["output"].split(":")[0] for test in result["tests"]} == {
        "missing"
    }
    assert "the file is not a notebook" in result["output"] and "symbolic link" in result["output"]
    shutil.rmtree(container.root / "submission") if os.getuid() == 0 else None
    if os.getuid() == 0:
        (container.root / "submission").mkdir()
        assert "There is no notebook of this homework" in container.grade()[0]["output"]


@pytest.mark.parametrize("breaks", ["assignment.toml", "wheel", "user"])
def test_a_crash_of_the_grader_leaves_a_result(container, breaks):
    container.submit("ch1-p15.ipynb", notebook("1.15", RIGHT_1_15))
    (container.root / "results" / "results.json").write_text('{"score": 100}')
    if breaks == "assignment.toml":
        (container.root / "source" / "assignment.toml").write_text("broken")
    elif breaks == "wheel":
        container._installed = container.root.parent  # no /opt/workbook/bin/python
    else:
        (container.root.parent / "passwd").write_text("root:x:0:0::/root:/bin/sh\n")
    result, done = container.grade()
    assert result["score"] == 0 and "tests" not in result
    assert "The grader itself failed on this submission. That is not your fault" in result["output"]
    assert done.stderr, "the lecturer sees why"


# Attempts of a notebook: each line reports what it achieved.
ATTEMPTS = """
import os, pathlib, signal, socket, subprocess
done = []
def attempt(name, action):
    try:
        action()
        done.append(name)
    except Exception as error:
        pass
attempt("reads the homework", lambda: open("/autograder/source/assignment.toml").read())
attempt("reads who it is", lambda: open("/autograder/submission_metadata.json").read())
attempt("lists submissions", lambda: os.listdir("/autograder/submission"))
attempt("reads results", lambda: open("/autograder/results/results.json").read())
attempt("writes results", lambda: open("/autograder/results/results.json", "a").close())
attempt("writes beside results", lambda: open("/autograder/results/x", "w").close())
attempt("replaces the grader", lambda: open("/autograder/run_autograder", "a").close())
attempt("reaches the network", lambda: socket.create_connection(("127.0.0.1", PORT), timeout=5))
others = [p for p in os.listdir("/proc") if p.isdigit() and os.stat("/proc/" + p).st_uid == 0]
attempt("signals others", lambda: [os.kill(int(p), 0) for p in others][0])
attempt("reads memory of others", lambda: [open(f"/proc/{p}/mem", "rb") for p in others][0])
attempt("becomes root", lambda: os.setuid(0))
attempt("many processes", lambda: [os.fork() or (signal.pause(), os._exit(0)) for k in range(200)][199])
"""
NAMES = [
    "reads the homework",
    "reads who it is",
    "lists submissions",
    "reads results",
    "writes results",
    "writes beside results",
    "replaces the grader",
    "reaches the network",
    "signals others",
    "reads memory of others",
    "becomes root",
    "many processes",
]


@pytest.fixture
def port():
    """A server of this machine that a notebook with a network would reach."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        yield server.getsockname()[1]


def with_cell(problem, answers, source):
    submitted = notebook(problem, answers)
    submitted["cells"].append(
        {
            "cell_type": "code",
            "metadata": {},
            "outputs": [],
            "execution_count": None,
            "source": source,
        }
    )
    return submitted


def test_hostile_notebooks_fail(container, port):
    cell = ATTEMPTS.replace("PORT", str(port))
    (container.root / "results" / "results.json").write_text("{}")
    unguarded = container.run(
        "/opt/workbook/bin/python", "-c", cell + "\nprint(done, flush=True)\nos._exit(0)"
    )
    assert unguarded.stdout.strip().split("\n")[-1] == repr(NAMES), (
        "run as root each attempt succeeds, else it tests nothing"
    )
    container.submit(
        "ch1-p15.ipynb",
        with_cell("1.15", HALF, cell + "\nraise RuntimeError('achieved: ' + repr(done))"),
    )
    result, _done = container.grade()
    assert result["score"] == 8 and "RuntimeError: achieved: []" in result["output"], result[
        "output"
    ]


@pytest.mark.parametrize(
    "cell",
    [
        "import os, signal\nos.kill(os.getpid(), signal.SIGKILL)",
        "import os\nos._exit(0)",
        "import os, signal\nos.kill(-1, signal.SIGKILL)",
        "big = bytearray(4 * 2**30)\nbig[::4096] = b'x' * len(big[::4096])",
        "import sys\nsys.exit()",
    ],
)
def test_a_notebook_that_ends_itself_costs_only_itself(container, cell):
    container.submit("ch1-p15.ipynb", with_cell("1.15", RIGHT_1_15, cell))
    container.submit("ch1-p17.ipynb", notebook("1.17", {}))
    result, _ = container.grade()
    assert len(result["tests"]) == 7 and "unchecked" not in json.dumps(result)
    assert [test["output"].split(":")[0] for test in result["tests"]][5:] == ["missing", "missing"]
    assert result["score"] == (0 if "getpid" in cell or "_exit" in cell else 10), (
        "alone of its user, it cannot kill itself with all others"
    )


def test_processes_of_a_notebook_end_with_it(container):
    daemon = (
        "import os, time\nif os.fork() == 0:\n    os.setsid()\n    if os.fork() == 0:\n        "
        "time.sleep(600)\n    os._exit(0)\n"
    )
    look = (
        "import os, time\ntime.sleep(1)\n"
        "mine = [p for p in os.listdir('/proc') if p.isdigit() and os.stat('/proc/' + p).st_uid == "
        "os.getuid()]\n"
        "raise RuntimeError(f'{len(mine)} process of mine')"
    )
    container.submit("ch1-p15.ipynb", with_cell("1.15", RIGHT_1_15, daemon))
    looking = with_cell("1.17", {}, look)
    container.submit("ch1-p17.ipynb", looking)
    result, _ = container.grade()
    place = sum(cell["cell_type"] == "code" for cell in looking["cells"])
    error = f"1.17: notebook: code cell {place}: RuntimeError: 1 process of mine"
    assert result["score"] == 10 and error in result["output"], result["output"]


# setup.sh


def test_the_trial_fails_where_a_notebook_lacks_a_library(container):
    library = next(container._installed.glob("lib/python3*/site-packages/casadi"))
    library.rename(library.with_name("away"))
    try:
        done = container.run(
            "/opt/workbook/bin/python",
            "-I",
            "-c",
            "from workbook.grading.gradescope import autograder; autograder.trial()",
        )
    finally:
        library.with_name("away").rename(library)
    assert done.returncode == 1
    assert "a notebook cannot be run as the user workbook-student: " in done.stderr


@pytest.mark.parametrize(
    "has, message",
    [
        ("3.12", "python3.12 -m venv /opt/workbook"),
        ("3.11", "python3.11 -m venv /opt/workbook"),
        ("", "choose Ubuntu 22.04"),
    ],
)
def test_setup(tmp_path, archive, has, message):
    """setup.sh asks the right things of the system, and ends if it has no suitable Python."""
    log = programs(tmp_path, f"python{has}", "python3.12", "python3.11")
    (tmp_path / "setpriv").write_text('#!/bin/bash\nshift 5\nexec "$@"\n')
    (tmp_path / "id").write_text("#!/bin/bash\necho 1\n")
    # The first Python on the path is one that the student's user cannot run.
    (tmp_path / "root").mkdir()
    for version in ("3.11", "3.12"):
        (tmp_path / "root" / f"python{version}").write_text("#!/bin/bash\nexit 1\n")
    for path in (tmp_path / "setpriv", tmp_path / "id", *(tmp_path / "root").iterdir()):
        path.chmod(0o755)
    with zipfile.ZipFile(archive) as bundled:
        script = bundled.read("setup.sh").decode().replace("/opt/workbook/bin/", "echo ")
    done = subprocess.run(
        ["bash", "-c", script],
        env={"PATH": f"{tmp_path}/root:{tmp_path}:/usr/bin:/bin"},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert message in (log.read_text() if has else done.stderr) and done.returncode == (
        0 if has else 1
    )
    assert log.read_text().startswith(USER_ADDED)
    if has:
        assert (
            "install --no-cache-dir --constraint /autograder/source/constraints.txt "
            "/autograder/source/trajlib-*.whl[workbook]" in done.stdout
        )
        assert done.stdout.rstrip().endswith("autograder.trial()")


def programs(folder, has, *others):
    """Make programs that only record their arguments; apt-get has one Python, `has`."""
    apt = f'[[ "$1" == update || "$*" == *"{has} "* ]] || exit 100\n'
    for name, body in {"apt-get": apt, "useradd": "", **dict.fromkeys((has, *others), "")}.items():
        (folder / name).write_text(f'#!/bin/bash\necho "${{0##*/}} $*" >> {folder}/log\n{body}')
        (folder / name).chmod(0o755)
    return folder / "log"
