"""Descriptions of the data of checks by the names of their arguments, one meaning in each theme.

`judged` adds them to the docstring of a check, so `help` and the page of checks show them. Data that
are of another kind than the records named there are refused (`contract.data_kinds`).
"""

COMMON = {
    "A": "n x n matrix",
    "B": "n x s matrix, a column for each control",
    "H": "m x n matrix, a row for each output",
    "field": "list of n expressions, the right-hand sides",
    "state": "list of n symbols",
    "parameters": "list of symbols",
    "parameter": "symbol",
}
RANGES = "dict from symbols to intervals or finite sets"
#: Of checks that find a range themselves where there is none.
LIST_OR_RANGES = f"{COMMON['parameters']}, or {RANGES}"
SHAPES = {
    "algebra": COMMON
    | {
        "given": "condition, or list of them",
        "reference": "number, expression, or matrix, exact or with all its digits",
    },
    "stability": COMMON
    | {
        "angle": "symbol",
        "angular": "expression of the radius",
        "at": "list of n expressions, or dict from symbols of the state to functions of time",
        "constants": "list of symbols",
        "controls": "list of s symbols",
        "deviations": "list of two symbols",
        "domain": "dict from symbols to intervals",
        "expression": "expression of the state",
        "function": "expression of the state",
        "given": "condition, or list of them",
        "integer": "symbol",
        "degree": "number",
        "kind": '"asymptotically stable", "unstable", "focus", "node", "saddle", "unique" or None',
        "part": "list of those symbols of the state that are meant",
        "polar": "list of two symbols",
        "program": "dict from symbols of the state to functions of time",
        "radial": "expression of the radius",
        "radius": "symbol, or number",
        "start": "symbols of the initial state",
        "system": "polynomial in one more symbol, n x n matrix, differential equation, or Deviations",
        "through": "list of points",
        "time": "symbol",
        "zeros": "list of n expressions of the state",
    },
    "estimation": COMMON
    | {
        "angle": "symbol",
        "at": "number, or expression of the parameters",
        "covariance": "symmetric n x n matrix of symbols",
        "deviations": "list of positive numbers or expressions",
        "estimates": "list of n symbols",
        "first": "expression of the vector, or list of them",
        "given": "condition, or list of them",
        "law": "covariance matrix of the vector, or dict from its values to their probabilities",
        "measured": "list of pairs",
        "moment": '"before" or "after"',
        "noises": "list of columns of n expressions, for a single coordinate of expressions",
        "of": "2 x n matrix, a row for each quantity",
        "outputs": "list of m symbols",
        "process": "Process",
        "start": "list of n symbols",
        "quantities": "list of expressions of the vector",
        "second": "expression of the vector, or list of them",
        "time": "symbol",
        "times": "list of numbers",
        "unknowns": "list of symbols",
        "vector": "list of symbols",
    },
    "structure": COMMON
    | {
        "control": "function of time, u(t)",
        "duration": "number",
        "known": "Linear or Deviations",
        "motion": "function of time, y(t)",
        "other": "Linear or Deviations",
        "outputs": "list of symbols for z, z', ...",
        "own": "True or False",
        "part": '"state", "error" or None',
        "quantities": "dict from names to rows, or to expressions of the state",
        "start": "symbols of x(0)",
        "system": "Linear",
        "time": "symbol",
    },
    "feedback": COMMON
    | {
        "K": "s x n matrix",
        "L": "n x m matrix",
        "controls": "list of s symbols",
        "cost": "symmetric n x n matrix of symbols",
        "desired": "dict from symbols of the state to functions of time",
        "domain": "dict from symbols to intervals",
        "equation": "Scalar",
        "estimates": "list of n symbols",
        "gain": "matrix of symbols, or one",
        "kind": '"phase", "delay" or "disk"',
        "given": "condition, or list of them",
        "loop": "rational function of one more symbol, Linear or Quadratic",
        "degree": "number",
        "mu": "symbol",
        "outputs": "list of m symbols",
        "polynomial": "expression of the symbol",
        "problem": "Quadratic",
        "process": "Process",
        "start": "list of n symbols",
        "symbol": "symbol",
        "system": "Linear",
        "time": "symbol",
        "zeros": "list of n expressions of the state",
    },
    "pontryagin": COMMON
    | {
        "angle": "symbol",
        "by": "symbol of the control, or None",
        "change": 'pair of "bound" and "inside"',
        "control": "symbol of one of several controls, or None",
        "costates": "list of n symbols, in the order of the states",
        "count": "symbol",
        "curve": "tuple of a symbol, an expression, two expressions, a symbol and an interval, or None",
        "domain": "dict from symbols to intervals",
        "duration": "symbol, or expression",
        "ends": "list of two expressions of the variable",
        "functional": "Functional",
        "kind": '"switching", "dispersal" or "barrier"',
        "law": "expression of the time and of constants",
        "parameters": RANGES,
        "problem": "pontryagin.Problem with one control",
        "quantity": "expression of the state",
        "start": "condition on the state, or symbol of the parameter that a control begins with",
        "system": "Controlled",
        "target": "list of expressions that vanish there, or of the pairs of numbers between which it lies",
        "time": "symbol",
        "unknown": "dict from symbols to intervals",
        "value": "number, or expression",
        "variable": "symbol",
    },
    "research": COMMON
    | {
        "D": "number, or symbol",
        "M": "number, or symbol",
        "T": "symbol",
        "amplitude": "symbol",
        "bounds": "list of k expressions",
        "box": "dict from symbols to pairs of ends",
        "delta": "symbol",
        "direction": "number, or symbol: an angle from the first heading",
        "directions": "matrix with a row of two numbers for each direction",
        "duration": "number, or symbol",
        "eps": "number",
        "estimated": "symbol",
        "factor": "number",
        "final": "number",
        "first": "list of three symbols",
        "functional": "list of numbers or expressions, one for each function of the signal",
        "given": "condition, or list of them",
        "initial": "list of n symbols",
        "kappa": "symbol",
        "lam": "symbol, or expression of another one",
        "level": "symbol",
        "m": "integer",
        "matrix": "n x n matrix of the equations, or of the measurements",
        "motion": "expression of the variables of the nodes",
        "mu": "number",
        "neglected": "symbol",
        "nodes": "dict from symbols to lists of numbers",
        "nuisance": "list of lists of samples, one for each function of the nuisance",
        "omega": "symbol",
        "places": "dict from symbols to numbers",
        "points": "list of pairs of expressions",
        "quantity": "expression of level, slope and the variables, or of those of the box",
        "rate": "symbol",
        "relative": "list of two expressions of the time",
        "rho": "number, or symbol",
        "samples": "list of numbers or symbols, one for each time",
        "second": "list of three symbols",
        "sides": "k x 2 matrix, a row for each side",
        "signal": "list of lists of samples, one for each function of the signal",
        "sight": "list of three symbols",
        "sights": "list of directions of three numbers each",
        "slope": "symbol",
        "state": "list of n numbers",
        "system": "Linear",
        "t": "symbol",
        "tau": "symbol",
        "times": "list of numbers or symbols",
        "transition": "matrix with expressions of kappa",
        "turn": "list of two symbols",
        "unknowns": "list of n symbols",
        "value": "number",
    },
}


def descriptions_of(module, kinds):
    """Return the descriptions of data for the checks of a module, with those that differ."""
    return SHAPES.get(module.split(".")[-2:][0], COMMON) | kinds


def with_shapes(docstring, descriptions, names):
    """Return the docstring of a check with the section of its parameters, before its examples."""
    if not docstring:
        return docstring
    answer, *data = names
    lines = [f"{name} : {descriptions[name]}" if name in descriptions else name for name in data]
    section = ["Parameters", "----------", f"{answer} : the student's answer", *lines]
    text, heading, examples = docstring.rstrip().partition("    Examples\n    ----")
    parts = [text.rstrip(), "", *(f"    {line}" for line in section), ""]
    return "\n".join([*parts, heading + examples, "    "] if heading else [*parts[:-1], "    "])
