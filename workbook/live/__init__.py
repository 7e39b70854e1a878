"""Lectures with live code: a problem or a lecture in JupyterLab, before a class.

`present` opens a copy that may be thrown away; its kernels are forked from a process that has
imported everything, and know the magics: this module is their IPython extension. All of it needs a
checkout of the workbook, where the worked solutions are.
"""

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(
    __name__,
    {
        "subjects": ["LiveError", "find", "lectures"],
        "presenting": ["present"],
        "explorers": [
            "region_of_stability",
            "phase_portrait",
            "losing_a_mode",
            "popov_distance",
            "fastest_motion",
            "circle_synthesis",
            "against_the_best",
            "explore",
        ],
    },
)


def load_ipython_extension(shell):
    from workbook.live.magics import LectureMagics

    lecture = LectureMagics(shell)
    shell.register_magics(lecture)
    shell.events.register("post_run_cell", lecture.after_cell)
