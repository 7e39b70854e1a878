"""Equations of small motions of a mechanical system, M q'' + K q = L u.

Any combination of the equations is accepted.

Equations may be added, multiplied by numbers and written in any order: what they say is q'' = -M^-1
K q + M^-1 L u, and this is compared.

No check here is declared by a reference: any combination of the equations is right.
"""

import numpy as np
import sympy as sp

from workbook.checks.contract.claims import Matrix, Parts
from workbook.checks.contract.tolerance import EXACT
from workbook.checks.contract.verdict import UnsuitableData, Wrong, judged
from workbook.checks.references.exceptional_values import judge_everywhere
from workbook.checks.tools.comparisons import SameSides
from workbook.checks.tools.samples import general_values, in_every_case
from workbook.checks.tools.values import entry_uncertainties, matrix_at, perturbed_arrays
from workbook.checks.tools.wording import number_text, where_text


def _like(name):
    return Matrix("parameters", shape=lambda data: getattr(data["system"], name).shape)


@judged(
    Parts(
        _like("M"),
        _like("K"),
        _like("L"),
        expected="a list of three matrices, [M, K, L] of M q'' + K q = L u",
    ),
    system="Mechanical",
)
def mechanical_equations(claim, system, parameters=()):
    """Check the matrices [M, K, L] of the equations M q'' + K q = L u of a `Mechanical` system.

    Can decide when M, K and L hold numbers or parameters, which get sample values. A factor of an
    equation does not matter.

    Examples
    --------
    >>> from workbook.systems import Mechanical
    >>> spring = Mechanical(M=[[2]], D=[[0]], K=[[8]], L=[[1]])
    >>> checks.mechanical_equations([[[1]], [[4]], [sp.Rational(1, 2)]], spring).status
    'right'
    >>> checks.mechanical_equations([[[2]], [[4]], [1]], spring).status
    'wrong'
    """
    if system.M.det().is_zero:
        raise UnsuitableData("system: expected an M that has an inverse")
    for values in in_every_case(general_values(parameters), claim):
        mass, *claimed = (matrix_at(part, values) for part in claim)
        if not np.linalg.cond(mass) < 1e12:
            raise Wrong(
                "your equations do not determine the accelerations: M has no "
                f"inverse{where_text(values)}"
            )
        true_mass, *true = (
            np.array(part.subs(values), dtype=float) for part in (system.M, system.K, system.L)
        )
        mass_uncertainty, *uncertainties = (entry_uncertainties(part, values) for part in claim)
        for claimed_part, true_part, uncertainty, name, sign in zip(
            claimed, true, uncertainties, "qu", (-1, 1)
        ):
            perturbed = perturbed_arrays((mass, claimed_part), (mass_uncertainty, uncertainty))
            rates = np.linalg.solve(mass, claimed_part)
            true_rates = np.linalg.solve(true_mass, true_part)
            uncertain = sum(abs(np.linalg.solve(*parts) - rates) for parts in perturbed)
            yield SameSides(
                rates,
                true_rates,
                EXACT * max(abs(true_rates).max(), 1e-300) + uncertain + np.zeros(rates.shape),
                lambda point: (
                    f"by your equations {name}"
                    f"{point[1] + 1 if rates.shape[1] > 1 or name == 'q' else ''} enters the "
                    f"acceleration of q{point[0] + 1} with the coefficient "
                    f"{number_text(sign * rates[point])}"
                    f"{where_text(values)}: this does not satisfy Lagrange's equations of the given energies"
                ),
                1.0,
            )
    judge_everywhere(
        claim[0],
        parameters,
        lambda: sp.true,
        "your equations are undefined",
        "your equations do not determine the accelerations, since M has no inverse,",
    )
    return "solved for the accelerations they are the equations that the energies give"
