"""A characterised material as text."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.material.characterisation import AREA, LENGTH, Characterisation
from forficula.material.fit.fit import FitCandidate, LawFit
from forficula.material.law.drift import Drift
from forficula.material.law.law_keys import show_range, show_value
from forficula.material.law.law_summary import known_values
from forficula.material.law.material_law import MaterialLaw
from forficula.material.tensile.modulus import ModulusClass, Quartiles
from forficula.quantities import show_quantity
from forficula.show.material.material_units import energy_unit, stress_unit

_NONE = "none"
_MOST_LAWS = 6
_DRIFT_NAMES = {"peak_stress": "peak stress", "loss": "loss", "residual_strain": "residual strain"}


def print_material(material: Characterisation) -> None:
    """Print the results of a material's tests."""
    Console(width=110, highlight=False).print(material_table(material))


def material_table(material: Characterisation) -> RenderableType:
    """Return cycles, moduli, drift and law as tables, and the remarks as sentences."""
    parts: list[RenderableType] = [Text(_heading(material), style="bold"), Text()]
    parts += [*_cycles(material), Text(), *_moduli(material), Text(), *_drifts(material)]
    if material.law is not None and material.fit is not None:
        parts += [Text(), *_law(material.law, material.fit), Text(), *_candidates(material.fit)]
    if material.remarks:
        parts += [Text(), *(Text(sentence(remark)) for remark in material.remarks)]
    return Group(*parts)


def sentence(remark: str) -> str:
    """Return a remark with a capital, unless it begins with a key, and a full stop."""
    first, _, rest = remark.partition(" ")
    start = first if "." in first or ":" in first else first[0].upper() + first[1:]
    return f"{start} {rest.rstrip('.')}."


def plain_table(*headings: str) -> Table:
    """Return a table without lines whose first column is text."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    for number, heading in enumerate(headings):
        table.add_column(heading, justify="right" if number else "left")
    return table


def _heading(material: Characterisation) -> str:
    tests = [specimen.test for specimen in material.specimens]
    lengths = _spread([show_quantity(test.length, LENGTH) for test in tests])
    areas = _spread([show_quantity(test.area, AREA).replace("^2", "²") for test in tests])
    count = "1 specimen" if len(tests) == 1 else f"{len(tests)} specimens"
    cycles = [cycle.number for cycle in material.cycles]
    which = f"cycle {cycles[0]}" if len(cycles) == 1 else f"cycles {cycles[0]} to {cycles[-1]}"
    return f"{material.name}: {count}, length {lengths}, area {areas}, {which}"


def _spread(texts: list[str]) -> str:
    return texts[0] if len(set(texts)) == 1 else f"{texts[0]} and larger"


def _cycles(material: Characterisation) -> list[RenderableType]:
    stress, modulus = stress_unit(max(cycle.secant_modulus for cycle in material.cycles))
    energy, loss = energy_unit(max(abs(cycle.loss) for cycle in material.cycles))
    table = plain_table(
        *("cycle", "specimens", f"secant modulus\n({stress})", f"loss\n({energy})", "residual\nstrain (%)"),
        *("no force on\nunloading below (%)", "largest\nstrain (%)"),
    )
    for cycle in material.cycles:
        table.add_row(
            str(cycle.number),
            str(cycle.specimens),
            _number(cycle.secant_modulus / modulus),
            _number(cycle.loss / loss),
            _number(100 * cycle.residual_strain),
            _number(100 * cycle.slack_strain),
            _number(100 * cycle.largest_strain),
        )
    change = material.change
    if change.specimens:
        table.add_row(
            "change a cycle",
            str(change.specimens),
            _signed(change.secant_modulus / modulus),
            _signed(change.loss / loss),
            _signed(100 * change.residual_strain),
            _signed(100 * change.slack_strain),
            "",
        )
    return [Text("Cycles, medians over specimens", style="italic"), table]


def _moduli(material: Characterisation) -> list[RenderableType]:
    unit, factor = stress_unit(max(item.secant_modulus.upper for item in material.pooled))
    table = plain_table("strain (%)", "loading:\nsecant", "local", "unloading:\nsecant", "local")
    classes: dict[tuple[float, float], dict[str, ModulusClass]] = {}
    for item in material.pooled:
        classes.setdefault((item.from_strain, item.to_strain), {})[item.way] = item
    for (low, high), by_branch in sorted(classes.items()):
        cells = [
            _quartiles(getattr(by_branch[branch], kind), factor) if branch in by_branch else _NONE
            for branch in ("loading", "unloading")
            for kind in ("secant_modulus", "local_modulus")
        ]
        table.add_row(f"{100 * low:g} to {100 * high:g}", *cells)
    title = f"Moduli by class of strain ({unit}): median [quartiles] over specimens and cycles"
    return [Text(title, style="italic"), table]


def _drifts(material: Characterisation) -> list[RenderableType]:
    table = plain_table("", "first cycle to last", "95 % interval", "form")
    for key, drift in material.drifts.items():
        table.add_row(_DRIFT_NAMES[key], *(["unknown", "", ""] if drift is None else _drift(drift)))
    return [Text("Drift over the cycles", style="italic"), table]


def _drift(drift: Drift) -> list[str]:
    if drift.kind == "none":
        return ["no drift", "", ""]
    values = [100 * (item - 1) if drift.relative else 100 * item for item in drift.change(drift.seen[1])]
    middle, low, high = (_signed(value) for value in values)
    unit = "%" if drift.relative else "percentage points"
    course = "ln N" if drift.kind == "logarithm" else f"plateau after {drift.cycles:.2g} cycles"
    return [f"{middle} {unit}", f"{low} to {high}", course]


def law_table(law: MaterialLaw) -> Table:
    """Return a table of a law's values, with intervals where they are known."""
    table = plain_table("", "value", "95 % interval")
    for value in known_values(law):
        interval = _NONE if value.interval is None else _minus(show_range(value.key, *value.interval))
        table.add_row(value.key, _minus(show_value(value.key, value.value)), interval)
    return table


def _law(law: MaterialLaw, fit: LawFit) -> list[RenderableType]:
    residual = f"{_stress(fit.misfit)}, {100 * fit.relative_misfit:.2g} % of the largest stress"
    return [Text(f"Law: {fit.form.name}; residual {residual}", style="italic"), law_table(law), *_amplitudes(fit)]


def _amplitudes(fit: LawFit) -> Iterator[Text]:
    """Yield a sentence on the differences between specimens, if there are several."""
    if fit.scatter is None:
        return
    least, *_, most = sorted(fit.residuals, key=lambda item: item.amplitude)
    shown = [f"{_signed(100 * (item.amplitude - 1))} % ({item.name})" for item in (least, most)]
    yield Text(
        f"The specimens' amplitudes differ from the law's by {shown[0]} to {shown[1]}, standard deviation"
        f" {_number(100 * fit.scatter)} %; the intervals hold for the material, not only for these specimens."
    )


def _candidates(fit: LawFit) -> list[RenderableType]:
    tried = [candidate for candidate in fit.candidates if math.isfinite(candidate.bic)]
    table = plain_table("", "values", "criterion minus\nthat of the chosen", "residual")
    for item in _best_of_each_kind(tried)[:_MOST_LAWS]:
        above = "chosen" if item is tried[0] else _minus(f"{item.bic - tried[0].bic:+.3g}")
        table.add_row(item.form.name, str(len(item.form.keys)), above, _stress(item.misfit))
    refused = len(fit.candidates) - len(tried)
    title = f"Best laws of each kind by the Bayesian information criterion; {len(tried)} compared, {refused} rejected"
    return [Text(title, style="italic"), table]


def _best_of_each_kind(tried: list[FitCandidate]) -> list[FitCandidate]:
    """Return the best candidate for each model of dissipation and softening."""
    best: dict[tuple[object, ...], FitCandidate] = {}
    for item in tried:
        best.setdefault((item.form.damper, item.form.branches, item.form.softening), item)
    return list(best.values())


def _stress(value: float) -> str:
    unit, factor = stress_unit(value)
    return f"{value / factor:.3g} {unit}"


def _quartiles(entry: Quartiles, factor: float) -> str:
    middle, low, high = (_number(value / factor, 2) for value in (entry.median, entry.lower, entry.upper))
    return f"{middle} [{low}; {high}]"


def _number(value: float, decimals: int = 3) -> str:
    """Return a number with three digits and a limited number of decimals, so that noise about 0 reads as 0."""
    if not math.isfinite(value):
        return _NONE
    digits = 2 - math.floor(math.log10(abs(value))) if value else 0
    text = f"{value:.{min(max(digits, 0), decimals)}f}"
    return _minus(text) if float(text) else "0"


def _minus(text: str) -> str:
    return text.replace("-", "−")


def _signed(value: float) -> str:
    text = _number(value)
    return text if text in (_NONE, "0") or text.startswith("−") else f"+{text}"
