"""A law of creases as text."""

from __future__ import annotations

from typing import Any

from rich.console import Console, Group, RenderableType
from rich.text import Text

from forficula.material.law.crease_law_file import CreaseLawFile
from forficula.show.material.material_table import plain_table


def print_crease_law(law: CreaseLawFile) -> None:
    """Print the values of a law of creases, and the facts from which they follow."""
    Console(width=110, highlight=False).print(crease_law_table(law))


def crease_law_table(law: CreaseLawFile) -> RenderableType:
    """Return the values of a law of creases with their intervals or reasons, and the facts from its sources."""
    sizes = [f"{name} {size}" for name in ("thickness", "width") if (size := getattr(law, name))]
    parts: list[RenderableType] = [Text(", ".join([f"{law.name}: {law.source or 'no source'}", *sizes])), Text()]
    values = plain_table("crease.", "value", "95 % interval", "chosen")
    values.columns[-1].justify = "left"
    for key, value in law.values.items():
        low, high = law.intervals.get(key, ("", ""))
        values.add_row(key, str(value), f"{low} to {high}" if low else "", law.chosen.get(key, ""))
    parts.append(values)
    if law.facts:
        facts = plain_table("fact", "value", "source")
        facts.columns[-1].justify = "left"
        for fact in law.facts:
            facts.add_row(*map(Text, (fact.what, fact.value, fact.source)))
        parts += [Text(), facts]
    return Group(*parts)


def crease_law_json(law: CreaseLawFile) -> dict[str, Any]:
    """Return a law of creases as plain data with the texts of its file."""
    return {
        "name": law.name,
        "source": law.source,
        "thickness": law.thickness or None,
        "width": law.width or None,
        "values": dict(law.values),
        "chosen": dict(law.chosen),
        "interval_95": {key: list(pair) for key, pair in law.intervals.items()},
        "facts": [{"what": fact.what, "value": fact.value, "source": fact.source} for fact in law.facts],
    }
