"""Design -> Structure: each way of building is a file of its own, and this is the only place that chooses."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from forficula.design import AnyDesign, Design, FanDesign, JointDesign, SheetDesign, as_design
from forficula.errors import InputError
from forficula.structure import fan_protocol, joint, nodes, plates, sheet_protocol, veins
from forficula.structure.structure import Structure


@dataclass(frozen=True, kw_only=True)
class _Way:
    """A way of building; what its functions say is told of the public ones here, that call them."""

    build: Callable[[Any], Structure]
    with_protocol: Callable[[Structure, Any], Structure]
    drive_keys: Callable[[Any], tuple[str, ...]]
    static_keys: Callable[[Any], tuple[str, ...]]


def _sheet_structure(design: SheetDesign) -> Structure:
    """Plates where facets are rigid, nodes where they bend."""
    return plates.plate_structure(design) if design.facet.kind == "rigid" else nodes.node_structure(design)


_WAYS: Mapping[type[Design], _Way] = {
    FanDesign: _Way(
        build=veins.vein_structure,
        with_protocol=fan_protocol.with_protocol,
        drive_keys=fan_protocol.drive_keys,
        static_keys=fan_protocol.static_keys,
    ),
    JointDesign: _Way(
        build=joint.joint_structure,
        with_protocol=joint.with_protocol,
        drive_keys=joint.drive_keys,
        static_keys=joint.static_keys,
    ),
    SheetDesign: _Way(
        build=_sheet_structure,
        with_protocol=sheet_protocol.with_protocol,
        drive_keys=sheet_protocol.drive_keys,
        static_keys=sheet_protocol.static_keys,
    ),
}


def structure_of(design: AnyDesign) -> Structure:
    """Build a design, or that of a name or path, in the units that its numbers are in.

    Raises:
        InputError: no such design, or it cannot be built.
    """
    return _built(as_design(design))


@lru_cache(maxsize=16)  # a design and what it is built of are frozen; a run, its checks and its page all ask for it
def _built(design: Design) -> Structure:
    return _way(design).build(design)


def with_protocol(structure: Structure, design: Design) -> Structure:
    """A structure with the drives, goals, states and transitions of a design that differs in its protocol at most."""
    return _way(design).with_protocol(structure, design)


def drive_keys(design: Design) -> tuple[str, ...]:
    """Keys of the values that say how strong a design's drives are."""
    return _way(design).drive_keys(design)


def static_keys(design: Design) -> tuple[str, ...]:
    """Keys, or starts of keys, of what matters to where a design rests, but for its tendons."""
    return _way(design).static_keys(design)


def _way(design: Design) -> _Way:
    for kind, way in _WAYS.items():
        if isinstance(design, kind):
            return way
    raise InputError(f"{design.name}: there is no way to build it")
