"""Question of a tolerance analysis: a design, its tolerances, and the conditions for working."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.design import Design, key_quantity, key_value
from forficula.goals.deviation import Deviation, allowed_ends
from forficula.goals.limit import Limit
from forficula.goals.outcome_quantity import SOURCES, Source
from forficula.quantities import show_quantity

# name of the smallest of all margins
MARGIN = "margin"


@dataclass(frozen=True, kw_only=True)
class Question:
    """A design, its manufacturing tolerances, and the conditions under which it works.

    Attributes:
        design: nominal design.
        deviations: one per factor, with different keys.
        limits: requirements in addition to the goals of the protocol.
        wanted: limits on the probability of working.
        assumed: whether the deviations are the default ones, because none were given.
    """

    design: Design
    deviations: tuple[Deviation, ...]
    limits: tuple[Limit, ...] = ()
    wanted: tuple[Limit, ...] = ()
    assumed: bool = False

    @property
    def keys(self) -> tuple[str, ...]:
        """Keys of the factors, in their order."""
        return tuple(deviation.key for deviation in self.deviations)

    @property
    def sources(self) -> tuple[Source, ...]:
        """Sources of the quantities that determine whether a design works, the cheapest first."""
        needed = {"run", *(limit.quantity.source for limit in self.limits)}
        return tuple(source for source in SOURCES if source in needed)

    def offsets(self, points: Array) -> Array:
        """Convert points of the unit cube to deviations in widths, (points, factors) both."""
        columns = [deviation.offsets(column) for deviation, column in zip(self.deviations, points.T, strict=True)]
        return np.stack(columns, axis=1)

    def allows(self, offsets: Array) -> bool:
        """Return whether all keys allow their values with these deviations in widths, (factors,)."""
        for deviation, offset in zip(self.deviations, offsets, strict=True):
            quantity, nominal = (
                key_quantity(deviation.key, type(self.design)),
                float(key_value(self.design, deviation.key)),
            )
            if quantity is None:
                continue
            value = nominal + float(offset) * deviation.width(nominal)
            if not (quantity.at_least <= value <= quantity.at_most and quantity.above < value < quantity.below):
                return False
        return True

    def reach(self, factor: int) -> tuple[float, float]:
        """Return the range that the key of a factor allows, in widths: downwards, <= 0, and upwards, >= 0."""
        nominal = float(key_value(self.design, self.keys[factor]))
        width = self.deviations[factor].width(nominal)
        low, high = allowed_ends(self.design, self.keys[factor])
        return ((low - nominal) / width, (high - nominal) / width) if width else (-np.inf, np.inf)

    def value_text(self, factor: int, offset: float) -> str:
        """Return a factor's value at a deviation in widths, with its unit."""
        deviation = self.deviations[factor]
        quantity, nominal = key_quantity(deviation.key, type(self.design)), float(key_value(self.design, deviation.key))
        value = nominal + offset * deviation.width(nominal)
        return f"{value:.4g}" if quantity is None else show_quantity(value, quantity.unit)

    def width_text(self, factor: int) -> str:
        """Return the tolerance of a factor, such as "± 10 %"."""
        deviation = self.deviations[factor]
        quantity = key_quantity(deviation.key, type(self.design))
        return f"± {deviation.size:.4g}" if quantity is None else deviation.text(quantity.unit)
