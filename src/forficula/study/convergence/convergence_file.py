"""Convergence studies as files, including the curves of their figures."""

from __future__ import annotations

import io
import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import Verdict
from forficula.arrays import Array
from forficula.design import design_from_text, design_text
from forficula.errors import InputError
from forficula.files import write_bytes
from forficula.names import ordinal
from forficula.study.convergence.convergence import Convergence
from forficula.study.convergence.observed_order import OrderFit

# displayed hinge of files of older versions, which do not contain it
_HINGE = 2
_CURVES = {"time": ("times", "s"), "angle": ("angles", "angle of the {hinge} hinge, rad")}


def save_convergence(convergence: Convergence, path: Path) -> None:
    """Write a convergence study as netCDF.

    Raises:
        InputError: the file cannot be written.
    """
    import xarray

    variables = {"value": ("run", convergence.values, {"long_name": "value of the varied setting, SI"})}
    for name, times in convergence.transition_times.items():
        variables[f"{name}_time"] = ("run", times, {"long_name": "s"})
        variables[f"{name}_start"] = ("run", convergence.starts[name], {"long_name": "s"})
    hinge = ordinal(convergence.hinge)
    curves = {
        name: (("run", "row"), _even(getattr(convergence, field)), {"long_name": description.format(hinge=hinge)})
        for name, (field, description) in _CURVES.items()
    }
    words = {
        "rows": ("run", np.array(convergence.rows)),
        "status": ("run", np.array(convergence.statuses, dtype=object)),
        "verdict": ("run", np.array([str(verdict) for verdict in convergence.verdicts], dtype=object)),
    }
    data = xarray.Dataset(variables | curves | words)
    data.attrs = {
        "design": design_text(convergence.design),
        "key": convergence.key,
        "own": convergence.design_value,
        "hinge": convergence.hinge,
        "tolerance": convergence.tolerance,
        "fine": json.dumps(convergence.fine),
        "verdict": convergence.verdict,
        **{
            f"{name}_order": json.dumps(None if fit is None else asdict(fit))
            for name, fit in convergence.orders.items()
        },
    }
    write_bytes(path, data.to_netcdf(engine="h5netcdf"))


def load_convergence(path: Path) -> Convergence:
    """Read a convergence study that `save_convergence` wrote.

    Raises:
        InputError: the file cannot be read, or contains no convergence study.
    """
    import xarray

    try:
        with xarray.open_dataset(io.BytesIO(path.read_bytes()), engine="h5netcdf") as file:
            data = file.load()
        kept = data.attrs
        names = [str(name).removesuffix("_start") for name in data if str(name).endswith("_start")]
        lengths = [int(np.isfinite(row).sum()) for row in data["time"].values]
        return Convergence(
            design=design_from_text(kept["design"]),
            key=kept["key"],
            design_value=float(kept["own"]),
            rows=tuple(int(count) for count in data["rows"].values),
            statuses=tuple(str(status) for status in data["status"].values),
            verdicts=tuple(Verdict(str(verdict)) for verdict in data["verdict"].values),
            tolerance=float(kept["tolerance"]),
            fine=json.loads(kept["fine"]),
            verdict=kept["verdict"],
            values=data["value"].values,
            transition_times={name: data[f"{name}_time"].values for name in names},
            starts={name: data[f"{name}_start"].values for name in names},
            orders={name: _fit(kept[f"{name}_order"]) for name in names},
            times=_uneven(data["time"].values, lengths),
            hinge=int(kept.get("hinge", _HINGE)),
            angles=_uneven(data["angle"].values, lengths),
        )
    except (OSError, LookupError, ValueError, TypeError) as error:
        raise InputError(f"{path}: not a convergence study of forficula: {' '.join(str(error).split())}") from None


def _fit(text: str) -> OrderFit | None:
    values = json.loads(text)
    return None if values is None else OrderFit(**values)


def _even(curves: Sequence[Array]) -> NDArray[np.float32]:
    """Return curves of different lengths as one array, padded with nan, (run, row), in single precision for figures."""
    table = np.full((len(curves), max(len(curve) for curve in curves)), np.nan, dtype=np.float32)
    for row, curve in zip(table, curves, strict=True):
        row[: len(curve)] = curve
    return table


def _uneven(table: NDArray[np.float32], lengths: Sequence[int]) -> tuple[Array, ...]:
    return tuple(row[:length].astype(float) for row, length in zip(table, lengths, strict=True))
