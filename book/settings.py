"""Settings of the processes that execute pages.

They are read at the start of the interpreter or of a library, so this module loads no library.
"""

import os

#: Pages are executed in parallel, outputs must not depend on the order of a set, and pictures belong
#: in the page.
SETTINGS = {
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
    "PYTHONHASHSEED": "0",
    "MPLBACKEND": "module://matplotlib_inline.backend_inline",
}
CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
