# Written by `python -m trajlib._stubs`.
from trajlib.infosets.dubins import DubinsReachable as DubinsReachable
from trajlib.infosets.dubins import dubins_reachable as dubins_reachable
from trajlib.infosets.errors import EmptyInformationSet as EmptyInformationSet
from trajlib.infosets.known_speed import ConstantSpeedInformationSet as ConstantSpeedInformationSet
from trajlib.infosets.polygons import SupportPolygons as SupportPolygons
from trajlib.infosets.regions import Region as Region
from trajlib.infosets.unknown_speed import InformationSet as InformationSet
