"""Information on each single unknown: its prior, and the range that agrees with the facts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import scipy
from numpy.typing import NDArray

if TYPE_CHECKING:
    import xarray

# percentiles of an interval
_ENDS = (0.05, 0.95)
# significance level of a difference
_SIGNIFICANT = 0.05


@dataclass(frozen=True, kw_only=True)
class Marginal:
    """Prior and agreeing range of one unknown.

    Attributes:
        name: name of the coordinate in the result.
        key: key of the design.
        believed: 5th and 95th percentile of the drawn samples, as in the coordinate; words for choices.
        agrees: ends of the agreeing range between the samples, as in the coordinate, or the agreeing choices. For a
            result without these, 5th and 95th percentile of the agreeing samples.
        chance: significance of the difference between agreeing and other samples (Kolmogorov and Smirnov), corrected
            for the number of unknowns (Holm 1979, jstor.org/stable/4615733). Without the correction, among fifteen
            unknowns on which facts have no information, one is below 5 % in every second case.
    """

    name: str
    key: str
    believed: tuple[object, object]
    agrees: tuple[object, ...]
    chance: float

    @property
    def significant(self) -> bool:
        """Whether the facts give information on this unknown."""
        return self.chance < _SIGNIFICANT


def marginals(result: xarray.Dataset) -> list[Marginal]:
    """Return all unknowns of a result, the most significant first."""
    drawn = ~result["directed"].values & (result["status"].values == "ran")
    agrees = result["agrees"].values
    unknowns = []
    for name in unknowns_of(result):
        shares = result[f"{name}_share"].values
        others = shares[drawn & ~agrees]
        chance = float(scipy.stats.ks_2samp(shares[agrees], others).pvalue) if agrees.any() and len(others) else 1.0
        values = result[name].values
        unknowns.append(
            Marginal(
                name=name,
                key=str(result[name].attrs["key"]),
                believed=_ends(values[drawn], shares[drawn]),
                agrees=_range(result[name]) or _ends(values[agrees], shares[agrees]),
                chance=chance,
            )
        )
    return _among_all(sorted(unknowns, key=lambda unknown: unknown.chance))


def _among_all(unknowns: Sequence[Marginal]) -> list[Marginal]:
    """Correct the significance of each unknown for the number of unknowns; they are sorted by it."""
    chances = np.maximum.accumulate(
        [unknown.chance * (len(unknowns) - index) for index, unknown in enumerate(unknowns)]
    )
    return [replace(unknown, chance=min(float(chance), 1.0)) for unknown, chance in zip(unknowns, chances, strict=True)]


def unknowns_of(result: xarray.Dataset) -> list[str]:
    """Return the names of the coordinates of unknowns. In a file, a single one is stored as text, not as a list."""
    names: str | Sequence[str] = result.attrs["unknowns"]
    return [names] if isinstance(names, str) else [str(name) for name in names]


def _range(coordinate: xarray.DataArray) -> tuple[object, ...]:
    """Return the agreeing range between the samples; empty if a result lacks it."""
    attributes = coordinate.attrs
    if "agrees_choices" in attributes:
        # in a file, a single choice is stored as text, not as a list
        return tuple(str(value) for value in np.atleast_1d(attributes["agrees_choices"]))
    return (float(attributes["agrees_low"]), float(attributes["agrees_high"])) if "agrees_low" in attributes else ()


def _ends(values: NDArray[np.generic], shares: NDArray[np.float64]) -> tuple[object, object]:
    """Return the values at both ends of the interval, in the order of the shares."""
    order = np.argsort(shares, kind="stable")
    if not len(order):
        return None, None
    indices = [order[min(int(end * len(order)), len(order) - 1)] for end in _ENDS]
    return values[indices[0]], values[indices[1]]
