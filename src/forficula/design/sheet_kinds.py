"""Designs of sheets by the kind of their pattern."""

from __future__ import annotations

from forficula.design.file_pattern import FoldFile
from forficula.design.sheet import SheetDesign
from forficula.design.sheet_patterns import Kresling, MiuraOri, Pleats, Vertex, Waterbomb, Yoshimura


class MiuraDesign(SheetDesign):
    """A Miura sheet, and what is done to it."""

    pattern: MiuraOri


class WaterbombDesign(SheetDesign):
    """A waterbomb, or a sheet of them, and what is done to it."""

    pattern: Waterbomb


class YoshimuraDesign(SheetDesign):
    """A sheet or a tube of diamonds, and what is done to it."""

    pattern: Yoshimura


class KreslingDesign(SheetDesign):
    """A Kresling tower, and what is done to it."""

    pattern: Kresling


class PleatsDesign(SheetDesign):
    """A strip of pleats, and what is done to it."""

    pattern: Pleats


class VertexDesign(SheetDesign):
    """One vertex with the facets around it, and what is done to it."""

    pattern: Vertex


class FoldFileDesign(SheetDesign):
    """A sheet that a file holds, and what is done to it."""

    pattern: FoldFile
