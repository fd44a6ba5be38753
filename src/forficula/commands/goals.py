"""Commands that turn the question round: from what a structure must do, or did, to the design."""

from __future__ import annotations

from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from forficula.options import OutIfGiven, check_folder, read_shard
from forficula.terminal import came_to, remark

if TYPE_CHECKING:
    from xarray import Dataset

    from forficula.goals.identify import Observations


def identify(
    observations: Annotated[str, Parameter(help="Named observations, or the path of an observations file (.toml).")],
    /,
    *,
    out: Annotated[OutIfGiven, Parameter(help="Folder of the identification; out/<its name> if not given.")] = None,
    dry_run: Annotated[bool, Parameter(help="Only say how many runs there are and how long they take.")] = False,
    shard: Annotated[
        str, Parameter(help="Share the runs with other processes, as in 2/8; each has the result.")
    ] = "1/1",
    dask: Annotated[
        str | None, Parameter(help="Run on the Dask cluster with this scheduler, as in tcp://scheduler:8786.")
    ] = None,
) -> None:
    """Say which values of what is unknown agree with what was seen, and which facts exclude one another."""
    from forficula.goals.identify import load_observations
    from forficula.goals.identify.run_identify import estimate_identify

    asked = load_observations(observations)
    folder = out or Path("out") / asked.name
    check_folder(folder)
    if dry_run:
        count, runs, seconds = estimate_identify(asked)
        print(f"{asked.name}: {count} samples, about {runs:.0f} runs, about {seconds:.0f} s")
        return
    result = _identified(asked, folder, shard, dask)

    from forficula.show.folder.identify_folder import IDENTIFIED, identification_json, write_identification
    from forficula.show.goals.identify_text import print_identification

    if (folder / IDENTIFIED).is_file():
        remark(f"{folder}: replaces the result and the figures there; the rows stay")
    write_identification(result, folder)
    came_to(identification_json(result))
    print_identification(result)
    print(f"\nwritten to {folder}")


def _identified(asked: Observations, folder: Path, shard: str, dask: str | None) -> Dataset:
    """Run observations here or on a Dask cluster."""
    from forficula.goals.identify.run_identify import identify as identify_in
    from forficula.show.goals.identify_progress import identify_progress
    from forficula.study import dask_cluster

    with nullcontext() if dask is None else dask_cluster(dask) as cluster, identify_progress() as (samples, runs):
        return identify_in(asked, folder, shard=read_shard(shard), cluster=cluster, progress=samples, run_progress=runs)
