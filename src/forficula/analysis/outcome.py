"""What a run means: states, energies, work, times, verdict and the energy balance."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.dynamics import Record, StageEnd

Array = NDArray[np.float64]

# A hinge this far past straight, folding, has left the overbend for good.
_LEFT_STRAIGHT = np.radians(5.0)
_STIR = np.radians(0.1)


@dataclass(frozen=True, kw_only=True)
class State:
    """One of the three states: the mean over the last part of a stage, and how far the wing still swings.

    Attributes:
        time: end of the stage, s.
        distal_angle: by vein, folding negative in its own sense, rad, (vein,).
        distal_angle_low: lowest over the window, rad, (vein,).
        distal_angle_high: highest over the window, rad, (vein,).
        tendon_length: by vein, m, (vein,).
        tendon_energy: by vein, J, (vein,).
        membrane_energy: J; nan in a sparse record.
    """

    time: float
    distal_angle: Array
    distal_angle_low: Array
    distal_angle_high: Array
    tendon_length: Array
    tendon_energy: Array
    membrane_energy: float

    @property
    def swings(self) -> bool:
        """Whether a hinge still moves by more than 0.1 deg."""
        return bool(np.any(self.distal_angle_high - self.distal_angle_low > _STIR))


@dataclass(frozen=True, kw_only=True)
class Transition:
    """Folding or unfolding.

    Attributes:
        torque: on each driven axis, N m.
        succeeded: whether the goal was reached and held after the release.
        time: from the start of the stage until the goal was reached, s; None where it failed.
        work: of the torques over the stage, J: the integral of torque over angle.
    """

    torque: float
    succeeded: bool
    time: float | None
    work: float


@dataclass(frozen=True, kw_only=True)
class EnergyBalance:
    """Where the work went, J, from start to end of the run.

    Attributes:
        work: that the torques put in.
        tendon: change of the tendons' energy.
        membrane: change of the membrane's energy.
        kinetic: change of the kinetic energy.
        gravitational: change of the gravitational energy.
        hinge_damping: that the hinges' damping took.
        elastic_damping: that the tendons' and the membrane's damping took.
        stops: that stops, guard tendons and, where they are on, contacts took.
        branches: change of the energy of the tendons' Maxwell branches; None where they have none.
        branch_damping: that the dampers in these branches took; None where there are none.
        yielding: that the tendons' yielding took; None where they never yield.
        letting_go: minus what their branches stored without work, where the tendon gave way and did not push; None
            where it never does.
    """

    work: float
    tendon: float
    membrane: float
    kinetic: float
    gravitational: float
    hinge_damping: float
    elastic_damping: float
    stops: float
    branches: float | None = None
    branch_damping: float | None = None
    yielding: float | None = None
    letting_go: float | None = None

    @property
    def missing(self) -> float:
        """Work that the account does not find, J: the error of the integration."""
        stored = self.tendon + self.membrane + self.kinetic + self.gravitational
        of_law = sum(term or 0.0 for term in (self.branches, self.branch_damping, self.yielding, self.letting_go))
        return self.work - stored - self.hinge_damping - self.elastic_damping - self.stops - of_law

    @property
    def residual(self) -> float:
        """What is missing, as a share of the work put in, or where none was, of the energy that the tendons gave."""
        scale = abs(self.work) or abs(self.tendon)
        return abs(self.missing) / scale if scale else 0.0

    @property
    def residual_of(self) -> str:
        """What the residual is a share of."""
        return "the work put in" if self.work else "the energy of the tendons"


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """What a run means.

    Attributes:
        status: in a few words.
        advice: what to try, in a sentence; empty where there is nothing to mend.
        folded: whether every distal hinge folded, and stayed beyond half the folded angle when released.
        opened: whether every distal hinge opened, and stayed so when released.
        flat: the flat state, or None where the wing diverged before it.
        folded_state: None where the protocol did not get there.
        opened_state: None where the protocol did not get there.
        fold: None where the protocol has no such stage or did not get there.
        unfold: None where the protocol has no such stage or did not get there.
        energy_balance: over the whole run; None where the record is sparse.
    """

    status: str
    advice: str
    folded: bool
    opened: bool
    flat: State | None
    folded_state: State | None
    opened_state: State | None
    fold: Transition | None
    unfold: Transition | None
    energy_balance: EnergyBalance | None


def measure(record: Record) -> Outcome:
    """Find what a run means.

    The flat state is taken at the end of the first stage; the folded and the opened one at the end of the stage that
    follows folding and unfolding. Each is the mean over the protocol's window; where no release follows, it is the
    moment at which the goal was reached.
    """
    folding, after_folding = _driven(record, "fold")
    unfolding, after_unfolding = _driven(record, "unfold")
    folded_state = _state(record, after_folding)
    opened_state = _state(record, after_unfolding)
    protocol = record.design.protocol
    # A slack tendon lets its hinge rest anywhere on the folded side; one that is back beyond half way has opened again.
    folded = bool(
        folding
        and folding.goal_time is not None
        and folded_state
        and np.all(folded_state.distal_angle <= -protocol.folded_angle / 2)
    )
    opened = bool(
        unfolding
        and unfolding.goal_time is not None
        and opened_state
        and np.all(opened_state.distal_angle >= protocol.opened_angle)
    )
    if record.diverged_at is not None:
        folded = opened = False
    status, advice = _verdict(record, folded, opened, folded_state)
    if record.design.tendon.law is not None:  # of which the stiffness follows
        advice = advice.replace("tendon.stiffness", "tendon.area")
    return Outcome(
        status=status,
        advice=advice,
        folded=folded,
        opened=opened,
        flat=_state(record, record.stages[0] if _sound(record, 0) else None),
        folded_state=folded_state,
        opened_state=opened_state,
        fold=_transition(record, folding, protocol.fold_torque, folded),
        unfold=_transition(record, unfolding, protocol.unfold_torque, opened),
        energy_balance=_balance(record) if _is_full(record) else None,
    )


def _sound(record: Record, stage: int) -> bool:
    """Whether a stage took place without diverging."""
    return len(record.stages) > stage and (record.diverged_at is None or stage < len(record.stages) - 1)


def _driven(record: Record, drive: str) -> tuple[StageEnd | None, StageEnd | None]:
    """The stage with a drive, and the release that followed it, or itself where none did."""
    for index, end in enumerate(record.stages):
        if end.stage.drive == drive:
            after = record.stages[index + 1 : index + 2]
            released = bool(after) and after[0].stage.drive == "none" and _sound(record, index + 1)
            last = index + released
            return end, record.stages[last] if _sound(record, last) else None
    return None, None


def _state(record: Record, end: StageEnd | None) -> State | None:
    if end is None:
        return None
    snapped = end.stage.drive != "none" and end.goal_time is not None
    # a stage that ends in the middle of the snap is no rest to average over
    start = end.end if snapped else max(end.start, end.end - record.design.protocol.window)
    # half a step either way, for times are multiples of the timestep up to rounding
    half = float(record.design.protocol.timestep) / 2
    window = (record.time >= start - half) & (record.time <= end.end + half)
    series = {name: record.series[name][window] for name in ("distal_angle", "tendon_length", "tendon_energy")}
    angle = series["distal_angle"]
    return State(
        time=end.end,
        distal_angle=angle.mean(axis=0),
        distal_angle_low=angle.min(axis=0),
        distal_angle_high=angle.max(axis=0),
        tendon_length=series["tendon_length"].mean(axis=0),
        tendon_energy=series["tendon_energy"].mean(axis=0),
        membrane_energy=float(record.series["membrane_energy"][window].mean()) if _is_full(record) else math.nan,
    )


def _transition(record: Record, end: StageEnd | None, torque: float, succeeded: bool) -> Transition | None:
    if end is None:
        return None
    work = _since(record, "proximal_work", end) + _since(record, "distal_work", end)
    time = end.goal_time - end.start if succeeded and end.goal_time is not None else None
    return Transition(torque=torque, succeeded=succeeded, time=time, work=work)


def _since(record: Record, name: str, end: StageEnd) -> float:
    """Change of a series over a stage."""
    before, after = (int(np.argmin(np.abs(record.time - moment))) for moment in (end.start, end.end))
    return float(record.series[name][after] - record.series[name][before])


def _is_full(record: Record) -> bool:
    return "stop_work" in record.series


def _balance(record: Record) -> EnergyBalance:
    change = {
        name: float(values[-1].sum() - values[0].sum())
        for name, values in record.series.items()
        if name.endswith(("_energy", "_work"))
    }
    return EnergyBalance(
        work=change["proximal_work"] + change["distal_work"],
        tendon=change["tendon_energy"],
        membrane=change["membrane_energy"],
        kinetic=change["kinetic_energy"],
        gravitational=change["gravitational_energy"],
        hinge_damping=-change["hinge_damping_work"],
        elastic_damping=-change["elastic_damping_work"],
        stops=-change["stop_work"],
        branches=change.get("branch_energy"),
        branch_damping=_taken(change, "branch_damping_work"),
        yielding=_taken(change, "yield_work"),
        letting_go=_taken(change, "letting_go_work"),
    )


def _taken(change: dict[str, float], name: str) -> float | None:
    return -change[name] if name in change else None


def _verdict(record: Record, folded: bool, opened: bool, folded_state: State | None) -> tuple[str, str]:
    """The status in a few words and a sentence on what to try."""
    if record.diverged_at is not None:
        return (
            f"diverged at t = {record.diverged_at:.4g} s",
            'Take a shorter timestep (protocol.timestep = "auto" chooses one) or a softer membrane.',
        )
    drives = {end.stage.drive for end in record.stages}
    if "fold" not in drives:
        return "settled", ""
    if not folded:
        return _not_folded(record, folded_state)
    if "unfold" not in drives:
        return "folded", ""
    if opened:
        return "folded and opened", ""
    reached = next(end for end in record.stages if end.stage.drive == "unfold").goal_time is not None
    if reached:
        return (
            "did not open",
            "It opened under torque and folded again when released: hold it longer (hold of the unfolding stage), or"
            " raise hinge.overbend or tendon.stiffness so that the open state locks.",
        )
    return (
        "did not open",
        "Raise protocol.unfold_torque, or take softer or longer tendons (tendon.stiffness, tendon.rest_length).",
    )


def _not_folded(record: Record, state: State | None) -> tuple[str, str]:
    folding = next(end for end in record.stages if end.stage.drive == "fold")
    if folding.goal_time is not None:
        return (
            "did not stay folded",
            "It folded under torque and opened again when released: raise tendon.stiffness, shorten"
            " tendon.rest_length, or raise hinge.damping.",
        )
    least = float(np.max(state.distal_angle)) if state is not None else 0.0
    if least < -_LEFT_STRAIGHT:
        return (
            f"stuck at {np.degrees(least):.1f} deg",
            "Raise protocol.fold_torque, or take stiffer or shorter tendons, which pull further into the fold.",
        )
    return (
        "did not fold",
        "Raise protocol.fold_torque, or lower the barrier: softer or longer tendons (tendon.stiffness,"
        " tendon.rest_length), less hinge.overbend.",
    )
