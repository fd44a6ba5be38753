"""Conversion of a structure of sliding points or of plates into a net, and of its drives into loads."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array, eye_array

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.crease_turn import relaxed
from forficula.material.law.tendon_law import stacked_laws
from forficula.statics.net.contact.contact_energy import passes_through, touches
from forficula.statics.net.contact.contact_of import with_contact
from forficula.statics.net.energy import remembered, shape_at
from forficula.statics.net.load import Load, no_load, point_forces
from forficula.statics.net.net import Net, NetCreases, NetPlanes, NetShape, Springs, Tendons, Triangles
from forficula.statics.net.plate_nodes import joint_places, place_weights, plate_nodes, posed_nodes, stiffness_of
from forficula.statics.path_dependence import refuse_rest_angles
from forficula.statics.planes import planes_of
from forficula.statics.tree.ensemble import ensemble, start_angles
from forficula.statics.tree.pose import pose, tree_of
from forficula.statics.tree.potential import hinge_angles, rest
from forficula.structure import (
    GROUND,
    Structure,
    built_points,
    crease_flaps,
    crease_law,
    facet_triangles,
)
from forficula.structure.sheets.facets import BEND

Flags = NDArray[np.bool_]


def is_net(structure: Structure) -> bool:
    """Return whether all moving parts are sliding points, or plates that are in loops, free or touch each other.

    Springs along creases that open close loops, too.
    """
    if structure.bars or structure.limits:
        return False
    jointed = any(hinge.flaps is None for hinge in structure.hinges)
    if structure.plates:
        joints = [hinge.body for hinge in structure.hinges if hinge.flaps is None]
        loose = bool(structure.closures or structure.springs) or any(body.turns for body in structure.bodies)
        # the solver for trees has no contact
        loose = loose or structure.contact is not None
        return loose and len(joints) == len(set(joints)) and not structure.membranes
    return any(body.slides for body in structure.bodies) and not jointed


def net_of(structure: Structure) -> Net:
    """Convert a structure into a net: a node for every point, four nodes for every plate, stiff pins for joints.

    Pins are far stiffer than all other parts. The springs of the structure come first, then the bars of plates and the
    pins.

    Raises:
        InputError: bodies turn in a tree, or points are away from the origins of sliding bodies.
    """
    if not is_net(structure):
        raise InputError(f"{structure.name}: need points that slide and springs between them, got joints")
    laid = _plates(structure) if structure.plates else _nodes(structure)
    stiffness, rest = laid.stiff
    net = Net(
        nodes=laid.nodes,
        free=laid.free,
        points=laid.points,
        masses=laid.masses,
        springs=Springs(
            points=_pairs([*(spring.points for spring in structure.springs), *laid.pairs]),
            stiffness=np.concatenate([[spring.stiffness for spring in structure.springs], stiffness]),
            rest_length=np.concatenate([[spring.rest_length for spring in structure.springs], rest]),
            rigid=laid.rigid if structure.closures else (0, 0),
        ),
        creases=NetCreases(points=laid.creases, law=relaxed(valley_law(structure))),
        tendons=Tendons(
            points=_pairs([tendon.points for tendon in structure.tendons]),
            law=stacked_laws([tendon.law.elastic for tendon in structure.tendons]),
        ),
        membranes=_membranes(structure),
        gravity=structure.gravity,
        down=structure.down,
        planes=_planes(structure, laid.nodes),
    )
    return with_contact(structure, net)


def _planes(structure: Structure, nodes: Array) -> NetPlanes | None:
    """Return the planes of a net with its nodes as built, m, (node, 3); None without any.

    Raises:
        InputError: a part is below the table as built.
    """
    planes = planes_of(structure)
    if planes is None:
        return None
    if structure.plates:
        plates = plate_nodes(structure)
        points = zip(planes.bodies, planes.places, strict=True)
        rows = [place_weights(structure, plates, body, place) for body, place in points]
    else:
        node = {point.body: number for number, point in enumerate(structure.points)}
        rows = [{node[body]: 1.0} for body in planes.bodies]
    weights = _weights(rows, len(nodes))
    planes.refuse_start(structure, weights @ nodes)
    return NetPlanes(planes=planes, weights=weights)


def _weights(rows: list[dict[int, float]], count: int) -> csr_array:
    """Return the weights of nodes at points, by the number of the node, as a matrix, (point, node)."""
    entries = [
        (row, column, weight) for row, weights in enumerate(rows) for column, weight in weights.items() if weight
    ]
    at_row, at_column, weights = zip(*entries, strict=True)
    return csr_array((weights, (at_row, at_column)), shape=(len(rows), count))


def point_positions(net: Net, shape: NetShape) -> Array:
    """Return the positions of the structure's points, followed by those of joints, m, (point, 3)."""
    return np.asarray(net.points @ shape.positions)


def place_points(structure: Structure) -> list[int]:
    """Return the numbers of the points at places: all points, then those of the nodes of membranes."""
    at = {point.body: number for number, point in enumerate(structure.points)}
    nodes = [at[body] for membrane in structure.membranes for body in membrane.bodies.tolist()]
    return [*range(len(structure.points)), *nodes]


def panels(structure: Structure) -> Indices:
    """Return the triangles of facets and of plates, as points at their corners, (triangle, 3)."""
    fans = [(plate.points[0], one, other) for plate in structure.plates for one, other in pairwise(plate.points[1:])]
    return np.concatenate((facet_triangles(structure)[0], np.array(fans, dtype=np.int64).reshape(-1, 3)))


def start_shape(structure: Structure, net: Net) -> NetShape:
    """Return the shape from which a net is released: as built, except for plates on joints in a tree.

    These begin with the angles of a run and fold as without contact, until they rest or touch. Start angles also
    distinguish panels that lie on one another.
    """
    positions, angles = net.nodes, np.array([hinge.start for hinge in structure.hinges])
    if structure.contact is not None and not is_net(replace(structure, contact=None)):
        positions, angles = _folded_apart(structure, net)
    return remembered(net, shape_at(net, positions, valley_angles(structure, angles)))


def _folded_apart(structure: Structure, net: Net) -> tuple[Array, Array]:
    """Return nodes, m, (node, 3), and angles, rad, (hinge,), of a released tree that rests or whose plates touch."""
    structures, first = ensemble([structure]), plate_nodes(structure).first
    tree, steps = tree_of(structure), [start_angles(structures)]
    rest(structures, steps[0], follow=lambda _, angles: steps.append(angles.copy()))

    def nodes_at(angles: Array) -> Array:
        at = pose(tree, angles)
        return posed_nodes(structure, net.nodes, first, at.origins[0], at.frames[0])

    angles, nodes = steps[0], nodes_at(steps[0])
    for following in steps[1:]:
        moved = nodes_at(following)
        if touches(net, moved) or passes_through(net, nodes, moved):
            break
        angles, nodes = following, moved
    return nodes, hinge_angles(structures, angles)[0]


def own_angles(structure: Structure, shape: NetShape) -> Array:
    """Return the angles of the hinges in their own senses, rad, (hinge,)."""
    return np.asarray(_senses(structure) * shape.angles)


def own_memory(structure: Structure, shape: NetShape) -> Array | None:
    """Return the memory of the hinges at a shape in their own senses, (slot, hinge); None for new hinges.

    Args:
        structure: the structure.
        shape: from `remembered`.
    """
    return None if shape.turn is None else memory_in_senses(structure, shape.turn.memory)


def memory_in_senses(structure: Structure, memory: Array) -> Array:
    """Return the memory of hinges in their own senses instead of that by fold angles, or the inverse, (slot, hinge)."""
    memory, senses = memory.copy(), _senses(structure)
    # wear has no sense
    memory[0], memory[2:] = senses * memory[0], senses * memory[2:]
    return memory


def valley_angles(structure: Structure, angles: Array) -> Array:
    """Return angles of the hinges in their own senses as fold angles, valleys positive, rad, (hinge,)."""
    return np.asarray(_senses(structure) * angles)


def bends(structure: Structure) -> Flags:
    """Return which hinges are bends of panels, (hinge,)."""
    return np.array([hinge.role == BEND for hinge in structure.hinges], dtype=np.bool_)


def valley_law(structure: Structure) -> CreaseLaw:
    """Return the law of the creases' springs by fold angles, valleys positive, instead of by their own senses."""
    law = crease_law(structure, np.arange(len(structure.hinges)), rigid_stops=True)
    back = _senses(structure) < 0
    below, above, lower, upper = (np.asarray(limit) for limit in (law.lock_below, law.lock_above, law.lower, law.upper))
    return replace(
        law,
        rest_angle=_senses(structure) * np.asarray(law.rest_angle),
        lock_below=np.where(back, -above, below),
        lock_above=np.where(back, -below, above),
        lower=np.where(back, -upper, lower),
        upper=np.where(back, -lower, upper),
        # an even term changes its sign with the sense
        quadratic=_senses(structure) * np.asarray(law.quadratic),
    )


def motor_load(structure: Structure, net: Net, settings: tuple[float, ...]) -> Load:
    """Return the load of motors at given settings: N m, N, m of held points, or rad of changed rest angles.

    A change of a linear spring's rest angle is equivalent to the torque stiffness x angle, wherever the spring locks.

    Args:
        structure: the structure with the motors.
        net: net of the structure.
        settings: by motor.
    """
    load, senses = no_load(net), _senses(structure)
    stiffness = np.asarray(net.creases.law.stiffness)
    refuse_rest_angles(structure)
    for motor, setting in zip(structure.motors, settings, strict=True):
        if motor.direction is not None:
            vectors = np.tile(setting * motor.direction, (len(motor.points), 1))
            if motor.kind == "force":
                load.forces[:] += point_forces(net, np.array(motor.points), vectors).forces
            else:
                np.add.at(load.displacements, list(motor.points), vectors)
            continue
        hinges = np.array(motor.hinges, dtype=np.int64)
        gains = np.array(motor.gains) if motor.gains else np.ones(len(hinges))
        turned = stiffness[hinges] if motor.kind == "rest-angle" else 1.0
        np.add.at(load.torques, hinges, setting * gains * senses[hinges] * turned)
    return load


class _Frame(NamedTuple):
    """Frame of a net: nodes, points, creases between points, and bars that are far stiffer than all other parts."""

    nodes: Array
    free: Flags
    masses: Array | csr_array
    points: csr_array
    creases: Indices
    pairs: list[tuple[int, int]]
    stiff: tuple[list[float], list[float]]
    rigid: tuple[int, int]


def _plates(structure: Structure) -> _Frame:
    """Return the frame of plates: four nodes for every plate, and one for every point of the ground."""
    plates, rows = plate_nodes(structure), list[dict[int, float]]()
    ground = list[Array]()
    for point in structure.points:
        if point.body == GROUND:
            rows.append({len(plates.nodes) + len(ground): 1.0})
            ground.append(point.place)
        else:
            rows.append(place_weights(structure, plates, point.body, point.place))
    creases, pins = [], list[tuple[int, int]]()
    for hinge in structure.hinges:
        if hinge.flaps is not None:
            creases.append(hinge.flaps)
            continue
        first = len(rows)
        for body, place in joint_places(structure, hinge, plates.size):
            if body == GROUND:
                rows.append({len(plates.nodes) + len(ground): 1.0})
                ground.append(place)
            else:
                rows.append(place_weights(structure, plates, body, place))
        creases.append((first, first + 1, first + 2, first + 3, first + 4, first + 5))
        pins += [(first, first + 3), (first + 1, first + 4)]
    nodes = np.concatenate([plates.nodes, np.array(ground).reshape(-1, 3)])
    begin = len(rows)
    rows += [{number: 1.0} for number in range(len(plates.nodes))]
    bars = [(begin + one, begin + other) for one, other in plates.bars]
    rest = [float(np.linalg.norm(nodes[one] - nodes[other])) for one, other in plates.bars]
    free = np.zeros(nodes.shape, dtype=np.bool_)
    for body, first in enumerate(plates.first):
        free[first : first + 4] |= plates.free[body]
    stiff = stiffness_of(structure, plates.size)
    mass = np.zeros((len(nodes), len(nodes)))
    mass[: len(plates.nodes), : len(plates.nodes)] = plates.mass
    return _Frame(
        nodes=nodes,
        free=free,
        masses=csr_array(mass),
        points=_weights(rows, len(nodes)),
        creases=np.array(creases, dtype=np.int64).reshape(-1, 6),
        pairs=[*bars, *pins],
        stiff=([stiff] * (len(bars) + len(pins)), [*rest, *[0.0] * len(pins)]),
        rigid=(len(bars), len(pins)),
    )


def _nodes(structure: Structure) -> _Frame:
    """Return the frame of sliding points: a node for every point."""
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
    points = csr_array(eye_array(len(nodes)))
    return _Frame(nodes, free, masses, points, crease_flaps(structure), [], ([], []), (0, 0))


def _pairs(pairs: list[tuple[int, int]]) -> Indices:
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)


def _senses(structure: Structure) -> Indices:
    return np.array([hinge.sense for hinge in structure.hinges], dtype=np.int64)


def _membranes(structure: Structure) -> Triangles | None:
    """Return the triangles of all membranes, each with the law of its membrane."""
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
