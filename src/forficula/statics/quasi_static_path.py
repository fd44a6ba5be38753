"""Quasi-static path of a structure: the shapes through which a slowly growing drive takes it, of trees and of nets."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.quantities import show_value
from forficula.results import pandas_module
from forficula.structure import Drive, Structure, crease_law, drive_unit
from forficula.structure.sheets.facets import springs_name

if TYPE_CHECKING:
    from forficula.results import DataFrame

Flags = NDArray[np.bool_]

_MORE = 1.25  # ratio of the numbers of points from one display of a growing path to the next


@dataclass(frozen=True, kw_only=True, eq=False)
class QuasiStaticPoint:
    """A shape of a structure on its quasi-static path.

    Attributes:
        strength: of the drive, in the drive's SI unit, with the sign of the drive.
        resting: whether the structure is at rest under this drive; False during a snap.
        angles: of all hinges in their own senses, rad, (hinge,).
        positions: of the structure's points, then of the nodes of its membranes, m, (place, 3).
        coordinates: what the solver moves, (coordinate,): angles of hinges, rad, or displacements of a net's nodes from
            the built shape, m.
        energy: stored by part, J; parts that the structure does not have are left out.
        force: total force along the displacement of the drive, N; 0 for other drives.
    """

    strength: float
    resting: bool
    angles: Array
    positions: Array
    coordinates: Array
    energy: Mapping[str, float]
    force: float = 0.0


@dataclass(frozen=True, kw_only=True)
class PathMark:
    """Event on a quasi-static path.

    Attributes:
        kind: "snap", a jump at a constant drive; "branch", where the path turns into one of several possible paths;
            "goal", where the goal of the transition is reached; "lost", where the path could not be followed further.
        share: position on the path.
        end: position at which a snap ends; equal to `share` for other events.
        strength: of the drive, in its SI unit, with the sign of the drive.
        released: energy that a snap releases, J; 0 for other events.
        text: a sentence on the event.
    """

    kind: Literal["snap", "branch", "goal", "lost"]
    share: float
    end: float
    strength: float
    released: float
    text: str


@dataclass(frozen=True, kw_only=True, eq=False)
class QuasiStaticPath:
    """Quasi-static path of a structure under a slowly growing drive, from rest to the goal of a transition.

    The structure is at rest at all points except within snaps. A snap has several points at the same strength of the
    drive, between its last equilibrium and the next one, in the order of a motion with equal dampers and without
    inertia.

    Attributes:
        structure: the structure.
        name: name of the transition, or of the drive if it makes none.
        drive: the drive; its full strength is that of the design.
        share: position of each point on the path, rising from 0 to 1, (point,). Between two points it grows with the
            root of the mean square distance that the structure's points move.
        strength: strength of the drive in its SI unit, with the sign of the drive, (point,).
        resting: whether the structure is at rest, (point,); False within a snap.
        angles: of all hinges in their own senses, rad, (point, hinge).
        positions: of the structure's points, then of the nodes of its membranes, m, (point, place, 3); the anchors of a
            drawing are indices into the second axis.
        coordinates: what the solver moves, (point, coordinate).
        energy: stored energy by part, J, (point,) each.
        force: total force along the displacement of the drive, N, (point,); 0 for other drives.
        length: distance along the path in the measure of `share`, m.
        marks: events, by share.
        reached: whether the path reaches the goal of its transition, or the full strength of the drive without a goal.
        complete: whether the path is computed to its end; False while it grows.
        error: largest estimated distance between a point of the structure and its linear interpolation between points
            of the path at which it is at rest, as a share of the structure's span; nan while the path grows.
        at: position of the shape from which the path was continued; None if it was computed from its start.
        remarks: sentences on what is unreliable or missing.
    """

    structure: Structure
    name: str
    drive: Drive
    share: Array
    strength: Array
    resting: Flags
    angles: Array
    positions: Array
    coordinates: Array
    energy: Mapping[str, Array]
    force: Array
    length: float
    marks: tuple[PathMark, ...]
    reached: bool
    complete: bool
    error: float
    at: float | None = None
    remarks: tuple[str, ...] = ()

    def __repr__(self) -> str:
        """Name, number of points and events."""
        events = ", ".join(f"{mark.kind} at {100 * mark.share:.0f} %" for mark in self.marks)
        return f"<QuasiStaticPath {self.name}: {len(self.share)} points{'; ' if events else ''}{events}>"

    @property
    def unit(self) -> str:
        """Return the SI unit of the strength of the drive."""
        return drive_unit(self.structure, self.drive)

    @cached_property
    def stored(self) -> Array:
        """Return the stored energy of all parts, J, (point,)."""
        return np.asarray(np.sum([np.zeros(len(self.share)), *self.energy.values()], axis=0))

    @cached_property
    def moments(self) -> Array:
        """Return the moments of the springs of all hinges and creases, N m, (point, hinge).

        A moment is the derivative of the energy of the spring by the hinge's angle in its own sense, positive if the
        spring reduces the angle. A drive that changes rest angles changes the moments accordingly.
        """
        return spring_moments(
            self.structure, self.angles, self.strength[:, None] * rest_changes(self.structure, self.drive)
        )

    @cached_property
    def strains(self) -> Mapping[str, Array]:
        """Return the strains of elastic parts, (point, element) each, without parts that the structure does not have.

        "bars" (or "openings" between plates): change of length per rest length, nan for a rest length of 0. "tendons":
        extension per rest length, 0 if slack. "membranes": largest principal Green strain of each triangle.
        """
        structure, result = self.structure, dict[str, Array]()
        if structure.springs:
            rest = np.array([spring.rest_length for spring in structure.springs])
            length = self._lengths([spring.points for spring in structure.springs])
            strain = np.full_like(length, np.nan)
            np.divide(length - rest, rest, out=strain, where=np.broadcast_to(rest > 0, length.shape))
            result[springs_name(structure)] = strain
        if structure.tendons:
            rest = np.array([float(tendon.law.elastic.rest_length) for tendon in structure.tendons])
            length = self._lengths([tendon.points for tendon in structure.tendons])
            result["tendons"] = np.maximum(length - rest, 0.0) / np.where(rest > 0, rest, np.inf)
        if structure.membranes:
            result["membranes"] = self._membrane_strains()
        return result

    def to_dataframe(self) -> DataFrame:
        """Return a pandas table with share, strength of the drive, energies and rest of every point."""
        pandas = pandas_module()
        unit = self.unit.replace(" ", "_")
        columns: dict[str, object] = {"share": self.share, f"drive_{unit}": self.strength}
        columns |= {f"{part.replace(' ', '_')}_J": values for part, values in self.energy.items()}
        return pandas.DataFrame(columns | {"resting": self.resting})

    def index(self, share: float) -> int:
        """Return the number of the point at or just before a position on the path."""
        return int(np.clip(np.searchsorted(self.share, share, side="right") - 1, 0, len(self.share) - 1))

    def point(self, share: float) -> QuasiStaticPoint:
        """Return the shape at a position on the path, interpolated linearly between points.

        Args:
            share: from 0 to 1.

        Raises:
            InputError: the position is not on the path.
        """
        if not (isinstance(share, int | float | np.number) and 0 <= share <= 1):
            raise InputError(f"share: need a number from 0 to 1, got {share!r}")
        before = self.index(share)
        after = min(before + 1, len(self.share) - 1)
        gap = self.share[after] - self.share[before]
        weight = float(np.clip((share - self.share[before]) / gap, 0.0, 1.0)) if gap > 0 else 0.0

        def between(values: Array) -> Array:
            return np.asarray((1 - weight) * values[before] + weight * values[after])

        return QuasiStaticPoint(
            strength=float(between(self.strength)),
            resting=bool(self.resting[before] and (self.resting[after] or weight == 0)),
            angles=between(self.angles),
            positions=between(self.positions),
            coordinates=between(self.coordinates),
            energy={part: float(between(values)) for part, values in self.energy.items()},
            force=float(between(self.force)),
        )

    def _lengths(self, pairs: Sequence[tuple[int, int]]) -> Array:
        one, other = np.array(pairs).T
        return np.asarray(np.linalg.norm(self.positions[:, other] - self.positions[:, one], axis=2))

    def _membrane_strains(self) -> Array:
        first, result = len(self.structure.points), list[Array]()
        for membrane in self.structure.membranes:
            corners = self.positions[:, first + membrane.triangles]
            result.append(_largest_strain(corners, membrane.built[membrane.triangles]))
            first += len(membrane.built)
        return np.concatenate(result, axis=1)


def _largest_strain(corners: Array, built: Array) -> Array:
    """Return the largest principal Green strain of triangles, (point, triangle).

    Args:
        corners: m, (point, triangle, 3, 3).
        built: corners without strain, m, (triangle, 3, 3).
    """
    sides, rest = (
        np.diff(corners[:, :, [0, 1, 0, 2]], axis=2)[:, :, ::2],
        np.diff(built[:, [0, 1, 0, 2]], axis=1)[:, ::2],
    )
    metric, unstrained = (pair @ np.swapaxes(pair, -1, -2) for pair in (sides, rest))
    mixed = np.linalg.solve(unstrained[None], metric)
    half, product = np.trace(mixed, axis1=-2, axis2=-1) / 2, np.linalg.det(mixed)
    return np.asarray((half + np.sqrt(np.maximum(half**2 - product, 0.0)) - 1) / 2)


def rest_changes(structure: Structure, drive: Drive) -> Array:
    """Return the changes of the rest angles of all hinges, in their own senses, per strength of a drive, (hinge,)."""
    changes = np.zeros(len(structure.hinges))
    for motor, share in zip(structure.motors, drive.shares, strict=True):
        if motor.kind == "rest-angle":
            hinges = list(motor.hinges)
            np.add.at(changes, hinges, share * (np.array(motor.gains) if motor.gains else np.ones(len(hinges))))
    return changes


def spring_moments(structure: Structure, angles: Array, further: Array | float = 0.0) -> Array:
    """Return the moments of the springs of all hinges, N m, (..., hinge).

    Args:
        structure: the structure.
        angles: of all hinges in their own senses, rad, (..., hinge).
        further: changes of the rest angles, rad.
    """
    law = crease_law(structure, np.arange(len(structure.hinges)), rigid_stops=True)
    creases = np.array([hinge.flaps is not None for hinge in structure.hinges], dtype=np.bool_)
    linear = law.rest_moment(angles, further)
    # the stops of joints bound their angles and have no stiffness
    return np.where(creases, law.moment(angles, further), linear)


class GrowingPath:
    """Points of a path while it is computed, which are shown to a caller whenever there are noticeably more.

    Attributes:
        stopped: whether the caller wants to stop.
    """

    def __init__(
        self,
        structure: Structure,
        name: str,
        drive: Drive,
        follow: Callable[[QuasiStaticPath], bool] | None,
        *,
        continued: bool = False,
    ) -> None:
        """Begin without points.

        Args:
            structure: the structure.
            name: name of the transition or of the drive.
            drive: the drive.
            follow: called with the growing path, returns whether to go on; None for no caller.
            continued: whether the first point is the one from which another path is continued.
        """
        self.stopped = False
        self._follow, self._known = follow, (structure, name, drive)
        self._at = 0 if continued else None
        self._points, self._due, self._held = list[QuasiStaticPoint](), 2, 0

    def add(self, point: Callable[[], QuasiStaticPoint]) -> None:
        """Add a point, which is computed only if a caller follows the path."""
        if self._follow is None or self.stopped:
            return
        if self._held:
            self._held += 1
        else:
            self._points.append(point())
        if len(self._points) + self._held >= self._due:
            self.show(self._points)

    def hold(self) -> None:
        """Add no more points; the same path is shown again at times, so that the caller can stop."""
        self._held = 1

    def show(self, points: Sequence[QuasiStaticPoint], *, at: int | None = None) -> None:
        """Show all points of the path so far.

        Args:
            points: in the order of the path.
            at: number of the point from which another path is continued.
        """
        if self._follow is None or self.stopped:
            return
        self._points, self._at = list(points), self._at if at is None else at
        self._due = math.ceil(_MORE * (len(points) + self._held))
        structure, name, drive = self._known
        path = path_of(structure, name, drive, self._points, (), reached=False, complete=False, at=self._at)
        self.stopped = not self._follow(path)


@dataclass(frozen=True, kw_only=True)
class NumberedEvent:
    """Event of a path by the numbers of its points.

    Attributes:
        kind: as for `PathMark`.
        first: number of the point of the event, or of the last equilibrium before a snap.
        last: number of the first equilibrium after a snap; `first` for other events.
        strength: of the drive, in its SI unit, with the sign of the drive.
        released: energy that a snap releases, J.
    """

    kind: Literal["snap", "branch", "goal", "lost"]
    first: int
    last: int
    strength: float
    released: float = 0.0


def last_event(points: Sequence[QuasiStaticPoint], *, reached: bool) -> NumberedEvent:
    """Return the event at the last point of a path: the goal, or the loss of the path."""
    last = len(points) - 1
    return NumberedEvent(kind="goal" if reached else "lost", first=last, last=last, strength=points[-1].strength)


def path_of(
    structure: Structure,
    name: str,
    drive: Drive,
    points: Sequence[QuasiStaticPoint],
    events: Sequence[NumberedEvent],
    *,
    reached: bool,
    complete: bool = True,
    error: float = np.nan,
    at: int | None = None,
    remarks: tuple[str, ...] = (),
) -> QuasiStaticPath:
    """Return a path from its points and events.

    Args:
        structure: the structure.
        name: name of the transition or of the drive.
        drive: the drive.
        points: at least one, in the order of the path.
        events: by the numbers of the points.
        reached: as for `QuasiStaticPath`.
        complete: as for `QuasiStaticPath`.
        error: as for `QuasiStaticPath`.
        at: number of the point from which the path was continued.
        remarks: as for `QuasiStaticPath`.
    """
    positions = np.array([point.positions for point in points])
    steps = np.sqrt(np.mean(np.sum(np.diff(positions, axis=0) ** 2, axis=2), axis=1))
    length = np.concatenate([[0.0], np.cumsum(steps)])
    share = length / length[-1] if length[-1] > 0 else np.linspace(0.0, 1.0, len(points))
    strength = np.array([point.strength for point in points])
    unit = drive_unit(structure, drive)
    marks = [
        PathMark(
            kind=event.kind,
            share=float(share[event.first]),
            end=float(share[event.last]),
            strength=event.strength,
            released=event.released,
            text=_sentence(structure, drive, event, show_value(event.strength, unit)),
        )
        for event in events
        # a path that was stopped might have been followed further
        if complete or event.kind != "lost"
    ]
    return QuasiStaticPath(
        structure=structure,
        name=name,
        drive=drive,
        share=share,
        strength=strength,
        resting=np.array([point.resting for point in points], dtype=np.bool_),
        angles=np.array([point.angles for point in points]),
        positions=positions,
        coordinates=np.array([point.coordinates for point in points]),
        energy={part: np.array([point.energy[part] for point in points]) for part in points[0].energy},
        force=np.array([point.force for point in points]),
        length=float(length[-1]),
        marks=tuple(sorted(marks, key=lambda mark: mark.share)),
        reached=reached,
        complete=complete,
        error=error,
        at=None if at is None else float(share[at]),
        remarks=remarks,
    )


def _sentence(structure: Structure, drive: Drive, event: NumberedEvent, strength: str) -> str:
    """Return a sentence on an event."""
    whole = structure.appearance.whole
    if event.kind == "snap":
        released = show_value(event.released, "J", 3)
        return f'The {whole} snaps when the drive "{drive.name}" reaches {strength}; the snap releases {released}.'
    if event.kind == "branch":
        return f"The path branches at {strength}; imperfections decide which branch the {whole} takes."
    if event.kind == "goal":
        return f'The goal is reached when the drive "{drive.name}" is {strength}.'
    return f"The path could not be followed beyond {strength}."


def lengths_along(positions: Array) -> Array:
    """Return the distance of each point of a path from its start in the space of all positions, m, (point,)."""
    steps = np.linalg.norm(np.diff(positions, axis=0).reshape(len(positions) - 1, -1), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def interval_errors(positions: Array) -> Array:
    """Estimate the largest distance of a place from its linear interpolation in each interval of a path, m.

    The distance is length^2 / 8 times the curvature of the path, from the differences at both ends of the interval. A
    path of one interval would deviate at most by the distance that it moves.

    Args:
        positions: m, (point, place, 3).

    Returns:
        Errors, (interval,).
    """
    moved = np.diff(positions, axis=0)
    if len(moved) < 2:
        return np.asarray(np.linalg.norm(moved, axis=2).max(axis=1))
    steps = np.maximum(np.diff(lengths_along(positions)), 1e-300)
    rates = moved / steps[:, None, None]
    curvature = 2 * np.linalg.norm(np.diff(rates, axis=0), axis=2).max(axis=1) / (steps[1:] + steps[:-1])
    at_ends = np.concatenate([curvature[:1], curvature, curvature[-1:]])
    return np.asarray(steps**2 / 8 * np.maximum(at_ends[1:], at_ends[:-1]))
