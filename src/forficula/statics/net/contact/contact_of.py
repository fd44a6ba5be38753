"""Contact of a structure's facets and plates, as that of a net."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern.drawings.flat_faces import parts_of
from forficula.quantities import SMALL_LENGTH, show_quantity
from forficula.statics.net.contact.net_contact import NetContact
from forficula.statics.net.energy import expand, shape_at
from forficula.statics.net.net import Net
from forficula.statics.net.plate_nodes import plate_nodes
from forficula.structure import Structure, facet_triangles
from forficula.structure.tree import built_frames

_JOINED = 1e-6  # of the span: distance from the axis of a joint within which corners of two plates are joined
_WITHIN = 1e-6  # of the thickness, by which facets may be too close as built


def panels(structure: Structure) -> Indices:
    """Return the triangles of facets and of plates, as points at their corners, (triangle, 3)."""
    fans = [(plate.points[0], one, other) for plate in structure.plates for one, other in pairwise(plate.points[1:])]
    return np.concatenate((facet_triangles(structure)[0], np.array(fans, dtype=np.int64).reshape(-1, 3)))


def with_contact(structure: Structure, net: Net) -> Net:
    """Return the net of a structure with its contact; the same net for a structure without contact.

    Raises:
        InputError: facets are closer as built than they may be.
    """
    if structure.contact is None:
        return net
    triangles, facets = panels(structure), facet_triangles(structure)[1]
    plates = [number for number, plate in enumerate(structure.plates) for _ in range(len(plate.points) - 2)]
    facets = np.concatenate((facets, len(structure.facets) + np.array(plates, dtype=np.int64)))
    names = (
        *(facet.name for facet in structure.facets),
        *(structure.bodies[plate.body].name for plate in structure.plates),
    )
    stiffest = float(expand(net, shape_at(net, net.nodes)).free.diagonal().max(initial=0.0)) or 1.0
    contact = NetContact(
        thickness=structure.contact.thickness,
        stiffness=stiffest,
        triangles=triangles,
        corners=_joined_points(structure, net)[triangles],
        facets=facets,
        rigid=_rigid_bodies(structure, len(triangles)),
        names=names,
    )
    _check_apart(structure, net, contact)
    return replace(net, contact=contact)


def _check_apart(structure: Structure, net: Net, contact: NetContact) -> None:
    """Refuse facets that are too close as built."""
    apart, (one, other) = contact.least_distance(net.points @ net.nodes)
    if apart >= (1 - _WITHIN) * contact.thickness:
        return
    got = f"{show_quantity(contact.thickness, SMALL_LENGTH)} with {contact.names[one]} and {contact.names[other]}"
    if apart <= _WITHIN * contact.thickness:
        raise InputError(
            f"{structure.name}: contact.thickness: need facets that are apart as built, got {got}, which touch or cross:"
            " no thickness works"
        )
    raise InputError(
        f"{structure.name}: contact.thickness: need at most {show_quantity(apart, SMALL_LENGTH)}, the least distance of"
        f" two facets as built, got {got}"
    )


def _rigid_bodies(structure: Structure, count: int) -> Indices:
    """Return the number of the body that carries each triangle; negative numbers for those of facets, (triangle,)."""
    first = plate_nodes(structure).first if structure.plates else ()
    bodies = [first[plate.body] for plate in structure.plates for _ in range(len(plate.points) - 2)]
    return np.array([*range(len(bodies) - count, 0), *bodies], dtype=np.int64)


def _joined_points(structure: Structure, net: Net) -> Indices:
    """Number the points so that corners of several facets at one vertex have the same number, (point,)."""
    sides = [(flaps[end], flaps[end + 3]) for flaps in net.creases.points for end in (0, 1)]
    sides += [pair for closure in structure.closures for pair in closure.points]
    places = net.points @ net.nodes
    at: dict[int, list[int]] = {}
    for plate in structure.plates:
        at[plate.body] = list(plate.points)
    origins, frames = built_frames(structure)
    for hinge in structure.hinges:
        if hinge.flaps is not None:
            continue
        parent = structure.bodies[hinge.body].parent
        axis = frames[hinge.body] @ hinge.axis
        near = [
            [point for point in at.get(body, ()) if _off_axis(places[point] - origins[hinge.body], axis) < _JOINED * structure.span]
            for body in (parent, hinge.body)
        ]
        sides += [
            (one, other)
            for one in near[0]
            for other in near[1]
            if np.linalg.norm(places[one] - places[other]) < _JOINED * structure.span
        ]
    return parts_of(net.points.shape[0], sides)


def _off_axis(place: Array, axis: Array) -> float:
    return float(np.linalg.norm(np.cross(place, axis)) / np.linalg.norm(axis))
