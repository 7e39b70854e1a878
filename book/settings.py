"""What counts from the start of the interpreter, or when a library is loaded; so it loads nothing
itself."""

import os

#: Pages are executed side by side, outputs should not depend on the order of a set, and pictures
#: belong into the page.
SETTINGS = {
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
    "PYTHONHASHSEED": "0",
    "MPLBACKEND": "module://matplotlib_inline.backend_inline",
}
CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
