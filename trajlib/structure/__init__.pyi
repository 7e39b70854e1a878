# Written by `python -m trajlib._stubs`.
from trajlib.structure.canonical import CanonicalForm as CanonicalForm
from trajlib.structure.canonical import controller_canonical_form as controller_canonical_form
from trajlib.structure.canonical import observer_canonical_form as observer_canonical_form
from trajlib.structure.components import ComponentDecomposition as ComponentDecomposition
from trajlib.structure.components import decompose_by_inputs as decompose_by_inputs
from trajlib.structure.components import decompose_by_outputs as decompose_by_outputs
from trajlib.structure.decomposition import Decomposition as Decomposition
from trajlib.structure.decomposition import (
    controllability_decomposition as controllability_decomposition,
)
from trajlib.structure.decomposition import (
    observability_decomposition as observability_decomposition,
)
from trajlib.structure.distance import Distance as Distance
from trajlib.structure.distance import distance_to_uncontrollable as distance_to_uncontrollable
from trajlib.structure.distance import distance_to_unobservable as distance_to_unobservable
from trajlib.structure.gramian import controllability_gramian as controllability_gramian
from trajlib.structure.input_derivatives import ScalarEquation as ScalarEquation
from trajlib.structure.input_derivatives import scalar_equation as scalar_equation
from trajlib.structure.input_derivatives import state_form as state_form
from trajlib.structure.kalman_matrices import controllability_matrix as controllability_matrix
from trajlib.structure.kalman_matrices import observability_matrix as observability_matrix
from trajlib.structure.lagrange import SmallMotions as SmallMotions
from trajlib.structure.lagrange import small_motions as small_motions
from trajlib.structure.measurement_errors import time_varying_conditions as time_varying_conditions
from trajlib.structure.measurement_errors import (
    time_varying_observability_matrix as time_varying_observability_matrix,
)
from trajlib.structure.measurement_errors import with_measurement_error as with_measurement_error
from trajlib.structure.mechanical import first_order_form as first_order_form
from trajlib.structure.mechanical import mechanical_controllability as mechanical_controllability
from trajlib.structure.mechanical import mechanical_observability as mechanical_observability
from trajlib.structure.parameters import RankConditions as RankConditions
from trajlib.structure.parameters import controllability_conditions as controllability_conditions
from trajlib.structure.parameters import observability_conditions as observability_conditions
from trajlib.structure.rank_tests import HiddenMode as HiddenMode
from trajlib.structure.rank_tests import RankTest as RankTest
from trajlib.structure.rank_tests import controllability as controllability
from trajlib.structure.rank_tests import observability as observability
from trajlib.structure.subspaces import controllable_subspace as controllable_subspace
from trajlib.structure.subspaces import unobservable_subspace as unobservable_subspace
