"""Sources of the values of a design that was derived from another one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from forficula.design.files.tendon_tables import is_by_vein
from forficula.errors import InputError
from forficula.names import listed
from forficula.quantities import as_written

if TYPE_CHECKING:
    from forficula.design.design import Design

# keys that describe a design and are not values of it
DESCRIPTIVE_KEYS = ("name", "source", "shows", "reproduces")
PAPERS = ("binder2025",)  # papers with which a design or a study may be compared
_MOST_LISTED = 6


def derived_source(base: Design, design: Design) -> str:
    """Return the source of a design derived from another: the keys that differ, then the source of the other."""
    differing = differing_keys(base, design)
    if not differing:
        return base.source
    beginning, end = f"{base.name} with other values of ", f"; {base.name}: "
    listing, _, original = base.source.removeprefix(beginning).partition(end)
    before = listing.replace(" and ", ", ").split(", ") if base.source.startswith(beginning) and original else []
    changed = sorted({*before, *differing} - {"more"})
    if len(changed) > _MOST_LISTED:
        changed = [*changed[:_MOST_LISTED], "more"]
    source = original if before else base.source
    return f"{beginning}{listed(changed)}{end}{source}" if source else f"{beginning}{listed(changed)}"


def differing_keys(base: Design, design: Design) -> list[str]:
    """Return the dotted keys at which two designs differ, except for `DESCRIPTIVE_KEYS`."""
    return _differing(base.si_tables(), design.si_tables())


def _differing(base: object, other: object, key: str = "") -> list[str]:
    """Return the dotted keys at which tables differ, except `DESCRIPTIVE_KEYS`; entries of lists by their names."""
    if base is other:
        return []
    if isinstance(base, list | tuple) and isinstance(other, list | tuple):
        base, other = _by_name(base) or base, _by_name(other) or other
        if isinstance(base, dict) and isinstance(other, dict) and list(base) != list(other):
            return [key]
    # tendons that differ from vein to vein count as one value
    whole = key == "tendon" and (is_by_vein(base) or is_by_vein(other))
    if whole or not (isinstance(base, dict) and isinstance(other, dict)):
        return [] if base == other else [key]
    names = [name for name in {**base, **other} if key or name not in DESCRIPTIVE_KEYS]
    keys = (_differing(base.get(name), other.get(name), f"{key}.{name}" if key else name) for name in names)
    return [differing for inner in keys for differing in inner]


def _by_name(entries: Sequence[object]) -> dict[str, object]:
    """Return the entries of a list by their names; empty if not all of them have different names."""
    named: dict[str, object] = {
        str(entry["name"]): entry for entry in entries if isinstance(entry, dict) and entry.get("name")
    }
    return named if len(named) == len(entries) else {}


def scaled_source(name: str, source: str, factor: float) -> str:
    """Return the source of a design that was scaled in size."""
    scaled = f"{name} at {factor:g} times its size"
    return f"{scaled}; {name}: {source}" if source else scaled


def check_paper(name: str) -> str:
    """Return the name of a paper that is reproduced, if it is known.

    Raises:
        InputError: there is no paper of that name; the caller adds the key.
    """
    if name not in PAPERS:
        raise InputError(f"need one of {', '.join(PAPERS)}, got {as_written(name)}")
    return name
