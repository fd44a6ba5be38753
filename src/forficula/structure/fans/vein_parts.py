"""Components of veins, chains of bars with hinges between them, in a fan or alone."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.arrays import Array
from forficula.design import FanDesign, JointDesign, TendonSection, tendon_law
from forficula.errors import InputError
from forficula.pattern import vein_roles
from forficula.structure.fans.crossing import bar_crossing, sine_between
from forficula.structure.fans.vein import Vein, attachments
from forficula.structure.mass import end_inertia, turned_inertia
from forficula.structure.motors_and_measures import Measure
from forficula.structure.parts import GROUND, Bar, Body, Crossing, Hinge, Point, PointMass, Tendon
from forficula.structure.structure import Structure
from forficula.structure.surroundings import Stops

# designs with veins
VeinDesign = FanDesign | JointDesign

# prefixes of names at the ring folds of a vein, from the hub outwards
_FOLDS = ("", "outer_")
# axis and bars of a hinge with both bars normal to it
_SQUARE = (np.array([0.0, 1.0, 0.0]), (np.array([1.0, 0.0, 0.0]), np.array([1.0, 0.0, 0.0])))


def bare_veins(
    design: VeinDesign,
    veins: Sequence[Vein],
    *,
    masses: Sequence[PointMass],
    labels: Sequence[str],
    aims: Sequence[Sequence[Hinge]] = (),
    overlapping: float = 0.0,
) -> Structure:
    """Build veins with bars, ring folds and tendons, without panels between them and without a protocol.

    Args:
        design: design with the properties.
        veins: positions of the veins.
        masses: point masses on the bars.
        labels: name of the hinge and the tendon of each vein in tables.
        aims: hinges of each vein's proximal bar; empty if no vein has any.
        overlapping: length of the first bars from the hub in which contact is ignored, m.
    """
    bodies: list[Body] = []
    points: list[Point] = []
    bars: list[Bar] = []
    hinges: list[Hinge] = []
    tendons: list[Tendon] = []
    for index, vein in enumerate(veins):
        choice, first = design.tendons[index], len(points)
        bodies += _bodies(index, vein)
        points += _points(index, vein, choice)
        bars += _bars(design, index, vein, (first, len(points) - 1), overlapping)
        hinges += [*(aims[index] if aims else ()), *_hinges(design, index, vein, labels[index])]
        if choice is not None:
            carried = turned_inertia(masses, hinges[-1].body, hinges[-1].axis)
            length = design.bar_lengths[index][1]
            across = _crossings(design, choice, vein, len(hinges) - 1, carried, length)
            tendon = _tendon(f"tendon{index}", choice, vein, first + vein.bars, across)
            key = f"tendon.{index}" if isinstance(design.tendon, tuple) else "tendon"
            tendons.append(replace(tendon, key=key, label=labels[index]))
    return Structure(
        name=design.name,
        stops=Stops(time_constant=design.stops.time_constant, damping_ratio=design.stops.damping_ratio),
        bodies=tuple(bodies),
        points=tuple(points),
        bars=tuple(bars),
        masses=tuple(masses),
        hinges=tuple(hinges),
        tendons=tuple(tendons),
        measures=(_distal_angle(hinges, len(veins[0].axes)),),
        span=_longest_vein(design),
        mass=_bar_mass(design),
        gravity=design.protocol.gravity,
        down=design.protocol.down,
    )


def _distal_angle(hinges: Sequence[Hinge], folds: int) -> Measure:
    """Return the measure of the distal hinge angles; the angle of a vein is the sum over its ring folds."""
    rings = tuple(number for number, hinge in enumerate(hinges) if hinge.role == "ring")
    return Measure(
        name="distal_angle",
        kind="angle",
        hinges=rings,
        signs=(1,) * len(rings),
        together=folds,
        label="distal angle",
    )


def vein_masses(design: VeinDesign, veins: Sequence[Vein]) -> tuple[PointMass, ...]:
    """Return the point masses of hinges and tendons, in the units of the design; none if all are 0.

    Half of a tendon's mass is at each end. This has the momentum of a straight line between two moving points; the
    kinetic energy is larger by a twelfth of the mass times the square of the difference of their velocities.
    """
    masses: list[PointMass] = []
    for index, vein in enumerate(veins):
        tendon, hinge = design.tendons[index], design.vein.added_mass / 2
        if hinge:
            for fold in range(len(vein.axes)):
                ends = ((fold, vein.end(fold)), (fold + 1, np.zeros(3)))
                masses += [
                    PointMass(body=vein.body(index, bar), place=place, mass=hinge, role="hinge") for bar, place in ends
                ]
        if tendon is not None and tendon.mass:
            masses += [
                PointMass(body=end.body, place=end.place, mass=tendon.mass / 2, role="tendon")
                for end in attachments(tendon, index, vein)
            ]
    return tuple(masses)


def _bodies(index: int, vein: Vein) -> list[Body]:
    """Return the bodies of a vein's bars, each with the previous one as its parent; all have the axes of the first."""
    return [
        Body(
            name=f"{role}{index}",
            role=role,
            parent=vein.body(index, bar - 1) if bar else GROUND,
            position=vein.end(bar - 1) if bar else vein.places[0],
            frame=np.eye(3) if bar else vein.frame,
        )
        for bar, role in enumerate(vein_roles(len(vein.axes)))
    ]


def _points(index: int, vein: Vein, tendon: TendonSection | None) -> list[Point]:
    """Return the ends of a vein's bars, from the hub outwards, with the ends of its tendon before the tip."""
    last = vein.bars - 1
    return [
        Point(name=f"hub{index}", role="hub", body=vein.body(index, 0), place=np.zeros(3)),
        *(
            Point(name=f"{ring}ring{index}", role="ring", body=vein.body(index, fold + 1), place=np.zeros(3))
            for fold, ring in enumerate(_FOLDS[: len(vein.axes)])
        ),
        *([] if tendon is None else attachments(tendon, index, vein)),
        Point(name=f"tip{index}", role="tip", body=vein.body(index, last), place=vein.end(last)),
    ]


def _bars(design: VeinDesign, index: int, vein: Vein, ends: tuple[int, int], overlapping: float) -> list[Bar]:
    """Return the bars of a vein between its points.

    Args:
        design: design with the properties of the bars.
        index: number of the vein.
        vein: position of the vein.
        ends: numbers of the points at the hub and at the tip.
        overlapping: length of the first bar from the hub in which contact is ignored, m.
    """
    hub, tip = ends
    return [
        Bar(
            body=vein.body(index, bar),
            end=vein.end(bar),
            diameter=design.vein.diameter,
            density=design.vein.density,
            points=(hub + bar, hub + bar + 1 if bar < vein.bars - 1 else tip),
            overlaps=overlapping if bar == 0 else 0.0,
        )
        for bar in range(vein.bars)
    ]


def _hinges(design: VeinDesign, index: int, vein: Vein, label: str) -> list[Hinge]:
    """Return the hinges of a vein at its ring folds, which share the limits and the initial angle equally."""
    choice, folds = design.hinge, len(vein.axes)
    return [
        Hinge(
            name=f"{which}fold{index}",
            role="ring",
            body=vein.body(index, fold + 1),
            axis=vein.axis(fold),
            lower=-choice.fold_limit / folds,
            upper=choice.overbend / folds,
            start=design.protocol.initial_overbend / folds,
            sense=vein.sense,
            damping=choice.damping,
            friction=choice.friction,
            armature=choice.armature,
            label=label if folds == 1 else f"{label}, {which.strip('_') or 'inner'}",
        )
        for fold, which in enumerate(_FOLDS[:folds])
    ]


def _tendon(
    name: str, choice: TendonSection, vein: Vein, end: int, across: tuple[Crossing | None, Crossing | None]
) -> Tendon:
    """Return the tendon of a vein from the point with the number `end` to the next one, with its crossings `across`."""
    crossing, ideal = across
    return Tendon(
        name=name,
        role="tendon",
        points=(end, end + 1),
        law=tendon_law(choice),
        longest=_longest(choice, vein),
        crossing=crossing,
        ideal=ideal,
        gauge_length=choice.rest_length,
        material=None if choice.law is None else choice.law.material,
    )


def _longest(tendon: TendonSection, vein: Vein) -> float:
    """Compute the largest possible length of a tendon: from its ends to the ring folds, plus between the ring folds."""
    ends = math.hypot(tendon.proximal_attachment, tendon.proximal_offset, tendon.proximal_aside) + math.hypot(
        tendon.distal_attachment, tendon.distal_offset, tendon.distal_aside
    )
    return ends + sum(float(np.linalg.norm(vein.end(bar))) for bar in range(1, vein.bars - 1))


def _crossings(
    design: VeinDesign, tendon: TendonSection, vein: Vein, hinge: int, carried: float, length: float
) -> tuple[Crossing | None, Crossing | None]:
    """Compute the crossing of a tendon at the ring fold, and the one with bars normal to it; None for several folds.

    `carried` is the inertia about the hinge of the masses on the distal bar, `length` the length of this bar.
    """
    if len(vein.axes) > 1:
        return None, None
    proximal, distal = (vein.places[bar + 1] - vein.places[bar] for bar in range(2))
    bars = proximal / np.linalg.norm(proximal), distal / np.linalg.norm(distal)
    crossing = _crossing(design, tendon, hinge, vein.axes[0], bars, carried, length)
    return crossing, _crossing(design, tendon, hinge, *_SQUARE, carried, length)


def _crossing(
    design: VeinDesign,
    tendon: TendonSection,
    hinge: int,
    axis: Array,
    bars: tuple[Array, Array],
    carried: float,
    length: float,
) -> Crossing:
    """Compute the crossing of a tendon at a distal hinge, between bars that point outwards in the flat sheet.

    `carried` is the inertia about the axis of the masses on the distal bar, `length` the length of this bar.
    """
    distal = bars[1]
    inertia = end_inertia(
        diameter=design.vein.diameter,
        density=design.vein.density,
        length=length,
        along=float(distal @ axis),
        across=sine_between(distal, axis),
    )
    return bar_crossing(
        hinge=hinge,
        axis=axis,
        bars=bars,
        attachments=(tendon.proximal_attachment, tendon.distal_attachment),
        offsets=(tendon.proximal_offset, tendon.distal_offset),
        asides=(tendon.proximal_aside, tendon.distal_aside),
        inertia=inertia + design.hinge.armature + carried,
    )


def _longest_vein(design: VeinDesign) -> float:
    """Return the length of the longest vein from the hub to the tip, in the units of the design."""
    return max(proximal + distal for proximal, distal in design.bar_lengths)


def _bar_mass(design: VeinDesign) -> float:
    """Compute the mass of the longest vein, kg."""
    span = _longest_vein(design)
    mass = design.vein.density * span * math.pi / 4 * design.vein.diameter**2
    if not 0 < mass < math.inf:
        raise InputError(
            f"vein.diameter and vein.density: need a vein with a mass > 0 and finite, got {mass:g} kg, from"
            f" {design.vein.diameter:g} m and {design.vein.density:g} kg/m^3"
        )
    return mass
