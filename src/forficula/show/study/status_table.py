"""Status of a study as text: shards by state, the shards that need attention, and the command that runs them again."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from pathlib import Path

from rich.console import Console
from rich.table import Table

from forficula.names import counted
from forficula.quantities import show_duration
from forficula.study.running.study_status import ShardState, ShardStatus, StudyStatus

# [chosen] largest number of shards that are all listed, and of listed shards that need attention
_MOST_LISTED = 20


def print_status(status: StudyStatus, study: str, folder: Path) -> None:
    """Print the status of a study.

    Args:
        status: the status.
        study: name or path of the study, as on the command line.
        folder: folder of the study.
    """
    what = f"{status.name}: {status.points_done} of {counted(status.points, 'point')}"
    if not status.shards:
        print(f"{what}; no process has started in {folder}")
        return
    print(f"{what} in {counted(len(status.shards), 'shard')}")
    _print(
        ["state", "shards", "points", "of", "runs/s", "time left"],
        [_state_row(state, shards) for state in ShardState if (shards := status.shards_in(state))],
    )
    listed = [shard for shard in status.shards if _needs_attention(shard)]
    if len(status.shards) <= _MOST_LISTED:
        listed = list(status.shards)
    if listed:
        print()
        _print(
            ["shard", "state", "points", "of", "runs/s", "time left", "machine", "job", "reason"],
            [_shard_row(shard) for shard in listed[:_MOST_LISTED]],
        )
    if len(listed) > _MOST_LISTED:
        print(f"and {len(listed) - _MOST_LISTED} more; --json lists all shards")
    command = f"forficula study {shlex.quote(study)} --out {shlex.quote(str(folder))}"
    if status.complete:
        print(f"complete: {command} --collect")
    elif status.run_again:
        _print_again(status, command, folder)


def _print_again(status: StudyStatus, command: str, folder: Path) -> None:
    """Print how the stale, failed and missing shards are run again."""
    script, count = folder / "study.slurm", len(status.shards)
    if count == 1:
        print(f"run again: {command}")
    elif script.is_file():
        print(f"run again: sbatch --array={status.run_again} {shlex.quote(str(script))}")
    else:
        print(f"run again, with each of these numbers for K: {command} --shard K/{count}\n    {status.run_again}")


def _needs_attention(shard: ShardStatus) -> bool:
    return shard.state in (ShardState.STALE, ShardState.FAILED) or (shard.slow and shard.state is ShardState.RUNNING)


def _state_row(state: ShardState, shards: Sequence[ShardStatus]) -> list[str]:
    running = state is ShardState.RUNNING
    rates = [shard.rate for shard in shards if running and shard.rate is not None]
    times = [shard.time_left for shard in shards if shard.time_left is not None]
    return [
        state.value,
        str(len(shards)),
        str(sum(shard.points_done for shard in shards)),
        str(sum(shard.points for shard in shards)),
        f"{sum(rates):.3g}" if rates else "",
        show_duration(float(f"{max(times):.2g}")) if times else "",
    ]


def _shard_row(shard: ShardStatus) -> list[str]:
    reason = shard.why or ("slow: its runs take more than twice as long as those of the median shard" * shard.slow)
    return [
        str(shard.number),
        shard.state.value,
        str(shard.points_done),
        str(shard.points),
        "" if shard.rate is None else f"{shard.rate:.3g}",
        "" if shard.time_left is None else show_duration(float(f"{shard.time_left:.2g}")),
        shard.host,
        shard.job,
        reason,
    ]


def _print(headings: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    lines = Table(box=None, padding=(0, 2, 0, 0))
    for heading in headings:
        text = heading in ("state", "machine", "job", "reason")
        lines.add_column(heading, justify="left" if text else "right", overflow="fold")
    for row in rows:
        lines.add_row(*row)
    Console(width=110, highlight=False, markup=False).print(lines)
