from .checks.check import Check
from .checks.check_parts import check_parts
from .make_parts import make_parts as parts
from .part import Part, PartSet

__all__ = ["Check", "Part", "PartSet", "check_parts", "parts"]
