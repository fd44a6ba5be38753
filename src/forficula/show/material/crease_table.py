"""A characterised crease as text."""

from __future__ import annotations

import math

from rich.console import Console, Group, RenderableType
from rich.text import Text

from forficula.material.folding.crease_characterisation import CreaseCharacterisation, shown_value
from forficula.names import counted
from forficula.quantities import show_value
from forficula.show.material.material_table import plain_table, sentence


def print_crease(crease: CreaseCharacterisation) -> None:
    """Print the law of a crease."""
    Console(width=110, highlight=False).print(crease_table(crease))


def crease_table(crease: CreaseCharacterisation) -> RenderableType:
    """Return the values of the law, the laws that were compared, and the remarks as sentences."""
    fit, law = crease.fit, crease.law
    sizes = [f"{key} {size}" for key in ("width", "thickness") if (size := getattr(law, key))]
    heading = ", ".join([f"{crease.name}: {counted(len(crease.tests), 'strip')}", *sizes])
    residual = f"{_moment(fit.misfit)}, {100 * fit.relative_misfit:.2g} % of the largest moment"
    values = plain_table("crease.", "value", "95 % interval")
    for value in fit.values:
        interval = [shown_value(value.key, end) for end in value.interval or ()]
        values.add_row(
            value.key, shown_value(value.key, value.value), " to ".join(interval).replace("-", "\N{MINUS SIGN}")
        )
    tried = [candidate for candidate in fit.candidates if math.isfinite(candidate.bic)]
    compared = plain_table("", "values", "criterion minus\nthat of the chosen", "residual")
    for item in tried:
        above = "chosen" if item is tried[0] else f"{item.bic - tried[0].bic:+.3g}".replace("-", "\N{MINUS SIGN}")
        compared.add_row(item.law, str(len(item.keys)), above, _moment(item.misfit))
    refused = len(fit.candidates) - len(tried)
    title = f"Laws by the Bayesian information criterion; {len(tried)} compared, {refused} rejected"
    parts: list[RenderableType] = [Text(heading, style="bold"), Text()]
    parts += [Text(f"Law per length of the crease: {fit.law}; residual {residual}", style="italic"), values, Text()]
    parts += [Text(title, style="italic"), compared]
    if crease.remarks:
        parts += [Text(), *(Text(sentence(remark)) for remark in crease.remarks)]
    return Group(*parts)


def _moment(moment: float) -> str:
    return f"{show_value(moment, 'N', 3)} m/m"
