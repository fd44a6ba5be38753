"""Contact in the engine: compliance of bars and panels of fans, and the surface of panels."""

from __future__ import annotations

import math
from collections import Counter

import mujoco
import numpy as np

from forficula.design.section import SMALL_LENGTH
from forficula.errors import InputError
from forficula.quantities import show_quantity
from forficula.structure import Contact, Structure

# bits by which MuJoCo selects pairs for contact
BARS, PANELS = 1, 2
# By default MuJoCo hardens a contact over 0.001 of its length unit, a different share of every structure. The other
# numbers are its defaults.
_SOFT_SHARE = 0.02
# tolerance of a thickness, because numbers are shown with four digits
_ROUNDING = 1e-3


def has_engine_contact(structure: Structure) -> bool:
    """Return whether the engine computes contacts: those of bars and membranes, and those with the table.

    It does not compute the contacts of facets and plates with each other.
    """
    surfaces = any(membrane.surface is not None for membrane in structure.membranes)
    touching = structure.contact is not None and (surfaces or bool(structure.bars))
    return touching or structure.table is not None


def set_contact(shape: mujoco.MjsGeom | mujoco.MjsFlex, thickness: float, contact: Contact) -> None:
    """Set the compliance of a shape's contacts; a contact softens over 2 % of a thickness."""
    shape.condim = 3 if contact.friction else 1
    # without rolling and spinning friction, which condim leaves out
    shape.friction = [contact.friction, 0, 0]
    shape.solref[:2] = [contact.stops.time_constant, contact.stops.damping_ratio]
    shape.solimp = [0.9, 0.95, _SOFT_SHARE * thickness, 0.5, 2]


def add_panels(spec: mujoco.MjSpec, structure: Structure) -> None:
    """Add the surfaces of membranes for contact, as one flex without elasticity and mass.

    The engine ignores contact between triangles with nodes on the same body, and all panels at a vein have such nodes.
    Nodes are therefore on copies of their bodies, fixed to them: one copy for nodes of a surface that belong to the
    same panels, and one for nodes that surfaces share, where they join and must not push each other apart. The engine
    derives the softness of a contact from the mobility of the origins of bodies. Copies have their origins in the
    middle of their nodes, because the origins of veins at the hub do not move.
    """
    contact = structure.contact
    surfaces = [membrane.surface for membrane in structure.membranes if membrane.surface is not None]
    if contact is None or not surfaces:
        return
    joined = Counter(place for surface in surfaces for place in surface.carried)
    bodies: list[str] = []
    copies: list[str] = []
    triangles = []
    for number, surface in enumerate(surfaces):
        triangles.append(len(copies) + surface.triangles)
        # panels of each node, as bits
        of = np.zeros(len(surface.bodies), dtype=np.int64)
        np.bitwise_or.at(of, surface.triangles, 1 << surface.panels[:, None])
        for place, panels in zip(surface.carried, of.tolist(), strict=True):
            bodies.append(structure.bodies[place[0]].name)
            copies.append(f"{bodies[-1]}_{'seam' if joined[place] > 1 else number}_{panels}")
    names, of_copy = np.unique(copies, return_inverse=True)
    places = np.concatenate([surface.places for surface in surfaces])
    for copy, name in enumerate(names.tolist()):
        of_this = of_copy == copy
        middle = places[of_this].mean(axis=0)
        spec.body(bodies[int(np.argmax(of_this))]).add_body(name=name, pos=middle)
        places[of_this] -= middle
    flex = spec.add_flex(name="panels", dim=2, radius=contact.thickness / 2, thickness=contact.thickness)
    flex.vertbody = copies
    flex.vert = places.ravel()
    flex.elem = np.concatenate(triangles).ravel()
    flex.selfcollide = mujoco.mjtFlexSelf.mjFLEXSELF_AUTO
    flex.contype = flex.conaffinity = PANELS
    set_contact(flex, contact.thickness, contact)


def check_apart(engine: mujoco.MjModel, structure: Structure, unit: float) -> None:
    """Reject panels that contact would push apart in the built shape, because this would supply energy.

    Args:
        engine: the compiled model.
        structure: its structure, in the model's units.
        unit: of length, m.

    Raises:
        InputError: panels are too thick; the message gives the largest thickness.
    """
    if structure.contact is None or not engine.nflex:
        return
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    overlap = -float(np.min(data.contact.dist[data.contact.flex[:, 0] >= 0], initial=0.0))
    thickness = structure.contact.thickness
    if overlap > _ROUNDING * thickness:
        most, provided = (show_quantity(unit * size, SMALL_LENGTH) for size in (thickness - overlap, thickness))
        raise InputError(f"contact.thickness: panels are nearer than that as built: need <= {most}, got {provided}")


def add_stop_sensors(spec: mujoco.MjSpec, structure: Structure) -> None:
    """Add sensors that separate the forces of stops and length limits from those of contacts, if there are contacts."""
    if not has_engine_contact(structure):
        return
    limits = mujoco.mjtSensor
    joints = [hinge for hinge in structure.hinges if hinge.flaps is None]
    hinges = [hinge for hinge in joints if math.isfinite(hinge.lower) or math.isfinite(hinge.upper)]
    for hinge in hinges:
        spec.add_sensor(type=limits.mjSENS_JOINTLIMITFRC, objtype=mujoco.mjtObj.mjOBJ_JOINT, objname=hinge.name)
    for limit in structure.limits:
        spec.add_sensor(type=limits.mjSENS_TENDONLIMITFRC, objtype=mujoco.mjtObj.mjOBJ_TENDON, objname=limit.name)
