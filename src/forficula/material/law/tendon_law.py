"""Force of a tendon as a function of its length, rate and history."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.law.maxwell_element import MaxwellElement


@dataclass(frozen=True, kw_only=True)
class ElasticLaw:
    """An elastic tendon that pulls beyond its resting length, without hysteresis.

    With the extension x = length - rest_length the force is linear x + quadratic x^2 + cubic x^3 for x > 0, and 0 when
    slack (Binder et al. 2025, doi 10.3390/biomimetics11010009, whose tendons are linear). The tendon must pull at every
    extension: linear >= 0, cubic >= 0, and quadratic either >= 0 or > -2 sqrt(linear cubic). It may soften, but never
    push. All values may be 0. The numbers may be arrays for many tendons, which broadcast with the lengths.

    Attributes:
        rest_length: m.
        linear: N/m.
        quadratic: N/m^2.
        cubic: N/m^3.

    Raises:
        InputError: a number out of these bounds or not finite.
    """

    rest_length: float
    linear: float
    quadratic: float = 0.0
    cubic: float = 0.0

    def __post_init__(self) -> None:
        numbers = (self.rest_length, self.linear, self.quadratic, self.cubic)
        # fast path, because almost all laws pass this test and many are created
        if all(isinstance(number, float) and 0 <= number < math.inf for number in numbers):
            return
        units = {"rest_length": "m", "linear": "N/m", "quadratic": "N/m^2", "cubic": "N/m^3"}
        for name, unit in units.items():
            value = getattr(self, name)
            if not np.all(np.isfinite(value)):
                raise InputError(f"{name}: need a finite number, got {np.min(value):g} {unit}")
            if np.any(value < 0) and name != "quadratic":
                raise InputError(f"{name}: need >= 0, got {np.min(value):g} {unit}")
        lowest = 2 * np.sqrt(self.linear) * np.sqrt(self.cubic)
        if not np.all((self.quadratic >= 0) | (self.quadratic > -lowest)):
            rule = f"> {np.min(-lowest):g} N/m^2, -2 sqrt(linear cubic)," if np.any(lowest) else ">= 0"
            got = f"{np.min(self.quadratic):g} N/m^2"
            raise InputError(f"quadratic: need {rule} or the tendon would push at some extension, got {got}")

    @cached_property
    def _straight(self) -> bool:
        """Return whether the force is proportional to the extension, so that products with zeros can be left out."""
        return not (np.any(self.quadratic) or np.any(self.cubic))

    def _extension(self, length: ArrayLike) -> Array:
        return np.maximum(np.asarray(length, dtype=np.float64) - self.rest_length, 0.0)

    def force(self, length: ArrayLike) -> Array:
        """Compute the pull at a length, N, in the shape of `length` (m)."""
        return np.asarray(self._force_at(self._extension(length)))

    def energy(self, length: ArrayLike) -> Array:
        """Compute the stored energy, the integral of the force, J, in the shape of `length` (m)."""
        return np.asarray(self._energy_at(self._extension(length)))

    def stiffness(self, length: ArrayLike) -> Array:
        """Compute the slope of the force, N/m, in the shape of `length` (m); at the resting length, that when taut."""
        return np.where(np.asarray(length) < self.rest_length, 0.0, self._slope_at(self._extension(length)))

    def expansion(self, length: Array) -> tuple[Array, Array, Array]:
        """Compute energy, pull and slope of the force together, in the shape of `length` (m)."""
        x = self._extension(length)
        slope = np.where(length < self.rest_length, 0.0, self._slope_at(x))
        return self._energy_at(x), self._force_at(x), slope

    def _energy_at(self, x: Array) -> Array:
        """Compute the energy at an extension, J."""
        if self._straight:
            return x**2 * (self.linear / 2)
        return x**2 * (self.linear / 2 + x * (self.quadratic / 3 + x * self.cubic / 4))

    def _force_at(self, x: Array) -> Array:
        if self._straight:
            return x * self.linear
        return x * (self.linear + x * (self.quadratic + x * self.cubic))

    def _slope_at(self, x: Array) -> Array:
        if self._straight:
            return np.asarray(self.linear)
        return self.linear + x * (2 * self.quadratic + x * 3 * self.cubic)

    def released(self, length: ArrayLike, shortening: ArrayLike) -> Array:
        """Compute the energy that is released when the tendon shortens.

        The difference of the two energies is computed as a product with the shortening, which is accurate also if the
        shortening is small.

        Args:
            length: length before, m, any shape.
            shortening: >= 0, m, of a shape that broadcasts with `length`; shortening beyond slack releases no energy.

        Returns:
            Energy, J, in the common shape.
        """
        x = self._extension(length)
        d = np.minimum(np.asarray(shortening, dtype=np.float64), x)
        # the mean force from x - d to x
        linear = self.linear * (x - d / 2)
        quadratic = self.quadratic * (x**2 - d * (x - d / 3))
        cubic = self.cubic * (x**3 - d * (1.5 * x**2 - d * (x - d / 4)))
        return np.asarray(d * (linear + quadratic + cubic))


def stacked_laws(laws: Sequence[ElasticLaw]) -> ElasticLaw:
    """Combine many laws to one with arrays, (law,), which broadcast with lengths, (..., law)."""
    numbers: Any = {field.name: np.array([getattr(law, field.name) for law in laws]) for field in fields(ElasticLaw)}
    return ElasticLaw(**numbers)


@dataclass(frozen=True, kw_only=True)
class TendonLaw:
    """The law of a tendon for simulation: a pull-only spring, a damper, Maxwell branches, and a yield.

    With the extension x = length - rest_length and its rate v, the pull is the sum of a x + b x^2 + c x^3,
    a v + b v|v| + c v^3 and the forces of the branches if x > 0 and this sum is > 0, otherwise 0. If `pushes` is true,
    damper and branches act at any x and with either sign. Where x would exceed `yield_extension`, the resting length
    creeps so that it does not (ideal plasticity, MuJoCo's `springyield`).

    Attributes:
        rest_length: m.
        stiffness: N/m, N/m^2, N/m^3.
        damping: N s/m, N s^2/m^2, N s^3/m^3; None if the material's viscosity is not known.
        branches: Maxwell branches, any number.
        yield_extension: m, > 0; None if the tendon never yields.
        pushes: whether damper and branches act at any length and also push, as in a strut.

    Raises:
        InputError: values that `ElasticLaw` refuses, damping < 0, or a yield extension that is not > 0.
    """

    rest_length: float
    stiffness: tuple[float, float, float]
    damping: tuple[float, float, float] | None = None
    branches: tuple[MaxwellElement, ...] = ()
    yield_extension: float | None = None
    pushes: bool = False

    def __post_init__(self) -> None:
        _ = self.elastic
        if self.damping is not None and not all(np.isfinite(value) and value >= 0 for value in self.damping):
            raise InputError(f"damping: need three finite numbers >= 0, got {self.damping}")
        at = self.yield_extension
        if at is not None and not (np.isfinite(at) and at > 0):
            raise InputError(f"yield_extension: need a finite number > 0, got {at:g} m")

    @property
    def elastic(self) -> ElasticLaw:
        """The spring of the tendon."""
        linear, quadratic, cubic = self.stiffness
        return ElasticLaw(rest_length=self.rest_length, linear=linear, quadratic=quadratic, cubic=cubic)

    @property
    def may_push(self) -> bool:
        """Whether damper or branches could push without the rule that the tendon only pulls."""
        return bool(self.branches) or any(self.damping or ())

    @property
    def must_push(self) -> bool:
        """Whether the simulation cannot prevent pushing, which it can only with linear damping and without yield."""
        return self.may_push and (any((self.damping or ())[1:]) or self.yield_extension is not None)

    @property
    def lets_go(self) -> bool:
        """Whether the simulation limits the sum of spring, damper and branches to pulling, and to 0 while slack.

        It does not for a law that `pushes` or must push, and an elastic law needs no limit.
        """
        return self.may_push and not self.pushes and not self.must_push

    @property
    def yield_force(self) -> float | None:
        """Largest force of the spring, N; None if the tendon never yields."""
        if self.yield_extension is None:
            return None
        return float(self.elastic.force(self.rest_length + self.yield_extension))
