"""Design -> Structure: each way of building is a file of its own, and this is the only place that chooses."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

from forficula.design import AnyDesign, Design, FanDesign, JointDesign, SheetDesign, as_design
from forficula.errors import InputError
from forficula.structure.fans import joint, veins
from forficula.structure.sheets import nodes, plates
from forficula.structure.structure import Structure


def _sheet_structure(design: SheetDesign) -> Structure:
    """Plates where facets are rigid, nodes where they bend."""
    return plates.plate_structure(design) if design.facet.kind == "rigid" else nodes.node_structure(design)


_WAYS: Mapping[type[Design], Callable[[Any], Structure]] = {
    FanDesign: veins.vein_structure,
    JointDesign: joint.joint_structure,
    SheetDesign: _sheet_structure,
}


def structure_of(design: AnyDesign) -> Structure:
    """Build a design, or that of a name or path, in the units that its numbers are in.

    Raises:
        InputError: no such design, or it cannot be built.
    """
    return _built(as_design(design))


@lru_cache(maxsize=16)  # a design and what it is built of are frozen; a run, its checks and its page all ask for it
def _built(design: Design) -> Structure:
    for kind, build in _WAYS.items():
        if isinstance(design, kind):
            return build(design)
    raise InputError(f"{design.name}: there is no way to build it")


def drive_keys(design: Design) -> tuple[str, ...]:
    """Keys of the values that say how strong a design's drives are."""
    return tuple(drive.key for drive in design.named_protocol.drives)


def static_keys(design: Design) -> tuple[str, ...]:
    """Keys, or starts of keys, of what matters to where a design rests, but for its tendons."""
    # without gravity it rests where it rests, however heavy it is
    return (*design.rest_keys, design.weight_section) if design.protocol.gravity else design.rest_keys
