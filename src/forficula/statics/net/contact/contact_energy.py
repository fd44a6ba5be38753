"""Contact of a net as inequality constraints: the augmented Lagrangian with its gradient, Hessian and multipliers."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy.sparse import coo_array, csc_array, csr_array, eye_array, kron

from forficula.arrays import Array
from forficula.statics.net.contact.closest import distance_hessians, gradients, squared_sines
from forficula.statics.net.contact.net_contact import NetContact, Pairs, Pressing

if TYPE_CHECKING:
    from forficula.statics.net.net import Net, NetShape

# squared sines of the angle between edges from which, and up to which, their pair gains its full effect; the distance
# of parallel edges is also that of an end and a triangle
_PARALLEL = (1e-4, 1e-3)
_TOLERANCE = 1e-7  # of the thickness: largest error of a distance with contact, and of a gap with a force


class ContactTerms(NamedTuple):
    """Contribution of contact to an expansion.

    Attributes:
        energy: of the augmented Lagrangian, J; 0 at a converged equilibrium.
        slope: forces by the positions of nodes, N, (node, 3).
        curvature: Hessian by all coordinates, N/m.
    """

    energy: float
    slope: Array
    curvature: csc_array


def contact_terms(net: Net, contact: NetContact, positions: Array, pressing: Pressing | None) -> ContactTerms:
    """Compute the augmented Lagrangian of the constraints distance >= thickness.

    For a pair with the distance d, the multiplier f and the stiffness k, the term is (max(0, f + k (t - d))^2 - f^2) /
    (2 k) (Rockafellar 1973, doi 10.1007/BF00934777). At the solution f is the force of the contact.

    Args:
        net: the net.
        contact: its contact.
        positions: of the nodes, m, (node, 3).
        pressing: multipliers; None for 0.
    """
    places = net.points @ positions
    pairs, force, known = _forces(contact, places, pressing)
    rows = np.flatnonzero((force > 0) | (known > 0))
    if not len(rows):
        return ContactTerms(0.0, np.zeros_like(positions), csc_array((positions.size, positions.size)))
    stiffness, force, known = contact.stiffness, np.maximum(force[rows], 0.0), known[rows]
    corners = int(np.count_nonzero(rows < pairs.corners))
    pairs = Pairs(pairs.codes[rows], pairs.points[rows], corners, pairs.facets[rows])
    at, closest = places[pairs.points], pairs.closest(places)
    share, changes = _shares(pairs, at)
    value = (force**2 - known**2) / (2 * stiffness)
    slopes = gradients(closest).reshape(-1, 12)
    by_place = -(share * force)[:, None] * slopes + value[:, None] * changes
    hessians = (share * stiffness * (force > 0))[:, None, None] * slopes[:, :, None] * slopes[:, None]
    hessians -= (share * force)[:, None, None] * distance_hessians(at, closest)
    mixed = -force[:, None, None] * slopes[:, :, None] * changes[:, None]
    hessians += mixed + np.swapaxes(mixed, 1, 2)
    count = net.points.shape[0]
    numbers = (3 * pairs.points[:, :, None] + np.arange(3)).reshape(-1, 12)
    forces = np.zeros(3 * count)
    np.add.at(forces, numbers, by_place)
    rows_of, columns_of = (np.broadcast_to(part, hessians.shape) for part in (numbers[:, :, None], numbers[:, None]))
    curvature = coo_array((hessians.ravel(), (rows_of.ravel(), columns_of.ravel())), shape=(3 * count, 3 * count))
    spread = csr_array(kron(csr_array(net.points), eye_array(3)))
    return ContactTerms(
        energy=float(share @ value),
        slope=np.asarray(net.points.T @ forces.reshape(-1, 3)),
        curvature=csc_array(spread.T @ curvature.tocsr() @ spread),
    )


def with_contact_forces(net: Net, shape: NetShape) -> tuple[NetShape, bool]:
    """Return a shape with its multipliers updated, and whether they had already converged.

    They have converged if no distance is smaller than the thickness, and no pair with a force is further apart, by more
    than 1e-7 of the thickness.
    """
    contact = net.contact
    if contact is None:
        return shape, True
    pairs, force, known = _forces(contact, net.points @ shape.positions, shape.pressing)
    used = np.ones(len(force), dtype=np.bool_)
    used[pairs.corners :] = squared_sines((net.points @ shape.positions)[pairs.points[pairs.corners :]])[0] > _PARALLEL[0]
    force = np.where(used, np.maximum(force, 0.0), 0.0)
    error = float(np.abs(force - known).max(initial=0.0)) / contact.stiffness
    pressed = force > 0
    pressing = Pressing(codes=pairs.codes[pressed], forces=force[pressed])
    return replace(shape, pressing=pressing), error <= _TOLERANCE * contact.thickness


def facet_forces(net: Net, shape: NetShape) -> dict[tuple[int, int], float]:
    """Return the sum of the forces between each pair of facets that touch, N, by the numbers of the facets."""
    contact, pressing = net.contact, shape.pressing
    if contact is None or pressing is None or not len(pressing.codes):
        return {}
    places = net.points @ shape.positions
    pairs = contact.within(places, contact.thickness, pressing)
    shares = _shares(pairs, places[pairs.points])[0] * pressing.of(pairs.codes)
    result = dict[tuple[int, int], float]()
    for row in np.flatnonzero(shares > 0).tolist():
        one, other = sorted(pairs.facets[row].tolist())
        result[one, other] = result.get((one, other), 0.0) + float(shares[row])
    return dict(sorted(result.items()))


def facet_gaps(net: Net, shape: NetShape) -> dict[tuple[int, int], float]:
    """Return the least distance minus the thickness of each pair of facets that is near, m, by their numbers."""
    contact = net.contact
    if contact is None:
        return {}
    places = net.points @ shape.positions
    pairs = contact.within(places, contact.thickness + net.size / 10, shape.pressing)
    result = dict[tuple[int, int], float]()
    for facets, distance in zip(np.sort(pairs.facets, axis=1).tolist(), pairs.closest(places).distance, strict=True):
        pair = (facets[0], facets[1])
        result[pair] = min(result.get(pair, np.inf), float(distance) - contact.thickness)
    return result


def passes_through(net: Net, before: Array, after: Array) -> bool:
    """Return whether triangles pass through each other between two positions of the nodes, m, (node, 3) each."""
    if net.contact is None:
        return False
    return net.contact.crossed(net.points @ before, net.points @ after)


def _forces(contact: NetContact, places: Array, pressing: Pressing | None) -> tuple[Pairs, Array, Array]:
    """Return pairs that may touch, their forces f + k (t - d), N, and their multipliers f, N."""
    pairs = contact.within(places, contact.thickness, pressing)
    known = np.zeros(len(pairs.codes)) if pressing is None else pressing.of(pairs.codes)
    distance = pairs.closest(places).distance
    return pairs, np.asarray(known + contact.stiffness * (contact.thickness - distance)), known


def _shares(pairs: Pairs, at: Array) -> tuple[Array, Array]:
    """Return the share of the effect of each pair, from 0 to 1, and its gradient by the positions, 1/m, (pair, 12)."""
    share, changes = np.ones(len(at)), np.zeros((len(at), 12))
    sines, slopes = squared_sines(at[pairs.corners :])
    low, high = _PARALLEL
    rise = np.clip((sines - low) / (high - low), 0.0, 1.0)
    share[pairs.corners :] = rise**2 * (3 - 2 * rise)
    changes[pairs.corners :] = (6 * rise * (1 - rise) / (high - low))[:, None] * slopes.reshape(-1, 12)
    return share, changes
