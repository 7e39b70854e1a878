"""Former names of checks, under which notebooks that were handed out before still work."""

import functools

_POINTS = "field state parameters domain"
_VALUES = "field state parameters given integer"
_ANGLES = "field state parameters integer"
_CURVE = "system target domain parameters start"
_LOOP = "loop K L process parameters given"
_STABLE, _UNSTABLE = {"kind": "asymptotically stable"}, {"kind": "unstable"}
#: {former name: the check, the order of its data then, data that it did not take}.
FORMER = {
    "barrier": ("switching_curve", _CURVE, {"kind": "barrier"}),
    "delay_margin": ("loop_margin", _LOOP, {"kind": "delay"}),
    "disk_margin": ("loop_margin", _LOOP, {"kind": "disk"}),
    "dispersal_curve": ("switching_curve", _CURVE, {"kind": "dispersal"}),
    "equilibrium_angles": ("equilibrium_values", _ANGLES, {}),
    "equilibrium_angles_exist": ("equilibrium_condition", _POINTS, {}),
    "equilibrium_exists": ("equilibrium_condition", _POINTS, {}),
    "equilibrium_types": ("equilibrium_type", "field state", {}),
    "focus_region": ("equilibrium_condition", _POINTS, {"kind": "focus"}),
    "linearisation_matrices": ("equilibrium_linearisation", f"{_VALUES} zeros", {}),
    "node_region": ("equilibrium_condition", _POINTS, {"kind": "node"}),
    "nullcline": ("equilibria", _POINTS, {}),
    "possible_margins": ("possible_degrees", "system mu parameters", {}),
    "phase_margin": ("loop_margin", _LOOP, {"kind": "phase"}),
    "saddle_angle_condition": (
        "equilibrium_condition",
        "field state parameters angle",
        {"kind": "saddle"},
    ),
    "stable_angle_condition": (
        "equilibrium_condition",
        "field state parameters angle",
        _STABLE,
    ),
    "stable_equilibria": ("equilibria", "field state", _STABLE),
    "stable_equilibrium_angles": ("equilibrium_values", _ANGLES, _STABLE),
    "stable_equilibrium_values": ("equilibrium_values", _VALUES, _STABLE),
    "stationary_exists": ("equilibrium_condition", _POINTS, {}),
    "stationary_linearisation": ("equilibrium_linearisation", _POINTS, {}),
    "stationary_points": ("equilibria", f"{_POINTS} zeros", {}),
    "stationary_stability": ("equilibrium_stability", _POINTS, {}),
    "stationary_type": ("equilibrium_type", _POINTS, {}),
    "stationary_value": ("equilibrium_value", f"expression {_POINTS}", {}),
    "unique_equilibrium": (
        "equilibrium_condition",
        "field state parameters",
        {"kind": "unique"},
    ),
    "unstable_equilibrium_angles": ("equilibrium_values", _ANGLES, _UNSTABLE),
    "unstable_equilibrium_values": ("equilibrium_values", _VALUES, _UNSTABLE),
}


def former_check(name, present):
    """Return a check under its former name, with the data in the order of that time.

    Parameters
    ----------
    name : str
        A key of `FORMER`.
    present : callable
        Returns the check of a present name.
    """
    new, order, fixed = FORMER[name]
    check = present(new)

    @functools.wraps(check)
    def judge(answer, *data, **options):
        return check(answer, **dict(zip(order.split(), data)), **options, **fixed)

    return judge
