"""Bars on creases with membranes between them: the fan as a structure."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.design import FanDesign, TendonSection, tendon_law
from forficula.design.places import row_bars
from forficula.errors import InputError
from forficula.pattern import CreasePattern, earwig_pattern, ring_directions, vein_roles
from forficula.quantities import show_value
from forficula.structure.appearance import Appearance
from forficula.structure.couplings import vein_couplings
from forficula.structure.crossing import bar_crossing, sine_between
from forficula.structure.fan_fold import fan_fold
from forficula.structure.fan_masses import fan_masses, fan_panels
from forficula.structure.fan_protocol import with_protocol
from forficula.structure.mass import end_inertia, turned_inertia
from forficula.structure.medium import immersed
from forficula.structure.panel_surface import fan_contact, overlapping_length, panel_surface
from forficula.structure.parts import (
    GROUND,
    Array,
    Bar,
    Body,
    Crossing,
    Hinge,
    LengthLimit,
    Membrane,
    MembraneLaw,
    Point,
    Tendon,
)
from forficula.structure.structure import Structure
from forficula.structure.vein import Vein, attachments, panel_lines

_APPEARANCE = Appearance(
    whole="wing",
    bar="vein",
    crease="ring fold",
    overbend="overbend",
    bodies="two for every vein",
    titles={"distal_angle": "distal hinge angle", "turn": "turn about its own axis"},
)
_NOT_RIGID = (
    "with two ring folds, whose vertices are off Kawasaki, rigid panels do not fold, so there is no energy along that;"
    " every tendon lies across both folds, so there are no landscapes of single hinges"
)
# a vein alone has next to no inertia about its own axis
_STEADIER = "give the turning hinges the inertia of what drives them, hinge.armature"
# what tells the ring folds of a vein from each other, from the hub outwards, in names
_FOLDS = ("", "outer_")
# the hinges of a vein in this order: sweep and lift aim it, turn is about its own axis
_AIMS = (("sweep", (0.0, 0.0, 1.0)), ("lift", (0.0, 1.0, 0.0)), ("turn", (1.0, 0.0, 0.0)))
# axis and bars of a hinge with both bars square to it
_SQUARE = (np.array([0.0, 1.0, 0.0]), (np.array([1.0, 0.0, 0.0]), np.array([1.0, 0.0, 0.0])))


def vein_structure(design: FanDesign) -> Structure:
    """Build bars, hinges, tendons and membranes on the creases of a fan, in the units of its design."""
    fan, pattern = design.fan, earwig_pattern(design.fan)
    built = structure_of_veins(design, veins_on(pattern, ring_directions(fan)))
    chosen, rigid = design.pattern, fan.ring_folds == 1
    sizes = {
        "proximal length": chosen.proximal_length,
        "distal length": chosen.distal_length,
        "hub radius": chosen.hub_radius,
        **({} if rigid else {"pitch": fan.pitch, "lowest gusset": fan.gusset_height}),
    }
    text = (
        f"A fan of {fan.vein_count} veins and {fan.vein_count - 1} membrane panels, each vein"
        f" {show_value(chosen.proximal_length, 'm')} long up to the ring fold and"
        f" {show_value(chosen.distal_length, 'm')} beyond it"
    )
    if not rigid:
        text += (
            f", which is two folds with a gusset between them; layers lie {show_value(fan.pitch, 'm')} apart when"
            " folded, and every layer's gusset stands higher by twice as much than that of the layer inside it"
        )
    circles = {"hub": chosen.hub_radius}
    appearance = replace(built.appearance, text=text, sizes=sizes, pattern=pattern, circles=circles)
    return replace(
        built,
        appearance=appearance if rigid else replace(appearance, bodies="three for every vein"),
        rigid_fold=fan_fold(design, built) if rigid else None,
        remarks=() if rigid else (_NOT_RIGID,),
    )


def veins_on(pattern: CreasePattern, directions: Array) -> tuple[Vein, ...]:
    """The veins on the creases of a pattern with the roles of `vein_roles`.

    A turn of a vein by its sense folds it as a crease, with the panel that hangs on it rising where the sense is -1.

    Args:
        pattern: flat.
        directions: unit vectors along which each vein folds at its ring folds, (vein, 3).
    """
    place = pattern.vertices_coords
    bars = [
        place[[pattern.edges_vertices[edge] for edge, its in enumerate(pattern.edges_role) if its == role]]
        for role in vein_roles(2 if "gusset" in pattern.edges_role else 1)
    ]
    lines = [bars[0][:, 0], *(ends[:, 1] for ends in bars)]
    return tuple(
        Vein(
            places=tuple(line[index] for line in lines),
            axes=(directions[index],) * (len(lines) - 2),
            # odd veins are valleys
            sense=(-1) ** (index + 1),
        )
        for index in range(len(lines[0]))
    )


def structure_of_veins(design: FanDesign, veins: Sequence[Vein]) -> Structure:
    """Build on veins of any layout, neighbours joined by panels and guards, with the design's properties."""
    bodies: list[Body] = []
    points: list[Point] = []
    bars: list[Bar] = []
    hinges: list[Hinge] = []
    tendons: list[Tendon] = []
    masses, overlapping = fan_masses(design, veins), overlapping_length(design)
    for index, vein in enumerate(veins):
        choice, first = design.tendon_on(index), len(points)
        bodies += _bodies(index, vein)
        points += _points(index, vein, choice)
        bars += _bars(design, index, vein, (first, len(points) - 1), overlapping)
        hinges += _hinges(design, index, vein)
        if choice is None:
            continue
        carried = turned_inertia(masses, hinges[-1].body, hinges[-1].axis)
        crossing, ideal = _crossings(design, choice, vein, len(hinges) - 1, carried)
        tendons.append(
            Tendon(
                name=f"tendon{index}",
                role="tendon",
                points=(first + vein.bars, first + vein.bars + 1),
                law=tendon_law(choice),
                longest=_longest(choice, vein),
                crossing=crossing,
                ideal=ideal,
                gauge_length=choice.rest_length,
                material=None if choice.law is None else choice.law.material,
                key=f"tendon.{index}" if isinstance(design.tendon, tuple) else "tendon",
                label=f"vein {index}",
            )
        )
    built = Structure(
        name=design.name,
        bodies=tuple(bodies),
        points=tuple(points),
        bars=tuple(bars),
        masses=masses,
        hinges=tuple(hinges),
        couplings=vein_couplings(design, hinges),
        tendons=tuple(tendons),
        limits=_guards(design, veins, [number for number, point in enumerate(points) if point.role == "tip"]),
        membranes=_panels(design, veins),
        span=design.pattern.proximal_length + design.pattern.distal_length,
        mass=_bar_mass(design),
        contact=fan_contact(design),
        gravity=design.protocol.gravity,
        appearance=_APPEARANCE if design.hinge.armature else replace(_APPEARANCE, steadier=_STEADIER),
    )
    return with_protocol(immersed(built, design.medium, fan_panels(design, veins)), design)


def _bodies(index: int, vein: Vein) -> list[Body]:
    """The bars of a vein, each on the one before; all have the axes of the first."""
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
    """The ends of a vein's bars, from the hub outwards, and of its tendon, before the tip."""
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


def _bars(design: FanDesign, index: int, vein: Vein, ends: tuple[int, int], overlapping: float) -> list[Bar]:
    """The bars of a vein between points, given the numbers of the first and the last; nothing touches them up to there.

    Args:
        design: of the fan.
        index: of the vein.
        vein: where it lies.
        ends: numbers of the points at the hub and at the tip.
        overlapping: how far from the hub on the first one touches nothing, m.
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


def _hinges(design: FanDesign, index: int, vein: Vein) -> list[Hinge]:
    """The hinges of a vein: of its proximal bar, unless that is held, and at its ring folds, which share their way."""
    choice, folds = design.hinge, len(vein.axes)
    aims = [
        Hinge(
            name=f"{role}{index}",
            role=role,
            body=vein.body(index, 0),
            axis=np.array(axis),
            sense=vein.sense if role == "turn" else 1,
            lower=-choice.turn_back if role == "turn" else -math.inf,
            upper=choice.turn_limit if role == "turn" else math.inf,
            damping=choice.damping,
            armature=choice.armature,
            label=f"vein {index}",
        )
        for role, axis in _AIMS
        if not vein.fixed_base
    ]
    rings = [
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
            armature=choice.armature,
            label=f"vein {index}" if folds == 1 else f"vein {index}, {which.strip('_') or 'inner'}",
        )
        for fold, which in enumerate(_FOLDS[:folds])
    ]
    return [*aims, *rings]


def _longest(tendon: TendonSection, vein: Vein) -> float:
    """Up to which a tendon is ever stretched: from its ends to the ring folds, and from one of these to the next."""
    ways = math.hypot(tendon.proximal_attachment, tendon.proximal_offset, tendon.proximal_aside) + math.hypot(
        tendon.distal_attachment, tendon.distal_offset, tendon.distal_aside
    )
    return ways + sum(float(np.linalg.norm(vein.end(bar))) for bar in range(1, vein.bars - 1))


def _crossings(
    design: FanDesign, tendon: TendonSection, vein: Vein, hinge: int, carried: float
) -> tuple[Crossing | None, Crossing | None]:
    """How a tendon lies across the ring fold of a vein, and the same with bars square to it; None across several.

    What the distal bar carries has the inertia `carried` about the hinge.
    """
    if len(vein.axes) > 1:
        return None, None
    proximal, distal = (vein.places[bar + 1] - vein.places[bar] for bar in range(2))
    bars = proximal / np.linalg.norm(proximal), distal / np.linalg.norm(distal)
    own = _crossing(design, tendon, hinge, vein.axes[0], bars, carried)
    return own, _crossing(design, tendon, hinge, *_SQUARE, carried)


def _crossing(
    design: FanDesign, tendon: TendonSection, hinge: int, axis: Array, bars: tuple[Array, Array], carried: float
) -> Crossing:
    """How a tendon lies across a distal hinge about an axis, between bars that point outwards in the flat sheet.

    What the distal bar carries has the inertia `carried` about the axis.
    """
    distal = bars[1]
    inertia = end_inertia(
        diameter=design.vein.diameter,
        density=design.vein.density,
        length=design.pattern.distal_length,
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


def _panels(design: FanDesign, veins: Sequence[Vein]) -> tuple[Membrane, ...]:
    """Lay the membrane: panel k from the edge of its margin on vein k to the axis of vein k + 1.

    The margin is glued to vein k and turns with it; about vein k + 1 the panel may turn. A row of nodes lies at every
    share of the proximal length, at the ring folds, at every share of the distal length and at the tip; that of a ring
    fold is on the bar before it.
    """
    choice, panels = design.membrane, []
    law = MembraneLaw(
        youngs_modulus=choice.youngs_modulus,
        poisson_ratio=choice.poisson_ratio,
        thickness=choice.thickness,
        damping=choice.damping,
    )
    carriers = [0, *row_bars(veins[0].bars - 1, design)]
    for panel in range(len(veins) - 1):
        pair = veins[panel : panel + 2]
        built: list[Array] = []
        bodies: list[int] = []
        places: list[Array] = []
        roots: list[Array] = []
        for bar, here, edge, there in zip(carriers, *panel_lines(design, *pair), strict=True):
            for vein, number, node, root in zip(pair, (panel, panel + 1), (edge, there), (here, there), strict=True):
                built.append(node)
                bodies.append(vein.body(number, bar))
                places.append(vein.on_bar(bar, node))
                roots.append(vein.on_bar(bar, root))
        corners = [
            each
            for left in range(0, len(built) - 2, 2)
            for each in ([left, left + 2, left + 3], [left, left + 3, left + 1])
        ]
        panels.append(
            Membrane(
                name=f"panel{panel}",
                bodies=np.array(bodies, dtype=np.int64),
                places=np.array(places),
                built=np.array(built),
                triangles=np.array(corners, dtype=np.int64),
                law=law,
                margin=choice.margin,
                roots=np.array(roots),
                surface=panel_surface(design, pair, panel),
            )
        )
    return tuple(panels)


def _guards(design: FanDesign, veins: Sequence[Vein], tips: Sequence[int]) -> tuple[LengthLimit, ...]:
    """Guard tendons between neighbouring tips, of which the numbers are given."""
    limits = []
    for index in range(len(veins) - 1):
        apart = float(np.linalg.norm(veins[index + 1].places[-1] - veins[index].places[-1]))
        ends, most = (tips[index], tips[index + 1]), design.guard.stretch * apart
        limits.append(LengthLimit(name=f"guard{index}", points=ends, built_length=apart, most=most))
    return tuple(limits)


def _bar_mass(design: FanDesign) -> float:
    """Mass of a vein of the whole length, kg."""
    span = design.pattern.proximal_length + design.pattern.distal_length
    mass = design.vein.density * span * math.pi / 4 * design.vein.diameter**2
    if not 0 < mass < math.inf:
        raise InputError(
            f"vein.diameter and vein.density: need a vein with a mass > 0 and finite, got {mass:g} kg, from"
            f" {design.vein.diameter:g} m and {design.vein.density:g} kg/m^3"
        )
    return mass
