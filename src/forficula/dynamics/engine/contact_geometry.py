"""Parts of a structure that touch, with the bodies that carry them, and the checks of starts and of overlaps."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import mujoco
import numpy as np

from forficula.arrays import Array, Indices
from forficula.design.section import SMALL_LENGTH
from forficula.dynamics.engine.placement import Placement, Pose, placement_of
from forficula.errors import InputError
from forficula.quantities import show_quantity, show_value
from forficula.structure import Contact
from forficula.structure.contact.distances import row_cross
from forficula.structure.contact.pairs import near_pairs, parts_that_cross
from forficula.structure.contact.touching_parts import TouchingParts, touching_parts

if TYPE_CHECKING:
    from forficula.dynamics.engine.model import Model

# tolerance of a thickness, because numbers are shown with four digits
_ROUNDING = 1e-3
# distance, as a share of the thickness and of the mean length of sides, within which pairs are listed
_SKINS = (2.0, 0.1)
# [chosen] largest overlap as a share of the thickness: beyond it, parts may have passed through each other
_LARGEST_OVERLAP = 0.5
# share of the thickness that counts as a slight overlap
SLIGHT_OVERLAP = 0.1


@dataclass(frozen=True, kw_only=True, eq=False)
class ContactGeometry:
    """The parts of a structure that touch, and the bodies that carry their nodes, in the model's units.

    Attributes:
        parts: of the structure.
        contact: its contact.
        placement: of its bodies.
        carriers: number of the body of each node, (node,); the number of bodies for the ground.
        places: positions of the nodes in the axes of their bodies, (node, 3).
        mobilities: largest acceleration of each node per force on it, as built, (node,).
        levers: largest distance of a node from the axis of each joint in any shape, (joint,).
        skin: distance within which pairs are listed.
        timestep: of the model.
        engine: the compiled model.
        explicit: whether forces are those in the middle of a step; else they are those at its start.
    """

    parts: TouchingParts
    contact: Contact
    placement: Placement
    carriers: Indices
    places: Array
    mobilities: Array
    levers: Array
    skin: float
    timestep: float
    engine: mujoco.MjModel
    explicit: bool

    def nodes(self, position: Array) -> tuple[Pose, Array, Array]:
        """Return the pose of the bodies, and positions and arms of the nodes, (node, 3), for one position."""
        pose = self.placement.poses(position)
        frames = np.concatenate([pose.frames, np.eye(3)[None]])
        arms = (frames[self.carriers] @ self.places[..., None])[..., 0]
        return pose, np.concatenate([pose.origins, np.zeros((1, 3))])[self.carriers] + arms, arms

    def velocities(self, pose: Pose, arms: Array, velocity: Array) -> Array:
        """Return the velocities of the nodes, (node, 3)."""
        moves, turns = (
            np.concatenate([values, np.zeros((1, 3))])[self.carriers] for values in self.placement.rates(pose, velocity)
        )
        return moves + row_cross(turns, arms)

    def most_moved(self, shift: Array) -> float:
        """Return an upper bound of the motion of any node for a change of the position, or a velocity, (position,).

        It is infinite if bodies turn freely.
        """
        if len(self.placement.free):
            return np.inf
        slides = self.placement.slides
        slid = float(np.abs(shift[slides[slides >= 0]]).max(initial=0.0)) * math.sqrt(3)
        return slid + float(np.abs(shift[self.placement.hinges]) @ self.levers)

    def loads(self, pose: Pose, arms: Array, forces: Array) -> Array:
        """Return the generalised forces of forces on the nodes, (dof,)."""
        count = len(self.placement.parents) + 1
        pushes, torques = np.zeros((2, count, 3))
        np.add.at(pushes, self.carriers, forces)
        np.add.at(torques, self.carriers, row_cross(arms, forces))
        return self.placement.loads(pose, pushes[:-1], torques[:-1])


def contact_geometry(model: Model) -> ContactGeometry | None:
    """Return the parts of a structure that touch; None if the structure has no such parts, or no contact."""
    structure, contact = model.in_units, model.in_units.contact
    parts = None if contact is None else touching_parts(structure, contact)
    if parts is None or contact is None:
        return None
    placement = placement_of(structure)
    points = [structure.points[point] for point in parts.points.tolist()]
    carriers = np.array([point.body if point.body >= 0 else len(structure.bodies) for point in points], dtype=np.int64)
    geometry = ContactGeometry(
        parts=parts,
        contact=contact,
        placement=placement,
        carriers=carriers,
        places=np.array([point.place for point in points]),
        mobilities=np.zeros(len(points)),
        levers=np.zeros(0),
        skin=0.0,
        timestep=model.timestep,
        engine=model.engine,
        explicit=model.explicit,
    )
    _, places, _ = geometry.nodes(np.array(model.engine.qpos0))
    ends = places[parts.sides]
    length = float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).mean())
    return replace(
        geometry,
        mobilities=_mobilities(geometry),
        levers=_levers(geometry),
        skin=max(_SKINS[0] * contact.thickness, _SKINS[1] * length),
    )


def _levers(geometry: ContactGeometry) -> Array:
    """Return the largest distance of a node from the axis of each joint in any shape, (joint,)."""
    placement = geometry.placement
    radii = np.zeros(len(placement.parents) + 1)
    np.maximum.at(radii, geometry.carriers, np.linalg.norm(geometry.places, axis=1))
    for level in reversed(placement.levels[1:]):
        reach = np.linalg.norm(placement.positions[level], axis=1) + radii[level]
        np.maximum.at(radii, placement.parents[level], reach)
    return radii[placement.hinged]


def check_start(model: Model) -> None:
    """Reject parts that cross or overlap at the start, because contact would push them apart and supply energy.

    Raises:
        InputError: the message names two parts and gives the largest thickness.
    """
    from forficula.dynamics.stepping.start_states import start_position

    geometry = contact_geometry(model)
    if geometry is None:
        return
    parts = geometry.parts
    _, places, _ = geometry.nodes(start_position(model))
    for one, other in parts_that_cross(parts, places):
        raise _crossing_error(parts, one, other)
    pairs = near_pairs(parts, places, 0.0)
    distances = pairs.nearest(places).distances
    overlaps = pairs.thickness - distances
    if not (overlaps > _ROUNDING * pairs.thickness).any():
        return
    worst = int(np.argmax(overlaps))
    one, other = pairs.parts[worst].tolist()
    if distances[worst] < _ROUNDING * pairs.thickness[worst]:
        raise _crossing_error(parts, one, other)
    halves = parts.half[[one, other]]
    thickness = 2 * float(halves[1])
    # if the other part is a bar, which keeps its diameter, the facet alone becomes thinner
    most = thickness - float(overlaps[worst]) * (1 if halves[0] == halves[1] else 2)
    need, got = (show_quantity(model.units.length * size, SMALL_LENGTH) for size in (most, thickness))
    room = f"need <= {need}" if most > 0 else "need parts that are further apart"
    names = f"{parts.names[one]} and {parts.names[other]}"
    raise InputError(f"contact.thickness: {names} are nearer than that at the start: {room}, got {got}")


def _crossing_error(parts: TouchingParts, one: int, other: int) -> InputError:
    """Return the error that two parts cross at the start."""
    return InputError(
        f"protocol.contact: {parts.names[one]} and {parts.names[other]} pass through each other at the start: need a"
        " start without crossings, or false"
    )


def overlap_doubt(contact: Contact, overlap: float) -> str:
    """Return why a run in which parts overlapped by a share of their thickness is unreliable; empty for a small one."""
    if overlap <= _LARGEST_OVERLAP:
        return ""
    now, need = (
        show_value(value, "s") for value in (contact.stops.time_constant, resolving_time_constant(contact, overlap))
    )
    return (
        f"parts that touch overlap by {100 * overlap:.0f} % of their thickness, so that they may have passed through"
        f" each other: need a contact.time_constant shorter than {now}, such as {need}, and a timestep that resolves"
        " it"
    )


def resolving_time_constant(contact: Contact, overlap: float, slight: float = SLIGHT_OVERLAP) -> float:
    """Return the time constant with which an overlap by a share of the thickness becomes a slight one, s.

    The energy of an overlap s is proportional to (-s - ln(1 - s)) / T^2 and at an impact does not depend on the time
    constant T. Overlaps under a constant force decrease more quickly with T. Larger overlaps than half the thickness
    count as this one, because parts may be anywhere beyond: the time constant is then a first trial.
    """

    def size(share: float) -> float:
        return math.sqrt(-share - math.log1p(-share))

    return contact.stops.time_constant * size(slight) / size(min(overlap, _LARGEST_OVERLAP))


def _mobilities(geometry: ContactGeometry) -> Array:
    """Compute the largest acceleration of each node in any direction per force on it, as built, (node,)."""
    engine, placement = geometry.engine, geometry.placement
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    inertia = np.zeros((engine.nv, engine.nv))
    mujoco.mj_fullM(engine, data, inertia)
    if not len(placement.hinged) and not len(placement.free):
        # nodes that slide move independently
        free = np.append(placement.velocities, -1)[placement.slides]
        masses = np.append(np.diag(inertia), np.inf)[free]
        return np.append((1 / masses).max(axis=1), 0.0)[geometry.carriers]
    pose, _, arms = geometry.nodes(np.array(engine.qpos0))
    moves, turns = (
        np.concatenate([values, np.zeros((engine.nv, 1, 3))], axis=1)[:, geometry.carriers]
        for values in placement.rates(pose, np.eye(engine.nv))
    )
    shifts = (moves + row_cross(turns, arms)).transpose(1, 0, 2)
    answers = np.linalg.solve(inertia, shifts.transpose(1, 0, 2).reshape(engine.nv, -1)).reshape(engine.nv, -1, 3)
    return np.linalg.eigvalsh(shifts.transpose(0, 2, 1) @ answers.transpose(1, 0, 2))[:, -1]
