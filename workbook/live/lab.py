"""JupyterLab's server for one lecture, in a process of its own.

    python -m workbook.live.lab FOLDER PORT

`FOLDER` holds the copy (copy/) and settings of this lecture alone: nothing of the lecturer's own
JupyterLab is read or changed. It ends when its standard input does, and writes a line as soon as it
answers.
"""

import json
import os
import shutil
import sys
from pathlib import Path

from workbook.live.kernels import without_grammars

#: Shift+Enter goes on when the cell has run, not before: then what a magic puts below it is the
#: next cell.
RUN_THEN_DOWN = {"commands": ["notebook:run-cell", "notebook:move-cursor-down"]}
#: Points on a projector; the last row reads them.
# on slides it is a command of labextension/
SETTINGS = {
    "@jupyterlab/shortcuts-extension/shortcuts": {
        "shortcuts": [
            shortcut
            for mode in ("edit", "command")
            for selector in [f".jp-Notebook.jp-mod-{mode}Mode"]
            for shortcut in (
                {
                    "command": "notebook:run-cell-and-select-next",
                    "keys": ["Shift Enter"],
                    "selector": selector,
                    "disabled": True,
                },
                {
                    "command": "apputils:run-all-enabled",
                    "keys": ["Shift Enter"],
                    "selector": selector,
                    "args": RUN_THEN_DOWN,
                },
            )
        ]
    },
    "@jupyterlab/apputils-extension/themes": {
        "overrides": {
            "code-font-size": "20px",
            "content-font-size1": "21px",
            "ui-font-size1": "15px",
        }
    },
    "@jupyterlab/apputils-extension/notification": {"checkForUpdates": False, "fetchNews": "false"},
    # Nothing can be spoilt here, and %catchup reads what is saved.
    "@jupyterlab/docmanager-extension/plugin": {
        "autosaveInterval": 3,
        "renameUntitledFileOnSave": False,
    },
    "@jupyterlab/notebook-extension/tracker": {
        "windowingMode": "none",
        "scrollPastEnd": True,
        "codeCellConfig": {"lineNumbers": False, "lineWrap": True},
    },
}
#: What would only stand in the way, or cost the page its time.
UNSEEN = (
    "@jupyter/nbgrader",
    "@jupyter-notebook/lab-extension",
    "jupyterlab-jupytext",
    "@jupyterlab/cell-toolbar-extension",
    "@jupyterlab/debugger-extension",
    "@jupyterlab/extensionmanager-extension",
    "@jupyterlab/apputils-extension:announcements",
)
#: What a lecture needs of all that is installed: each other one costs the start its time.
SERVED = {"jupyterlab": True, "jupyterlab_rise": True}
IPYTHON = """\
c.InteractiveShellApp.extensions = ["workbook.live"]
c.HistoryManager.enabled = False
c.InlineBackend.figure_formats = {"retina"}
"""


def furnish(folder):
    """Write the settings of the lecture's JupyterLab and of its kernels; returns their
    environment."""
    for name, said in SETTINGS.items():
        plugin, _, part = name.rpartition("/")
        path = folder / "settings" / plugin / f"{part}.jupyterlab-settings"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(said), encoding="utf-8")
    page = folder / "config" / "labconfig" / "page_config.json"
    page.parent.mkdir(parents=True)
    page.write_text(
        json.dumps({"disabledExtensions": dict.fromkeys(UNSEEN, True)}), encoding="utf-8"
    )
    shutil.copytree(
        Path(__file__).with_name("labextension"),
        folder / "data" / "labextensions" / "workbook-live",
    )
    profile = folder / "ipython" / "profile_default"
    profile.mkdir(parents=True)
    (profile / "ipython_config.py").write_text(IPYTHON, encoding="utf-8")
    places = {
        "JUPYTERLAB_SETTINGS_DIR": "settings",
        "JUPYTERLAB_WORKSPACES_DIR": "workspaces",
        "JUPYTER_CONFIG_DIR": "config",
        "JUPYTER_RUNTIME_DIR": "runtime",
        "JUPYTER_DATA_DIR": "data",
        "IPYTHONDIR": "ipython",
    }
    return {variable: str(folder / place) for variable, place in places.items()}


def serve(folder, port):
    without_grammars()
    from jupyterlab.labapp import LabApp
    from traitlets.config import Config

    from workbook.live.provisioning import take_over

    take_over()
    others = dict.fromkeys(
        (
            "jupyter_lsp",
            "jupyter_server_terminals",
            "jupyterlab_jupytext",
            "notebook",
            "notebook_shim",
            "nbclassic",
            *_graders(),
        ),
        False,
    )
    config = Config()
    config.ServerApp.update(
        root_dir=str(folder / "copy"),
        ip="127.0.0.1",
        port=port,
        port_retries=0,
        open_browser=False,
        log_level="ERROR",
        jpserver_extensions=others | {name: True for name in SERVED if _is_there(name)},
        allow_root=True,
        terminals_enabled=False,
        preferred_dir=str(folder / "copy"),
    )
    config.LabApp.update(news_url=None, extension_manager="readonly", expose_app_in_browser=True)
    config.FileContentsManager.delete_to_trash = False
    server = LabApp.initialize_server(argv=[], config=config)
    loop = server.io_loop
    loop.add_handler(sys.stdin.fileno(), lambda *_: server.stop(), loop.READ)
    loop.add_callback(lambda: print("ready", flush=True))
    server.start()


def _graders():
    return [
        f"nbgrader.server_extensions.{name}"
        for name in ("formgrader", "validate_assignment", "assignment_list", "course_list")
    ]


def _is_there(name):
    from importlib.util import find_spec

    return find_spec(name) is not None


if __name__ == "__main__":
    os.chdir(sys.argv[1])
    serve(Path(sys.argv[1]), int(sys.argv[2]))
