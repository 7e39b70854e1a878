"""The notebook that runs this process, if one does."""

import sys


def runs_in_notebook():
    """Return whether the output goes to a notebook."""
    # A notebook's kernel has imported IPython.
    ipython = sys.modules.get("IPython")
    return ipython is not None and getattr(ipython.get_ipython(), "kernel", None) is not None
