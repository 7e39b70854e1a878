"""All hostile submissions: more than forty kinds, by what they attack."""

from hostile.endings import ENDINGS
from hostile.figures import FIGURES
from hostile.files import FILES
from hostile.forging import FORGING
from hostile.objects import OBJECTS
from hostile.outside import OUTSIDE
from hostile.patching import PATCHING
from hostile.reading import READING
from hostile.resources import RESOURCES

ATTACKS = [
    *READING,
    *OUTSIDE,
    *RESOURCES,
    *ENDINGS,
    *PATCHING,
    *FORGING,
    *OBJECTS,
    *FIGURES,
    *FILES,
]
