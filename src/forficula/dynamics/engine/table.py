"""The table in the engine: a plane, and spheres of the structure that touch nothing else."""

from __future__ import annotations

import mujoco
import numpy as np

from forficula.dynamics.stepping.folds import Folds, start_of
from forficula.structure import Structure, refuse_below_table, touching_points

# bit by which MuJoCo selects pairs of the table and a sphere; other contacts have lower bits
_TABLE = 8
_NAME = "table"
# radius of a sphere of a part without a thickness, as a share of the structure's size: the engine needs some
_POINT = 1e-6
# length over which a contact hardens, as a share of the structure's size; the other numbers are MuJoCo's defaults
_SOFT = 1e-5


def add_table(spec: mujoco.MjSpec, structure: Structure) -> None:
    """Add the table of a structure in a model's units, and the spheres that touch it, after all bodies."""
    table = structure.table
    if table is None:
        return
    up = -np.array(structure.down)
    plane = spec.worldbody.add_geom(name=_NAME, type=mujoco.mjtGeom.mjGEOM_PLANE, size=[structure.span] * 3)
    plane.pos = table.height * up
    mujoco.mju_quatZ2Vec(plane.quat, up)
    plane.contype, plane.conaffinity = 0, _TABLE
    # the numbers of the plane apply to all of its contacts
    plane.priority = 1
    plane.condim = 3 if table.friction else 1
    plane.friction = [table.friction, 0, 0]
    plane.solref[:2] = [table.stops.time_constant, table.stops.damping_ratio]
    plane.solimp = [0.9, 0.95, _SOFT * structure.span, 0.5, 2]
    for point in touching_points(structure):
        sphere = spec.body(structure.bodies[point.body].name).add_geom(
            type=mujoco.mjtGeom.mjGEOM_SPHERE, pos=point.place, mass=0
        )
        sphere.size[0] = max(point.radius, _POINT * structure.span)
        sphere.contype, sphere.conaffinity = _TABLE, 0


def check_above_table(engine: mujoco.MjModel, structure: Structure, folds: Folds, unit: float) -> None:
    """Refuse a structure that starts below its table.

    Args:
        engine: the compiled model.
        structure: its structure, in the model's units.
        folds: of the model.
        unit: of length, m.

    Raises:
        InputError: a part is below the table; the message gives the largest height.
    """
    if structure.table is None:
        return
    data = mujoco.MjData(engine)
    data.qpos[:] = start_of(engine, structure, folds)
    mujoco.mj_kinematics(engine, data)
    spheres = engine.geom_contype == _TABLE
    heights = data.geom_xpos[spheres] @ -np.array(structure.down) - engine.geom_size[spheres, 0]
    refuse_below_table(structure, float(heights.min(initial=np.inf)), unit)
