"""Tables of design files laid over each other, by the rules of each kind of design."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from forficula.design.assembly.assembly import part_names
from forficula.design.fans.fan import FanDesign
from forficula.design.fans.fan_sections import MOST_UNITS
from forficula.design.fans.joint import JointDesign
from forficula.design.fans.joint_sections import JointTendon
from forficula.design.files.keys import section_fields
from forficula.design.files.kinds import KINDS, design_class, kind_of
from forficula.design.files.tables import (
    REMOVED,
    RejectedError,
)
from forficula.design.files.tendon_tables import entries_over, tendon_over, tendons_over
from forficula.design.sheets.crease_law_section import CreaseSpring
from forficula.errors import InputError
from forficula.material.law.crease_law_file import FORMS, CreaseLawFile, load_crease_law
from forficula.quantities import as_written


def laid_over(
    tables: dict[str, Any], upper: dict[str, Any], lay: Callable[[object, object], Any], *, si: bool
) -> dict[str, Any]:
    """Lay tables over others; tendons have separate rules, and the pattern of a fan gives their number."""
    if names := tuple(dict.fromkeys([*part_names(tables), *part_names(upper)])):
        return _assembly_over(tables, upper, lay, names, si=si)
    tables = _without_other_spring(_without_other_pattern(tables, kind_of(upper)), upper)
    both: dict[str, Any] = lay(tables, {key: value for key, value in upper.items() if key != "tendon"})
    if REMOVED in both.values():
        both = _without_removed(both)
    if "tendon" not in upper:
        return both
    model = design_class(both)
    if issubclass(model, JointDesign):
        tendon = upper["tendon"]
        if isinstance(tendon, dict):
            tendon = tendon_over(tables.get("tendon"), tendon, "", si=si, model=JointTendon)
        return {**both, "tendon": tendon}
    if not issubclass(model, FanDesign):
        return {**both, "tendon": entries_over(tables.get("tendon"), upper["tendon"], si=si)}
    pattern = both.get("pattern")
    units = pattern.get("units") if isinstance(pattern, dict) else None
    veins = 2 * units + 1 if isinstance(units, int) and 0 < units <= MOST_UNITS else 0
    return {**both, "tendon": tendons_over(tables.get("tendon"), upper["tendon"], veins=veins, si=si)}


def _assembly_over(
    tables: dict[str, Any],
    upper: dict[str, Any],
    lay: Callable[[object, object], Any],
    names: Sequence[str],
    *,
    si: bool,
) -> dict[str, Any]:
    """Lay tables of an assembly over others, part by part, by the rules of each part's kind."""
    parts: dict[str, Any] = {}
    for name in names:
        below, above = tables.get(name, {}), upper.get(name)
        if above is None:
            continue
        if not isinstance(below, dict) or not isinstance(above, dict):
            raise RejectedError([name], f"{name}: need a table under [part.{name}], got {as_written(above)}")
        try:
            parts[name] = laid_over(below, above, lay, si=si)
        except RejectedError as error:
            raise RejectedError([name, *error.place], f"{name}.{error}") from None
        except InputError as error:
            raise InputError(f"{name}.{error}") from None
    others = {key: value for key, value in upper.items() if key not in (*names, "parts")}
    below = {key: value for key, value in tables.items() if key not in parts}
    return {**lay(below, others), **parts, "parts": list(names)}


def _without_removed(tables: dict[str, Any]) -> dict[str, Any]:
    """Return tables without the sections that "none" removes: those that a design need not have."""
    fields = design_class(tables).model_fields
    removed = {
        key
        for key, value in tables.items()
        if value == REMOVED and key in fields and fields[key].default is None and section_fields(fields[key].annotation)
    }
    return {key: value for key, value in tables.items() if key not in removed}


def _without_other_spring(tables: dict[str, Any], upper: dict[str, Any]) -> dict[str, Any]:
    """Remove the spring of the creases from tables if a law of creases is to be laid over them.

    Damping and rest angle stay if the law gives none.
    """
    crease, changes = tables.get("crease"), upper.get("crease")
    law = changes.get("law") if isinstance(changes, dict) else None
    named = law.get("based_on") if isinstance(law, dict) else law
    if not isinstance(crease, dict) or not isinstance(named, str | CreaseLawFile) or named in FORMS:
        return tables
    try:
        file = named if isinstance(named, CreaseLawFile) else load_crease_law(named)
    except InputError as error:
        raise RejectedError(["crease", "law"], f"crease.law: {error}") from None
    replaced = set(CreaseSpring.model_fields) - ({"damping", "rest_angle"} - file.values.keys())
    return tables | {"crease": {key: value for key, value in crease.items() if key not in replaced}}


def _without_other_pattern(tables: dict[str, Any], kind: str | None) -> dict[str, Any]:
    """Remove the pattern from tables if a pattern of another kind is to be laid over them.

    Raises:
        RejectedError: designs of the new kind have other sections.
    """
    below = kind_of(tables)
    if kind == below or kind is None or below is None or not {kind, below} <= KINDS.keys():
        return tables
    model = KINDS[kind]
    if model.model_fields.keys() != KINDS[below].model_fields.keys():
        reference = model.reference
        instead = f'; begin with based_on = "{reference}"' if reference else ""
        raise RejectedError(
            ["pattern", "kind"],
            f"pattern.kind: designs of kind {kind} have other sections than those of kind {below}{instead}",
        )
    return {key: value for key, value in tables.items() if key != "pattern"}
