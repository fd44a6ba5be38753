"""Sections of a design that do not change while other values do, and are not read and checked again."""

from __future__ import annotations

from typing import Any

from forficula.design.section import Section


def with_kept_sections(section: Section, tables: dict[str, Any]) -> dict[str, Any]:
    """Replace tables that did not change by the sections that were read from them.

    Args:
        section: a checked section.
        tables: its `si_tables` with some values replaced.
    """
    before = section.si_tables()
    return {
        key: _kept(getattr(section, key), before[key], after) if key in before else after
        for key, after in tables.items()
    }


def _kept(value: object, before: object, after: Any) -> Any:
    """Return a section if its tables did not change; otherwise the tables, with unchanged sections inside them."""
    if isinstance(value, Section) and isinstance(after, dict):
        return value if _same(before, after) else with_kept_sections(value, after)
    if not (isinstance(value, tuple) and value and isinstance(before, list) and isinstance(after, list)):
        return after
    if not all(isinstance(entry, Section) for entry in value) or not len(value) == len(before) == len(after):
        return after
    return [_kept(entry, before[number], after[number]) for number, entry in enumerate(value)]


def _same(before: object, after: object) -> bool:
    """Return whether tables hold the same objects; equal values may differ in type, as 1.0 and true do."""
    if before is after:
        return True
    if isinstance(before, dict) and isinstance(after, dict):
        return before.keys() == after.keys() and all(_same(before[key], after[key]) for key in before)
    if isinstance(before, list) and isinstance(after, list):
        return len(before) == len(after) and all(map(_same, before, after))
    return False
