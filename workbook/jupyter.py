"""The notebook that runs this process, if one does."""

import sys


def runs_in_notebook():
    """Return whether the output goes to a notebook."""
    # A notebook's kernel has imported IPython.
    ipython = sys.modules.get("IPython")
    return ipython is not None and getattr(ipython.get_ipython(), "kernel", None) is not None


def runs_for_a_person():
    """Return whether a person at a notebook has run the present cell.

    Programs that run notebooks (nbclient, so nbgrader and the build) declare that no input can be
    asked for; JupyterLab, Notebook and VS Code declare that it can.
    """
    if not runs_in_notebook():
        return False
    request = sys.modules["IPython"].get_ipython().kernel.get_parent("shell")
    return bool(request.get("content", {}).get("allow_stdin"))
