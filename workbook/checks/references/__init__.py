"""Reference solutions: what is true of the data, found without the solvers of trajlib."""
