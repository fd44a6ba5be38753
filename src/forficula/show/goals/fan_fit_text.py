"""A fan that was fitted to clicked points as text."""

from __future__ import annotations

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.goals.clicks.fan_fit import FanFit
from forficula.quantities import show_value

_MOST_ROWS = 40


def print_fan_fit(fit: FanFit) -> None:
    """Print a fitted fan."""
    Console(width=110, highlight=False).print(fan_fit_table(fit))


def fan_fit_table(fit: FanFit) -> RenderableType:
    """Return the four numbers with their intervals, and the deviations by vein."""
    heading = (
        f"{fit.name or 'fan'}: {fit.vein_count} veins, {len(fit.points)} clicked points; root mean square deviation"
        f" {show_value(fit.rms, 'm', 3)}, {100 * fit.relative_rms:.2g} % of the length of a vein"
    )
    numbers = _columns("number of the fan", "value", "95 % interval")
    for key, unit in (("proximal_length", "m"), ("distal_length", "m"), ("hub_radius", "m"), ("sector_angle", "rad")):
        number = getattr(fit, key)
        interval = f"{show_value(number.low, unit)} to {show_value(number.high, unit)}"
        numbers.add_row(key, show_value(number.value, unit), interval)
    side = f"{fit.tangent}{'' if fit.tangent_certain else ' (uncertain)'}"
    numbers.add_row("tangent", side, "")
    parts: list[RenderableType] = [Text(heading, style="bold"), Text(), numbers, Text(), _veins(fit)]
    sentences = list(_sentences(fit))
    return Group(*parts, *([Text()] if sentences else []), *map(Text, sentences))


def _veins(fit: FanFit) -> Table:
    bases = any(vein.base is not None for vein in fit.veins)
    headings = ["distance from the fan, at vein", *(["base"] if bases else []), "ring fold", "tip", "root mean square"]
    table = _columns(*headings, *(["with different veins"] if fit.different else []))
    for vein in fit.veins[:_MOST_ROWS]:
        values = [*([vein.base] if bases else []), vein.ring, vein.tip, vein.rms]
        if fit.different:
            values.append(vein.rms_different)
        cells = ("" if value is None else show_value(value, "m", 3) for value in values)
        table.add_row(str(vein.vein), *cells)
    return table


def _sentences(fit: FanFit) -> list[str]:
    sentences = [
        f"The intervals assume that the deviations are random, with a standard deviation of"
        f" {show_value(fit.standard_deviation, 'm', 3)} per coordinate ({fit.freedoms} degrees of freedom)."
    ]
    if fit.different is not None:
        other = fit.different
        sentences.append(
            f"With different lengths of all veins and different angles of all panels ({other.unknowns} unknowns instead"
            f" of 7), the deviation is {show_value(other.rms, 'm', 3)}; {other.freedoms} degrees of freedom are left."
        )
    return [*sentences, *fit.doubts]


def _columns(*headings: str) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0))
    for heading in headings:
        table.add_column(heading)
    return table
