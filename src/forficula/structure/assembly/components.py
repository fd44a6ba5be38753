"""Components of the parts of an assembly, with the numbers, names and positions that they have in the assembly."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.errors import InputError
from forficula.structure.assembly.joined_part import JoinedPart
from forficula.structure.membranes import Membrane, Surface
from forficula.structure.parts import (
    GROUND,
    Bar,
    Closure,
    Coupling,
    Facet,
    LengthLimit,
    Plate,
    PointMass,
    Spring,
    Tendon,
)
from forficula.structure.structure import Structure
from forficula.structure.surroundings import Hold, Medium


def with_components(structure: Structure, masses: Sequence[PointMass], parts: Sequence[JoinedPart]) -> Structure:
    """Return a structure with the bars, plates, facets and elastic elements of all parts, one part after another.

    Args:
        structure: bodies, points and hinges of the assembly.
        masses: point masses on the bodies of hinges between parts.
        parts: the parts of the assembly.

    Raises:
        InputError: supports hold points of a part that another part carries.
    """
    return replace(
        structure,
        bars=tuple(_bar(part, bar) for part in parts for bar in part.structure.bars),
        plates=tuple(_plate(part, plate) for part in parts for plate in part.structure.plates),
        masses=(*masses, *(_mass(part, mass) for part in parts for mass in part.structure.masses)),
        facets=tuple(_facet(part, facet) for part in parts for facet in part.structure.facets),
        closures=tuple(_closure(part, closure) for part in parts for closure in part.structure.closures),
        holds=tuple(_hold(part, hold) for part in parts for hold in part.structure.holds),
        limits=tuple(_limit(part, limit) for part in parts for limit in part.structure.limits),
        membranes=tuple(_membrane(part, sheet) for part in parts for sheet in part.structure.membranes),
        couplings=tuple(_coupling(part, coupling) for part in parts for coupling in part.structure.couplings),
        springs=tuple(_spring(part, spring) for part in parts for spring in part.structure.springs),
        tendons=tuple(_tendon(part, tendon) for part in parts for tendon in part.structure.tendons),
        medium=_medium(parts),
    )


def _bar(part: JoinedPart, bar: Bar) -> Bar:
    one, other = part.point_numbers(bar.points)
    return replace(bar, body=part.body(bar.body), points=(one, other))


def _plate(part: JoinedPart, plate: Plate) -> Plate:
    return replace(
        plate,
        body=part.body(plate.body),
        points=part.point_numbers(plate.points),
        touching_distance=_touching_distance(part) if plate.touching_distance is None else plate.touching_distance,
        solids=tuple(part.point_numbers(solid) for solid in plate.solids),
        core=part.point_numbers(plate.core),
    )


def _touching_distance(part: JoinedPart) -> float | None:
    """Return the distance between the mid-planes of touching plates or facets of a part, m; None without contact."""
    contact = part.structure.contact
    return None if contact is None else contact.thickness


def _mass(part: JoinedPart, mass: PointMass) -> PointMass:
    return replace(mass, body=part.body(mass.body), place=part.place(mass.body, mass.place))


def _facet(part: JoinedPart, facet: Facet) -> Facet:
    return replace(
        facet,
        name=part.full_name(facet.name),
        points=part.point_numbers(facet.points),
        inside=part.point_numbers(facet.inside),
        touching_distance=_touching_distance(part),
    )


def _closure(part: JoinedPart, closure: Closure) -> Closure:
    one, other = (part.body(body) for body in closure.bodies)
    pairs = tuple((part.first_point + first, part.first_point + second) for first, second in closure.points)
    return replace(closure, name=part.full_name(closure.name), bodies=(one, other), points=pairs)


def _hold(part: JoinedPart, hold: Hold) -> Hold:
    if part.base != GROUND:
        raise InputError(
            f"part.{part.name}.support: need one facet or edge that is held along all axes in a part of rigid facets"
            " that a hinge or another part carries, because further supports and vertices are held to the ground"
        )
    axis = part.motion.rotation @ hold.axis
    return replace(hold, name=part.full_name(hold.name), point=part.first_point + hold.point, axis=axis)


def _limit(part: JoinedPart, limit: LengthLimit) -> LengthLimit:
    one, other = part.point_numbers(limit.points)
    return replace(limit, name=part.full_name(limit.name), points=(one, other))


def _membrane(part: JoinedPart, membrane: Membrane) -> Membrane:
    surface = membrane.surface
    return replace(
        membrane,
        name=part.full_name(membrane.name),
        bodies=part.numbers(membrane.bodies),
        places=part.places(membrane.bodies, membrane.places),
        built=membrane.built if _stays(part) else part.motion.of(membrane.built),
        surface=None if surface is None else _surface(part, surface),
    )


def _stays(part: JoinedPart) -> bool:
    return not part.motion.shift.any() and np.array_equal(part.motion.rotation, np.eye(3))


def _surface(part: JoinedPart, surface: Surface) -> Surface:
    return replace(
        surface,
        bodies=part.numbers(surface.bodies),
        places=part.places(surface.bodies, surface.places),
        names=tuple(part.full_name(name) for name in surface.names),
    )


def _coupling(part: JoinedPart, coupling: Coupling) -> Coupling:
    one, other = (part.hinges[hinge] for hinge in coupling.hinges)
    return replace(coupling, name=part.full_name(coupling.name), hinges=(one, other))


def _spring(part: JoinedPart, spring: Spring) -> Spring:
    one, other = part.point_numbers(spring.points)
    return replace(spring, name=part.full_name(spring.name), points=(one, other))


def _tendon(part: JoinedPart, tendon: Tendon) -> Tendon:
    one, other = part.point_numbers(tendon.points)
    crossing, ideal = tendon.crossing, tendon.ideal
    return replace(
        tendon,
        name=part.full_name(tendon.name),
        points=(one, other),
        key=f"{part.name}.{tendon.key}" if tendon.key else "",
        label=part.full_name(tendon.label or tendon.name),
        crossing=None if crossing is None else replace(crossing, hinge=part.hinges[crossing.hinge]),
        ideal=None if ideal is None else replace(ideal, hinge=part.hinges[ideal.hinge]),
    )


def _medium(parts: Sequence[JoinedPart]) -> Medium | None:
    """Return the medium around all parts; None without one."""
    media = [(part, part.structure.medium) for part in parts if part.structure.medium is not None]
    if not media:
        return None
    kept = [(part, medium) for part, medium in media if medium is not None]
    return replace(
        kept[0][1],
        carriers=np.concatenate([part.numbers(medium.carriers) for part, medium in kept]),
        places=np.concatenate([part.places(medium.carriers, medium.places) for part, medium in kept]),
        widths=np.concatenate([medium.widths for _, medium in kept]),
        masses=tuple(_mass(part, mass) for part, medium in kept for mass in medium.masses),
    )
