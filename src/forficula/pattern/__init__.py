"""Crease patterns: read, draw by formula, analyse and write."""

from forficula.public_names import public_names

_PUBLIC = (
    "CreasePattern",
    "EarwigFan",
    "PatternFacts",
    "Trace",
    "earwig_pattern",
    "read_fold",
    "read_folded_frames",
    "write_fold",
)

# all names are in __init__.pyi; those that are not public are for other modules of forficula
__getattr__, __dir__, __all__ = public_names(__name__, __file__, public=_PUBLIC)

# at once, because the import of this module by another one would put it in the place of the function
from forficula.pattern.facet_tree import facet_tree as facet_tree  # noqa: E402
