"""Effect of a waiting time on a structure: forces of its tendons before and after it, and the next transition."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.analysis.outcome import Outcome
from forficula.analysis.verdict import Verdict
from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.quantities import Unit, show_duration, show_value
from forficula.serial import Joules, Key, Seconds, Written

# share of the largest pull of the run below which a tendon counts as slack
_SLACK = 1e-3


@dataclass(frozen=True, kw_only=True)
class Storage:
    """A stage that waited.

    Attributes:
        stage: number of the stage.
        name: name of the stage.
        state: name of the state in which it waited; "" if that has no name.
        time: duration of the wait, s.
        clock: time since the structure first rested, s, (row,), one row before every skipped interval and at the end.
        pulls: force of every tendon, N, (row, tendon); None if no tendon has Maxwell branches.
        slack: whether no tendon pulls at the beginning and at the end of the wait.
        lost: energy that Maxwell branches of tendons dissipated, J.
        lost_in_creases: energy that those of creases dissipated, J; None without them.
        membrane: energy stored in the membrane at the end, J; its creep is not modelled; 0 without a membrane, nan in
            a sparse record.
    """

    stage: Annotated[int, Written.NEVER]
    name: Annotated[str, Key("stage")]
    state: Annotated[str, Written.OR_NULL]
    time: Annotated[Seconds, Key("wait")]
    clock: Annotated[Array, Written.NEVER]
    pulls: Annotated[Array | None, Written.NEVER]
    slack: Annotated[bool, Written.NEVER]
    lost: Annotated[Joules, Key("branch_damping")]
    lost_in_creases: Annotated[Joules | None, Key("crease_branch_damping"), Written.IF_KNOWN]
    membrane: Annotated[Joules, Key("membrane_energy")]

    @property
    def pull_before(self) -> Annotated[Array | None, Unit("N")]:
        """Return the force of every tendon at the start of the wait, N, (tendon,)."""
        return None if self.pulls is None else self.pulls[0]

    @property
    def pull_after(self) -> Annotated[Array | None, Unit("N")]:
        """Return the force of every tendon at the end of the wait, N, (tendon,)."""
        return None if self.pulls is None else self.pulls[-1]

    @property
    def weakened(self) -> Annotated[float | None, Key("pull_lost")]:
        """Return the share of the total force of tendons that was lost; None if there was no force."""
        if self.pulls is None or self.slack:
            return None
        return float(1 - self.pulls[-1].sum() / self.pulls[0].sum())


def storages(record: Record) -> tuple[Storage, ...]:
    """Return the stages that completed their wait, in order."""
    result, waited, states = [], record.series.get("waited"), record.structure.stage_states
    for number, end in enumerate(record.stages):
        if waited is None or not end.stage.wait or end.goal_time is None:
            continue
        # a skipped interval begins at the last row before `waited` grows, and steps continue at the next row
        rows = np.flatnonzero((record.time >= end.start) & (record.time <= end.end))
        last = rows[np.append(np.diff(waited[rows]) > 0, True)]
        clock = record.time[last] + waited[last]
        pulls = record.series.get("tendon_pull")
        heat = record.series.get("branch_damping_work", np.zeros(len(record.time)))
        of_creases = record.series.get("crease_branch_work")
        result.append(
            Storage(
                stage=number,
                name=end.stage.name,
                state=states[number] or next(reversed([name for name in states[:number] if name]), ""),
                time=end.stage.wait,
                clock=clock - clock[0],
                pulls=None if pulls is None else pulls[last],
                slack=pulls is not None and bool(np.all(pulls[last[[0, -1]]] <= _SLACK * pulls.max(initial=0.0))),
                lost=float(heat[last[0]] - heat[last[-1]]),
                lost_in_creases=None if of_creases is None else float(of_creases[last[0]] - of_creases[last[-1]]),
                membrane=float(record.series["membrane_energy"][last[-1]]),
            )
        )
    return tuple(result)


def storage_texts(record: Record, outcome: Outcome) -> list[str]:
    """Return the effect of every wait, in one to three sentences each."""
    return [_storage_text(record, outcome, storage) for storage in storages(record)]


def _storage_text(record: Record, outcome: Outcome, storage: Storage) -> str:
    # a state that was not reached, or was lost, is not named
    missed = outcome.holds.get(storage.state, True) is not True
    where = f'in the stage "{storage.name}"' if missed or not storage.state else storage.state
    after = f"After {show_duration(storage.time)} {where}"
    weakened, of_creases = storage.weakened, storage.lost_in_creases
    if storage.pulls is None and of_creases is not None:
        first = f"{after} its creases have relaxed: their Maxwell branches dissipated {show_value(of_creases, 'J')}."
    elif storage.pulls is None:
        first = f"{after} it is unchanged: none of its tendons has Maxwell branches, and no other part creeps."
    elif weakened is None:
        first = f"{after} the holding force is unchanged, because its tendons are slack in this state."
    else:
        pulls = [show_value(float(storage.pulls[row].sum()), "N") for row in (-1, 0)]
        word = "less" if weakened >= 0 else "more"
        first = (
            f"{after} its tendons pull {100 * abs(weakened):.3g} % {word}: {pulls[0]} instead of {pulls[1]}. Where it"
            f" rests on its stops, the holding torque is {word} by the same share. Maxwell branches dissipated"
            f" {show_value(storage.lost, 'J')}."
        )
    if storage.pulls is not None and of_creases is not None:
        first = f"{first} Those of its creases dissipated {show_value(of_creases, 'J')}."
    if record.structure.membranes and np.isfinite(storage.membrane):
        first = f"{first} Its membrane, whose creep is not modelled, stores {show_value(storage.membrane, 'J')}."
    then = next(
        (
            transition
            for transition in record.structure.transitions
            if transition.stage is not None and transition.stage > storage.stage
        ),
        None,
    )
    if then is None or outcome.verdict is Verdict.UNTRUSTED or (result := outcome.transitions[then.name]) is None:
        return first
    words = then.wording
    return f"{first} Then it {words.did or words.done if result.succeeded else f'did not {words.verb}'}."
