# Written by `python -m trajlib._stubs`.
from trajlib import estimation as estimation
from trajlib import feedback as feedback
from trajlib import flows as flows
from trajlib import infosets as infosets
from trajlib import invariant as invariant
from trajlib import plotting as plotting
from trajlib import pontryagin as pontryagin
from trajlib import reconstruction as reconstruction
from trajlib import reference_curves as reference_curves
from trajlib import solvability as solvability
from trajlib import stability as stability
from trajlib import structure as structure

__version__: str
