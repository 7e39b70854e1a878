"""The process in which Wasmtime runs: one guest after the other, each from the same image of memory.

A guest sees the standard library and ours, both read-only, and a clock. It has no network, no
processes, no threads and no folder to write to. Its memory and its time are limited, its output is
discarded, and bytes leave it by one function.

Memory after `guest.boot` is an image from which each notebook's guest starts, as in the pages of
the site. No signal can stop a cell inside: a guest whose time is over is ended, and the notebook
runs again without the cell that took it.
"""

import ctypes
import importlib.util
import json
import multiprocessing
import os
import signal
import struct
import threading
import time
from contextlib import suppress

import wasmtime

from workbook.grading.sandbox.limits import MAX_MESSAGE, Limits, Outcome
from workbook.grading.sandbox.wasm import compiled
from workbook.grading.sandbox.wasm.guest import ANSWERS, CELL, MISSING, MODULE

#: How much longer a notebook may compute than in the sandbox of Linux, which is 2 to 3 times faster.
SLOWER = 3
#: How often a notebook runs, each time with one more cell that is timed or left out.
MAX_TURNS = 6
#: Seconds between two looks at the clock; the smallest part of time that a guest gets.
TICK = 0.02
#: Bytes of a page of WebAssembly memory; of memory, and seconds, in which a guest is to boot.
PAGE, BOOT_BYTES, BOOT_SECONDS = 2**16, 2**32, 600
#: Libraries of the course that may be missing on this machine, too.
LIBRARIES = {"casadi", "control", "flint", "ipywidgets", "z3"}
ENVIRONMENT = {
    "HOME": "/tmp",
    "TMPDIR": "/tmp",
    "MPLBACKEND": "Agg",
    "MPLCONFIGDIR": "/tmp",
    "PYTHONDONTWRITEBYTECODE": "1",
    "PYTHONHASHSEED": "0",
    "PYTHONTZPATH": "",
}
#: The file that Python itself looks for in the guest, and how our code there is called.
STANDARD_LIBRARY = "usr/local/lib/python315.zip"
#: Matplotlib's data: an archive within that file, which Matplotlib looks for beside its own modules.
DATA_ARCHIVE, DATA = "matplotlib/mpl-data.zip", "matplotlib/mpl-data"
GUEST = "from workbook.grading.sandbox.wasm import guest; guest."
#: WASI's number for what is not supported.
NOT_SUPPORTED = 58


def serve(receiver, sender, lifeline, root, limits):
    """Run notebooks until the pipe closes; the generator of a `Child`.

    Parameters
    ----------
    receiver, sender : multiprocessing.connection.Connection
        The ends of the pipe on which requests come, as JSON.
    lifeline : multiprocessing.connection.Connection or None
        A pipe; this process ends when it closes.
    root : str
        The folder that guests see as /, with library.zip, `STANDARD_LIBRARY` and `DATA`.
    limits : dict
        As of `limits.Limits`.

    Yields
    ------
    list
        At first an empty one; then [how it ended, the bytes as text, seconds] of each notebook.
    """
    sender.close()  # or the pipe would not end when the parent closes its copy
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    host = Host(root, Limits(**limits), lifeline)
    yield []
    with suppress(EOFError):
        while True:
            outcome = host.run(json.loads(receiver.recv_bytes()))
            yield [outcome.ended, outcome.handed_over.decode("latin-1"), outcome.seconds]


class Host:
    """Runs notebooks, each in a guest of its own.

    Parameters
    ----------
    root : str
        The folder that guests see as /.
    limits : Limits
        Those of each notebook, in seconds of the sandbox of Linux.
    lifeline : multiprocessing.connection.Connection, optional
        A pipe; this process ends when it closes.
    """

    def __init__(self, root, limits, lifeline=None):
        self._root, self._limits, self._lifeline = root, limits, lifeline
        self._engine, self.clock = compiled.engine(), Clock()
        self._module = compiled.load(self._engine)
        threading.Thread(target=self._tick, daemon=True).start()
        self._image = _in_deep_thread(self._boot)

    def run(self, request):
        """Return the `Outcome` of a notebook; the request has "sources", "names" and "before"."""
        seconds = SLOWER * self._limits.cpu_seconds
        timed, left_out, began = [], [], self.clock.seconds()
        for _ in range(MAX_TURNS):
            guest, outcome = _in_deep_thread(
                self._turn,
                {
                    **request,
                    "timed": timed,
                    "left out": left_out,
                    "seconds": self._limits.cpu_seconds / 2,
                },
                seconds,
            )
            if outcome.ended != "time" or guest.cell in (0, *left_out):
                break
            if guest.cell in timed:
                timed.remove(guest.cell)
                left_out.append(guest.cell)
            else:
                timed.append(guest.cell)
        if outcome.ended == "time":
            outcome = Outcome("elsewhere", b"it takes longer here than there")
        if outcome.ended != "large" and guest.missing:
            names = ", ".join(sorted(guest.missing))
            outcome = Outcome("elsewhere", f"it uses what is missing here: {names}".encode())
        used = (self.clock.seconds() - began) / SLOWER
        return Outcome(outcome.ended, outcome.handed_over, used)

    def _turn(self, request, seconds):
        guest = Guest(self._engine, self._module, self.clock, self._root, self._memory())
        guest.restore(self._image)
        guest.allow(seconds)
        try:
            return guest, guest.outcome(GUEST + f"run({json.dumps(request)!r})")
        finally:
            guest.store.close()  # gives its memory back at once

    def _memory(self):
        return min(len(self._image) + self._limits.memory_megabytes * 2**20, BOOT_BYTES)

    def _boot(self):
        guest = Guest(self._engine, self._module, self.clock, self._root, BOOT_BYTES, loud=True)
        guest.allow(BOOT_SECONDS)
        guest.exports["_initialize"](guest.store)
        if status := guest.turn("import sys; sys.path.append('/library.zip')\n" + GUEST + "boot()"):
            raise RuntimeError(f"Python does not start in WebAssembly: exit code {status}")
        return guest.memory_bytes()

    def _tick(self):
        """Count the time by the engine's epochs, and end with the processes that need this one."""
        parent, epochs = multiprocessing.parent_process(), 0
        while True:
            time.sleep(TICK)
            cut = self._lifeline is not None and self._lifeline.poll()
            if cut or (parent is not None and not parent.is_alive()):
                os._exit(1)
            while epochs < self.clock.seconds() / TICK:
                self._engine.increment_epoch()
                epochs += 1


class Clock:
    """Seconds of computing in this process, with those in which a guest slept."""

    def __init__(self):
        self._slept = 0.0

    def seconds(self):
        """Return the seconds so far."""
        return time.process_time() + self._slept

    def sleep(self, seconds):
        """Sleep, which counts as computing."""
        time.sleep(seconds)
        self._slept += seconds


class Guest:
    """One instance of CPython in WebAssembly.

    `cell` is the number of the cell that it runs, `missing` what the notebook did not find here,
    `answers` what it handed over: None, bytes, or "large".
    """

    def __init__(self, engine, module, clock, root, memory, loud=False):
        self.store, self._clock, self._end = wasmtime.Store(engine), clock, float("inf")
        self.cell, self.missing, self.answers, self._is_timed = 0, set(), None, False
        self._limit_cells = lambda: None
        self.store.set_limits(memory_size=memory)
        self.store.set_epoch_deadline(2**31)
        wasi = wasmtime.WasiConfig()
        wasi.argv, wasi.env = ["python"], list(ENVIRONMENT.items())
        wasi.preopen_dir(root, "/", False)
        wasi.preopen_dir(f"{root}/{DATA}", f"/{STANDARD_LIBRARY}/{DATA}", False)
        if loud:  # our own code
            wasi.inherit_stderr()
        self.store.set_wasi(wasi)
        self._born = time.monotonic_ns()  # where the guest's monotonic clock begins
        kind = wasmtime.FuncType([wasmtime.ValType.i32()] * 4, [wasmtime.ValType.i32()])
        linker = wasmtime.Linker(engine)
        linker.allow_shadowing = True
        linker.define_wasi()
        # Wasmtime's own would sleep where no epoch ends it.
        linker.define_func(
            "wasi_snapshot_preview1", "poll_oneoff", kind, self._poll, access_caller=True
        )
        linker.define_func("host", "call", kind, self._called, access_caller=True)
        self.exports = linker.instantiate(self.store, module).exports(self.store)

    def allow(self, seconds):
        """Let the guest compute for so long from now on, and each cell for half of what is left."""
        end = self._clock.seconds() + seconds
        self._limit(seconds)
        self._limit_cells = lambda: self._limit((end - self._clock.seconds()) / 2)

    def _limit(self, seconds):
        self._end = self._clock.seconds() + seconds
        self.store.set_epoch_deadline(max(1, int(seconds / TICK)))

    def restore(self, image):
        """Let the memory be this image."""
        memory = self.exports["memory"]
        memory.grow(self.store, (len(image) - memory.data_len(self.store)) // PAGE)
        ctypes.memmove(memory.data_ptr(self.store), image, len(image))

    def memory_bytes(self):
        """Return the memory."""
        memory = self.exports["memory"]
        return ctypes.string_at(memory.data_ptr(self.store), memory.data_len(self.store))

    def turn(self, text):
        """Run Python code; return its exit status."""
        data = text.encode()
        pointer = self.exports["host_alloc"](self.store, len(data)) & 0xFFFFFFFF
        self.exports["memory"].write(self.store, data, pointer)
        return self.exports["turn"](self.store, pointer, len(data))

    def outcome(self, text):
        """Run Python code that hands answers over; return the `Outcome`."""
        try:
            status = self.turn(text)
        except wasmtime.ExitTrap as end:
            return Outcome("died", f"exit {end.code}".encode())
        except (wasmtime.Trap, wasmtime.WasmtimeError) as error:
            code = getattr(error, "trap_code", None)
            if code == wasmtime.TrapCode.INTERRUPT:
                return Outcome("time", b"")
            # It need not be the notebook's fault.
            return Outcome("elsewhere", f"Python ended here ({code or 'a host function'})".encode())
        if self.answers == "large":
            return Outcome("large", b"")
        if self.answers is None:
            return Outcome("died", f"exit {status}".encode())
        return Outcome("done", self.answers)

    def _poll(self, caller, subscriptions, events, count, written):
        """`poll_oneoff` for one clock, which is what `time.sleep` needs.

        A sleep beyond the time allowed ends the guest; in a cell that is timed it ends early, and the
        guest itself stops the cell.
        """
        memory = caller.get("memory")
        subscriptions, events, written = (p & 0xFFFFFFFF for p in (subscriptions, events, written))
        user, tag, clock, timeout, flags = struct.unpack(
            "<QB7xI4xQ8xH6x", bytes(memory.read(caller, subscriptions, subscriptions + 48))
        )
        if count != 1 or tag != 0:
            return NOT_SUPPORTED
        if flags & 1:  # until a time of the guest's clock
            timeout -= time.time_ns() if clock == 0 else time.monotonic_ns() - self._born
        left = max(0.0, self._end - self._clock.seconds())
        self._clock.sleep(min(timeout / 1e9, left / 2 if self._is_timed else left))
        if timeout / 1e9 > left and not self._is_timed:
            self.store.set_epoch_deadline(0)
        memory.write(caller, struct.pack("<QHB21x", user, 0, 0), events)
        memory.write(caller, struct.pack("<I", 1), written)
        return 0

    def _called(self, caller, pointer, length, answer, answer_length):
        """Take a message of the guest; the answer is always empty."""
        memory = caller.get("memory")
        pointer, length = pointer & 0xFFFFFFFF, length & 0xFFFFFFFF
        if length > MAX_MESSAGE:
            self.answers = "large"
            return -2
        message = bytes(memory.read(caller, pointer, pointer + length))
        kind, text = message[:1], message[1:41].decode(errors="replace")
        if kind == ANSWERS and self.answers != "large":
            self.answers = message[1:]
        elif kind == CELL:
            number, _, timed = text.partition(" ")
            self.cell, self._is_timed = int(number) if number.isdecimal() else 0, bool(timed)
            self._limit_cells()
        elif len(self.missing) < 10 and (
            kind == MISSING or (kind == MODULE and _is_elsewhere(text))
        ):
            self.missing.add(text)
        start = caller.get("host_alloc")(caller, 1) & 0xFFFFFFFF
        for where, value in ((answer, start), (answer_length, 0)):
            memory.write(caller, struct.pack("<I", value), where & 0xFFFFFFFF)
        return 0


def _is_elsewhere(name):
    """Return whether a module is missing only here: a misspelt one is missing on every machine."""
    return name in LIBRARIES or (name.isidentifier() and importlib.util.find_spec(name) is not None)


def _in_deep_thread(function, *args):
    """Call a function in a thread whose stack has room for the guest's."""
    result = []

    def call():
        try:
            result.append((function(*args), None))
        except BaseException as error:
            result.append((None, error))

    previous = threading.stack_size(4 * compiled.STACK)
    thread = threading.Thread(target=call)
    thread.start()
    threading.stack_size(previous)
    thread.join()
    value, error = result[0]
    if error is not None:
        raise error
    return value
