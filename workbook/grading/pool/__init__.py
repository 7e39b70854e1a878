"""Judge many notebooks at once, each in processes of its own."""
