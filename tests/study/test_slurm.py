import os
import shutil
import subprocess

import pytest

from forficula.cli import main
from forficula.errors import InputError
from forficula.study import collect, load_study, run_study, slurm_script

pytestmark = pytest.mark.skipif(shutil.which("bash") is None, reason="the script is for bash")
NAMES = ["study.toml", "my study.toml", "it's $HOME.toml", 'a "b" `c`;d.toml', "ä&|<>*.toml"]


def accepts(script):
    """Whether bash parses a script without errors."""
    done = subprocess.run(["bash", "-n"], input=script, capture_output=True, text=True, check=False)
    return done.returncode == 0 and not done.stderr


def words(script, place, task="3"):
    """The words of the command of a job."""
    shown = script.replace("\nforficula study", "\nprintf '%s\\n' study")
    done = subprocess.run(
        ["bash"],
        input=shown,
        capture_output=True,
        text=True,
        check=True,
        cwd=place,
        env=os.environ | {"SLURM_ARRAY_TASK_ID": task},
    )
    return done.stdout.splitlines()


@pytest.mark.parametrize("name", NAMES)
def test_every_job_runs_its_shard_for_all_names(tmp_path, name):
    script = slurm_script(name, f"out/{name}", 8)
    assert accepts(script)
    assert words(script, tmp_path) == ["study", name, "--out", f"out/{name}", "--shard", "3/8"]
    assert list(tmp_path.iterdir()) == []


def test_the_array_has_one_job_a_shard():
    script = slurm_script("binder2025-search", "out/search", 12)
    assert script.startswith("#!/bin/bash\n")
    assert "#SBATCH --array=1-12\n" in script
    assert "forficula study binder2025-search --out out/search --collect" in script
    # directives must precede the first command
    assert script.rindex("#SBATCH") < script.index("\nforficula study")


@pytest.mark.parametrize("shards", [0, -1, 10_001])
def test_no_jobs_and_too_many_are_refused(shards):
    with pytest.raises(InputError, match=f"--slurm: need a number of jobs from 1 to 10000, got {shards}"):
        slurm_script("binder2025-search", "out", shards)


@pytest.mark.parametrize("names", [("a\nrm -rf b.toml", "out"), ("a.toml", "out\necho b"), ("a.toml", "out\r")])
def test_a_name_with_a_line_break_is_rejected(names):
    with pytest.raises(InputError, match="--slurm: need names on one line"):
        slurm_script(*names, 2)


def test_a_job_of_the_array_runs_its_shard_of_the_study(tmp_path, study_file):
    path = study_file('"tendon.stiffness" = "10..30 N/cm step 10"', name="my study.toml")
    study, out = load_study(path), tmp_path / "my out"
    script = slurm_script(str(path), str(out), 2)
    main(words(script, tmp_path, "2"))
    assert [path.name for path in out.glob("*.jsonl")] == ["journal-2-of-2.jsonl"]
    run_study(study, out, shard=(1, 2))
    assert collect(study, out).identical(run_study(study, tmp_path / "other"))
