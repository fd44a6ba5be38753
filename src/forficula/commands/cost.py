"""Cost estimates: one line on standard error where a command will take longer than ten seconds."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from time import monotonic
from typing import TYPE_CHECKING, Any

from forficula.terminal import is_quiet

if TYPE_CHECKING:
    from forficula.design import StageSection
    from forficula.structure import Structure

LONG = 10.0  # s; a shorter command is not announced
_MEASURED = 1.0  # s of work from which the rest is estimated


def _rounded(seconds: float) -> str:
    """Return a duration of two digits."""
    for unit, length in (("d", 86400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= length:
            return f"{seconds / length:.2g} {unit}"
    return f"{seconds:.2g} s"


class _Estimate:
    """Time since the start, and whether the estimate was written."""

    def __init__(self) -> None:
        self._start: float | None = None
        self._done = False

    def elapsed(self) -> float:
        """Return the time since the first call, s."""
        self._start = monotonic() if self._start is None else self._start
        return monotonic() - self._start

    def write(self, seconds: float, text: str) -> None:
        """Write the estimate once, where it exceeds ten seconds."""
        self._done = True
        if seconds > LONG and not is_quiet():
            print(text, file=sys.stderr, flush=True)


class RunEstimate(_Estimate):
    """Progress of a run that also writes how long the run takes at most, from its first second of work.

    Args:
        progress: receives every call.
        searches: whether the timestep is searched by halving.
        several: whether the run is the first of several runs side by side, which are followed by others.
        stages: of the protocol. The time that statics takes for those that are quasi-static cannot be estimated.
    """

    def __init__(
        self,
        progress: Callable[[str, float, float], None],
        *,
        searches: bool,
        several: bool = False,
        stages: Sequence[StageSection] = (),
    ) -> None:
        super().__init__()
        self._progress, self._searches, self._several = progress, searches, several
        self._slow = tuple(stage.name for stage in stages if stage.quasi_static)
        self._slow_limit = sum(stage.time_limit for stage in stages if stage.quasi_static)
        self._reached_statics = False

    def __call__(self, stage: str, time: float, longest: float) -> None:
        """Report a stage, the simulated time and its upper limit, s."""
        elapsed = self.elapsed()
        self._reached_statics = self._reached_statics or stage.endswith(self._slow)
        if self._reached_statics:
            if not self._done and elapsed > LONG:
                unknown = "the number of static steps of quasi-static stages is unknown"
                self.write(elapsed, f"estimate: none, because {unknown}; {_rounded(elapsed)} so far")
        elif not self._done and elapsed >= _MEASURED and time > 0:
            left = elapsed * (longest - self._slow_limit - time) / time
            more = ", and twice as long at each finer timestep" if self._searches else ""
            # runs side by side may have different timesteps, and the progress is that of one of them
            limit, runs = ("about", " for the first runs") if self._several else ("at most", "")
            further = "; some runs are repeated at a shorter timestep" if self._several else ""
            simulated = " for the simulated stages" if self._slow else ""
            text = f"{limit} {_rounded(left)}{runs}{simulated}, less if stages reach their goals early{more}{further}"
            self.write(left, f"estimate: {text}")
        self._progress(stage, time, longest)


def write_survey_estimate(structure: Structure) -> None:
    """Write how long the landscape of a structure will take, where that may exceed ten seconds."""
    from forficula.statics.net.survey_cost import survey_time

    times = survey_time(structure)
    if times is not None:
        least, most = times
        _Estimate().write(most, f"estimate: {_rounded(least)} to {_rounded(most)} for the static analysis")


class CountEstimate(_Estimate):
    """Estimate of the time for many runs, from the first second of work.

    Args:
        what: that is counted, in the plural, such as "runs".
        most: whether the count is an upper limit, as in searches.
    """

    def __init__(self, what: str = "runs", *, most: bool = False) -> None:
        super().__init__()
        self._what, self._most = what, most
        self._before: int | None = None
        self.elapsed()

    def update(self, done: int, needed: int) -> None:
        """Report the number that is done, and the number that is needed.

        What was done before the first report, such as the runs of an interrupted study, took no time now.
        """
        elapsed = self.elapsed()
        if self._before is None:
            self._before = max(done - 1, 0)
        if self._done or done <= self._before or elapsed < _MEASURED:
            return
        left = elapsed * (needed - done) / (done - self._before)
        limit = "at most " * self._most
        self.write(left, f"estimate: {limit}{_rounded(left)} for {limit}{needed} {self._what}")


def runs_estimated(
    progress: Callable[[int, int, dict[str, Any]], None], *, most: bool = False
) -> Callable[[int, int, dict[str, Any]], None]:
    """Return the progress of many runs that also writes an estimate; `most` is as in `CountEstimate`."""
    estimate = CountEstimate(most=most)

    def update(done: int, needed: int, row: dict[str, Any]) -> None:
        estimate.update(done, needed)
        progress(done, needed, row)

    return update
