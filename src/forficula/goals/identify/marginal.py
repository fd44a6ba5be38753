"""What facts say of each unknown by itself: what is believed of it, and what agrees."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import scipy
from numpy.typing import NDArray

if TYPE_CHECKING:
    import xarray

# of an interval, from end to end
_ENDS = (0.05, 0.95)
# below which a difference is told of as one
_TOLD = 0.05


@dataclass(frozen=True, kw_only=True)
class Marginal:
    """An unknown, in what is believed and in what agrees.

    Attributes:
        name: of the coordinate in the result.
        key: of the design.
        believed: 5th and 95th percentile of the drawn samples, as the coordinate has them; words where it has such.
        agrees: ends of the range of what agrees between the samples, as the coordinate has them, or some of the choices
            of what has such; of a result without these, 5th and 95th percentile of the samples that agree.
        chance: that samples that agree by chance would differ as much from the others (Kolmogorov and Smirnov) in any
            of the unknowns that are not told of more surely (Holm 1979, jstor.org/stable/4615733): of fifteen of which
            facts tell nothing, every other time one differs by itself with a chance below 5 %.
    """

    name: str
    key: str
    believed: tuple[object, object]
    agrees: tuple[object, ...]
    chance: float

    @property
    def told(self) -> bool:
        """Whether the facts tell something of it."""
        return self.chance < _TOLD


def marginals(result: xarray.Dataset) -> list[Marginal]:
    """All unknowns of a result, those first that facts tell most of."""
    drawn = ~result["directed"].values & (result["status"].values == "ran")
    agrees = result["agrees"].values
    found = []
    for name in unknowns_of(result):
        shares = result[f"{name}_share"].values
        others = shares[drawn & ~agrees]
        chance = float(scipy.stats.ks_2samp(shares[agrees], others).pvalue) if agrees.any() and len(others) else 1.0
        values = result[name].values
        found.append(
            Marginal(
                name=name,
                key=str(result[name].attrs["key"]),
                believed=_ends(values[drawn], shares[drawn]),
                agrees=_range(result[name]) or _ends(values[agrees], shares[agrees]),
                chance=chance,
            )
        )
    return _among_all(sorted(found, key=lambda each: each.chance))


def _among_all(found: Sequence[Marginal]) -> list[Marginal]:
    """Marginals with the chance of each by itself, the least first, told as that of one among all."""
    chances = np.maximum.accumulate([each.chance * (len(found) - place) for place, each in enumerate(found)])
    return [replace(each, chance=min(float(chance), 1.0)) for each, chance in zip(found, chances, strict=True)]


def unknowns_of(result: xarray.Dataset) -> list[str]:
    """The names of the coordinates of unknowns; read from a file, one alone is no list."""
    names: str | Sequence[str] = result.attrs["unknowns"]
    return [names] if isinstance(names, str) else [str(name) for name in names]


def _range(coordinate: xarray.DataArray) -> tuple[object, ...]:
    """What agrees between the samples; empty where a result does not say so."""
    told = coordinate.attrs
    if "agrees_choices" in told:
        # read from a file, one alone is no list
        return tuple(str(value) for value in np.atleast_1d(told["agrees_choices"]))
    return (float(told["agrees_low"]), float(told["agrees_high"])) if "agrees_low" in told else ()


def _ends(values: NDArray[np.generic], shares: NDArray[np.float64]) -> tuple[object, object]:
    """The values at both ends of the interval, in the order of the shares."""
    order = np.argsort(shares, kind="stable")
    if not len(order):
        return None, None
    places = [order[min(int(end * len(order)), len(order) - 1)] for end in _ENDS]
    return values[places[0]], values[places[1]]
