"""Quasi-static path of a structure while it is computed, and from its points and events."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.quantities import show_value
from forficula.statics.quasi_static_path import EventKind, PathMark, QuasiStaticPath, QuasiStaticPoint
from forficula.structure import Drive, Structure, drive_unit

_STILL = 1e-12  # of the length of a path: displacement between two equal shapes
_NAMED = 4  # pairs of touching parts that a sentence names
_MORE = 1.25  # ratio of the numbers of points from one display of a growing path to the next


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
        parts: pairs of parts that touch for the first time, each by the names of both.
    """

    kind: EventKind
    first: int
    last: int
    strength: float
    released: float = 0.0
    parts: tuple[str, ...] = ()


def contact_events(points: Sequence[QuasiStaticPoint]) -> list[NumberedEvent]:
    """Return the points of a path at which parts touch for the first time."""
    known, events = set[str](), list[NumberedEvent]()
    for number, point in enumerate(points):
        parts = tuple(name for name, force in point.contacts.items() if force > 0 and name not in known)
        if parts and point.resting:
            known.update(parts)
            events.append(
                NumberedEvent(kind="contact", first=number, last=number, strength=point.strength, parts=parts)
            )
    return events


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
    # root of the mean over places
    length = lengths_along(positions) / math.sqrt(positions.shape[1])
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
    path = QuasiStaticPath(
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
        sets=np.array([np.zeros_like(point.angles) if point.sets is None else point.sets for point in points]),
        length=float(length[-1]),
        marks=tuple(sorted(marks, key=lambda mark: mark.share)),
        reached=reached,
        complete=complete,
        error=error,
        at=None if at is None else float(share[at]),
        remarks=remarks,
        contacts={
            name: np.array([point.contacts.get(name, 0.0) for point in points])
            for name in sorted({name for point in points for name in point.contacts})
        },
    )
    if not path.friction.any():
        return path
    most = show_value(float(np.nanmax(path.friction, initial=0.0)), unit)
    remark = (
        f'the path is that without dry friction, which increases the drive "{drive.name}" by up to {most} while it'
        " grows and reduces it by the same amount while it falls"
    )
    return replace(path, remarks=(*remarks, remark))


def _sentence(structure: Structure, drive: Drive, event: NumberedEvent, strength: str) -> str:
    """Return a sentence on an event."""
    whole = structure.appearance.whole
    if event.kind == "snap":
        released = show_value(event.released, "J", 3)
        return f'The {whole} snaps when the drive "{drive.name}" reaches {strength}; the snap releases {released}.'
    if event.kind == "branch":
        return f"The path branches at {strength}; imperfections decide which branch the {whole} takes."
    if event.kind == "contact":
        named = ", ".join(event.parts[:_NAMED])
        more = f" and {len(event.parts) - _NAMED} further pairs" if len(event.parts) > _NAMED else ""
        pairs = f"{named[:1].upper()}{named[1:]}{more}"
        if not event.first:
            return f"{pairs} touch at the start."
        return f'{pairs} begin to touch when the drive "{drive.name}" is {strength}.'
    if event.kind == "goal":
        return f'The goal is reached when the drive "{drive.name}" is {strength}.'
    return f"The path could not be followed beyond {strength}."


def nearest_point(points: Sequence[QuasiStaticPoint], positions: Array) -> int:
    """Return the number of the point whose shape is nearest to positions of places, m, (place, 3)."""
    return int(np.argmin([np.abs(point.positions - positions).max() for point in points]))


def lengths_along(positions: Array) -> Array:
    """Return the distance of each point of a path from its start in the space of all positions, m, (point,)."""
    steps = np.linalg.norm(np.diff(positions, axis=0), axis=(1, 2))
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
    along = lengths_along(positions)
    # shapes that a contact or a stop blocks are equal
    steps = np.maximum(np.diff(along), max(_STILL * along[-1], 1e-300))
    rates = moved / steps[:, None, None]
    curvature = 2 * np.linalg.norm(np.diff(rates, axis=0), axis=2).max(axis=1) / (steps[1:] + steps[:-1])
    at_ends = np.concatenate([curvature[:1], curvature, curvature[-1:]])
    return np.asarray(steps**2 / 8 * np.maximum(at_ends[1:], at_ends[:-1]))
