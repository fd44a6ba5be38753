"""Files of records: netCDF with a checksum at the end."""

from __future__ import annotations

import hashlib
import io
import json
import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import cache
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np

from forficula.design import design_from_text, design_text
from forficula.dynamics.record import (
    OPTIONAL_VARIABLES,
    VARIABLES,
    ContactRun,
    NumericalCheck,
    Record,
    StageEnd,
    Variable,
    coordinates,
    series_variables,
)
from forficula.errors import InputError
from forficula.files import as_path, read_bytes, shown_path, write_bytes
from forficula.structure import structure_of

# of the file; other formats are rejected
_FORMAT = 2
# netCDF's name of the scale of a dimension without coordinates
_NOT_A_VARIABLE = "This is a netCDF dimension but not a netCDF variable. {:10d}"
# precedes the checksum at the end of a record; readers of HDF5 ignore bytes after its end
_SEAL = b"\nforficula sha256 "


def save_record(record: Record, path: str | os.PathLike[str]) -> None:
    """Write a record as netCDF, with its design, its stages and a checksum at the end.

    Raises:
        InputError: the file cannot be written.
    """
    nothing = float("nan")
    ends, seconds = record.stages, {"units": "s"}
    goal_times = [nothing if end.goal_time is None else end.goal_time for end in ends]
    reached = "when the stage's goal was reached, nan if it was not"
    stages: dict[str, tuple[Any, dict[str, str]]] = {
        "stage_name": ([end.stage.name for end in ends], {}),
        "stage_start": ([end.start for end in ends], seconds),
        "stage_end": ([end.end for end in ends], seconds),
        "stage_goal_time": (goal_times, {"units": "s", "long_name": reached}),
        "stage_at_goal": (np.array([end.at_goal for end in ends], dtype=np.int8), {}),
        "stage_at_rest": (np.array([end.at_rest for end in ends], dtype=np.int8), {}),
        "stage_waited": ([end.waited for end in ends], seconds),
    }
    mesh = {"long_name": "membrane mesh: nodes of each triangle"}
    variables = {
        **series_variables(record),
        **coordinates(record),
        "triangle": (("face", "corner"), record.triangles, mesh),
        **{name: (("stage",), np.asarray(values), notes) for name, (values, notes) in stages.items()},
    }
    attributes = {
        "format": _FORMAT,
        "title": f"forficula run of {record.design.name}",
        "design": design_text(record.design),
        "design_hash": record.design.hash,
        "diverged_at": nothing if record.diverged_at is None else record.diverged_at,
        "doubt": record.doubt,
        **({"checks": json.dumps([asdict(check) for check in record.checks])} if record.checks else {}),
        **({"contact_runs": json.dumps([asdict(run) for run in record.contact_runs])} if record.contact_runs else {}),
        **_quasi_static(record.stages),
        **({} if record.kinetic_peak is None else {"kinetic_peak": np.array(record.kinetic_peak)}),
        **({} if record.strain_rates is None else {"strain_rates": record.strain_rates}),
        **{f"version_{name}": version for name, version in versions(record.design.protocol.device).items()},
    }
    content = _netcdf(variables, attributes)
    write_bytes(Path(path), content + _seal(content))


def _quasi_static(stages: Sequence[StageEnd]) -> dict[str, str]:
    """Return the shares of quasi-static stages as text; nothing without such stages."""
    shares = [(end.share, end.lost) for end in stages]
    return {"quasi_static": json.dumps(shares)} if any(share is not None for share, _ in shares) else {}


def _seal(content: bytes) -> bytes:
    """Return the end of a record: the SHA-256 of every byte before it.

    The checksum is of the file and not of its arrays, because HDF5 cannot handle damaged files. It takes 1 ms.
    """
    return _SEAL + hashlib.sha256(content).hexdigest().encode() + b"\n"


def _netcdf(variables: Mapping[str, Variable], attributes: Mapping[str, Any]) -> bytes:
    """Return variables as netCDF-4: HDF5 with dimension scales (netCDF file format specification, appendix C).

    h5py is five times as fast as xarray, whose import alone takes 0.6 s, and a study writes a hundred records. The file
    is written in memory, because HDF5 on a full disk fails in ways that cannot be caught, including a crash.
    """
    import h5py

    sizes: dict[str, int] = {}
    for dimensions, values, _ in variables.values():
        sizes |= dict(zip(dimensions, values.shape, strict=True))
    with h5py.File("record.nc", "w", driver="core", backing_store=False, track_order=True) as file:
        file.attrs.update(attributes)
        for name, (_, values, notes) in variables.items():
            kind = h5py.string_dtype() if values.dtype.kind in "UO" else values.dtype
            file.create_dataset(name, data=values.astype(kind)).attrs.update(notes)
        for dimension, size in sizes.items():
            if dimension in variables:
                file[dimension].make_scale(dimension)
            else:
                file.create_dataset(dimension, shape=size, dtype=">f4").make_scale(_NOT_A_VARIABLE.format(size))
        for name, (dimensions, _, _) in variables.items():
            for place, dimension in enumerate(dimensions):
                if dimension != name:
                    file[name].dims[place].attach_scale(file[dimension])
        file.flush()
        return bytes(file.id.get_file_image())


def load_record(path: str | os.PathLike[str]) -> Record:
    """Read a record that `save_record` wrote.

    Args:
        path: of its file, or of the folder of a run.

    Raises:
        InputError: there is no such file, it is not a record, or it is damaged.
    """
    import h5py

    path = as_path(path, "the folder of a run, or its record.nc")
    path = path / "record.nc" if path.is_dir() else path
    try:
        content = read_bytes(path, math.inf)  # its size grows with the duration of the run
    except InputError as error:
        raise InputError(f"{shown_path(path)}: {error}") from None
    whole, seal, checksum = content.rpartition(_SEAL)
    if not seal:
        why = "no checksum ends it: it is cut off, or not of this version"
        raise InputError(f"{path}: not a record of forficula: {why}; run its design again")
    if _seal(whole) != seal + checksum:
        raise InputError(
            f"{path}: not a record of forficula any more: damaged since it was written; run its design again"
        )
    try:
        # h5py is ten times as fast as xarray, and a study reads a hundred records
        with h5py.File(io.BytesIO(whole)) as file:
            written = int(np.squeeze(file.attrs.get("format", 1)))
            if written == _FORMAT:
                return _read(file)
    except (OSError, LookupError, ValueError, TypeError, RuntimeError) as error:
        raise InputError(f"{path}: not a record of forficula: {' '.join(str(error).split())}") from None
    age, design = "an earlier" if written < _FORMAT else "a later", path.parent / "design.toml"
    raise InputError(
        f"{path}: written by {age} state of forficula (format {written}, this one reads {_FORMAT}): run"
        f" `forficula run {design}`"
    )


def as_record(run: object) -> Record:
    """Return a record, the record of a run, or that of a run's folder or file.

    Raises:
        InputError: the argument is not a record, or it cannot be read.
    """
    run = getattr(run, "record", run)  # `Run` is of a layer above
    if isinstance(run, Record):
        return run
    if isinstance(run, str | os.PathLike):
        return load_record(run)
    raise InputError(f"need the record of a run, or its folder, got a {type(run).__name__}")


def _read(file: Any) -> Record:
    """Return the record in an open file."""
    design = design_from_text(file.attrs["design"])
    ends = [file[f"stage_{name}"][()] for name in ("start", "end", "goal_time", "at_rest", "at_goal")]
    waits = file["stage_waited"][()] if "stage_waited" in file else np.zeros(len(ends[0]))
    diverged_at = float(np.squeeze(file.attrs["diverged_at"]))
    shares = json.loads(file.attrs["quasi_static"]) if "quasi_static" in file.attrs else [(None, ())] * len(ends[0])
    stages = tuple(
        StageEnd(
            stage=stage,
            start=float(start),
            end=float(end),
            goal_time=None if np.isnan(goal) else float(goal),
            at_rest=bool(at_rest),
            at_goal=bool(at_goal),
            waited=float(waited),
            share=share,
            lost=tuple(lost),
        )
        for stage, start, end, goal, at_rest, at_goal, waited, (share, lost) in zip(
            design.protocol.stages, *ends, waits, shares, strict=False
        )
    )
    return Record(
        design=design,
        structure=structure_of(design),
        time=file["time"][()],
        series={name: file[name][()] for name in (*VARIABLES, *(name for name in OPTIONAL_VARIABLES if name in file))},
        stages=stages,
        diverged_at=None if np.isnan(diverged_at) else diverged_at,
        doubt=str(file.attrs["doubt"]),
        checks=tuple(map(_check, json.loads(file.attrs.get("checks", "[]")))),
        contact_runs=tuple(ContactRun(**run) for run in json.loads(file.attrs.get("contact_runs", "[]"))),
        kinetic_peak=(float(peak[0]), float(peak[1])) if (peak := file.attrs.get("kinetic_peak")) is not None else None,
        strain_rates=None if (rates := file.attrs.get("strain_rates")) is None else np.atleast_1d(rates),
    )


def _check(written: Mapping[str, Any]) -> NumericalCheck:
    return NumericalCheck(**{**written, "values": {name: tuple(values) for name, values in written["values"].items()}})


def versions(device: str | None = None) -> dict[str, str]:
    """Return the versions of the packages that numbers of runs on a device depend on; None for the processor."""
    names = ("forficula", "mujoco", "numpy", *(() if device is None else ("mujoco-warp", "warp-lang")))
    return {name: _version(name) for name in names}


@cache  # a look-up takes milliseconds
def _version(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:  # an extra, with which another computer wrote the results
        return "not installed"
