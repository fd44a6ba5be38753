"""Bars on creases with membranes between them: the fan as a structure."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.arrays import Array
from forficula.design import FanDesign
from forficula.design.places import row_bars
from forficula.pattern import CreasePattern, earwig_pattern, ring_directions, vein_roles
from forficula.quantities import show_value
from forficula.structure.appearance import Appearance
from forficula.structure.couplings import vein_couplings
from forficula.structure.fan_fold import fan_fold
from forficula.structure.fan_masses import fan_masses, fan_panels
from forficula.structure.medium import immersed
from forficula.structure.panel_surface import fan_contact, overlapping_length, panel_surface
from forficula.structure.parts import Hinge, LengthLimit, Membrane, MembraneLaw
from forficula.structure.protocol import with_protocol
from forficula.structure.structure import Structure
from forficula.structure.vein import Vein, panel_lines
from forficula.structure.vein_parts import bare_veins

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
