"""Parts -> design: the design that a structure of them has, so that one can run the thing as it is made."""

from __future__ import annotations

import math
import os
from collections.abc import Collection
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Literal, cast, get_args

from forficula.design import Design, key_quantity, key_value, save_design
from forficula.design.section import HINGE_STIFFNESS
from forficula.errors import InputError
from forficula.make.made_values import MadeTendon, MadeValues, made_values
from forficula.make.part import PartSet
from forficula.names import listed
from forficula.quantities import as_written, show_quantity
from forficula.serial import Written
from forficula.structure import structure_of

Group = Literal["attachments", "offsets", "stops", "stiffness", "masses", "coupling"]
GROUPS: tuple[Group, ...] = get_args(Group)
AS_MADE = "as-made.toml"

# what differs by less is as designed: rad, and by itself
_ANGLE, _ALIKE = math.radians(0.01), 1e-9
# digits of what is measured
_DIGITS = 6


@dataclass(frozen=True, kw_only=True)
class MadeChange:
    """A value that parts have otherwise than their design says.

    Attributes:
        group: that it is of.
        key: of the design, dotted.
        designed: as a sentence has it, "" where the design gives none.
        made: alike.
    """

    group: Group
    key: str
    designed: Annotated[str, Written.OR_NULL]
    made: str


def as_made(parts: PartSet, groups: Collection[Group] = GROUPS, values: MadeValues | None = None) -> Design:
    """The design that parts have: their pegs, stops, stiffness, masses and inertias about the hinges.

    - attachments and offsets are those of the pegs; straps at both sides of a bar count as one in their middle
    - stops are where the two halves begin to overlap; within 0.01 deg of the design's they are the design's
    - the stiffness is the design's by the area that straps are printed with, in whole layers for a filament, which is
      printed standing on edge; the law is the design's own, whatever else a strap's material does
    - bars have the density with which a uniform one has the inertia of the outer halves about their hinges, and half of
      `vein.added_mass` at the hinge what is missing of their mass; straps weigh by halves at the pegs

    - a coupling of neighbouring veins is left out, for no part does it

    What there is no key for is told by `forficula.make.unkept.unkept`.

    Args:
        parts: with joints.
        groups: of values that are taken from the parts; the others stay those of the design.
        values: of the parts, where they are known already.

    Returns:
        A design of its own name, whose source says what of it is measured.

    Raises:
        InputError: parts without joints, a material without a density, or what the parts have is no design: as where
            they stop before what counts as folded.

    >>> parts = ff.make.parts("binder2025-joint")
    >>> made = as_made(parts)
    >>> made.hinge.overbend == parts.design.hinge.overbend
    True
    """
    values = made_values(parts) if values is None else values
    changed: dict[str, object] = {}
    if "stops" in groups:
        changed |= _stops(parts, values)
    for tendon in values.tendons:
        changed |= _tendon(parts, tendon, groups, _place(parts, values, tendon))
    if "masses" in groups:
        changed |= {"vein.density": _told(values.bars.density), "vein.added_mass": _told(values.bars.hinge_mass)}
    design = parts.design
    if "coupling" in groups and uncoupled(parts):
        changed["coupling"] = None
    changed = {key: value for key, value in changed.items() if value is None or not _same(_value(design, key), value)}
    try:
        made = design.with_values(changed)
    except InputError as error:
        raise InputError(f"as made, it is no design that can be run: {error}") from None
    words = {"name": f"{design.name}-as-made", "source": _source(design, groups)}
    return made.model_copy(update=words)


def write_as_made(parts: PartSet, folder: str | os.PathLike[str]) -> Path:
    """Write the design as made into a folder, `as-made.toml`; `forficula run` takes it.

    Raises:
        InputError: as of `as_made`, or it cannot be written.
    """
    path = Path(folder) / AS_MADE
    save_design(as_made(parts), path)
    return path


def changes(parts: PartSet, made: Design) -> tuple[MadeChange, ...]:
    """What a design as made has otherwise than that of the parts, key by key."""
    found = []
    for group, key in _keys(parts, made):
        before, after = (_value(design, key) for design in (parts.design, made))
        if not _same(before, after):
            found.append(
                MadeChange(group=group, key=key, designed=_written(made, key, before), made=_written(made, key, after))
            )
    if uncoupled(parts) and not structure_of(made).couplings:
        told = parts.structure.couplings[0]
        stiffness = "rigid" if told.rigid else show_quantity(told.stiffness, HINGE_STIFFNESS)
        found.append(MadeChange(group="coupling", key="coupling.stiffness", designed=stiffness, made=""))
    return tuple(found)


def uncoupled(parts: PartSet) -> bool:
    """Whether a design ties neighbouring bars at the ground to each other, which rods that bend there do not."""
    return bool(parts.roots and parts.structure.couplings)


def _keys(parts: PartSet, made: Design) -> list[tuple[Group, str]]:
    """The keys that parts may have other values of, each with its group."""
    of_tendons: tuple[tuple[Group, str], ...] = (
        ("attachments", "proximal_attachment"),
        ("attachments", "distal_attachment"),
        ("offsets", "proximal_offset"),
        ("offsets", "distal_offset"),
        ("offsets", "proximal_aside"),
        ("offsets", "distal_aside"),
        ("stiffness", "stiffness"),
        # without a law its area is nothing but its volume
        ("stiffness" if any(each.material for each in parts.structure.tendons) else "masses", "area"),
        ("masses", "density"),
    )
    own = structure_of(made).tendons
    places = dict.fromkeys(own[place.tendon].key for place in parts.straps)
    return [
        ("stops", "hinge.overbend"),
        ("stops", "hinge.fold_limit"),
        *((group, f"{place}.{name}") for place in places for group, name in of_tendons),
        ("masses", "vein.density"),
        ("masses", "vein.added_mass"),
    ]


def _stops(parts: PartSet, values: MadeValues) -> dict[str, object]:
    """The stops of all hinges: where they are furthest from the design's; of several folds that share them, summed."""
    found: dict[str, object] = {}
    folds = round(float(key_value(parts.design, "hinge.fold_limit")) / -parts.joints[0].lower)
    for key, less, stops in (
        ("hinge.fold_limit", 1, [joint.lower for joint in parts.joints]),
        ("hinge.overbend", -1, [joint.upper for joint in parts.joints]),
    ):
        measured = [each[0 if less > 0 else 1] for each in values.stops]
        short = max((less * (at - stop) for at, stop in zip(measured, stops, strict=True)), key=abs)
        if abs(short) > _ANGLE:
            found[key] = math.radians(round(math.degrees(key_value(parts.design, key) - folds * short), 2))
    return found


def _tendon(parts: PartSet, tendon: MadeTendon, groups: Collection[Group], place: str) -> dict[str, object]:
    """What a tendon has as made, by key."""
    found: dict[str, object] = {}
    for end, side in enumerate(("proximal", "distal")):
        if "attachments" in groups:
            found[f"{place}.{side}_attachment"] = tendon.attachments[end]
        if "offsets" in groups:
            # straps at both sides count as one in their middle, which is on the bar
            found |= {f"{place}.{side}_offset": tendon.offsets[end], f"{place}.{side}_aside": 0.0}
    design, own = parts.design, parts.structure.tendons[tendon.number]
    density, area = key_value(design, f"{place}.density"), key_value(design, f"{place}.area")
    length = float(key_value(design, f"{place}.rest_length"))
    mass = tendon.mass if "masses" in groups else density * (area or 0.0) * length
    by_area = tendon.by_area if "stiffness" in groups else 1.0
    if own.material is None:
        found[f"{place}.stiffness"] = _told(by_area * key_value(design, f"{place}.stiffness"))
        # without a law it has no other meaning than its volume
        area = tendon.area if "stiffness" in groups or not area else area
    else:
        area = _told(by_area * area)
    if own.material is not None or mass:
        found[f"{place}.area"] = area
    if mass:
        found[f"{place}.density"] = _told(mass / (area * length))
    return found


def _place(parts: PartSet, values: MadeValues, tendon: MadeTendon) -> str:
    """The key of a tendon's section: of all of them where the design has one for all and straps are alike."""
    alike = all(replace(each, number=tendon.number) == tendon for each in values.tendons)
    key = parts.structure.tendons[tendon.number].key
    return key if alike or key != "tendon" else _numbered(parts, tendon.number)


def _numbered(parts: PartSet, number: int) -> str:
    return f"tendon.{parts.structure.tendons[number].name.removeprefix('tendon')}"


def _value(design: Design, key: str) -> object:
    """What a design has at a key, in SI; None where it has none."""
    return cast(object, key_value(design, key))


def _same(one: object, other: object) -> bool:
    if isinstance(one, float | int) and isinstance(other, float | int):
        return math.isclose(one, other, rel_tol=_ALIKE, abs_tol=_ALIKE**2)
    return one == other


def _told(value: float) -> float:
    """A measured value with as many digits as are worth telling."""
    return float(f"{value:.{_DIGITS}g}")


def _written(design: Design, key: str, value: object) -> str:
    quantity = key_quantity(key, type(design))
    if value is None:
        return ""
    return show_quantity(value, quantity.unit) if quantity and isinstance(value, float | int) else as_written(value)


def _source(design: Design, groups: Collection[Group]) -> str:
    own = [group for group in GROUPS if group in groups]
    return (
        f"{design.name} as its parts are made: {listed(own)} measured on their solids; {design.name}: {design.source}"
    )
