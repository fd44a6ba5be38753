"""Effect of a halved tolerance, and of the sign of a deviation, estimated from existing samples."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np
import scipy
from numpy.typing import NDArray

from forficula.goals.binomial_interval import LEVEL
from forficula.goals.tolerance.probability import Probability, probability
from forficula.serial import Key, Written

Values = NDArray[np.float64]
Booleans = NDArray[np.bool_]

_NORMAL = float(scipy.special.ndtri((1 + LEVEL) / 2))


@dataclass(frozen=True, kw_only=True)
class Narrowed:
    """Effect of one factor's tolerance on the probability of working.

    Attributes:
        gain: increase of the probability if the tolerance is halved.
        gain_low: lower end of its 95 % interval.
        gain_high: upper end.
        below: probability if the factor is below its nominal value.
        above: probability if it is above.
    """

    gain: float
    gain_low: Annotated[float, Key("low")]
    gain_high: Annotated[float, Key("high")]
    below: Annotated[Probability, Written.NEVER]
    above: Annotated[Probability, Written.NEVER]


def narrowed(offsets: Values, works: Booleans, distribution: Literal["uniform", "normal"]) -> Narrowed:
    """Estimate the effect of halving a tolerance, from samples within the full one.

    Samples are weighted by the ratio of their densities in the halved and in the full tolerance (importance sampling).
    For a uniform tolerance the weight is 2 in the inner half and 0 outside. The interval is that of the difference of
    two means over the same samples, to first order.

    Args:
        offsets: offsets of one factor, in widths, (samples,).
        works: whether each sample works, (samples,).
        distribution: distribution of the offsets.
    """
    if distribution == "uniform":
        weights = np.where(np.abs(offsets) <= 0.5, 2.0, 0.0)
    else:
        weights = scipy.stats.norm.pdf(offsets, scale=0.5) / scipy.stats.norm.pdf(offsets)
    gain = scatter = 0.0
    if weights.any():
        share, mean = weights / np.mean(weights), float(np.mean(works))
        halved = float(np.mean(share * works))
        gain = halved - mean
        scatter = _NORMAL * float(np.std(share * (works - halved) - (works - mean))) / np.sqrt(len(works))
    low = offsets < 0
    return Narrowed(
        gain=gain,
        gain_low=gain - scatter,
        gain_high=gain + scatter,
        below=_counted(works[low]),
        above=_counted(works[~low]),
    )


def _counted(works: Booleans) -> Probability:
    if not len(works):
        return Probability(works=0, fails=0, unknown=0, share=None, low=0.0, high=1.0)
    return probability(int(np.sum(works)), int(np.sum(~works)))
