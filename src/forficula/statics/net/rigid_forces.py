"""Forces of rigid bars and pins of a net: multipliers that close loops of plates exactly.

Plates are four nodes with stiff bars, and joints are stiff pins. Close to a flat-folded state a loop resists some
motions only by an amount that is proportional to the square of the angle to this state, and stiff parts yield. Bars and
pins of nets with loops are therefore constraints. Their term of the potential is force x stretch + stiffness x
stretch^2 / 2, the augmented Lagrangian (Hestenes 1969, doi 10.1007/BF00927673). At an equilibrium with these forces
they become force + stiffness x stretch, until they change no longer and the stretches have vanished.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from scipy.sparse.linalg import LinearOperator, gmres

from forficula.arrays import Array
from forficula.statics.net.energy import Expansion, expand, expand_at
from forficula.statics.net.factor import Factorisation, factored
from forficula.statics.net.fold_angle import side_lengths
from forficula.statics.net.load import Load
from forficula.statics.net.net import TIGHTER, Net, NetShape, RigidForces

# takes forces on free coordinates, N, in columns, and returns displacements, m
Solve = Callable[[Array], Array]

_CHANGE = 1e-5  # of the largest force: largest change in the last update
_ROUNDING = 1e-14  # of the net's size: a stretch that counts as rounding
_UPDATES = 12  # largest number of updates
_STEPS = 60  # largest number of Newton's method
_HOME = 1e-9  # of the net's size: last step of Newton's method
_FAR = 0.1  # of the net's size: longest step
_SLOW = 0.05  # ratio of two changes beyond which forces follow from Newton's method
_KRYLOV, _MOST_KRYLOV = 1e-6, 40  # relative residual that ends the search for forces, and largest number of steps
# yield of a stretch to its force, relative to that of a bar alone, below which a force depends on other forces
_INDEPENDENT = 1e-5


def with_rigid_forces(net: Net, current: Expansion, solve: Solve | None = None) -> tuple[NetShape, bool]:
    """Return a shape with updated forces of its rigid parts, and whether the updates have ended.

    Where forces converge slowly, they follow from Newton's method on the stretches as functions of the forces
    (Bertsekas 1982, Constrained Optimization and Lagrange Multiplier Methods, section 2.3.2). If the updates end and
    the forces are not `exact`, they do not converge.

    Args:
        net: supported.
        current: expansion about an equilibrium for the forces of its shape.
        solve: returns the displacements of free coordinates under forces, in columns; by default at a constant load.
    """
    springs, shape, before = net.springs, current.shape, current.shape.rigid
    if not any(springs.rigid):
        return shape, True
    bars, pins = springs.rigid_parts
    stiffness, sides = springs.tightened(before), _sides(net, current)
    tension = stiffness[bars] * (side_lengths(sides[:, bars]) - springs.rest_length[bars])
    pull = stiffness[pins] * sides[:, pins]
    if before is None:
        return replace(shape, rigid=RigidForces(bars=tension, pins=pull, change=np.inf)), False
    step = max(np.abs(tension).max(initial=0.0), np.abs(pull).max(initial=0.0))
    largest = max(np.abs(before.bars + tension).max(initial=0.0), np.abs(before.pins + pull).max(initial=0.0))
    rounded = step <= _ROUNDING * net.size * float(stiffness[pins].max(initial=0.0))
    change = 0.0 if rounded else float(step / largest)
    if change > _CHANGE and change > _SLOW * before.change:
        stretches = np.concatenate((tension / stiffness[bars], sides[:, pins].T.ravel()))
        forces = _forces_of(net, _Gradients(net, current), stretches, solve or factored(current.free).solve)
        tension, pull = forces[: len(tension)], forces[len(tension) :].reshape(-1, 3).T
    ended = change <= _CHANGE or before.updates >= _UPDATES
    after = RigidForces(
        bars=before.bars + tension, pins=before.pins + pull, change=change, updates=0 if ended else before.updates + 1
    )
    return replace(shape, rigid=after), ended


def is_exact(net: Net, shape: NetShape) -> bool:
    """Return whether the rigid parts of an equilibrium have their exact lengths, or whether a net has none."""
    return not any(net.springs.rigid) or (shape.rigid is not None and shape.rigid.change <= _CHANGE)


def loop_remarks(net: Net, place: str, shapes: Sequence[NetShape]) -> tuple[str, ...]:
    """Return a remark on equilibria in which loops of facets are not closed exactly; none if all are.

    Args:
        net: the net.
        place: where the equilibria are, as a part of a sentence.
        shapes: at equilibrium.
    """
    count = sum(not is_exact(net, shape) for shape in shapes)
    if not count:
        return ()
    return (
        f"{place}, loops of facets are not closed exactly in {count} of {len(shapes)} equilibria, because the stiff"
        " parts that close them yield: angles, torques and energies of these equilibria are unreliable",
    )


def lost_reason(net: Net) -> str:
    """Return why a path may end before its goal, as a part of a sentence; empty for a net without loops."""
    if not any(net.springs.rigid):
        return ""
    return ": close to a flat-folded state, statics cannot close loops of facets exactly; a run can"


def constrained_index(net: Net, current: Expansion, parts: Factorisation) -> int:
    """Return the number of directions in which the energy falls while rigid parts keep their lengths.

    The Hessian of the augmented Lagrangian may have further negative eigenvalues. These are as many as those of the
    yields of stretches to forces (Haynsworth 1968, doi 10.1016/0024-3795(68)90050-5).

    Args:
        net: supported.
        current: expansion.
        parts: of its Hessian by the free coordinates.
    """
    if not parts.index or current.shape.rigid is None:
        return parts.index
    gradients, moves = _Gradients(net, current), np.zeros((np.count_nonzero(net.free), *net.nodes.shape))
    moves[np.arange(len(moves)), *np.nonzero(net.free)] = 1.0
    slopes = np.stack([gradients.stretches(move) for move in moves], axis=1)
    yields = slopes @ parts.solve(np.ascontiguousarray(slopes.T))
    values = np.linalg.eigvalsh((yields + yields.T) / 2)
    return parts.index - int(np.count_nonzero(values < -_INDEPENDENT * np.abs(values).max()))


def closed(net: Net, current: Expansion, load: Load | None, factor: float) -> Expansion:
    """Return the equilibrium near another one in which rigid parts have their exact lengths, by Newton's method.

    Without convergence it is the other one, with the stretches of stiff parts and without forces of rigid parts.

    Args:
        net: supported.
        current: expansion about an equilibrium at a constant factor.
        load: acting load.
        factor: of the load.
    """
    if not any(net.springs.rigid):
        return current
    shape, ended = with_rigid_forces(net, current)
    if ended and is_exact(net, shape):
        return replace(current, shape=shape)
    exact = exact_equilibrium(net, expand(net, shape, load, factor), load, factor)
    if exact is not None or current.shape.rigid is None:
        return exact or current
    return expand(net, replace(current.shape, rigid=None), load, factor)


def exact_equilibrium(net: Net, start: Expansion, load: Load | None, factor: float) -> Expansion | None:
    """Return the equilibrium near a shape, by Newton's method on shape and forces; None without convergence.

    Args:
        net: supported.
        start: expansion about the shape, with forces of rigid parts.
        load: acting load.
        factor: of the load.
    """
    result = start
    for _ in range(_STEPS):
        positions = result.shape.positions.copy()
        step = factored(result.free).solve(-result.slope[net.free])
        far = float(np.abs(step).max(initial=0.0))
        if not far <= _FAR * net.size:
            break
        positions[net.free] += step
        result = expand_at(net, positions, result.shape, load, factor)
        if far > _HOME * net.size:
            continue
        shape, ended = with_rigid_forces(net, result)
        if ended and not is_exact(net, shape):
            break
        if ended:
            return replace(result, shape=shape)
        result = expand(net, shape, load, factor)
    return None


def rigid_tangent(net: Net, current: Expansion, tangent: Array, parts: Factorisation) -> tuple[Array, Array]:
    """Return the change of displacements with the load factor while rigid parts keep their lengths, m, (node, 3).

    The second result is the change of the forces of bars and, point by point, of pins with the factor, N.

    Args:
        net: supported.
        current: expansion about an equilibrium.
        tangent: change of displacements with the factor at constant forces of rigid parts, m, (node, 3).
        parts: of the Hessian by the free coordinates.
    """
    if current.shape.rigid is None:
        return tangent, np.zeros(0)
    gradients, result = _Gradients(net, current), tangent.copy()
    rates = _forces_of(net, gradients, gradients.stretches(tangent), parts.solve)
    result[net.free] -= parts.solve(gradients.slope(rates)[net.free])
    return result, rates


def with_changed_forces(shape: NetShape, change: Array) -> NetShape:
    """Return a shape whose rigid parts have other forces.

    Args:
        shape: the shape.
        change: of the forces, in the order of `rigid_tangent`, N.
    """
    forces = shape.rigid
    if forces is None:
        return shape
    count = len(forces.bars)
    bars, pins = forces.bars + change[:count], forces.pins + change[count:].reshape(-1, 3).T
    return replace(shape, rigid=replace(forces, bars=bars, pins=pins))


def between_forces(before: NetShape, after: NetShape, share: float) -> NetShape:
    """Return a shape with forces of rigid parts between those of two shapes, at a share of the way to the second."""
    if before.rigid is None or after.rigid is None:
        return before
    bars = before.rigid.bars + share * (after.rigid.bars - before.rigid.bars)
    pins = before.rigid.pins + share * (after.rigid.pins - before.rigid.pins)
    return replace(before, rigid=replace(before.rigid, bars=bars, pins=pins))


def _forces_of(net: Net, gradients: _Gradients, stretches: Array, solve: Solve) -> Array:
    """Return the forces of bars and pins that undo stretches, N, by Krylov's method.

    The stretches per force have few different eigenvalues: 0 where parts depend on each other, the inverse of their
    stiffness, and those of the few motions that they hardly resist.
    """
    size, moved = len(stretches), np.zeros_like(net.nodes)
    least = _INDEPENDENT / (TIGHTER * net.springs.stiffness[net.springs.rigid_parts[0].start])

    def yielding(forces: Array) -> Array:
        moved[net.free] = solve(gradients.slope(forces)[net.free])
        return np.asarray(gradients.stretches(moved) + least * forces)

    yields = LinearOperator((size, size), matvec=yielding, dtype=np.float64)
    return np.asarray(gmres(yields, stretches, rtol=_KRYLOV, restart=_MOST_KRYLOV, maxiter=1)[0])


class _Gradients:
    """Gradients of the lengths of bars and of the sides of pins by the positions of nodes."""

    def __init__(self, net: Net, current: Expansion) -> None:
        bars, pins = net.springs.rigid_parts
        sides = _sides(net, current)[:, bars]
        self._spread, self._count = current.layout.sides[bars.start : pins.stop], bars.stop - bars.start
        self._units = (sides / side_lengths(sides)).T

    def stretches(self, moved: Array) -> Array:
        """Return the stretches of bars and, point by point, of pins under displacements, m, (node, 3)."""
        apart = self._spread @ moved
        return np.concatenate((np.sum(self._units * apart[: self._count], axis=1), apart[self._count :].ravel()))

    def slope(self, forces: Array) -> Array:
        """Return the gradient of forces x stretches by the nodes, N, (node, 3)."""
        pulls = np.concatenate((self._units * forces[: self._count, None], forces[self._count :].reshape(-1, 3)))
        return np.asarray(self._spread.T @ pulls)


def _sides(net: Net, current: Expansion) -> Array:
    """Return the sides of springs, m, (3, spring)."""
    count = len(net.springs.points)
    return np.asarray((current.layout.sides[:count] @ current.shape.positions).T)
