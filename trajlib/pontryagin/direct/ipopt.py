"""IPOPT through CasADi: the options that all programmes share, and an end in time.

IPOPT relaxes bounds by 1e-8 unless an option forbids it, and its return status decides.
"""

from trajlib._lazy import casadi as ca
from trajlib.pontryagin.problem.time_limit import seconds_left, stopped_from_within


class Ipopt:
    """A nonlinear programme {"x", "f", "g"} of CasADi, with IPOPT as its solver.

    Parameters
    ----------
    name : str
        Of the solver.
    nlp : dict
        Variables, cost and constraints.
    tolerance : float
        Of IPOPT.
    patience : int
        Iterations at most.
    **options
        Further options of IPOPT.
    """

    def __init__(self, name, nlp, tolerance, patience, **options):
        shared = {
            "ipopt.print_level": 0,
            "print_time": False,
            "ipopt.sb": "yes",
            "ipopt.tol": tolerance,
            "ipopt.max_iter": patience,
            "ipopt.bound_relax_factor": 0.0,
            "ipopt.mu_strategy": "adaptive",
            "show_eval_warnings": False,
            "error_on_fail": False,
        }
        options = {f"ipopt.{key}": value for key, value in options.items()}
        if seconds_left() < float("inf"):
            # A limit among IPOPT's own options would count from each call. CasADi does not keep it.
            self._stop = _stop_in_time(nlp["x"].numel(), nlp["g"].numel())
            options["iteration_callback"] = self._stop
        self._solver = ca.nlpsol(name, "ipopt", nlp, shared | options)

    def __call__(self, **arguments):
        """Return the solution for bounds and a guess, with the names of `casadi.nlpsol`."""
        with stopped_from_within():
            return self._solver(**arguments)

    @property
    def status(self) -> str:
        """IPOPT's return status of the last call."""
        return self._solver.stats()["return_status"]

    @property
    def solved(self) -> bool:
        """Whether the last call found a solution."""
        return self.status in ("Solve_Succeeded", "Solved_To_Acceptable_Level")

    @property
    def iterations(self) -> int:
        """Iterations of the last call."""
        return self._solver.stats()["iter_count"]


def _stop_in_time(variables, constraints):
    """Return a CasADi callback by which IPOPT stops between two iterations when the time is over."""

    class Stop(ca.Callback):
        def __init__(self):
            ca.Callback.__init__(self)
            self.construct("stop", {})

        def get_n_in(self):
            return ca.nlpsol_n_out()

        def get_n_out(self):
            return 1

        def get_sparsity_in(self, i):
            sizes = {
                "f": 1,
                "x": variables,
                "lam_x": variables,
                "g": constraints,
                "lam_g": constraints,
            }
            return ca.Sparsity.dense(sizes.get(ca.nlpsol_out(i), 0), 1)

        def eval(self, arguments):
            return [float(seconds_left() == 0)]

    return Stop()
