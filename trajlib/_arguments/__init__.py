"""Reading of arguments: each form that is accepted becomes one, all others are refused.

An error names the argument, what was expected and what was got; TypeError where the kind is wrong,
ValueError where the value is. The modules are `arrays` (all forms of an array, on which the others
build), `symbols` (symbols, expressions, vector fields), `numbers` (numbers, times, names), `matrices`
(exact or floats, the pairs (A, H) and (A, B)), `covariances`, `records` (measurements with gaps,
inputs) and `integration` (method and budget).
"""
