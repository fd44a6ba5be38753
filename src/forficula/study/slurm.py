"""A job array that runs a study's shards on a cluster with SLURM."""

from __future__ import annotations

import re
import shlex

from forficula.errors import InputError
from forficula.quantities import as_written

_MOST_SHARDS = 10_000


def slurm_script(study: str, out: str, shards: int) -> str:
    """Write the text of a job array, one job a shard.

    Args:
        study: name or path, as the command line takes it.
        out: folder of the study, on a disk that all machines see.
        shards: how many jobs.

    Raises:
        InputError: not a sensible number of jobs.
    """
    if not 1 <= shards <= _MOST_SHARDS:
        raise InputError(f"--slurm: need a number of jobs from 1 to {_MOST_SHARDS}, got {shards}")
    for text in (study, out):
        if any(sign in text for sign in "\r\n"):
            raise InputError("--slurm: need names on one line, got a line break in the name of the study or its folder")
        if re.search("[\ud800-\udfff]", text):
            raise InputError(f"--slurm: need names in UTF-8, got {as_written(text)}")
    command = f"forficula study {shlex.quote(study)} --out {shlex.quote(out)}"
    return f"""#!/bin/bash
#SBATCH --job-name=forficula
#SBATCH --array=1-{shards}
#SBATCH --cpus-per-task=4
#SBATCH --output={shlex.quote(out)}/slurm-%a.log
# Submit with: sbatch THIS_FILE. When all jobs are done: {command} --collect
{command} --shard "${{SLURM_ARRAY_TASK_ID}}/{shards}"
"""
