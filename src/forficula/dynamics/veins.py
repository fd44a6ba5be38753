"""Veins: a proximal and a distal bar each, their hinges and their motors."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np
from numpy.typing import NDArray

from forficula.design import Design
from forficula.pattern import EarwigFan, hub_points, ring_vertices, tips

Point = NDArray[np.float64]

# bits by which MuJoCo selects who touches whom
_PROXIMAL, _DISTAL = 1, 2
# MuJoCo hardens a contact over 0.001 of its length unit, which would be another share of every wing; the other numbers
# are its defaults.
_SOFT_SHARE = 0.02


@dataclass(frozen=True, kw_only=True)
class Vein:
    """Where a vein lies in the flat wing, in model units, and which way it folds.

    Attributes:
        hub_point: its proximal joint, (3,).
        ring_vertex: its distal hinge, (3,).
        tip: its outer end, (3,).
        ring_direction: unit vector of the distal hinge's axis, (3,).
        sense: +1 or -1: the sign of the turn that folds it about its own axis and about the ring crease.
        fixed_base: whether the proximal bar is part of the ground.
    """

    hub_point: Point
    ring_vertex: Point
    tip: Point
    ring_direction: Point
    sense: int
    fixed_base: bool = False

    @cached_property
    def frame(self) -> NDArray[np.float64]:
        """Rotation from the bar's axes (x along the proximal bar, z across the wing) to the wing's, (3, 3)."""
        along = (self.ring_vertex - self.hub_point) / np.linalg.norm(self.ring_vertex - self.hub_point)
        across = np.array([0.0, 0.0, 1.0])
        return np.column_stack([along, np.cross(across, along), across])

    def on_proximal_bar(self, point: Point) -> Point:
        """A point of the flat wing in the axes of the proximal bar, (3,)."""
        return np.asarray(self.frame.T @ (point - self.hub_point))

    def on_distal_bar(self, point: Point) -> Point:
        """A point of the flat wing in the axes of the distal bar, which are those of the proximal one, (3,)."""
        return np.asarray(self.frame.T @ (point - self.ring_vertex))


def fan_veins(fan: EarwigFan) -> tuple[Vein, ...]:
    """The veins of a fan; every distal hinge lies along the ring crease to the next vein.

    A turn of a vein by its sense folds it as a crease, with the panel that hangs on it rising where the sense is -1.
    """
    ring = ring_vertices(fan, continued=True)
    creases = np.diff(ring, axis=0)
    return tuple(
        Vein(
            hub_point=hub,
            ring_vertex=vertex,
            tip=tip,
            ring_direction=crease / np.linalg.norm(crease),
            # odd veins are valleys, as `earwig_pattern` has them
            sense=(-1) ** (index + 1),
        )
        for index, (hub, vertex, tip, crease) in enumerate(
            zip(hub_points(fan), ring[:-1], tips(fan), creases, strict=True)
        )
    )


def add_vein(spec: mujoco.MjSpec, index: int, vein: Vein, design: Design) -> None:
    """Add a vein's bodies, bars, hinges, attachment sites and motors to a model in the design's units."""
    frame = np.zeros(4)
    mujoco.mju_mat2Quat(frame, vein.frame.ravel())
    proximal = spec.worldbody.add_body(name=f"proximal{index}", pos=vein.hub_point, quat=frame)
    ring_vertex = vein.on_proximal_bar(vein.ring_vertex)
    distal = proximal.add_body(name=f"distal{index}", pos=ring_vertex)
    tip = vein.on_distal_bar(vein.tip)
    # Proximal bars do not touch each other: the veins of a fan overlap near the hub even where it lies flat.
    _add_bar(proximal, ring_vertex, design, kind=_PROXIMAL, touches=_DISTAL)
    _add_bar(distal, tip, design, kind=_DISTAL, touches=_PROXIMAL | _DISTAL)

    tendon = design.tendon
    towards_hub = -ring_vertex / np.linalg.norm(ring_vertex)
    proximal.add_site(name=f"proximal_attachment{index}", pos=ring_vertex + tendon.proximal_attachment * towards_hub)
    distal.add_site(name=f"distal_attachment{index}", pos=tendon.distal_attachment * tip / np.linalg.norm(tip))
    distal.add_site(name=f"tip{index}", pos=tip)

    hinge = design.hinge
    if not vein.fixed_base:
        # in this order, sweep and lift aim the vein and turn is about its own axis
        _add_hinge(proximal, f"sweep{index}", np.array([0.0, 0.0, 1.0]), design)
        _add_hinge(proximal, f"lift{index}", np.array([0.0, 1.0, 0.0]), design)
        _add_hinge(
            proximal,
            f"turn{index}",
            np.array([1.0, 0.0, 0.0]),
            design,
            vein.sense,
            (-hinge.turn_back, hinge.turn_limit),
        )
        _add_motor(spec, f"turn{index}", vein.sense)
    crease = vein.frame.T @ vein.ring_direction
    _add_hinge(distal, f"fold{index}", crease, design, vein.sense, (-hinge.fold_limit, hinge.overbend))
    _add_motor(spec, f"fold{index}", vein.sense)


def stop_reference(design: Design) -> list[float]:
    """Time constant and damping ratio of joint limits: as stiff as the timestep allows without rebound."""
    return [2 * float(design.protocol.timestep), 1.0]


def _add_bar(body: mujoco.MjsBody, end: Point, design: Design, kind: int, touches: int) -> None:
    """Add a cylinder for the mass and, where bars touch, a capsule without mass, whose contacts are closed forms."""
    place = {"size": [design.vein.diameter / 2, 0, 0], "fromto": [0, 0, 0, *end]}
    body.add_geom(type=mujoco.mjtGeom.mjGEOM_CYLINDER, density=design.vein.density, contype=0, conaffinity=0, **place)
    if design.protocol.contact:
        body.add_geom(
            type=mujoco.mjtGeom.mjGEOM_CAPSULE,
            density=0,
            contype=kind,
            conaffinity=touches,
            solref=stop_reference(design),
            solimp=[0.9, 0.95, _SOFT_SHARE * design.vein.diameter, 0.5, 2],
            **place,
        )


def _add_hinge(
    body: mujoco.MjsBody,
    name: str,
    axis: Point,
    design: Design,
    sense: int = 1,
    limits: tuple[float, float] | None = None,
) -> None:
    low, high = limits or (-math.inf, math.inf)
    body.add_joint(
        name=name,
        type=mujoco.mjtJoint.mjJNT_HINGE,
        axis=axis,
        damping=[design.hinge.damping, 0, 0],
        armature=design.hinge.armature,
        limited=limits is not None,
        range=[0, 0] if limits is None else [low, high] if sense > 0 else [-high, -low],
        solref_limit=stop_reference(design),
    )


def _add_motor(spec: mujoco.MjSpec, joint: str, sense: int) -> None:
    motor = spec.add_actuator(name=joint, target=joint, trntype=mujoco.mjtTrn.mjTRN_JOINT, gear=[sense, 0, 0, 0, 0, 0])
    motor.set_to_motor()
