"""Direct methods: from a problem to discrete solutions by nonlinear programming."""
