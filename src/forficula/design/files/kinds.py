"""The class of a design by the kind of its pattern."""

from __future__ import annotations

from collections.abc import Mapping
from typing import get_args

from forficula.design.assembly.assembly import AssemblyDesign, assembly_class, part_names
from forficula.design.design import Design
from forficula.design.families.fold_file import FoldFileDesign
from forficula.design.families.kresling import KreslingDesign
from forficula.design.families.miura_ori import MiuraDesign
from forficula.design.families.pleats import PleatsDesign
from forficula.design.families.vertex import VertexDesign
from forficula.design.families.waterbomb import WaterbombDesign
from forficula.design.families.yoshimura import YoshimuraDesign
from forficula.design.fans.fan import FanDesign
from forficula.design.fans.joint import JointDesign
from forficula.design.files.tables import RejectedError
from forficula.names import one_of
from forficula.quantities import as_written

_DESIGNS: tuple[type[Design], ...] = (
    FanDesign,
    JointDesign,
    MiuraDesign,
    WaterbombDesign,
    YoshimuraDesign,
    KreslingDesign,
    PleatsDesign,
    VertexDesign,
    FoldFileDesign,
)


def _kind(design: type[Design]) -> str:
    """Return the kind of pattern of a class of designs."""
    section = design.model_fields["pattern"].annotation
    assert section is not None
    return str(get_args(section.model_fields["kind"].annotation)[0])


KINDS: Mapping[str, type[Design]] = {_kind(design): design for design in _DESIGNS}
# kinds with tables of keys: those of patterns, and assemblies, whose parts have the keys of their own kinds
KEYED: Mapping[str, type[Design]] = {**KINDS, "assembly": AssemblyDesign}
# base of a new design whose kind has no named design; the new file has another pattern
OTHER_REFERENCE = "miura-sheet"


def design_class(tables: Mapping[str, object]) -> type[Design]:
    """Return the class of a design from its unchecked tables; the class of fans if they give no kind.

    Raises:
        RejectedError: an unknown kind, or a part that is not a table.
    """
    if names := part_names(tables):
        return assembly_class(tuple((name, _part_class(name, tables.get(name))) for name in names))
    pattern = tables.get("pattern")
    kind = pattern.get("kind", "earwig-fan") if isinstance(pattern, Mapping) else "earwig-fan"
    if not isinstance(kind, str) or kind not in KINDS:
        raise RejectedError(["pattern", "kind"], f"pattern.kind: need {one_of(KINDS, kind)}")
    return KINDS[kind]


def _part_class(name: str, tables: object) -> type[Design]:
    """Return the class of a part of an assembly from its unchecked tables."""
    if not isinstance(tables, Mapping):
        raise RejectedError([name], f"{name}: need a table under [part.{name}], got {as_written(tables)}")
    try:
        return design_class(tables)
    except RejectedError as error:
        raise RejectedError([name, *error.place], f"{name}.{error}") from None


def kind_of(tables: Mapping[str, object]) -> str | None:
    """Return the kind of pattern in the unchecked tables of a design; None if they give none."""
    pattern = tables.get("pattern")
    kind = pattern.get("kind") if isinstance(pattern, Mapping) else None
    return kind if isinstance(kind, str) else None
