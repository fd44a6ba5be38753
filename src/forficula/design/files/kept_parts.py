"""Parts of a design that stay as they are while other values change, so that they are not read and checked again."""

from __future__ import annotations

from typing import Any

from forficula.design.section import Section


def with_kept_parts(part: Section, tables: dict[str, Any]) -> dict[str, Any]:
    """Tables of a part with its own parts in place of the tables that are still theirs.

    Args:
        part: checked.
        tables: its `si_tables` with some values replaced.
    """
    before = part.si_tables()
    return {
        key: _kept(getattr(part, key), before[key], after) if key in before else after for key, after in tables.items()
    }


def _kept(value: object, before: object, after: Any) -> Any:
    """What a part has at a key, if its tables are as before and it holds parts; else the tables, parts kept in them."""
    if isinstance(value, Section) and isinstance(after, dict):
        return value if _same(before, after) else with_kept_parts(value, after)
    if not (isinstance(value, tuple) and value and isinstance(before, list) and isinstance(after, list)):
        return after
    if not all(isinstance(entry, Section) for entry in value) or not len(value) == len(before) == len(after):
        return after
    return [_kept(entry, before[number], after[number]) for number, entry in enumerate(value)]


def _same(before: object, after: object) -> bool:
    """Whether tables hold the very same values: equal ones may be of another kind, as 1.0 and true are."""
    if before is after:
        return True
    if isinstance(before, dict) and isinstance(after, dict):
        return before.keys() == after.keys() and all(_same(before[key], after[key]) for key in before)
    if isinstance(before, list) and isinstance(after, list):
        return len(before) == len(after) and all(map(_same, before, after))
    return False
