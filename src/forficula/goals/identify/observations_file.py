"""Observations in files: named ones, and those of a user."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from forficula.design import Design, key_quantity, key_value, numbered_key
from forficula.design.key_table import names_within
from forficula.design.part import Quantity
from forficula.errors import InputError
from forficula.goals.identify.fact import Fact
from forficula.goals.identify.fact_file import read_fact
from forficula.goals.identify.observation_keys import OBSERVATION_KEYS
from forficula.goals.identify.observations import Observations
from forficula.names import as_given, check_whole, folder_name
from forficula.quantities import as_written
from forficula.study.factors import DISTRIBUTIONS, MOST_VALUES, Factor
from forficula.study.file_keys import check_keys
from forficula.study.named_file import base_design, load_named, named_files
from forficula.study.study_file import check_not_settled, read_factors

_PACKAGE = "forficula.goals.identify"
_SAMPLES, _DIRECTED = 256, 128


def load_observations(name_or_path: str | Path) -> Observations:
    """Read named observations or an observations file.

    Args:
        name_or_path: one of `named_observations`, or the path of a TOML file.

    Raises:
        InputError: none such, not TOML, an unknown key, or a value that is not allowed.
    """
    return load_named(name_or_path, _PACKAGE, "observations file", "observations", observations_of)


def named_observations() -> list[str]:
    """The names of the observations that come with the package."""
    return named_files(_PACKAGE)


def observations_of(tables: Mapping[str, Any], folder: Path = Path()) -> Observations:
    """Build observations of tables as a file has them, but for `design`, which may be one.

    Args:
        tables: of the file.
        folder: that paths start from.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    check_keys(tables, names_within("", OBSERVATION_KEYS), "")
    for key in ("settings", "sampling", "unknown"):
        if not isinstance(tables.get(key, {}), dict):
            raise InputError(f"{key}: need a table, got {as_written(tables[key])}")
    try:
        title = folder_name(tables.get("name", "observations"))
    except InputError as error:
        raise InputError(f"name: {error}") from None
    base = base_design(tables, folder)
    priors = _priors(tables, folder, base)
    sampling = tables.get("sampling", {})
    check_keys(sampling, names_within("sampling", OBSERVATION_KEYS), "sampling.")
    return Observations(
        name=title,
        source=str(tables.get("source", "")),
        base=base,
        priors=priors,
        facts=_facts(tables.get("fact"), base, folder, priors),
        samples=_whole(sampling, "samples", _SAMPLES, 1),
        directed=_whole(sampling, "directed", _DIRECTED, 0),
        seed=_whole(sampling, "seed", 0, 0),
    )


def _priors(tables: Mapping[str, Any], folder: Path, base: Design) -> tuple[Factor, ...]:
    priors = read_factors(tables, "unknown", folder, base)
    check_not_settled(tables, "unknown", priors, base)
    for prior in priors:
        now, quantity = key_value(base, prior.key), key_quantity(prior.key, prior.model)
        if prior.distribution is not None and quantity is None and not isinstance(now, float):
            raise InputError(f"unknown.{prior.key}: need a list or a range; only numbers with fractions are drawn")
        if quantity is not None:
            _check_allowed(prior, quantity)
    return priors


def _check_allowed(prior: Factor, quantity: Quantity) -> None:
    """Refuse what is believed of a value where its key allows none, for no design is built of it."""
    given: list[tuple[str, object]] = [("", value) for value in prior.values]
    if (drawn := prior.distribution) is not None:
        # a normal distribution has no end: what it has beyond a bound is not built, and counted as such
        ends = (drawn.first,) if drawn.name == "normal" else (drawn.first, drawn.second)
        given = [(f".{name}", end) for name, end in zip(DISTRIBUTIONS[drawn.name], ends, strict=False)]
    for place, value in given:
        try:
            quantity.read(value, in_si=drawn is not None)
        except InputError as error:
            raise InputError(f"unknown.{prior.key}{place}: {error}") from None


def _facts(given: object, base: Design, folder: Path, priors: Sequence[Factor]) -> tuple[Fact, ...]:
    if not isinstance(given, list) or not given:
        raise InputError(f"fact: need at least one table [[fact]], {as_given(given)}")
    facts: list[Fact] = []
    for number, table in enumerate(given):
        name = table.get("name", number) if isinstance(table, dict) else number
        try:
            facts.append(read_fact(table, base, folder))
            _check_known(facts[-1], base, priors)
        except InputError as error:
            raise InputError(f"fact {name}: {error}") from None
        if facts[-1].name in [fact.name for fact in facts[:-1]]:
            raise InputError(f"fact {name}: need a name of its own")
    return tuple(facts)


def _check_known(fact: Fact, base: Design, priors: Sequence[Factor]) -> None:
    """Refuse conditions over what is unknown: a sample has one value of it, and the fact would be held to others."""
    unknown = {numbered_key(base, prior.key): prior.key for prior in priors}
    for term in fact.terms:
        keys = [(f"over.{factor.key}", factor.key) for factor in term.over]
        keys += [] if term.least is None else [("least.key", term.least.key)]
        for place, key in keys:
            if (own := unknown.get(numbered_key(base, key))) is not None:
                told = "" if place.endswith(own) else f", as {own}"
                raise InputError(f"{place}: is under [unknown], too{told}; need it in one of them")


def _whole(sampling: Mapping[str, Any], key: str, default: int, least: int) -> int:
    return check_whole(f"sampling.{key}", sampling.get(key, default), least, MOST_VALUES)
