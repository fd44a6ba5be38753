"""Code that depends on the operating system, with every branch simulated on the system that runs the tests.

docs/operating-systems.md lists these branches.
"""

import asyncio
import importlib
import os
import signal
import subprocess
import sys
import types

import pytest

import forficula.lock
from forficula.cli import check_room_for_libraries
from forficula.errors import InputError
from forficula.files import open_to_append, read_bytes, read_text, write_text
from forficula.make.files.print_orientation import file_names
from forficula.names import folder_name


@pytest.fixture
def lock_of_windows(monkeypatch):
    """The module of locks as Windows imports it, where a stand-in holds files by their number."""
    taken = set()

    def locking(descriptor, mode, count):
        assert (mode, count) == (2, 1)
        name = os.fstat(descriptor).st_ino
        if name in taken:
            raise PermissionError(13, "Permission denied")
        taken.add(name)

    windows = types.SimpleNamespace(LK_NBLCK=2, locking=locking)
    with monkeypatch.context() as patched:
        patched.setitem(sys.modules, "msvcrt", windows)
        patched.setattr(sys, "platform", "win32")
        yield importlib.reload(forficula.lock)
    importlib.reload(forficula.lock)


def test_a_lock_on_windows_is_given_to_one_and_its_file_is_removed_after_it_is_closed(lock_of_windows, tmp_path):
    with lock_of_windows.hold_lock(tmp_path / "lock") as first:
        assert first is True
        with lock_of_windows.hold_lock(tmp_path / "lock", wait=False) as second:
            assert second is False
    assert list(tmp_path.iterdir()) == []


def test_a_lock_file_that_another_process_is_removing_is_waited_for(lock_of_windows, tmp_path, monkeypatch):
    """Windows refuses to open a file that is removed as soon as its last owner closes it."""
    opened, refused = os.open, []

    def open_later(*arguments, **options):
        if len(refused) < 3:
            refused.append(1)
            raise PermissionError(13, "Permission denied")
        return opened(*arguments, **options)

    monkeypatch.setattr(os, "open", open_later)
    with lock_of_windows.hold_lock(tmp_path / "lock") as taken:
        assert taken is True
    assert len(refused) == 3


def test_a_folder_that_cannot_be_written_is_an_error_on_windows_too(lock_of_windows, tmp_path, monkeypatch):
    def refuse(*_, **__):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(lock_of_windows, "_REMOVED_SECONDS", 0.05)
    monkeypatch.setattr(os, "open", refuse)
    with pytest.raises(PermissionError), lock_of_windows.hold_lock(tmp_path / "lock"):
        pass


def test_files_are_read_and_written_where_flags_of_unix_are_missing(monkeypatch, tmp_path):
    for flag in ("O_NOFOLLOW", "O_NONBLOCK"):
        monkeypatch.delattr(os, flag, raising=False)
    path = tmp_path / "lines"
    with open_to_append(path) as file:
        file.write(b"one\n")
    assert read_bytes(path) == b"one\n"
    with forficula.lock.hold_lock(tmp_path / "lock") as taken:
        assert taken is True


def test_memory_is_not_limited_where_the_system_has_no_limits(monkeypatch):
    monkeypatch.setitem(sys.modules, "resource", None)
    monkeypatch.delitem(sys.modules, "scipy.linalg", raising=False)
    before = os.environ.get("OPENBLAS_NUM_THREADS")
    check_room_for_libraries()
    assert os.environ.get("OPENBLAS_NUM_THREADS") == before


def test_line_ends_of_every_system_are_read_and_one_kind_is_written(tmp_path):
    for ends in (b"\n", b"\r\n", b"\r"):
        (tmp_path / "read").write_bytes(b"\xef\xbb\xbfone" + ends + b"two" + ends)
        assert read_text(tmp_path / "read") == "one\ntwo\n"
    write_text(tmp_path / "written", "one\ntwo\n")
    assert (tmp_path / "written").read_bytes() == b"one\ntwo\n"


@pytest.mark.parametrize(
    "name", ["con", "PRN", "aux", "nul", "NUL.txt", "com1", "LPT9", "lpt¹", "end.", "end ", 'a"b', "a|b"]
)
def test_a_name_that_windows_cannot_have_is_refused_on_every_system(name):
    with pytest.raises(InputError, match="need a name that a folder can have on every system"):
        folder_name(name)


@pytest.mark.parametrize("name", ["console", "aux2", "com10", "nulle", "lpt", ".hidden", "a.b"])
def test_a_name_that_only_resembles_a_device_is_taken(name):
    assert folder_name(name) == name


def test_files_of_parts_have_names_that_differ_without_regard_to_case_and_name_no_device():
    names = file_names(["Bar", "bar", "aux", "Flügel"])
    assert len({name.lower() for name in names}) == 4
    assert names == ["Bar", "bar-2", "aux-2", "Fl_gel"]


def test_the_workbench_works_where_signals_cannot_be_handled(monkeypatch):
    """Event loops of Windows handle none; Ctrl-C still ends the workbench."""
    from forficula.workbench.server import _end_signals

    monkeypatch.delattr(signal, "SIGHUP", raising=False)

    async def end():
        def refuse(*_):
            raise NotImplementedError

        monkeypatch.setattr(asyncio.get_running_loop(), "add_signal_handler", refuse, raising=False)
        return _end_signals()

    assert not asyncio.run(end()).is_set()


def test_importing_commands_starts_no_process_and_needs_no_module_of_one_system(tmp_path):
    """Processes that Windows and macOS spawn import the main module again."""
    script = tmp_path / "main.py"
    script.write_text(
        "import sys\n"
        "for name in ('fcntl_', 'resource', 'termios', 'pwd', 'grp'):\n"
        "    sys.modules[name] = None\n"
        "import forficula.cli, forficula.workbench.server\n"
        "assert not {'matplotlib', 'mujoco'} & set(sys.modules), 'only tasks need them, in processes of their own'\n"
        "import forficula.calls, forficula.workbench.tasks\n"
        "print('imported')\n"
    )
    done = subprocess.run([sys.executable, script], capture_output=True, text=True, check=True)
    assert done.stdout == "imported\n"
