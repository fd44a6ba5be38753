"""Warnings of the engine."""

from __future__ import annotations

import threading

import mujoco


class _Quiet:
    """Context that keeps MuJoCo from writing its warnings to a file; divergence is in the record.

    MuJoCo has only one handler for warnings. The first user replaces it, and the last user restores it.
    """

    def __init__(self) -> None:
        self._lock, self._users, self._before = threading.Lock(), 0, None

    def __enter__(self) -> None:
        with self._lock:
            if not self._users:
                self._before = mujoco.get_mju_user_warning()
                mujoco.set_mju_user_warning(_ignore_warning)
            self._users += 1

    def __exit__(self, *error: object) -> None:
        with self._lock:
            self._users -= 1
            if not self._users:
                mujoco.set_mju_user_warning(self._before)


def _ignore_warning(message: str) -> None:
    """Ignore a warning of MuJoCo."""


quiet = _Quiet()
