"""Which design a file holds, by the kind of its pattern."""

from __future__ import annotations

from collections.abc import Mapping

from forficula.design.design import Design
from forficula.design.fan import FanDesign
from forficula.design.joint import JointDesign
from forficula.design.sheet_kinds import (
    FoldFileDesign,
    KreslingDesign,
    MiuraDesign,
    PleatsDesign,
    VertexDesign,
    WaterbombDesign,
    YoshimuraDesign,
)
from forficula.design.tables import RejectedError
from forficula.names import one_of

KINDS: Mapping[str, type[Design]] = {
    "earwig-fan": FanDesign,
    "joint": JointDesign,
    "miura-ori": MiuraDesign,
    "waterbomb": WaterbombDesign,
    "yoshimura": YoshimuraDesign,
    "kresling": KreslingDesign,
    "pleats": PleatsDesign,
    "vertex": VertexDesign,
    "fold-file": FoldFileDesign,
}
# by kind, a named design to begin with
REFERENCES: Mapping[str, str] = {
    "earwig-fan": "binder2025",
    "joint": "binder2025-joint",
    "miura-ori": "miura-sheet",
    "waterbomb": "waterbomb-base",
    "kresling": "kresling-cell",
    "pleats": "letter-fold",
    "vertex": "bistable-clasp",
}
# those without one begin with this, and a pattern of their own
OTHER_REFERENCE = "miura-sheet"


def design_class(tables: Mapping[str, object]) -> type[Design]:
    """The class of a design's tables, not checked yet; of a fan where they do not say.

    Raises:
        RejectedError: a kind that there is not.
    """
    pattern = tables.get("pattern")
    kind = pattern.get("kind", "earwig-fan") if isinstance(pattern, Mapping) else "earwig-fan"
    if not isinstance(kind, str) or kind not in KINDS:
        raise RejectedError(["pattern", "kind"], f"pattern.kind: need {one_of(KINDS, kind)}")
    return KINDS[kind]


def kind_of(tables: Mapping[str, object]) -> str | None:
    """The kind of pattern that a design's tables, not checked yet, give; None where they give none."""
    pattern = tables.get("pattern")
    kind = pattern.get("kind") if isinstance(pattern, Mapping) else None
    return kind if isinstance(kind, str) else None


def reference_of(model: type[Design]) -> str | None:
    """The named design that one of a class can begin with; None where there is none."""
    return next((name for kind, name in REFERENCES.items() if KINDS[kind] is model), None)
