"""Design -> Structure: each way of building is a file of its own, and this is the only place that chooses."""

from __future__ import annotations

from forficula.design import Design, FanDesign, PlatesDesign
from forficula.errors import InputError
from forficula.structure import fan_protocol, plates, veins
from forficula.structure.structure import Structure


def structure_of(design: Design) -> Structure:
    """Build a design, in the units that its numbers are in.

    Raises:
        InputError: it cannot be built.
    """
    if isinstance(design, FanDesign):
        return veins.vein_structure(design)
    if isinstance(design, PlatesDesign):
        return plates.plate_structure(design)
    raise _no_way(design)


def with_protocol(structure: Structure, design: Design) -> Structure:
    """A structure with the drives, goals, states and transitions of a design that differs in its protocol at most."""
    if isinstance(design, FanDesign):
        return fan_protocol.with_protocol(structure, design)
    if isinstance(design, PlatesDesign):
        return plates.with_protocol(structure, design)
    raise _no_way(design)


def drive_keys(design: Design) -> tuple[str, ...]:
    """Keys of the values that say how strong a design's drives are."""
    if isinstance(design, FanDesign):
        return fan_protocol.drive_keys(design)
    if isinstance(design, PlatesDesign):
        return plates.drive_keys(design)
    raise _no_way(design)


def static_keys(design: Design) -> tuple[str, ...]:
    """Keys, or starts of keys, of what matters to where a design rests, but for its tendons."""
    if isinstance(design, FanDesign):
        return fan_protocol.static_keys(design)
    if isinstance(design, PlatesDesign):
        return plates.static_keys(design)
    raise _no_way(design)


def _no_way(design: Design) -> InputError:
    return InputError(f"{design.name}: there is no way to build it")
