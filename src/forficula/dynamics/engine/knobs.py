"""Values of a design that can be changed in a compiled model: which of its numbers each changes, and by how much.

These numbers are found by comparison: the design is compiled with the lowest and the highest value, and the numbers
that differ must be linear in the value. Knowledge about the building of structures is therefore not repeated.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from forficula.arrays import Array, Indices
from forficula.design import Design, key_quantity, key_value, with_values
from forficula.dynamics.engine.model import Model, compile_model
from forficula.dynamics.engine.portable_model import model_numbers
from forficula.dynamics.stepping.timestep import stable_timestep
from forficula.errors import InputError
from forficula.quantities import Unit

# candidate keys, and the factors on their values at the ends of their ranges
_FACTORS = {
    "tendon.stiffness": (0.1, 10.0),
    "tendon.rest_length": (0.5, 1.5),
    "tendon.damping": (0.01, 10.0),
    "membrane.youngs_modulus": (0.2, 5.0),
    "membrane.damping": (0.0, 10.0),
    "hinge.stiffness": (0.0, 10.0),
    "hinge.damping": (0.1, 10.0),
    "crease.stiffness": (0.1, 10.0),
    "crease.rest_angle": (-1.0, 1.0),
    "crease.damping": (0.1, 10.0),
    "protocol.gravity": (0.0, 1.0),
}
_SAFE = ("protocol.gravity", "crease.rest_angle")
# largest gravity of the range, SI, if the design's gravity is small
_GRAVITY = 20.0
_MOST_TENDONS = 4
_OPTIONS = "gravity"
_EXACT = 1e-9  # tolerance of linearity, as a share of the largest change
_NARROWER = 0.7  # factor by which a range shrinks if its end is not allowed
_TRIES = 12


@dataclass(frozen=True, kw_only=True)
class KnobChange:
    """Change of some numbers of a compiled model with a value.

    Attributes:
        field: MuJoCo's name of the field; "opt.gravity" for the option.
        places: indices in the flat field, (number,).
        low: numbers at the lowest value, (number,).
        slopes: change per SI unit of the value, (number,).
    """

    field: str
    places: Indices
    low: Array
    slopes: Array


@dataclass(frozen=True, kw_only=True)
class Knob:
    """A value of a design that can be changed while the structure moves.

    Attributes:
        key: of the design.
        unit: of the value.
        value: of the design, SI.
        lowest: lower end of its range, SI.
        highest: upper end of its range, SI; up to this value the design's timestep is short enough.
        changes: of the compiled model.
    """

    key: str
    unit: Unit
    value: float
    lowest: float
    highest: float
    changes: tuple[KnobChange, ...]


def knobs_of(model: Model) -> tuple[Knob, ...]:
    """Return the values of a structure's design that can be changed in its compiled model."""
    return _knobs(model.design)


@lru_cache(maxsize=8)  # pages of a study, and of repeated runs, have the same design
def _knobs(design: Design) -> tuple[Knob, ...]:
    model = compile_model(design)
    result: list[Knob] = []
    taken: set[tuple[str, int]] = set()
    for key in _keys(model):
        knob = _knob(model, key)
        if knob is None:
            continue
        entries = {(change.field, place) for change in knob.changes for place in change.places.tolist()}
        # numbers that two values change would depend on both
        if not entries & taken:
            taken |= entries
            result.append(knob)
    return tuple(result)


def _keys(model: Model) -> list[str]:
    """Return candidate keys; for a few tendons that differ or have names, the keys of each tendon."""
    keys = list(dict.fromkeys(tendon.key for tendon in model.structure.tendons))
    if not 0 < len(keys) <= _MOST_TENDONS or keys == ["tendon"]:
        return list(_FACTORS)
    of_tendons = [f"{tendon}{key.removeprefix('tendon')}" for tendon in keys for key in _FACTORS if "tendon." in key]
    return [*of_tendons, *(key for key in _FACTORS if "tendon." not in key)]


def _factors(key: str) -> tuple[float, float]:
    # keys of single tendons begin with the names of their part and of the tendon
    return _FACTORS.get(key) or _FACTORS[f"tendon.{key.rpartition('.')[2]}"]


def _knob(model: Model, key: str) -> Knob | None:
    """Return the knob of a key; None if the design does not have it, or the model cannot be changed in place."""
    design = model.design
    try:
        quantity, value = key_quantity(key, type(design)), key_value(design, key)
    except InputError:
        return None
    if quantity is None or not isinstance(value, float):
        return None
    low, high = _range(key, value)
    if low == high:
        return None
    lowest, highest = (_allowed(design, key, value, end) for end in (low, high))
    if lowest is None or highest is None:
        return None
    try:
        ends = _all_numbers(compile_model(lowest)), _all_numbers(compile_model(highest))
    except InputError:
        return None
    first, last = float(key_value(lowest, key)), float(key_value(highest, key))
    changes = _changes(ends[0], ends[1], _all_numbers(model), (first, value, last))
    if not changes:
        return None
    return Knob(key=key, unit=quantity.unit, value=value, lowest=first, highest=last, changes=changes)


def _range(key: str, value: float) -> tuple[float, float]:
    """Return the range of a slider for the value."""
    low, high = _factors(key)
    if key == "protocol.gravity":
        return 0.0, max(_GRAVITY, 2 * value)
    if key == "crease.rest_angle":
        return -math.pi, math.pi
    return low * value, high * value


def _allowed(design: Design, key: str, value: float, end: float) -> Design | None:
    """Return a design with the value at an end of a range, or as near to it as its rules and timestep allow."""
    for _ in range(_TRIES):
        try:
            changed = with_values(design, {key: end})
            # smaller values never need a shorter timestep, and safe keys do not affect it
            if end <= value or key in _SAFE or float(design.protocol.timestep) <= stable_timestep(changed):
                return changed
        except InputError:
            pass
        end = value + _NARROWER * (end - value)
    return None


def _all_numbers(model: Model) -> dict[str, Array]:
    numbers, engine = model_numbers(model), model.engine
    # tendons that only measure have no spring, but the engine sets an arbitrary spring length
    sprung = np.isin(np.arange(engine.ntendon), [*model.tendons, *model.springs])
    if "tendon_lengthspring" in numbers:
        numbers["tendon_lengthspring"][np.repeat(~sprung, 2)] = 0.0
    gravity = np.asarray(getattr(engine.opt, _OPTIONS), dtype=np.float64)
    return {**numbers, f"opt.{_OPTIONS}": gravity.copy()}


def _changes(
    low: Mapping[str, Array], high: Mapping[str, Array], middle: Mapping[str, Array], values: tuple[float, float, float]
) -> tuple[KnobChange, ...]:
    """Return the differences between two models if a third one is on a straight line between them; else nothing.

    Args:
        low: numbers of the model with the lowest value.
        high: numbers of the model with the highest value.
        middle: numbers of the model with the value between.
        values: these three values, ascending.
    """
    first, value, last = values
    changes = []
    for name, lowest in low.items():
        highest, between = high.get(name), middle.get(name)
        if highest is None or between is None or not lowest.shape == highest.shape == between.shape:
            return ()
        places = np.flatnonzero((lowest != highest) | (lowest != between))
        if not len(places):
            continue
        slopes = (highest[places] - lowest[places]) / (last - first)
        on_line = lowest[places] + slopes * (value - first)
        size = np.abs(np.stack([lowest[places], highest[places]])).max(axis=0)
        if np.any(np.abs(on_line - between[places]) > _EXACT * size):
            return ()
        # differences of the size of rounding do not count
        moved = np.abs(highest[places] - lowest[places]) > _EXACT * size
        if moved.any():
            changes.append(
                KnobChange(field=name, places=places[moved], low=lowest[places][moved], slopes=slopes[moved])
            )
    return tuple(changes)
