"""Wording of questions about the output of records other than x' = A x, z = H x."""

from dataclasses import replace

from workbook.checks.structure.dual_questions import OUTPUT
from workbook.systems import Measurements, WithError

BOTH = replace(
    OUTPUT,
    holds="observable together with the error",
    fails="not observable together with the error",
    free="independent pair (x(0), C) with z = 0 for all time",
    none_free="no pair (x(0), C) but zero gives z = 0 for all time",
)
STATE = replace(
    OUTPUT,
    holds="such that z determines the state",
    fails="such that z does not determine the state",
    free="independent x(0), not zero, whose motion together with some error gives z = 0",
    none_free="only x(0) = 0 can give z = 0, whatever the error",
)
AMPLITUDE = replace(
    OUTPUT,
    holds="such that z determines C",
    fails="such that z does not determine C",
    free="C, up to a factor and not zero, with z = 0 for some motion",
    none_free="only C = 0 can give z = 0, whatever the motion",
)


def _measurement_changes(k, order, number, value):
    return f"your change {k} alters the measurement {number or 1} at first order: its rate is {value}, up to a factor"


LOCAL = replace(
    OUTPUT,
    holds="locally observable",
    fails="not locally observable",
    free="change of the unknowns, not zero, that alters no measurement to first order",
    none_free="every change of the unknowns alters a measurement to first order",
    basis_right="none of them alters a measurement to first order, they are independent, and there are no "
    "more",
    shows=_measurement_changes,
    nearly_zero="your change {k} alters a measurement, though little",
)

#: By the part of the unknowns that is asked for.
WITH_ERROR = {None: BOTH, "state": STATE, "error": AMPLITUDE}
#: The positions of a part among the unknowns (x(0), C).
PARTS = {
    "state": lambda system: tuple(range(system.A.rows)),
    "error": lambda system: (system.A.rows,),
}


def words(system, part=None):
    """Return the wording of the question whether an output determines the unknowns, or a part."""
    if isinstance(system, WithError):
        return WITH_ERROR[part]
    return LOCAL if isinstance(system, Measurements) else OUTPUT
