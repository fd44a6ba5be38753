"""Creases between two flaps: their angles and the laws of their springs."""

from __future__ import annotations

import math

import numpy as np

from forficula.arrays import Array, Indices
from forficula.material.law.crease_law import CreaseLaw
from forficula.pattern.geometry import cross, dot
from forficula.structure.structure import Structure
from forficula.structure.tree import built_points

# [chosen] stiffness of stops, if not given, relative to that of the crease, or of the stiffest crease if this one has
# no spring: in runs and in statics. With the spring 1 rad from rest, a stop deflects by 0.06 deg in runs and by
# 6e-5 deg in statics.
_STOP, _RIGID = 1e3, 1e6
# [chosen] angle by which a crease with dry friction turns elastically before it slides, rad
_SLIDING = 5e-3
_NEVER = 1e30  # s, relaxation time of a branch that does not relax


def crease_numbers(structure: Structure) -> Indices:
    """Return the numbers of the hinges that are creases, (crease,)."""
    return np.array([number for number, hinge in enumerate(structure.hinges) if hinge.flaps], dtype=np.int64)


def crease_flaps(structure: Structure) -> Indices:
    """Return the points of the flaps of creases, (crease, 6): tail, head and corner on the left, then on the right."""
    return np.array([hinge.flaps for hinge in structure.hinges if hinge.flaps], dtype=np.int64).reshape(-1, 6)


def flap_angles(corners: Array) -> Array:
    """Compute fold angles from the positions of the flaps: 0 flat, valley positive, from -pi to pi, rad, (...).

    The angle is atan2(e . (n x m), m . n) with the normals m and n of the left and the right flap and the unit vector
    e along the crease.

    Args:
        corners: m, (..., 6, 3): tail, head and corner of the left flap, then of the right one.
    """
    # coordinates on the first axis: several times as fast as on the last one
    tail, head, left, right_tail, right_head, right = np.moveaxis(corners, (-2, -1), (0, 1))
    edge, right_edge = head - tail, right_head - right_tail
    along = edge + right_edge
    one, other = cross(edge, left - tail), cross(right - right_tail, right_edge)
    sine = dot(along, cross(other, one)) / np.sqrt(dot(along, along))
    return np.asarray(np.arctan2(sine, dot(one, other)))


def built_creases(structure: Structure) -> Array:
    """Compute the angles of the creases in the built shape, in their own senses, rad, (crease,)."""
    senses = np.array([hinge.sense for hinge in structure.hinges if hinge.flaps], dtype=np.int64)
    return np.asarray(senses * flap_angles(built_points(structure)[crease_flaps(structure)]))


def crease_law(structure: Structure, creases: Indices, *, rigid_stops: bool = False) -> CreaseLaw:
    """Return the law of the springs of creases, in the creases' own senses, with arrays (crease,).

    Args:
        structure: structure with the creases.
        creases: numbers of the hinges of the creases, (crease,).
        rigid_stops: whether stops without a given stiffness are practically rigid, for statics.
    """
    hinges = [structure.hinges[number] for number in creases]
    damages = [hinge.damage for hinge in hinges]
    # the engine computes the friction of joints
    rubbing = [[hinge.friction] if hinge.flaps is not None and hinge.friction else [] for hinge in hinges]
    stiffness = np.array([hinge.stiffness for hinge in hinges])
    defaults = (_RIGID if rigid_stops else _STOP) * np.where(stiffness > 0, stiffness, stiffness.max(initial=0.0))
    stops = [
        default if hinge.stop_stiffness is None else hinge.stop_stiffness
        for hinge, default in zip(hinges, defaults, strict=True)
    ]
    return CreaseLaw(
        stiffness=stiffness,
        rest_angle=np.array([hinge.rest_angle for hinge in hinges]),
        lock_below=np.array([hinge.lock_below for hinge in hinges]),
        lock_above=np.array([hinge.lock_above for hinge in hinges]),
        lower=np.array([hinge.lower for hinge in hinges]),
        upper=np.array([hinge.upper for hinge in hinges]),
        stop_stiffness=np.array(stops),
        yield_angle=np.array([hinge.yield_angle for hinge in hinges]),
        hardening=np.array([hinge.hardening for hinge in hinges]),
        quadratic=np.array([hinge.quadratic for hinge in hinges]),
        cubic=np.array([hinge.cubic for hinge in hinges]),
        branch_stiffness=_padded(
            [
                [*(branch.stiffness for branch in hinge.branches), *(limit / _SLIDING for limit in limits)]
                for hinge, limits in zip(hinges, rubbing, strict=True)
            ],
            0.0,
        ),
        branch_time=_padded(
            [
                [*(branch.time for branch in hinge.branches), *(_NEVER for _ in limits)]
                for hinge, limits in zip(hinges, rubbing, strict=True)
            ],
            1.0,
        ),
        branch_limit=_padded(
            [[*(math.inf for _ in hinge.branches), *limits] for hinge, limits in zip(hinges, rubbing, strict=True)],
            math.inf,
        ),
        damage_loss=np.array([damage.loss if damage else 0.0 for damage in damages]),
        damage_turn=np.array([damage.turn if damage else 1.0 for damage in damages]),
        damage_by_set=np.array([damage is not None and damage.by_set for damage in damages], dtype=np.bool_),
    )


def _padded(rows: list[list[float]], absent: float) -> Array:
    """Return rows of numbers as an array, (row, number), with a value for absent numbers."""
    most = max((len(row) for row in rows), default=0)
    return np.array([[*row, *[absent] * (most - len(row))] for row in rows]).reshape(len(rows), most)
