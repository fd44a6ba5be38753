"""Parts of the time line that a page shows enlarged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from forficula.design import stage_drives
from forficula.dynamics import StageEnd
from forficula.show.page.playback import Clip

# time shown before and after a driven stage, as a share of it; largest hold shown, as a share of the time to the goal
_LEAD, _HOLD = 0.15, 0.6


@dataclass(frozen=True, kw_only=True)
class Span:
    """Part of the clock that several clips share.

    Attributes:
        name: name of the span.
        label: label of the time axis, which names its zero.
        start: s on the clock.
        end: s on the clock.
        origins: time of each clip at 0 on the clock, s, (clip,).
        whole: whether the span covers everything, most of it at rest.
    """

    name: str
    label: str
    start: float
    end: float
    origins: tuple[float, ...]
    whole: bool = False


def run_spans(clip: Clip) -> list[Span]:
    """Return the whole run, then each driven stage enlarged, in the run's own time."""
    label = "time since the start of the run"
    first, last = float(clip.time[0]), float(clip.time[-1])
    spans = [Span(name="whole run", label=label, start=first, end=last, origins=(0.0,), whole=True)]
    for end in _driven(clip):
        low, high = _close_up(end)
        within = (max(end.start + low, first), min(end.start + high, last))
        if within[0] < within[1]:
            spans.append(Span(name=end.stage.name, label=label, start=within[0], end=within[1], origins=(0.0,)))
    return spans


def shared_spans(clips: Sequence[Clip]) -> list[Span]:
    """Return whole runs side by side, then their transitions, each from the start of its stage in every run.

    Whole runs are aligned at the start of the first transition, or at their own start if a run never reaches it.
    """
    spans = []
    nouns = {transition.drive: transition.wording.noun for clip in clips for transition in clip.structure.transitions}
    for place, (drive, name) in enumerate(nouns.items()):
        label = f"time since the start of {name}"
        starts = [_start(clip, drive) for clip in clips]
        known = [start for start in starts if start is not None]
        if place == 0 and len(known) == len(clips):
            spans.append(_whole(clips, tuple(known), label))
        ends = [end for clip in clips for end in _driven(clip) if drive in stage_drives(end.stage)]
        if len(ends) < 2:
            continue
        low, high = min(_close_up(end)[0] for end in ends), max(_close_up(end)[1] for end in ends)
        # a run that never reached the transition stays at its end
        origins = tuple(
            float(clip.time[-1]) if start is None else start for clip, start in zip(clips, starts, strict=True)
        )
        spans.append(Span(name=name, label=label, start=low, end=high, origins=origins))
    if not spans or len(set(spans[0].origins)) > 1:
        spans.append(_whole(clips, (0.0,) * len(clips), "time since the start of the runs"))
    return spans


def span_data(span: Span) -> dict[str, Any]:
    """Return a span as data for JSON."""
    return {
        "name": span.name,
        "label": span.label,
        "start": span.start,
        "end": span.end,
        "origins": list(span.origins),
        "whole": span.whole,
    }


def _whole(clips: Sequence[Clip], origins: tuple[float, ...], label: str) -> Span:
    pairs = list(zip(clips, origins, strict=True))
    return Span(
        name="whole runs" if any(origins) else "whole runs from their start",
        label=label,
        start=min(float(clip.time[0]) - origin for clip, origin in pairs),
        end=max(float(clip.time[-1]) - origin for clip, origin in pairs),
        origins=origins,
        whole=True,
    )


def _driven(clip: Clip) -> list[StageEnd]:
    return [end for end in clip.stages if stage_drives(end.stage)]


def _start(clip: Clip, drive: str) -> float | None:
    return next((end.start for end in clip.stages if drive in stage_drives(end.stage)), None)


def _close_up(end: StageEnd) -> tuple[float, float]:
    """Return the start and end of the enlarged part of a stage, s since the stage's start."""
    duration = end.end - end.start
    if end.goal_time is not None:
        duration = min(duration, (1 + _HOLD) * (end.goal_time - end.start))
    return -_LEAD * duration, (1 + _LEAD) * duration
