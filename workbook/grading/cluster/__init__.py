"""Grading on the machines of a Dask cluster: the coordinator here, the Dask workers there."""
