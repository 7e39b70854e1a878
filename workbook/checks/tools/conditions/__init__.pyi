# Written by `python -m workbook._stubs`.
from workbook.checks.tools.conditions.comparison import compare as compare
from workbook.checks.tools.conditions.comparison import (
    contradiction_message as contradiction_message,
)
from workbook.checks.tools.conditions.comparison import decide as decide
from workbook.checks.tools.conditions.decimals import readings as readings
from workbook.checks.tools.conditions.evaluation import Condition as Condition
from workbook.checks.tools.conditions.evaluation import allowed as allowed
from workbook.checks.tools.conditions.reference_condition import Case as Case
from workbook.checks.tools.conditions.reference_condition import (
    ReferenceCondition as ReferenceCondition,
)
from workbook.checks.tools.conditions.reference_condition import exactly as exactly
from workbook.checks.tools.conditions.sampling import on_borders as on_borders
