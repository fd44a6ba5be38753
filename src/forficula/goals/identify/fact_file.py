"""Read and check the facts of an observations file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, cast

import numpy as np
from pydantic import BeforeValidator

from forficula.design import Design, key_quantity, key_value, value_from_folder
from forficula.design.file_fields import ByKey, Settings, YesOrNo, entry
from forficula.design.files.rejection import read_section
from forficula.design.section import Section
from forficula.errors import InputError, error_prefix
from forficula.goals.identify.fact import COUNTS, NUMBERS, PLACES, Fact, LeastValue, Order, Statistic, Term
from forficula.goals.identify.row_quantity import Combination, is_state, read_combination, row_quantities
from forficula.names import check_known, one_of, shown_name
from forficula.quantities import Unit, as_written, parse_quantity
from forficula.structure import structure_of
from forficula.study.factors import Factor, Grid, Values, range_values, read_factor
from forficula.study.files.named_file import settings_of
from forficula.study.points import grid_points

LEAST_VALUE = "least value"
_Keys = Annotated[list[str], "list of keys of over"]
_ORDERS: dict[str, Order] = {"equals": "equals", "at_least": "at least", "at_most": "at most"}


class LeastTable(Section):
    """Search for the least value of a key under every condition."""

    key: str = entry("key whose least value is searched for", ...)
    values: Values = entry("values to try, rising", ...)
    state: str | None = entry("state that must be reached", left_out="the first")
    monotone: YesOrNo = entry("true: all values above the least one also reach the state", False)


class FactTable(Section):
    """A table `fact` of an observations file."""

    name: str = entry("short name, unique among the facts", ...)
    source: str = entry("source of the fact", "")
    quantity: Annotated[Any, "text"] = entry(
        'a state, a number of a run, a sum of such numbers, or "least value"', left_out="needed"
    )
    statistic: Annotated[str | None, "count, all, none, any; or least, largest, mean, least at, largest at"] = entry(
        "statistic over all conditions: count, all, none or any for a state, the others for a number",
        left_out='"all" or "least"',
    )
    over: Grid = entry("conditions; all combinations of their values are run", {})
    settings: Settings = entry("value of this key under all conditions", {})
    until: str | None = entry("transition after which runs end", left_out="the whole protocol")
    where: str | None = entry("state that a run must reach to be included")
    absent: Annotated[Any, "as the quantity"] = entry(
        "value for a run in which the quantity does not exist", left_out="needed for numbers"
    )
    rising: _Keys = entry("if one value of such a key reaches the state, every larger value also does", [])
    falling: _Keys = entry("if one value of such a key reaches the state, every smaller value also does", [])
    least: LeastTable | None = entry("search for a least value under every condition")
    equals: Annotated[Any, "number, text with a unit, or table"] = entry(
        "required value: a number, or another quantity"
    )
    at_least: Annotated[Any, "as equals"] = entry("lower limit of the quantity")
    at_most: Annotated[Any, "as equals"] = entry("upper limit of the quantity")
    at: Annotated[dict[str, Any], BeforeValidator(ByKey(allowed="list"))] = entry(
        "values of a condition at which the quantity must be least or largest", {}
    )
    tolerance: Annotated[Any, "number, or text with a unit"] = entry("largest allowed deviation from the fact", 0)
    scale: Annotated[Any, "as tolerance"] = entry(
        "scale by which the deviation is divided in sums over several facts", left_out="spread of the samples"
    )


# keys of a table under `equals`, `at_least` or `at_most`; their defaults are those of the fact
_OF_TERM = (
    *("quantity", "statistic", "over", "settings", "until", "where"),
    *("absent", "rising", "falling", "least"),
)


def read_fact(table: FactTable, base: Design, folder: Path) -> Fact:
    """Read a table `fact`.

    Args:
        table: content of the file.
        base: the design.
        folder: folder that paths are relative to.

    Raises:
        InputError: a value that is not allowed. The caller adds the name of the fact.
    """
    with error_prefix("name: "):
        name = shown_name(table.name)
    term = _term(table, base, folder)
    orders = [key for key in _ORDERS if key in table.model_fields_set]
    places = _places(table, term)
    if term.statistic in ("all", "none", "any") or term.statistic in PLACES:
        if orders:
            raise InputError(f'{orders[0]}: is not allowed with statistic = "{term.statistic}"')
        order, implied = _implied_bound(term)
        bound: float | Term = implied
    elif len(orders) != 1:
        raise InputError(f"need one of {', '.join(_ORDERS)}, got {' and '.join(orders) or 'none'}")
    else:
        order, bound = _ORDERS[orders[0]], _bound(table, orders[0], term, base, folder)
    zero = 0 if term.unit is None else f"0 {term.unit.display}"
    tolerance = _number(table.tolerance if "tolerance" in table.model_fields_set else zero, term, "tolerance")
    scale = None if table.scale is None else _number(table.scale, term, "scale")
    if tolerance < 0:
        raise InputError(f"tolerance: need >= 0, got {as_written(table.tolerance)}")
    if scale is not None and scale <= 0:
        raise InputError(f"scale: need > 0, got {as_written(table.scale)}")
    return Fact(
        name=name,
        source=table.source,
        term=term,
        order=order,
        bound=bound,
        places=places,
        tolerance=tolerance,
        scale=scale,
    )


def _implied_bound(term: Term) -> tuple[Order, float]:
    """Return the order and bound that the statistics all, none, any, least at and largest at imply."""
    match term.statistic:
        case "all":
            return "equals", float(np.prod(term.shape, dtype=int))
        case "any":
            return "at least", 1.0
        case _:
            return "equals", 0.0


def _bound(table: FactTable, order: str, term: Term, base: Design, folder: Path) -> float | Term:
    value = getattr(table, order)
    if not isinstance(value, Mapping):
        return _number(value, term, order)
    check_known(value, _OF_TERM, f"{order}.")
    defaults = table.model_dump(include={"name", *_OF_TERM}, exclude_unset=True)
    with error_prefix(f"{order}."):
        other = _term(read_section(FactTable, defaults | dict(value)), base, folder)
    if other.unit != term.unit:
        raise InputError(f"{order}: need a quantity in the same unit")
    return other


def _number(value: object, term: Term, key: str) -> float:
    """Read a number in the unit of the term, or a plain number if it has none."""
    if term.unit is not None:
        with error_prefix(f"{key}: "):
            return parse_quantity(value, term.unit)
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(f"{key}: need a number, got {as_written(value)}")
    return float(value)


def _term(table: FactTable, base: Design, folder: Path) -> Term:
    with error_prefix("quantity: "):
        quantity = () if table.quantity == LEAST_VALUE else read_combination(table.quantity, row_quantities(base))
    over = _over(table.over, folder, base)
    least = None if table.least is None else _least(table.least, base)
    if not quantity and least is None:
        raise InputError(f'quantity: "{LEAST_VALUE}" needs a table least with key and values')
    counted = is_state(quantity) and least is None
    statistic = table.statistic or ("all" if counted else "least")
    allowed = COUNTS if counted else (*NUMBERS, *PLACES)
    if statistic not in allowed:
        raise InputError(f"statistic: need {one_of(allowed, statistic)}")
    unit = _unit(quantity, least) if not counted else None
    transitions = structure_of(base).transitions
    for key, value, names in (
        ("until", table.until, [transition.name for transition in transitions]),
        ("where", table.where, [transition.state for transition in transitions]),
    ):
        if value is not None and value not in names:
            raise InputError(f"{key}: need {one_of(names, value)}")
    for key, keys in (("rising", table.rising), ("falling", table.falling)):
        _check_directions(key, keys, over, counted=counted)
    return Term(
        quantity=quantity,
        statistic=cast(Statistic, statistic),
        over=over,
        settings=_settings(table.settings, folder, base),
        until=table.until,
        where=table.where,
        least=least,
        rising=tuple(table.rising),
        falling=tuple(table.falling),
        absent=None if counted else _absent(table, unit, least),
        unit=unit,
    )


def _unit(quantity: Combination, least: LeastValue | None) -> Unit | None:
    if not quantity:
        assert least is not None
        return least.unit
    unit = quantity[0][1].unit
    assert unit is None or isinstance(unit, Unit)
    return unit


def _over(conditions: Mapping[str, object], folder: Path, base: Design) -> tuple[Factor, ...]:
    factors = []
    for key, value in conditions.items():
        # a single value is read as a list of one
        text = isinstance(value, str) and " step " not in value
        values = [value] if text or not isinstance(value, str | list | dict) else value
        with error_prefix("over."):
            factors.append(read_factor(key, value_from_folder(key, values, folder), type(base)))
            key_value(base, key)
    if drawn := [factor.key for factor in factors if factor.distribution is not None]:
        raise InputError(f"over.{drawn[0]}: need a list or a range, got a distribution")
    grid_points(tuple(factors))
    return tuple(factors)


def _settings(settings: Mapping[str, object], folder: Path, base: Design) -> dict[str, object]:
    values = settings_of(settings, folder)
    with error_prefix("settings: "):
        base.with_values(values)
    return values


def _least(table: LeastTable, base: Design) -> LeastValue:
    values = table.values
    quantity = key_quantity(table.key, type(base))
    if quantity is None:
        raise InputError(f"least.key: need a key whose value has a unit, got {as_written(table.key)}")
    listed = range_values("least.values", values) if isinstance(values, str) else values
    if not isinstance(listed, list | tuple) or not listed:
        raise InputError(f'least.values: need values such as "10..50 N cm step 10", got {as_written(values)}')
    numbers = tuple(quantity.parse(value) for value in listed)
    if sorted(set(numbers)) != list(numbers):
        raise InputError(f"least.values: need values that rise, got {as_written(values)}")
    states = [transition.state for transition in structure_of(base).transitions]
    if table.state is not None and table.state not in states:
        raise InputError(f"least.state: need {one_of(states, table.state)}")
    return LeastValue(
        key=table.key,
        values=tuple(listed),
        numbers=numbers,
        unit=quantity.unit,
        state=table.state or states[0],
        monotone=table.monotone,
    )


def _check_directions(key: str, keys: Sequence[str], over: Sequence[Factor], *, counted: bool) -> None:
    """Reject directions of a quantity that is not a state, or along a key that is not a condition."""
    if keys and not counted:
        raise InputError(f"{key}: only for a state: need a list of keys of over, got {as_written(keys)}")
    for direction in keys:
        if direction not in (known := [factor.key for factor in over]):
            raise InputError(f"{key}: need {one_of(known, direction)}")


def _absent(table: FactTable, unit: Unit | None, least: LeastValue | None) -> float:
    if table.absent is None:
        if least is not None and table.quantity == LEAST_VALUE:
            # one step above the largest value that was tried
            return 2 * least.numbers[-1] - least.numbers[-2] if len(least.numbers) > 1 else 2 * least.numbers[-1]
        raise InputError("absent: is missing; give the value for a run that has no such number, such as the time limit")
    if unit is None:
        raise InputError("absent: is not allowed with a state")
    with error_prefix("absent: "):
        return parse_quantity(table.absent, unit)


def _places(table: FactTable, term: Term) -> dict[str, tuple[object, ...]]:
    """Return the positions at which a number must be least or largest, with values of the grid."""
    if ("at" in table.model_fields_set) != (term.statistic in PLACES):
        raise InputError(f'at: belongs to statistic = "{PLACES[0]}" or "{PLACES[1]}", got "{term.statistic}"')
    positions: dict[str, tuple[object, ...]] = {}
    for key, values in table.at.items():
        factor = next((factor for factor in term.over if factor.key == key), None)
        if factor is None:
            raise InputError(f"at: need {one_of([factor.key for factor in term.over], key)}")
        wanted = values if isinstance(values, list) else [values]
        positions[key] = tuple(_grid_value(factor, value) for value in wanted)
    return positions


def _grid_value(factor: Factor, value: object) -> object:
    """Return the value of the grid that equals a value, which may be written differently."""
    for grid_value in factor.values:
        same = grid_value == value
        if factor.unit is not None and isinstance(grid_value, str) and isinstance(value, str):
            same = bool(
                np.isclose(parse_quantity(grid_value, factor.unit), parse_quantity(value, factor.unit), atol=1e-12)
            )
        if same:
            return grid_value
    raise InputError(f"at.{factor.key}: need values of the grid, got {as_written(value)}")
