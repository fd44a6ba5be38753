"""Equilibria of a net: the energy minimum reached downhill from a shape, and the stationary point nearest to it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import csc_array

from forficula.arrays import Array
from forficula.statics.net.contact.contact_energy import constrained_step, passes_through, with_contact_forces
from forficula.statics.net.energy import Expansion, expand, expand_at, remembered
from forficula.statics.net.factor import Factorisation, Matrix, definite, factored, largest_entry
from forficula.statics.net.load import Load, check_load
from forficula.statics.net.net import TIGHTER, Net, NetShape
from forficula.statics.net.rigid_forces import closed, constrained_index, exact_equilibrium
from forficula.statics.net.supports import supported

_MOST_STEPS = 2000
_CORRECTIONS = 7
_MOST_CORRECTIONS = 50  # of a stationary point
_SMALLEST_SHIFT, _LARGEST_SHIFT = 1e-9, 1e3  # of the largest stiffness
_DRAG = 1e-4  # dampers on all coordinates of a large net, relative to those between nodes
_SHARE = 0.8  # of the longest step that a large net shall take
_HOME = 1e-9  # step that ends the search, of the net's size
_EXACT = 1e-12  # the same with contact
_NEAR = 0.02  # of the net's size: largest distance to an equilibrium of loops that Newton's method finds at once
_PUSH = 1e-3
_ROUNDING = 1e-13
# stiffness below this share of the largest one counts as zero
_NEUTRAL = 1e-11


@dataclass(frozen=True, kw_only=True, eq=False)
class NetRest:
    """An equilibrium of a net.

    Attributes:
        shape: shape of the net.
        energy: stored energy, including that of the weight (0 at the origin), J.
        slope: largest residual force on a free coordinate, N.
        index: number of directions in which the energy falls: 0 at a minimum, 1 at a saddle between two minima.
        neutral: number of further directions without stiffness.
        pins: coordinates, pairs of node and axis, held to remove rigid-body motions.
        steps: number of steps taken.
        settled: whether the search converged.
    """

    shape: NetShape
    energy: float
    slope: float
    index: int
    neutral: int
    pins: tuple[tuple[int, int], ...]
    steps: int
    settled: bool

    @property
    def stable(self) -> bool:
        """Return whether the net stays at the equilibrium after any small push."""
        return self.settled and self.index == 0 and self.neutral == 0


def minimum(
    net: Net,
    start: NetShape,
    load: Load | None = None,
    factor: float = 0.0,
    *,
    longest_step: float | None = None,
    between_nodes: bool = False,
    stop: Callable[[NetShape], bool] | None = None,
) -> NetRest:
    """Find the energy minimum that is reached by descending from a shape.

    Every step minimises the energy plus shift / 2 |step|^2 by Newton's method (proximal steps, Rockafellar 1976, which
    follow a slow motion with equal dampers on all coordinates). The corrections restore the lengths of stiff bars
    before the energy is compared. The shift decreases to 0, so that the last steps are those of Newton's method.

    Args:
        net: need not be supported if the load moves no rigid body; see `supported`.
        start: start shape.
        load: acting load; its displacements are not applied to the start.
        factor: of the load.
        longest_step: of any coordinate, m; None for a tenth of the net's size.
        between_nodes: whether the dampers of a large net connect neighbouring nodes, and those on all coordinates are
            weak. A sheet then comes to rest in a fraction of the steps, because its far end moves along instead of
            being held back while the sheet buckles in between. The minimum may be another one.
        stop: ends the search, not settled, at the first shape for which it returns True.

    Raises:
        InputError: the load does not fit, or would move the net as a rigid body.
    """
    if load is not None:
        check_load(net, load)
    net, pins = supported(net, load)
    longest = longest_step if longest_step is not None else net.size / 10
    if start.rigid is not None and net.contact is None:
        # stiff parts without forces would yield where exact ones hold
        exact = exact_equilibrium(net, expand(net, start, load, factor), load, factor)
        if exact is not None and np.abs(exact.shape.positions - start.positions).max() <= _NEAR * net.size:
            rest = _rest(net, exact, pins, 1, True)
            if rest.stable:
                return rest
    current, shift, steps, settled = expand(net, replace(start, rigid=None), load, factor), 0.0, 0, False
    dampers = current.layout.dampers if between_nodes and not isinstance(current.free, np.ndarray) else None
    parts, most, before = definite(current.free), 0.0, np.inf
    while steps < _MOST_STEPS and not settled and not (stop is not None and stop(current.shape)):
        steps += 1
        stiffest = float(current.free.diagonal().max(initial=0.0)) or 1.0
        # largest value so far, because at an inflection a net of few coordinates has no stiffness
        most = max(most, _LARGEST_SHIFT * stiffest)
        while parts is None and shift <= most:
            shift = _raised(shift, stiffest)
            parts = definite(*_damped(current, dampers, shift))
        if parts is None:
            parts = factored(*_damped(current, dampers, shift))
        taken, corrections = _proximal_step(net, current, parts, (shift, dampers), load, factor, longest)
        if taken is None:
            if shift > most:
                break
            shift = _raised(shift, stiffest)
        else:
            moved = float(np.abs(taken.shape.positions - current.shape.positions).max())
            near = _is_near(net, moved, before)
            before, current = moved, taken
            # while a shift remains, the shape is a minimum only if no force is left
            pushed = np.abs(current.slope[net.free]).max(initial=0.0) > _PUSH * _HOME * net.size * stiffest
            settled = near and (shift <= _SMALLEST_SHIFT * stiffest or not pushed)
            # a step that exceeds the longest one costs a factorisation
            divisor = 10.0 if dampers is None else min(10.0, max(1.0, _SHARE * longest / max(moved, 1e-300)))
            shift = shift / divisor if corrections <= 2 else shift / 2 if corrections <= 3 else shift
            shift = 0.0 if shift < _SMALLEST_SHIFT * stiffest else shift
            if settled:
                current, settled = _with_contact_forces(net, current, load, factor)
        parts = definite(*_damped(current, dampers, shift))
    return _rest(net, closed(net, current, load, factor) if settled else current, pins, steps, settled)


def stationary(net: Net, start: NetShape, load: Load | None = None, factor: float = 0.0) -> NetRest:
    """Find the equilibrium near a shape, stable or not, by Newton's method on the gradient.

    Args:
        net: as for `minimum`.
        start: shape near the equilibrium.
        load: acting load; its displacements are not applied to the start.
        factor: of the load.
    """
    net, pins = supported(net, load)
    current, settled, steps, before = expand(net, start, load, factor), False, 0, np.inf
    while steps < _MOST_CORRECTIONS and not settled:
        parts = factored(current.free)
        step, shape = constrained_step(net, current.shape, parts, -parts.solve(current.slope[net.free]))
        most = float(np.abs(step).max(initial=0.0))
        settled = _is_near(net, most, before)
        current = _moved(net, shape, step * min(1.0, 0.05 * net.size / max(most, 1e-300)), load, factor)
        if settled and net.contact is not None:
            with_forces, settled = with_contact_forces(net, current.shape, factored(current.free))
            current = replace(current, shape=with_forces) if settled else current
        steps, before = steps + 1, most
    return _rest(net, closed(net, current, load, factor) if settled else current, pins, steps, settled)


def _is_near(net: Net, moved: float, before: float) -> bool:
    """Return whether the last step, m, ends a search, from the step before it."""
    near = moved <= _HOME * net.size
    # contact forces are as exact as the shape; rounding may keep steps from getting shorter
    return near and (net.contact is None or moved <= _EXACT * net.size or 2 * moved > before)


def _with_contact_forces(net: Net, current: Expansion, load: Load | None, factor: float) -> tuple[Expansion, bool]:
    """Return an expansion with updated contact forces, and whether they had already converged."""
    if net.contact is None:
        return current, True
    shape, converged = with_contact_forces(net, current.shape, factored(current.free))
    return (replace(current, shape=shape), True) if converged else (expand(net, shape, load, factor), False)


def _rest(net: Net, current: Expansion, pins: tuple[tuple[int, int], ...], steps: int, settled: bool) -> NetRest:
    near = _NEUTRAL * largest_entry(current.free) / (1 if current.shape.rigid is None else TIGHTER)
    index = constrained_index(net, current, factored(current.free, near))
    return NetRest(
        shape=remembered(net, current.shape),
        energy=current.stored,
        slope=float(np.abs(current.slope[net.free]).max(initial=0.0)),
        index=index,
        neutral=constrained_index(net, current, factored(current.free, -near)) - index,
        pins=pins,
        steps=steps,
        settled=settled,
    )


def _raised(shift: float, stiffest: float) -> float:
    return max(10 * shift, _SMALLEST_SHIFT * stiffest)


def _damped(current: Expansion, dampers: Array | None, shift: float) -> tuple[Matrix, float]:
    """Return the Hessian with dampers of a size, as a matrix and a multiple of the identity to add."""
    if dampers is None or isinstance(current.free, np.ndarray):
        return current.free, shift
    if current.pressed is not None:
        return csc_array(current.free + shift * current.layout.damping), _DRAG * shift
    return _like(current.free, current.free.data + shift * dampers), _DRAG * shift


def _resistance(current: Expansion, dampers: Array | None, step: Array) -> Array:
    """Return the forces of dampers of size 1 for a step, (coordinate,)."""
    if dampers is None or isinstance(current.free, np.ndarray):
        return step
    return np.asarray(current.layout.damping @ step + _DRAG * step)


def _like(matrix: csc_array, entries: Array) -> csc_array:
    """Return a matrix with the pattern of another."""
    return csc_array((entries, matrix.indices, matrix.indptr), shape=matrix.shape)


def _moved(net: Net, shape: NetShape, step: Array, load: Load | None, factor: float) -> Expansion:
    positions = shape.positions.copy()
    positions[net.free] += step
    return expand_at(net, positions, shape, load, factor)


def _proximal_step(
    net: Net,
    current: Expansion,
    parts: Factorisation,
    damping: tuple[float, Array | None],
    load: Load | None,
    factor: float,
    longest: float,
) -> tuple[Expansion | None, int]:
    """Return the expansion about a shape of less energy, None if the step fails, and the number of corrections."""
    shift, dampers = damping
    down = -current.slope[net.free]
    step = parts.solve(down)
    promise, steepest = float(down @ step) / 2, np.abs(down).max(initial=0.0)
    for corrections in range(_CORRECTIONS):
        if not np.abs(step).max(initial=0.0) <= longest:
            return None, corrections
        following = _moved(net, current.shape, step, load, factor)
        slope = following.slope[net.free]
        resisting = _resistance(current, dampers, step)
        gain = current.energy - following.energy - shift / 2 * float(step @ resisting)
        rounded = abs(gain) <= _rounding(net, current) and np.abs(slope).max(initial=0.0) <= 2 * steepest
        if gain >= 0.1 * promise or rounded:
            crossed = passes_through(net, current.shape.positions, following.shape.positions)
            return None if crossed else following, corrections
        if not np.all(np.isfinite(slope)):
            return None, corrections
        step = step - factored(*_damped(following, dampers, shift)).solve(slope + shift * resisting)
    return None, _CORRECTIONS


def _rounding(net: Net, current: Expansion) -> float:
    """Return the difference of energies that counts as rounding."""
    stiffest = largest_entry(current.free)
    return _ROUNDING * (abs(current.energy) + abs(current.stored) + stiffest * _HOME * net.size**2)
