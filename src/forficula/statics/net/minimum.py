"""Where a net rests: the minimum downhill from a shape, and the stationary point beside it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.statics.net.energy import Expansion, expand, shape_at
from forficula.statics.net.factor import Factorisation, factored
from forficula.statics.net.load import Load, check_load
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.supports import supported

_MOST_STEPS = 2000
_CORRECTIONS = 7
_SMALLEST_SHIFT, _LARGEST_SHIFT = 1e-9, 1e3  # of the largest stiffness
_HOME = 1e-9  # step that ends the search, of the net's size
_PUSH = 1e-3
_ROUNDING = 1e-13
# a curvature below this share of the largest one is none
_NEUTRAL = 1e-11


@dataclass(frozen=True, kw_only=True, eq=False)
class NetRest:
    """Where a net is in equilibrium.

    Attributes:
        shape: there.
        energy: stored, that of the weight included (0 at z = 0), J.
        slope: the largest force on a free coordinate that is left, N.
        index: how many ways lead downhill: 0 at a minimum, 1 at a saddle between two.
        neutral: how many more ways lead along no slope at all.
        pins: coordinates, pairs of node and axis, held to take away motions of the whole.
        steps: taken.
        settled: whether the last step was none.
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
        """Whether it stays there after any small push."""
        return self.settled and self.index == 0 and self.neutral == 0


def minimum(
    net: Net,
    start: NetShape,
    load: Load | None = None,
    factor: float = 0.0,
    *,
    longest_step: float | None = None,
    stop: Callable[[NetShape], bool] | None = None,
) -> NetRest:
    """Go downhill to rest.

    Every step minimises the energy plus shift / 2 |step|^2 (proximal steps, Rockafellar 1976, which follow the way of a
    slow motion that equal dampers brake) by Newton's method, whose corrections bring stiff bars back to their lengths
    before the energy is judged; the shift falls to 0, and the end is Newton's.

    Args:
        net: not held as a whole where nothing acts on that; see `supported`.
        start: m.
        load: that acts; its displacements are not applied to the start.
        factor: times which it does.
        longest_step: of any coordinate, m; None for a tenth of the net's size.
        stop: ends it on the way, not settled, at the first shape for which it says so.

    Raises:
        InputError: the load does not fit, or would carry the whole away.
    """
    if load is not None:
        check_load(net, load)
    net, pins = supported(net, load)
    longest = longest_step if longest_step is not None else net.size / 10
    here, shift, steps, settled = expand(net, start, load, factor), 0.0, 0, False
    parts, most = factored(here.free), 0.0
    while steps < _MOST_STEPS and not settled and not (stop is not None and stop(here.shape)):
        steps += 1
        stiffest = float(here.free.diagonal().max(initial=0.0)) or 1.0
        # of the way so far: where a net of few coordinates goes over an inflection, nothing is stiff
        most = max(most, _LARGEST_SHIFT * stiffest)
        while parts.index and shift <= most:
            shift = _raised(shift, stiffest)
            parts = factored(here.free, shift)
        taken, corrections = _proximal_step(net, here, parts, shift, load, factor, longest)
        if taken is None:
            if shift > most:
                break
            shift = _raised(shift, stiffest)
        else:
            near = bool(np.abs(taken.positions - here.shape.positions).max() <= _HOME * net.size)
            here = expand(net, taken, load, factor)
            # where a shift remains, it is no minimum: it rests there only if nothing pushes
            pushed = np.abs(here.slope[net.free]).max(initial=0.0) > _PUSH * _HOME * net.size * stiffest
            settled = near and (shift <= _SMALLEST_SHIFT * stiffest or not pushed)
            shift = shift / 10 if corrections <= 2 else shift / 2 if corrections <= 3 else shift
            shift = 0.0 if shift < _SMALLEST_SHIFT * stiffest else shift
        parts = factored(here.free, shift)
    return _rest(net, here, pins, steps, settled)


def stationary(net: Net, start: NetShape, load: Load | None = None, factor: float = 0.0) -> NetRest:
    """The equilibrium beside a shape, stable or not, by Newton's method on the slope.

    Args:
        net: as for `minimum`.
        start: near by.
        load: that acts; its displacements are not applied to the start.
        factor: times which it does.
    """
    net, pins = supported(net, load)
    here, settled, steps = expand(net, start, load, factor), False, 0
    while steps < 50 and not settled:
        step = -factored(here.free).solve(here.slope[net.free])
        most = np.abs(step).max(initial=0.0)
        settled = bool(most <= _HOME * net.size)
        here = expand(net, _moved(net, here.shape, step * min(1.0, 0.05 * net.size / max(most, 1e-300))), load, factor)
        steps += 1
    return _rest(net, here, pins, steps, settled)


def _rest(net: Net, here: Expansion, pins: tuple[tuple[int, int], ...], steps: int, settled: bool) -> NetRest:
    near = _NEUTRAL * float(np.abs(here.free.data).max(initial=0.0))
    index = factored(here.free, near).index
    return NetRest(
        shape=here.shape,
        energy=here.stored,
        slope=float(np.abs(here.slope[net.free]).max(initial=0.0)),
        index=index,
        neutral=factored(here.free, -near).index - index,
        pins=pins,
        steps=steps,
        settled=settled,
    )


def _raised(shift: float, stiffest: float) -> float:
    return max(10 * shift, _SMALLEST_SHIFT * stiffest)


def _moved(net: Net, shape: NetShape, step: Array) -> NetShape:
    positions = shape.positions.copy()
    positions[net.free] += step
    return shape_at(net, positions, shape.angles)


def _proximal_step(
    net: Net, here: Expansion, parts: Factorisation, shift: float, load: Load | None, factor: float, longest: float
) -> tuple[NetShape | None, int]:
    """A shape of less energy, None where the step does not get there, and how many corrections it took."""
    down = -here.slope[net.free]
    step = parts.solve(down)
    promise, steepest = float(down @ step) / 2, np.abs(down).max(initial=0.0)
    for corrections in range(_CORRECTIONS):
        if not np.abs(step).max(initial=0.0) <= longest:
            return None, corrections
        there = expand(net, _moved(net, here.shape, step), load, factor)
        slope = there.slope[net.free]
        gain = here.energy - there.energy - shift / 2 * float(step @ step)
        rounded = abs(gain) <= _rounding(net, here) and np.abs(slope).max(initial=0.0) <= 2 * steepest
        if gain >= 0.1 * promise or rounded:
            return there.shape, corrections
        if not np.all(np.isfinite(slope)):
            return None, corrections
        step = step - factored(there.free, shift).solve(slope + shift * step)
    return None, _CORRECTIONS


def _rounding(net: Net, here: Expansion) -> float:
    """Differences of energy that are those of its last digits."""
    stiffest = float(np.abs(here.free.data).max(initial=0.0))
    return _ROUNDING * (abs(here.energy) + abs(here.stored) + stiffest * _HOME * net.size**2)
