"""The tables in `cases/`, loaded once for all tests that read them."""

import importlib.util
from pathlib import Path


def _load(path):
    spec = importlib.util.spec_from_file_location(f"cases_{path.parent.name}_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


#: Theme and family -> module, such as "stability.regions".
TABLES = {
    f"{path.parent.name}.{path.stem}": _load(path)
    for path in sorted((Path(__file__).parent / "cases").glob("*/*.py"))
}
CASES = [case for table in TABLES.values() for case in table.CASES]
#: Themes whose checks look for optima and follow motions: two thirds of the time of all cases.
LONG = {"pontryagin"}
