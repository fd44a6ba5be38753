"""Reading and writing of law files in TOML, with errors that name the key."""

from __future__ import annotations

import math
import os
import tomllib
from collections.abc import Mapping
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

import tomli_w

from forficula.errors import InputError, error_prefix
from forficula.files import read_toml, write_text
from forficula.material.law.drift import Drift
from forficula.material.law.law_cycle import drifts_of
from forficula.material.law.law_keys import TERMS, law_unit, nearest, number
from forficula.material.law.law_tables import read_facts, read_list, read_table, read_text
from forficula.material.law.material_law import Bounds, MaterialLaw, MaxwellBranch, Unknown
from forficula.material.law.softening import OgdenRoxburgh, Triple
from forficula.names import check_known
from forficula.quantities import as_written, format_quantity, parse_quantity

_NUMBERS = ("yield_strain", "residual_strain", "largest_strain", "lowest_strain_rate", "highest_strain_rate")
_TEXTS = ("name", "source", "no_tendon")
_TABLES = ("modulus", "viscosity", "branches", "softening", "drift", "interval", "range", "unknown", "facts")
_SECTIONS = ("modulus", "viscosity", "branches", "yield_strain", "softening", "largest_strain")
_SOFTENING = ("r", "m", "beta")
_DRIFTS = {"stiffness": True, "residual_strain": False}  # whether a drift is relative


def load_law(name_or_path: str | Path) -> MaterialLaw:
    """Read a named material or a law file.

    Args:
        name_or_path: one of `named_laws`, or the path of a TOML file.

    Raises:
        InputError: no such material or file, not TOML, an unknown key, or a value that is not allowed; the message
            names the file and the key.
    """
    name = str(name_or_path)
    if name in _named():
        return _named_law(name)
    path = Path(name_or_path)
    if path.suffix.lower() != ".toml":
        hint = nearest(name, _named()).replace("allowed here:", "the named materials are")
        raise InputError(f"{as_written(name)} is neither a named material nor a .toml file; {hint}")
    tables = read_toml(path, "a law")
    tables.setdefault("name", path.stem)
    return _read(name, tables)


def save_law(law: MaterialLaw, path: str | os.PathLike[str]) -> None:
    """Write a law to a file, from which exactly the same law is read.

    Raises:
        InputError: the file cannot be written.
    """
    write_text(Path(path), law_text(law))


def named_laws() -> dict[str, str]:
    """Return the names of the materials that come with the package, with their sources."""
    return {name: load_law(name).source for name in _named()}


def law_text(law: MaterialLaw) -> str:
    """Return a law as TOML without absent values."""
    tables: dict[str, Any] = {name: getattr(law, name) for name in _TEXTS if getattr(law, name) or name == "name"}
    for name in _NUMBERS:
        if getattr(law, name) not in (None, 0.0):
            tables[name] = _text(name, getattr(law, name))
    for name, values in (("modulus", law.moduli), ("viscosity", law.viscosity)):
        if values is not None:
            tables[name] = {term: _text(f"{name}.{term}", value) for term, value in zip(TERMS, values, strict=True)}
    if law.branches:
        keys = ("modulus", "time")
        tables["branches"] = [
            {key: _text(f"branches.0.{key}", getattr(branch, key)) for key in keys} for branch in law.branches
        ]
    if law.softening is not None:
        soft = law.softening
        tables["softening"] = {"r": soft.r, "m": _text("softening.m", soft.m), "beta": soft.beta}
    if drifts := drifts_of(law):
        tables["drift"] = {name: _drift_table(drift) for name, drift in drifts.items()}
    for name, pairs in (("interval", law.intervals), ("range", law.ranges)):
        if pairs:
            tables[name] = {pair.key: [_text(pair.key, pair.low), _text(pair.key, pair.high)] for pair in pairs}
    if law.unknown:
        tables["unknown"] = {entry.key: entry.why for entry in law.unknown}
    if law.facts:
        tables["facts"] = [{"what": fact.what, "value": fact.value, "source": fact.source} for fact in law.facts]
    return tomli_w.dumps(tables)


def law_values(law: MaterialLaw) -> dict[str, float]:
    """Return all numbers of a law by key, in SI, without absent values."""
    values: dict[str, float] = {}
    for name, terms in (("modulus", law.moduli), ("viscosity", law.viscosity)):
        values |= {f"{name}.{term}": value for term, value in zip(TERMS, terms or (), strict=False)}
    for index, branch in enumerate(law.branches):
        values |= {f"branches.{index}.modulus": branch.modulus, f"branches.{index}.time": branch.time}
    if law.softening is not None:
        values |= {f"softening.{name}": getattr(law.softening, name) for name in _SOFTENING}
    values |= {name: getattr(law, name) for name in _NUMBERS if getattr(law, name) is not None}
    return values


def _text(key: str, value: float) -> str | float:
    unit = law_unit(key)
    return value if unit.display == "dimensionless" else format_quantity(value, unit)


@cache
def _named() -> tuple[str, ...]:
    folder = resources.files("forficula.material") / "references"
    return tuple(sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml")))


@cache  # the files of the package do not change, and a law is frozen
def _named_law(name: str) -> MaterialLaw:
    text = (resources.files("forficula.material") / "references" / f"{name}.toml").read_text("utf-8")
    return _read(name, tomllib.loads(text))


def _read(file: str, tables: dict[str, Any]) -> MaterialLaw:
    """Convert the tables of a file to a law; every error begins with the name of the file."""
    with error_prefix(f"{file}: "):
        check_known(tables, (*_TEXTS, *_NUMBERS, *_TABLES), "")
        texts = {name: read_text(name, tables.get(name, "")) for name in _TEXTS}
        numbers = {name: _quantity(name, tables[name]) for name in _NUMBERS if name in tables}
        softening = _softening(tables["softening"]) if "softening" in tables else None
        return MaterialLaw(
            name=texts["name"],
            source=texts["source"],
            no_tendon=texts["no_tendon"],
            yield_strain=numbers.get("yield_strain"),
            residual_strain=numbers.get("residual_strain", 0.0),
            largest_strain=numbers.get("largest_strain"),
            lowest_strain_rate=numbers.get("lowest_strain_rate"),
            highest_strain_rate=numbers.get("highest_strain_rate"),
            moduli=_triple("modulus", tables),
            viscosity=_triple("viscosity", tables),
            branches=tuple(_branch(index, branch) for index, branch in enumerate(read_list("branches", tables))),
            softening=softening,
            **{f"{name}_drift": drift for name, drift in _drifts(tables).items()},
            intervals=_bounds("interval", tables),
            ranges=_bounds("range", tables),
            unknown=_unknown(tables),
            facts=read_facts(tables),
        )


def _quantity(key: str, value: object) -> float:
    unit = law_unit(key)
    if unit.display == "dimensionless":
        return number(key, value)
    with error_prefix(f"{key}: "):
        return parse_quantity(value, unit)


def _triple(section: str, tables: Mapping[str, Any]) -> Triple | None:
    """Read the three terms of a polynomial; the quadratic and the cubic one are 0 if they are left out."""
    if section not in tables:
        return None
    table = read_table(section, tables[section], TERMS, needed=TERMS[:1])
    first, second, third = (_quantity(f"{section}.{term}", table[term]) if term in table else 0.0 for term in TERMS)
    return first, second, third


def _branch(index: int, value: object) -> MaxwellBranch:
    keys, key = ("modulus", "time"), f"branches.{index}"
    table = read_table(key, value, keys, needed=keys)
    try:
        return MaxwellBranch(**{name: _quantity(f"{key}.{name}", table[name]) for name in keys})
    except InputError as error:
        raise InputError(str(error).replace("branches.", f"{key}.") if key not in str(error) else str(error)) from None


def _softening(value: object) -> OgdenRoxburgh:
    table = read_table("softening", value, _SOFTENING, needed=("r", "m"))
    return OgdenRoxburgh(**{name: _quantity(f"softening.{name}", entry) for name, entry in table.items()})


def _drift_table(drift: Drift) -> dict[str, Any]:
    """Return a drift as a table with the keys of its kind."""
    values: dict[str, Any] = {"kind": drift.kind}
    if drift.kind != "none":
        values |= {"rate": drift.rate, "interval": list(drift.interval)}
    if drift.kind == "plateau":
        values["cycles"] = drift.cycles
    return values | {"seen": list(drift.seen)}


def _drifts(tables: Mapping[str, Any]) -> dict[str, Drift]:
    table = read_table("drift", tables.get("drift", {}), tuple(_DRIFTS))
    return {name: _drift(f"drift.{name}", drift, _DRIFTS[name]) for name, drift in table.items()}


def _drift(key: str, value: object, relative: bool) -> Drift:
    needed: tuple[str, ...] = ("kind", "seen")
    table = read_table(key, value, ("kind", "rate", "interval", "cycles", "seen"), needed=needed)
    if table["kind"] != "none":
        read_table(key, value, tuple(table), needed=("rate", "interval", *(["cycles"] * (table["kind"] == "plateau"))))
    low, high = _numbers(f"{key}.interval", table.get("interval", [0.0, 0.0]))
    first, last = _numbers(f"{key}.seen", table["seen"])
    if first % 1 or last % 1:
        raise InputError(f"{key}.seen: need whole numbers, got {as_written(table['seen'])}")
    try:
        return Drift(
            kind=table["kind"],
            rate=number(f"{key}.rate", table.get("rate", 0.0)),
            interval=(low, high),
            cycles=number(f"{key}.cycles", table.get("cycles", 0.0)),
            relative=relative,
            seen=(int(first), int(last)),
        )
    except InputError as error:
        raise InputError(str(error) if key in str(error) else f"{key}.{error}") from None


def _numbers(key: str, value: object) -> tuple[float, float]:
    if not isinstance(value, list) or len(value) != 2:
        raise InputError(f"{key}: need two numbers such as [2, 5], got {as_written(value)}")
    first, second = (number(key, entry) for entry in value)
    if not (math.isfinite(first) and math.isfinite(second)):
        raise InputError(f"{key}: need finite numbers, got {as_written(value)}")
    return first, second


def _flat(table: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Return values by dotted key, for quoted keys as well as nested tables."""
    values: dict[str, Any] = {}
    for key, value in table.items():
        values |= _flat(value, f"{prefix}{key}.") if isinstance(value, dict) else {f"{prefix}{key}": value}
    return values


def _bounds(section: str, tables: Mapping[str, Any]) -> tuple[Bounds, ...]:
    table = tables.get(section, {})
    if not isinstance(table, dict):
        raise InputError(f"{section}: need a table under [{section}], got {as_written(table)}")
    return tuple(_pair(section, key, value) for key, value in _flat(table).items())


def _pair(section: str, key: str, value: object) -> Bounds:
    unit = law_unit(key)
    if not isinstance(value, list) or len(value) != 2:
        raise InputError(f'{section}.{key}: need two values such as ["{unit.example}", ...], got {as_written(value)}')
    with error_prefix(f"{section}."):
        low, high = (_quantity(key, entry) for entry in value)
    if not low <= high:
        raise InputError(f"{section}.{key}: need the lower value first, got {as_written(value)}")
    return Bounds(key=key, low=low, high=high)


def _unknown(tables: Mapping[str, Any]) -> tuple[Unknown, ...]:
    table = read_table("unknown", tables.get("unknown", {}), _SECTIONS)
    return tuple(Unknown(key=key, why=read_text(f"unknown.{key}", why)) for key, why in table.items())
