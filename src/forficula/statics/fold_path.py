"""The wing along its fold: energy over the pleat angle, from camber through flat to folded."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicHermiteSpline

from forficula.design import Design
from forficula.pattern import EarwigFan
from forficula.statics.equilibrium import Equilibria, PathState, states_along
from forficula.statics.potential import FOLD, LIFT, SWEEP, TURN, Section, rest, section
from forficula.statics.sheet import sheet_energy

Array = NDArray[np.float64]

# Moment that counts as none: of the tendons' largest about the ring, or, where they have none, of E t l^2 of the
# membrane.
_QUIET, _QUIET_SHEET = 1e-3, 1e-4
# how often places learn from their neighbours, and energy that counts as none, of the largest
_PASSES, _ROUNDING = 8, 1e-12


@dataclass(frozen=True, kw_only=True)
class FoldPath:
    """A wing along the one way in which rigid panels fold (theory.md, section 2, mode I).

    The pleat angle is the fold angle of the veins; it is negative where the overbend bends them backwards. Veins turn
    by half of it and the distal hinges fold with the ring creases. Sweep and lift of the veins, which the panels' way
    leaves open because the hub points stay where they are, go to where the membrane is stretched least.

    Attributes:
        pleat_angle: rising, rad, (place,).
        ring_angle: fold angle of the ring creases, of its sign, rad, (place,).
        tendon_energy: of all tendons, J, (place,).
        sheet_energy: of membrane and guards, J, (place,).
        moment: about the pleats, -d energy / d pleat angle, N m, (place,).
        fold_slope: d ring angle / d pleat angle, (place,).
        quiet: moment that counts as none, N m, (place,).
        veins: how many.
        states: where the wing rests, in the order of the pleat angle.
        remarks: sentences on what to know of it.
    """

    pleat_angle: Array
    ring_angle: Array
    tendon_energy: Array
    sheet_energy: Array
    moment: Array
    fold_slope: Array
    quiet: Array
    veins: int
    states: tuple[PathState, ...]
    remarks: tuple[str, ...]

    @property
    def energy(self) -> Array:
        """Of tendons, membrane and guards, J, (place,)."""
        return self.tendon_energy + self.sheet_energy

    @property
    def fold_torque(self) -> float:
        """Least torque on every proximal turn axis that takes the wing along, from its first state to folded, N m.

        The steepest climb, shared by the veins, which turn by half the pleat angle.
        """
        climbs = np.where(-self.moment > self.quiet, -self.moment, 0.0)
        return float(climbs.max()) * 2 / self.veins

    @property
    def unfold_torque(self) -> float | None:
        """Least torque on every distal hinge that takes it back, N m; None where the ring does not move on the way."""
        moves = self.fold_slope > 0
        if not moves.any():
            return None
        climbs = np.where(self.moment > self.quiet, self.moment, 0.0)
        return float(np.max(climbs[moves] / self.fold_slope[moves])) / self.veins


def ring_ratio(fan: EarwigFan) -> float:
    """Ratio m of the tangents of half the ring's and half the veins' fold angle (theory.md, section 2)."""
    return math.sin(fan.epsilon) / math.cos(fan.sector_angle / 2)


def camber_angle(design: Design) -> float | None:
    """Pleat angle at which the ring creases reach the overbend, rad, negative; None where they never do."""
    ratio = ring_ratio(design.fan)
    return -2 * math.atan2(math.tan(design.hinge.overbend / 2), ratio) if ratio > 0 else None


def fold_path(design: Design, points: int = 181) -> FoldPath:
    """Follow a wing along its fold.

    Args:
        design: the wing.
        points: how many places to look at.
    """
    camber, ratio = camber_angle(design), ring_ratio(design.fan)
    low, high = camber or 0.0, _last_pleat(design, ratio)
    pleat = np.unique(np.concatenate([np.linspace(low, high, points), [0.0]]))
    half_sine = np.sin(pleat / 2)
    half_cosine = np.where(pleat == math.pi, 0.0, np.cos(pleat / 2))
    ring = 2 * np.arctan2(ratio * half_sine, half_cosine) if ratio > 0 else np.zeros_like(pleat)
    fold_slope = ratio / (half_cosine**2 + (ratio * half_sine) ** 2) if ratio > 0 else np.zeros_like(pleat)
    wings = section([design]).only(np.zeros(len(pleat), dtype=np.int64))
    start = np.zeros((len(pleat), len(wings.lower)))
    start[:, TURN::4], start[:, FOLD::4] = pleat[:, None] / 2, -ring[:, None]
    found = _least_stretched(wings, start)
    sheet, on_sheet, _ = sheet_energy(wings.sheet, found.position.reshape(len(pleat), wings.veins, 4))
    # the slope of the least energy is that at fixed sweep and lift (envelope theorem)
    of_tendons = (on_sheet - found.slope)[:, FOLD::4].sum(axis=1) * fold_slope
    slope = of_tendons + on_sheet[:, TURN::4].sum(axis=1) / 2 - on_sheet[:, FOLD::4].sum(axis=1) * fold_slope
    curve = CubicHermiteSpline(pleat, found.energy, slope)
    by_angle = curve.derivative()
    quiet = _quiet_moment(design, of_tendons, fold_slope)
    return FoldPath(
        pleat_angle=pleat,
        ring_angle=ring,
        tendon_energy=found.energy - sheet,
        sheet_energy=sheet,
        moment=-slope,
        fold_slope=fold_slope,
        quiet=quiet,
        veins=wings.veins,
        states=states_along(lambda x: (curve(x), by_angle(x)), pleat, force=quiet),
        remarks=_remarks(design, camber),
    )


def _least_stretched(wings: Section, start: Array) -> Equilibria:
    """Aim the veins where the membrane is stretched least, at every place of the path, (place, angle).

    A place can have several such equilibria: each is also looked for from where its neighbours found theirs, and the
    lowest counts, so that the path does not jump between them.
    """
    found = rest(wings, start, fixed=(TURN, FOLD))
    for _ in range(_PASSES):
        lowered = False
        for shift in (1, -1):
            beside = start.copy()
            for joint in (SWEEP, LIFT):
                beside[:, joint::4] = np.roll(found.position, shift, axis=0)[:, joint::4]
            beside[0 if shift > 0 else -1] = found.position[0 if shift > 0 else -1]
            other = rest(wings, beside, fixed=(TURN, FOLD))
            lower = other.energy < found.energy - _ROUNDING * np.abs(found.energy).max()
            lowered |= bool(lower.any())
            found = replace(
                found,
                position=np.where(lower[:, None], other.position, found.position),
                energy=np.where(lower, other.energy, found.energy),
                slope=np.where(lower[:, None], other.slope, found.slope),
            )
        if not lowered:
            break
    return found


def _quiet_moment(design: Design, of_tendons: Array, fold_slope: Array) -> Array:
    """Moment about the pleats that counts as none at every place, N m: the ring moves faster by some than by others."""
    membrane = design.membrane.youngs_modulus * design.membrane.thickness * design.pattern.proximal_length**2
    about_ring = np.divide(of_tendons, fold_slope, out=np.zeros_like(of_tendons), where=fold_slope > 0)
    largest = float(np.abs(about_ring).max())
    # a slack tendon's moment is rounding
    if largest > 1e-9 * membrane:
        return np.asarray(_QUIET * largest * fold_slope)
    return np.full_like(fold_slope, _QUIET_SHEET * membrane)


def _last_pleat(design: Design, ratio: float) -> float:
    """Pleat angle at which the ring creases reach the fold limit, or the veins theirs, rad."""
    limit = design.hinge.fold_limit
    closed = math.pi if ratio == 0 or limit == math.pi else 2 * math.atan2(math.tan(limit / 2), ratio)
    return min(closed, 2 * design.hinge.turn_limit)


def _remarks(design: Design, camber: float | None) -> tuple[str, ...]:
    if camber is None:
        return (
            "pattern.hub_radius is 0, so the ring fold stays straight until the pleats are closed: rigid panels never"
            " reach the overbend, and their energy is the same all along; a hub radius > 0 couples the two",
        )
    remarks = []
    if 2 * design.hinge.turn_limit < math.pi:
        remarks.append(
            f"hinge.turn_limit stops the veins at {math.degrees(design.hinge.turn_limit):.4g} deg, so rigid panels"
            f" pleat to {math.degrees(2 * design.hinge.turn_limit):.4g} deg and no further"
        )
    back, stop = -camber / 2, design.hinge.turn_back
    if back > stop:
        remarks.append(
            f"rigid panels reach the overbend of {math.degrees(design.hinge.overbend):.4g} deg only with veins turned"
            f" back by {math.degrees(back):.4g} deg, and hinge.turn_back stops them at {math.degrees(stop):.4g} deg:"
            " in the compliant wing the membrane gives way instead"
        )
    return tuple(remarks)
