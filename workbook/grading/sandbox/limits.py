"""What a notebook may use, how it ended, and why none runs: the same in every sandbox."""

from dataclasses import dataclass, field

#: Bytes of the longest message of a notebook: the encoding of answers limits them far below.
MAX_MESSAGE = 16 * 2**20


class SandboxUnavailableError(RuntimeError):
    """This machine offers no sandbox; the message names what is missing."""


class ProcessStartError(SandboxUnavailableError):
    """A process of the grader ended, or was too slow, while it started, several times.

    The machine may well offer a sandbox: the same command may succeed later.
    """


@dataclass(frozen=True)
class Limits:
    """What one notebook may use, all its processes together.

    Time in which nothing of the notebook wants to compute counts as computing. Wall time may be
    three times as long, and what it waits for busy processors is added, up to `withheld_seconds`:
    that is not the student's fault.

    Parameters
    ----------
    cpu_seconds, wall_seconds, withheld_seconds : float
        Processor time; wall time; wall time in addition while others have the processors.
    memory_megabytes, disk_megabytes : int
        Memory; files in each of `isolation.SCRATCH`.
    processes : int
        Processes and threads.
    """

    cpu_seconds: float = 120
    wall_seconds: float = 360
    withheld_seconds: float = 3600
    memory_megabytes: int = 2048
    disk_megabytes: int = 64
    processes: int = 32

    @classmethod
    def of_time(cls, seconds):
        """Return the limits for so many seconds of computing."""
        return cls(cpu_seconds=seconds, wall_seconds=3 * seconds)


@dataclass(frozen=True)
class Outcome:
    """How a notebook ended, and the bytes that it handed over, as they are.

    Parameters
    ----------
    ended : str
        "done"; the limit that was exceeded ("time", "memory", "processes", "sockets", "large");
        "died", with the exit code or signal as the bytes; "failed", if the sandbox itself did; or
        "elsewhere", if only a machine with Linux can run it, with the reason as the bytes.
    handed_over : bytes
        The encoded answers, or details of how it ended.
    seconds : float
        What it used of `Limits.cpu_seconds`.
    """

    ended: str
    handed_over: bytes
    seconds: float = field(default=0.0, compare=False)
