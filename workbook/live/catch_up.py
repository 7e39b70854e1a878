"""Read the cells above the running one, for `%catchup`, from the saved notebook."""

import json
import os
from pathlib import Path

from workbook.live.errors import LiveError


def cells_above(shell):
    """Return the sources of the code cells above the running one, in order.

    Raises
    ------
    LiveError
        If the running cell is not one of a saved notebook.
    """
    request = shell.kernel.get_parent() if getattr(shell, "kernel", None) else {}
    cell_id = (request.get("metadata") or {}).get("cellId")
    path = Path(os.environ.get("JPY_SESSION_NAME", ""))
    if not (cell_id and path.is_file()):
        raise LiveError(
            "%catchup belongs into a cell of a lecture's notebook; name an answer to work up to it"
        )
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    running = next((k for k, cell in enumerate(cells) if cell.get("id") == cell_id), None)
    if running is None:
        raise LiveError("this cell is not saved yet; press Ctrl+S and run it again")
    return ["".join(cell["source"]) for cell in cells[:running] if cell["cell_type"] == "code"]
