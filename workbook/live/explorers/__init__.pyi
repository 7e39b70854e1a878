# Written by `python -m workbook._stubs`.
from workbook.live.explorers.by_name import explore as explore
from workbook.live.explorers.by_name import list_explorers as list_explorers
from workbook.live.explorers.cancellation import pole_zero_cancellation as pole_zero_cancellation
from workbook.live.explorers.circle import circle_synthesis as circle_synthesis
from workbook.live.explorers.fastest import fastest_motion as fastest_motion
from workbook.live.explorers.manual import manual_control as manual_control
from workbook.live.explorers.phase import phase_portrait as phase_portrait
from workbook.live.explorers.region import region_of_stability as region_of_stability
from workbook.live.explorers.unobservability import (
    distance_to_unobservable as distance_to_unobservable,
)
