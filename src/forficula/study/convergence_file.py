"""Convergence studies in a file, with the curves that their figures show."""

from __future__ import annotations

import io
import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import Verdict
from forficula.design import design_from_text, design_text
from forficula.errors import InputError
from forficula.files import write_bytes
from forficula.names import ordinal
from forficula.study.convergence import Convergence
from forficula.study.observed_order import OrderFit

Array = NDArray[np.float64]

_BY_RUN = {
    "value": ("values", "of the setting that is varied, SI"),
    "fold_time": ("fold_times", "s"),
    "unfold_time": ("unfold_times", "s"),
    "fold_start": ("fold_starts", "s"),
    "unfold_start": ("unfold_starts", "s"),
}
# the hinge of files from before they said which
_HINGE = 2
_CURVES = {"time": ("times", "s"), "angle": ("angles", "of the {hinge} distal hinge, rad")}


def save_convergence(convergence: Convergence, path: Path) -> None:
    """Write a convergence study as netCDF.

    Raises:
        InputError: it cannot be written.
    """
    import xarray

    variables = {
        name: ("run", getattr(convergence, field), {"long_name": say}) for name, (field, say) in _BY_RUN.items()
    }
    hinge = ordinal(convergence.hinge)
    curves = {
        name: (("run", "row"), _even(getattr(convergence, field)), {"long_name": say.format(hinge=hinge)})
        for name, (field, say) in _CURVES.items()
    }
    words = {
        "rows": ("run", np.array(convergence.rows)),
        "status": ("run", np.array(convergence.statuses, dtype=object)),
        "verdict": ("run", np.array([str(verdict) for verdict in convergence.verdicts], dtype=object)),
    }
    data = xarray.Dataset(variables | curves | words)
    fits = {name: getattr(convergence, name) for name in ("fold_order", "unfold_order")}
    data.attrs = {
        "design": design_text(convergence.design),
        "key": convergence.key,
        "own": convergence.own,
        "hinge": convergence.hinge,
        "tolerance": convergence.tolerance,
        "fine": json.dumps(convergence.fine),
        "verdict": convergence.verdict,
        **{name: json.dumps(None if fit is None else asdict(fit)) for name, fit in fits.items()},
    }
    write_bytes(path, data.to_netcdf(engine="h5netcdf"))


def load_convergence(path: Path) -> Convergence:
    """Read a convergence study that `save_convergence` wrote.

    Raises:
        InputError: it cannot be read, or is none.
    """
    import xarray

    try:
        with xarray.open_dataset(io.BytesIO(path.read_bytes()), engine="h5netcdf") as file:
            data = file.load()
        kept = data.attrs
        lengths = [int(np.isfinite(row).sum()) for row in data["time"].values]
        return Convergence(
            design=design_from_text(kept["design"]),
            key=kept["key"],
            own=float(kept["own"]),
            rows=tuple(int(count) for count in data["rows"].values),
            statuses=tuple(str(status) for status in data["status"].values),
            verdicts=tuple(Verdict(str(verdict)) for verdict in data["verdict"].values),
            tolerance=float(kept["tolerance"]),
            fine=json.loads(kept["fine"]),
            verdict=kept["verdict"],
            values=data["value"].values,
            fold_times=data["fold_time"].values,
            unfold_times=data["unfold_time"].values,
            fold_starts=data["fold_start"].values,
            unfold_starts=data["unfold_start"].values,
            times=_uneven(data["time"].values, lengths),
            hinge=int(kept.get("hinge", _HINGE)),
            angles=_uneven(data["angle"].values, lengths),
            fold_order=_fit(kept["fold_order"]),
            unfold_order=_fit(kept["unfold_order"]),
        )
    except (OSError, LookupError, ValueError, TypeError) as error:
        raise InputError(f"{path}: not a convergence study of forficula: {' '.join(str(error).split())}") from None


def _fit(text: str) -> OrderFit | None:
    values = json.loads(text)
    return None if values is None else OrderFit(**values)


def _even(curves: Sequence[Array]) -> NDArray[np.float32]:
    """Curves of different lengths in one array, nan after their ends, (run, row); single precision draws them."""
    table = np.full((len(curves), max(len(curve) for curve in curves)), np.nan, dtype=np.float32)
    for row, curve in zip(table, curves, strict=True):
        row[: len(curve)] = curve
    return table


def _uneven(table: NDArray[np.float32], lengths: Sequence[int]) -> tuple[Array, ...]:
    return tuple(row[:length].astype(float) for row, length in zip(table, lengths, strict=True))
