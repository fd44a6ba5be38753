"""Parts of a structure in the engine, by their names."""

from __future__ import annotations

from collections.abc import Sequence

import mujoco
import numpy as np

from forficula.arrays import Indices
from forficula.structure import Structure


def has_turning_bodies(structure: Structure) -> bool:
    """Return whether bodies turn, so that a force on a point of a body needs a site there; nodes only slide."""
    return bool(structure.plates or structure.bars)


def engine_sites(structure: Structure) -> list[int]:
    """Return the numbers of points that need a site: those away from body origins, and ends of tendons."""
    pairs = [spring.points for spring in structure.springs]
    pairs += [*(tendon.points for tendon in structure.tendons), *(limit.points for limit in structure.limits)]
    pairs += [measure.points for measure in structure.measures if measure.points is not None]
    pairs += [pair for closure in structure.closures for pair in closure.points]
    ends = {number for pair in pairs for number in pair}
    ends |= {hold.point for hold in structure.holds}
    if has_turning_bodies(structure):
        ends |= {number for motor in structure.motors for number in motor.points}
    return [number for number, point in enumerate(structure.points) if point.place.any() or number in ends]


def part_indices(engine: mujoco.MjModel, kind: mujoco.mjtObj, names: Sequence[str]) -> Indices:
    """Return the ids of parts by their names."""
    return np.array([mujoco.mj_name2id(engine, kind, name) for name in names], dtype=np.int64)


def sites_of(engine: mujoco.MjModel, structure: Structure) -> Indices:
    """Return the site of every point, (point,), -1 for points without a site."""
    sites = np.full(len(structure.points), -1, dtype=np.int64)
    for number in engine_sites(structure):
        sites[number] = part_indices(engine, mujoco.mjtObj.mjOBJ_SITE, [structure.points[number].name])[0]
    return sites


def carriers_of(engine: mujoco.MjModel, structure: Structure) -> Indices:
    """Return the body that carries every point, (point,); 0 is the ground."""
    bodies = part_indices(engine, mujoco.mjtObj.mjOBJ_BODY, [body.name for body in structure.bodies])
    return np.array([0 if point.body < 0 else bodies[point.body] for point in structure.points], dtype=np.int64)


def hinge_creep(engine: mujoco.MjModel, structure: Structure) -> Indices:
    """Return the place of each joint's rest angle among the plastic states, (hinge,); -1 for one that never yields."""
    joints = [mujoco.mj_name2id(engine, mujoco.mjtObj.mjOBJ_JOINT, hinge.name) for hinge in structure.hinges]
    return np.array([-1 if joint < 0 else engine.jnt_plasticadr[joint] for joint in joints], dtype=np.int64)
