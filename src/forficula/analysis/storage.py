"""What a wait does to a structure: what its tendons pull before and after, and whether it goes on from there."""

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

# of the largest pull of the run: a tendon that pulls less is slack
_SLACK = 1e-3


@dataclass(frozen=True, kw_only=True)
class Storage:
    """A stage that waited.

    Attributes:
        stage: its number.
        name: its name.
        state: the state that it waited in, by name; "" where none has one.
        time: how long it waited, s.
        clock: since it first rested, s, (row,), one row before every leap and at the end.
        pulls: of every tendon, N, (row, tendon); None where none has Maxwell branches.
        slack: whether no tendon pulls from its beginning to its end.
        lost: energy that Maxwell branches turned into heat, J.
        membrane: energy that the membrane holds at the end, which has no law of creep, J; 0 where there is none, nan in
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
    membrane: Annotated[Joules, Key("membrane_energy")]

    @property
    def pull_before(self) -> Annotated[Array | None, Unit("N")]:
        """What every tendon pulls when the wait begins, N, (tendon,)."""
        return None if self.pulls is None else self.pulls[0]

    @property
    def pull_after(self) -> Annotated[Array | None, Unit("N")]:
        """What every tendon pulls when the wait is over, N, (tendon,)."""
        return None if self.pulls is None else self.pulls[-1]

    @property
    def weakened(self) -> Annotated[float | None, Key("pull_lost")]:
        """The share of all tendons' pull that is lost; None where there is none to lose."""
        if self.pulls is None or self.slack:
            return None
        return float(1 - self.pulls[-1].sum() / self.pulls[0].sum())


def storages(record: Record) -> tuple[Storage, ...]:
    """The stages that waited to their end, in order."""
    found, waited, states = [], record.series.get("waited"), record.structure.stage_states
    for number, end in enumerate(record.stages):
        if waited is None or not end.stage.wait or end.goal_time is None:
            continue
        # every leap begins at the last row with less waited, and steps go on from the first row with more
        rows = np.flatnonzero((record.time >= end.start) & (record.time <= end.end))
        last = rows[np.append(np.diff(waited[rows]) > 0, True)]
        clock = record.time[last] + waited[last]
        pulls = record.series.get("tendon_pull")
        heat = record.series.get("branch_damping_work", np.zeros(len(record.time)))
        found.append(
            Storage(
                stage=number,
                name=end.stage.name,
                state=states[number] or next(reversed([name for name in states[:number] if name]), ""),
                time=end.stage.wait,
                clock=clock - clock[0],
                pulls=None if pulls is None else pulls[last],
                slack=pulls is not None and bool(np.all(pulls[last[[0, -1]]] <= _SLACK * pulls.max(initial=0.0))),
                lost=float(heat[last[0]] - heat[last[-1]]),
                membrane=float(record.series["membrane_energy"][last[-1]]),
            )
        )
    return tuple(found)


def storage_texts(record: Record, outcome: Outcome) -> list[str]:
    """What every wait did, in a sentence or two each."""
    return [_told(record, outcome, each) for each in storages(record)]


def _told(record: Record, outcome: Outcome, storage: Storage) -> str:
    # what was not reached, or lost, is no state
    missed = outcome.holds.get(storage.state, True) is not True
    where = f'in the stage "{storage.name}"' if missed or not storage.state else storage.state
    after = f"After {show_duration(storage.time)} {where}"
    weakened = storage.weakened
    if storage.pulls is None:
        first = f"{after} it is as before: none of its tendons has Maxwell branches, and nothing else creeps."
    elif weakened is None:
        first = f"{after} its tendons, which are slack there, have lost nothing that holds it."
    else:
        pulls = [show_value(float(storage.pulls[row].sum()), "N") for row in (-1, 0)]
        word = "less" if weakened >= 0 else "more"
        first = (
            f"{after} its tendons pull {100 * abs(weakened):.3g} % {word}, {pulls[0]} instead of {pulls[1]}, and what"
            f" holds it there is {word} by as much where it rests at its stops; {show_value(storage.lost, 'J')} went."
        )
    if record.structure.membranes and np.isfinite(storage.membrane):
        first = f"{first} Its membrane, which does not creep here, holds {show_value(storage.membrane, 'J')}."
    then = next(
        (each for each in record.structure.transitions if each.stage is not None and each.stage > storage.stage), None
    )
    if then is None or outcome.verdict is Verdict.UNTRUSTED or (found := outcome.transitions[then.name]) is None:
        return first
    words = then.wording
    return f"{first} Then it {words.did or words.done if found.succeeded else f'did not {words.verb}'}."
