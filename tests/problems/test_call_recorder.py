"""Shared functions of an answer and its check are recorded, however they were imported."""

import functools
import sys
from types import SimpleNamespace

import scipy.linalg
import sympy as sp
from call_recorder import recorded_calls
from scipy.linalg import expm

from trajlib.structure import controllability
from workbook.systems import Mechanical


def from_here(module, caller):
    return caller.f_code.co_filename == __file__


def test_calls_are_noted_and_do_what_they_did():
    before = expm.__code__
    with recorded_calls(("scipy.linalg", "trajlib."), from_here) as called:
        assert expm([[0, 1], [0, 0]]).tolist() == [[1, 1], [0, 1]]
        assert controllability([[0, 1], [0, 0]], [[0], [1]]).holds
    assert (expm.__module__, "expm") in called and (
        "trajlib.structure.rank_tests",
        "controllability",
    ) in called
    assert expm.__code__ is before


def test_what_a_library_calls_by_itself_is_left_out():
    with recorded_calls(("scipy.linalg",), from_here) as called:
        assert scipy.linalg.sqrtm([[4, 0], [0, 9]]).tolist() == [[2, 0], [0, 3]]
    assert {name for _, name in called} == {"sqrtm"}


def test_methods_are_seen_and_keep_their_defaults():
    with recorded_calls(("workbook.",), from_here) as called:
        assert Mechanical([[1]], [[0]], [["k"]]).subs("k", 2).K == sp.ImmutableMatrix([[2]])
    assert called == {("workbook.systems.linear", "Mechanical.subs")}


def test_a_kept_result_is_no_call():
    """A cached result is no call: nothing may be cached when calls of checks are recorded."""
    names = {"__name__": "trajlib.kept", "functools": functools}
    exec("@functools.cache\ndef square(x):\n    return x * x\n", names)
    sys.modules["trajlib.kept"] = SimpleNamespace(**names)
    try:
        with recorded_calls(("trajlib.kept",), from_here) as called:
            assert names["square"](3) == 9 and called == {("trajlib.kept", "square")}
            called.clear()
            assert names["square"](3) == 9 and called == set()
    finally:
        del sys.modules["trajlib.kept"]
