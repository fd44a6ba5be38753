"""The scripts of the page on clusters: every job runs its shard, and journals survive a job that fails."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from forficula.study import slurm_script

pytestmark = pytest.mark.skipif(os.name != "posix", reason="the scripts are for sh")
PAGE = (Path(__file__).parents[2] / "docs" / "how-to" / "cluster.md").read_text("utf-8")
FILES = dict(re.findall(r"```\{file\} (\S+)\n(.*?)```", PAGE, flags=re.DOTALL))
# writes its arguments, and a row to the journal of its shard; the word "bad" in the name of the study lets it fail
FORFICULA = """#!/bin/sh
printf '%s\\n' "$*" >> "$CALLS"
study=$2
while [ $# -gt 0 ]; do
    case $1 in --out) out=$2;; --shard) shard=$2;; esac
    shift
done
echo row >> "$out/journal-${shard%/*}-of-${shard#*/}.jsonl"
case $study in *bad*) exit 1;; esac
"""
# an object store in a folder
AWS = """#!/bin/sh
from=${3#s3://} to=${4#s3://}
mkdir -p "$to"
cp "$from"/journal-*.jsonl "$to" 2> /dev/null || true
"""


@pytest.fixture
def run(tmp_path):
    """Run a script of the page with stand-ins for forficula and aws; returns the exit status and the calls."""
    for name, text in {**FILES, "bin/forficula": FORFICULA, "bin/aws": AWS}.items():
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
        path.chmod(0o755)
    (tmp_path / "out").mkdir()
    calls = tmp_path / "calls"

    def run(*words, **variables):
        environment = os.environ | {"PATH": f"{tmp_path / 'bin'}:{os.environ['PATH']}", "CALLS": str(calls)}
        done = subprocess.run(words, cwd=tmp_path, env=environment | variables, check=False, capture_output=True)
        return done.returncode, calls.read_text().splitlines() if calls.exists() else []

    return run


@pytest.mark.parametrize("variable", ["AWS_BATCH_JOB_ARRAY_INDEX", "BATCH_TASK_INDEX", "JOB_COMPLETION_INDEX"])
def test_every_job_of_a_batch_service_runs_its_shard(run, variable):
    for index in range(3):
        status, calls = run("sh", "shard.sh", "3", "my study.toml", "out", **{variable: str(index)})
        assert status == 0
    assert calls == [f"study my study.toml --shard {number}/3 --out out --keep 0" for number in (1, 2, 3)]


def test_a_job_without_a_number_is_refused(run):
    status, calls = run("sh", "shard.sh", "3", "a.toml", "out")
    assert status != 0
    assert calls == []


def test_journals_are_copied_from_and_to_an_object_store_even_if_the_job_fails(run, tmp_path):
    arguments = ("sh", "shard-s3.sh", "3", "a.toml", "s3://store")
    assert run(*arguments, AWS_BATCH_JOB_ARRAY_INDEX="1")[0] == 0
    assert run(*arguments[:3], "bad.toml", "s3://store", AWS_BATCH_JOB_ARRAY_INDEX="1")[0] == 1
    assert [path.name for path in (tmp_path / "store").iterdir()] == ["journal-2-of-3.jsonl"]
    # the second job continued the journal of the first
    assert (tmp_path / "store" / "journal-2-of-3.jsonl").read_text() == "row\nrow\n"


def test_the_jobs_of_a_slurm_array_run_all_shards(run, tmp_path):
    (tmp_path / "study.slurm").write_text(slurm_script("a.toml", "out", 5))
    for task in range(1, 6):
        status, calls = run("bash", "study.slurm", SLURM_ARRAY_TASK_ID=str(task))
        assert status == 0
    assert calls == [f"study a.toml --out out --shard {task}/5" for task in range(1, 6)]


@pytest.mark.skipif(shutil.which("snakemake") is None, reason="Snakemake is not installed")
def test_snakemake_plans_every_shard_and_the_table(run):
    assert run("snakemake", "--cores", "1", "--dry-run")[0] == 0
