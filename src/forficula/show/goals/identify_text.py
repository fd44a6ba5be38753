"""What an identification came to, in lines of text."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from rich.console import Console, Group
from rich.table import Table
from rich.text import Text

from forficula.goals.identify.exclusion import Together
from forficula.goals.identify.fact_text import value_text
from forficula.goals.identify.marginal import Marginal, marginals
from forficula.quantities import Unit
from forficula.show.study.factor_text import display_values, number_text, plain_name

if TYPE_CHECKING:
    from xarray import Dataset

_MOST_PAIRS = 12
_NARROW = 110


def print_identification(result: Dataset) -> None:
    """Print how far each fact can be met, which exclude one another, and what agrees."""
    Console(width=_NARROW, highlight=False).print(identification_text(result))


def identification_text(result: Dataset) -> Group:
    """How far each fact can be met, which exclude one another, and what agrees."""
    return Group(
        Text(first_sentence(result), style="bold"),
        Text("Facts", style="italic"),
        facts_table(result),
        *(Text(sentence) for sentence in together_sentences(result)),
        Text("Unknown values", style="italic"),
        unknowns_table(result),
        Text(agrees_sentence(result)),
    )


def first_sentence(result: Dataset) -> str:
    """How many samples there are of what."""
    told = result.attrs
    count = len(np.atleast_1d(told["unknowns"]))
    missing = f", {told['could_not_run']} of which cannot be built" if told["could_not_run"] else ""
    placed = f" and {told['placed']} placed where they may meet what none met" if told["placed"] else ""
    return (
        f"{told['name']}: {told['drawn']} samples of {count} unknown values of {told['design']} drawn{placed}{missing};"
        f" {told['runs']} runs"
    )


def facts_table(result: Dataset) -> Table:
    """A line for every fact: what it is to be, how many samples meet it, and how far the others are from it."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    for heading, side in (
        ("fact", "left"),
        ("to be", "left"),
        ("met by", "right"),
        ("share, %", "right"),
        ("nearest", "right"),
        ("middle", "right"),
    ):
        table.add_column(heading, justify="right" if side == "right" else "left")
    drawn = ~result["directed"].values
    for number, name in enumerate(result["fact"].values):
        fact = result.isel(fact=number)
        low, high = 100 * float(fact["met_share_low"]), 100 * float(fact["met_share_high"])
        distances = fact["distance"].values
        told = distances[drawn & np.isfinite(distances)]
        table.add_row(
            str(name),
            str(fact["fact_asked"].values),
            str(int(fact["met"].values[drawn].sum())),
            f"{low:.3g} to {high:.3g}",
            _number(fact, float(np.nanmin(distances, initial=np.inf))),
            _number(fact, float(np.median(told)) if len(told) else np.nan),
        )
    return table


def _number(fact: Dataset, value: float) -> str:
    """A value of a fact in its unit."""
    si, display = str(fact["fact_units"].values), str(fact["fact_display"].values)
    unit = Unit(display=display, si=si, example="") if si else None
    return value_text(value, unit) if np.isfinite(value) else "-"


def together_sentences(result: Dataset) -> list[str]:
    """Which facts are met together by no sample, and what that means."""
    drawn = int((~result["directed"].values & (result["status"].values == "ran")).sum())
    most, facts = result.attrs["most_met"], result.sizes["fact"]
    if most == facts:
        count = int(result["met"].all("fact").sum())
        sentences = [
            f"{count} samples meet all {facts} facts." if count > 1 else f"One sample meets all {facts} facts."
        ]
    else:
        best = [str(each) for each in np.atleast_1d(result.attrs["met_most"])]
        sentences = [f"No sample meets all {facts} facts; the most that one meets is {most}: {best[0]}."]
        if len(best) > 1:
            sentences.append(f"{len(best) - 1} other sets of {most} facts are met, too.")
    found = _pairs(result)
    for word, words in (
        (Together.EXCLUDED, "Exclude one another, as far as {drawn} samples tell"),
        (Together.PLACED, "Met together by samples that were placed, and by none that was drawn"),
        (Together.RARE, "Met together by none, and each too rare for that to tell anything"),
    ):
        these = [each for each in found if each[2] == word]
        if these:
            sentences.append(f"{words.format(drawn=drawn)}:")
            sentences += [f"  {text}" for *_, text in these[:_MOST_PAIRS]]
            if len(these) > _MOST_PAIRS:
                sentences.append(f"  and {len(these) - _MOST_PAIRS} more pairs")
    unmet = [str(each) for each in np.atleast_1d(result.attrs.get("unmet", "")) if str(each)]
    if unmet:
        sentences.append("Met by no sample all three together, though any two of them are:")
        sentences += [f"  {each}" for each in unmet[:_MOST_PAIRS]]
        if len(unmet) > _MOST_PAIRS:
            sentences.append(f"  and {len(unmet) - _MOST_PAIRS} more")
    never = [
        str(name)
        for name, met in zip(result["fact"].values, result["met"].any("sample").values, strict=True)
        if not met
    ]
    if never:
        sentences.append(f"Met by none at all: {', '.join(never)}.")
    return sentences


def _pairs(result: Dataset) -> list[tuple[int, int, str, str]]:
    """Pairs of facts: their numbers, the verdict, and a line on them."""
    names = [str(name) for name in result["fact"].values]
    both = result["met_together"].values
    drawn = max(int((~result["directed"].values & (result["status"].values == "ran")).sum()), 1)
    found = []
    for one in range(len(names)):
        for other in range(one + 1, len(names)):
            verdict = str(result["together"].values[one, other])
            high = 100 * float(result["together_share_high"].values[one, other])
            expected = both[one, one] * both[other, other] / drawn
            placed = int(result["met_together_placed"].values[one, other])
            line = f"{names[one]} | {names[other]}: "
            if verdict == Together.PLACED:
                line += f"{placed} placed samples"
            else:
                line += f"none where {expected:.2g} would be expected"
                line += f"; less than {high:.2g} % (95 %)" if verdict == Together.EXCLUDED else ""
            found.append((one, other, verdict, line))
    return found


def unknowns_table(result: Dataset) -> Table:
    """A line for every unknown: what is believed of it, and what agrees."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    for heading in ("unknown", "believed", "agrees", "told"):
        table.add_column(heading)
    for each in marginals(result):
        told = f"by chance in {100 * each.chance:.2g} %" if each.told else ""
        table.add_row(
            plain_name(result[each.name]), _range(result, each, each.believed), _range(result, each, each.agrees), told
        )
    return table


def _range(result: Dataset, marginal: Marginal, ends: tuple[object, object]) -> str:
    if isinstance(ends[0], str) or ends[0] is None:
        return " | ".join(dict.fromkeys(map(str, ends)))
    coordinate = result[marginal.name]
    shown = coordinate.copy(data=np.full(coordinate.shape, 0.0))
    shown.values[:2] = ends if len(shown) > 1 else ends[:1]
    values, unit = display_values(shown)
    return f"{number_text(float(values[0]))} to {number_text(float(values[min(1, len(values) - 1)]))} {unit}".rstrip()


def agrees_sentence(result: Dataset) -> str:
    """What is taken for what agrees."""
    agrees = result["agrees"].values
    whole = bool(result["met"].values[agrees].all()) if agrees.any() else False
    what = "meet every fact" if whole else "are nearest to all facts"
    return f"What agrees are the {int(agrees.sum())} drawn samples that {what}; ranges hold 90 % of the samples."
