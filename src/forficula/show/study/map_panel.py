"""What maps show: a table in two of its factors, and what each pair of axes has of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from xarray import DataArray, Dataset


@dataclass(frozen=True, kw_only=True)
class MapPanel:
    """What one pair of axes shows.

    Attributes:
        title: what it is.
        values: in SI, nan where there is none.
        reasons: why there is none, of the same shape; read only there.
        unit: SI; empty where there are verdicts only.
    """

    title: str
    values: DataArray
    reasons: DataArray
    unit: str


@dataclass(frozen=True, kw_only=True)
class MapView:
    """Where things are drawn: over which factors, and what of the table.

    Attributes:
        table: the slice that is drawn.
        x: factor across.
        y: factor upwards, or None where a quantity is.
        note: which slice it is, or nothing.
        sampled: whether the rows are samples rather than a grid.
    """

    table: Dataset
    x: str
    y: str | None
    note: str
    sampled: bool
