"""Study: a design, factors, and what is asked of every point."""

from __future__ import annotations

import difflib
import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any

from forficula.design import TORQUE, Design, key_quantity, key_value, load_design, value_from_folder
from forficula.errors import InputError
from forficula.names import folder_name, one_of
from forficula.quantities import Unit, as_written, format_quantity, parse_quantity
from forficula.structure import Drive, Structure, Transition, drive_of, first_state, structure_of
from forficula.study.choices import one_at_a_time, with_own_word
from forficula.study.factors import MOST_VALUES, Factor, drawn_values, range_values, read_factor
from forficula.toml_text import parse_toml

_KEYS = (
    "name",
    "source",
    "reproduces",
    "design",
    "ask",
    "vary",
    "settings",
    "factors",
    "grid",
    "sampling",
    "search",
)
_MOST_TORQUES = 1000  # every one of them is a run of every point
_SEARCHES = ("least-torques", "least-value")


@dataclass(frozen=True, kw_only=True)
class SearchStep:
    """A transition whose least value is looked for.

    Attributes:
        transition: its name, such as "fold".
        drive: name of its drive.
        state: name of the state that it leads to, such as "folded".
        done: what it comes to where it succeeds, in a word.
        key: of the design's value that is tried, such as "protocol.fold_torque".
        values: that are tried, SI, one after another, rising or falling; none where it is not asked for.
        unit: of the values.
        sign: by which a value is multiplied before it is the key's: that of the drive.
    """

    transition: str
    drive: str
    state: str
    done: str
    key: str
    values: tuple[float, ...]
    unit: Unit
    sign: float = 1.0

    @property
    def value_name(self) -> str:
        """What tables call the values, such as "fold_torque"."""
        return "_".join(self.key.split(".")[1:])

    @property
    def least_name(self) -> str:
        """What tables call the least value that does it, such as "least_fold_torque"."""
        return f"least_{self.value_name}"


@dataclass(frozen=True, kw_only=True)
class Search:
    """Which values are tried for the least that bring a structure to its states.

    Attributes:
        first: the first transition.
        second: the next one; None where there is none, or where it is not asked for.
        reference: value of the first one's key, SI, at which the second one is tried.
        next_drive: of the transition after the first one, before whose stage its release ends; None where there is
            none: the whole protocol then runs with every value.
        start_state: name of the state before the first transition; "" where there is none.
        refinements: how often the step below the least value that worked is halved.
    """

    first: SearchStep
    second: SearchStep | None
    reference: float
    next_drive: str | None
    start_state: str
    refinements: int

    @property
    def steps(self) -> tuple[SearchStep, ...]:
        """The transitions that are asked for."""
        return (self.first,) if self.second is None else (self.first, self.second)


@dataclass(frozen=True, kw_only=True)
class Study:
    """Many runs of one design.

    Attributes:
        name: what outputs call it.
        source: where the question comes from.
        base: the design that is varied.
        factors: what is varied.
        points: the values of every point by dotted key, as a design file has them; what is not there is the base's.
        sampled: whether the points were drawn; otherwise they are the grid of all factors, the last fastest.
        search: the values to try for the least ones; None runs the protocol as it is.
        choices: where factors are varied one at a time, the value of one of them each, by key; the first is empty, the
            base. Otherwise none.
        grid: the factors whose whole grid is repeated at every choice, the last fastest.
        reproduces: name of the paper that its results are set beside; None for none.
    """

    name: str
    source: str
    base: Design
    factors: tuple[Factor, ...]
    points: tuple[Mapping[str, object], ...]
    sampled: bool
    search: Search | None
    choices: tuple[Mapping[str, object], ...] = ()
    grid: tuple[Factor, ...] = ()
    reproduces: str | None = None


def load_study(name_or_path: str | Path) -> Study:
    """Read a named study or a study file.

    Args:
        name_or_path: one of `named_studies`, or the path of a TOML file.

    Raises:
        InputError: no such study or file, not TOML, an unknown key, or a value that is not allowed.
    """
    text, where, folder = _read(str(name_or_path))
    try:
        tables = parse_toml(text, "a study")
        tables.setdefault("name", Path(where).stem)
        return _study(tables, folder)
    except InputError as error:
        raise InputError(f"{where}: {error}") from None


def named_studies() -> list[str]:
    """The names of the studies that come with the package."""
    folder = resources.files("forficula.study") / "references"
    return sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml"))


def _read(name_or_path: str) -> tuple[str, str, Path]:
    """Text of a study, how errors call it, and the folder that paths in it start from."""
    if name_or_path in named_studies():
        file = resources.files("forficula.study") / "references" / f"{name_or_path}.toml"
        return file.read_text("utf-8"), name_or_path, Path()
    if not name_or_path.endswith(".toml"):
        raise InputError(
            f'"{name_or_path}" is neither a named study nor a .toml file; the named studies are'
            f" {', '.join(named_studies())}"
        )
    path = Path(name_or_path)
    try:
        return path.read_text("utf-8-sig"), name_or_path, path.parent
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise InputError(f"{path}: cannot be read: need UTF-8") from None
    except ValueError as error:  # a null byte
        raise InputError(f"{as_written(name_or_path)}: cannot be read: {error}") from None


def _study(tables: dict[str, Any], folder: Path) -> Study:
    _known(tables, _KEYS, "")
    for key in ("settings", "sampling", "search"):
        if not isinstance(tables.get(key, {}), dict):
            raise InputError(f"{key}: need a table, got {as_written(tables[key])}")
    name = tables.get("design")
    try:
        title = folder_name(tables["name"])
    except InputError as error:
        raise InputError(f"name: {error}") from None
    reproduces = tables.get("reproduces")
    if not isinstance(reproduces, str | None):
        raise InputError(f"reproduces: need the name of a paper, in quotes, got {as_written(reproduces)}")
    if name is None:
        raise InputError('design: is missing; give the name or path of a design, such as "binder2025"')
    if not isinstance(name, str):
        raise InputError(f'design: need the name or path of a design, such as "binder2025", got {as_written(name)}')
    settings = {
        key: value_from_folder(key, value, folder)
        for key, value in _flat(tables.get("settings", {}), "settings").items()
    }
    base = load_design(str(folder / name) if name.endswith(".toml") else name, settings)
    factors = _factors(tables, "factors", folder, type(base))
    drawn = [factor for factor in factors if factor.distribution is not None]
    if drawn and len(drawn) < len(factors):
        raise InputError("factors: need either all of them as distributions or none, got both kinds")
    vary = tables.get("vary", "grid")
    if vary not in ("grid", "one-at-a-time"):
        raise InputError(f'vary: need "grid" or "one-at-a-time", got {as_written(vary)}')
    if "vary" in tables and drawn:
        raise InputError(f"vary: needs factors that are lists or ranges, got distributions with {as_written(vary)}")
    grid = _repeated_grid(tables, vary, factors, folder, type(base))
    for factor in (*factors, *grid):
        now = key_value(base, factor.key)
        if factor in drawn and key_quantity(factor.key, factor.model) is None and not isinstance(now, float):
            raise InputError(f"{factor.key}: need a list or a range; only numbers with fractions are drawn")
    ask = tables.get("ask", "run")
    if ask not in ("run", *_SEARCHES):
        raise InputError(f"ask: need {one_of(('run', *_SEARCHES), str(ask))}")
    if "sampling" in tables and not drawn:
        raise InputError("sampling: needs factors that are distributions, got lists and ranges")
    if "search" in tables and ask not in _SEARCHES:
        raise InputError('search: needs ask = "least-torques" or "least-value"')
    search = read_search(ask, tables.get("search", {}), base) if ask in _SEARCHES else None
    looked_for = {step.key for step in search.steps} if search is not None else set()
    if ask == "least-torques":
        looked_for |= {drive.key for drive in structure_of(base).drives}
    if taken := looked_for & {factor.key for factor in (*factors, *grid)}:
        raise InputError(f'factors.{min(taken)}: is what "{ask}" looks for; give it under [search], or ask "run"')
    choices: tuple[Mapping[str, object], ...] = ()
    if vary == "one-at-a-time":
        factors = tuple(with_own_word(base, factor) for factor in factors)
        choices = one_at_a_time(base, factors)
    if drawn:
        points = _drawn(factors, tables.get("sampling", {}))
    elif choices:
        points = [{**choice, **point} for choice in choices for point in grid_points(grid, len(choices))]
    else:
        points = grid_points(factors)
    return Study(
        name=title,
        source=str(tables.get("source", "")),
        base=base,
        factors=factors,
        points=tuple(points),
        sampled=bool(drawn),
        search=search,
        choices=choices,
        grid=grid,
        reproduces=reproduces,
    )


def _factors(tables: Mapping[str, Any], name: str, folder: Path, model: type[Design]) -> tuple[Factor, ...]:
    """The factors of a table of the file."""
    given = tables.get(name)
    if not isinstance(given, dict) or not given:
        raise InputError(f'{name}: need a table with at least one, such as "tendon.stiffness" = "10..60 N/cm step 10"')
    values = _flat(given, name).items()
    return tuple(read_factor(key, value_from_folder(key, value, folder), model) for key, value in values)


def _repeated_grid(
    tables: Mapping[str, Any], vary: str, factors: tuple[Factor, ...], folder: Path, model: type[Design]
) -> tuple[Factor, ...]:
    """The factors that are crossed wherever the others, varied one at a time, are."""
    if "grid" not in tables:
        return ()
    if vary != "one-at-a-time":
        raise InputError('grid: needs vary = "one-at-a-time"; otherwise all factors are a grid, under [factors]')
    grid = _factors(tables, "grid", folder, model)
    if twice := {factor.key for factor in grid} & {factor.key for factor in factors}:
        raise InputError(f"grid.{min(twice)}: is under [factors], too; need it in one of them")
    if drawn := [factor.key for factor in grid if factor.distribution is not None]:
        raise InputError(f"grid.{drawn[0]}: need a list or a range, got a distribution")
    return grid


def _known(table: Mapping[str, object], keys: tuple[str, ...], prefix: str) -> None:
    for key in table:
        if key not in keys:
            near = difflib.get_close_matches(key, keys, n=1)
            hint = f"did you mean {prefix}{near[0]}?" if near else f"allowed here: {', '.join(keys)}"
            raise InputError(f"{prefix}{key}: unknown key; {hint}")


def _flat(table: Mapping[str, Any], header: str, prefix: str = "") -> dict[str, Any]:
    """Dotted keys of nested tables; a table with a distribution is a value, and a law with what it is based on."""
    flat: dict[str, Any] = {}
    for key, value in table.items():
        nested = isinstance(value, dict) and not {"distribution", "based_on"} & value.keys()
        more = _flat(value, header, f"{prefix}{key}.") if nested else {f"{prefix}{key}": value}
        if twice := flat.keys() & more.keys():
            raise InputError(f"{header}.{min(twice)}: is given twice, once with dots in its name and once in a table")
        flat |= more
    return flat


def grid_points(factors: tuple[Factor, ...], times: int = 1) -> list[dict[str, object]]:
    """Every combination of the factors' values, the last factor fastest.

    Args:
        factors: with values.
        times: how often the study has this grid.

    Raises:
        InputError: more than a million in all.
    """
    keys = [factor.key for factor in factors]
    count = times * math.prod(len(factor.values) for factor in factors)
    if count > MOST_VALUES:
        raise InputError(f"factors: need at most {MOST_VALUES} points, got {count}")
    return [dict(zip(keys, values, strict=True)) for values in itertools.product(*(each.values for each in factors))]


def _drawn(factors: tuple[Factor, ...], sampling: Mapping[str, Any]) -> list[dict[str, object]]:
    _known(sampling, ("method", "count", "seed"), "sampling.")
    method, count, seed = sampling.get("method", "sobol"), sampling.get("count"), sampling.get("seed", 0)
    if method not in ("random", "sobol"):
        raise InputError(f'sampling.method: need "random" or "sobol", got {method!r}')
    for key, value, least in (("count", count, 1), ("seed", seed, 0)):
        if isinstance(value, bool) or not isinstance(value, int) or value < least:
            raise InputError(f"sampling.{key}: need a whole number >= {least}, got {value!r}")
    if int(str(count)) > MOST_VALUES:
        raise InputError(f"sampling.count: need at most {MOST_VALUES}, got {as_written(count)}")
    return drawn_values(factors, method, int(str(count)), seed)


def read_search(ask: str, given: Mapping[str, Any], base: Design) -> Search:
    """Read the table `search` of a study file.

    Args:
        ask: "least-torques", of the first two transitions of the base, with keys such as `fold_torques`, `fold_with`,
            `unfold_torques`; or "least-value", with `key`, `values` and the `state` that is to be reached.
        given: the table; torques that it does not give are those of the drive.
        base: the design that is varied.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    structure = structure_of(base)
    if not structure.transitions:
        raise InputError(f'ask: "{ask}" needs a design that a protocol drives to a state, got {base.name}')
    start = first_state(structure, structure.stage_states)
    if ask == "least-value":
        return _value_search(given, base, structure, start)
    first, *others = structure.transitions[:2]
    names = [f"{each.name}_torques" for each in (first, *others)]
    _known(given, (names[0], f"{first.name}_with", *names[1:], "refinements"), "search.")
    steps = [
        _torque_step(each, drive_of(structure, each.drive), given, none=each is not first) for each in (first, *others)
    ]
    if len({step.key for step in steps}) < len(steps):
        raise InputError(
            f'ask: "least-torques" needs transitions with drives of their own, got {steps[0].key} for both'
            f' {first.name} and {others[0].name}; ask "least-value" of one'
        )
    large = given.get(f"{first.name}_with", drive_of(structure, first.drive).large or _shown(steps[0].values[-1]))
    return Search(
        first=steps[0],
        second=next((step for step in steps[1:] if step.values), None),
        reference=_torques(f"{first.name}_with", [large])[0],
        next_drive=next((each.drive for each in others), None),
        start_state=start,
        refinements=_refinements(given),
    )


def _value_search(given: Mapping[str, Any], base: Design, structure: Structure, start: str) -> Search:
    """A search for the least value of any key that reaches a state."""
    _known(given, ("key", "values", "state", "refinements"), "search.")
    states = {transition.state: transition for transition in structure.transitions}
    state, key = given.get("state", next(iter(states))), given.get("key")
    if state not in states:
        raise InputError(f"search.state: need {one_of(list(states), str(state))}")
    if key is None:
        raise InputError('search.key: is missing; give the key whose least value is asked for: "tendon.stiffness"')
    if not isinstance(key, str):
        raise InputError(f'search.key: need a key such as "tendon.stiffness", got {as_written(key)}')
    quantity = key_quantity(key, type(base))
    if quantity is None:
        raise InputError(f"search.key: need a key whose value has a unit, got {key}")
    # refuses entries of lists that there are not
    key_value(base, key)
    transition = states[state]
    step = SearchStep(
        transition=transition.name,
        drive=transition.drive,
        state=state,
        done=transition.wording.done,
        key=key,
        values=_rising("values", given.get("values"), quantity.unit, none=False),
        unit=quantity.unit,
    )
    return Search(
        first=step, second=None, reference=0.0, next_drive=None, start_state=start, refinements=_refinements(given)
    )


def _torque_step(transition: Transition, drive: Drive, given: Mapping[str, Any], *, none: bool) -> SearchStep:
    name = f"{transition.name}_torques"
    return SearchStep(
        transition=transition.name,
        drive=transition.drive,
        state=transition.state,
        done=transition.wording.done,
        key=drive.key,
        values=_torques(name, given.get(name, drive.tries or [_shown(abs(drive.torque))]), none=none),
        unit=TORQUE,
        sign=-1.0 if drive.torque < 0 else 1.0,
    )


def _shown(torque: float) -> str:
    return format_quantity(torque, TORQUE)


def _refinements(given: Mapping[str, Any]) -> int:
    refinements = given.get("refinements", 0)
    if isinstance(refinements, bool) or not isinstance(refinements, int) or not 0 <= refinements <= 20:
        raise InputError(f"search.refinements: need a whole number from 0 to 20, got {refinements!r}")
    return refinements


def _torques(key: str, given: object, *, none: bool = False) -> tuple[float, ...]:
    return _rising(key, given, TORQUE, none=none)


def _rising(key: str, given: object, unit: Unit, *, none: bool) -> tuple[float, ...]:
    """Read values, a list or a range: torques that rise from 0 or more, or those of any key, which may fall, too."""
    what = "torques" if unit is TORQUE else "values"
    values = range_values(f"search.{key}", given) if isinstance(given, str) else given
    if not isinstance(values, list | tuple) or not (values or none):
        raise InputError(f'search.{key}: need {what} such as "0..50 {unit.display} step 10", got {given!r}')
    if len(values) > _MOST_TORQUES:
        raise InputError(f"search.{key}: need at most {_MOST_TORQUES} {what}, got {len(values)}")
    try:
        numbers = tuple(parse_quantity(value, unit) for value in values)
    except InputError as error:
        raise InputError(f"search.{key}: {error}") from None
    rising = sorted(set(numbers))
    if key == "values":
        if list(numbers) not in (rising, rising[::-1]):
            raise InputError(f"search.{key}: need values that rise, or that fall, got {as_written(given)}")
    elif list(numbers) != rising or min(numbers, default=0.0) < 0:
        raise InputError(
            f"search.{key}: need rising torques >= 0, whose sign is that of the drive, got {as_written(given)}"
        )
    return numbers
