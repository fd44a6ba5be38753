"""Law files of creases in TOML: values per length of the crease, with their sources."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

import tomli_w

from forficula.errors import InputError, error_prefix
from forficula.files import read_toml, write_text
from forficula.material.law.law_keys import nearest
from forficula.material.law.law_tables import read_facts, read_table, read_text
from forficula.material.law.material_law import LawFact
from forficula.names import check_known
from forficula.quantities import Unit, as_written

CREASE_STIFFNESS = Unit(display="N m/rad/m", si="N m/rad/m", example="1e-2 N m/rad/m")
CREASE_MOMENT = Unit(display="N m/m", si="N m/m", example="1e-2 N m/m")
CREASE_DAMPING = Unit(display="N m s/rad/m", si="N m s/rad/m", example="1e-3 N m s/rad/m")
# forms of the elastic part of a spring, which a design may name instead of a law
FORMS = ("linear", "locking")
_TEXTS = ("name", "source", "thickness", "width")
_TABLES = ("crease", "chosen", "interval", "facts")
LAW_VALUES = ("stiffness", "rest_angle", "yield_moment", "hardening", "damping", "kind")


@dataclass(frozen=True, kw_only=True)
class CreaseLawFile:
    """A law of creases as its file has it; a design reads and checks the values.

    Attributes:
        name: name of the law.
        source: source of the numbers.
        thickness: thickness of the sheet to which the values apply, with its unit; empty if it is not known.
        width: length of the crease on which the values were measured, with its unit; empty if they were not measured.
        values: values by the keys of the section [crease] of a design, per length of the crease, as in the file.
        chosen: reason for each chosen value, by key.
        intervals: lower and upper end of the 95 % confidence interval of each fitted value, by key, as in the file.
        facts: further facts from the sources.
    """

    name: str
    source: str = ""
    thickness: str = ""
    width: str = ""
    values: Mapping[str, Any]
    chosen: Mapping[str, str]
    intervals: Mapping[str, tuple[str, str]]
    facts: tuple[LawFact, ...] = ()

    @property
    def tables(self) -> dict[str, Any]:
        """The values and their description by the keys of a design's law of creases."""
        described = {name: getattr(self, name) for name in _TEXTS if getattr(self, name)}
        return {**described, "chosen": list(self.chosen), **self.values}


def load_crease_law(name_or_path: str | Path) -> CreaseLawFile:
    """Read a named law of creases or a law file.

    Args:
        name_or_path: one of `named_crease_laws`, or the path of a TOML file.

    Raises:
        InputError: no such law or file, not TOML, or an unknown table; the message names the file and the key.
    """
    name = str(name_or_path)
    if name in _named():
        return _named_law(name)
    path = Path(name_or_path)
    if path.suffix.lower() != ".toml":
        hint = nearest(name, (*FORMS, *_named())).replace("allowed here:", "the forms and named laws are")
        raise InputError(f"{as_written(name)} is neither a form, a named law of creases nor a .toml file; {hint}")
    tables = read_toml(path, "a law of creases")
    tables.setdefault("name", path.stem)
    return _read(name, tables)


def named_crease_laws() -> dict[str, str]:
    """Return the names of the laws of creases that come with the package, with their sources."""
    return {name: load_crease_law(name).source for name in _named()}


def save_crease_law(law: CreaseLawFile, path: str | os.PathLike[str]) -> None:
    """Write a law of creases to a file, from which exactly the same law is read.

    Raises:
        InputError: the file cannot be written.
    """
    tables: dict[str, Any] = {name: getattr(law, name) for name in _TEXTS if getattr(law, name)}
    tables["crease"] = dict(law.values)
    for name, values in (("chosen", law.chosen), ("interval", law.intervals)):
        if values:
            tables[name] = {key: value if isinstance(value, str) else list(value) for key, value in values.items()}
    if law.facts:
        tables["facts"] = [{"what": fact.what, "value": fact.value, "source": fact.source} for fact in law.facts]
    write_text(Path(path), tomli_w.dumps(tables))


@cache
def _named() -> tuple[str, ...]:
    entries = _folder().iterdir()
    return tuple(sorted(entry.name.removesuffix(".toml") for entry in entries if entry.name.endswith(".toml")))


@cache  # the files of the package do not change, and a law is frozen
def _named_law(name: str) -> CreaseLawFile:
    return _read(name, tomllib.loads((_folder() / f"{name}.toml").read_text("utf-8")))


def _folder() -> Any:
    return resources.files("forficula.material") / "references" / "creases"


def _read(file: str, tables: Mapping[str, Any]) -> CreaseLawFile:
    """Convert the tables of a file to a law; every error begins with the name of the file."""
    with error_prefix(f"{file}: "):
        if "crease" not in tables and "modulus" in tables:
            raise InputError("need a law of creases with a table [crease], got a law of tendons")
        check_known(tables, (*_TEXTS, *_TABLES), "")
        values = read_table("crease", tables.get("crease"), LAW_VALUES)
        if "stiffness" not in values:
            raise InputError("crease.stiffness: is missing; a law of creases needs it")
        for section in ("chosen", "interval"):
            read_table(section, tables.get(section, {}), tuple(values))
        return CreaseLawFile(
            **{name: read_text(name, tables.get(name, "")) for name in _TEXTS},
            values=values,
            chosen={key: read_text(f"chosen.{key}", why) for key, why in tables.get("chosen", {}).items()},
            intervals={key: _pair(f"interval.{key}", pair) for key, pair in tables.get("interval", {}).items()},
            facts=read_facts(tables),
        )


def _pair(key: str, value: object) -> tuple[str, str]:
    if not isinstance(value, list) or len(value) != 2:
        raise InputError(f"{key}: need two values, the lower one first, got {as_written(value)}")
    low, high = (read_text(key, entry) for entry in value)
    return low, high
