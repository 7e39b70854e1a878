"""What a run of the grader is told."""

from dataclasses import dataclass, field
from pathlib import Path

from workbook.grading.pool.judging import Bounds
from workbook.grading.sandbox.limits import Limits


@dataclass(frozen=True)
class GradingOptions:
    """What `workbook grade` is told.

    Parameters
    ----------
    submitted, out : path
        Folders of submissions and of results.
    assignment_folder : path or None
        Folder of the assignment files.
    processes : int or None
        Notebooks graded at the same time; by default as many as processors.
    limits, bounds : Limits, Bounds
        Those of running and of judging a notebook.
    trusting : bool
        Whether notebooks run without a sandbox.
    wasm : bool
        Whether notebooks run in WebAssembly, not in bubblewrap.
    quiet : bool
        Whether nothing is printed.
    roster : path or None
        The students of the class: a gradebook exported from Canvas, or any other table of them.
    site : str
        Address of the student edition of the site.
    cluster : dict or None
        The options (address, ca_file, cert, key) of a `cluster.coordinator.Cluster` that grades.
    review : bool
        Whether a page for grading by hand is served afterwards.
    by : str
        Who gives points on that page.
    """

    submitted: Path
    out: Path
    assignment_folder: Path | None = None
    processes: int | None = None
    limits: Limits = field(default_factory=Limits)
    bounds: Bounds = field(default_factory=Bounds)
    trusting: bool = False
    wasm: bool = False
    quiet: bool = False
    roster: Path | None = None
    site: str = ""
    cluster: dict | None = None
    review: bool = False
    by: str = ""
