"""The net that a structure of sliding points is, and what its drives do to it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array, eye_array

from forficula.errors import InputError
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.tendon_law import stacked_laws
from forficula.statics.net.energy import shape_at
from forficula.statics.net.load import Load, no_load
from forficula.statics.net.net import Creases, Net, Shape, Springs, Tendons, Triangles
from forficula.structure import GROUND, Structure, built_points, crease_flaps, crease_law, crease_numbers
from forficula.structure.facets import BEND

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]


def is_net(structure: Structure) -> bool:
    """Whether all that moves are points that slide, without joints, and nothing but springs joins them."""
    jointed = any(hinge.flaps is None for hinge in structure.hinges)
    turning = any(body.turns for body in structure.bodies)
    return any(body.slides for body in structure.bodies) and not (jointed or turning or structure.limits)


def net_of(structure: Structure) -> Net:
    """Take a structure as a net: a node for every point, one that its body holds where that does not slide.

    Raises:
        InputError: bodies that turn, or points beside the origins of bodies that slide.
    """
    if not is_net(structure):
        raise InputError(f"{structure.name}: need points that slide and springs between them, got joints")
    nodes, free, masses = _nodes(structure)
    return Net(
        nodes=nodes,
        free=free,
        points=csr_array(eye_array(len(nodes))),
        masses=masses,
        springs=Springs(
            points=_pairs([spring.points for spring in structure.springs]),
            stiffness=np.array([spring.stiffness for spring in structure.springs]),
            rest_length=np.array([spring.rest_length for spring in structure.springs]),
        ),
        creases=Creases(points=crease_flaps(structure), law=valley_law(structure)),
        tendons=Tendons(
            points=_pairs([tendon.points for tendon in structure.tendons]),
            law=stacked_laws([tendon.law.elastic for tendon in structure.tendons]),
        ),
        membranes=_membranes(structure),
        gravity=structure.gravity,
    )


def start_shape(structure: Structure, net: Net) -> Shape:
    """The shape as built, with panels that lie on one another on the side where they start."""
    start = np.array([hinge.start for hinge in structure.hinges])
    return shape_at(net, net.nodes, _senses(structure) * start)


def own_angles(structure: Structure, shape: Shape) -> Array:
    """Angles of the hinges in their own senses, rad, (hinge,)."""
    return np.asarray(_senses(structure) * shape.angles)


def bends(structure: Structure) -> Flags:
    """Which hinges are bends of panels, (hinge,)."""
    return np.array([hinge.role == BEND for hinge in structure.hinges], dtype=np.bool_)


def valley_law(structure: Structure) -> CreaseLaw:
    """The law of the creases' springs by fold angles, valleys positive, where the structure has them in own senses."""
    law, back = crease_law(structure, crease_numbers(structure)), _senses(structure) < 0
    below, above, lower, upper = (np.asarray(each) for each in (law.lock_below, law.lock_above, law.lower, law.upper))
    return replace(
        law,
        rest_angle=_senses(structure) * np.asarray(law.rest_angle),
        lock_below=np.where(back, -above, below),
        lock_above=np.where(back, -below, above),
        lower=np.where(back, -upper, lower),
        upper=np.where(back, -lower, upper),
    )


def motor_load(structure: Structure, net: Net, settings: tuple[float, ...]) -> Load:
    """What motors do, each set to a value: N m, N, m of held points, or rad by which springs rest further on.

    A spring that rests further on by some angle pushes as the torque stiffness x angle does, wherever it locks.

    Args:
        structure: whose motors they are.
        net: of it.
        settings: by motor.
    """
    load, senses = no_load(net), _senses(structure)
    stiffness = np.asarray(net.creases.law.stiffness)
    for motor, setting in zip(structure.motors, settings, strict=True):
        if motor.direction is not None:
            acting = load.forces if motor.kind == "force" else load.displacements
            np.add.at(acting, list(motor.points), setting * motor.direction)
            continue
        hinges = np.array(motor.hinges, dtype=np.int64)
        gains = np.array(motor.gains) if motor.gains else np.ones(len(hinges))
        turned = stiffness[hinges] if motor.kind == "rest-angle" else 1.0
        np.add.at(load.torques, hinges, setting * gains * senses[hinges] * turned)
    return load


def _nodes(structure: Structure) -> tuple[Array, NDArray[np.bool_], Array]:
    """Places, free coordinates and masses of the points' nodes, one each."""
    nodes = built_points(structure)
    free, masses = np.zeros(nodes.shape, dtype=np.bool_), np.zeros(len(nodes))
    carried = set[int]()
    for number, point in enumerate(structure.points):
        if point.body == GROUND:
            continue
        body = structure.bodies[point.body]
        if body.slides and (np.any(point.place) or point.body in carried):
            raise InputError(f"{point.name}: need one point at the origin of a body that slides, got another")
        free[number, list(body.slides)] = True
        masses[number] = body.mass if point.body not in carried else 0.0
        carried.add(point.body)
    return nodes, free, masses


def _pairs(pairs: list[tuple[int, int]]) -> NDArray[np.int64]:
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)


def _senses(structure: Structure) -> NDArray[np.int64]:
    return np.array([hinge.sense for hinge in structure.hinges], dtype=np.int64)


def _membranes(structure: Structure) -> Triangles | None:
    """All triangles, each with the numbers of its own membrane."""
    if not structure.membranes:
        return None
    at = {point.body: number for number, point in enumerate(structure.points)}
    corners = [
        np.array([at[body] for body in membrane.bodies.tolist()])[membrane.triangles]
        for membrane in structure.membranes
    ]
    counts = [len(membrane.triangles) for membrane in structure.membranes]
    laws = [membrane.law for membrane in structure.membranes]
    return Triangles(
        points=np.concatenate(corners),
        built=np.concatenate([membrane.built[membrane.triangles] for membrane in structure.membranes]),
        youngs_modulus=np.repeat([law.youngs_modulus for law in laws], counts),
        poisson_ratio=np.repeat([law.poisson_ratio for law in laws], counts),
        thickness=np.repeat([law.thickness for law in laws], counts),
    )
