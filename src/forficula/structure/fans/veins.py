"""Bars on creases with membranes between them: the fan as a structure."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.arrays import Array
from forficula.design import FanDesign
from forficula.design.fans.fan_sections import ContactSection
from forficula.design.places import margin_edge, row_bars
from forficula.pattern import CreasePattern, EarwigFan, earwig_pattern, ring_directions, vein_gaps, vein_roles
from forficula.quantities import show_value
from forficula.structure.appearance import Appearance
from forficula.structure.course import RigidFold
from forficula.structure.fans.fan_masses import fan_masses, fan_panels
from forficula.structure.fans.vein import Vein, panel_lines
from forficula.structure.fans.vein_parts import bare_veins
from forficula.structure.medium import immersed
from forficula.structure.parts import Contact, Hinge, LengthLimit, Membrane, MembraneLaw, Stops, Surface
from forficula.structure.protocol import with_protocol
from forficula.structure.sheets.couplings import vein_couplings
from forficula.structure.structure import Structure

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
# the hinges of a vein in this order: sweep and lift aim it, turn is about its own axis
_AIMS = (("sweep", (0.0, 0.0, 1.0)), ("lift", (0.0, 1.0, 0.0)), ("turn", (1.0, 0.0, 0.0)))
# strips along a vein from the membrane's inner edge to the ring fold, and from there to the tip; a gusset is one, for
# all of it is joined to the panels on both sides, which are further from each other than layers are thick
_STRIPS = 3
# how far beside a vein's axis neighbouring panels begin to touch at least, by their thickness: nearer they are joined
_BESIDE = 5.0
_SHARES = np.linspace(0, 1, 1001)


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
    """The hinges of a vein's proximal bar, unless that is held."""
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


def fan_fold(design: FanDesign, structure: Structure) -> RigidFold:
    """How a fan folds along its pleats.

    The pleat angle is the fold angle of the veins; it is negative where the overbend bends them backwards. Veins turn
    by half of it and the distal hinges fold with the ring creases. Sweep and lift of the veins, which the panels' way
    leaves open because the hub points stay where they are, go to where the membrane is stretched least.
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
    """Ratio m of the tangents of half the ring's and half the veins' fold angle (theory.md, section 2)."""
    return math.sin(fan.epsilon) / math.cos(fan.sector_angle / 2)


def camber_angle(design: FanDesign) -> float | None:
    """Pleat angle at which the ring creases reach the overbend, rad, negative; None where they never do."""
    ratio = ring_ratio(design.fan)
    return -2 * math.atan2(math.tan(design.hinge.overbend / 2), ratio) if ratio > 0 else None


def _last_pleat(design: FanDesign, ratio: float) -> float:
    """Pleat angle at which the ring creases reach the fold limit, or the veins theirs, rad."""
    limit = design.hinge.fold_limit
    closed = math.pi if ratio == 0 or limit == math.pi else 2 * math.atan2(math.tan(limit / 2), ratio)
    return min(closed, 2 * design.hinge.turn_limit)


def _remarks(design: FanDesign, camber: float | None) -> tuple[str, ...]:
    if camber is None:
        return (
            "pattern.hub_radius is 0, so the ring fold stays straight until the pleats are closed: rigid panels never"
            " reach the overbend, and their energy is the same all along; a hub radius > 0 couples the two",
        )
    remarks = []
    if 2 * design.hinge.turn_limit < math.pi:
        remarks.append(
            f"hinge.turn_limit stops the veins at {math.degrees(design.hinge.turn_limit):.4g} deg, so rigid panels"
            f" pleat to {math.degrees(2 * design.hinge.turn_limit):.4g} deg and no further"
        )
    back, stop = -camber / 2, design.hinge.turn_back
    if back > stop:
        remarks.append(
            f"rigid panels reach the overbend of {math.degrees(design.hinge.overbend):.4g} deg only with veins turned"
            f" back by {math.degrees(back):.4g} deg, and hinge.turn_back stops them at {math.degrees(stop):.4g} deg:"
            " in the compliant wing the membrane gives way instead"
        )
    return tuple(remarks)


def fan_contact(design: FanDesign) -> Contact | None:
    """How the panels and the bars of a fan touch; None where they do not."""
    if not design.protocol.contact:
        return None
    chosen = design.contact or ContactSection()
    return Contact(
        thickness=design.membrane.thickness if chosen.thickness is None else chosen.thickness,
        friction=chosen.friction,
        stops=Stops(time_constant=chosen.time_constant, damping_ratio=chosen.damping_ratio),
    )


def overlapping_length(design: FanDesign) -> float:
    """How far from the hub on proximal bars touch nothing, m: up to the membrane, or to where they lie apart if later.

    Nearer, neighbours may overlap in the flat fan, and the hub brings them together as they fold.
    """
    close = _SHARES[vein_gaps(design.fan, _SHARES) <= design.vein.diameter]
    apart = float(close[-1]) + 1 / (len(_SHARES) - 1) if len(close) else 0.0
    return min(max(apart, design.membrane.proximal_rows[0]), 1.0) * design.pattern.proximal_length


def panel_surface(design: FanDesign, veins: Sequence[Vein], number: int) -> Surface:
    """The surface of a panel and its margin, from the axis of one vein to that of the next.

    Lines of nodes: the axis of vein `number`, one beside it up to which the panel before may fold on this one without
    touching, the edge of the margin, all on that vein's bars, and the axis of the next vein.
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
        here, there = (vein.places[bar] + share * (vein.places[bar + 1] - vein.places[bar]) for vein in (near, far))
        edge = margin_edge(here, there, design, near.margin_along(bar) if share == 1 else None)
        margin = float(np.linalg.norm(edge - here))
        begins = here + beside / max(margin, 2 * beside) * (edge - here)
        for vein, index, place in zip(
            (near, near, near, far), (number, number, number, number + 1), (here, begins, edge, there), strict=True
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
