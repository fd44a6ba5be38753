"""Designs of sheets by the kind of their pattern."""

from __future__ import annotations

from forficula.design.sheet import SheetDesign
from forficula.design.sheet_patterns import FoldFile, Pleats


class PleatsDesign(SheetDesign):
    """A strip of pleats, and what is done to it."""

    pattern: Pleats


class FoldFileDesign(SheetDesign):
    """A sheet that a FOLD file describes, and what is done to it."""

    pattern: FoldFile
