"""Ctrl-C stops the grader also when it arrives during a finalizer."""

import signal
import sys
import threading
import time
import weakref

import pytest

from workbook.grading.interrupts import repeat_lost_interrupts


class Disturbed:
    """An object during whose finalizer Ctrl-C arrives."""

    def __del__(self):
        signal.raise_signal(signal.SIGINT)


def in_del():
    Disturbed()


def in_a_callback():
    class Thing:
        pass

    thing = Thing()
    kept = weakref.ref(thing, lambda _: signal.raise_signal(signal.SIGINT))
    del thing
    assert kept() is None


@pytest.fixture(autouse=True)
def heeding():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture
def ignored(monkeypatch):
    """The types of errors that Python reports as ignored."""
    types = []
    monkeypatch.setattr(sys, "unraisablehook", lambda unraisable: types.append(unraisable.exc_type))
    return types


@pytest.mark.parametrize("finalizing", [in_del, in_a_callback])
class TestFinalizers:
    def test_without_the_guard_the_interrupt_is_lost(self, finalizing, ignored):
        finalizing()
        assert ignored == [KeyboardInterrupt]

    def test_it_is_raised_again_while_the_grader_waits(self, finalizing, ignored):
        reached = []
        with pytest.raises(KeyboardInterrupt), repeat_lost_interrupts():
            finalizing()
            reached.append("went on")
            time.sleep(20)
            reached.append("was not stopped")
        assert reached == ["went on"] and not ignored

    def test_it_is_raised_at_the_end_of_the_block(self, finalizing, ignored):
        with pytest.raises(KeyboardInterrupt), repeat_lost_interrupts():
            finalizing()
        assert not ignored
        time.sleep(0.2)  # and not once more after that


def test_other_ignored_errors_are_reported_as_before(ignored):
    class Broken:
        def __del__(self):
            raise ValueError

    hook = sys.unraisablehook
    with repeat_lost_interrupts():
        Broken()
    assert ignored == [ValueError] and sys.unraisablehook is hook
    assert not [thread for thread in threading.enumerate() if isinstance(thread, threading.Timer)]
