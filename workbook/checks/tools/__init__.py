"""Tools of checks: comparisons, values of expressions, samples, domains, conditions, wording."""
