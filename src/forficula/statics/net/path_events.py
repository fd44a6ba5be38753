"""Events on the path of a net under a growing load: limits of the load and bifurcations."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from forficula.arrays import Array
from forficula.statics.net.energy import expand
from forficula.statics.net.factor import softest
from forficula.statics.net.load import Load
from forficula.statics.net.net import Net
from forficula.statics.net.path_increment import HALVINGS, PathPoint, PathStation, increment

_ITERATIONS = 3  # of a vector towards the softest mode
_SAME = 1e-3  # as a share of the increment: two events at this distance are one


@dataclass(frozen=True, kw_only=True, eq=False)
class PathEvent:
    """Point of a path at which the index changes or the load factor has an extremum.

    Attributes:
        kind: "limit", an extremum of the load, from which the net snaps; "bifurcation", where another path crosses.
        after: number of the point before the event.
        point: the equilibrium at the event.
        mode: direction in which stiffness is lost, the largest coordinate 1, (node, 3); at a bifurcation, the direction
            of the other path.
    """

    kind: Literal["limit", "bifurcation"]
    after: int
    point: PathPoint
    mode: Array


def events_between(
    net: Net, load: Load, current: PathStation, following: PathStation, length: float, after: int
) -> list[PathEvent]:
    """Return the events within an increment, in order."""
    brackets = list[_Bracket]()
    limit, indices = following.point.rising != current.point.rising, (current.point.index, following.point.index)
    if limit:
        brackets.append(
            _bracket(
                net,
                load,
                (current, following),
                length,
                passed=lambda station: station.point.rising != current.point.rising,
                measure=lambda station: station.pace,
            )
        )
    # at a limit the index changes as well
    if indices[0] != indices[1] and not any(bracket.indices == indices for bracket in brackets):
        mode = _softest_mode(net, following)
        bracket = _bracket(
            net,
            load,
            (current, following),
            length,
            passed=lambda station: station.point.index != indices[0],
            measure=lambda station: 1 / float(mode @ station.parts.solve(mode)),
        )
        if not any(abs(bracket.place - other.place) <= _SAME * length for other in brackets):
            brackets.append(bracket)
    events = list[tuple[float, PathEvent]]()
    for number, bracket in enumerate(brackets):
        # an increment may not converge exactly where stiffness is lost, but one just short of it does
        point = (bracket.after or (following if bracket.before is current else bracket.before)).point
        mode = np.zeros_like(net.nodes)
        mode[net.free] = softest(expand(net, point.shape, load, point.factor).free, 1)[1][:, 0]
        events.append(
            (
                bracket.place,
                PathEvent(
                    kind="limit" if limit and number == 0 else "bifurcation",
                    after=after,
                    point=point,
                    mode=mode / mode.flat[np.argmax(np.abs(mode))],
                ),
            )
        )
    return [event for _, event in sorted(events, key=lambda entry: entry[0])]


def _softest_mode(net: Net, station: PathStation) -> Array:
    """Return about the direction of free coordinates that is the softest at a point, by inverse iteration."""
    mode = np.random.default_rng(0).standard_normal(np.count_nonzero(net.free))
    for _ in range(_ITERATIONS):
        mode = station.parts.solve(mode)
        mode = mode / np.linalg.norm(mode)
    return mode


class _Bracket(NamedTuple):
    """Short part of an increment that contains an event.

    Attributes:
        before: point just before the event.
        after: point just after the event; None if no increment converges there.
        place: length at which the event has passed.
    """

    before: PathStation
    after: PathStation | None
    place: float

    @property
    def indices(self) -> tuple[int, int] | None:
        """Return the indices before and after the event; None if no increment converges after the event."""
        return None if self.after is None else (self.before.point.index, self.after.point.index)


def _bracket(
    net: Net,
    load: Load,
    ends: tuple[PathStation, PathStation],
    length: float,
    *,
    passed: Callable[[PathStation], bool],
    measure: Callable[[PathStation], float],
) -> _Bracket:
    """Locate an event within an increment, on a grid of 2^`HALVINGS` equal parts.

    The method is regula falsi with halved weights (Dowell and Jarratt 1971, doi 10.1007/BF01934364). Every third step
    halves the bracket, which converges for any function. If an increment does not converge, halving starts again.

    Args:
        net: supported.
        load: at a factor of 1.
        ends: points before and after the increment.
        length: of the increment.
        passed: whether a point is beyond the event.
        measure: number whose sign changes at the event without a jump.
    """
    whole = 2**HALVINGS
    stations: dict[int, PathStation | None] = {0: ends[0], whole: ends[1]}
    low, high, last, number, interpolates = 0, whole, 0, 0, True
    below, above = abs(measure(ends[0])), abs(measure(ends[1]))
    while high - low > 1:
        middle = (low + high) // 2
        if interpolates and number % 3 < 2 and 0 < below + above < np.inf:
            zero = low + (high - low) * below / (below + above)
            # rounded away from the nearer end, so that both ends approach the zero
            zero = math.ceil(zero) if zero < middle else math.floor(zero)
            middle = min(max(zero, low + 1), high - 1)
        number += 1
        if middle not in stations:
            stations[middle] = increment(net, load, ends[0], length * middle / whole)
        station = stations[middle]
        if station is None and interpolates:
            low, high, interpolates = 0, whole, False
        elif station is None or passed(station):
            below = below / 2 if last > 0 else below
            high, last, above = middle, 1, math.inf if station is None else abs(measure(station))
        else:
            above = above / 2 if last < 0 else above
            low, last, below = middle, -1, abs(measure(station))
    before = stations[low]
    assert before is not None
    return _Bracket(before=before, after=stations[high], place=length * high / whole)
