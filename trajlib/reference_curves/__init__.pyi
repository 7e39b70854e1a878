# Written by `python -m trajlib._stubs`.
from trajlib.reference_curves.curves import ReferenceCurves as ReferenceCurves
from trajlib.reference_curves.interpolation import TensorInterpolant as TensorInterpolant
from trajlib.reference_curves.interpolation import chebyshev_nodes as chebyshev_nodes
from trajlib.reference_curves.interpolation import lebesgue_constant as lebesgue_constant
from trajlib.reference_curves.residuals import Residual as Residual
