"""Reference optima of transfers, syntheses and functionals, found without the maximum principle."""
