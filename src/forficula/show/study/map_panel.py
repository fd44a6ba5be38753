"""Contents of maps: a table over two of its factors, and the values of each panel."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from forficula.arrays import Array

if TYPE_CHECKING:
    from xarray import DataArray, Dataset


@dataclass(frozen=True, kw_only=True)
class MapPanel:
    """Contents of one panel.

    Attributes:
        title: title of the panel.
        values: values in SI, nan if missing.
        reasons: reason for each missing value, same shape.
        unit: SI unit; empty for verdicts.
    """

    title: str
    values: DataArray
    reasons: DataArray
    unit: str


@dataclass(frozen=True, kw_only=True)
class MapView:
    """Axes of maps, and their part of the table.

    Attributes:
        table: the slice to draw.
        x: factor on the horizontal axis.
        y: factor on the vertical axis; None if it shows the quantity.
        note: text that names the slice, or empty.
        sampled: whether the rows are samples and not a grid.
        bins: whether the cells are bins of several points.
        edges: boundaries of the cells along a factor, SI, if the factor is a continuous axis.
    """

    table: Dataset
    x: str
    y: str | None
    note: str
    sampled: bool
    bins: bool = False
    edges: Mapping[str, Array] = field(default_factory=dict)
