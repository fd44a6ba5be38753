"""A study on a Dask cluster gives the same result, whatever happens to its workers."""

import gc
import os
import signal
import sys
import time

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import forficula as ff
from forficula.cli import main
from forficula.dynamics import versions
from forficula.errors import InputError
from forficula.study import dask_cluster
from forficula.study.running.cluster import _check_versions, _Pace
from forficula.study.running.journal import read_rows

FACTORS = '"tendon.stiffness" = "10..40 N/cm step 10"\n"tendon.rest_length" = "1..8 cm step 1"'

distributed = pytest.importorskip("distributed", reason="Dask is not installed: pip install 'forficula[cluster]'")


def local_cluster(**options):
    """Two workers with one thread each."""
    return distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address="127.0.0.1:0", silence_logs="CRITICAL", **options
    )


@pytest.fixture
def cluster(monkeypatch):
    """A cluster whose workers are in this process and start at once."""
    # otherwise runs as short as these would all be done in this process
    monkeypatch.setattr("forficula.study.running.cluster._LEAST_SECONDS", 0.05)
    with local_cluster(processes=False, protocol="tcp://") as cluster:
        yield cluster


@pytest.fixture(scope="module")
def mortal_cluster():
    """A cluster whose workers are processes that can be killed; new ones replace them."""
    with local_cluster(processes=True) as cluster:
        yield cluster


@pytest.fixture(scope="module")
def study(tmp_path_factory, write_study_file):
    return ff.load_study(write_study_file(tmp_path_factory.mktemp("study") / "study.toml", FACTORS))


@pytest.fixture(scope="module")
def local_table(study, tmp_path_factory):
    """The table without a cluster, and the lines of its journal."""
    folder = tmp_path_factory.mktemp("here")
    return ff.run_study(study, folder), lines(folder)


def lines(folder):
    """The signature and the rows of a journal, without the start and end of its process."""
    content = (folder / "journal.jsonl").read_text()
    return sorted(line for line in content.split("\n") if not line.startswith('{"attempt"'))


def kill_at_work(cluster):
    """Kill a worker during a chunk; return the lost chunks, none if all workers are idle."""
    with distributed.Client(cluster, set_as_default=False) as client:
        at_work = {
            address: key
            for address, stacks in client.call_stack().items()
            for key, frames in stacks.items()
            if "_run_chunk" in "".join(frames)
        }
    for worker in cluster.workers.values():
        if worker.worker_address not in at_work:
            continue
        os.kill(worker.pid, signal.SIGSTOP)
        time.sleep(0.2)  # messages that it has sent arrive
        held = {task.key for task in cluster.scheduler.workers[worker.worker_address].processing}
        # a stopped worker cannot have finished its present chunk
        os.kill(worker.pid, signal.SIGKILL if at_work[worker.worker_address] in held else signal.SIGCONT)
        return held & {at_work[worker.worker_address]}
    return set()


@pytest.mark.parametrize("blamed_on_others", [3, 0], ids=["given to another worker", "run here"])
def test_a_worker_killed_at_work_loses_no_row_and_changes_no_bit(
    mortal_cluster, study, local_table, tmp_path, monkeypatch, blamed_on_others
):
    cluster, died = mortal_cluster, set()
    monkeypatch.setattr(cluster.scheduler, "allowed_failures", blamed_on_others)
    # several chunks of runs as short as these
    monkeypatch.setattr("forficula.study.running.cluster._LEAST_SECONDS", 0.05)
    monkeypatch.setattr("forficula.study.running.cluster._CHUNK_SECONDS", 0.25)

    def kill_once(*_):
        if not died:
            died.update(kill_at_work(cluster))

    # All rows may have arrived while no worker was in the middle of a chunk. Then nothing has been tested.
    for attempt in range(5):
        with dask_cluster(cluster.scheduler_address) as workers:
            table = ff.run_study(study, tmp_path / f"{attempt}", cluster=workers, progress=kill_once)
        assert table.identical(local_table[0])
        assert lines(tmp_path / f"{attempt}") == local_table[1]
        if died:
            break
    assert len(died) == 1
    assert (
        len(local_table[1]) == len(study.points) + 2
    )  # the signature comes first, and nothing follows the last newline


def test_a_study_whose_workers_all_leave_ends_with_one_error_and_keeps_what_is_done(
    cluster, study, local_table, tmp_path, monkeypatch
):
    monkeypatch.setattr("forficula.study.running.cluster._PATIENCE_SECONDS", 1)
    kept = []

    def send_home(report):
        kept.append(report.latest["key"])
        cluster.scale(0)

    words = (
        r"^--dask: the scheduler at tcp://\S+ has had no workers for 1 s; the same command continues where it stopped$"
    )
    with dask_cluster(cluster.scheduler_address) as workers, pytest.raises(InputError, match=words):
        ff.run_study(study, tmp_path / "out", cluster=workers, progress=send_home)
    assert 0 < len(kept) < len(study.points)
    rows = []
    table = ff.run_study(study, tmp_path / "out", progress=lambda item: rows.append(item.latest["key"]))
    assert {*kept, *rows} == set(read_rows(tmp_path / "out", study.base))
    assert set(kept).isdisjoint(rows)
    assert table.identical(local_table[0])


def test_a_scheduler_that_is_gone_is_one_error_and_what_is_done_is_kept(cluster, study, tmp_path):
    with (
        dask_cluster(cluster.scheduler_address) as workers,
        pytest.raises(
            InputError,
            match=r"^--dask: the scheduler at tcp://\S+ is gone; the same command continues where it stopped",
        ),
    ):
        ff.run_study(study, tmp_path / "out", cluster=workers, progress=lambda *_: cluster.close())
    assert 0 < len(read_rows(tmp_path / "out", study.base)) < len(study.points)


def test_first_runs_are_local_and_determine_the_size_of_chunks(cluster, study, tmp_path, monkeypatch):
    sizes, submit = [], distributed.Client.submit

    def listen(self, run, texts, *arguments, **options):
        sizes.append(len(texts))
        return submit(self, run, texts, *arguments, **options)

    monkeypatch.setattr(distributed.Client, "submit", listen)
    with dask_cluster(cluster.scheduler_address) as workers:
        ff.run_study(study, tmp_path / "out", cluster=workers)
    assert 0 < sum(sizes) < len(study.points)
    assert sizes[0] > 1


@given(st.integers(1, 10_000), st.floats(1e-5, 30), st.integers(1, 100))
def test_chunks_take_about_a_second_including_the_last(left, seconds, runs):
    pace = _Pace(runs=runs, seconds=runs * seconds)
    assume(left >= pace.runs_in(0.2))
    least = 0.2 / max(seconds, 1e-4)
    while left:
        size = pace.chunk(left)
        # never less than 0.2 s, never more than 1.2 s plus the runs at its ends
        assert least * (1 - 1e-9) <= size <= min(left, 6 * least + 2)
        left -= size


@pytest.mark.parametrize("address", ["nonsense", "tcp://", "gopher://x:1"])
def test_an_invalid_address_is_one_error(address):
    with pytest.raises(InputError, match=r"^--dask: [^\n]*$"), dask_cluster(address):
        pass


def clients():
    return [item for item in gc.get_objects() if isinstance(item, distributed.Client)]


def test_an_address_where_nothing_listens_is_one_error_and_its_client_does_not_wait_to_be_collected():
    """If the failed client were collected while the next one starts, this one would wait for it."""
    words = r"--dask: no Dask scheduler answers at tcp://127\.0\.0\.1:9"
    gc.disable()
    try:
        # clients of earlier tests, whose schedulers have gone, may still exist
        before = clients()
        with pytest.raises(InputError, match=words), dask_cluster("tcp://127.0.0.1:9"):
            pass
        assert not [client for client in clients() if not any(client is other for other in before)]
    finally:
        gc.enable()


def test_without_dask_the_error_says_what_to_install(study_file, tmp_path, monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(SystemExit) as ended:
        main(["study", str(study_file(FACTORS)), "--out", str(tmp_path / "out"), "--dask", "tcp://127.0.0.1:9"])
    assert ended.value.code == 1
    assert 'pip install "forficula[cluster]"' in capsys.readouterr().err


@pytest.mark.parametrize("device", [None, "gpu"])
def test_rows_of_workers_with_other_versions_are_refused(device):
    _check_versions({device: versions(device)})
    with pytest.raises(InputError, match="a worker has other versions"):
        _check_versions({None: versions(), device: {**versions(device), "mujoco": "1.0"}})


def test_versions_of_the_engine_on_a_device_are_compared_too():
    with pytest.raises(InputError, match="warp-lang"):
        _check_versions({"gpu": {**versions("gpu"), "warp-lang": "0.1"}})
