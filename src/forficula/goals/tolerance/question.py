"""What is asked of a design that is built within tolerances."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.design import Design, key_quantity, key_value
from forficula.goals.deviation import Deviation, allowed_ends
from forficula.goals.limit import Limit
from forficula.goals.outcome_quantity import SOURCES, Source
from forficula.quantities import show_quantity

# what every margin together is called
MARGIN = "margin"


@dataclass(frozen=True, kw_only=True)
class Question:
    """A design, how far off what is built of it may be, and when that works.

    Attributes:
        design: as it is meant.
        deviations: one a factor, none of two with the same key.
        limits: what must hold beside what the protocol asks for.
        wanted: limits on the probability that it works.
        assumed: whether the deviations are the default ones, for none were given.
    """

    design: Design
    deviations: tuple[Deviation, ...]
    limits: tuple[Limit, ...] = ()
    wanted: tuple[Limit, ...] = ()
    assumed: bool = False

    @property
    def keys(self) -> tuple[str, ...]:
        """Of the factors, in their order."""
        return tuple(deviation.key for deviation in self.deviations)

    @property
    def sources(self) -> tuple[Source, ...]:
        """What it takes to know whether a design works, the cheap before the dear."""
        needed = {"run", *(limit.quantity.source for limit in self.limits)}
        return tuple(source for source in SOURCES if source in needed)

    def offsets(self, shares: Array) -> Array:
        """Array of the unit cube as deviations in widths, (points, factors) both."""
        columns = [deviation.offsets(column) for deviation, column in zip(self.deviations, shares.T, strict=True)]
        return np.stack(columns, axis=1)

    def allows(self, offsets: Array) -> bool:
        """Whether every key may have its value that is so many widths off, (factors,)."""
        for deviation, offset in zip(self.deviations, offsets, strict=True):
            quantity, own = key_quantity(deviation.key, type(self.design)), float(key_value(self.design, deviation.key))
            if quantity is None:
                continue
            value = own + float(offset) * deviation.width(own)
            if not (quantity.at_least <= value <= quantity.at_most and quantity.above < value < quantity.below):
                return False
        return True

    def reach(self, factor: int) -> tuple[float, float]:
        """How far down, <= 0, and up, >= 0, the key of a factor allows it to go, in widths."""
        own = float(key_value(self.design, self.keys[factor]))
        width = self.deviations[factor].width(own)
        low, high = allowed_ends(self.design, self.keys[factor])
        return ((low - own) / width, (high - own) / width) if width else (-np.inf, np.inf)

    def value_text(self, factor: int, offset: float) -> str:
        """A factor's value that is so many widths off, with its unit."""
        deviation = self.deviations[factor]
        quantity, own = key_quantity(deviation.key, type(self.design)), float(key_value(self.design, deviation.key))
        value = own + offset * deviation.width(own)
        return f"{value:.4g}" if quantity is None else show_quantity(value, quantity.unit)

    def width_text(self, factor: int) -> str:
        """How far off a factor may be, such as "± 10 %"."""
        deviation = self.deviations[factor]
        quantity = key_quantity(deviation.key, type(self.design))
        return f"± {deviation.size:.4g}" if quantity is None else deviation.text(quantity.unit)
