"""Quasi-static path of a structure: the shapes through which a slowly growing drive takes it, of trees and of nets."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Literal

import numpy as np

from forficula.arrays import Array, Flags
from forficula.errors import InputError
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.crease_memory import acting_moment, remaining_share
from forficula.material.law.crease_turn import relaxed
from forficula.results import pandas_module
from forficula.statics.friction import friction_range
from forficula.statics.path_dependence import path_dependence
from forficula.structure import Drive, Structure, crease_law, drive_unit, springs_name
from forficula.structure.membrane_stress import principal_strains

if TYPE_CHECKING:
    from forficula.results import DataFrame

EventKind = Literal["snap", "branch", "contact", "goal", "lost"]


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
        contacts: force between every pair of parts that touch, N, by the names of both.
        memory: of all hinges in their own senses, see `crease_memory`, (slot, hinge); None if no hinge remembers
            anything.
    """

    strength: float
    resting: bool
    angles: Array
    positions: Array
    coordinates: Array
    energy: Mapping[str, float]
    force: float = 0.0
    contacts: Mapping[str, float] = field(default_factory=dict)
    memory: Array | None = None

    @property
    def sets(self) -> Array | None:
        """Return the permanent folds of all hinges in their own senses, rad, (hinge,); None without memory."""
        return None if self.memory is None else self.memory[0]


@dataclass(frozen=True, kw_only=True)
class PathMark:
    """Event on a quasi-static path.

    Attributes:
        kind: "snap", a jump at a constant drive; "branch", where the path turns into one of several possible paths;
            "contact", where parts touch for the first time; "goal", where the goal of the transition is reached;
            "lost", where the path could not be followed further.
        share: position on the path.
        end: position at which a snap ends; equal to `share` for other events.
        strength: of the drive, in its SI unit, with the sign of the drive.
        released: energy that a snap releases, J; 0 for other events.
        text: a sentence on the event.
    """

    kind: EventKind
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
        memory: of all hinges in their own senses, see `crease_memory`, (slot, point, hinge). Maxwell branches are
            relaxed, because the path is infinitely slow.
        losses: energies that creases have dissipated since the beginning of the path, J, (point,): by permanent folds
            ("crease yielding") and by wear ("crease damage"), without those that no crease can dissipate.
        contacts: force between every pair of parts that touch anywhere on the path, N, (point,), by the names of both
            parts; 0 where they are apart. Statics ignores friction.
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
    memory: Array
    losses: Mapping[str, Array]
    length: float
    marks: tuple[PathMark, ...]
    reached: bool
    complete: bool
    error: float
    at: float | None = None
    remarks: tuple[str, ...] = ()
    contacts: Mapping[str, Array] = field(default_factory=dict)

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
    def friction(self) -> Array:
        """Return by how much dry friction of hinges widens the strength of the drive to both sides, (point,).

        While the drive grows, the structure needs this much more, and while it falls, this much less: see
        `forficula.statics.friction.friction_range`.
        """
        return friction_range(self.structure, self.drive, self.angles, self.positions, self.resting)

    @cached_property
    def moments(self) -> Array:
        """Return the moments of the springs of all hinges and creases, N m, (point, hinge).

        A moment is the derivative of the energy of the spring by the hinge's angle in its own sense, positive if the
        spring reduces the angle. A drive that changes rest angles changes the moments accordingly.
        """
        further = self.strength[:, None] * rest_changes(self.structure, self.drive)
        return spring_moments(self.structure, self.angles, further, self.memory)

    @property
    def sets(self) -> Array:
        """Return the permanent folds of creases that yield, rad, (point, hinge); 0 for others."""
        return np.asarray(self.memory[0])

    @cached_property
    def remaining(self) -> Array:
        """Return the share of the moments of all hinges that wear has left, (point, hinge)."""
        left = remaining_share(slow_law(self.structure), self.memory)
        return np.broadcast_to(left, self.angles.shape)

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
        """Return a pandas table of every point: share, drive and its friction, energies, losses, contacts and rest."""
        pandas = pandas_module()
        unit = self.unit.replace(" ", "_")
        columns: dict[str, object] = {"share": self.share, f"drive_{unit}": self.strength}
        columns |= {f"{part.replace(' ', '_')}_J": values for part, values in self.energy.items()}
        columns |= {f"{part.replace(' ', '_')}_J": values for part, values in self.losses.items()}
        columns |= {f"contact_{parts.replace(' ', '_')}_N": forces for parts, forces in self.contacts.items()}
        if self.friction.any():
            columns[f"friction_{unit}"] = self.friction
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
            contacts={parts: float(between(forces)) for parts, forces in self.contacts.items()},
            memory=np.array([between(slot) for slot in self.memory]) if path_dependence(self.structure) else None,
        )

    def _lengths(self, pairs: Sequence[tuple[int, int]]) -> Array:
        one, other = np.array(pairs).T
        return np.asarray(np.linalg.norm(self.positions[:, other] - self.positions[:, one], axis=2))

    def _membrane_strains(self) -> Array:
        first, result = len(self.structure.points), list[Array]()
        for membrane in self.structure.membranes:
            corners = self.positions[:, first + membrane.triangles]
            result.append(principal_strains(membrane.built[membrane.triangles], corners)[..., -1])
            first += len(membrane.built)
        return np.concatenate(result, axis=1)


def rest_changes(structure: Structure, drive: Drive) -> Array:
    """Return the changes of the rest angles of all hinges, in their own senses, per strength of a drive, (hinge,)."""
    changes = np.zeros(len(structure.hinges))
    for motor, share in zip(structure.motors, drive.shares, strict=True):
        if motor.kind == "rest-angle":
            hinges = list(motor.hinges)
            np.add.at(changes, hinges, share * (np.array(motor.gains) if motor.gains else np.ones(len(hinges))))
    return changes


def slow_law(structure: Structure) -> CreaseLaw:
    """Return the law of all hinges in their own senses, (hinge,), in infinitely slow motions."""
    return relaxed(crease_law(structure, np.arange(len(structure.hinges)), rigid_stops=True))


def spring_moments(
    structure: Structure, angles: Array, further: Array | float = 0.0, memory: Array | None = None
) -> Array:
    """Return the moments of the springs of all hinges, N m, (..., hinge).

    Args:
        structure: the structure.
        angles: of all hinges in their own senses, rad, (..., hinge).
        further: changes of the rest angles, rad.
        memory: of the hinges, (slot, ..., hinge); None for new hinges.
    """
    law = slow_law(structure)
    memory = np.zeros((law.slots, *angles.shape)) if memory is None else memory
    creases = np.array([hinge.flaps is not None for hinge in structure.hinges], dtype=np.bool_)
    alone = remaining_share(law, memory) * law.rest_moment(angles, further, law.rest_shift(memory[0]))
    # the stops of joints bound their angles and have no stiffness
    return np.where(creases, acting_moment(law, angles, further, memory)[0], alone)
