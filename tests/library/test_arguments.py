"""Every public function with arrays reads every form of them, or refuses it by the argument's name.

`CALLS` has one valid call of each function that takes a matrix, a record or times; which these are is
read from the annotations of all that the stubs export.
"""

import ast
import warnings
from datetime import datetime, timedelta
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
import scipy.sparse
import sympy as sp

import trajlib
from trajlib import (
    estimation,
    feedback,
    infosets,
    invariant,
    plotting,
    reconstruction,
    reference_curves,
    solvability,
    stability,
    structure,
)
from trajlib.estimation import Moments

# ruff: noqa: E501

A, B, H = np.array([[0.0, 1.0], [-2.0, -3.0]]), np.array([[0.0], [1.0]]), np.array([[1.0, 0.0]])
PHI, ONE, TWO = A / 4, np.eye(1), np.eye(2)
START = Moments(np.zeros(2), TWO)
TIMES = np.arange(5.0)
RECORD = np.array([[1.0], [2.0], [0.5], [4.0], [3.0]])
POINTS = np.array([[0.0, 0.0, 4.0], [4.0, 0.0, 0.5], [0.0, 4.0, 1.0], [3.0, 3.0, 3.0]])
EXACT = {"A": sp.Matrix([[0, 1], [-2, -3]]), "B": sp.Matrix([0, 1]), "H": sp.Matrix([[1, 0]])}
A_B, A_H = ({name: EXACT[name] for name in pair} for pair in ("AB", "AH"))
TAU, S, V = sp.symbols("tau s v")
STATE = sp.symbols("x1 x2")


def decay(t, x):
    return [-x[0]]


ITEMS = {"A": A, "H": H, "Q": TWO, "R": ONE}
DISCRETE = {"Phi": PHI, "H": H, "Q": TWO, "R": ONE}
REGULATOR = {"A": A, "B": B, "G": TWO, "N": ONE}
STEPS = {"A": PHI, "B": B, "G": TWO, "N": ONE}
MECHANICAL = {"M": TWO, "D": TWO, "K": TWO}
FILTER = estimation.KalmanFilter(**DISCRETE)
BUCY = estimation.ContinuousFilter(**ITEMS)
EXTENDED = estimation.ExtendedKalmanFilter(
    [STATE[0] + V, STATE[1] / 2], [STATE[0]], STATE, TWO, ONE, [V]
)
RUN = FILTER.run(RECORD, START)
RECORDS = {"z": RECORD, "start": START}
FIX = {"satellites": POINTS, "squared_ranges": np.array([27.0, 22.5, 20.0, 30.0])}
SQUARE = infosets.SupportPolygons(np.ones(4))
REACHED = infosets.dubins_reachable(1.0)
MOTION = reconstruction.reconstruct(TIMES, TIMES**2, 0.1, M=1.0)
CURVES = reference_curves.ReferenceCurves(decay, TIMES, [[1.0, 2.0]])
LINE = np.stack([np.ones(5), TIMES], axis=1)
LINEAR = solvability.analyse(LINE)

CALLS = {
    "estimation.bearing_fix": (estimation.bearing_fix, {"observers": POINTS[:2], "directions": POINTS[2:]}),
    "estimation.Measurement": (
        lambda z, H, R: estimation.filter_measurements(A, TWO, START, [estimation.Measurement(1, z, H, R)]).after,
        {"z": np.ones(1), "H": H, "R": ONE},
    ),
    "estimation.filter_measurements": (
        lambda A, Q: estimation.filter_measurements(A, Q, START, [estimation.Measurement(1, [1.0], H, ONE)]).after,
        {"A": A, "Q": TWO},
    ),
    "estimation.ContinuousFilter": (lambda **matrices: vars(estimation.ContinuousFilter(**matrices)), ITEMS),
    "estimation.ContinuousFilter.gain": (BUCY.gain, {"P": TWO}),
    "estimation.ContinuousFilter.rate": (BUCY.rate, {"P": TWO}),
    "estimation.ContinuousFilter.covariance": (BUCY.covariance, {"P": TWO, "t": 1.0}),
    "estimation.ContinuousFilter.run": (BUCY.run, {"averages": RECORD[:4], "times": TIMES, "start": START}),
    "estimation.ContinuousFilter.simulate": (BUCY.simulate, {"start": START, "times": TIMES, "paths": 1, "seed": 1}),
    "estimation.corrected": (estimation.corrected, {"prior": START, "z": np.ones(1), "H": H, "R": ONE}),
    "estimation.Moments": (Moments, {"mean": np.ones(2), "covariance": TWO}),
    "estimation.Moments.transformed": (START.transformed, {"B": A, "b": np.ones(2)}),
    "estimation.KalmanFilter": (lambda **matrices: vars(estimation.KalmanFilter(**matrices)), DISCRETE),
    "estimation.KalmanFilter.sampled": (
        lambda **arguments: vars(estimation.KalmanFilter.sampled(**arguments)), {**ITEMS, "times": TIMES},
    ),
    "estimation.KalmanFilter.run": (FILTER.run, {**RECORDS, "inputs": np.ones((5, 2))}),
    "estimation.FilterRun.plot": (RUN.plot, {"truth": np.ones((5, 2))}),
    "estimation.SmoothedRun.plot": (RUN.smoothed().plot, {"truth": np.ones((5, 2))}),
    "estimation.bearing_observability": (estimation.bearing_observability, {"position": np.ones(3), "observers": POINTS}),
    "estimation.satellite_observability": (estimation.satellite_observability, {"position": np.ones(3), "satellites": POINTS}),
    "estimation.error_covariance": (estimation.error_covariance, {**ITEMS, "K": np.ones((2, 1))}),
    "estimation.OptimalWeights.estimate": (
        estimation.optimal_weights(sp.exp(-TAU), TAU, TIMES, 5.0).estimate, {"z": TIMES},
    ),
    "estimation.optimal_weights": (
        estimation.optimal_weights,
        {"correlation": sp.exp(-TAU), "tau": TAU, "times": TIMES, "t": TIMES + 0.5, "noise": np.eye(5)},
    ),
    "estimation.LeastSquares.updated": (
        estimation.least_squares(TWO, np.ones(2)).updated, {"H": H, "z": np.ones(1), "R": ONE},
    ),
    "estimation.least_squares": (estimation.least_squares, {"H": LINE, "z": TIMES, "R": np.eye(5)}),
    "estimation.continuous_moments": (estimation.continuous_moments, {"A": A, "Q": TWO, "start": START, "t": 1.0}),
    "estimation.discrete_moments": (estimation.discrete_moments, {"Phi": PHI, "Q": TWO, "start": START, "steps": 3}),
    "estimation.discretise": (estimation.discretise, {"A": A, "Q": TWO, "step": 0.5}),
    "estimation.discretise_with_input": (estimation.discretise_with_input, {"A": A, "B": B, "Q": TWO, "step": 0.5}),
    "estimation.ExtendedKalmanFilter.run": (EXTENDED.run, {**RECORDS, "inputs": np.ones((5, 1))}),
    "estimation.gauss_newton": (
        lambda z, start, R: estimation.gauss_newton([STATE[0] ** 2, STATE[1]], z, STATE, start, R),
        {"z": np.array([4.0, 1.0]), "start": np.ones(2), "R": TWO},
    ),
    "estimation.SatelliteFix.nearest": (estimation.satellite_fix(**FIX).nearest, {"guess": np.ones(3)}),
    "estimation.satellite_fix": (estimation.satellite_fix, FIX),
    "estimation.with_shaping": (
        estimation.with_shaping,
        {**EXACT, "shaping": estimation.shaping_filter(sp.exp(-TAU), TAU), "Q": sp.eye(2), "C": sp.eye(1)},
    ),
    "estimation.covariance_consistency": (estimation.covariance_consistency, {"errors": POINTS[:, :2], "covariance": TWO}),
    "estimation.simulate_continuous": (
        estimation.simulate_continuous,
        {"A": A, "Q": TWO, "start": START, "times": TIMES, "paths": 2, "seed": 1, "H": H, "R": ONE},
    ),
    "estimation.simulate_discrete": (
        estimation.simulate_discrete,
        {"Phi": PHI, "Q": TWO, "start": START, "steps": 3, "paths": 2, "seed": 1, "H": H, "R": ONE},
    ),
    "estimation.discrete_stationary_covariance": (estimation.discrete_stationary_covariance, {"Phi": PHI, "Q": TWO}),
    "estimation.stationary_covariance": (estimation.stationary_covariance, {"A": A, "Q": TWO}),
    "estimation.discrete_stationary_filter": (estimation.discrete_stationary_filter, DISCRETE),
    "estimation.stationary_filter": (estimation.stationary_filter, ITEMS),
    "feedback.discrete_finite_lqr": (feedback.discrete_finite_lqr, {**STEPS, "F": TWO, "steps": 3, "cross": B / 4}),
    "feedback.discrete_lqr": (feedback.discrete_lqr, {**STEPS, "cross": B / 4}),
    "feedback.feedback_by_estimate": (
        feedback.feedback_by_estimate,
        {**EXACT, "K": sp.Matrix([[1, 1]]), "L": sp.Matrix([1, 1, 1]), "S": sp.eye(1), "c": sp.eye(1)},
    ),
    "feedback.fixed_ends_lqr": (
        feedback.fixed_ends_lqr, {**REGULATOR, "start": np.ones(2), "end": np.zeros(2), "duration": 1.0},
    ),
    "feedback.convergent_gains": (feedback.convergent_gains, {**A_H, "L": sp.Matrix([S, 1])}),
    "feedback.stabilising_gains": (feedback.stabilising_gains, {**A_B, "K": sp.Matrix([[S, 1]])}),
    "feedback.observer": (feedback.observer, {**A_H, "eigenvalues": [-1, -2]}),
    "feedback.regulator": (feedback.regulator, {**A_B, "eigenvalues": [-1, -2]}),
    "feedback.place": (feedback.place, {"A": A, "B": B, "eigenvalues": [-1, -2]}),
    "feedback.finite_lqr": (feedback.finite_lqr, {**REGULATOR, "F": TWO, "time_to_go": 1.0, "cross": B / 4}),
    "feedback.lqr": (feedback.lqr, {**REGULATOR, "cross": B / 4}),
    "feedback.reduced_observer": (feedback.reduced_observer, {**EXACT, "eigenvalues": [-1]}),
    "feedback.discrete_lqg": (feedback.discrete_lqg, {**STEPS, "H": H, "Q": TWO, "R": ONE}),
    "feedback.lqg": (feedback.lqg, {**REGULATOR, "H": H, "Q": TWO, "R": ONE}),
    "feedback.best_degree": (feedback.best_degree, {"A": A, "B": B, "H": H}),
    "feedback.detectability": (feedback.detectability, {"A": A, "H": H}),
    "feedback.stabilisability": (feedback.stabilisability, {"A": A, "B": B}),
    "infosets.DubinsReachable.support": (REACHED.support, {"directions": TIMES}),
    "infosets.DubinsReachable.contains": (REACHED.contains, {"points": POINTS[:, :2]}),
    "infosets.dubins_reachable": (
        lambda position: infosets.dubins_reachable(1.0, position=position).position, {"position": np.ones(2)},
    ),
    "infosets.SupportPolygons": (infosets.SupportPolygons, {"values": np.ones((2, 4))}),
    "infosets.SupportPolygons.of_tight": (infosets.SupportPolygons.of_tight, {"values": np.ones((2, 4))}),
    "infosets.SupportPolygons.around": (infosets.SupportPolygons.around, {"points": POINTS[:, :2], "m": 4}),
    "infosets.SupportPolygons.hull": (SQUARE.hull, {"other": 2 * np.ones((1, 4))}),
    "infosets.SupportPolygons.shift": (SQUARE.shift, {"by": np.ones((1, 2))}),
    "infosets.SupportPolygons.intersect": (SQUARE.intersect, {"other": 2 * np.ones((1, 4))}),
    "infosets.SupportPolygons.contains": (SQUARE.contains, {"points": POINTS[:, :2]}),
    "infosets.Region.box": (infosets.Region.box, {"centre": np.ones(2), "width": 1.0}),
    "infosets.Region.disc": (infosets.Region.disc, {"centre": np.ones(2), "radius": 1.0}),
    "infosets.Region.polygon": (infosets.Region.polygon, {"points": POINTS[:3, :2]}),
    "invariant.InvariantEstimator": (
        lambda times, covariance: (
            invariant.InvariantEstimator(times, [1], covariance=covariance).estimate(TIMES, invariant.value(1.0))
        ),
        {"times": TIMES, "covariance": np.eye(5)},
    ),
    "invariant.InvariantEstimator.estimate": (
        lambda h: invariant.InvariantEstimator(TIMES, [1]).estimate(h, invariant.value(1.0)), {"h": TIMES},
    ),
    "invariant.derivative": (lambda t: invariant.derivative(t)(S**2), {"t": TIMES}),
    "invariant.integral": (lambda a, b: invariant.integral(a, b)(lambda x: x), {"a": TIMES, "b": TIMES + 1}),
    "invariant.value": (lambda t: invariant.value(t)(lambda x: x**2), {"t": TIMES}),
    "plotting.estimate": (plotting.estimate, {"times": TIMES, "mean": TIMES, "deviation": TIMES}),
    "reconstruction.Reconstruction.position": (MOTION.position, {"t": TIMES}),
    "reconstruction.Reconstruction.velocity": (MOTION.velocity, {"t": TIMES}),
    "reconstruction.Reconstruction.acceleration": (MOTION.acceleration, {"t": TIMES}),
    "reconstruction.Reconstruction.standard_deviations": (MOTION.standard_deviations, {"t": TIMES}),
    "reconstruction.reconstruct": (
        lambda t, h, sigma: reconstruction.reconstruct(t, h, sigma, M=1.0).position(0.5),
        {"t": TIMES, "h": TIMES**2, "sigma": np.ones(5)},
    ),
    "reconstruction.SweepGains": (
        lambda t, sigma: reconstruction.SweepGains(t, sigma, 1.0).t, {"t": TIMES, "sigma": np.ones(5)},
    ),
    "reconstruction.SweepGains.apply": (reconstruction.SweepGains(TIMES, 0.1, 1.0).apply, {"h": TIMES}),
    "reference_curves.ReferenceCurves": (
        lambda t_nodes: reference_curves.ReferenceCurves(decay, t_nodes, [[1.0]]).nodes, {"t_nodes": TIMES},
    ),
    "reference_curves.ReferenceCurves.__call__": (lambda t: CURVES(t, [1.0]), {"t": TIMES[:3]}),
    "reference_curves.ReferenceCurves.derivative": (lambda t: CURVES.derivative(t, [1.0]), {"t": TIMES[:3]}),
    "reference_curves.ReferenceCurves.defect": (lambda t: CURVES.defect(t, [1.0]), {"t": TIMES[:3]}),
    "reference_curves.ReferenceCurves.integrated": (lambda t: CURVES.integrated(t, [1.0]), {"t": TIMES[:3]}),
    "reference_curves.lebesgue_constant": (reference_curves.lebesgue_constant, {"nodes": TIMES}),
    "solvability.analyse": (
        lambda matrix, W, matrix_error: solvability.analyse(matrix, W, matrix_error=matrix_error).singular_values,
        {"matrix": LINE, "W": np.ones(5), "matrix_error": LINE / 1024},
    ),
    "solvability.solve": (
        lambda matrix, Z, W, matrix_error: solvability.solve(matrix, Z, W, matrix_error=matrix_error).x,
        {"matrix": LINE, "Z": TIMES, "W": np.ones(5), "matrix_error": LINE / 1024},
    ),
    "solvability.Solvability.noise_bound": (LINEAR.noise_bound, {"e": np.ones(5), "state": np.ones(2)}),
    "solvability.Solvability.relative_noise_bound": (LINEAR.relative_noise_bound, {"e": np.ones(5), "state": np.ones(2)}),
    "solvability.clohessy_wiltshire": (lambda times: solvability.clohessy_wiltshire(0.5, times), {"times": TIMES}),
    "solvability.stack": (
        lambda H, Phi: solvability.stack(H, Phi), {"H": H, "Phi": np.stack([TWO, A])},
    ),
    "solvability.transition": (solvability.transition, {"A": A, "times": TIMES}),
    "solvability.linearise": (
        lambda state, times: solvability.linearise(decay, decay, state, times).matrix,
        {"state": np.ones(1), "times": TIMES},
    ),
    "stability.linear_stability": (stability.linear_stability, {"A": A}),
    "stability.characteristic_polynomial": (stability.characteristic_polynomial, {"A": A, "symbol": S}),
    "stability.classify_planar": (stability.classify_planar, {"A": A}),
    "structure.controller_canonical_form": (structure.controller_canonical_form, {"A": A, "b": B}),
    "structure.observer_canonical_form": (structure.observer_canonical_form, {"A": A, "h": H}),
    "structure.decompose_by_inputs": (structure.decompose_by_inputs, {**A_B, "form": "sequential"}),
    "structure.decompose_by_outputs": (structure.decompose_by_outputs, {**A_H, "form": "sequential"}),
    "structure.controllability_decomposition": (structure.controllability_decomposition, {"A": A, "B": B}),
    "structure.observability_decomposition": (structure.observability_decomposition, {"A": A, "H": H}),
    "structure.distance_to_uncontrollable": (structure.distance_to_uncontrollable, {"A": A, "B": B}),
    "structure.distance_to_unobservable": (structure.distance_to_unobservable, {"A": A, "H": H}),
    "structure.controllability_gramian": (structure.controllability_gramian, {"A": A, "B": B, "duration": 1.0}),
    "structure.scalar_equation": (structure.scalar_equation, {"A": EXACT["A"], "b": EXACT["B"], "h": EXACT["H"]}),
    "structure.controllability_matrix": (structure.controllability_matrix, {"A": A, "B": B}),
    "structure.observability_matrix": (structure.observability_matrix, {"A": A, "H": H}),
    "structure.with_measurement_error": (structure.with_measurement_error, {"A": A, "H": H, "S": ONE, "c": ONE}),
    "structure.first_order_form": (structure.first_order_form, {**MECHANICAL, "L": B, "H1": H, "H2": H}),
    "structure.mechanical_controllability": (structure.mechanical_controllability, {**MECHANICAL, "L": B}),
    "structure.mechanical_observability": (structure.mechanical_observability, {**MECHANICAL, "H1": H, "H2": H}),
    "structure.controllability": (structure.controllability, {"A": A, "B": B}),
    "structure.observability": (structure.observability, {"A": A, "H": H}),
    "structure.controllable_subspace": (structure.controllable_subspace, {"A": A, "B": B}),
    "structure.unobservable_subspace": (structure.unobservable_subspace, {"A": A, "H": H}),
}  # fmt: skip

#: What an argument is called in messages, where that is not its name.
NAMED = {"b": "b|B", "h": "h|H", "state": "state|e"}


#: Functions whose arrays are read by another of the table, or that take symbols only.
ELSEWHERE = {
    "feedback.loop_function", "stability.jury_conditions",
    "reference_curves.TensorInterpolant.__call__", "reference_curves.TensorInterpolant.derivative",
    "reference_curves.ReferenceCurves.output", "invariant.SlidingWindow.estimate",
    "infosets.InformationSet", "infosets.ConstantSpeedInformationSet",
    "structure.controllability_conditions", "structure.observability_conditions",
    "structure.time_varying_conditions", "structure.time_varying_observability_matrix",
    "stability.stability_conditions", "solvability.guarantee",
}  # fmt: skip
SYMBOLS = "symbols beside floats"
#: What is read where other functions refuse it: dates are times, gaps may be masked or None.
DATES = {"datetime64", "datetime"}
TIMES_OF_RECORDS = {
    ("estimation.KalmanFilter.sampled", "times"), ("estimation.simulate_continuous", "times"),
    ("invariant.InvariantEstimator", "times"),
}  # fmt: skip
READ = {
    ("estimation.Measurement", "z", "None"),
    ("estimation.KalmanFilter.run", "z", "masked"),
    ("estimation.ExtendedKalmanFilter.run", "z", "masked"),
}


def exported():
    """Yield the public functions and classes as (package, name, syntax tree)."""
    root = Path(trajlib.__file__).parent
    for stub in sorted(root.glob("*/__init__.pyi")):
        for line in ast.parse(stub.read_text(encoding="utf-8")).body:
            if isinstance(line, ast.ImportFrom):
                home = root.joinpath(*line.module.split(".")[1:]).with_suffix(".py")
                tree = ast.parse(home.read_text(encoding="utf-8"))
                for alias in line.names:
                    for node in tree.body:
                        if getattr(node, "name", None) == alias.name:
                            yield stub.parent.name, alias.name, node


def arrays_of(nodes):
    """Return the names of annotated arguments or fields that are matrices or arrays."""
    return [
        getattr(node, "arg", None) or node.target.id
        for node in nodes
        if node.annotation is not None
        and {"MatrixLike", "ArrayLike"} & set(ast.unparse(node.annotation).split(" "))
    ]


def functions_with_arrays():
    """Return (name in `CALLS`, arguments that are arrays) of all public functions."""
    found = {}
    for package, name, node in exported():
        if isinstance(node, ast.FunctionDef):
            found[f"{package}.{name}"] = arrays_of(node.args.args + node.args.kwonlyargs)
            continue
        if not isinstance(node, ast.ClassDef):
            continue
        fields = [part for part in node.body if isinstance(part, ast.AnnAssign)]
        found[f"{package}.{name}"] = arrays_of(fields)
        for part in node.body:
            if isinstance(part, ast.FunctionDef):
                own = arrays_of(part.args.args + part.args.kwonlyargs)
                key = f"{package}.{name}" + f".{part.name}" * (part.name != "__init__")
                found[key] = found.get(key, []) + own
    return {name: arguments for name, arguments in found.items() if arguments}


ARRAYS = functions_with_arrays()


def test_each_public_function_with_arrays_has_a_row():
    listed = {name.split(".", 1)[1] for name in CALLS}
    assert {name for name in ARRAYS if name.split(".", 1)[1] not in listed} == ELSEWHERE


CASES = [
    (name, argument)
    for name, (_, arguments) in CALLS.items()
    for argument, value in arguments.items()
    if isinstance(value, np.ndarray | sp.MatrixBase) and not getattr(value, "free_symbols", None)
]


def floats_of(value):
    return np.array(value.tolist(), dtype=float)


def equal_kinds(value):
    """Return arrays of other libraries with the same entries."""
    kinds = {
        "list": value.tolist(),
        "object array": value.astype(object),
        "masked without a mask": np.ma.masked_array(value),
        "float32": value.astype(np.float32),
        "Fraction": np.vectorize(Fraction, otypes=[object])(value).tolist(),
        "Decimal": np.vectorize(lambda x: Decimal(float(x)), otypes=[object])(value).tolist(),
        "SymPy objects": np.vectorize(sp.Rational, otypes=[object])(value),
    }
    if value.ndim == 1:
        kinds["Series"] = pd.Series(value)
    if value.ndim == 2:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", PendingDeprecationWarning)
            matrix = np.asmatrix(value)
        kinds |= {
            "DataFrame": pd.DataFrame(value),
            "DataFrame of SymPy": pd.DataFrame(kinds["SymPy objects"]),
            "np.matrix": matrix,
            "sparse": scipy.sparse.csr_array(value),
        }
    return kinds


def foreign_kinds(value):
    """Return what is no array of real numbers."""
    filled = np.ones(value.shape)
    masked = np.ma.masked_array(filled, mask=np.arange(value.size).reshape(value.shape) == 0)
    return {
        "text": filled.astype(str),
        "text in a list": filled.astype(str).tolist(),
        "bool": filled.astype(bool),
        "complex": filled * 1j,
        "timedelta64": filled.astype("timedelta64[s]"),
        "durations": np.full(value.shape, timedelta(seconds=1)).tolist(),
        "datetime64": filled.astype("datetime64[s]"),
        "datetime": np.full(value.shape, datetime(2026, 11, 28)),
        "None": np.full(value.shape, None),
        "masked": masked,
        "a word": "identity",
        "a set": {1, 2},
        SYMBOLS: np.full(value.shape, V, dtype=object),
    }


def outcome(function, arguments):
    """Return the repr of a result, or the error."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            warnings.simplefilter("ignore", PendingDeprecationWarning)
            return repr(function(**arguments))
    except (TypeError, ValueError) as error:
        return error
    finally:
        plt.close("all")


def is_named(error, argument):
    names = NAMED.get(argument, argument).split("|")
    return isinstance(error, TypeError | ValueError) and str(error).startswith(
        tuple(f"{name}:" for name in names)
    )


@pytest.mark.parametrize("name, argument", CASES)
def test_every_form_of_an_array_is_read_or_refused(name, argument):
    function, arguments = CALLS[name]
    value = floats_of(arguments[argument])
    right = outcome(function, arguments)
    assert isinstance(right, str), right
    for kind, other in equal_kinds(value).items():
        found = outcome(function, arguments | {argument: other})
        exact = isinstance(arguments[argument], sp.MatrixBase) and "expected exact" in str(found)
        assert isinstance(found, str) or exact or is_named(found, argument), (kind, found)
        if not isinstance(arguments[argument], sp.MatrixBase) and kind in SAME_FLOATS:
            assert found == right, kind


#: Forms of floats, which give the same as an array.
SAME_FLOATS = {
    "list", "object array", "masked without a mask", "float32", "Series", "DataFrame", "np.matrix", "sparse",
}  # fmt: skip


@pytest.mark.parametrize("name, argument", CASES)
def test_what_is_no_array_of_numbers_is_refused_by_name(name, argument):
    function, arguments = CALLS[name]
    value = floats_of(arguments[argument])
    for kind, other in foreign_kinds(value).items():
        dates = (name, argument) in TIMES_OF_RECORDS and kind in DATES
        if (name, argument, kind) in READ or dates:
            continue
        found = outcome(function, arguments | {argument: other})
        # A matrix of symbols is exact where no other one is of floats.
        taken = kind == SYMBOLS and (isinstance(found, str) or "parameters:" in str(found))
        assert taken or is_named(found, argument), (kind, found)


FRAME = pd.DataFrame([[0.0, 1.0], [-9.81, -3.0]])


@pytest.mark.parametrize(
    "function",
    [
        lambda A: feedback.lqr(A, B, TWO, ONE).gain,
        lambda A: estimation.stationary_filter(A, H, TWO, ONE).gain,
        lambda A: structure.observability_matrix(A, H),
        lambda A: structure.observability_matrix(A, [1, 0]),
    ],
)
def test_a_data_frame_of_decimals_is_one_of_floats(function):
    frame, array = function(FRAME), function(FRAME.to_numpy())
    assert isinstance(frame, np.ndarray) and np.array_equal(frame, array)


def test_a_data_frame_of_expressions_is_exact():
    k = sp.Symbol("k")
    found = structure.observability_matrix(pd.DataFrame([[0, 1], [k, sp.Rational(1, 3)]]), [1, 0])
    assert found == sp.Matrix([[1, 0], [0, 1]])


def test_fractions_and_decimals_are_exact():
    A = [[Fraction(1, 3), Decimal("0.1")], [0, 1]]
    assert structure.observability_matrix(A, [1, 0])[1, :] == sp.Matrix(
        [[sp.Rational(1, 3), sp.Rational(1, 10)]]
    )


ERRORS = [
    (lambda: FILTER.run(RECORD, START, inputs=np.ones((5, 1))), r"inputs: expected the shape \(5, 2\), got \(5, 1\)"),
    (lambda: FILTER.run(RECORD, START, inputs=np.full((5, 2), np.nan)), r"inputs: expected finite numbers, but entry \(0, 0\)"),
    (lambda: FILTER.run(RECORD, START, inputs=np.ones((5, 2), "timedelta64[s]")), "inputs: expected 2 numbers for each step"),
    (lambda: FILTER.run(RECORD, START, inputs=np.ones((4, 2))), r"inputs: expected the shape \(5, 2\), got \(4, 2\)"),
    (lambda: FILTER.run(RECORD, START, missing=[0] * 5), "missing: expected booleans"),
    (lambda: FILTER.run(RECORD, START, missing=np.ma.masked_array([True] * 5, [True] * 5)), "missing: .* masked"),
    (lambda: FILTER.run(RECORD, Moments([0, 0, 0], sp.eye(3))), "mean: expected 2 components, got 3"),
    (lambda: EXTENDED.run(RECORD, START, inputs=np.ones(5, "timedelta64[s]")), "inputs: expected 1 number for each step"),
    (lambda: EXTENDED.run(RECORD, START), "inputs: expected 1 number"),
    (lambda: Moments([1, 2, 3], [[1, 0], [0, 1]]), "mean: expected 2 components, got 3"),
    (lambda: Moments(np.ones(1), TWO), "mean: expected 2 components, got 1"),
    (lambda: estimation.simulate_discrete(PHI, TWO, Moments(0, 1), 3, 1, 1), "covariance: expected a matrix 2 x 2"),
    (lambda: feedback.place(A, B, [-1, np.nan]), r"eigenvalues: expected finite numbers, got nan"),
    (lambda: feedback.place(A, B, [-1]), "eigenvalues: expected 2 numbers, got 1"),
    (lambda: estimation.continuous_moments(A, TWO, START, np.timedelta64(1, "s")), "t: expected a SymPy expression or a number"),
    (lambda: estimation.discretise(A, TWO, "1"), "step: expected a SymPy expression"),
    (lambda: estimation.discretise(A, TWO, -1), "step: expected a time that is not negative"),
    (lambda: estimation.continuous_moments(A, TWO, START, np.inf), "t: expected a time that is not negative"),
    (lambda: BUCY.covariance(TWO, datetime(2026, 11, 28)), "t: expected a SymPy expression or a number"),
    (
        lambda: estimation.filter_measurements(A, TWO, START, [estimation.Measurement(datetime(2026, 11, 28), 1, H, 1)]),
        "time: expected a SymPy expression or a number",
    ),
    (lambda: estimation.UnscentedKalmanFilter([STATE[0]], [STATE[0]], [STATE[0]], 0, 1, kappa="1"), "kappa: expected a number"),
    (lambda: estimation.UnscentedKalmanFilter([STATE[0]], [STATE[0]], [STATE[0]], 0, 1, kappa=-1), "kappa: expected a number that is not negative"),
]  # fmt: skip


@pytest.mark.parametrize("call, message", ERRORS)
def test_errors_name_the_argument_and_what_was_expected(call, message):
    with pytest.raises((TypeError, ValueError), match=rf"^{message}"):
        call()


def test_masked_entries_of_a_record_are_missing():
    masked = np.ma.masked_array(RECORD.copy(), mask=[[0], [1], [0], [0], [1]])
    masked.data[1] = np.nan
    run = FILTER.run(masked, START)
    right = FILTER.run(RECORD, START, missing=[False, True, False, False, True])
    assert np.array_equal(run.estimates, right.estimates)
    assert np.isnan(run.innovations[[1, 4]]).all()


def test_one_input_of_one_state_may_be_a_flat_list():
    one = estimation.KalmanFilter(1, 1, 1, 1)
    flat = one.run(np.ones(3), Moments(0, 1), inputs=[1.0, 2.0, 3.0])
    column = one.run(np.ones(3), Moments(0, 1), inputs=[[1.0], [2.0], [3.0]])
    assert np.array_equal(flat.estimates, column.estimates) and flat.predicted[1] == 1.5


def test_inputs_of_several_series():
    both = np.stack([RECORD, 2 * RECORD])
    inputs = np.stack([np.ones((5, 2)), np.zeros((5, 2))])
    run = FILTER.run(both, START, inputs=inputs)
    for i in range(2):
        alone = FILTER.run(both[i], START, inputs=inputs[i])
        np.testing.assert_allclose(run.estimates[i], alone.estimates, rtol=1e-13)


@pytest.mark.parametrize(
    "result, text",
    [
        (FILTER, "KalmanFilter of 2 states, 1 outputs"),
        (EXTENDED, "ExtendedKalmanFilter of 2 states, 1 outputs"),
        (
            estimation.UnscentedKalmanFilter([STATE[0]], [STATE[0]], [STATE[0]], 0, 1),
            "UnscentedKalmanFilter of 1 states, 1 outputs",
        ),
        (BUCY, "ContinuousFilter of 2 states, 1 outputs"),
        (BUCY.run(RECORD[:4], TIMES, START), "ContinuousRun of 4 steps, 2 states"),
        (
            estimation.filter_measurements(
                A, TWO, START, [estimation.Measurement(1, [1.0], H, ONE)]
            ),
            "ContinuousDiscreteRun of 1 measurements",
        ),
    ],
)
def test_the_text_of_a_result_has_no_arrays(result, text):
    assert repr(result) == text
