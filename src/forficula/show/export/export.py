"""Choice of a format for the export of a run, and writing of its files completely or not at all."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

import numpy as np

from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.files import replacing_all, write_bytes, write_text
from forficula.names import listed, one_of
from forficula.pattern import write_fold
from forficula.quantities import show_duration
from forficula.show.export.fold import fold_frames
from forficula.show.export.gltf import gltf_bytes
from forficula.show.export.mesh_files import obj_files, stl_bytes
from forficula.show.export.scene import STILL, frame_times, sampled_points, scene_of
from forficula.show.export.table import csv_table
from forficula.show.export.usd import usd_text
from forficula.show.export.vtk import write_vtk


@dataclass(frozen=True, kw_only=True)
class Format:
    """File format.

    Attributes:
        ending: ending of its files.
        moving: whether a file holds the motion; others hold one moment.
        write: writes a record at times (s) to a path.
    """

    ending: str
    moving: bool
    write: Callable[[Record, Array, Path], None]


def _write_gltf(record: Record, times: Array, path: Path) -> None:
    write_bytes(path, gltf_bytes(scene_of(record, times)))


def _write_obj(record: Record, times: Array, path: Path) -> None:
    files = obj_files(scene_of(record, times), path.stem)
    with replacing_all(path.parent) as folder:
        for name, content in files.items():
            (folder / name).write_bytes(content)


def _write_stl(record: Record, times: Array, path: Path) -> None:
    content = stl_bytes(record.structure, sampled_points(record, times)[0], scene_of(record, times))
    write_bytes(path, content)


def _write_vtk(record: Record, times: Array, path: Path) -> None:
    series = path.parent / path.stem
    old = [f"{path.stem}/{file.name}" for file in series.glob("*.vtu")] if series.is_dir() else []
    with replacing_all(path.parent, remove=old) as folder:
        write_vtk(record, times, folder, path.stem)


def _write_usd(record: Record, times: Array, path: Path) -> None:
    write_text(path, usd_text(scene_of(record, times)))


def _write_fold(record: Record, times: Array, path: Path) -> None:
    pattern, frames = fold_frames(record, times)
    write_fold(pattern, path, frames=frames)


def _write_csv(record: Record, _: Array, path: Path) -> None:
    write_text(path, csv_table(record))


FORMATS = {
    "gltf": Format(ending=".glb", moving=True, write=_write_gltf),
    "obj": Format(ending=".obj", moving=False, write=_write_obj),
    "stl": Format(ending=".stl", moving=False, write=_write_stl),
    "vtk": Format(ending=".pvd", moving=True, write=_write_vtk),
    "usd": Format(ending=".usda", moving=True, write=_write_usd),
    "fold": Format(ending=".fold", moving=True, write=_write_fold),
    "csv": Format(ending=".csv", moving=True, write=_write_csv),
}


def check_format(to: str) -> None:
    """Refuse a name that no format has.

    Raises:
        InputError: unknown format; the message names the nearest one, and the caller adds the key.
    """
    if to not in FORMATS:
        raise InputError(f"need {one_of(FORMATS, to)}")


def format_of(path: Path, to: str | None) -> str:
    """Return the name of the format of a file: the chosen one, or that of the ending of its path.

    Raises:
        InputError: an unknown ending, or one that is not that of the chosen format.
    """
    endings = {kind.ending: name for name, kind in FORMATS.items()}
    if to is None and path.suffix not in endings:
        by_name = endings | {f".{name}": name for name in FORMATS}
        near = get_close_matches(path.suffix.lower(), by_name, n=1)
        hint = f"; did you mean {FORMATS[by_name[near[0]]].ending}?" if near else ""
        raise InputError(f"need a file that ends with {listed(endings, 'or')}, got {path}{hint}")
    if to is not None and path.suffix != FORMATS[to].ending:
        raise InputError(f"need a file that ends with {FORMATS[to].ending} for {to}, got {path}")
    return to or endings[path.suffix]


def default_path(folder: Path, to: str) -> Path:
    """Return the path of an export without a name: a file in the folder of the run."""
    return folder / f"{'motion' if FORMATS[to].moving else 'moment'}{FORMATS[to].ending}"


def export_times(record: Record, to: str, at: float | None) -> Array:
    """Return the times of the frames of an export, s, (frame,).

    Args:
        record: the run.
        to: name of a format of `FORMATS`.
        at: time of the only moment, s; None for the whole motion, or for the last moment where the format holds one.

    Raises:
        InputError: a time outside of the run or after its divergence, or a structure that never moved.
    """
    if at is not None:
        first, last = record.time[0], record.time[-1]
        if to == "csv":
            raise InputError(f"need none for csv, which holds all samples, got {at:g} s")
        if not first <= at <= last:
            bounds = f"{show_duration(first)} to {show_duration(last)}"
            raise InputError(f"need a time within the run, {bounds}, got {at:g} s")
        times = np.array([float(at)])
        if not np.isfinite(sampled_points(record, times)).all():
            raise InputError(f"need a time before the run diverged, got {at:g} s")
        return times
    if to == "csv":
        return record.time
    times = frame_times(record)
    if not FORMATS[to].moving:
        return times[-1:]
    if len(times) < 2 or np.ptp(sampled_points(record, times), axis=0).max() <= STILL * record.structure.span:
        raise InputError(
            f"{record.design.name}: the structure never moved, so there is no motion for {to}; export one moment with"
            " the option at, or to obj or stl"
        )
    return times


def write_export(record: Record, path: Path, to: str, times: Array) -> None:
    """Write frames of a run to a file of another program.

    Args:
        record: the run.
        path: path of the file, with the ending of the format.
        to: name of a format of `FORMATS`.
        times: times of the frames, from `export_times`, s.

    Raises:
        InputError: a structure that the format cannot hold, a library that is not installed, or files that cannot be
            written; existing files are then unchanged.
    """
    FORMATS[to].write(record, times, path)
