"""Design of a structure as its parts are made, so that this structure can be run."""

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

# smaller differences count as none: rad, and relative
_ANGLE, _ALIKE = math.radians(0.01), 1e-9
# digits of measured values
_DIGITS = 6


@dataclass(frozen=True, kw_only=True)
class MadeChange:
    """A value that differs between the parts and their design.

    Attributes:
        group: group of the value.
        key: dotted key of the design.
        designed: in words, "" if the design gives none.
        made: in words.
    """

    group: Group
    key: str
    designed: Annotated[str, Written.OR_NULL]
    made: str


def as_made(parts: PartSet, groups: Collection[Group] = GROUPS, values: MadeValues | None = None) -> Design:
    """Return the design of parts as made: with their pegs, stops, stiffness, masses and inertias about the hinges.

    - Attachments and offsets are those of the pegs. Straps at both sides of a bar count as one in their middle.
    - Stops are the angles at which the two halves begin to overlap. Differences below 0.01 deg are ignored.
    - The stiffness is the design's, scaled by the printed cross-section of straps. A filament is printed in whole
    layers of
      a strap that stands on its edge. The law is the design's own, whatever other properties a strap's material has.
    - Bars have the density with which a uniform bar has the inertia of the outer halves about their hinges. Half of
      `vein.added_mass` at the hinge adds the remaining mass. Half of the mass of straps is at each peg.
    - A coupling of neighbouring veins is removed, because no part provides it.

    Properties without a key are returned by `forficula.make.unkept.unkept`.

    Args:
        parts: parts with joints.
        groups: groups of values that are taken from the parts; the others stay those of the design.
        values: values of the parts, if they have been measured already.

    Returns:
        A design with a name of its own, whose source says which values were measured.

    Raises:
        InputError: parts without joints, a material without a density, or values that are no design, for example
            because the parts stop before the angle that counts as folded.

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
        changed |= {"vein.density": _rounded(values.bars.density), "vein.added_mass": _rounded(values.bars.hinge_mass)}
    design = parts.design
    if "coupling" in groups and uncoupled(parts):
        changed["coupling"] = None
    changed = {key: value for key, value in changed.items() if value is None or not _same(_value(design, key), value)}
    try:
        made = design.with_values(changed)
    except InputError as error:
        raise InputError(f"the design as made cannot be run: {error}") from None
    words = {"name": f"{design.name}-as-made", "source": _source(design, groups)}
    return made.model_copy(update=words)


def write_as_made(parts: PartSet, folder: str | os.PathLike[str]) -> Path:
    """Write the design as made into a folder, as `as-made.toml`, which `forficula run` accepts.

    Raises:
        InputError: see `as_made`, or the file cannot be written.
    """
    path = Path(folder) / AS_MADE
    save_design(as_made(parts), path)
    return path


def changes(parts: PartSet, made: Design) -> tuple[MadeChange, ...]:
    """Return the values that differ between the design as made and the design, key by key."""
    differences = []
    for group, key in _keys(parts, made):
        before, after = (_value(design, key) for design in (parts.design, made))
        if not _same(before, after):
            differences.append(
                MadeChange(group=group, key=key, designed=_written(made, key, before), made=_written(made, key, after))
            )
    if uncoupled(parts) and not structure_of(made).couplings:
        coupling = parts.structure.couplings[0]
        stiffness = "rigid" if coupling.rigid else show_quantity(coupling.stiffness, HINGE_STIFFNESS)
        differences.append(MadeChange(group="coupling", key="coupling.stiffness", designed=stiffness, made=""))
    return tuple(differences)


def uncoupled(parts: PartSet) -> bool:
    """Return whether the design couples neighbouring bars at the ground, which the made rods do not."""
    return bool(parts.roots and parts.structure.couplings)


def _keys(parts: PartSet, made: Design) -> list[tuple[Group, str]]:
    """Return the keys whose values may differ in parts, each with its group."""
    of_tendons: tuple[tuple[Group, str], ...] = (
        ("attachments", "proximal_attachment"),
        ("attachments", "distal_attachment"),
        ("offsets", "proximal_offset"),
        ("offsets", "distal_offset"),
        ("offsets", "proximal_aside"),
        ("offsets", "distal_aside"),
        ("stiffness", "stiffness"),
        # without a law, the area defines only the volume
        ("stiffness" if any(tendon.material for tendon in parts.structure.tendons) else "masses", "area"),
        ("masses", "density"),
    )
    tendons = structure_of(made).tendons
    sections = dict.fromkeys(tendons[strap.tendon].key for strap in parts.straps)
    return [
        ("stops", "hinge.overbend"),
        ("stops", "hinge.fold_limit"),
        *((group, f"{section}.{name}") for section in sections for group, name in of_tendons),
        ("masses", "vein.density"),
        ("masses", "vein.added_mass"),
    ]


def _stops(parts: PartSet, values: MadeValues) -> dict[str, object]:
    """Return the stops of all hinges, by the largest deviation from the design; summed over folds that share a stop."""
    changed: dict[str, object] = {}
    folds = round(float(key_value(parts.design, "hinge.fold_limit")) / -parts.joints[0].lower)
    for key, sign, stops in (
        ("hinge.fold_limit", 1, [joint.lower for joint in parts.joints]),
        ("hinge.overbend", -1, [joint.upper for joint in parts.joints]),
    ):
        measured = [pair[0 if sign > 0 else 1] for pair in values.stops]
        deviation = max((sign * (at - stop) for at, stop in zip(measured, stops, strict=True)), key=abs)
        if abs(deviation) > _ANGLE:
            changed[key] = math.radians(round(math.degrees(key_value(parts.design, key) - folds * deviation), 2))
    return changed


def _tendon(parts: PartSet, tendon: MadeTendon, groups: Collection[Group], section: str) -> dict[str, object]:
    """Return the values of a tendon as made, by key."""
    changed: dict[str, object] = {}
    for end, side in enumerate(("proximal", "distal")):
        if "attachments" in groups:
            changed[f"{section}.{side}_attachment"] = tendon.attachments[end]
        if "offsets" in groups:
            # straps at both sides count as one in their middle, which is on the bar
            changed |= {f"{section}.{side}_offset": tendon.offsets[end], f"{section}.{side}_aside": 0.0}
    design, built = parts.design, parts.structure.tendons[tendon.number]
    density, area = key_value(design, f"{section}.density"), key_value(design, f"{section}.area")
    length = float(key_value(design, f"{section}.rest_length"))
    mass = tendon.mass if "masses" in groups else density * (area or 0.0) * length
    by_area = tendon.by_area if "stiffness" in groups else 1.0
    if built.material is None:
        changed[f"{section}.stiffness"] = _rounded(by_area * key_value(design, f"{section}.stiffness"))
        # without a law, the area defines only the volume
        area = tendon.area if "stiffness" in groups or not area else area
    else:
        area = _rounded(by_area * area)
    if built.material is not None or mass:
        changed[f"{section}.area"] = area
    if mass:
        changed[f"{section}.density"] = _rounded(mass / (area * length))
    return changed


def _place(parts: PartSet, values: MadeValues, tendon: MadeTendon) -> str:
    """Return the key of a tendon's section: a common section if the design has one and all straps are equal."""
    alike = all(replace(other, number=tendon.number) == tendon for other in values.tendons)
    key = parts.structure.tendons[tendon.number].key
    return key if alike or key != "tendon" else _numbered(parts, tendon.number)


def _numbered(parts: PartSet, number: int) -> str:
    return f"tendon.{parts.structure.tendons[number].name.removeprefix('tendon')}"


def _value(design: Design, key: str) -> object:
    """Return the value of a design's key, in SI; None if it has none."""
    return cast(object, key_value(design, key))


def _same(one: object, other: object) -> bool:
    if isinstance(one, float | int) and isinstance(other, float | int):
        return math.isclose(one, other, rel_tol=_ALIKE, abs_tol=_ALIKE**2)
    return one == other


def _rounded(value: float) -> float:
    """Round a measured value to significant digits."""
    return float(f"{value:.{_DIGITS}g}")


def _written(design: Design, key: str, value: object) -> str:
    quantity = key_quantity(key, type(design))
    if value is None:
        return ""
    return show_quantity(value, quantity.unit) if quantity and isinstance(value, float | int) else as_written(value)


def _source(design: Design, groups: Collection[Group]) -> str:
    measured = [group for group in GROUPS if group in groups]
    return (
        f"{design.name} as its parts are made: {listed(measured)} measured on their solids;"
        f" {design.name}: {design.source}"
    )
