"""Masters: a problem is its page (solutions/ch1/p15.md) and its trials (p15.trials.py).

`read_master` returns the master with its cells by role and its trials; `write_exercises` writes the
notebooks for students.
"""

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(
    __name__,
    {
        "scaffold": ["new_course", "new_problem"],
        "proof": ["Proof", "prove"],
        "errors": ["MasterError"],
        "master": ["Answer", "Cell", "Master", "master_paths", "read_master", "read_all"],
        "trials": ["Trial"],
        "student_notebook": ["write_exercises"],
        "links": ["Links"],
    },
)
