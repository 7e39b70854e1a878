"""What is true of the data, found without trajlib's solvers: rest points, unseen states, optima."""
