"""The notebook that runs this process, if one does."""

import sys


def in_notebook():
    """Whether a notebook reads what is shown."""
    # IPython is not imported for this: where there is a notebook, it is there.
    ipython = sys.modules.get("IPython")
    return ipython is not None and getattr(ipython.get_ipython(), "kernel", None) is not None
