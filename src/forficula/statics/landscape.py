"""Energy landscapes of a design: one tendon, the wing along its fold, its partly folded states."""

from __future__ import annotations

import difflib
import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from forficula.design import TORQUE, Design
from forficula.errors import InputError
from forficula.quantities import show_quantity
from forficula.statics.equilibrium import PathState, barrier_between
from forficula.statics.fold_path import FoldPath, fold_path
from forficula.statics.hinge import ideal_hinge, wing_hinges
from forficula.statics.hinge_landscape import HingeLandscape, hinge_landscape
from forficula.statics.partial_folds import PartialFold, fold_levels, partial_folds, single_hinge_barriers
from forficula.statics.potential import FOLD, section
from forficula.statics.quasi_static import flat_state, folded_state, least_slow_torque
from forficula.statics.tip_stiffness import TipStiffness, tip_stiffness

Array = NDArray[np.float64]

# torques tried for opening, by the largest moment of a tendon against it
_MOST_UNFOLD = 4.0
_STRAIGHT = math.radians(1)  # what counts as straight


@dataclass(frozen=True, kw_only=True)
class EnergyLandscape:
    """What statics says of a design.

    Attributes:
        design: the design.
        hinge: one ideal hinge, with both bars square to its axis.
        tendons: every hinge of the wing about its true axis, the ring crease, by vein.
        wing: the wing along its fold.
        levels: energies of independent ideal hinges, none to all of them folded, J, (vein + 1,).
        partial_folds: the wing let go with some hinges folded.
        hinge_barriers: energy to climb until one hinge of the flat wing folds alone, J, (vein,).
        fold_torque: least slowly growing torque on every proximal turn axis that folds the compliant wing, N m; None
            where not even the protocol's does.
        unfold_torque: least slowly growing torque on every distal hinge that opens it from folded, N m; None likewise.
        tips: resistance to a load at the tips.
        remarks: sentences on what does not exist, and what to know of the rest.
    """

    design: Design
    hinge: HingeLandscape
    tendons: tuple[HingeLandscape, ...]
    wing: FoldPath
    levels: Array
    partial_folds: tuple[PartialFold, ...]
    hinge_barriers: Array
    fold_torque: float | None
    unfold_torque: float | None
    tips: TipStiffness
    remarks: tuple[str, ...]

    @property
    def fold_barrier(self) -> float | None:
        """Energy to climb from flat to folded along the fold, J; None where one of the two is no stable state."""
        return _barrier_or_none(self, "flat", "folded")

    @property
    def unfold_barrier(self) -> float | None:
        """Energy to climb from folded to flat along the fold, J; None where one of the two is no stable state."""
        return _barrier_or_none(self, "folded", "flat")


@dataclass(frozen=True, kw_only=True)
class StableState:
    """A stable state of the wing along its fold.

    Attributes:
        name: "flat", the first, where the wing is flat or cambered; "folded", the last; "partly folded" between them;
            "anywhere" where nothing moves it all along.
        kind: "stop", pressed onto the end of the path; "minimum"; "neutral", a range without any force.
        pleat_angle: rad; of a neutral range the end nearer to flat.
        far_pleat_angle: the other end of a neutral range, rad; otherwise the pleat angle.
        ring_angle: fold angle of the ring creases there, rad.
        energy: J.
        holding_torque: on every proximal turn axis, that presses it onto the end of the path, N m.
    """

    name: str
    kind: Literal["stop", "minimum", "maximum", "neutral"]
    pleat_angle: float
    far_pleat_angle: float
    ring_angle: float
    energy: float
    holding_torque: float


def energy_landscape(design: Design, points: int = 181) -> EnergyLandscape:
    """Survey the statics of a design.

    Args:
        design: what to build; its protocol says what counts as folded and as opened, and the largest fold torque.
        points: places on every curve.
    """
    hinge = hinge_landscape(ideal_hinge(design), points)
    tendons = tuple(hinge_landscape(each, points) for each in wing_hinges(design))
    wing = fold_path(design, points)
    wings = section([design])
    flat = flat_state(wings)
    fold = least_slow_torque(wings, flat, "fold", design.protocol.fold_torque)
    peak = max((each.peak_opening.torque for each in tendons if each.peak_opening is not None), default=0.0)
    most = max(_MOST_UNFOLD * peak, design.protocol.unfold_torque)
    unfold = least_slow_torque(wings, folded_state(wings), "distal", most)
    fold_torque, unfold_torque = (_known(each.torque[0]) for each in (fold, unfold))
    return EnergyLandscape(
        design=design,
        hinge=hinge,
        tendons=tendons,
        wing=wing,
        levels=fold_levels(design),
        partial_folds=partial_folds(design),
        hinge_barriers=single_hinge_barriers(design),
        fold_torque=fold_torque,
        unfold_torque=unfold_torque,
        tips=tip_stiffness(design),
        remarks=(
            *hinge.remarks,
            *_tendon_remarks(hinge, tendons[0]),
            *wing.remarks,
            *_flat_remarks(flat[0]),
            *_fold_remarks(design, fold_torque, fold.position[0]),
            *_unfold_remarks(most, unfold_torque),
        ),
    )


def stable_states(landscape: EnergyLandscape) -> tuple[StableState, ...]:
    """The stable states of the wing along its fold, from camber to folded."""
    wing = landscape.wing
    stable = [state for state in wing.states if state.stable]
    return tuple(
        StableState(
            name=_name(state, landscape),
            kind=state.kind,
            pleat_angle=state.coordinate,
            far_pleat_angle=state.far_coordinate,
            ring_angle=float(np.interp(state.coordinate, wing.pleat_angle, wing.ring_angle)),
            energy=state.energy,
            holding_torque=state.press * 2 / wing.veins,
        )
        for state in stable
    )


def barrier(landscape: EnergyLandscape, start: str, end: str) -> float:
    """Energy to climb along the fold from one stable state to another, J, all hinges together.

    A wing may climb less where one hinge goes before the others: see `EnergyLandscape.hinge_barriers`.

    Args:
        landscape: of a design.
        start: name of a stable state, such as "flat".
        end: name of another, such as "folded".

    Returns:
        Up to the highest state between them; 0 where it is downhill all along.

    Raises:
        InputError: the wing has no stable state of that name.
    """
    by_name = {state.name: state for state in stable_states(landscape)}
    ends: list[PathState] = []
    for name in (start, end):
        if name not in by_name:
            near = difflib.get_close_matches(name, by_name, 1)
            meant = f', did you mean "{near[0]}"?' if near else ""
            why = "" if near else "".join(f"; {remark}" for remark in landscape.wing.remarks)
            known = ", ".join(by_name)
            raise InputError(
                f'{landscape.design.name}: need a stable state of the wing ({known}), got "{name}"{meant}{why}'
            )
        place = by_name[name].pleat_angle
        ends.append(next(state for state in landscape.wing.states if state.stable and state.coordinate == place))
    return barrier_between(landscape.wing.states, *ends)


def _barrier_or_none(landscape: EnergyLandscape, start: str, end: str) -> float | None:
    names = {state.name for state in stable_states(landscape)}
    return barrier(landscape, start, end) if {start, end} <= names else None


def _name(state: PathState, landscape: EnergyLandscape) -> str:
    wing, folded = landscape.wing, landscape.design.protocol.folded_angle
    ring = float(np.interp(state.far_coordinate, wing.pleat_angle, wing.ring_angle))
    closed = ring >= folded or state.far_coordinate >= math.pi
    if state.coordinate <= 0:
        return "anywhere" if closed else "flat"
    return "folded" if closed else "partly folded"


def _known(value: float) -> float | None:
    return None if math.isnan(value) else float(value)


def _tendon_remarks(ideal: HingeLandscape, tendon: HingeLandscape) -> tuple[str, ...]:
    """What is said of the wing's tendons and not of the ideal one; where both are slack, the angles differ a little."""
    if ideal.hinge.pulls == tendon.hinge.pulls:
        return ()
    return tuple(f"about the wing's own hinge axes {remark}" for remark in tendon.remarks)


def _flat_remarks(angles: Array) -> tuple[str, ...]:
    least = float(angles[FOLD::4].min())
    if least >= -_STRAIGHT:
        return ()
    return (
        f"let go flat, the compliant wing does not stay so: a hinge goes to {math.degrees(least):.4g} deg;"
        " its flat state, and what is said of it, is that",
    )


def _fold_remarks(design: Design, torque: float | None, angles: Array) -> tuple[str, ...]:
    if torque is not None:
        return ()
    reached = f"{math.degrees(float(angles[FOLD::4].max())):.4g} deg"
    return (
        f"no slowly growing torque up to {show_quantity(design.protocol.fold_torque, TORQUE)} folds it, the last hinge"
        f" stops at {reached}: it folds by inertia or not at all, which a run tells",
    )


def _unfold_remarks(most: float, torque: float | None) -> tuple[str, ...]:
    if torque is not None:
        return ()
    return (f"no slowly growing torque up to {show_quantity(most, TORQUE)} on the distal hinges opens it from folded",)
