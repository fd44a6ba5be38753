"""What an observations file says of its facts, read and checked."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, cast

import numpy as np

from forficula.design import Design, key_quantity, key_value, value_from_folder
from forficula.design.key_table import names_within
from forficula.errors import InputError
from forficula.goals.identify.fact import COUNTS, NUMBERS, PLACES, Fact, LeastValue, Order, Statistic, Term
from forficula.goals.identify.observation_keys import OBSERVATION_KEYS
from forficula.goals.identify.row_quantity import RowQuantity, is_state, read_combination, row_quantities
from forficula.names import as_given, one_of, shown_name
from forficula.quantities import Unit, as_written, parse_quantity
from forficula.structure import structure_of
from forficula.study.factors import Factor, grid_points, range_values, read_factor
from forficula.study.file_keys import check_keys, dotted_values

LEAST_VALUE = "least value"
_ORDERS: dict[str, Order] = {"equals": "equals", "at_least": "at least", "at_most": "at most"}
_OF_TERM = ("quantity", "statistic", "over", "settings", "until", "where", "absent", "rising", "falling", "least")


def read_fact(given: object, base: Design, folder: Path) -> Fact:
    """Read a table `fact`.

    Args:
        given: the table.
        base: the design.
        folder: that paths start from.

    Raises:
        InputError: an unknown key, or a value that is not allowed; the caller knows which fact.
    """
    if not isinstance(given, dict):
        raise InputError(f"need a table, got {as_written(given)}")
    check_keys(given, names_within("fact", OBSERVATION_KEYS), "")
    name = given.get("name")
    if not isinstance(name, str):
        raise InputError(f"name: need a short text, {as_given(name)}")
    term = _term(given, base, folder)
    orders = [key for key in _ORDERS if key in given]
    places = _places(given, term)
    if term.statistic in ("all", "none", "any") or term.statistic in PLACES:
        if orders:
            raise InputError(f'{orders[0]}: has no place beside statistic = "{term.statistic}"')
        order, own = _own_bound(term)
        bound: float | Term = own
    elif len(orders) != 1:
        raise InputError(f"need one of {', '.join(_ORDERS)}, got {' and '.join(orders) or 'none'}")
    else:
        order, bound = _ORDERS[orders[0]], _bound(given, orders[0], term, base, folder)
    tolerance = _number(given.get("tolerance", 0 if term.unit is None else f"0 {term.unit.display}"), term, "tolerance")
    scale = _number(given["scale"], term, "scale") if "scale" in given else None
    if tolerance < 0:
        raise InputError(f"tolerance: need >= 0, got {as_written(given['tolerance'])}")
    if scale is not None and scale <= 0:
        raise InputError(f"scale: need > 0, got {as_written(given['scale'])}")
    return Fact(
        name=shown_name(name),
        source=str(given.get("source", "")),
        term=term,
        order=order,
        bound=bound,
        places=places,
        tolerance=tolerance,
        scale=scale,
    )


def _own_bound(term: Term) -> tuple[Order, float]:
    """What all, none, any and the places of least and largest numbers come to."""
    match term.statistic:
        case "all":
            return "equals", float(np.prod(term.shape, dtype=int))
        case "any":
            return "at least", 1.0
        case _:
            return "equals", 0.0


def _bound(given: Mapping[str, Any], order: str, term: Term, base: Design, folder: Path) -> float | Term:
    value = given[order]
    if not isinstance(value, dict):
        return _number(value, term, order)
    check_keys(value, _OF_TERM, f"{order}.")
    other = _term({**{key: given[key] for key in _OF_TERM if key in given}, **value}, base, folder)
    if other.unit != term.unit:
        raise InputError(f"{order}: need a quantity in the same unit")
    return other


def _number(value: object, term: Term, key: str) -> float:
    """A number in the term's unit, or a plain one."""
    if term.unit is not None:
        try:
            return parse_quantity(value, term.unit)
        except InputError as error:
            raise InputError(f"{key}: {error}") from None
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(f"{key}: need a number, got {as_written(value)}")
    return float(value)


def _term(given: Mapping[str, Any], base: Design, folder: Path) -> Term:
    known = row_quantities(base)
    quantity = _quantity(given.get("quantity"), known)
    over = _over(given, folder, base)
    least = _least(given.get("least"), base)
    if not quantity and least is None:
        raise InputError(f'quantity: "{LEAST_VALUE}" needs a table least with key and values')
    counted = is_state(quantity) and least is None
    statistic = given.get("statistic", "all" if counted else "least")
    allowed = COUNTS if counted else (*NUMBERS, *PLACES)
    if statistic not in allowed:
        raise InputError(f"statistic: need {one_of(allowed, statistic)}")
    unit = _unit(quantity, least) if not counted else None
    rising, falling = (_directions(given, key, over, counted) for key in ("rising", "falling"))
    return Term(
        quantity=quantity,
        statistic=cast(Statistic, statistic),
        over=over,
        settings=_settings(given, folder, base),
        until=_name(given, "until", [each.name for each in structure_of(base).transitions]),
        where=_name(given, "where", [each.state for each in structure_of(base).transitions]),
        least=least,
        rising=rising,
        falling=falling,
        absent=None if counted else _absent(given, unit, least),
        unit=unit,
    )


def _quantity(given: object, known: Mapping[str, RowQuantity]) -> Any:
    if given == LEAST_VALUE:
        return ()
    try:
        return read_combination(given, known)
    except InputError as error:
        raise InputError(f"quantity: {error}") from None


def _unit(quantity: Any, least: LeastValue | None) -> Unit | None:
    if not quantity:
        assert least is not None
        return least.unit
    unit = quantity[0][1].unit
    assert unit is None or isinstance(unit, Unit)
    return unit


def _over(given: Mapping[str, Any], folder: Path, base: Design) -> tuple[Factor, ...]:
    table = given.get("over", {})
    if not isinstance(table, dict):
        raise InputError(f"over: need a table, got {as_written(table)}")
    factors = []
    for key, value in dotted_values(table, "over", empty=True).items():
        # a single value is a list of one
        text = isinstance(value, str) and " step " not in value
        values = [value] if text or not isinstance(value, str | list | dict) else value
        try:
            factors.append(read_factor(key, value_from_folder(key, values, folder), type(base)))
            key_value(base, key)
        except InputError as error:
            raise InputError(f"over.{error}") from None
    if drawn := [factor.key for factor in factors if factor.distribution is not None]:
        raise InputError(f"over.{drawn[0]}: need a list or a range, got a distribution")
    grid_points(tuple(factors))
    return tuple(factors)


def _settings(given: Mapping[str, Any], folder: Path, base: Design) -> dict[str, object]:
    table = given.get("settings", {})
    if not isinstance(table, dict):
        raise InputError(f"settings: need a table, got {as_written(table)}")
    values = {key: value_from_folder(key, value, folder) for key, value in dotted_values(table, "settings").items()}
    try:
        base.with_values(values)
    except InputError as error:
        raise InputError(f"settings: {error}") from None
    return values


def _least(given: object, base: Design) -> LeastValue | None:
    if given is None:
        return None
    if not isinstance(given, dict):
        raise InputError(f"least: need a table, got {as_written(given)}")
    check_keys(given, names_within("fact.least", OBSERVATION_KEYS), "least.")
    key, values = given.get("key"), given.get("values")
    quantity = key_quantity(key, type(base)) if isinstance(key, str) else None
    if quantity is None:
        raise InputError(f"least.key: need a key whose value has a unit, got {as_written(key)}")
    listed = range_values("least.values", values) if isinstance(values, str) else values
    if not isinstance(listed, list | tuple) or not listed:
        raise InputError(f'least.values: need values such as "10..50 N cm step 10", got {as_written(values)}')
    numbers = tuple(quantity.parse(value) for value in listed)
    if sorted(set(numbers)) != list(numbers):
        raise InputError(f"least.values: need values that rise, got {as_written(values)}")
    monotone = given.get("monotone", False)
    if not isinstance(monotone, bool):
        raise InputError(f"least.monotone: need true or false, got {as_written(monotone)}")
    states = [each.state for each in structure_of(base).transitions]
    state = _name(given, "state", states) or states[0]
    assert isinstance(key, str)
    return LeastValue(
        key=key, values=tuple(listed), numbers=numbers, unit=quantity.unit, state=state, monotone=monotone
    )


def _name(given: Mapping[str, Any], key: str, names: list[str]) -> str | None:
    value = given.get(key)
    if value is not None and value not in names:
        raise InputError(f"{key}: need {one_of(names, value)}")
    return value


def _directions(given: Mapping[str, Any], key: str, over: tuple[Factor, ...], counted: bool) -> tuple[str, ...]:
    value = given.get(key, [])
    keys = [factor.key for factor in over]
    if not isinstance(value, list) or (value and not counted):
        raise InputError(f"{key}: need a list of keys of over, of a state, got {as_written(value)}")
    for each in value:
        if each not in keys:
            raise InputError(f"{key}: need {one_of(keys, each)}")
    return tuple(value)


def _absent(given: Mapping[str, Any], unit: Unit | None, least: LeastValue | None) -> float:
    if "absent" not in given:
        if least is not None and given.get("quantity") == LEAST_VALUE:
            # a step above all that were tried
            return 2 * least.numbers[-1] - least.numbers[-2] if len(least.numbers) > 1 else 2 * least.numbers[-1]
        raise InputError("absent: is missing; give the number of a run that has none, such as the time limit")
    if unit is None:
        raise InputError("absent: has no place beside a state")
    try:
        return parse_quantity(given["absent"], unit)
    except InputError as error:
        raise InputError(f"absent: {error}") from None


def _places(given: Mapping[str, Any], term: Term) -> dict[str, tuple[object, ...]]:
    """The allowed places, as the grid has them."""
    table = given.get("at")
    if (table is not None) != (term.statistic in PLACES):
        raise InputError(f'at: belongs to statistic = "{PLACES[0]}" or "{PLACES[1]}", got "{term.statistic}"')
    places: dict[str, tuple[object, ...]] = {}
    for key, values in dotted_values(table or {}, "at", empty=True).items():
        factor = next((factor for factor in term.over if factor.key == key), None)
        if factor is None:
            raise InputError(f"at: need {one_of([factor.key for factor in term.over], key)}")
        wanted = values if isinstance(values, list) else [values]
        places[key] = tuple(_grid_value(factor, value) for value in wanted)
    return places


def _grid_value(factor: Factor, value: object) -> object:
    """The value of a grid that a value is, however it is written."""
    for each in factor.values:
        same = each == value
        if factor.unit is not None and isinstance(each, str) and isinstance(value, str):
            same = bool(np.isclose(parse_quantity(each, factor.unit), parse_quantity(value, factor.unit), atol=1e-12))
        if same:
            return each
    raise InputError(f"at.{factor.key}: need values of the grid, got {as_written(value)}")
