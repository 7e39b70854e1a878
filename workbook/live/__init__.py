"""Lectures with live code: a problem or a lecture in JupyterLab, before a class.

`present` opens a copy that may be thrown away. Its kernels are forked from a process that has
imported everything, and they load this module as an IPython extension with the magics. All of it
needs a checkout of the workbook, which holds the worked solutions.
"""

from trajlib._lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(
    __name__,
    {
        "errors": ["LiveError"],
        "presentations": ["find_presentation", "lectures"],
        "presenting": ["present"],
        "explorers": [
            "region_of_stability",
            "phase_portrait",
            "pole_zero_cancellation",
            "distance_to_unobservable",
            "fastest_motion",
            "circle_synthesis",
            "manual_control",
            "explore",
        ],
    },
)


def load_ipython_extension(shell):
    """Register the magics of a lecture in an IPython shell."""
    from workbook.live.magics import LectureMagics  # loads ipywidgets
    from workbook.live.preparing import prepare_once

    lecture = LectureMagics(shell)
    shell.register_magics(lecture)
    shell.events.register("post_run_cell", lecture.after_cell)
    prepare_once(lecture)
