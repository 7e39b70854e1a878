"""Reading of arguments: each form that is accepted becomes one, all others are refused.

An error names the argument, what was expected and what was got; TypeError where the kind is wrong,
ValueError where the value is. The modules are `symbols` (symbols, expressions, vector fields),
`numbers` (numbers, times, names, arrays), `matrices` (exact or floats, the pairs (A, H) and (A, B)),
`covariances` and `integration` (method and budget).
"""
