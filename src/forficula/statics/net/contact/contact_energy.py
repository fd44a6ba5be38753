"""Contact of a net as inequality constraints: the augmented Lagrangian with its gradient, Hessian and multipliers."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy.optimize import nnls
from scipy.sparse import coo_array, csc_array, csr_array

from forficula.arrays import Array, Flags
from forficula.statics.net.contact.closest import Closest, distance_hessians, gradients
from forficula.statics.net.contact.net_contact import NetContact, Pressing
from forficula.statics.net.factor import Factorisation, Matrix
from forficula.structure.contact.distances import squared_sines
from forficula.structure.contact.pairs import Pairs

if TYPE_CHECKING:
    from forficula.statics.net.net import Net, NetShape

# squared sines of the angle between two sides from which, and up to which, their pair gains its full effect; the
# distance of parallel sides is also that of an end and a triangle
_PARALLEL = (1e-4, 1e-3)
_TOLERANCE = 1e-6  # of the thickness: largest error of a distance with contact, and of a gap with a force
_CHANGE = 1e-5  # of the largest force on a corner: largest change of such a force in the last iteration
_NEAR = 1e-3  # of the thickness: error from which on multipliers follow from Newton's method
_INDEPENDENT = 1e-6  # of the largest yield of a distance to its force, added to all of them
_ROUNDING = 1e-12  # of the thickness: an error of a distance that counts as rounding


class ContactTerms(NamedTuple):
    """Contribution of contact to an expansion.

    Attributes:
        energy: of the augmented Lagrangian, J; 0 at a converged equilibrium.
        slope: forces by the positions of nodes, N, (node, 3).
        curvature: Hessian by all coordinates, N/m; None if nothing touches.
    """

    energy: float
    slope: Array
    curvature: Matrix | None


def contact_terms(
    contact: NetContact, positions: Array, pressing: Pressing | None, *, dense: bool = False
) -> ContactTerms:
    """Compute the augmented Lagrangian of the constraints distance >= thickness.

    For a pair with the distance d, the multiplier f and the stiffness k, the term is (max(0, f + k (t - d))^2 - f^2) /
    (2 k) (Rockafellar 1973, doi 10.1007/BF00934777). At the solution f is the force of the contact.

    Args:
        contact: of the net.
        positions: of the nodes, m, (node, 3).
        pressing: multipliers; None for 0.
        dense: whether the Hessian is dense, which is faster for few nodes.
    """
    places = contact.points @ positions
    pairs, known = contact.near(places, pressing)
    if not len(known):
        return ContactTerms(0.0, np.zeros_like(positions), None)
    nearest = contact.closest(places[pairs.nodes], pairs.of_triangles)
    force = known + contact.stiffness * (pairs.thickness - nearest.distance)
    rows = (force > 0) | (known > 0)
    if not rows.any():
        return ContactTerms(0.0, np.zeros_like(positions), None)
    stiffness, force, known, pairs = contact.stiffness, np.maximum(force[rows], 0.0), known[rows], pairs.some(rows)
    at, nearest = places[pairs.nodes], _some(nearest, rows)
    share, changes = _shares(pairs, at)
    value = (force**2 - known**2) / (2 * stiffness)
    slopes = gradients(nearest).reshape(-1, 12)
    by_place = -(share * force)[:, None] * slopes + value[:, None] * changes
    hessians = (share * stiffness * (force > 0))[:, None, None] * slopes[:, :, None] * slopes[:, None]
    hessians -= (share * force)[:, None, None] * distance_hessians(at, nearest)
    mixed = -force[:, None, None] * slopes[:, :, None] * changes[:, None]
    hessians += mixed + np.swapaxes(mixed, 1, 2)
    size = places.size
    numbers = (3 * pairs.nodes[:, :, None] + np.arange(3)).reshape(-1, 12)
    forces = np.zeros(size)
    np.add.at(forces, numbers, by_place)
    by_node = np.asarray(contact.points.T @ forces.reshape(-1, 3))
    if dense:
        curvature = np.zeros((size, size))
        np.add.at(curvature, (numbers[:, :, None], numbers[:, None]), hessians)
        spread = contact.dense_spread
        return ContactTerms(energy=float(share @ value), slope=by_node, curvature=spread.T @ curvature @ spread)
    rows_of, columns_of = (np.broadcast_to(part, hessians.shape) for part in (numbers[:, :, None], numbers[:, None]))
    sparse = coo_array((hessians.ravel(), (rows_of.ravel(), columns_of.ravel())), shape=(size, size))
    return ContactTerms(
        energy=float(share @ value),
        slope=by_node,
        curvature=csc_array(contact.spread.T @ sparse.tocsr() @ contact.spread),
    )


def with_contact_forces(net: Net, shape: NetShape, parts: Factorisation) -> tuple[NetShape, bool]:
    """Return a shape with its multipliers updated, and whether they had already converged.

    They have converged if no distance is smaller than the thickness and no pair with a force is further apart by more
    than 1e-6 of the thickness, and if the sum of the forces on no corner changes by more than 1e-5 of the largest sum.
    Forces of single pairs need not converge, because several pairs may have the same distance, such as those of a
    corner on a side.

    Far from the solution, the multipliers become the forces f + k (t - d). Near it they follow from Newton's method on
    the distances of the pairs with a force as functions of the multipliers (Bertsekas 1982, Constrained Optimization
    and Lagrange Multiplier Methods, section 2.3.2), among forces >= 0 (Lawson and Hanson 1974).

    Args:
        net: with contact.
        shape: equilibrium for its multipliers.
        parts: of the Hessian by the free coordinates.
    """
    contact = net.contact
    if contact is None:
        return shape, True
    places = contact.points @ shape.positions
    pairs, nearest, force, known = _forces(contact, places, shape.pressing)
    used = (_shares(pairs, places[pairs.nodes])[0] > 0) & ((force > 0) | (known > 0))
    pairs, nearest, force, known = pairs.some(used), _some(nearest, used), force[used], known[used]
    error = float((np.abs(np.maximum(force, 0.0) - known) / (contact.stiffness * pairs.thickness)).max(initial=0.0))
    slopes, sums = gradients(nearest), np.zeros((2, *places.shape))
    for total, forces in zip(sums, (np.maximum(force, 0.0), np.maximum(force, 0.0) - known), strict=True):
        np.add.at(total, pairs.nodes, forces[:, None, None] * slopes)
    largest, change = np.abs(sums).max(axis=(1, 2))
    if error <= _TOLERANCE and (change <= _CHANGE * largest or error <= _ROUNDING):
        pressed = force > 0
        return replace(shape, pressing=Pressing(pairs=pairs.some(pressed), forces=force[pressed])), True
    active = force > 0
    by_free = _by_free(net, contact, pairs, nearest)[active]
    yields = by_free @ parts.solve(np.ascontiguousarray(by_free.T))
    overlap = pairs.thickness[active] - nearest.distance[active]
    force = force.copy()
    # away from a minimum, the distances do not determine the forces
    if active.any() and error <= _NEAR and parts.index == 0:
        force[active] = _pushing(yields, known[active], overlap)
    pressed = force > 0
    return replace(shape, pressing=Pressing(pairs=pairs.some(pressed), forces=force[pressed])), False


def constrained_step(net: Net, shape: NetShape, parts: Factorisation, step: Array) -> tuple[Array, NetShape]:
    """Return the step of Newton's method on equilibrium and distances of pressing pairs, and the shape with its forces.

    Unlike the multipliers of `with_contact_forces`, these converge near any equilibrium, stable or not.

    Args:
        net: need not have contact.
        shape: near an equilibrium.
        parts: of the Hessian by the free coordinates.
        step: to the equilibrium for the multipliers of the shape, by the free coordinates, m, (coordinate,).
    """
    contact = net.contact
    if contact is None:
        return step, shape
    places = contact.points @ shape.positions
    pairs, nearest, force, known = _forces(contact, places, shape.pressing)
    share = _shares(pairs, places[pairs.nodes])[0]
    used = (share > 0) & (force > 0)
    if not used.any():
        return step, replace(shape, pressing=None)
    pairs, nearest, share = pairs.some(used), _some(nearest, used), share[used]
    by_free = _by_free(net, contact, pairs, nearest)
    spread = parts.solve(np.ascontiguousarray(by_free.T)) * share
    overlap = pairs.thickness - nearest.distance - by_free @ step
    try:
        forces = _pushing(by_free @ spread, known[used], overlap)
    except np.linalg.LinAlgError:  # the force of a pair and its distance fall together
        return step, shape
    pressing = Pressing(pairs=pairs, forces=forces)
    return step + spread @ (forces - known[used]), replace(shape, pressing=pressing)


def _pushing(yields: Array, known: Array, overlap: Array) -> Array:
    """Return the forces >= 0 of pairs without overlaps, N, from those that have overlaps, m.

    Args:
        yields: of the distances to the forces, m/N, (pair, pair).
        known: forces with these overlaps, N, (pair,).
        overlap: m, (pair,).

    Raises:
        numpy.linalg.LinAlgError: the yields are not positive definite.
    """
    root = np.linalg.cholesky((yields + yields.T) / 2 + _INDEPENDENT * yields.diagonal().max() * np.eye(len(yields)))
    return np.asarray(nnls(root.T, root.T @ known + np.linalg.solve(root, overlap))[0])


def _by_free(net: Net, contact: NetContact, pairs: Pairs, nearest: Closest) -> Array:
    """Return the derivatives of the distances of pairs by the free coordinates, (pair, coordinate)."""
    numbers = (3 * pairs.nodes[:, :, None] + np.arange(3)).reshape(-1, 12)
    rows = np.repeat(np.arange(len(numbers)), 12)
    entries = gradients(nearest).ravel()
    by_place = csr_array((entries, (rows, numbers.ravel())), shape=(len(numbers), 3 * contact.points.shape[0]))
    return np.asarray((by_place @ contact.spread)[:, np.flatnonzero(net.free.ravel())].toarray())


def contact_forces(net: Net, shape: NetShape) -> dict[str, float]:
    """Return the sum of the forces between each pair of parts that touch at equilibrium, N, by the names of both.

    A table counts as a part.
    """
    contact, pressing, result = net.contact, shape.pressing, dict[str, float]()
    if net.planes is not None:
        result = net.planes.planes.table_forces(net.planes.depths(shape.positions))
    if contact is None or pressing is None or not len(pressing.forces):
        return result
    pairs, by_parts = pressing.pairs, dict[tuple[int, int], float]()
    forces = _shares(pairs, (contact.points @ shape.positions)[pairs.nodes])[0] * pressing.forces
    for parts, force in zip(contact.parts_of(pairs), forces.tolist(), strict=True):
        by_parts[parts] = by_parts.get(parts, 0.0) + force
    names = contact.parts.names
    touching = {
        f"{names[one]} and {names[other]}": force for (one, other), force in sorted(by_parts.items()) if force > 0
    }
    return touching | result


def touches(net: Net, positions: Array) -> bool:
    """Return whether parts are closer than their thickness at positions of the nodes, m, (node, 3)."""
    if net.contact is None:
        return False
    pairs, nearest, _, _ = _forces(net.contact, net.contact.points @ positions, None)
    return bool(np.any(nearest.distance < pairs.thickness))


def passes_through(net: Net, before: Array, after: Array) -> bool:
    """Return whether parts pass through each other between two positions of the nodes, m, (node, 3) each."""
    if net.contact is None:
        return False
    return net.contact.crossed(net.contact.points @ before, net.contact.points @ after)


def _forces(contact: NetContact, places: Array, pressing: Pressing | None) -> tuple[Pairs, Closest, Array, Array]:
    """Return pairs that may touch, their closest points, their forces f + k (t - d), N, and their multipliers f, N."""
    pairs, known = contact.near(places, pressing)
    nearest = contact.closest(places[pairs.nodes], pairs.of_triangles)
    return pairs, nearest, np.asarray(known + contact.stiffness * (pairs.thickness - nearest.distance)), known


def _some(nearest: Closest, which: Flags) -> Closest:
    """Select closest points of pairs."""
    return Closest(*(values[which] for values in nearest))


def _shares(pairs: Pairs, at: Array) -> tuple[Array, Array]:
    """Return the share of the effect of each pair, from 0 to 1, and its gradient by the positions, 1/m, (pair, 12)."""
    share, changes = np.ones(len(at)), np.zeros((len(at), 12))
    sines, slopes = squared_sines(at[pairs.of_triangles :])
    low, high = _PARALLEL
    rise = np.clip((sines - low) / (high - low), 0.0, 1.0)
    share[pairs.of_triangles :] = rise**2 * (3 - 2 * rise)
    changes[pairs.of_triangles :] = (6 * rise * (1 - rise) / (high - low))[:, None] * slopes.reshape(-1, 12)
    return share, changes
