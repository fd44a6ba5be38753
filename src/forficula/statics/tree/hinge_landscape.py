"""Energy landscape of one hinge: energy and moment over its angle, its stable states, and their properties."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cache, cached_property
from itertools import pairwise
from typing import Literal

import numpy as np
import scipy
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.design.section import ANGLE
from forficula.errors import InputError
from forficula.quantities import show_quantity, show_value
from forficula.statics.tree.equilibrium import PathState, states_along
from forficula.statics.tree.hinge import TendonHinge, slack_angle, tendon_hinge
from forficula.statics.tree.hinge_remarks import hinge_remarks, spring_remarks
from forficula.statics.tree.snap import FOLD_START, final_speed, fold_time, time_scale
from forficula.structure import Structure

_QUIET, _ROUNDING = 1e-9, 1e-13  # share of the largest moment that counts as zero, with and without a spring
_FINE, _COARSE = 1801, 46  # numbers of angles in the search for states and peaks, with and without a spring


@dataclass(frozen=True, kw_only=True)
class PeakTorque:
    """Largest moment against the opening of a hinge.

    Attributes:
        torque: N m, positive.
        angle: angle of that moment, rad.
    """

    torque: float
    angle: float


@dataclass(frozen=True, kw_only=True)
class HingeState:
    """A stable state of a hinge.

    Attributes:
        kind: "stop", pressed onto a stop; "minimum", at least energy between the stops; "neutral", a range over which
            the tendon is slack and nothing moves the hinge.
        angle: rad; for a neutral range, the end nearer to the top, or the overbend stop if the tendon never pulls.
        far_angle: the other end of a neutral range, rad; otherwise the angle.
        energy: J.
        holding_torque: torque that presses the hinge onto its stop, N m; 0 unless the kind is "stop".
    """

    kind: Literal["stop", "minimum", "neutral"]
    angle: float
    far_angle: float
    energy: float
    holding_torque: float


@dataclass(frozen=True, kw_only=True)
class HingeSpring:
    """The hinge's own spring.

    Attributes:
        stiffness: N m/rad.
        rest_angle: rad.
    """

    stiffness: float
    rest_angle: float


@dataclass(frozen=True, kw_only=True)
class HingeLandscape:
    """Energy landscape of a hinge over its whole range. Missing values are None, and the remarks give the reasons.

    Folding angles are negative; multiply by `sense` for the angles of the structure. If the hinge has a spring, energy
    and moment are still those of the tendon alone, and all other values include both.

    Attributes:
        hinge: the hinge with its tendon.
        angle: falling from the overbend to the fold limit, rad, (angle,); includes both ends, straight, the top, and
            the angles at which the tendon goes slack or is shortest.
        energy: J, (angle,).
        moment: positive towards the overbend, N m, (angle,).
        barrier: from the overbend stop to the top, J.
        barrier_angle: angle of the top, rad: straight, unless the tendon's ends are offset.
        holding_torque: torque that presses the hinge onto the overbend stop, N m.
        peak_opening: the largest moment against opening.
        slack_angle: angle beyond which the folding hinge is free, rad.
        states: the stable states, from the overbend to the fold limit.
        time_scale: t*, s.
        growth_rate: at the top, 1/s.
        fold_start: angle past the top from which the fold starts, rad.
        final_speed: at the fold limit, rad/s.
        remarks: sentences on missing values and on limits of the others.
        spring: of the hinge; None without a spring.
    """

    hinge: TendonHinge
    angle: Array
    energy: Array
    moment: Array
    barrier: float | None
    barrier_angle: float | None
    holding_torque: float | None
    peak_opening: PeakTorque | None
    slack_angle: float | None
    states: tuple[HingeState, ...]
    time_scale: float | None
    growth_rate: float | None
    fold_start: float
    final_speed: float | None
    remarks: tuple[str, ...]
    spring: HingeSpring | None = None

    def __repr__(self) -> str:
        """Range of the angle, stable states and barrier."""
        ends = " to ".join(show_quantity(self.sense * float(self.angle[end]), ANGLE) for end in (0, -1))
        return f"<HingeLandscape from {ends}: {_stable_text(self)}>"

    @property
    def sense(self) -> int:
        """Return +1 or -1, the factor that converts these angles to those of the structure's hinge."""
        return self.hinge.sense

    @cached_property
    def fold_time(self) -> float | None:
        """Return the time from the start of the fold to the fold limit, s, by an integral; None with a spring."""
        return self.time_to(self.hinge.fold_limit)

    def time_to(self, angle: float) -> float | None:
        """Return the time from the start of the fold to an angle past straight, rad, at most to the fold limit, s.

        It is None with a spring, and if the hinge does not fold.
        """
        if self.spring is not None:
            return None
        return fold_time(replace(self.hinge, fold_limit=min(angle, self.hinge.fold_limit)), self.fold_start)

    @property
    def spring_energy(self) -> Array:
        """Return the energy of the hinge's spring, J, (angle,)."""
        if self.spring is None:
            return np.zeros_like(self.angle)
        return np.asarray(self.spring.stiffness / 2 * (self.angle - self.spring.rest_angle) ** 2)

    def stored_energy(self, angle: ArrayLike) -> Array:
        """Return the energy of tendon and hinge spring, J, in the shape of `angle` (rad, folding negative)."""
        energy = self.hinge.energy(angle)
        if self.spring is None:
            return energy
        turned = np.asarray(angle, dtype=np.float64) - self.spring.rest_angle
        return np.asarray(energy + self.spring.stiffness / 2 * turned**2)

    @property
    def spring_moment(self) -> Array:
        """Return the moment of the hinge's spring, positive towards the overbend, N m, (angle,)."""
        if self.spring is None:
            return np.zeros_like(self.angle)
        return np.asarray(self.spring.stiffness * (self.spring.rest_angle - self.angle))


def hinge_landscape(
    hinge: TendonHinge,
    points: int = 181,
    fold_start: float = FOLD_START,
    overbend: str = "overbend",
    spring: HingeSpring | None = None,
) -> HingeLandscape:
    """Compute the energy landscape of a hinge along its angle, with or without a spring.

    Times and speeds of the snap are not computed for a hinge with a spring.

    Args:
        hinge: the hinge, folding towards negative angles.
        points: approximate number of angles; there are a few more, because every part between two special angles is
            divided evenly.
        fold_start: angle past the top from which the fold of `fold_time` starts, rad.
        overbend: name of the overbend in sentences.
        spring: of the hinge, with the same sign of angles; None without a spring.

    Raises:
        InputError: fewer than 2 points, or a start that is not > 0.
    """
    angle = special_angles(hinge, points)
    path = _Path(hinge=hinge, spring=spring)
    result = _places(path)
    stable = [place for place in result if place.stable]
    top = _first_maximum(result)
    climbed = top is not None and top is not result[0]
    slack = slack_angle(hinge)
    return HingeLandscape(
        hinge=hinge,
        angle=angle,
        energy=hinge.energy(angle),
        moment=hinge.moment(angle),
        barrier=top.energy - stable[0].energy if top is not None and climbed else None,
        barrier_angle=0.0 - top.coordinate if top is not None and climbed else None,
        holding_torque=_holding_torque(hinge, result[0]),
        peak_opening=_peak(path, top, result),
        slack_angle=slack,
        states=tuple(_hinge_state(hinge, place) for place in stable),
        time_scale=None if spring is not None else time_scale(hinge),
        growth_rate=None if top is None else _growth_rate(path, top),
        fold_start=fold_start,
        final_speed=None if spring is not None else final_speed(hinge, fold_start),
        remarks=hinge_remarks(hinge, fold_start, overbend) if spring is None else spring_remarks(hinge, stable, slack),
        spring=spring,
    )


@dataclass(frozen=True, kw_only=True)
class _Path:
    """A hinge and its spring along the negative angle, which rises during folding.

    Attributes:
        hinge: with its tendon.
        spring: of the hinge; None without a spring.
    """

    hinge: TendonHinge
    spring: HingeSpring | None

    def __call__(self, fold: Array) -> tuple[Array, Array]:
        """Return the energy, J, and its slope, N m."""
        energy, slope = self.hinge.energy(-fold), self.hinge.moment(-fold)
        if self.spring is None:
            return energy, slope
        turned = -fold - self.spring.rest_angle
        return energy + self.spring.stiffness / 2 * turned**2, slope - self.spring.stiffness * turned

    @property
    def places(self) -> int:
        """Return the number of angles to evaluate; for a tendon alone the special angles are always included."""
        return _COARSE if self.spring is None else _FINE

    def curvature(self, fold: float) -> float:
        """Return the second derivative of the energy, N m/rad."""
        return float(self.hinge.stiffness(-fold)) + (0.0 if self.spring is None else self.spring.stiffness)


def _places(path: _Path) -> tuple[PathState, ...]:
    """Return the states of a hinge and the maxima between them, from the overbend to the fold limit."""
    folds = -special_angles(path.hinge, path.places)
    largest = float(np.abs(path(folds)[1]).max())
    if path.spring is not None:
        return states_along(path, folds, force=_QUIET * largest)
    # add a position between any two special ones, at which the moment may be zero
    folds = np.sort(np.concatenate([folds, (folds[1:] + folds[:-1]) / 2]))
    # a range with a slack tendon counts as neutral, however short it is
    return states_along(path, folds, force=_ROUNDING * largest, wide=0.0)


def _first_maximum(states: tuple[PathState, ...]) -> PathState | None:
    """Return the first maximum that a hinge climbs to; else the one at its start, if its overbend is 0."""
    tops = [place for place in states if not place.stable]
    return next((top for top in tops if top is not states[0]), next(iter(tops), None))


def _holding_torque(hinge: TendonHinge, first: PathState) -> float | None:
    """Return the torque that presses a hinge onto its overbend stop; 0 for a slack tendon; None if it does not rest."""
    at_stop = first.stable and first.coordinate == -hinge.overbend
    return first.press if at_stop and (first.kind == "stop" or hinge.pulls) else None


def _peak(path: _Path, top: PathState | None, states: tuple[PathState, ...]) -> PeakTorque | None:
    """Return the largest folding moment between the top, or the overbend stop if the top is beyond it, and the state.

    It is at the zero of the energy's second derivative (Brent 1973), or at the fold limit if the moment still grows
    there.
    """
    hinge, places = path.hinge, [place.coordinate for place in states]
    if top is not None and top is not states[-1]:
        start, end = top.coordinate, places[states.index(top) + 1]
    elif path.spring is None and hinge.pulls and hinge.top_to_overbend < 0:
        start, end = -hinge.overbend, places[0]
    else:
        return None
    folds = np.linspace(start, end, path.places)
    slope = path(folds)[1]
    steepest = int(np.argmin(slope))
    before, after = folds[max(steepest - 1, 0)], folds[min(steepest + 1, len(folds) - 1)]
    fold = float(folds[steepest])
    if path.curvature(before) < 0 < path.curvature(after):
        fold = float(scipy.optimize.brentq(path.curvature, before, after, xtol=1e-15))
    return PeakTorque(torque=-float(path(np.array([fold]))[1][0]), angle=-fold)


def _growth_rate(path: _Path, top: PathState) -> float | None:
    """Compute the rate at which a hinge leaves its top, 1/s: sqrt(-stiffness of tendon and spring / inertia).

    For a linear law without a spring it is sqrt(1 - lambda) / t*, where lambda is the resting length divided by the
    length at the top (docs/model/theory.md, section Snap of a hinge).
    """
    stiffness = path.curvature(top.coordinate)
    return math.sqrt(-stiffness / path.hinge.inertia) if stiffness < 0 else None


def _hinge_state(hinge: TendonHinge, place: PathState) -> HingeState:
    assert place.kind != "maximum"
    ends = 0.0 - place.coordinate, 0.0 - place.far_coordinate
    if hinge.pulls and abs(ends[1] - hinge.top) < abs(ends[0] - hinge.top):
        ends = ends[::-1]
    # a hinge is free only with a slack tendon, whose energy is 0 up to rounding
    energy = 0.0 if place.kind == "neutral" else place.energy
    return HingeState(kind=place.kind, angle=ends[0], far_angle=ends[1], energy=energy, holding_torque=place.press)


@dataclass(frozen=True, kw_only=True)
class CrossedHinge:
    """A hinge that one tendon lies across.

    Attributes:
        tendon: number of the tendon.
        hinge: number of the hinge.
        actual: about its true axis.
        ideal: with both bars perpendicular to the axis; None without bars.
    """

    tendon: int
    hinge: int
    actual: HingeLandscape
    ideal: HingeLandscape | None

    def __repr__(self) -> str:
        """Numbers of the tendon and the hinge, stable states and barrier about the true axis."""
        return f"<CrossedHinge {self.hinge} under tendon {self.tendon}: {_stable_text(self.actual)}>"


def _stable_text(hinge: HingeLandscape) -> str:
    """Return the stable states of a hinge with their energies, and its barrier."""
    states = [
        f"{state.kind} at {show_quantity(hinge.sense * state.angle, ANGLE)} with {show_value(state.energy, 'J')}"
        for state in hinge.states
    ]
    barrier = [] if hinge.barrier is None else [f"barrier {show_value(hinge.barrier, 'J')}"]
    return ", ".join([*states, *barrier]) or "no stable state"


def crossed_hinges(structure: Structure, points: int = 181) -> tuple[CrossedHinge, ...]:
    """Compute the landscape of every hinge that one tendon lies across, in the order of the tendons.

    Equal hinges are computed once.
    """

    @cache
    def survey(hinge: TendonHinge, spring: HingeSpring | None) -> HingeLandscape:
        return hinge_landscape(hinge, points, overbend=structure.appearance.overbend, spring=spring)

    result = []
    for number, tendon in enumerate(structure.tendons):
        if tendon.crossing is None:
            continue
        crossed, actual = structure.hinges[tendon.crossing.hinge], tendon_hinge(structure, tendon, tendon.crossing)
        spring = None
        if crossed.stiffness:
            spring = HingeSpring(stiffness=crossed.stiffness, rest_angle=actual.sense * crossed.rest_angle)
        ideal = None if tendon.ideal is None else survey(tendon_hinge(structure, tendon, tendon.ideal), spring)
        result.append(
            CrossedHinge(tendon=number, hinge=tendon.crossing.hinge, actual=survey(actual, spring), ideal=ideal)
        )
    return tuple(result)


def special_angles(hinge: TendonHinge, points: int) -> Array:
    """Return angles from the overbend to the fold limit, (angle,), evenly spaced between special ones.

    See `HingeLandscape` for the special angles.

    Raises:
        InputError: fewer than 2 points.
    """
    if points < 2:
        raise InputError(f"points: need >= 2, got {points}")
    special = {hinge.overbend, 0.0, -hinge.fold_limit}
    slack, turn = hinge.slack_distance, 2 * math.pi
    apart = {0.0, math.pi, -math.pi}
    if slack is not None:
        apart |= {slack, -slack, turn - slack, slack - turn}
    special |= {angle for place in apart if -hinge.fold_limit < (angle := place - hinge.offset_angle) < hinge.overbend}
    ends = sorted(special, reverse=True)
    spacing = (ends[0] - ends[-1]) / (points - 1)
    parts = [np.linspace(high, low, math.ceil((high - low) / spacing), endpoint=False) for high, low in pairwise(ends)]
    return np.concatenate([*parts, [ends[-1]]])
