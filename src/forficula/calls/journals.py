"""Folder of a journal, and the seed of random numbers, for calls that make many runs."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from forficula.errors import InputError
from forficula.files import AnyPath, as_path
from forficula.names import check_whole

if TYPE_CHECKING:
    from numpy.random import Generator

_LARGEST_SEED = 2**31


@contextmanager
def journal_folder(out: AnyPath | None) -> Iterator[Path]:
    """Yield the folder of a journal: a temporary one, which is removed at the end, if none is given."""
    if out is not None:
        yield as_path(out, "a folder")
        return
    with TemporaryDirectory(prefix="forficula-") as folder:
        yield Path(folder)


def seed_of(rng: Generator | int | None, seed: int | None) -> int:
    """Return a seed (Scientific Python SPEC 7).

    Args:
        rng: the seed itself, a generator that draws it, or None for a seed from the operating system.
        seed: old name of `rng`; None if it is not given.

    Raises:
        InputError: a seed below 0, or both are given: `rng` is neither its default, 0, nor None.
    """
    if seed is not None and rng is not None and rng != 0:
        raise InputError(f"seed: need either rng or seed, got both: rng = {rng}, seed = {seed}")
    if seed is not None:
        warnings.warn("seed: use rng", DeprecationWarning, stacklevel=4)
        return seed
    if isinstance(rng, int):
        return check_whole("rng", rng, 0)
    import numpy as np

    return int(np.random.default_rng(rng).integers(_LARGEST_SEED))
