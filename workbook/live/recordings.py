"""Run cells before the class comes, and then show what they showed instead of computing again.

A cell is shown again where its source is the same and every name that it reads has the very object
that it had: after a change in a cell, that cell and all that depends on it are computed.
"""

from dataclasses import dataclass
from types import CodeType, FunctionType

from IPython.utils.capture import CapturedIO, capture_output

from workbook.live.steps import names_used

MISSING = object()


@dataclass(frozen=True)
class Recording:
    """What a cell has read, shown and assigned.

    Attributes
    ----------
    inputs : dict
        The objects that it read, by name; `MISSING` where there was none.
    shown : IPython.utils.capture.CapturedIO
        What it showed.
    assigned : dict
        The objects that it assigned, by name.
    """

    inputs: dict
    shown: CapturedIO
    assigned: dict


class Recordings:
    """The recorded cells of a shell, which shows them again when they are run.

    Parameters
    ----------
    shell : IPython.core.interactiveshell.InteractiveShell
        The shell; cells are replaced in it by a transformer of their text.
    """

    def __init__(self, shell):
        self._shell, self._by_source = shell, {}
        shell.input_transformers_cleanup.insert(0, self._replace)
        shell.recordings = self

    def record(self, source):
        """Run a cell out of sight, unless it is recorded as it is; return its error, if any."""
        source = source.strip()
        names = self._shell.user_ns
        try:
            inputs = self._inputs(source)
        except SyntaxError:  # also magics of IPython, which are run and not recorded
            inputs = None
        before = dict(names)
        # entered before, so that the run does not replace the display hook that captures
        with self._shell.display_trap, capture_output() as shown:
            outcome = self._shell.run_cell(source, store_history=False)
        error = outcome.error_before_exec or outcome.error_in_exec
        if error is None and inputs is not None and not self._is_current(source, inputs):
            assigned = {
                name: value
                for name, value in names.items()
                if not name.startswith("_") and before.get(name, MISSING) is not value
            }
            self._by_source[source] = Recording(inputs, shown, assigned)
        return error

    def show(self, source):
        """Show what a cell has shown, and assign what it has assigned."""
        recording = self._by_source[source]
        self._shell.user_ns.update(recording.assigned)
        recording.shown.show()

    def _replace(self, lines):
        source = "".join(lines).strip()
        if source in self._by_source and self._is_current(source, self._inputs(source)):
            return [f"get_ipython().recordings.show({source!r})\n"]
        return lines

    def _is_current(self, source, inputs):
        recording = self._by_source.get(source)
        return (
            recording is not None
            and recording.inputs.keys() == inputs.keys()
            and all(recording.inputs[name] is value for name, value in inputs.items())
        )

    def _inputs(self, source):
        """Return the objects that a cell reads, also by the functions of other cells, by name."""
        names, inputs = list(names_used(source)), {}
        while names:
            name = names.pop()
            if name not in inputs:
                inputs[name] = value = self._shell.user_ns.get(name, MISSING)
                if isinstance(value, FunctionType) and value.__globals__ is self._shell.user_ns:
                    names += _names_of_code(value.__code__)
        return inputs


def _names_of_code(code):
    nested = [constant for constant in code.co_consts if isinstance(constant, CodeType)]
    return [*code.co_names, *(name for inner in nested for name in _names_of_code(inner))]
