"""Straps as solids: as they are made, taut between their pegs, and bowed where they are slack."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.make.elastica import elastica
from forficula.make.joint_layout import Arm, JointLayout
from forficula.make.solids import Cut, Joined, Prism, Rod, Solid, band
from forficula.make.straps import Strap
from forficula.structure.parts import Array

# shorter than this, seen along the hinge, a strap's ends have no direction to bow square to, m
_NOWHERE = 1e-9
# corners of a bow
_CORNERS = 49


@dataclass(frozen=True, kw_only=True, eq=False)
class StrapPlace:
    """Where a tendon's straps end as the structure is built, in the axes of the ground.

    Attributes:
        tendon: its number.
        strap: what it is made as.
        bodies: of the two pegs, proximal first.
        ends: middles of a strap's eyes on them, m, (strap, 2, 3).
        across: unit vectors along the two pegs, (2, 3).
        up: unit vector to the side of the overbend, (3,).
        peg_diameter: m.
    """

    tendon: int
    strap: Strap
    bodies: tuple[int, int]
    ends: Array
    across: Array
    up: Array
    peg_diameter: float

    @property
    def eye_diameter(self) -> float:
        """Outer one of a strap's eyes, with walls as thick as the strap, m."""
        return self.peg_diameter + 2 * self.strap.thickness


def strap_places(joints: Sequence[JointLayout]) -> tuple[StrapPlace, ...]:
    """Where the straps of all tendons end, by what the joints have of their pegs; a tendon may cross several joints."""
    pegs: dict[int, list[tuple[JointLayout, Arm]]] = {}
    for joint in joints:
        if joint.tendon is not None:
            pegs.setdefault(joint.tendon, []).extend((joint, arm) for arm in (joint.proximal, joint.distal) if arm.peg)
    places = []
    for tendon, ((first, inner), (last, outer)) in pegs.items():
        if first.strap is None:
            continue
        across = np.array([first.across(inner), last.across(outer)])
        middles = np.array([first.peg_of(inner), last.peg_of(outer)])
        sides = (1, -1) if first.strap.count == 2 else (0,)
        places.append(
            StrapPlace(
                tendon=tendon,
                strap=first.strap,
                bodies=(inner.body, outer.body),
                ends=np.array([middles + side * first.aside * across for side in sides]),
                across=across,
                up=first.frame[:, 2],
                peg_diameter=first.make.peg_diameter,
            )
        )
    return tuple(places)


def made_strap(place: StrapPlace) -> Solid:
    """A strap at its resting length, straight from its proximal peg towards the other, with an eye at either end."""
    start, end = place.ends[0]
    along = (end - start) / np.linalg.norm(end - start)
    return _with_eyes(place, np.array([start, start + place.strap.rest_length * along]), place.up)


def strap_between(place: StrapPlace, start: Array, end: Array, side: Array) -> Solid:
    """A strap without its eyes between two places, m, bowed towards a side where it is longer than their distance.

    It bends about its width and does not twist. Taut, it keeps its width and thickness: it is drawn too thick.
    """
    chord = end - start
    apart = float(np.linalg.norm(chord))
    bow = side - chord * float(side @ chord) / max(apart, _NOWHERE) ** 2
    bow /= max(float(np.linalg.norm(bow)), _NOWHERE)
    along = chord / apart if apart > _NOWHERE else np.cross(bow, place.across[0])
    line = elastica(place.strap.rest_length, apart, _CORNERS)
    return Prism(
        outline=band(line, place.strap.thickness),
        origin=start,
        frame=np.column_stack([along, bow, np.cross(along, bow)]),
        height=place.strap.width,
    )


def _with_eyes(place: StrapPlace, ends: Array, up: Array) -> Solid:
    """A straight strap between the middles of two eyes."""
    along = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
    across = np.cross(up, along) / np.linalg.norm(np.cross(up, along))
    half = place.strap.width / 2 * across

    def disc(middle: Array, diameter: float, longer: float) -> Rod:
        return Rod(start=middle - longer * half, end=middle + longer * half, diameter=diameter)

    length = float(np.linalg.norm(ends[1] - ends[0]))
    middle = Prism(
        outline=band(np.array([[0.0, 0.0], [length, 0.0]]), place.strap.thickness),
        origin=ends[0],
        frame=np.column_stack([along, np.cross(across, along), -across]) @ np.diag([1.0, -1.0, -1.0]),
        height=place.strap.width,
    )
    eyes = [disc(end, place.eye_diameter, 1.0) for end in ends]
    holes = tuple(disc(end, place.peg_diameter, 2.0) for end in ends)
    return Cut(solid=Joined(solids=(middle, *eyes)), taken=holes)
