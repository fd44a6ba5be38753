"""Designs in other units and designs scaled in size: both multiply each value according to its dimension."""

from __future__ import annotations

import math
from collections.abc import Collection
from typing import Any, TypeVar

from forficula.design.contact import FIRST_TIME_CONSTANT
from forficula.design.design import Design
from forficula.design.files.design_file import AnyDesign, as_design, with_values
from forficula.design.files.provenance import scaled_source
from forficula.design.protocol import read_goal
from forficula.design.section import Quantity, Section, field_quantity
from forficula.errors import InputError
from forficula.quantities import as_written, dimension, format_quantity, parse_quantity, show_quantity

_SectionOf = TypeVar("_SectionOf", bound=Section)
_DesignOf = TypeVar("_DesignOf", bound=Design)

# smaller than atoms, larger than mountains; within this range a fifth power is a float
_SMALLEST, _LARGEST = 1e-9, 1e9


def in_units(design: Design, *, length: float, mass: float, time: float) -> Design:
    """Write every value of a design in other units of length, mass and time.

    Args:
        design: in SI.
        length: the new unit of length, m.
        mass: the new unit of mass, kg.
        time: the new unit of time, s.

    Returns:
        The same design with its numbers in the new units. It is not checked again, because the bounds are SI.

    Raises:
        InputError: a number in these units is not finite.
    """
    resolved = design.with_contact_time(FIRST_TIME_CONSTANT).settled()
    return _rescaled(resolved, length, mass, time, f"{design.name}: ")


def scale_design(design: AnyDesign, factor: float, *, natural: bool = False) -> Design:
    """Scale the size of a structure at fixed modulus and density, so that its motion is geometrically similar.

    Stiffness and time are proportional to the factor, energy and torque to its cube, inertia to its fifth power. The
    speed of the tips does not change (dimensional analysis; Ilton et al. 2018, arXiv 1711.04920, measured that speed).

    Args:
        design: the design, its name or its path.
        factor: size of the new structure divided by that of the old one.
        natural: whether quantities that do not depend on size keep their values: gravity and relaxation times.

    Returns:
        The scaled design. In scaled time its motion is the same, except for effects of quantities that `natural`
        leaves unchanged. A time constant of contact "auto" becomes that of the first run, scaled.

    Raises:
        InputError: no such design, the factor is not between 1e-9 and 1e9, or a value leaves its bounds.
    """
    design = as_design(design)
    if not isinstance(factor, int | float) or not _SMALLEST <= factor <= _LARGEST:
        raise InputError(f"factor: need >= {_SMALLEST:g} and <= {_LARGEST:g}, got {as_written(factor)}")
    design = design.with_contact_time(FIRST_TIME_CONSTANT)
    scaled = _rescaled(design.settled(), 1 / factor, 1 / factor**3, 1 / factor)
    scaled = _with_scaled_bounds(_with_idle_stops(scaled, design), design, factor)
    if natural:
        # a value that a rule chooses is not a property of a material, so it is scaled
        scaled = _with_natural(scaled, design.settled(), {(choice.section, choice.key) for choice in design.chosen})
    source = scaled_source(design.name, design.source, factor)
    return with_values(scaled, {"name": f"{design.name}-x{factor:g}", "source": source})


def _with_idle_stops(scaled: _DesignOf, original: Design) -> _DesignOf:
    """Return a scaled design, and its parts, with the original compliance of stops where no body has stops.

    A design without stops of bodies refuses another compliance than the default.
    """
    changes: dict[str, Any] = {} if original.has_stops_of_bodies else {"stops": original.stops}
    for name in type(scaled).model_fields:
        part = getattr(original, name)
        if isinstance(part, Design):
            changes[name] = _with_idle_stops(getattr(scaled, name), part)
    return scaled.model_copy(update=changes)


def _with_scaled_bounds(scaled: _DesignOf, original: Design, factor: float) -> _DesignOf:
    """Return a scaled design, and its parts, whose stages end at scaled distances: bounds are text in a design."""
    units = original.measure_units

    def bound(text: str) -> str:
        written = read_goal(text)
        unit = None if written is None else units.get(written.name)
        if written is None or unit is None or not dimension(unit)[0]:
            return text
        value = factor * parse_quantity(written.value, unit)
        return f"{written.name} {written.relation} {format_quantity(value, unit)}"

    stages = tuple(stage.model_copy(update={"until": bound(stage.until)}) for stage in scaled.protocol.stages)
    changes: dict[str, Any] = {"protocol": scaled.protocol.model_copy(update={"stages": stages})}
    for name in type(scaled).model_fields:
        part = getattr(original, name)
        if isinstance(part, Design):
            changes[name] = _with_scaled_bounds(getattr(scaled, name), part, factor)
    return scaled.model_copy(update=changes)


def _with_natural(
    scaled: _SectionOf, original: _SectionOf, scaled_keys: Collection[tuple[str, str]], section: str = ""
) -> _SectionOf:
    """Return a scaled section with the natural values of the original, except for keys that are to stay scaled."""
    changes: dict[str, Any] = {}
    for name in type(scaled).model_fields:
        value, before = getattr(scaled, name), getattr(original, name)
        inside = f"{section}.{name}" if section else name
        if name in type(scaled).natural:
            changes[name] = value if (section, name) in scaled_keys else before
        elif isinstance(value, Section):
            changes[name] = _with_natural(value, before, scaled_keys, inside)
        elif isinstance(value, tuple):
            changes[name] = tuple(
                _with_natural(entry, entry_before, scaled_keys, inside) if isinstance(entry, Section) else entry
                for entry, entry_before in zip(value, before, strict=True)
            )
    return scaled.model_copy(update=changes)


def _rescaled(section: _SectionOf, length: float, mass: float, time: float, prefix: str = "") -> _SectionOf:
    """Return the section in other units; raise InputError where a number is not finite in these units."""

    def converted(value: float, quantity: Quantity, key: str) -> float:
        by_length, by_mass, by_time = dimension(quantity.unit)
        unit = length**by_length * mass**by_mass * time**by_time
        changed = value / unit if unit else math.inf
        if not math.isfinite(changed):
            got = show_quantity(value, quantity.unit)
            raise InputError(f"{key}: need a finite number in the units of a wing of this size, got {got}")
        return changed

    changes: dict[str, Any] = {}
    for name, field in type(section).model_fields.items():
        value, quantity = getattr(section, name), field_quantity(field)
        if isinstance(value, Section):
            changes[name] = _rescaled(value, length, mass, time, f"{prefix}{name}.")
        elif isinstance(value, tuple):
            changes[name] = tuple(
                _rescaled(item, length, mass, time, f"{prefix}{name}.{place}.")
                if isinstance(item, Section)
                else converted(item, quantity, f"{prefix}{name}.{place}")
                if quantity is not None and isinstance(item, float)
                else item
                for place, item in enumerate(value)
            )
        elif quantity is not None and isinstance(value, float):
            changes[name] = converted(value, quantity, f"{prefix}{name}")
    return section.model_copy(update=changes)
