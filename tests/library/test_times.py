"""All modules read times in one way: dates are seconds since the first, or refused by name."""

from datetime import UTC, date, datetime, timedelta

import numpy as np
import pytest
import sympy as sp

from trajlib.estimation import Moments, optimal_weights, simulate_continuous
from trajlib.invariant import InvariantEstimator, derivative, integral, value
from trajlib.reconstruction import SweepGains, reconstruct
from trajlib.reference_curves import ReferenceCurves
from trajlib.solvability import clohessy_wiltshire, linearise, stack, transition

SECONDS = np.arange(8.0)
NOON = datetime(2026, 11, 27, 12)
FORMS = {
    "datetime64[ns]": np.datetime64(NOON, "ns") + np.arange(8) * np.timedelta64(1, "s"),
    "datetime64[s]": np.datetime64(NOON, "s") + np.arange(8),
    "datetime": [NOON + timedelta(seconds=k) for k in range(8)],
    "datetime with a zone": [NOON.replace(tzinfo=UTC) + timedelta(seconds=k) for k in range(8)],
}


def decay(t, x):
    return [-x[0]]


READERS = {
    "reconstruct": lambda t: reconstruct(t, SECONDS**2, 0.1, M=1.0).t,
    "SweepGains": lambda t: SweepGains(t, 0.1, 1.0).t,
    "InvariantEstimator": lambda t: InvariantEstimator(t, [1]).times,
    "ReferenceCurves": lambda t: ReferenceCurves(decay, t, [[1]]).nodes[0],
    "linearise": lambda t: linearise(decay, decay, [1.0], t).times,
    "transition": lambda t: transition([[0, 1], [0, 0]], t)[:, 0, 1],
    "clohessy_wiltshire": lambda t: clohessy_wiltshire(1e-3, t)[:, 2, 5],
    "stack": lambda t: stack(lambda s: [[s]], lambda s, _: [[1.0]], t)[:, 0],
    "simulate_continuous": lambda t: (
        simulate_continuous(np.zeros((1, 1)), np.eye(1), Moments([0.0], [[0.0]]), t, 1, 1).times
    ),
}


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("name", READERS)
def test_dates_become_seconds_since_the_first(name, form):
    assert np.array_equal(READERS[name](FORMS[form]), READERS[name](SECONDS))


def test_months_and_days_are_counted_in_seconds():
    months = np.array(["2026-01", "2026-02", "2026-03"], dtype="datetime64[M]")
    for times in (months, [date(2026, month, 1) for month in (1, 2, 3)]):
        assert InvariantEstimator(times, [1]).times.tolist() == [0, 31 * 86400, 59 * 86400]


@pytest.mark.parametrize("name", READERS)
@pytest.mark.parametrize(
    "times",
    [
        SECONDS.astype("timedelta64[s]"),
        [NOON, NOON.replace(tzinfo=UTC), *FORMS["datetime"][2:]],
        [NOON, 1.0, *SECONDS[2:]],
        ["noon"] * 8,
        [[0, 1], [2]],
    ],
)
def test_other_times_are_refused_by_name(name, times):
    with pytest.raises(TypeError, match=r"^(t|times|t_nodes): (expected a list of times|dates of)"):
        READERS[name](times)


def test_a_date_that_is_missing_or_late_is_named():
    gap = FORMS["datetime64[ns]"].copy()
    gap[3] = np.datetime64("NaT")
    with pytest.raises(ValueError, match="entry 3 is not finite"):
        reconstruct(gap, SECONDS, 0.1, M=1.0)
    with pytest.raises(ValueError, match="must increase, but 1 is followed by 0"):
        reconstruct(FORMS["datetime"][:2] + FORMS["datetime"][:1], [0, 1, 2], 0.1, M=1.0)


_TAU = sp.Symbol("tau")
LATER = FORMS["datetime64[ns]"][3]
CURVES = ReferenceCurves(decay, FORMS["datetime"], [[1]])


@pytest.mark.parametrize(
    "call",
    [
        lambda: value(LATER),
        lambda: derivative([LATER]),
        lambda: integral(0, LATER),
        lambda: reconstruct(FORMS["datetime"], SECONDS, 0.1, M=1.0).position(LATER),
        lambda: CURVES(LATER, [1]),
        lambda: CURVES.on_grid([[LATER], [1]]),
        lambda: CURVES.integrated([LATER], [1]),
        lambda: linearise(decay, decay, [1.0], SECONDS, reference=LATER),
        lambda: linearise(decay, decay, [1.0], SECONDS, breaks=[LATER]),
        lambda: transition([[0.0]], SECONDS, LATER),
        lambda: optimal_weights(1, _TAU, SECONDS, np.array([LATER])),
    ],
)
def test_a_date_without_its_record_is_refused(call):
    with pytest.raises(TypeError, match="expected .*(number|time)"):
        call()
