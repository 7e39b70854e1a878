"""Which cells stand above the one that runs: its notebook, as it was last saved, knows."""

import json
import os
from pathlib import Path

from workbook.live.subjects import LiveError


def cells_above(shell):
    """Sources of the code cells above the running one, in order; raises `LiveError` if it is not
    saved yet."""
    asked = shell.kernel.get_parent() if getattr(shell, "kernel", None) else {}
    place, cell_id = (
        os.environ.get("JPY_SESSION_NAME", ""),
        (asked.get("metadata") or {}).get("cellId"),
    )
    if not (cell_id and Path(place).is_file()):
        raise LiveError(
            "%catchup belongs into a cell of a lecture's notebook; name an answer to work up to it"
        )
    cells = json.loads(Path(place).read_text(encoding="utf-8"))["cells"]
    here = next((k for k, cell in enumerate(cells) if cell.get("id") == cell_id), None)
    if here is None:
        raise LiveError("this cell is not saved yet; press Ctrl+S and run it again")
    return ["".join(cell["source"]) for cell in cells[:here] if cell["cell_type"] == "code"]
