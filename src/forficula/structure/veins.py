"""Bars on creases with membranes between them: the fan as a structure."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.design import FanDesign, TendonSection, tendon_law
from forficula.design.places import margin_edge, mesh_rows
from forficula.errors import InputError
from forficula.pattern import CreasePattern, earwig_pattern, ring_vertices
from forficula.quantities import show_value
from forficula.structure.appearance import Appearance
from forficula.structure.couplings import vein_couplings
from forficula.structure.crossing import bar_crossing, sine_between
from forficula.structure.fan_fold import fan_fold
from forficula.structure.fan_masses import fan_masses
from forficula.structure.fan_protocol import with_protocol
from forficula.structure.mass import end_inertia, turned_inertia
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
from forficula.structure.vein import Vein, attachments

_APPEARANCE = Appearance(
    whole="wing",
    bar="vein",
    crease="ring fold",
    overbend="overbend",
    bodies="two for every vein",
    titles={"distal_angle": "distal hinge angle", "turn": "turn about its own axis"},
)
# a vein alone has next to no inertia about its own axis
_STEADIER = "give the turning hinges the inertia of what drives them, hinge.armature"
# the hinges of a vein in this order: sweep and lift aim it, turn is about its own axis
_AIMS = (("sweep", (0.0, 0.0, 1.0)), ("lift", (0.0, 1.0, 0.0)), ("turn", (1.0, 0.0, 0.0)))
# axis and bars of a hinge with both bars square to it
_SQUARE = (np.array([0.0, 1.0, 0.0]), (np.array([1.0, 0.0, 0.0]), np.array([1.0, 0.0, 0.0])))


def vein_structure(design: FanDesign) -> Structure:
    """Build bars, hinges, tendons and membranes on the creases of a fan, in the units of its design."""
    pattern = earwig_pattern(design.fan)
    # the last vein takes the ring crease of the pattern continued
    built = structure_of_veins(design, veins_on(pattern, ring_vertices(design.fan, continued=True)[-1]))
    chosen = design.pattern
    sizes = {
        "proximal length": chosen.proximal_length,
        "distal length": chosen.distal_length,
        "hub radius": chosen.hub_radius,
    }
    text = (
        f"A fan of {design.fan.vein_count} veins and {design.fan.vein_count - 1} membrane panels, each vein"
        f" {show_value(chosen.proximal_length, 'm')} long up to the ring fold and"
        f" {show_value(chosen.distal_length, 'm')} beyond it"
    )
    circles = {"hub": chosen.hub_radius}
    appearance = replace(built.appearance, text=text, sizes=sizes, pattern=pattern, circles=circles)
    return replace(built, appearance=appearance, rigid_fold=fan_fold(design, built))


def veins_on(pattern: CreasePattern, beyond: Array) -> tuple[Vein, ...]:
    """The veins on the creases of a pattern with the roles "proximal" and "distal".

    Every distal hinge lies along the ring crease to the next vein. A turn of a vein by its sense folds it as a crease,
    with the panel that hangs on it rising where the sense is -1.

    Args:
        pattern: flat.
        beyond: where the ring fold would meet the vein after the last one, (3,).
    """
    place = pattern.vertices_coords
    ends = {
        role: [pattern.edges_vertices[edge] for edge, its in enumerate(pattern.edges_role) if its == role]
        for role in ("proximal", "distal")
    }
    ring = np.concatenate([place[[vertex for _, vertex in ends["proximal"]]], beyond[None]])
    creases = np.diff(ring, axis=0)
    return tuple(
        Vein(
            hub_point=place[hub],
            ring_vertex=place[vertex],
            tip=place[tip],
            ring_direction=crease / np.linalg.norm(crease),
            # odd veins are valleys
            sense=(-1) ** (index + 1),
        )
        for index, ((hub, vertex), (_, tip), crease) in enumerate(
            zip(ends["proximal"], ends["distal"], creases, strict=True)
        )
    )


def structure_of_veins(design: FanDesign, veins: Sequence[Vein]) -> Structure:
    """Build on veins of any layout, neighbours joined by panels and guards, with the design's properties."""
    bodies: list[Body] = []
    points: list[Point] = []
    bars: list[Bar] = []
    hinges: list[Hinge] = []
    tendons: list[Tendon] = []
    masses = fan_masses(design, veins)
    for index, vein in enumerate(veins):
        ring, tip = vein.on_proximal_bar(vein.ring_vertex), vein.on_distal_bar(vein.tip)
        proximal, distal, first = 2 * index, 2 * index + 1, len(points)
        bodies.append(
            Body(name=f"proximal{index}", role="proximal", parent=GROUND, position=vein.hub_point, frame=vein.frame)
        )
        bodies.append(Body(name=f"distal{index}", role="distal", parent=proximal, position=ring, frame=np.eye(3)))
        choice = design.tendon_on(index)
        points += [
            Point(name=f"hub{index}", role="hub", body=proximal, place=np.zeros(3)),
            Point(name=f"ring{index}", role="ring", body=distal, place=np.zeros(3)),
            *([] if choice is None else attachments(choice, index, vein)),
            Point(name=f"tip{index}", role="tip", body=distal, place=tip),
        ]
        thick, dense = design.vein.diameter, design.vein.density
        # veins overlap near the hub even where the fan lies flat
        base = Bar(body=proximal, end=ring, diameter=thick, density=dense, points=(first, first + 1), overlaps=True)
        bars += [base, Bar(body=distal, end=tip, diameter=thick, density=dense, points=(first + 1, len(points) - 1))]
        hinges += _hinges(design, index, vein)
        if choice is None:
            continue
        carried = turned_inertia(masses, distal, hinges[-1].axis)
        tendons.append(
            Tendon(
                name=f"tendon{index}",
                role="tendon",
                points=(first + 2, first + 3),
                law=tendon_law(choice),
                longest=math.hypot(choice.proximal_attachment, choice.proximal_offset, choice.proximal_aside)
                + math.hypot(choice.distal_attachment, choice.distal_offset, choice.distal_aside),
                crossing=_crossing(design, choice, len(hinges) - 1, vein.ring_direction, _bars(vein), carried),
                ideal=_crossing(design, choice, len(hinges) - 1, *_SQUARE, carried),
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
        contact=design.protocol.contact,
        gravity=design.protocol.gravity,
        appearance=_APPEARANCE if design.hinge.armature else replace(_APPEARANCE, steadier=_STEADIER),
    )
    return with_protocol(built, design)


def _hinges(design: FanDesign, index: int, vein: Vein) -> list[Hinge]:
    """The hinges of a vein: of its proximal bar, unless that is held, and of its distal one."""
    choice = design.hinge
    aims = [
        Hinge(
            name=f"{role}{index}",
            role=role,
            body=2 * index,
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
    ring = Hinge(
        name=f"fold{index}",
        role="ring",
        body=2 * index + 1,
        axis=vein.frame.T @ vein.ring_direction,
        lower=-choice.fold_limit,
        upper=choice.overbend,
        start=design.protocol.initial_overbend,
        sense=vein.sense,
        damping=choice.damping,
        armature=choice.armature,
        label=f"vein {index}",
    )
    return [*aims, ring]


def _bars(vein: Vein) -> tuple[Array, Array]:
    """Unit vectors along the proximal and the distal bar, outwards."""
    proximal, distal = vein.ring_vertex - vein.hub_point, vein.tip - vein.ring_vertex
    return proximal / np.linalg.norm(proximal), distal / np.linalg.norm(distal)


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
    share of the proximal length, at the ring fold, at every share of the distal length and at the tip; that of the ring
    fold is on the proximal bar.
    """
    choice, panels = design.membrane, []
    law = MembraneLaw(
        youngs_modulus=choice.youngs_modulus,
        poisson_ratio=choice.poisson_ratio,
        thickness=choice.thickness,
        damping=choice.damping,
    )
    beyond = [0] * (len(choice.proximal_rows) + 1) + [1] * (len(choice.distal_rows) + 1)
    for panel in range(len(veins) - 1):
        pair = veins[panel : panel + 2]
        near, far = (mesh_rows(vein.hub_point, vein.ring_vertex, vein.tip, design) for vein in pair)
        built: list[Array] = []
        bodies: list[int] = []
        places: list[Array] = []
        roots: list[Array] = []
        for distal, here, there in zip(beyond, near, far, strict=True):
            for vein, number, node, root in zip(
                pair, (panel, panel + 1), (margin_edge(here, there, design), there), (here, there), strict=True
            ):
                built.append(node)
                bodies.append(2 * number + distal)
                places.append(vein.on_distal_bar(node) if distal else vein.on_proximal_bar(node))
                roots.append(vein.on_distal_bar(root) if distal else vein.on_proximal_bar(root))
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
            )
        )
    return tuple(panels)


def _guards(design: FanDesign, veins: Sequence[Vein], tips: Sequence[int]) -> tuple[LengthLimit, ...]:
    """Guard tendons between neighbouring tips, of which the numbers are given."""
    limits = []
    for index in range(len(veins) - 1):
        apart = float(np.linalg.norm(veins[index + 1].tip - veins[index].tip))
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
