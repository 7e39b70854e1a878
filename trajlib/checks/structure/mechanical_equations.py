"""The equations of small motions of a mechanical system, M q'' + K q = L u, in whatever way they are combined.

Equations may be added, multiplied by numbers and written in any order: what they say is q'' = -M^-1 K q + M^-1 L u,
and this is compared.
"""

import numpy as np

from trajlib.checks.contract import coercion
from trajlib.checks.contract.tolerance import share
from trajlib.checks.contract.verdict import Invalid, Wrong, judged
from trajlib.checks.tools.values import matrix_at
from trajlib.checks.tools.wording import number_text, where_text
from trajlib.checks.truths.pairs import general_values


@judged
def mechanical_equations(answer, M, K, L, parameters=()):
    """The list [M, K, L] of equations M q'' + K q = L u with the accelerations of the given ones (M, K: n x n; L: n x
    s)."""
    if not isinstance(answer, (list, tuple)) or len(answer) != 3:
        raise Invalid("expected a list of three matrices, [M, K, L] of M q'' + K q = L u")
    claim = [coercion.as_matrix(part, parameters, true.shape) for part, true in zip(answer, (M, K, L))]
    tolerance = max(share(*claim), 1e-9)
    for values in general_values(parameters):
        mass, stiffness, push = (matrix_at(part, values) for part in claim)
        if not np.linalg.cond(mass) < 1e12:
            raise Wrong(f"your equations do not determine the accelerations: M has no inverse{where_text(values)}")
        true_mass, *true = (np.array(part.subs(values), dtype=float) for part in (M, K, L))
        for said, right, what in zip((stiffness, push), true, ("q{}", "u{}")):
            own, wanted = np.linalg.solve(mass, said), np.linalg.solve(true_mass, right)
            bad = ~(abs(own - wanted) <= tolerance * max(abs(wanted).max(), 1e-300))
            if bad.any():
                i, j = np.argwhere(bad)[0]
                sign = -1 if what[0] == "q" else 1
                name = what.format(j + 1) if what[0] == "q" or L.cols > 1 else "u"
                raise Wrong(f"by your equations {name} enters the acceleration of q{i + 1} with the coefficient "
                            f"{number_text(sign * own[i, j])}{where_text(values)}, and that is not what the energies "
                            "give")
    return "solved for the accelerations they are the equations that the energies give"
