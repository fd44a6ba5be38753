"""Creases between two flaps: their angles, and the laws of their springs."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array, Indices
from forficula.material.law.crease_law import CreaseLaw
from forficula.pattern.geometry import cross, dot
from forficula.structure.structure import Structure
from forficula.structure.tree import built_points

# by a crease's stiffness, or by the stiffest if it has none: that of its stops, if it is not given [chosen]. In runs a
# stop of 1000 times gives way by 0.06 deg where the spring of the crease is 1 rad from rest; in statics by 6e-5 deg.
_STOP, _RIGID = 1e3, 1e6


def crease_numbers(structure: Structure) -> Indices:
    """Numbers of the hinges that are creases, (crease,)."""
    return np.array([number for number, hinge in enumerate(structure.hinges) if hinge.flaps], dtype=np.int64)


def crease_flaps(structure: Structure) -> Indices:
    """Points of the flaps of all creases, (crease, 6): tail, head and corner on the left, then on the right."""
    return np.array([hinge.flaps for hinge in structure.hinges if hinge.flaps], dtype=np.int64).reshape(-1, 6)


def flap_angles(corners: Array) -> Array:
    """Fold angles from where the points of the flaps are: 0 flat, valley positive, from -pi to pi, rad, (...).

    With the normals m and n of the left and the right flap and the unit vector e along the crease that is
    atan2(e . (n x m), m . n).

    Args:
        corners: m, (..., 6, 3): tail, head and corner of the left flap, then of the right one.
    """
    # coordinates first: several times as fast as along the last axis
    tail, head, left, right_tail, right_head, right = np.moveaxis(corners, (-2, -1), (0, 1))
    edge, right_edge = head - tail, right_head - right_tail
    along = edge + right_edge
    one, other = cross(edge, left - tail), cross(right - right_tail, right_edge)
    sine = dot(along, cross(other, one)) / np.sqrt(dot(along, along))
    return np.asarray(np.arctan2(sine, dot(one, other)))


def built_creases(structure: Structure) -> Array:
    """Angles of the creases in the built shape, in their own senses, rad, (crease,)."""
    senses = np.array([hinge.sense for hinge in structure.hinges if hinge.flaps], dtype=np.int64)
    return np.asarray(senses * flap_angles(built_points(structure)[crease_flaps(structure)]))


def crease_law(structure: Structure, creases: Indices, *, rigid_stops: bool = False) -> CreaseLaw:
    """The law of the springs of creases, by the numbers of their hinges, in own senses, arrays (crease,).

    Args:
        structure: whose creases they are.
        creases: numbers of their hinges, (crease,).
        rigid_stops: whether stops without a stiffness of their own are so stiff that they count as rigid, for statics.
    """
    hinges = [structure.hinges[number] for number in creases]
    stiffness = np.array([hinge.stiffness for hinge in hinges])
    chosen = (_RIGID if rigid_stops else _STOP) * np.where(stiffness > 0, stiffness, stiffness.max(initial=0.0))
    stops = [
        own if hinge.stop_stiffness is None else hinge.stop_stiffness for hinge, own in zip(hinges, chosen, strict=True)
    ]
    return CreaseLaw(
        stiffness=stiffness,
        rest_angle=np.array([hinge.rest_angle for hinge in hinges]),
        lock_below=np.array([hinge.lock_below for hinge in hinges]),
        lock_above=np.array([hinge.lock_above for hinge in hinges]),
        lower=np.array([hinge.lower for hinge in hinges]),
        upper=np.array([hinge.upper for hinge in hinges]),
        stop_stiffness=np.array(stops),
    )
