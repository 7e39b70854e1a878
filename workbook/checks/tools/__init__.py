"""What checks of several themes use: values at places, samples, conditions, places of parameters,
words."""
