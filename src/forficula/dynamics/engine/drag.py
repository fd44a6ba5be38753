"""Drag of the medium on the panels of many structures, as generalised forces on the engine's velocities."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import mujoco
import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.parts import part_indices
from forficula.pattern.geometry import cross, dot
from forficula.structure import Structure, gathered_mass

# of a thin plate normal to a flow at Reynolds numbers above 1000: 1.98 for a long strip, 1.17 for a disc (Hoerner 1965,
# Fluid-Dynamic Drag, chapter 3)
DRAG_COEFFICIENT = 2.0
# steps over which the forces are constant: with 1 and with 10 the reference wing in air has the same times, and drag
# dissipates 1 % more or less
CONSTANT_STEPS = 5
# fields of the engine from which the drag is computed
KINEMATICS = ("xpos", "xmat", "subtree_com", "cdof")
# quadrature of a triangle, exact to the fourth power: barycentric coordinates of two groups of three points, and their
# weights (Strang and Fix 1973, table 4.1)
_GROUPS = ((0.816847572980459, 0.109951743655322), (0.108103018168070, 0.223381589678011))
_POINTS = np.array([np.roll([far, (1 - far) / 2, (1 - far) / 2], turn) for far, _ in _GROUPS for turn in range(3)])
_WEIGHTS = np.repeat([weight for _, weight in _GROUPS], 3)


@dataclass(frozen=True, kw_only=True)
class Drag:
    """Panels of one structure, in the model's units, or of several of one topology, with arrays (structure, ...).

    Forces are computed outside the engine and are constant over a few steps: exact at the first step, and of first
    order in the timestep. Their work is that on the engine's velocities, up to rounding. (The engine's own drag acts
    against the speed in any direction, so it would dissipate 1.35 times as much while the reference wing folds, and 1.8
    times as much while it opens.)

    Attributes:
        bodies: numbers of the engine's bodies that carry corners, (body,).
        roots: numbers of the root bodies of their trees, (body,).
        moved: 1 if a coordinate moves a body, else 0, (body, dof).
        carriers: index in `bodies` of the body of each corner of triangles, (triangle, 3).
        carried: 1 if a body carries a corner, else 0, (body, 3 triangles).
        places: positions of the corners in the axes of their bodies, (..., triangle, 3, 3).
        quadratic: pressure per squared speed along the normal, (...).
        linear: pressure per speed along the normal, (..., triangle).
    """

    bodies: Indices
    roots: Indices
    moved: Array
    carriers: Indices
    carried: Array
    places: Array
    quadratic: Array
    linear: Array

    def forces(self, which: Indices, kinematics: Mapping[str, Array], velocities: Array) -> Array:
        """Compute the generalised forces of the drag on structures of `stacked_drag`, (structure, dof).

        Args:
            which: indices of the structures.
            kinematics: the engine's fields `KINEMATICS`, (structure, ...).
            velocities: of the engine, (structure, dof).
        """
        on = self.carriers
        frames = kinematics["xmat"][:, self.bodies].reshape(len(which), -1, 3, 3)
        arms = (frames[:, on] @ self.places[which][..., None])[..., 0]
        corners = kinematics["xpos"][:, self.bodies][:, on] + arms
        # the engine's twists of a tree are about its centre of mass
        away = np.moveaxis(corners - kinematics["subtree_com"][:, self.roots][:, on], -1, 0)
        twists = (self.moved * velocities[:, None]) @ kinematics["cdof"]
        turns, moves = np.moveaxis(twists[:, on], -1, 0).reshape(2, *away.shape)
        one, two, three = np.moveaxis(corners, (2, 3), (0, 1))
        area = cross(two - one, three - one) / 2
        size = np.sqrt(dot(area, area))
        # a panel that is crushed to a line has no normal and no area
        normal = area / np.where(size > 0, size, 1.0)
        across = dot(moves + cross(turns, away), normal[..., None]) @ _POINTS.T
        pressure = (self.quadratic[which, None, None] * np.abs(across) + self.linear[which, :, None]) * across
        pushes = -(pressure * _WEIGHTS @ _POINTS) * area[..., None]
        wrenches = np.concatenate([cross(away, pushes), pushes]).reshape(6, len(which), -1)
        by_body = self.carried @ np.moveaxis(wrenches, 0, -1)
        return np.asarray(np.sum(self.moved.T @ by_body * kinematics["cdof"], axis=-1))


def drag_of(engine: mujoco.MjModel, structure: Structure) -> Drag | None:
    """Return the drag on a structure, in the model's units, for the compiled model; None without a medium."""
    medium = structure.medium
    if medium is None:
        return None
    numbers, carriers = np.unique(medium.carriers, return_inverse=True)
    names = [structure.bodies[number].name for number in numbers.tolist()]
    bodies = part_indices(engine, mujoco.mjtObj.mjOBJ_BODY, names)
    moved = np.zeros((len(bodies), engine.nv))
    # numbers increase from the ground, 0, outwards
    chains = [bodies.tolist()]
    while any(chains[-1]):
        chains.append(engine.body_parentid[chains[-1]].tolist())
    for chain in chains:
        for row, body in enumerate(chain):
            moved[row, engine.body_dofadr[body] :][: engine.body_dofnum[body]] = 1.0
    return Drag(
        bodies=bodies,
        roots=np.asarray(engine.body_rootid[bodies], dtype=np.int64),
        moved=moved,
        carriers=carriers.reshape(-1, 3).astype(np.int64),
        carried=(carriers.ravel() == np.arange(len(bodies))[:, None]).astype(np.float64),
        places=medium.places,
        quadratic=np.array(DRAG_COEFFICIENT / 2 * medium.density),
        linear=32 / math.pi * medium.viscosity / medium.widths,
    )


def stacked_drag(drags: Sequence[Drag]) -> Drag:
    """Combine the drags of structures of one topology into one object."""
    return replace(
        drags[0],
        places=np.array([drag.places for drag in drags]),
        quadratic=np.array([drag.quadratic for drag in drags]),
        linear=np.array([drag.linear for drag in drags]),
    )


def add_medium(spec: mujoco.MjSpec, structure: Structure) -> None:
    """Add the added mass of the medium to bodies, in the model's units: inertia without weight."""
    masses = structure.medium.masses if structure.medium is not None else ()
    for number in sorted({mass.body for mass in masses}):
        body = spec.body(structure.bodies[number].name)
        mass, centre, inertia = gathered_mass([entry for entry in masses if entry.body == number])
        if structure.bodies[number].slides and not structure.bodies[number].turns:
            # a body that never turns has its mass at one point
            body.mass += mass
            body.inertia = [body.mass] * 3
            body.gravcomp = mass / body.mass
            continue
        added = body.add_body(name=f"{body.name}_medium", gravcomp=1.0)
        added.explicitinertial, added.mass, added.ipos = True, mass, centre
        moments, axes = np.linalg.eigh(inertia)
        # rounding may violate the engine's conditions for masses in a plane or on a line
        moments = np.maximum(moments, 0.0)
        added.inertia = [*moments[:2], min(moments[2], moments[0] + moments[1])]
        frame = np.zeros(4)
        mujoco.mju_mat2Quat(frame, (axes * np.linalg.det(axes)).ravel())
        added.iquat = frame
