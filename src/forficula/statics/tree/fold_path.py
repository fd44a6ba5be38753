"""Energy of a structure along its rigid fold: over the pleat angle, from camber through flat to folded."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.quantities import show_value
from forficula.statics.tree.ensemble import Ensemble
from forficula.statics.tree.equilibrium import Equilibria, PathState, states_along
from forficula.statics.tree.pose import span
from forficula.statics.tree.potential import hinge_angles, rest
from forficula.statics.tree.sheet import sheet_energy
from forficula.structure import RigidFold, Structure, drive_of, goal_of, state_of

# Moment that counts as zero: as a share of the tendons' largest moment about the ring or, without one, of E t l^2 of
# the membrane.
_QUIET, _QUIET_SHEET = 1e-3, 1e-4
# number of passes that start from neighbouring solutions, and energy that counts as zero, of the largest
_PASSES, _ROUNDING = 8, 1e-12


@dataclass(frozen=True, kw_only=True)
class FoldPath:
    """A structure along the single folding path of its rigid panels, see `forficula.structure.RigidFold`.

    Hinges that the path does not determine move to where the membrane is stretched least.

    Attributes:
        pleat_angle: rising, rad, (place,).
        ring_angle: fold angle of the ring creases, with its sign, rad, (place,).
        angles: of all hinges, in their own senses, rad, (place, hinge).
        tendon_energy: of all tendons, springs and weights, J, (place,).
        sheet_energy: of membranes and length limits, J, (place,).
        moment: about the pleats, -d energy / d pleat angle, N m, (place,).
        fold_slope: d ring angle / d pleat angle, (place,).
        unfold_rate: work of a unit torque of the opening drive per decrease of the pleat angle, (place,).
        quiet: moment that counts as zero, N m, (place,).
        turns: number of hinges that turn by half the pleat angle each.
        driven: number of these hinges with a motor; all if none has a motor.
        folds: number of hinges that fold with the ring.
        states: equilibria, in the order of the pleat angle.
        remarks: sentences on the limits of the path.
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
        """Return the total energy, J, (place,)."""
        return self.tendon_energy + self.sheet_energy

    @property
    def fold_torque(self) -> float:
        """Return the least torque on every driven hinge that folds the structure from its first state, N m.

        It is the steepest climb of the energy, shared by the driven hinges, which turn by half the pleat angle. Rigid
        panels make the other hinges follow.
        """
        climbs = np.where(-self.moment > self.quiet, -self.moment, 0.0)
        return float(climbs.max()) * 2 / self.driven

    @property
    def unfold_torque(self) -> float | None:
        """Return the least torque of the opening drive that opens the structure, N m; None if the ring never moves."""
        moves = (self.fold_slope > 0) & (self.unfold_rate > 0)
        if not moves.any():
            return None
        climbs = np.where(self.moment > self.quiet, self.moment, 0.0)
        return float(np.max(climbs[moves] / self.unfold_rate[moves]))


@dataclass(frozen=True, kw_only=True)
class StableState:
    """A stable state of a structure along its fold.

    Attributes:
        name: the start of the fold, such as "flat", for a first state that is flat or cambered; the end of the fold,
            such as "folded", for the last state; "partly folded" between them; "anywhere" for a neutral range over the
            whole path.
        kind: "stop", pressed onto the end of the path; "minimum"; "neutral", a range without any force.
        pleat_angle: rad; for a neutral range, the end nearer to flat.
        far_pleat_angle: the other end of a neutral range, rad; otherwise the pleat angle.
        ring_angle: fold angle of the ring creases, rad.
        energy: J.
        holding_torque: torque on every turning hinge that presses the structure onto the end of the path, N m.
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
    """Return the single folding path of a structure's rigid panels.

    Raises:
        InputError: there is no single folding path.
    """
    if structure.rigid_fold is None:
        raise InputError(
            f"{structure.name}: has no single folding path of rigid panels, so there is no energy along it"
        )
    return structure.rigid_fold


def refuse_fold_on_table(structure: Structure) -> None:
    """Refuse the energy along the rigid fold of a structure on a table.

    Raises:
        InputError: the structure has a table.
    """
    if structure.table is not None:
        raise InputError(
            f"{structure.name}: has no energy along its rigid fold, because the fold may lead below the table;"
            ' table = "none" leaves the table out'
        )


def fold_path(structures: Ensemble, points: int = 181) -> FoldPath:
    """Compute a structure along its fold.

    Args:
        structures: only the first case is used.
        points: number of places along the fold.

    Raises:
        InputError: the structure has no single folding path, or lies on a table.
    """
    fold = rigid_fold(structures.structure)
    refuse_fold_on_table(structures.structure)
    ratio, turns, folds = fold.ratio, span(fold.turns), span(fold.folds)
    pleat = np.unique(np.concatenate([np.linspace(fold.first or 0.0, fold.last, points), [0.0]]))
    half_sine = np.sin(pleat / 2)
    half_cosine = np.where(pleat == math.pi, 0.0, np.cos(pleat / 2))
    ring = 2 * np.arctan2(ratio * half_sine, half_cosine) if ratio > 0 else np.zeros_like(pleat)
    fold_slope = ratio / (half_cosine**2 + (ratio * half_sine) ** 2) if ratio > 0 else np.zeros_like(pleat)
    many = structures.repeated(len(pleat))
    start = np.zeros((len(pleat), many.size))
    start[:, turns], start[:, folds] = pleat[:, None] / 2, -ring[:, None]
    result = _least_stretched(many, start, fold)
    sheet, on_sheet, _ = sheet_energy(many.sheet, result.position)
    # the slope of the least energy equals that with the undetermined hinges held (envelope theorem)
    of_tendons = (on_sheet - result.slope)[:, folds].sum(axis=1) * fold_slope
    slope = of_tendons + result.slope[:, turns].sum(axis=1) / 2 - on_sheet[:, folds].sum(axis=1) * fold_slope
    curve = scipy.interpolate.CubicHermiteSpline(pleat, result.energy, slope)
    by_angle = curve.derivative()
    quiet = _quiet_moment(structures.structure, fold, of_tendons, fold_slope)
    return FoldPath(
        pleat_angle=pleat,
        ring_angle=ring,
        angles=hinge_angles(many, result.position),
        tendon_energy=result.energy - sheet,
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
    """Return the stable states of a structure along its fold, from camber to folded."""
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
    """Return `FoldPath.unfold_rate`; for torques on the folding hinges if no transition leads back."""
    built, turns, folds = structures.structure, list(fold.turns), list(fold.folds)
    back = next((transition for transition in built.transitions if transition.state != fold.end), None)
    torques = np.zeros(structures.size)
    torques[folds] = 1.0
    if back is not None:
        drive = drive_of(built, back.drive)
        torques = np.array(drive.shares) @ structures.drives * (-1.0 if drive.strength < 0 else 1.0)
    return np.asarray(torques[folds].sum() * fold_slope - torques[turns].sum() / 2)


def _driven(structure: Structure, fold: RigidFold) -> int:
    """Return the number of turning hinges with a motor; all of them if none has a motor."""
    return len({hinge for motor in structure.motors for hinge in motor.hinges} & set(fold.turns)) or len(fold.turns)


def _least_stretched(structures: Ensemble, start: Array, fold: RigidFold) -> Equilibria:
    """Let the undetermined hinges move to where the membrane is stretched least, at every place of the path.

    A place can have several such equilibria. Each place is also solved from the solutions of its neighbours, and the
    lowest energy is kept, so that the path does not jump between equilibria.
    """
    fixed = [*fold.turns, *fold.folds]
    result = rest(structures, start, fixed=fixed)
    free = np.delete(np.arange(structures.size), fixed)
    for _ in range(_PASSES):
        lowered = False
        for shift in (1, -1):
            shifted = start.copy()
            shifted[:, free] = np.roll(result.position, shift, axis=0)[:, free]
            shifted[0 if shift > 0 else -1] = result.position[0 if shift > 0 else -1]
            other = rest(structures, shifted, fixed=fixed)
            lower = other.energy < result.energy - _ROUNDING * np.abs(result.energy).max()
            lowered |= bool(lower.any())
            result = replace(
                result,
                position=np.where(lower[:, None], other.position, result.position),
                energy=np.where(lower, other.energy, result.energy),
                slope=np.where(lower[:, None], other.slope, result.slope),
            )
        if not lowered:
            break
    return result


def _quiet_moment(structure: Structure, fold: RigidFold, of_tendons: Array, fold_slope: Array) -> Array:
    """Return the moment about the pleats that counts as zero at every place, N m; it grows with the ring's rate."""
    laws = [membrane.law for membrane in structure.membranes]
    membrane = max((law.youngs_modulus * law.thickness * fold.base_length**2 for law in laws), default=0.0)
    about_ring = np.divide(of_tendons, fold_slope, out=np.zeros_like(of_tendons), where=fold_slope > 0)
    largest = float(np.abs(about_ring).max())
    # the moment of a slack tendon is a rounding error
    if largest > 1e-9 * membrane:
        return np.asarray(_QUIET * largest * fold_slope)
    return np.full_like(fold_slope, _QUIET_SHEET * membrane)
