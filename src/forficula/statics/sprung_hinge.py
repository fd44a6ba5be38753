"""A hinge that has a spring of its own under the tendon that lies across it: where the two let it rest, and why."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.statics.equilibrium import PathState, states_along
from forficula.statics.hinge import PeakTorque, TendonHinge, slack_angle
from forficula.statics.hinge_landscape import (
    HingeLandscape,
    HingeSpring,
    HingeState,
    degrees,
    special_angles,
    why_no_pull,
)
from forficula.statics.snap import FOLD_START

_QUIET = 1e-9  # of the largest moment, what counts as none
_FINE = 1801  # angles among which states are looked for


def sprung_landscape(hinge: TendonHinge, spring: HingeSpring, points: int = 181) -> HingeLandscape:
    """Survey a hinge with a spring of its own, whose moment no closed form has: all is found along the angle.

    The barrier is that from the first state, towards the overbend, to the next one; its top is where the sum of both
    energies is largest. How fast it snaps is left open.

    Args:
        hinge: the hinge, folding towards negative angles.
        spring: of the hinge, its angles counted alike.
        points: how many angles to aim at.

    Raises:
        InputError: fewer than 2 points.
    """
    angle = special_angles(hinge, points)
    found = _states(hinge, spring, -special_angles(hinge, _FINE))
    stable = [state for state in found if state.stable]
    top = _first_top(found)
    first = stable[0]
    pressed = first.kind == "stop" and first.coordinate == -hinge.overbend
    peak = None if top is None else _peak(hinge, spring, top, _next_stable(found, top))
    slack = slack_angle(hinge)
    return HingeLandscape(
        hinge=hinge,
        angle=angle,
        energy=hinge.energy(angle),
        moment=hinge.moment(angle),
        barrier=None if top is None else top.energy - first.energy,
        barrier_angle=None if top is None else 0.0 - top.coordinate,
        holding_torque=first.press if pressed else None,
        peak_opening=peak,
        slack_angle=slack,
        states=tuple(_hinge_state(state) for state in stable),
        time_scale=None,
        growth_rate=None if top is None else _growth_rate(hinge, spring, top),
        fold_start=FOLD_START,
        final_speed=None,
        remarks=_remarks(hinge, stable, slack),
        spring=spring,
    )


def _path(hinge: TendonHinge, spring: HingeSpring) -> Callable[[Array], tuple[Array, Array]]:
    """Energy of both, and its slope, over the angle turned round, so that folding rises."""

    def path(fold: Array) -> tuple[Array, Array]:
        turned = -fold - spring.rest_angle
        energy = hinge.energy(-fold) + spring.stiffness / 2 * turned**2
        return energy, hinge.moment(-fold) - spring.stiffness * turned

    return path


def _states(hinge: TendonHinge, spring: HingeSpring, folds: Array) -> tuple[PathState, ...]:
    path = _path(hinge, spring)
    return states_along(path, folds, force=_QUIET * float(np.abs(path(folds)[1]).max()))


def _first_top(found: tuple[PathState, ...]) -> PathState | None:
    """The first place from which the energy falls to either side."""
    return next((one for before, one, _ in _triples(found) if before.stable and not one.stable), None)


def _next_stable(found: tuple[PathState, ...], top: PathState) -> PathState:
    return next(after for one, after in pairwise(found) if one is top)


def _triples(found: tuple[PathState, ...]) -> list[tuple[PathState, PathState, PathState]]:
    return list(zip(found, found[1:], found[2:], strict=False))


def _peak(hinge: TendonHinge, spring: HingeSpring, top: PathState, folded: PathState) -> PeakTorque:
    """The largest moment that folds it between its top and the state behind it."""
    path = _path(hinge, spring)

    def slope(fold: float) -> float:
        return float(path(np.array([fold]))[1][0])

    folds = np.linspace(top.coordinate, folded.coordinate, _FINE)
    steepest = int(np.argmin(path(folds)[1]))
    around = folds[max(steepest - 1, 0)], folds[min(steepest + 1, len(folds) - 1)]
    best = scipy.optimize.minimize_scalar(slope, bounds=around, method="bounded", options={"xatol": 1e-12})
    fold = min((float(folds[steepest]), float(best.x)), key=slope)
    return PeakTorque(torque=-slope(fold), angle=-fold)


def _growth_rate(hinge: TendonHinge, spring: HingeSpring, top: PathState) -> float | None:
    """Rate at which the hinge leaves its top, 1/s: sqrt(-stiffness of both / inertia)."""
    stiffness = float(hinge.stiffness(-top.coordinate)) + spring.stiffness
    return math.sqrt(-stiffness / hinge.inertia) if stiffness < 0 else None


def _hinge_state(state: PathState) -> HingeState:
    assert state.kind != "maximum"
    return HingeState(
        kind=state.kind,
        angle=0.0 - state.coordinate,
        far_angle=0.0 - state.far_coordinate,
        energy=state.energy,
        holding_torque=state.press,
    )


def _remarks(hinge: TendonHinge, stable: list[PathState], slack: float | None) -> tuple[str, ...]:
    if not hinge.pulls:
        return (why_no_pull(hinge, "the spring of its hinge is all that moves it, and there is no barrier"),)
    remarks = []
    if len(stable) == 1:
        remarks.append(
            "the tendon and the spring of its hinge let it rest at one place only,"
            f" {degrees(-hinge.sense * stable[0].coordinate)}, so there is no barrier; a stiffer or shorter tendon, or"
            " a softer spring, gives one"
        )
    if slack is not None:
        remarks.append(
            f"the tendon is slack beyond {degrees(hinge.sense * slack)} of the fold: the spring of its hinge is all"
            " that moves it there"
        )
    return tuple(remarks)
