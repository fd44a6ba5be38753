"""Observations in a folder: what is missing is run, what is there is kept, and the result is built at the end."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from forficula.goals.assessor import Assessor, open_assessor
from forficula.goals.identify.identify import Progress, identify_samples
from forficula.goals.identify.observations import Observations
from forficula.goals.identify.result import build_result
from forficula.goals.identify.sample_runs import ConditionRun
from forficula.study.running.evaluate import evaluate
from forficula.study.running.journal import Row
from forficula.study.running.run_study import Evaluate
from forficula.study.running.run_study import Progress as RunProgress

if TYPE_CHECKING:
    import xarray

# samples by which the time of all is guessed
_GUESS = 2


def identify(
    observations: Observations,
    out: str | Path,
    *,
    shard: tuple[int, int] = (1, 1),
    threads: int = 0,
    cluster: Evaluate | None = None,
    progress: Progress | None = None,
    run_progress: RunProgress | None = None,
) -> xarray.Dataset:
    """Run what observations lack, and say which samples agree with the facts.

    Killed and taken up again in the same folder it comes to the same, bit for bit.

    Args:
        observations: what was seen.
        out: folder with the rows of runs.
        shard: number, from 1 on, and count of the processes that share the runs, each of which comes to the result.
        threads: 0 for one a core.
        cluster: what makes rows of designs, from `dask_cluster`.
        progress: called after every batch of samples with those done, all, and the samples.
        run_progress: called after every run with those done, those known to be needed, and the row.

    Returns:
        The table of `build_result`.

    Raises:
        InputError: the folder holds rows of another design, or cannot be written; a number is not allowed.
    """
    with open_assessor(
        out, observations.base, shard=shard, threads=threads, cluster=cluster, progress=run_progress
    ) as assessor:
        asked: set[str] = set()
        samples = identify_samples(observations, lambda runs: _rows(assessor, runs, asked), progress)
        return build_result(observations, samples, len(asked))


def _rows(assessor: Assessor, runs: Sequence[ConditionRun], asked: set[str]) -> list[Row]:
    asked.update(run.key for run in runs)
    return assessor([run.design for run in runs], ["run"], points=[run.values for run in runs])


def estimate_identify(observations: Observations) -> tuple[int, float, float]:
    """Guess what observations take: samples, runs in all, and time on this machine, s.

    The guess is that of the first samples, run now, times all of them.

    Args:
        observations: what was seen.
    """
    few = replace(observations, samples=min(_GUESS, observations.samples), directed=0)
    runs, start = 0, time.perf_counter()

    def assess(wanted: Sequence[ConditionRun]) -> list[Row]:
        nonlocal runs
        runs += len(wanted)
        rows = {row["key"]: row for row in evaluate([run.design for run in wanted])}
        return [rows[run.key] for run in wanted]

    identify_samples(few, assess)
    count = observations.samples + observations.directed
    share = count / few.samples
    return count, share * runs, share * (time.perf_counter() - start)
