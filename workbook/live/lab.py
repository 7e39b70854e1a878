"""JupyterLab's server for one lecture, in a process of its own.

    python -m workbook.live.lab FOLDER PORT

`FOLDER` holds the notebook (copy/) and the settings of this lecture; the lecturer's own JupyterLab
is neither read nor changed. The server prints a line when it is ready, and stops when its standard
input closes.
"""

import itertools
import json
import os
import shutil
import sys
import threading
from importlib.util import find_spec
from pathlib import Path

from workbook.live.kernel_forkserver import skip_rfc3987_grammars

#: Shift+Enter selects the next cell when the cell has run, so that a cell inserted by a magic is next.
#: JupyterLab's own command for this passes over folded cells.
RUN_THEN_DOWN = {"commands": ["notebook:run-cell", "workbook:next-cell"]}
#: Settings by plugin: Shift+Enter (on slides labextension/ does it), large fonts for a projector.
SETTINGS = {
    "@jupyterlab/shortcuts-extension/shortcuts": {
        "shortcuts": [
            # on slides it would go on to the next one before anybody has seen the result
            {
                "command": "RISE:smart-exec",
                "keys": ["Shift Enter"],
                "selector": ".lm-Widget.reveal .jp-Notebook:focus",
                "disabled": True,
            },
        ]
        + [
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
    # %catchup reads what is saved, and the notebook is a copy
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
#: Installed extensions of the page that a lecture needs. Others slow it down, and some of them fail
#: on the page of slides.
PAGE_EXTENSIONS = ("@jupyter-widgets/jupyterlab-manager", "jupyterlab-rise")
#: Extensions of JupyterLab itself that a lecture does not need, or that slow it down.
DISABLED_EXTENSIONS = (
    "@jupyterlab/cell-toolbar-extension",
    "@jupyterlab/debugger-extension",
    "@jupyterlab/extensionmanager-extension",
    "@jupyterlab/apputils-extension:announcements",
)
#: Extensions of the server that a lecture needs; each other one slows down the start.
SERVER_EXTENSIONS = ("jupyterlab", "jupyterlab_rise")
IPYTHON_CONFIG = """\
c.InteractiveShellApp.extensions = ["workbook.live"]
c.HistoryManager.enabled = False
c.InlineBackend.figure_formats = {"retina"}
"""


def write_settings(folder):
    """Write the settings of the lecture's JupyterLab and kernels and return their environment.

    Parameters
    ----------
    folder : pathlib.Path
        The folder of the lecture.

    Returns
    -------
    dict of str
        Environment variables that point to the settings.
    """
    from jupyter_core.paths import jupyter_path  # commands without a lecture do not need it

    for name, settings in SETTINGS.items():
        plugin, _, part = name.rpartition("/")
        path = folder / "settings" / plugin / f"{part}.jupyterlab-settings"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(settings), encoding="utf-8")
    page = folder / "config" / "labconfig" / "page_config.json"
    page.parent.mkdir(parents=True)
    page.write_text(
        json.dumps({"disabledExtensions": dict.fromkeys(DISABLED_EXTENSIONS, True)}),
        encoding="utf-8",
    )
    extensions = folder / "data" / "labextensions"
    shutil.copytree(Path(__file__).with_name("labextension"), extensions / "workbook-live")
    for name in PAGE_EXTENSIONS:
        installed = (Path(path) / name for path in jupyter_path("labextensions"))
        for path in itertools.islice(filter(Path.is_dir, installed), 1):
            shutil.copytree(path, extensions / name)
    profile = folder / "ipython" / "profile_default"
    profile.mkdir(parents=True)
    (profile / "ipython_config.py").write_text(IPYTHON_CONFIG, encoding="utf-8")
    subfolders = {
        "JUPYTERLAB_SETTINGS_DIR": "settings",
        "JUPYTERLAB_WORKSPACES_DIR": "workspaces",
        "JUPYTER_CONFIG_DIR": "config",
        "JUPYTER_RUNTIME_DIR": "runtime",
        "JUPYTER_DATA_DIR": "data",
        "IPYTHONDIR": "ipython",
    }
    return {variable: str(folder / name) for variable, name in subfolders.items()}


def serve(folder, port):
    """Run the server until its standard input closes."""
    skip_rfc3987_grammars()
    from jupyterlab.labapp import LabApp
    from traitlets.config import Config

    from workbook.live.provisioning import register_provisioner

    register_provisioner()
    disabled = dict.fromkeys(
        (
            "jupyter_lsp",
            "jupyter_server_terminals",
            "jupyterlab_jupytext",
            "notebook",
            "notebook_shim",
            "nbclassic",
            *_nbgrader_extensions(),
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
        jpserver_extensions=disabled
        | {name: True for name in SERVER_EXTENSIONS if find_spec(name)},
        allow_root=True,
        terminals_enabled=False,
        preferred_dir=str(folder / "copy"),
    )
    config.LabApp.update(news_url=None, extension_manager="readonly", expose_app_in_browser=True)
    for app in (config.LabApp, config.RiseApp):
        app.labextensions_path = [str(folder / "data" / "labextensions")]
    config.FileContentsManager.delete_to_trash = False
    server = LabApp.initialize_server(argv=[], config=config)
    loop = server.io_loop

    def stop_with_parent():
        sys.stdin.buffer.raw.read()  # until it closes
        loop.add_callback(server.stop)

    # a thread, since the loop of Windows cannot wait for a pipe
    threading.Thread(target=stop_with_parent, daemon=True).start()
    loop.add_callback(lambda: print("ready", flush=True))
    server.start()


def _nbgrader_extensions():
    return [
        f"nbgrader.server_extensions.{name}"
        for name in ("formgrader", "validate_assignment", "assignment_list", "course_list")
    ]


if __name__ == "__main__":
    os.chdir(sys.argv[1])
    serve(Path(sys.argv[1]), int(sys.argv[2]))
