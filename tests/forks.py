"""Processes that are killed in the midst of work: forks of one that has imported what they need."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

# forks at every line that it reads, and says of each fork which process it is and how it ended
_FORKING = """
import os, sys
{imports}
for _ in sys.stdin:
    child = os.fork()
    if not child:
        {work}
        os._exit(0)
    print(child, flush=True)
    print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
"""
KillOnce = Callable[..., bool]


def _of_group(group: int) -> int:
    """Return the number of processes of a group, from Linux's /proc/PID/stat: the fifth field is the group."""
    count = 0
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            count += int(path.read_text().rpartition(")")[2].split()[2]) == group
        except OSError:
            continue
    return count


@contextmanager
def forks(imports: str, work: str, *arguments: object) -> Iterator[KillOnce]:
    """Hand out what starts a fork that does some work and kills it once something holds, and says whether it could.

    In the end no fork may have left a process behind.

    Args:
        imports: lines that are run once.
        work: one line, which each fork runs; it prints nothing.
        arguments: what sys.argv has from 1 on.
    """
    script = _FORKING.format(imports=imports, work=work)
    command = [sys.executable, "-c", script, *map(str, arguments)]
    pipes = dict.fromkeys(("stdin", "stdout"), subprocess.PIPE)
    with subprocess.Popen(command, **pipes, text=True, start_new_session=True) as process:

        def kill_once(holds: Callable[[], bool], after: float = 0.0) -> bool:
            process.stdin.write("\n")
            process.stdin.flush()
            child = int(process.stdout.readline())
            try:
                while not holds():
                    os.kill(child, 0)
                    time.sleep(1e-3)
                time.sleep(after)
                os.kill(child, signal.SIGKILL)
            except ProcessLookupError:  # it ended before
                pass
            return int(process.stdout.readline()) == -signal.SIGKILL

        yield kill_once
        process.stdin.close()
    assert process.returncode == 0
    assert _of_group(process.pid) == 0
