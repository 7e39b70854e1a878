from chromium import browser  # noqa: F401
from engine_page import addresses, packed  # noqa: F401
from firefox import firefox  # noqa: F401
