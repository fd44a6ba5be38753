"""Bins of a study with more points than a map can show: the mean value and the most frequent outcome of each bin."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Array
from forficula.names import counted, listed
from forficula.show.study.factor_text import plain_name
from forficula.show.study.map_panel import MapPanel, MapView
from forficula.show.study.outcome_looks import NO_POINTS

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

Indices = NDArray[np.int64]
Words = NDArray[np.object_]

# A map of more points is drawn in bins, because more marks or cells are not legible. [chosen]
_MOST_POINTS = 20_000
# Largest number of bins along a factor. [chosen]
MOST_BINS = 200
# Average number of sampled points in a bin: the standard error of a share is 0.1 or less. [chosen]
_POINTS_PER_BIN = 25
# Ratio of the largest to the least sampled value from which the bins may have equal ratios. [chosen]
_LEAST_RATIO = 10


@dataclass(frozen=True, kw_only=True)
class _BinAxis:
    """Bins along a factor.

    Attributes:
        index: bin of each value of the factor, or of each sample.
        values: a value of each bin, SI: its middle for sampled numbers.
        edges: boundaries of the bins, SI; None for words and for the values of a grid.
    """

    index: Indices
    values: NDArray[np.generic]
    edges: Array | None


@dataclass(frozen=True, kw_only=True)
class Bins:
    """Bins of the points of a view.

    Attributes:
        view: view with one cell for each bin.
        dimensions: dimensions of the points, in the order of `index`.
        index: number of the bin of each point, (point,).
        counts: number of points in each bin, (bin,).
        others: names of the factors that vary within a bin.
    """

    view: MapView
    dimensions: tuple[str, ...]
    index: Indices
    counts: Indices
    others: tuple[str, ...]

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of bins upwards and across, or across only."""
        return tuple(self.view.table[name].size for name in (self.view.y, self.view.x) if name)

    @property
    def size_text(self) -> str:
        """Number of points and bins, such as "1 000 000 points in 200 x 200 bins"."""
        points, bins = f"{len(self.index):,}".replace(",", " "), " x ".join(map(str, reversed(self.shape)))
        others = f", over all values of {listed(self.others)}" if self.others else ""
        return f"{points} points in {bins} bins{others}"

    def text(self, *, numbers: bool) -> str:
        """Return the number of points and bins, and the meaning of the colours of numbers or of outcomes."""
        colour = (
            "mean of a bin; if most of its points have no value, their most frequent outcome"
            if numbers
            else "most frequent outcome of a bin"
        )
        return f"{self.size_text}; colour: {colour}"

    def panel(self, panel: MapPanel) -> MapPanel:
        """Return a panel with the mean and the most frequent reason of each bin."""
        values, reasons = (array.transpose(*self.dimensions).values.ravel() for array in (panel.values, panel.reasons))
        means, words = self.means_and_words(values.astype(float), reasons)
        return replace(panel, values=self._cells(means), reasons=self._cells(words))

    def means_and_words(self, values: Array, words: Words) -> tuple[Array, Words]:
        """Return the mean value of each bin, nan if most of its points have no value, and the word of these points.

        Args:
            values: value of each point, nan if missing.
            words: word of each point that counts if its value is missing.
        """
        known = np.isfinite(values)
        numbers = self._count(known)
        sums = np.bincount(self.index[known], weights=values[known], minlength=len(self.counts))
        has_mean = (2 * numbers >= self.counts) & (numbers > 0)
        means = np.full(len(self.counts), math.nan)
        means[has_mean] = sums[has_mean] / numbers[has_mean]
        return means, self.most_frequent(words, ~known)

    def shares(self, words: Words) -> list[str]:
        """Return the number of points of each bin, and the share of each word, as text."""
        codes, names = word_codes(words)
        numbers = np.stack([self._count(codes == code) for code in range(len(names))], axis=1)
        texts = []
        for row, count in zip(numbers.tolist(), self.counts.tolist(), strict=True):
            parts = sorted(((number, name) for number, name in zip(row, names, strict=True) if number), reverse=True)
            listed = ", ".join(f"{100 * number / count:.3g} % {name}" for number, name in parts)
            texts.append(f"{counted(count, 'point')}{f': {listed}' if listed else ''}")
        return texts

    def bin_of(self, point: int, table: Dataset) -> int | None:
        """Return the bin of a point of the study's table, by its index; None if the view does not contain the point."""
        if self.dimensions == ("sample",):
            return int(self.index[point])
        outcome = table["outcome"]
        places = dict(zip(outcome.dims, np.unravel_index(point, outcome.shape), strict=True))
        for name, place in places.items():
            if name not in self.dimensions and int(place) != table.sizes[name] // 2:
                return None
        sizes = tuple(table.sizes[name] for name in self.dimensions)
        return int(self.index[np.ravel_multi_index([int(places[name]) for name in self.dimensions], sizes)])

    def most_frequent(self, words: Words, among: NDArray[np.bool_]) -> Words:
        """Return the most frequent word in each bin among some of the points."""
        codes, names = word_codes(words)
        largest = np.zeros(len(self.counts), dtype=np.int64)
        result = np.full(len(self.counts), NO_POINTS, dtype=object)
        for code, name in enumerate(names):
            numbers = self._count(among & (codes == code))
            result[numbers > largest] = name
            largest = np.maximum(largest, numbers)
        return result

    def _count(self, among: NDArray[np.bool_]) -> Indices:
        return np.bincount(self.index[among], minlength=len(self.counts))

    def _cells(self, values: NDArray[np.generic]) -> DataArray:
        from xarray import DataArray

        names = [name for name in (self.view.y, self.view.x) if name]
        return DataArray(values.reshape(self.shape), dims=names)


def word_codes(words: Words) -> tuple[Indices, list[str]]:
    """Return the number of each word, and the words by number."""
    numbers: dict[str, int] = {}
    codes = np.fromiter((numbers.setdefault(word, len(numbers)) for word in words.tolist()), np.int64, len(words))
    return codes, [str(name) for name in numbers]


def bins_of(view: MapView, most: int = MOST_BINS) -> Bins | None:
    """Return the bins of a view; None if all of its points can be drawn.

    Args:
        view: the view.
        most: largest number of bins along a factor.
    """
    from xarray import Dataset

    names = [name for name in (view.y, view.x) if name]
    dimensions = ("sample",) if view.sampled else tuple(names)
    points = math.prod(view.table.sizes[name] for name in dimensions)
    if points <= _MOST_POINTS:
        return None
    number = min(most, _fitting(points, len(names))) if view.sampled else most
    axes = {name: _axis(view, view.table[name], number) for name in names}
    index: Indices = np.zeros(1, dtype=np.int64)
    for name in names:
        # rows of bins follow one another upwards
        index = index * axes[name].values.size
        index = index + axes[name].index if view.sampled else np.add.outer(index, axes[name].index).ravel()
    coordinates = {name: (name, axis.values, view.table[name].attrs) for name, axis in axes.items()}
    binned = replace(
        view,
        table=Dataset(coords=coordinates, attrs=view.table.attrs),
        sampled=view.sampled and view.y is None,
        bins=True,
        edges={name: axis.edges for name, axis in axes.items() if axis.edges is not None},
    )
    varied = [values for name, values in view.table.coords.items() if values.dims == ("sample",) and name not in names]
    return Bins(
        view=binned,
        dimensions=dimensions,
        index=index,
        counts=np.bincount(index, minlength=math.prod(axis.values.size for axis in axes.values())),
        others=tuple(plain_name(values) for values in varied if values.name != "sample"),
    )


def binned_page(view: MapView, panels: Sequence[MapPanel]) -> tuple[MapView, Sequence[MapPanel], str]:
    """Return the view, the panels and a description of the panels; many points are shown as bins."""
    bins = bins_of(view)
    if bins is None:
        return view, panels, ""
    return bins.view, [bins.panel(panel) for panel in panels], bins.text(numbers=bool(panels[0].unit))


def _fitting(points: int, axes: int) -> int:
    return max(1, int((points / _POINTS_PER_BIN) ** (1 / axes)))


def _axis(view: MapView, factor: DataArray, most: int) -> _BinAxis:
    """Return at most a number of bins of equal widths, or of equal ratios if the values are spread over decades."""
    values = factor.values
    if not view.sampled:
        count = min(values.size, most)
        index = np.arange(values.size) * count // values.size
        middle_places = [int(np.flatnonzero(index == number).mean()) for number in range(count)]
        return _BinAxis(index=index, values=values[middle_places], edges=None)
    if values.dtype.kind not in "iuf":
        codes, names = word_codes(values.astype(object))
        return _BinAxis(index=codes, values=np.array(names, dtype=object), edges=None)
    numbers = values.astype(float)
    is_log = _is_logarithmic(numbers)
    along = np.log(numbers) if is_log else numbers
    low, high = float(along.min()), float(along.max())
    edges = np.linspace(low, high, (most if high > low else 1) + 1)
    index = np.clip(np.searchsorted(edges, along, side="right") - 1, 0, len(edges) - 2)
    middles = (edges[1:] + edges[:-1]) / 2
    if is_log:
        return _BinAxis(index=index, values=np.exp(middles), edges=np.exp(edges))
    return _BinAxis(index=index, values=middles, edges=edges)


def _is_logarithmic(values: Array) -> bool:
    """Return whether the logarithms of values are spread more evenly than the values."""
    low, high = float(values.min()), float(values.max())
    if low <= 0 or high < _LEAST_RATIO * low:
        return False
    median = float(np.median(values))
    share, log_share = (median - low) / (high - low), math.log(median / low) / math.log(high / low)
    return abs(log_share - 0.5) < abs(share - 0.5)
