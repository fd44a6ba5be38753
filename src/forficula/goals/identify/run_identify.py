"""Identification in a folder: missing runs are done, existing rows are kept, and the result is built at the end."""

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

# number of samples from which the time of all is estimated
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
    """Do the missing runs of observations, and determine which samples agree with the facts.

    An interrupted call that is repeated in the same folder gives the same result, bit for bit.

    Args:
        observations: design, unknowns and facts.
        out: folder with the rows of runs.
        shard: number, from 1, and count of the processes that share the runs; each of them gets the result.
        threads: number of threads; 0 for one per core.
        cluster: computes rows of designs, from `dask_cluster`.
        progress: called after every batch with the number of completed samples, the number of all samples, and the
            samples.
        run_progress: called after every run with the number of completed runs, the number of runs known to be needed,
            and the row.

    Returns:
        The table of `build_result`.

    Raises:
        InputError: the folder has rows of another design, or cannot be written; a number is not allowed.
    """
    with open_assessor(
        out, observations.base, shard=shard, threads=threads, cluster=cluster, progress=run_progress
    ) as assessor:
        keys: set[str] = set()
        samples = identify_samples(observations, lambda runs: _rows(assessor, runs, keys), progress)
        return build_result(observations, samples, len(keys))


def _rows(assessor: Assessor, runs: Sequence[ConditionRun], keys: set[str]) -> list[Row]:
    keys.update(run.key for run in runs)
    return assessor([run.design for run in runs], ["run"], points=[run.values for run in runs])


def estimate_identify(observations: Observations) -> tuple[int, float, float]:
    """Estimate the number of samples, the number of runs, and the time on this machine, s.

    The estimate is that of the first samples, which run now, times the number of samples.

    Args:
        observations: design, unknowns and facts.
    """
    first_samples = replace(observations, samples=min(_GUESS, observations.samples), directed=0)
    runs, start = 0, time.perf_counter()

    def assess(wanted: Sequence[ConditionRun]) -> list[Row]:
        nonlocal runs
        runs += len(wanted)
        rows = {row["key"]: row for row in evaluate([run.design for run in wanted])}
        return [rows[run.key] for run in wanted]

    identify_samples(first_samples, assess)
    count = observations.samples + observations.directed
    share = count / first_samples.samples
    return count, share * runs, share * (time.perf_counter() - start)
