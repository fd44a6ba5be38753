"""Goals in files: named ones, and those of a user."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Literal

from forficula.design import Design, check_keys_once, numbered_key, value_from_folder
from forficula.design.key_table import names_within
from forficula.errors import InputError
from forficula.goals.deviation import Deviation, read_deviations
from forficula.goals.goal import Goal, Objective
from forficula.goals.goal_keys import GOAL_KEYS
from forficula.goals.limit import Limit, check_limits, read_limit
from forficula.goals.outcome_quantity import PROBABILITY, OutcomeQuantity, quantity_of
from forficula.goals.parameter import Parameter, read_parameter
from forficula.names import check_whole, folder_name, one_of
from forficula.quantities import as_written
from forficula.study.file_keys import check_keys, dotted_values
from forficula.study.named_file import base_design, load_named, named_files
from forficula.study.search_file import read_search
from forficula.study.search_steps import Search

_PACKAGE = "forficula.goals"
_TABLES = ("settings", "vary", "limits", "objectives", "tolerances", "search")
_COUNTS = {"runs": (512, 1), "batch": (32, 4), "neighbours": (64, 8), "seed": (0, 0)}
_MOST = 1_000_000
_MOST_OBJECTIVES = 3


def load_goal(name_or_path: str | Path) -> Goal:
    """Read a named goal or a goal file.

    Args:
        name_or_path: one of `named_goals`, or the path of a TOML file.

    Raises:
        InputError: no such goal or file, not TOML, an unknown key, or a value that is not allowed.
    """
    return load_named(name_or_path, _PACKAGE, "goal", "goals", _goal)


def goal_of(tables: Mapping[str, Any]) -> Goal:
    """Build a goal of tables as a file has them, but for `design`, which may be one.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    return _goal(dict(tables), Path())


def named_goals() -> list[str]:
    """The names of the goals that come with the package."""
    return named_files(_PACKAGE)


def _goal(tables: dict[str, Any], folder: Path) -> Goal:
    check_keys(tables, names_within("", GOAL_KEYS), "")
    for key in _TABLES:
        if not isinstance(tables.get(key, {}), dict):
            raise InputError(f"{key}: need a table, got {as_written(tables[key])}")
    try:
        title = folder_name(tables["name"])
    except InputError as error:
        raise InputError(f"name: {error}") from None
    simulate = tables.get("simulate", True)
    if not isinstance(simulate, bool):
        raise InputError(f"simulate: need true or false, got {as_written(simulate)}")
    base = base_design(tables, folder)
    limits = read_limits(flat_table(tables, "limits"), base)
    given = tuple(each for each in limits if each.quantity.source == "search" and each.kind == "<=")
    base = with_torques(base, given)
    limits = tuple(each for each in limits if each not in given)
    if any(each.quantity.name == PROBABILITY and each.kind == "<=" for each in limits):
        raise InputError(f'limits.{PROBABILITY}: need a lower limit, such as ">= 95 %"')
    objectives = _objectives(flat_table(tables, "objectives"), base)
    deviations = deviations_within(
        flat_table(tables, "tolerances", keep=("distribution", "size", "intervals_of")), base, folder
    )
    parameters = _parameters(flat_table(tables, "vary", keep=("low", "high", "step")), base, folder)
    asked = [*(each.quantity for each in limits), *(each.quantity for each in objectives)]
    _check_asked([*(each.quantity for each in given), *asked], parameters, deviations, simulate=simulate)
    _check_varied(asked, given, parameters, base)
    return Goal(
        name=title,
        source=str(tables.get("source", "")),
        base=base,
        parameters=parameters,
        limits=limits,
        given=given,
        objectives=objectives,
        deviations=deviations,
        simulate=simulate,
        search=_search(tables.get("search", {}), asked, base),
        **{name: _count(tables.get("search", {}), name) for name in _COUNTS},
    )


def flat_table(tables: Mapping[str, Any], name: str, keep: Sequence[str] = ()) -> dict[str, Any]:
    """The entries of a table by dotted key; tables with some of these keys are values."""
    return dotted_values(tables.get(name, {}), name, values=frozenset(keep), empty=True)


def read_limits(given: Mapping[str, Any], base: Design) -> tuple[Limit, ...]:
    """Read the limits of a file by the quantities' names.

    Raises:
        InputError: an unknown quantity, or no limit.
    """
    found = []
    for name, texts in given.items():
        try:
            quantity = quantity_of(base, name)
            limits = [read_limit(quantity, text) for text in (texts if isinstance(texts, list) else [texts])]
            check_limits(limits)
        except InputError as error:
            raise InputError(_told("limits", name, error)) from None
        found += limits
    return tuple(found)


def _told(table: str, name: str, error: InputError) -> str:
    """An error with the key that it is about."""
    text = str(error)
    return f"{table}.{text}" if text.startswith(f"{name}:") else f"{table}.{name}: {text}"


def _objectives(given: Mapping[str, Any], base: Design) -> tuple[Objective, ...]:
    found = []
    for name, kind in given.items():
        try:
            quantity = quantity_of(base, name)
        except InputError as error:
            raise InputError(_told("objectives", name, error)) from None
        if kind not in ("least", "largest"):
            raise InputError(f"objectives.{name}: need {one_of(('least', 'largest'), kind)}")
        way: Literal["least", "largest"] = "least" if kind == "least" else "largest"
        found.append(Objective(quantity=quantity, kind=way))
    if not 1 <= len(found) <= _MOST_OBJECTIVES:
        raise InputError(
            f'objectives: need one to three quantities, such as mass = "least", got {len(found) or "none"}'
        )
    return tuple(found)


def with_torques(base: Design, given: Sequence[Limit]) -> Design:
    """The design with the torques of upper limits on least torques as its protocol's."""
    if not given:
        return base
    steps = {step.least_name: step for step in read_search("least-torques", {}, base).steps}
    values: dict[str, object] = {}
    # of several limits on one, the strictest comes last
    for limit in sorted(given, key=lambda each: -each.bound):
        step = steps[limit.quantity.name]
        values[step.key] = step.sign * limit.bound
    return base.with_values(values)


def deviations_within(given: Mapping[str, Any], base: Design, folder: Path) -> tuple[Deviation, ...]:
    """Read the tolerances of a file that lies in a folder.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    within = {
        key: {**value, "intervals_of": str(folder / value["intervals_of"])}
        if isinstance(value, dict) and str(value.get("intervals_of", "")).endswith(".toml")
        else value
        for key, value in given.items()
    }
    try:
        return read_deviations(within, base)
    except InputError as error:
        raise InputError(f"tolerances.{error}") from None


def _parameters(given: Mapping[str, Any], base: Design, folder: Path) -> tuple[Parameter, ...]:
    try:
        check_keys_once(given, base)
        return tuple(read_parameter(key, value_from_folder(key, value, folder), base) for key, value in given.items())
    except InputError as error:
        raise InputError(f"vary.{error}") from None


def _check_asked(
    asked: Sequence[OutcomeQuantity],
    parameters: Sequence[Parameter],
    deviations: Sequence[Deviation],
    *,
    simulate: bool,
) -> None:
    """Refuse what cannot be known of the designs that are tried."""
    for quantity in asked:
        if quantity.source in ("run", "record", "search") and not simulate:
            raise InputError(f"{quantity.name}: is known by running a design, which simulate = false leaves out")
        if quantity.name == PROBABILITY and not deviations:
            raise InputError(f'{PROBABILITY}: needs tolerances, such as all = "10 %" under [tolerances]')
    if not parameters:
        raise InputError('vary: need at least one key, such as "tendon.stiffness" = { low = "4 N/cm", high = ".." }')


def _check_varied(
    asked: Sequence[OutcomeQuantity], given: Sequence[Limit], parameters: Sequence[Parameter], base: Design
) -> None:
    """Refuse to vary what a limit on a least torque settles, or a search for one tries."""
    names = {each.name for each in (*asked, *(limit.quantity for limit in given)) if each.source == "search"}
    if not names:
        return
    settled = {step.key: step.least_name for step in read_search("least-torques", {}, base).steps}
    varied = {numbered_key(base, each.key): each.key for each in parameters}
    for key, name in settled.items():
        if name in names and (own := varied.get(numbered_key(base, key))) is not None:
            raise InputError(f"vary.{own}: is what {name} is about; need it in one of them")


def _search(given: Mapping[str, Any], asked: Sequence[OutcomeQuantity], base: Design) -> Search | None:
    """What a search for least values tries, where one of them is asked for."""
    own = {key: value for key, value in given.items() if key not in _COUNTS}
    if not any(quantity.source == "search" for quantity in asked):
        if own:
            check_keys(given, tuple(_COUNTS), "search.")
        return None
    return read_search("least-torques", own, base)


def _count(given: Mapping[str, Any], name: str) -> int:
    default, least = _COUNTS[name]
    value = given.get(name, default)
    return check_whole(f"search.{name}", value, least, _MOST)
