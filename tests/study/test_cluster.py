"""A study on a Dask cluster is the same study, whatever becomes of its workers."""

import os
import signal
import subprocess
import sys
import time

import pytest

import forficula as ff
from forficula.errors import InputError
from forficula.study import dask_cluster

STUDY = """
design = "binder2025"

[factors]
"tendon.stiffness" = "10..30 N/cm step 10"
"tendon.rest_length" = "1..8 cm step 1"

[settings]
"protocol.timestep" = "0.4 ms"
"""

distributed = pytest.importorskip("distributed", reason="Dask is not installed: pip install 'forficula[cluster]'")


@pytest.fixture(params=[3, 0], ids=["given to another worker", "run here"])
def cluster(request):
    """Two workers of a thread each, and how many of their deaths Dask blames on others than the task."""
    import dask

    with (
        dask.config.set({"distributed.scheduler.allowed-failures": request.param}),
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address="127.0.0.1:0", silence_logs="CRITICAL"
        ) as cluster,
    ):
        yield cluster


@pytest.fixture
def study(tmp_path):
    file = tmp_path / "study.toml"
    file.write_text(STUDY)
    return ff.load_study(file)


def test_a_killed_worker_loses_no_row_and_changes_no_bit(cluster, study, tmp_path):
    victim = cluster.workers[0].pid
    killed = []

    def kill_once(done, _, row):
        if done >= 3 and not killed:
            killed.append(row["key"])
            os.kill(victim, signal.SIGKILL)

    with dask_cluster(cluster.scheduler_address) as workers:
        table = ff.run_study(study, tmp_path / "cluster", cluster=workers, progress=kill_once)
    assert killed
    assert table.identical(ff.run_study(study, tmp_path / "here"))
    theirs, ours = (sorted((tmp_path / name / "journal.jsonl").read_text().split("\n")) for name in ("cluster", "here"))
    assert theirs == ours
    assert len(ours) == len(study.points) + 1  # and nothing after the last newline


def test_an_address_where_nothing_listens_is_one_error_within_seconds():
    start = time.monotonic()
    words = r"--dask: no Dask scheduler answers at tcp://127\.0\.0\.1:9"
    with pytest.raises(InputError, match=words), dask_cluster("tcp://127.0.0.1:9"):
        pass
    assert time.monotonic() - start < 10


@pytest.mark.parametrize("address", ["nonsense", "tcp://", "gopher://x:1"])
def test_an_address_that_is_none_is_one_error(address):
    with pytest.raises(InputError, match=r"^--dask: [^\n]*$"), dask_cluster(address):
        pass


def test_without_dask_the_error_says_what_to_install():
    code = """
import sys
sys.modules["distributed"] = None
from forficula.cli import main
main(["study", "binder2025-search", "--out", "/tmp/none-of-it", "--dask", "tcp://127.0.0.1:9"])
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert 'pip install "forficula[cluster]"' in done.stderr
