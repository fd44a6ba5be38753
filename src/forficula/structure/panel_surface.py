"""The panels of a fan as surfaces, with the strips by which they are glued to veins: what may touch and cross."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from forficula.design import FanDesign
from forficula.design.fan_sections import ContactSection
from forficula.design.places import margin_edge
from forficula.pattern import vein_gaps, vein_roles
from forficula.structure.parts import Contact, Stops, Surface
from forficula.structure.vein import Vein

# strips along a vein from the membrane's inner edge to the ring fold, and from there to the tip; a gusset is one, for
# all of it is joined to the panels on both sides, which are further from each other than layers are thick
_STRIPS = 3
# how far beside a vein's axis neighbouring panels begin to touch at least, by their thickness: nearer they are joined
_BESIDE = 5.0
_SHARES = np.linspace(0, 1, 1001)


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
