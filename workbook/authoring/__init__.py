"""Masters: two files say everything about a problem, its page (solutions/ch1/p15.md) and its trials
beside it.

`read` gives the master with its cells by role and its trials, `student_notebook` converts it to the
students' copy.
"""

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(
    __name__,
    {
        "scaffold": ["begin"],
        "errors": ["MasterError"],
        "master": ["Answer", "Cell", "Master", "master_paths", "read", "read_all"],
        "trials": ["Trial"],
        "student_notebook": ["student_notebook", "write_exercises"],
        "links": ["Links"],
    },
)
