import os
import subprocess
import sys
import time

import pytest

from forficula.lock import hold_lock

HOLD = """
import sys, time
from pathlib import Path
from forficula.lock import hold_lock
with hold_lock(Path(sys.argv[1])) as taken:
    print(taken, flush=True)
    time.sleep(float(sys.argv[2]))
"""


def another(path, seconds):
    """Another process that holds a lock."""
    child = subprocess.Popen([sys.executable, "-c", HOLD, path, str(seconds)], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "True\n"
    return child


def test_a_lock_of_another_process_cannot_be_acquired(tmp_path):
    with another(tmp_path / "lock", 60) as child:
        with hold_lock(tmp_path / "lock", wait=False) as taken:
            assert taken is False
        child.kill()


def test_a_lock_dies_with_its_owner(tmp_path):
    with another(tmp_path / "lock", 60) as child:
        child.kill()
    assert (tmp_path / "lock").exists()
    with hold_lock(tmp_path / "lock", wait=False) as taken:
        assert taken is True
    assert list(tmp_path.iterdir()) == []


def test_waiting_acquires_the_lock_and_reports_a_long_wait(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("forficula.lock._SILENT_SECONDS", 0.2)
    with another(tmp_path / "lock", 0.5):
        start = time.monotonic()
        with hold_lock(tmp_path / "lock") as taken:
            assert taken is True
            assert time.monotonic() - start > 0.2
    assert capsys.readouterr().err == f"waiting for another process that writes to {tmp_path}\n"
    assert list(tmp_path.iterdir()) == []


def test_only_one_holds_a_lock_at_a_time(tmp_path):
    script = (
        "import sys\nfrom pathlib import Path\nfrom forficula.lock import hold_lock\n"
        "number = Path(sys.argv[1], 'number')\n"
        "for _ in range(200):\n"
        "    with hold_lock(Path(sys.argv[1], 'lock')):\n"
        "        number.write_text(str(int(number.read_text()) + 1))\n"
    )
    (tmp_path / "number").write_text("0")
    children = [subprocess.Popen([sys.executable, "-c", script, tmp_path]) for _ in range(3)]
    assert [child.wait() for child in children] == [0, 0, 0]
    assert (tmp_path / "number").read_text() == "600"
    assert [path.name for path in tmp_path.iterdir()] == ["number"]


@pytest.mark.skipif(not hasattr(os, "O_NOFOLLOW"), reason="links cannot be detected when they are opened")
def test_a_symbolic_link_is_not_accepted_as_a_lock_file(tmp_path):
    (tmp_path / "lock").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(OSError, match="symbolic"), hold_lock(tmp_path / "lock"):
        pass
    assert not (tmp_path / "elsewhere").exists()


def test_a_file_system_without_locks_is_reported_without_waiting(tmp_path, monkeypatch):
    fcntl = pytest.importorskip("fcntl")

    def fail(*_):
        raise OSError(38, "Function not implemented")

    monkeypatch.setattr(fcntl, "flock", fail)
    with hold_lock(tmp_path / "lock") as first, hold_lock(tmp_path / "lock") as second:
        assert (first, second) == (None, None)
