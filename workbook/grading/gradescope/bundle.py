"""Make the archive that is uploaded to Gradescope as an autograder.

It has no solutions, as the wheel has none.
"""

import base64
import hashlib
import io
import zipfile
from importlib import metadata
from pathlib import Path

from workbook.course import FILE, PACKAGE, WORKBOOK
from workbook.grading.course import assignment as assignments
from workbook.grading.course import numbers
from workbook.grading.course.assignment import BY_HAND, AssignmentError
from workbook.grading.course.policy import Budget
from workbook.grading.course.record import put_bytes
from workbook.mistakes import mistakes_file
from workbook.notebooks import exercises
from workbook.notebooks.dependencies import PACKAGES

HERE = Path(__file__).resolve().parent
HOME = PACKAGE.parent
#: The folder of the course's problems, which `autograder` names.
COURSE = "course"
#: The date of all entries, so that equal files give an equal archive.
DATE = (2012, 1, 1, 0, 0, 0)


def make(folder, name, out):
    """Write the bundle for the homework `folder`/`name` to a file.

    Returns (the `Assignment` without points by hand, sentences on what Gradescope cannot do of it).
    """
    file = Path(folder) / name / "assignment.toml"
    homework = assignments.read(file)
    if homework.pool or file.with_name(numbers.NAME).is_file():
        raise AssignmentError(
            f"{file.parent} has {numbers.NAME} or a pool: Gradescope hands the same file to all "
            "students"
        )
    if Path(out).suffix != ".zip":
        raise AssignmentError(f"{out}: Gradescope takes a .zip")
    packed = _packed(homework.problems)
    wheel_name, wheel = _wheel(packed.pop(WORKBOOK, {}))
    course_files = {
        f"{COURSE}/{path}": content
        for home, notebooks in packed.items()
        for path, content in {
            **{path.name: path.read_bytes() for path in (home.folder / FILE, home.checks) if path},
            **notebooks,
        }.items()
    }
    put_bytes(
        Path(out),
        _zip(
            {
                "setup.sh": (HERE / "setup.sh").read_bytes(),
                "run_autograder": (HERE / "run_autograder").read_bytes(),
                "assignment.toml": file.read_bytes(),
                "constraints.txt": _constraints().encode(),
                wheel_name: wheel,
                **course_files,
            }
        ),
    )
    return homework.automatic, _left_out(homework)


def _left_out(homework):
    policy, notes = homework.policy, []
    if homework.by_hand:
        items = ", ".join(f"{n} ({worth:g})" for n, worth in homework.points[BY_HAND].items())
        notes.append(f"points by hand are given at Gradescope: {items}")
    if unknown := sorted(name for name in policy.students if "@" not in name):
        notes.append(
            "Gradescope knows students by their addresses, so extensions, exemptions and labels do "
            f"not reach {', '.join(unknown)}"
        )
    if policy.grace_days:
        notes.append(
            "Gradescope knows one homework only, so grace_days of the course are not applied there"
        )
    if policy.budget != Budget():
        notes.append(
            "[budget] does not hold there: Gradescope itself limits how long a submission may run"
        )
    if policy.due:
        notes.append(
            "set no due date there, or allow late submissions: lateness, bonus and extensions count "
            "as assignment.toml says"
        )
    return notes


def _packed(problems):
    """Return {course: {path below its folder: content}} of problems, with their mistakes."""
    packed = {}
    for problem in problems:
        notebook = exercises.notebook_path(problem)
        packed.setdefault(exercises.home_of(problem), {}).update(
            {
                f"exercises/{path.parent.name}/{path.name}": path.read_bytes()
                for path in (notebook, mistakes_file(notebook))
                if path.is_file()
            }
        )
    return packed


def _wheel(notebooks):
    """Return (name, bytes) of a wheel of trajlib and workbook as installed here, with exercises."""
    distribution = metadata.distribution("trajlib")
    info = f"trajlib-{distribution.version}.dist-info"
    files = {
        path.relative_to(HOME).as_posix(): path.read_bytes()
        for package in PACKAGES
        for path in sorted((HOME / package).rglob("*"))
        if path.is_file() and not {"__pycache__", "_exercises"} & set(path.relative_to(HOME).parts)
    }
    files |= {f"workbook/_{path}": content for path, content in notebooks.items()}
    files |= {
        f"{info}/{name}": distribution.read_text(name).encode()
        for name in ("METADATA", "entry_points.txt")
    }
    files[f"{info}/WHEEL"] = (
        b"Wheel-Version: 1.0\nGenerator: trajlib\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
    )
    records = [f"{name},sha256={_digest(data)},{len(data)}\n" for name, data in files.items()]
    files[f"{info}/RECORD"] = "".join([*records, f"{info}/RECORD,,\n"]).encode()
    return f"trajlib-{distribution.version}-py3-none-any.whl", _zip(files)


def _constraints():
    """Return pip constraints with the versions here of all requirements, for the same verdicts."""
    requirements = [
        requirement
        for requirement in metadata.distribution("trajlib").requires or ()
        if "extra ==" not in requirement or "extra == 'workbook'" in requirement.replace('"', "'")
    ]
    names = sorted(
        requirement.split(";")[0].rstrip("0123456789.,<>=!~ ") for requirement in requirements
    )
    return "".join(f"{name}=={metadata.version(name)}\n" for name in names)


def _digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


def _zip(files):
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as file:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (
                0o100755 if name in ("setup.sh", "run_autograder") else 0o100644
            ) << 16
            file.writestr(entry, data)
    return archive.getvalue()
