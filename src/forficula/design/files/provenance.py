"""Where the values of a design come from, once some of them are other ones."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from forficula.design.files.tendon_tables import is_by_vein
from forficula.errors import InputError
from forficula.names import listed
from forficula.quantities import as_written

if TYPE_CHECKING:
    from forficula.design.design import Design

# what a design says of itself, which is no value of it
WORDS = ("name", "source", "shows", "reproduces")
PAPERS = ("binder2025",)  # that a design or a study may be set beside
_MOST_TOLD = 6


def derived_source(base: Design, design: Design) -> str:
    """The source of a design that came from another: where values differ, which, and then the source of the other."""
    given = differing_keys(base, design)
    if not given:
        return base.source
    beginning, end = f"{base.name} with other values of ", f"; {base.name}: "
    told, _, original = base.source.removeprefix(beginning).partition(end)
    before = told.replace(" and ", ", ").split(", ") if base.source.startswith(beginning) and original else []
    changed = sorted({*before, *given} - {"more"})
    if len(changed) > _MOST_TOLD:
        changed = [*changed[:_MOST_TOLD], "more"]
    source = original if before else base.source
    return f"{beginning}{listed(changed)}{end}{source}" if source else f"{beginning}{listed(changed)}"


def differing_keys(base: Design, design: Design) -> list[str]:
    """The dotted keys at which two designs differ, but for what they are called and where they come from."""
    return _differing(base.si_tables(), design.si_tables())


def _differing(base: object, given: object, key: str = "") -> list[str]:
    """The dotted keys at which tables differ, but for words; entries of lists by their names, if they have them."""
    if base is given:
        return []
    if isinstance(base, list | tuple) and isinstance(given, list | tuple):
        base, given = _by_name(base) or base, _by_name(given) or given
        if isinstance(base, dict) and isinstance(given, dict) and list(base) != list(given):
            return [key]
    # tendons that differ from vein to vein count as one value
    whole = key == "tendon" and (is_by_vein(base) or is_by_vein(given))
    if whole or not (isinstance(base, dict) and isinstance(given, dict)):
        return [] if base == given else [key]
    names = [name for name in {**base, **given} if key or name not in WORDS]
    parts = (_differing(base.get(name), given.get(name), f"{key}.{name}" if key else name) for name in names)
    return [found for part in parts for found in part]


def _by_name(entries: Sequence[object]) -> dict[str, object]:
    """Entries of a list by their names; none where they have none of their own."""
    found: dict[str, object] = {
        str(entry["name"]): entry for entry in entries if isinstance(entry, dict) and entry.get("name")
    }
    return found if len(found) == len(entries) else {}


def scaled_source(name: str, source: str, factor: float) -> str:
    """The source of a design that was scaled in size."""
    scaled = f"{name} at {factor:g} times its size"
    return f"{scaled}; {name}: {source}" if source else scaled


def check_paper(name: str) -> str:
    """Take the name of a paper that is reproduced.

    Raises:
        InputError: there is none of that name; the caller knows the key.
    """
    if name not in PAPERS:
        raise InputError(f"need one of {', '.join(PAPERS)}, got {as_written(name)}")
    return name
