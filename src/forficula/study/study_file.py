"""Studies in files: named ones, and those of a user."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from forficula.design import (
    NO_LAW,
    Design,
    check_keys_once,
    key_quantity,
    key_value,
    names_law,
    numbered_key,
    value_from_folder,
)
from forficula.design.key_table import names_within
from forficula.design.provenance import check_paper
from forficula.errors import InputError
from forficula.names import check_whole, folder_name, one_of
from forficula.quantities import as_written
from forficula.structure import structure_of
from forficula.study.choices import one_at_a_time, with_own_word
from forficula.study.factors import MOST_VALUES, Factor, drawn_values, grid_points, read_factor
from forficula.study.file_keys import check_keys, dotted_values
from forficula.study.named_file import base_design, load_named, named_files
from forficula.study.search_file import SEARCHES, read_search
from forficula.study.search_steps import Search
from forficula.study.study import Study
from forficula.study.study_keys import STUDY_KEYS

_PACKAGE = "forficula.study"


def load_study(name_or_path: str | Path) -> Study:
    """Read a named study or a study file.

    Args:
        name_or_path: one of `named_studies`, or the path of a TOML file.

    Raises:
        InputError: no such study or file, not TOML, an unknown key, or a value that is not allowed.
    """
    return load_named(name_or_path, _PACKAGE, "study", "studies", _study)


def study_of(tables: Mapping[str, Any]) -> Study:
    """Build a study of tables as a file has them, but for `design`, which may be one.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    return _study(dict(tables), Path())


def named_studies() -> list[str]:
    """The names of the studies that come with the package."""
    return named_files(_PACKAGE)


def _study(tables: dict[str, Any], folder: Path) -> Study:
    check_keys(tables, names_within("", STUDY_KEYS), "")
    _check_tables(tables)
    base = base_design(tables, folder)
    factors = read_factors(tables, "factors", folder, base)
    drawn = [factor for factor in factors if factor.distribution is not None]
    vary = _vary(tables, factors, drawn)
    if vary == "grid":  # otherwise a setting says where the others vary from
        check_not_settled(tables, "factors", factors, base)
    grid = _repeated_grid(tables, vary, factors, folder, base)
    _check_drawn(tables, base, (*factors, *grid), drawn)
    search = _search(tables, base, (*factors, *grid))
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
        name=folder_name(tables["name"]),
        source=str(tables.get("source", "")),
        base=base,
        factors=factors,
        points=tuple(points),
        sampled=bool(drawn),
        search=search,
        choices=choices,
        grid=grid,
        reproduces=tables.get("reproduces"),
    )


def _check_tables(tables: Mapping[str, Any]) -> None:
    """Refuse what cannot be, whatever the design is."""
    for key in ("settings", "sampling", "search"):
        if not isinstance(tables.get(key, {}), dict):
            raise InputError(f"{key}: need a table, got {as_written(tables[key])}")
    try:
        folder_name(tables["name"])
    except InputError as error:
        raise InputError(f"name: {error}") from None
    reproduces = tables.get("reproduces")
    if not isinstance(reproduces, str | None):
        raise InputError(f"reproduces: need the name of a paper, in quotes, got {as_written(reproduces)}")
    try:
        if reproduces is not None:
            check_paper(reproduces)
    except InputError as error:
        raise InputError(f"reproduces: {error}") from None


def _vary(tables: Mapping[str, Any], factors: Sequence[Factor], drawn: Sequence[Factor]) -> str:
    """How the factors vary together; some of them are drawn, or none."""
    if drawn and len(drawn) < len(factors):
        raise InputError("factors: need either all of them as distributions or none, got both kinds")
    vary = tables.get("vary", "grid")
    if vary not in ("grid", "one-at-a-time"):
        raise InputError(f'vary: need "grid" or "one-at-a-time", got {as_written(vary)}')
    if "vary" in tables and drawn:
        raise InputError(f"vary: needs factors that are lists or ranges, got distributions with {as_written(vary)}")
    return str(vary)


def _check_drawn(tables: Mapping[str, Any], base: Design, factors: Sequence[Factor], drawn: Sequence[Factor]) -> None:
    """Refuse to draw values between which there are none, and to say how where none are drawn."""
    if "sampling" in tables and not drawn:
        raise InputError("sampling: needs factors that are distributions, got lists and ranges")
    for factor in factors:
        now = key_value(base, factor.key)
        if factor in drawn and key_quantity(factor.key, factor.model) is None and not isinstance(now, float):
            raise InputError(f"{factor.key}: need a list or a range; only numbers with fractions are drawn")


def read_factors(tables: Mapping[str, Any], name: str, folder: Path, base: Design) -> tuple[Factor, ...]:
    """The factors of a table of a file.

    Args:
        tables: of the file.
        name: of the table.
        folder: that paths start from.
        base: the design that is varied.

    Raises:
        InputError: the table is missing or empty, or a value is not allowed, or given twice by two names.
    """
    given = tables.get(name)
    if not isinstance(given, dict) or not given:
        raise InputError(f'{name}: need a table with at least one, such as "tendon.stiffness" = "10..60 N/cm step 10"')
    values = dotted_values(given, name, empty=True)
    try:
        check_keys_once(values, base)
        return tuple(
            read_factor(key, value_from_folder(key, value, folder), type(base)) for key, value in values.items()
        )
    except InputError as error:
        raise InputError(f"{name}.{error}") from None


def check_not_settled(tables: Mapping[str, Any], name: str, factors: Sequence[Factor], base: Design) -> None:
    """Refuse a factor whose key is under `settings`, too, where its value there counts for no run.

    Args:
        tables: of the file.
        name: of the table of the factors.
        factors: that have a value in every run.
        base: the design that is varied.

    Raises:
        InputError: which one is.
    """
    settings = {numbered_key(base, key): key for key in dotted_values(tables.get("settings", {}), "settings")}
    for factor in factors:
        if names_law(factor.key) and NO_LAW in factor.values:
            continue  # a tendon without a law keeps the stiffness of the one that it had
        if (twice := settings.get(numbered_key(base, factor.key))) is not None:
            told = "" if twice == factor.key else f", as {twice}"
            raise InputError(f"{name}.{factor.key}: is under [settings], too{told}; need it in one of them")


def _repeated_grid(
    tables: Mapping[str, Any], vary: str, factors: tuple[Factor, ...], folder: Path, base: Design
) -> tuple[Factor, ...]:
    """The factors that are crossed wherever the others, varied one at a time, are."""
    if "grid" not in tables:
        return ()
    if vary != "one-at-a-time":
        raise InputError('grid: needs vary = "one-at-a-time"; otherwise all factors are a grid, under [factors]')
    grid = read_factors(tables, "grid", folder, base)
    check_not_settled(tables, "grid", grid, base)
    if twice := {factor.key for factor in grid} & {factor.key for factor in factors}:
        raise InputError(f"grid.{min(twice)}: is under [factors], too; need it in one of them")
    if drawn := [factor.key for factor in grid if factor.distribution is not None]:
        raise InputError(f"grid.{drawn[0]}: need a list or a range, got a distribution")
    return grid


def _search(tables: Mapping[str, Any], base: Design, factors: Sequence[Factor]) -> Search | None:
    """What the study looks for, none of which its factors may vary; None where it runs the protocol as it is."""
    ask = tables.get("ask", "run")
    if ask not in ("run", *SEARCHES):
        raise InputError(f"ask: need {one_of(('run', *SEARCHES), str(ask))}")
    if "search" in tables and ask not in SEARCHES:
        raise InputError('search: needs ask = "least-torques" or "least-value"')
    if ask not in SEARCHES:
        return None
    search = read_search(ask, tables.get("search", {}), base)
    looked_for = {step.key for step in search.steps}
    if ask == "least-torques":
        looked_for |= {drive.key for drive in structure_of(base).drives}
    if taken := looked_for & {factor.key for factor in factors}:
        raise InputError(f'factors.{min(taken)}: is what "{ask}" looks for; give it under [search], or ask "run"')
    return search


def _drawn(factors: tuple[Factor, ...], sampling: Mapping[str, Any]) -> list[dict[str, object]]:
    check_keys(sampling, names_within("sampling", STUDY_KEYS), "sampling.")
    method = sampling.get("method", "sobol")
    if method not in ("random", "sobol"):
        raise InputError(f'sampling.method: need "random" or "sobol", got {method!r}')
    count = check_whole("sampling.count", sampling.get("count"), 1, MOST_VALUES)
    seed = check_whole("sampling.seed", sampling.get("seed", 0), 0)
    return drawn_values(factors, method, count, seed)
