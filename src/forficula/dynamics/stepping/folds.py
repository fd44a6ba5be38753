"""Angles of hinges, which are joints or creases, from the engine's positions."""

from __future__ import annotations

from dataclasses import dataclass, replace

import mujoco
import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.placement import Placement, Pose, placement_of
from forficula.dynamics.engine.plate_angles import PlateAngles, plate_angles
from forficula.pattern.geometry import cross, dot
from forficula.structure import Structure, built_points, crease_flaps, crease_numbers, flap_angles


@dataclass(frozen=True, kw_only=True)
class Folds:
    """Mapping from the engine's positions to the angles of hinges.

    Attributes:
        senses: +1 or -1 by hinge, (hinge,).
        joints: index of each hinge in the engine's positions, (hinge,); -1 for a crease.
        speeds: index of each hinge in the engine's velocities, (hinge,); -1 for a crease.
        creases: numbers of the hinges that are creases, (crease,).
        flaps: nodes at the corners of their flaps, (crease, 6).
        built: these nodes in the built shape, in the model's units, (node, 3).
        slides: index of each node's coordinates in the engine's positions, (node, 3); -1 for held ones.
        placement: of the bodies that carry the nodes; None if none of them turns.
        carriers: number of the body of each node, (node,).
        places: positions of the nodes in the axes of their bodies, in the model's units, (node, 3).
    """

    senses: Indices
    joints: Indices
    speeds: Indices
    creases: Indices
    flaps: Indices
    built: Array
    slides: Indices
    placement: Placement | None
    carriers: Indices
    places: Array

    def some(self, hinges: Indices) -> Folds:
        """Select hinges by number."""
        joints = self.joints[hinges]
        which = np.flatnonzero(joints < 0)
        return replace(
            self,
            senses=self.senses[hinges],
            joints=joints,
            speeds=self.speeds[hinges],
            creases=which,
            flaps=self.flaps[np.searchsorted(self.creases, hinges[which])],
        )

    def angles(self, positions: Array) -> Array:
        """Compute angles of all hinges in their own senses, rad, (..., hinge), from positions, (..., position)."""
        if not len(self.creases):
            return np.asarray(self.senses * positions[..., self.joints])
        angles = np.zeros((*positions.shape[:-1], len(self.senses)))
        turned = self.joints >= 0
        angles[..., turned] = (self.senses * positions[..., self.joints])[..., turned]
        with np.errstate(over="ignore", invalid="ignore"):  # diverging structures
            angles[..., self.creases] = self.senses[self.creases] * flap_angles(self.corners(positions))
        return angles

    def travel(self, positions: Array, shifts: Array) -> Array:
        """Compute the turns of all hinges in their own senses for small shifts of the positions, rad, (..., hinge).

        Args:
            positions: start of the shifts, (..., position).
            shifts: in the coordinates of velocities, (..., dof).
        """
        if not len(self.creases):
            return np.asarray(self.senses * shifts[..., self.speeds])
        turned = np.zeros((*shifts.shape[:-1], len(self.senses)))
        joints = self.joints >= 0
        turned[..., joints] = (self.senses * shifts[..., self.speeds])[..., joints]
        with np.errstate(over="ignore", divide="ignore", invalid="ignore"):  # diverging structures
            if self.placement is None:
                turns = flap_turns(self.corners(positions), self._shifted(shifts)[..., self.flaps, :])
            else:
                turns = self.turns(positions, shifts)[1]
            turned[..., self.creases] = self.senses[self.creases] * turns
        return turned

    def corners(self, positions: Array) -> Array:
        """Return the positions of the corners of all flaps, in the model's units, (..., crease, 6, 3)."""
        if self.placement is None:
            return np.asarray((self.built + self._shifted(positions))[..., self.flaps, :])
        return self._corner_positions(self.placement.poses(positions))

    def turns(self, positions: Array, shifts: Array) -> tuple[PlateAngles, Array]:
        """Return angles between plates with their derivatives, and changes by small shifts, rad, (..., crease)."""
        assert self.placement is not None
        pose = self.placement.poses(positions)
        angles = plate_angles(self._corner_positions(pose))
        _, turned = self.placement.rates(pose, shifts)
        left, right = (turned[..., self.carriers[self.flaps[:, place]], :] for place in (0, 3))
        return angles, dot(angles.turning, np.moveaxis(right - left, -1, 0))

    def _corner_positions(self, pose: Pose) -> Array:
        """Return the positions of the corners of all flaps for some poses of the bodies, (..., crease, 6, 3)."""
        arms = (pose.frames[..., self.carriers, :, :] @ self.places[..., None])[..., 0]
        return np.asarray((pose.origins[..., self.carriers, :] + arms)[..., self.flaps, :])

    def _shifted(self, positions: Array) -> Array:
        """Return the shifts of the nodes, (..., node, 3)."""
        held = np.concatenate([positions, np.zeros((*positions.shape[:-1], 1))], axis=-1)
        return np.asarray(held[..., self.slides])


def start_of(engine: mujoco.MjModel, structure: Structure, folds: Folds) -> Array:
    """Return the engine's positions at the start; bodies that slide start in the built shape."""
    position = np.array(engine.qpos0)
    for hinge, place in zip(structure.hinges, folds.joints.tolist(), strict=True):
        if place >= 0:
            position[place] = hinge.sense * hinge.start + 0.0  # -0 would be another bit
    return position


def folds_of(engine: mujoco.MjModel, structure: Structure) -> Folds:
    """Find the hinges of a structure in the model's units, and the nodes of its creases, in the compiled model."""
    hinges = structure.hinges
    joints = [-1 if hinge.flaps else joint_address(engine, hinge.name) for hinge in hinges]
    speeds = [-1 if hinge.flaps else joint_address(engine, hinge.name, "dofadr") for hinge in hinges]
    points, flaps = np.unique(crease_flaps(structure), return_inverse=True)
    slides = np.full((len(points), 3), -1, dtype=np.int64)
    for node, point in enumerate(points.tolist()):
        body = structure.bodies[structure.points[point].body]
        for axis in () if body.turns else body.slides:
            slides[node, axis] = joint_address(engine, slide_name(body.name, axis))
    return Folds(
        senses=np.array([hinge.sense for hinge in hinges], dtype=np.int64),
        joints=np.array(joints, dtype=np.int64),
        speeds=np.array(speeds, dtype=np.int64),
        creases=crease_numbers(structure),
        flaps=flaps.reshape(-1, 6).astype(np.int64),
        built=built_points(structure)[points],
        slides=slides,
        placement=placement_of(structure) if structure.plates and len(flaps) else None,
        carriers=np.array([structure.points[point].body for point in points.tolist()], dtype=np.int64),
        places=np.array([structure.points[point].place for point in points.tolist()]).reshape(-1, 3),
    )


def slide_name(body: str, axis: int) -> str:
    """Return the engine's name of the slide of a body along an axis, 0 to 2."""
    return f"{body}_{'xyz'[axis]}"


def joint_address(engine: mujoco.MjModel, joint: str, of: str = "qposadr") -> int:
    """Return the index of a joint in the engine's positions, or in its velocities."""
    return int(getattr(engine, f"jnt_{of}")[mujoco.mj_name2id(engine, mujoco.mjtObj.mjOBJ_JOINT, joint)])


def flap_turns(corners: Array, shifts: Array) -> Array:
    """Compute the changes of the angles between flaps for small shifts of their corners, rad, (...).

    The outer corner of a flap turns it by its shift along the flap's normal divided by its height. The ends of the side
    contribute with the shares in which the foot of the corner divides the side (Bridson, Marino and Fedkiw 2003,
    section 4).

    Args:
        corners: as for `flap_angles`, (..., 6, 3).
        shifts: of the corners, (..., 6, 3).
    """
    # coordinates first: several times as fast as along the last axis
    places, moves = (np.moveaxis(vectors, (-2, -1), (0, 1)) for vectors in (corners, shifts))
    turned: Array | float = 0.0
    for first, side in ((0, 1.0), (3, -1.0)):
        (tail, head, corner), (at_tail, at_head, at_corner) = (
            vectors[first : first + 3] for vectors in (places, moves)
        )
        along, away = head - tail, corner - tail
        normal = side * cross(along, away)
        square = dot(along, along)
        share = dot(away, along) / square
        moved = at_corner - at_tail - share * (at_head - at_tail)
        turned = turned + np.sqrt(square) / dot(normal, normal) * dot(normal, moved)
    return np.asarray(turned)
