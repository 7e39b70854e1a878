"""Master notebooks: one MyST Markdown file says everything about a problem (solutions/ch1/p15.md).

`read` gives the master with its cells by role, `student_notebook` converts it to the copy that students receive.
"""

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(__name__, {
    "reading": ["Answer", "Cell", "Master", "MasterError", "master_paths", "read", "read_all"],
    "converting": ["student_notebook", "write_exercises"],
    "links": ["Links"],
})
