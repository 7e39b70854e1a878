# Written by `python -m trajlib._stubs`.
from trajlib.reconstruction.fitting import Reconstruction as Reconstruction
from trajlib.reconstruction.fitting import reconstruct as reconstruct
from trajlib.reconstruction.sweep import SweepGains as SweepGains
from trajlib.reconstruction.sweep import sweep_eigenvalues as sweep_eigenvalues
