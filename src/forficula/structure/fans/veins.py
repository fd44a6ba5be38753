"""The structure of a fan: bars on the creases with membranes between them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.arrays import Array
from forficula.design import FanDesign
from forficula.design.places import margin_edge, row_bars
from forficula.pattern import (
    CreasePattern,
    EarwigFan,
    earwig_pattern,
    ring_directions,
    ring_ratios,
    vein_gaps,
    vein_roles,
)
from forficula.quantities import show_value
from forficula.structure.appearance import Appearance
from forficula.structure.contact.contact_section import contact_of
from forficula.structure.fans.fan_masses import fan_masses, fan_panels
from forficula.structure.fans.vein import Vein, panel_lines
from forficula.structure.fans.vein_parts import bare_veins
from forficula.structure.medium import immersed
from forficula.structure.membranes import Membrane, MembraneLaw, Surface
from forficula.structure.motors_and_measures import RigidFold
from forficula.structure.parts import Hinge, LengthLimit
from forficula.structure.protocol import with_protocol
from forficula.structure.sheets.couplings import vein_couplings
from forficula.structure.structure import Structure
from forficula.structure.surroundings import Contact

_APPEARANCE = Appearance(
    whole="wing",
    bar="vein",
    crease="ring fold",
    overbend="overbend",
    bodies="two for every vein",
    titles={"distal_angle": "distal hinge angle", "turn": "turn about its own axis"},
)
_NOT_RIGID = (
    "with two ring folds, whose vertices do not satisfy Kawasaki's condition, rigid panels do not fold, so there is no"
    " energy along a rigid fold; every tendon lies across both folds, so there are no landscapes of single hinges"
)
# hinges of a vein in this order: sweep and lift set its direction, turn is about its own axis
_AIMS = (("sweep", (0.0, 0.0, 1.0)), ("lift", (0.0, 1.0, 0.0)), ("turn", (1.0, 0.0, 0.0)))
# strips along a vein from the membrane's inner edge to the ring fold, and from there to the tip; a gusset is a single
# strip, because it is joined to the panels on both sides, whose distance exceeds the thickness of a layer
_STRIPS = 3
# least distance from a vein's axis, in panel thicknesses, at which neighbouring panels can touch: nearer, they are
# joined
_BESIDE = 5.0
# difference of the ratios of veins that counts as rounding
_EQUAL = 1e-9
_SHARES = np.linspace(0, 1, 1001)


def vein_structure(design: FanDesign) -> Structure:
    """Build bars, hinges, tendons and membranes on the creases of a fan, in the units of its design."""
    fan, pattern = design.fan, earwig_pattern(design.fan)
    built = structure_of_veins(design, veins_on(pattern, ring_directions(fan)))
    section, one_fold = design.pattern, fan.ring_folds == 1
    most = "longest " if fan.varied else ""
    sizes = {
        f"{most}proximal length": max(fan.proximal_lengths),
        f"{most}distal length": max(fan.distal_lengths),
        **({} if fan.hub_shares else {"hub radius": section.hub_radius}),
        **({} if one_fold else {"pitch": fan.pitch, "lowest gusset": fan.gusset_height}),
    }
    text = (
        f"A fan of {fan.vein_count} veins and {fan.vein_count - 1} membrane panels, each vein"
        f" {_lengths(fan.proximal_lengths)} long up to the ring fold and"
        f" {_lengths(fan.distal_lengths)} beyond it"
    )
    if not one_fold:
        text += (
            f", which is two folds with a gusset between them; folded layers are {show_value(fan.pitch, 'm')} apart,"
            " and the gusset of each layer is higher than that of the layer inside it by twice this distance"
        )
    # veins that touch different circles touch no common one
    circles = {} if fan.hub_shares else {"hub": section.hub_radius}
    appearance = replace(built.appearance, text=text, sizes=sizes, pattern=pattern, circles=circles)
    equal = bool(np.ptp(ring_ratios(fan)) <= _EQUAL)
    return replace(
        built,
        appearance=appearance if one_fold else replace(appearance, bodies="three for every vein"),
        rigid_fold=fan_fold(design, built) if one_fold and equal else None,
        remarks=(_NOT_RIGID,) if not one_fold else () if equal else (_unequal_pleats(fan),),
    )


def _lengths(lengths: Sequence[float]) -> str:
    """Return a length, or a range of lengths."""
    least, most = min(lengths), max(lengths)
    return show_value(least, "m") if least == most else f"{show_value(least, 'm')} to {show_value(most, 'm')}"


def _unequal_pleats(fan: EarwigFan) -> str:
    """Return why there is no energy along a rigid fold, with the range of the veins' ratios."""
    ratios = ring_ratios(fan)
    return (
        "rigid panels of different veins fold flat with one degree of freedom, but every vein at its own rate: the"
        f" ratio of the tangents of half the ring's and half the vein's fold angle is {ratios.min():.3g} to"
        f" {ratios.max():.3g}; the energy along a rigid fold is only computed for veins that fold at the same rate"
    )


def veins_on(pattern: CreasePattern, directions: Array) -> tuple[Vein, ...]:
    """Return the veins on the creases of a pattern with the roles of `vein_roles`.

    A turn of a vein in its own sense folds the crease; the panel that is glued to the vein rises if the sense is -1.

    Args:
        pattern: flat crease pattern.
        directions: unit vectors of the axes about which each vein folds at its ring folds, (vein, 3).
    """
    coords = pattern.vertices_coords
    bars = [
        coords[[pattern.edges_vertices[edge] for edge, name in enumerate(pattern.edges_role) if name == role]]
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
    """Build a fan on veins in any positions, with panels and guard tendons between neighbours."""
    bare = bare_veins(
        design,
        veins,
        masses=fan_masses(design, veins),
        labels=[f"vein {index}" for index in range(len(veins))],
        aims=[_aims(design, index, vein) for index, vein in enumerate(veins)],
        overlapping=overlapping_length(design),
    )
    built = replace(
        bare,
        couplings=vein_couplings(design, bare.hinges),
        limits=_guards(design, veins, [number for number, point in enumerate(bare.points) if point.role == "tip"]),
        membranes=_panels(design, veins),
        contact=fan_contact(design),
        appearance=_APPEARANCE,
    )
    return with_protocol(immersed(built, design.medium, fan_panels(design, veins)), design)


def _aims(design: FanDesign, index: int, vein: Vein) -> list[Hinge]:
    """Return the hinges of a vein's proximal bar, none if the bar is fixed."""
    choice = design.hinge
    return [
        Hinge(
            name=f"{role}{index}",
            role=role,
            body=vein.body(index, 0),
            axis=np.array(axis),
            sense=vein.sense if role == "turn" else 1,
            lower=-choice.turn_back if role == "turn" else -math.inf,
            upper=choice.turn_limit if role == "turn" else math.inf,
            damping=choice.damping,
            friction=choice.friction,
            armature=choice.armature,
            label=f"vein {index}",
        )
        for role, axis in _AIMS
        if not vein.fixed_base
    ]


def _panels(design: FanDesign, veins: Sequence[Vein]) -> tuple[Membrane, ...]:
    """Build the membranes: panel k extends from the edge of its margin on vein k to the axis of vein k + 1.

    The margin is glued to vein k and turns with it, and the panel is hinged on the axis of vein k + 1. Rows of nodes
    lie at every share of the proximal length, at the ring folds, at every share of the distal length and at the tip.
    The row of a ring fold is carried by the bar before it.
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
        for bar, start, edge, end in zip(carriers, *panel_lines(design, *pair), strict=True):
            for vein, number, node, root in zip(pair, (panel, panel + 1), (edge, end), (start, end), strict=True):
                built.append(node)
                bodies.append(vein.body(number, bar))
                places.append(vein.on_bar(bar, node))
                roots.append(vein.on_bar(bar, root))
        corners = [
            triangle
            for left in range(0, len(built) - 2, 2)
            for triangle in ([left, left + 2, left + 3], [left, left + 3, left + 1])
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
    """Return the guard tendons between neighbouring tips, given the numbers of the tips."""
    limits = []
    for index in range(len(veins) - 1):
        distance = float(np.linalg.norm(veins[index + 1].places[-1] - veins[index].places[-1]))
        ends, most = (tips[index], tips[index + 1]), design.guard.stretch * distance
        limits.append(LengthLimit(name=f"guard{index}", points=ends, built_length=distance, most=most))
    return tuple(limits)


def fan_fold(design: FanDesign, structure: Structure) -> RigidFold:
    """Return the fold of a fan with rigid panels along its pleats.

    The pleat angle is the fold angle of the veins; it is negative in the overbend. Veins turn by half of the pleat
    angle, and the distal hinges fold with the ring creases. The hub points are fixed, so that rigid folding does not
    determine sweep and lift of the veins: they minimise the stretching of the membrane.
    """
    camber, ratio = camber_angle(design), ring_ratio(design.fan)
    roles = [hinge.role for hinge in structure.hinges]
    return RigidFold(
        turns=tuple(number for number, role in enumerate(roles) if role == "turn"),
        folds=tuple(number for number, role in enumerate(roles) if role == "ring"),
        ratio=ratio,
        first=camber,
        last=_last_pleat(design, ratio),
        base_length=design.pattern.proximal_length,
        tip_length=design.pattern.distal_length,
        tips=tuple(number for number, point in enumerate(structure.points) if point.role == "tip"),
        start="flat",
        end="folded",
        remarks=_remarks(design, camber),
    )


def ring_ratio(fan: EarwigFan) -> float:
    """Compute m, the ratio of the tangents of half the ring's and half the middle vein's fold angle.

    See docs/model/theory.md, section "Fan pattern".
    """
    return float(ring_ratios(fan)[fan.units])


def camber_angle(design: FanDesign) -> float | None:
    """Compute the pleat angle at which the ring creases reach the overbend, rad, negative; None if they never do."""
    ratio = ring_ratio(design.fan)
    return -2 * math.atan2(math.tan(design.hinge.overbend / 2), ratio) if ratio > 0 else None


def _last_pleat(design: FanDesign, ratio: float) -> float:
    """Compute the pleat angle at which the ring creases reach their fold limit, or the veins their turn limit, rad."""
    limit = design.hinge.fold_limit
    closed = math.pi if ratio == 0 or limit == math.pi else 2 * math.atan2(math.tan(limit / 2), ratio)
    return min(closed, 2 * design.hinge.turn_limit)


def _remarks(design: FanDesign, camber: float | None) -> tuple[str, ...]:
    if camber is None:
        return (
            "pattern.hub_radius is 0, so the ring fold stays straight until the pleats are closed: rigid panels never"
            " reach the overbend, and their energy is constant; a hub radius > 0 couples ring fold and pleats",
        )
    remarks = []
    if 2 * design.hinge.turn_limit < math.pi:
        remarks.append(
            f"hinge.turn_limit stops the veins at {math.degrees(design.hinge.turn_limit):.4g} deg, so rigid panels"
            f" cannot pleat beyond {math.degrees(2 * design.hinge.turn_limit):.4g} deg"
        )
    back, stop = -camber / 2, design.hinge.turn_back
    if back > stop:
        remarks.append(
            f"rigid panels reach the overbend of {math.degrees(design.hinge.overbend):.4g} deg only with veins turned"
            f" back by {math.degrees(back):.4g} deg, and hinge.turn_back stops them at {math.degrees(stop):.4g} deg:"
            " in the compliant wing the membrane stretches instead"
        )
    return tuple(remarks)


def fan_contact(design: FanDesign) -> Contact | None:
    """Return the contact of the panels and bars of a fan; None without contact."""
    return contact_of(design, design.membrane.thickness)


def overlapping_length(design: FanDesign) -> float:
    """Compute the length of proximal bars from the hub in which contact is ignored, m.

    It extends to the membrane, or further if neighbouring bars overlap further in the flat fan. Nearer to the hub,
    neighbours may overlap when flat, and folding brings them together.
    """
    close = _SHARES[vein_gaps(design.fan, _SHARES) <= design.vein.diameter]
    overlap = float(close[-1]) + 1 / (len(_SHARES) - 1) if len(close) else 0.0
    return min(max(overlap, design.membrane.proximal_rows[0]), 1.0) * max(design.fan.proximal_lengths)


def panel_surface(design: FanDesign, veins: Sequence[Vein], number: int) -> Surface:
    """Build the surface of a panel and its margin, from the axis of one vein to that of the next.

    The nodes lie on four lines. Three are carried by the bars of vein `number`: its axis, a line beside the axis up to
    which contact with the previous panel is ignored, and the edge of the margin. The fourth is the next vein's axis.
    """
    near, far = veins
    contact = fan_contact(design)
    thickness = design.membrane.thickness if contact is None else contact.thickness
    beside = max(_BESIDE * thickness, design.vein.diameter)
    rows = [(0, design.membrane.proximal_rows[0])]
    for bar in range(near.bars):
        first = rows[0][1] if bar == 0 else 0.0
        strips = _STRIPS if bar in (0, near.bars - 1) else 1
        rows += [(bar, share) for share in np.linspace(first, 1, strips + 1)[1:].tolist()]
    bodies, places = [], []
    for bar, share in rows:
        start, end = (vein.places[bar] + share * (vein.places[bar + 1] - vein.places[bar]) for vein in (near, far))
        edge = margin_edge(start, end, design, near.margin_along(bar) if share == 1 else None)
        margin = float(np.linalg.norm(edge - start))
        contact_line = start + beside / max(margin, 2 * beside) * (edge - start)
        for vein, index, place in zip(
            (near, near, near, far), (number, number, number, number + 1), (start, contact_line, edge, end), strict=True
        ):
            bodies.append(vein.body(index, bar))
            places.append(vein.on_bar(bar, place))
    triangles, panels = [], []
    for row in range(len(rows) - 1):
        for line in range(3):
            first = 4 * row + line
            triangles += [[first, first + 4, first + 5], [first, first + 5, first + 1]]
            panels += [rows[row + 1][0]] * 2
    return Surface(
        bodies=np.array(bodies, dtype=np.int64),
        places=np.array(places),
        triangles=np.array(triangles, dtype=np.int64),
        panels=np.array(panels, dtype=np.int64),
        names=tuple(f"{role} panel {number}" for role in vein_roles(near.bars - 1)),
    )
