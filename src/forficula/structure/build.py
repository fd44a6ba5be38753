"""From a design to a structure: the only place that chooses among the modules that build structures."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

from forficula.design import AnyDesign, AssemblyDesign, Design, FanDesign, JointDesign, SheetDesign, as_design
from forficula.errors import InputError
from forficula.structure import protocol
from forficula.structure.assembly.join import assembly_structure
from forficula.structure.fans import joint, veins
from forficula.structure.sheets import nodes, plates
from forficula.structure.structure import Structure
from forficula.structure.table import table_of


def _sheet_structure(design: SheetDesign) -> Structure:
    """Build plates if facets are rigid, nodes if they bend."""
    return plates.plate_structure(design) if design.facet.kind == "rigid" else nodes.node_structure(design)


_BUILDERS: Mapping[type[Design], Callable[[Any], Structure]] = {
    FanDesign: veins.vein_structure,
    JointDesign: joint.joint_structure,
    SheetDesign: _sheet_structure,
    AssemblyDesign: lambda design: assembly_structure(design, structure_of),
}


def structure_of(design: AnyDesign) -> Structure:
    """Build the structure of a design, or of its name or path, in the units of the design's numbers.

    Raises:
        InputError: no such design, or it cannot be built.
    """
    return _built(as_design(design))


@lru_cache(maxsize=16)  # designs and structures are frozen; a run, its checks and its page need the same structure
def _built(design: Design) -> Structure:
    for kind, build in _BUILDERS.items():
        if isinstance(design, kind):
            structure = build(design)
            return structure if design.table is None else replace(structure, table=table_of(design))
    raise InputError(f"{design.name}: designs of this class cannot be built")


def with_protocol(structure: Structure, design: Design) -> Structure:
    """Return a structure with the drives, goals, states and transitions of a design.

    Args:
        structure: structure of the design, or of a design that differs in the protocol only.
        design: design with the protocol.

    Raises:
        InputError: drives that the structure cannot combine, or a force on a vertex that a support holds.
    """
    # the drives of an assembly are those of its parts, whose structures it does not keep
    return structure_of(design) if isinstance(design, AssemblyDesign) else protocol.with_protocol(structure, design)


def drive_keys(design: Design) -> tuple[str, ...]:
    """Return the keys of the strengths of a design's drives."""
    return tuple(drive.key for drive in design.named_protocol.drives)


def static_keys(design: Design) -> tuple[str, ...]:
    """Return the keys, or beginnings of keys, on which the rest states of a design depend, apart from its tendons."""
    # without gravity, the rest states do not depend on masses
    weighing = design.weight_sections if design.protocol.gravity else ()
    return (*design.rest_keys, *weighing, "table")
