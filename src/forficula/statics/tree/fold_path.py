"""A structure along its rigid fold: energy over the pleat angle, from camber through flat to folded."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.quantities import show_value
from forficula.statics.tree.equilibrium import Equilibria, PathState, states_along
from forficula.statics.tree.pose import span
from forficula.statics.tree.potential import Ensemble, rest
from forficula.statics.tree.sheet import sheet_energy
from forficula.structure import RigidFold, Structure, drive_of, goal_of, state_of

# Moment that counts as none: of the tendons' largest about the ring, or, where they have none, of E t l^2 of the
# membrane.
_QUIET, _QUIET_SHEET = 1e-3, 1e-4
# how often places learn from their neighbours, and energy that counts as none, of the largest
_PASSES, _ROUNDING = 8, 1e-12


@dataclass(frozen=True, kw_only=True)
class FoldPath:
    """A structure along the one way in which rigid panels fold, see `forficula.structure.RigidFold`.

    Hinges that the panels leave open go to where the membrane is stretched least.

    Attributes:
        pleat_angle: rising, rad, (place,).
        ring_angle: fold angle of the ring creases, of its sign, rad, (place,).
        angles: of all hinges, in their own senses, rad, (place, hinge).
        tendon_energy: of all tendons, springs and weights, J, (place,).
        sheet_energy: of membranes and length limits, J, (place,).
        moment: about the pleats, -d energy / d pleat angle, N m, (place,).
        fold_slope: d ring angle / d pleat angle, (place,).
        unfold_rate: work that a unit torque of the drive back does, by the pleat angle that it takes back, (place,).
        quiet: moment that counts as none, N m, (place,).
        turns: how many hinges turn, by half the pleat angle each.
        driven: how many of these a motor drives; all where none is driven.
        folds: how many fold with the ring.
        states: where it rests, in the order of the pleat angle.
        remarks: sentences on what to know of it.
    """

    pleat_angle: Array
    ring_angle: Array
    angles: Array
    tendon_energy: Array
    sheet_energy: Array
    moment: Array
    fold_slope: Array
    unfold_rate: Array
    quiet: Array
    turns: int
    driven: int
    folds: int
    states: tuple[PathState, ...]
    remarks: tuple[str, ...]

    @property
    def energy(self) -> Array:
        """Of everything, J, (place,)."""
        return self.tendon_energy + self.sheet_energy

    @property
    def fold_torque(self) -> float:
        """Least torque on every driven hinge that takes it along, from its first state to folded, N m.

        The steepest climb, shared by these hinges, which turn by half the pleat angle; rigid panels take the others
        along.
        """
        climbs = np.where(-self.moment > self.quiet, -self.moment, 0.0)
        return float(climbs.max()) * 2 / self.driven

    @property
    def unfold_torque(self) -> float | None:
        """Least torque of the drive back that takes it back, N m; None where the ring does not move on the way."""
        moves = (self.fold_slope > 0) & (self.unfold_rate > 0)
        if not moves.any():
            return None
        climbs = np.where(self.moment > self.quiet, self.moment, 0.0)
        return float(np.max(climbs[moves] / self.unfold_rate[moves]))


@dataclass(frozen=True, kw_only=True)
class StableState:
    """A stable state of a structure along its fold.

    Attributes:
        name: the start of the fold, such as "flat", the first, where it is flat or cambered; its end, such as
            "folded", the last; "partly folded" between them; "anywhere" where nothing moves it all along.
        kind: "stop", pressed onto the end of the path; "minimum"; "neutral", a range without any force.
        pleat_angle: rad; of a neutral range the end nearer to flat.
        far_pleat_angle: the other end of a neutral range, rad; otherwise the pleat angle.
        ring_angle: fold angle of the ring creases there, rad.
        energy: J.
        holding_torque: on every hinge that turns, that presses it onto the end of the path, N m.
    """

    name: str
    kind: Literal["stop", "minimum", "maximum", "neutral"]
    pleat_angle: float
    far_pleat_angle: float
    ring_angle: float
    energy: float
    holding_torque: float

    def __repr__(self) -> str:
        """Name and energy."""
        return f"<StableState {self.name}: {show_value(self.energy, 'J')}>"


def rigid_fold(structure: Structure) -> RigidFold:
    """How the panels of a structure fold.

    Raises:
        InputError: it is not one way.
    """
    if structure.rigid_fold is None:
        raise InputError(f"{structure.name}: has no one way in which rigid panels fold, so no energy along it")
    return structure.rigid_fold


def fold_path(structures: Ensemble, points: int = 181) -> FoldPath:
    """Follow a structure along its fold.

    Args:
        structures: of which the first case is taken.
        points: how many places to look at.

    Raises:
        InputError: it has no one way to fold.
    """
    fold = rigid_fold(structures.structure)
    ratio, turns, folds = fold.ratio, span(fold.turns), span(fold.folds)
    pleat = np.unique(np.concatenate([np.linspace(fold.first or 0.0, fold.last, points), [0.0]]))
    half_sine = np.sin(pleat / 2)
    half_cosine = np.where(pleat == math.pi, 0.0, np.cos(pleat / 2))
    ring = 2 * np.arctan2(ratio * half_sine, half_cosine) if ratio > 0 else np.zeros_like(pleat)
    fold_slope = ratio / (half_cosine**2 + (ratio * half_sine) ** 2) if ratio > 0 else np.zeros_like(pleat)
    many = structures.repeated(len(pleat))
    start = np.zeros((len(pleat), many.size))
    start[:, turns], start[:, folds] = pleat[:, None] / 2, -ring[:, None]
    found = _least_stretched(many, start, fold)
    sheet, on_sheet, _ = sheet_energy(many.sheet, found.position)
    # the slope of the least energy is that with the open hinges held (envelope theorem)
    of_tendons = (on_sheet - found.slope)[:, folds].sum(axis=1) * fold_slope
    slope = of_tendons + found.slope[:, turns].sum(axis=1) / 2 - on_sheet[:, folds].sum(axis=1) * fold_slope
    curve = scipy.interpolate.CubicHermiteSpline(pleat, found.energy, slope)
    by_angle = curve.derivative()
    quiet = _quiet_moment(structures.structure, fold, of_tendons, fold_slope)
    return FoldPath(
        pleat_angle=pleat,
        ring_angle=ring,
        angles=found.position,
        tendon_energy=found.energy - sheet,
        sheet_energy=sheet,
        moment=-slope,
        fold_slope=fold_slope,
        unfold_rate=_unfold_rate(structures, fold, fold_slope),
        quiet=quiet,
        turns=len(fold.turns),
        driven=_driven(structures.structure, fold),
        folds=len(fold.folds),
        states=states_along(lambda x: (curve(x), by_angle(x)), pleat, force=quiet),
        remarks=fold.remarks,
    )


def fold_states(structure: Structure, path: FoldPath) -> tuple[StableState, ...]:
    """The stable states of a structure along its fold, from camber to folded."""
    return tuple(
        StableState(
            name=_name(structure, path, state),
            kind=state.kind,
            pleat_angle=state.coordinate,
            far_pleat_angle=state.far_coordinate,
            ring_angle=float(np.interp(state.coordinate, path.pleat_angle, path.ring_angle)),
            energy=state.energy,
            holding_torque=state.press * 2 / path.turns,
        )
        for state in path.states
        if state.stable
    )


def _name(structure: Structure, path: FoldPath, state: PathState) -> str:
    fold = rigid_fold(structure)
    ring = float(np.interp(state.far_coordinate, path.pleat_angle, path.ring_angle))
    folded = state_of(structure, fold.end)
    most = None if folded is None else goal_of(structure, folded.goal).most[list(fold.folds)]
    enough = most is not None and bool(np.all(-ring <= most))
    closed = enough or state.far_coordinate >= math.pi
    if state.coordinate <= 0:
        return "anywhere" if closed else fold.start
    return fold.end if closed else f"partly {fold.end}"


def _unfold_rate(structures: Ensemble, fold: RigidFold, fold_slope: Array) -> Array:
    """See `FoldPath.unfold_rate`; that of torques on the folding hinges where no transition leads back."""
    built, turns, folds = structures.structure, list(fold.turns), list(fold.folds)
    back = next((each for each in built.transitions if each.state != fold.end), None)
    torques = np.zeros(structures.size)
    torques[folds] = 1.0
    if back is not None:
        drive = drive_of(built, back.drive)
        torques = np.array(drive.shares) @ structures.drives * (-1.0 if drive.strength < 0 else 1.0)
    return np.asarray(torques[folds].sum() * fold_slope - torques[turns].sum() / 2)


def _driven(structure: Structure, fold: RigidFold) -> int:
    """How many of the hinges that turn have a motor; all where none has."""
    return len({hinge for motor in structure.motors for hinge in motor.hinges} & set(fold.turns)) or len(fold.turns)


def _least_stretched(structures: Ensemble, start: Array, fold: RigidFold) -> Equilibria:
    """Let what the panels leave open go where the membrane is stretched least, at every place of the path.

    A place can have several such equilibria: each is also looked for from where its neighbours found theirs, and the
    lowest counts, so that the path does not jump between them.
    """
    fixed = [*fold.turns, *fold.folds]
    found = rest(structures, start, fixed=fixed)
    free = np.delete(np.arange(structures.size), fixed)
    for _ in range(_PASSES):
        lowered = False
        for shift in (1, -1):
            beside = start.copy()
            beside[:, free] = np.roll(found.position, shift, axis=0)[:, free]
            beside[0 if shift > 0 else -1] = found.position[0 if shift > 0 else -1]
            other = rest(structures, beside, fixed=fixed)
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


def _quiet_moment(structure: Structure, fold: RigidFold, of_tendons: Array, fold_slope: Array) -> Array:
    """Moment about the pleats that counts as none at every place, N m: the ring moves faster by some than by others."""
    laws = [membrane.law for membrane in structure.membranes]
    membrane = max((law.youngs_modulus * law.thickness * fold.base_length**2 for law in laws), default=0.0)
    about_ring = np.divide(of_tendons, fold_slope, out=np.zeros_like(of_tendons), where=fold_slope > 0)
    largest = float(np.abs(about_ring).max())
    # a slack tendon's moment is rounding
    if largest > 1e-9 * membrane:
        return np.asarray(_QUIET * largest * fold_slope)
    return np.full_like(fold_slope, _QUIET_SHEET * membrane)
