"""Largest strains and stresses of bars, sheets and tendons in a run, and the largest fold angle of its creases."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.serial import Key, Pascals, Radians, Seconds, Written
from forficula.structure import hinge_groups, springs_name
from forficula.structure.membrane_stress import principal_strains, principal_stresses


@dataclass(frozen=True, kw_only=True)
class Peak:
    """The largest strain and the largest stress of some parts in a run.

    Attributes:
        kind: of the parts, such as "bars".
        strain: strain of largest magnitude, positive for stretching.
        stress: stress of largest magnitude, Pa; None if the part has no cross-section or no law for it. For bars it is
            the stress at the largest strain. In a membrane it may be elsewhere, because stretching in two directions
            increases the stress.
        part: name of the part.
        time: of the largest strain, s.
        stressed_at: time of the largest stress, s.
        withstood: strength of the material, Pa; None if it is not given.
    """

    kind: Annotated[str, Written.NEVER]
    strain: float
    stress: Annotated[Pascals | None, Written.IF_KNOWN]
    withstood: Annotated[Pascals | None, Key("strength"), Written.IF_KNOWN] = None
    part: str
    time: Seconds
    stressed_at: Annotated[Seconds, Written.NEVER]


@dataclass(frozen=True, kw_only=True)
class FoldPeak:
    """Largest fold angle of all creases in a run, or largest permanent fold at its end, in the crease's own sense.

    Attributes:
        angle: rad.
        crease: its name.
        time: s.
    """

    angle: Radians
    crease: str
    time: Seconds


@dataclass(frozen=True, kw_only=True)
class WornCrease:
    """The crease that wear has weakened most at the end of a run.

    Attributes:
        remaining: share of its moment that remains.
        crease: name of the crease.
    """

    remaining: float
    crease: str


def strain_peaks(record: Record) -> tuple[Peak, ...]:
    """Find the largest strains of bars, membranes and tendons in the rows of a record.

    Returns:
        One peak per kind of part that the structure has; empty for a run that diverged.
    """
    if record.diverged_at is not None:
        return ()
    result = (_bars(record), *membrane_peaks(record), _tendons(record))
    return tuple(peak for peak in result if peak is not None)


def fold_peak(record: Record) -> FoldPeak | None:
    """Find the crease with the largest fold angle; None for a structure without creases and for a diverged run."""
    creases = hinge_groups(record.structure).get("creases", ())
    if not creases or record.diverged_at is not None:
        return None
    angles = record.series["hinge_angle"][:, list(creases)]
    row, crease = _furthest(angles)
    return FoldPeak(
        angle=float(angles[row, crease]),
        crease=record.structure.hinges[creases[crease]].name,
        time=float(record.time[row]),
    )


def permanent_fold(record: Record) -> FoldPeak | None:
    """Find the crease with the largest permanent fold at the end of a run; None if no crease yields, or if it diverged.

    The permanent fold (set) is the angle about which the crease then rests without a moment of the part of its spring
    that yields; see `CreaseLaw`.
    """
    if "hinge_set" not in record.series or record.diverged_at is not None:
        return None
    sets = record.series["hinge_set"][-1]
    crease = int(np.argmax(np.abs(sets)))
    return FoldPeak(angle=float(sets[crease]), crease=record.structure.hinges[crease].name, time=float(record.time[-1]))


def worn_crease(record: Record) -> WornCrease | None:
    """Find the crease that has lost most of its moment to wear; None if no crease wears, or for a diverged run."""
    if "hinge_remaining" not in record.series or record.diverged_at is not None:
        return None
    remaining = record.series["hinge_remaining"][-1]
    crease = int(np.argmin(remaining))
    return WornCrease(remaining=float(remaining[crease]), crease=record.structure.hinges[crease].name)


def _bars(record: Record) -> Peak | None:
    """Return the peak of axial strain relative to the resting length, and of stress in the cross-section."""
    springs = record.structure.springs
    if not springs or "spring_force" not in record.series:
        return None
    stiffness, rest = (np.array([getattr(spring, name) for spring in springs]) for name in ("stiffness", "rest_length"))
    forces = record.series["spring_force"]
    strains = np.divide(forces, stiffness * rest, out=np.zeros_like(forces), where=stiffness * rest > 0)
    row, bar = _furthest(strains)
    area = springs[bar].area
    return Peak(
        kind=springs_name(record.structure),
        strain=float(strains[row, bar]),
        stress=float(forces[row, bar]) / area if area else None,
        part=springs[bar].name,
        time=float(record.time[row]),
        stressed_at=float(record.time[row]),
        withstood=record.structure.strength,
    )


def membrane_peaks(record: Record) -> list[Peak]:
    """Find the largest principal strain and the largest principal stress in the triangles of every membrane.

    Returns:
        One peak per membrane; empty for a diverged run and for a record without positions of membrane nodes.
    """
    if record.diverged_at is not None or "membrane_position" not in record.series:
        return []
    peaks, first = [], 0
    for membrane in record.structure.membranes:
        places = record.series["membrane_position"][:, first : first + len(membrane.bodies)]
        first += len(membrane.bodies)
        principal = principal_strains(membrane.built[membrane.triangles], places[:, membrane.triangles])
        strain, row = _largest(principal)
        stress, stressed = _largest(principal_stresses(membrane.law, principal))
        peaks.append(
            Peak(
                kind="membranes",
                strain=strain,
                stress=stress,
                part=membrane.name,
                time=float(record.time[row]),
                stressed_at=float(record.time[stressed]),
                withstood=record.structure.strength,
            )
        )
    return peaks


def _largest(principal: Array) -> tuple[float, int]:
    """Return the principal value of largest magnitude of (row, triangle, 2), and its row."""
    place = np.unravel_index(int(np.argmax(np.abs(principal))), principal.shape)
    return float(principal[place]), int(place[0])


def _tendons(record: Record) -> Peak | None:
    """Return the peak of tendon extension divided by the gauge length, without a stress: the law gives the force."""
    tendons = record.structure.tendons
    gauges = np.array([tendon.gauge_length for tendon in tendons])
    known = np.flatnonzero(gauges > 0)
    if not len(known):
        return None
    strains = np.maximum(record.series["tendon_length"][:, known] / gauges[known] - 1, 0)
    row, tendon = _furthest(strains)
    return Peak(
        kind="tendons",
        strain=float(strains[row, tendon]),
        stress=None,
        part=tendons[int(known[tendon])].name,
        time=float(record.time[row]),
        stressed_at=float(record.time[row]),
    )


def _furthest(values: Array) -> tuple[int, int]:
    """Return row and column of the value of largest magnitude."""
    row, column = np.unravel_index(int(np.argmax(np.abs(values))), values.shape)
    return int(row), int(column)
