"""Timing of a film: which time of the run is shown when; states are held, and moves are slowed down."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from forficula.analysis import Outcome, State
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.show.run.missed_goal import still_time
from forficula.show.run.state_names import lettered_states

_HOLD, _SKIP, _MOVE = 1.2, 0.8, 3.5  # s of the film: a state, the time before a state, and a move


@dataclass(frozen=True, kw_only=True)
class FilmCut:
    """Part of a film.

    Attributes:
        words: its title.
        first: time in the run at its start, s.
        last: time in the run at its end, s.
        length: length in the film, s.
        stage: driven stage that is shown; None for a state, or for a run without driven stages.
        slowed: factor by which it is slower than the run; None if the film only moves on to the next state.
    """

    words: str
    first: float
    last: float
    length: float
    stage: StageEnd | None = None
    slowed: float | None = None


def film_cuts(record: Record, outcome: Outcome, slowed: float | None = None) -> tuple[FilmCut, ...]:
    """Return the parts of a film: the states, held for a while, and the driven stages until motion ends.

    Args:
        record: the simulated motion.
        outcome: the outcome of the run.
        slowed: factor by which moves are slower than in the run; by default each move takes about 3.5 s.
    """
    end = last_sound_time(record)
    driven = [stage for stage in record.stages if stage_drives(stage.stage) and stage.start < end]
    if not driven:
        return (_move("the whole run", 0.0, end, slowed, None),)
    held = sorted(lettered_states(record.structure, outcome), key=lambda item: item[1].time)
    # half a step, because times are multiples of the timestep only up to rounding
    half = float(record.design.protocol.timestep) / 2
    cuts: list[FilmCut] = []
    for name, state in [item for item in held if item[1].time <= driven[0].start + half][-1:]:
        cuts.append(_hold(name, state.time))
        if state.time < driven[0].start:
            skipped = FilmCut(words=name, first=state.time, last=driven[0].start, length=_SKIP)
            cuts.append(skipped)
    for stage, until in pairwise([*driven, None]):
        assert stage is not None
        limit = end if until is None else min(until.start, end)
        still = still_time(record, stage.start, limit)
        cuts.append(_move(stage.stage.name, stage.start, still, slowed, stage))
        since = still
        for name, state in held:
            if stage.start + half < state.time <= limit + half:
                cuts += _state(state, name, since, _last_stage(record, state.time))
                since = max(since, state.time)
    return tuple(cuts)


def moment(cuts: Sequence[FilmCut], time: float) -> tuple[FilmCut, float]:
    """Return the part of a film at one of its times (s), and the time in the run, s."""
    for cut in cuts:
        if time < cut.length or cut is cuts[-1]:
            share = min(max(time / cut.length, 0.0), 1.0)
            return cut, cut.first + share * (cut.last - cut.first)
        time -= cut.length
    raise AssertionError("a film has at least one part")


def last_sound_time(record: Record) -> float:
    """Return the last time at which all positions are known, s: before a run diverged."""
    sound = np.isfinite(record.series["point_position"]).all(axis=(1, 2))
    if record.diverged_at is not None:
        sound &= record.time < record.diverged_at
    return float(record.time[sound][-1]) if sound.any() else float(record.time[0])


def _state(state: State, words: str, after: float, on_the_way: str) -> list[FilmCut]:
    """Return the parts that move on to a state quickly, and hold it."""
    if state.time <= after:
        return [_hold(words, state.time)]
    return [FilmCut(words=on_the_way, first=after, last=state.time, length=_SKIP), _hold(words, state.time)]


def _hold(words: str, time: float) -> FilmCut:
    return FilmCut(words=words, first=time, last=time, length=_HOLD)


def _last_stage(record: Record, time: float) -> str:
    """Return the name of the last stage that began before a time."""
    return next((end.stage.name for end in reversed(record.stages) if end.start < time), "")


def _move(words: str, start: float, end: float, slowed: float | None, stage: StageEnd | None) -> FilmCut:
    """Return the part of a stage, slowed down by a given factor, or by a factor with one digit."""
    lasts = max(end - start, 1e-9)
    factor = slowed or float(f"{_MOVE / lasts:.1g}")
    return FilmCut(words=words, first=start, last=end, length=lasts * factor, stage=stage, slowed=factor)
