"""Results of an identification as lines of text."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from rich.console import Console, Group
from rich.table import Table
from rich.text import Text

from forficula.goals.identify.exclusion import Together
from forficula.goals.identify.fact_text import value_text
from forficula.goals.identify.marginal import Marginal, marginals
from forficula.names import counted
from forficula.quantities import Unit
from forficula.show.study.factor_text import display_values, number_text, plain_name

if TYPE_CHECKING:
    from xarray import Dataset

_MOST_PAIRS = 12
_NARROW = 110
# sentences about pairs of one verdict, in this order
_PAIRS = {
    Together.EXCLUDED: "Pairs that exclude one another, as far as samples show: some meet each fact, none meets both",
    Together.UNTRIED: "Pairs that no sample meets, though some meet each fact; no sample was placed to meet both",
    Together.OPEN: "Pairs that no sample meets, but samples are too sparse to exclude values between them",
    Together.NEARLY: "Pairs that no sample meets, but one sample nearly does",
    Together.PLACED: "Pairs that placed samples meet, but no drawn one",
    Together.RARE: "Pairs that no sample meets, but too few samples meet the rarer fact to conclude anything",
}


def print_identification(result: Dataset) -> None:
    """Print the agreement with each fact, the facts that exclude one another, and the values that agree."""
    Console(width=_NARROW, highlight=False, markup=False).print(identification_text(result))


def identification_text(result: Dataset) -> Group:
    """Return the agreement with each fact, the facts that exclude one another, and the values that agree."""
    return Group(
        Text(first_sentence(result), style="bold"),
        Text("Facts", style="italic"),
        facts_table(result),
        *(Text(sentence) for sentence in together_sentences(result)),
        Text("Unknown values", style="italic"),
        unknowns_table(result),
        *(Text(sentence) for sentence in agrees_sentences(result)),
    )


def first_sentence(result: Dataset) -> str:
    """Return the numbers of samples, unknowns and runs in one sentence."""
    attributes = result.attrs
    count = len(np.atleast_1d(attributes["unknowns"]))
    missing = f", {attributes['could_not_run']} of them cannot be built" if attributes["could_not_run"] else ""
    placed = f" and {attributes['placed']} placed to meet facts that none met" if attributes["placed"] else ""
    return (
        f"{attributes['name']}: {counted(attributes['drawn'], 'sample')} of {counted(count, 'unknown value')} of"
        f" {attributes['design']} drawn{placed}{missing};"
        f" {counted(attributes['runs'], 'run')}"
    )


def facts_table(result: Dataset) -> Table:
    """Return a line for every fact: its value, the number of samples that meet it, and the distances of the others."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    for heading, side in (
        ("fact", "left"),
        ("observed", "left"),
        ("met by", "right"),
        ("share, %", "right"),
        ("nearest", "right"),
        ("median", "right"),
    ):
        table.add_column(heading, justify="right" if side == "right" else "left")
    drawn = ~result["directed"].values
    for number, name in enumerate(result["fact"].values):
        fact = result.isel(fact=number)
        low, high = 100 * float(fact["met_share_low"]), 100 * float(fact["met_share_high"])
        distances = fact["distance"].values
        known = distances[drawn & np.isfinite(distances)]
        table.add_row(
            str(name),
            str(fact["fact_asked"].values),
            str(int(fact["met"].values[drawn].sum())),
            f"{low:.3g} to {high:.3g}",
            _number(fact, float(np.nanmin(distances, initial=np.inf))),
            _number(fact, float(np.median(known)) if len(known) else np.nan),
        )
    return table


def _number(fact: Dataset, value: float) -> str:
    """Return a value of a fact in its unit."""
    si, display = str(fact["fact_units"].values), str(fact["fact_display"].values)
    unit = Unit(display=display, si=si, example="") if si else None
    return value_text(value, unit) if np.isfinite(value) else "-"


def together_sentences(result: Dataset) -> list[str]:
    """Return sentences on the facts that no sample meets together."""
    sentences = [*_not_built(result), *_most_met(result), *_untold(result)]
    pairs = _pairs(result)
    for word, words in _PAIRS.items():
        these = [line for verdict, line in pairs if verdict == word]
        if these:
            sentences += [f"{words}:", *_first(these, "pairs")]
    unmet = _triples(result)
    if unmet:
        sentences += ["No sample meets all three of these facts, though some meet any two of them:", *_first(unmet, "")]
    never = [
        str(name)
        for name, met in zip(result["fact"].values, result["met"].any("sample").values, strict=True)
        if not met
    ]
    return [*sentences, f"Facts that no sample meets: {', '.join(never)}."] if never else sentences


def _not_built(result: Dataset) -> list[str]:
    """Return a sentence on the samples that cannot be built, with the most frequent reason."""
    why = Counter(str(status) for status in result["status"].values if status != "ran")
    if not why:
        return []
    ((reason, _),) = why.most_common(1)
    return [f"{counted(why.total(), 'sample')} cannot be built, mostly: {reason}"]


def _most_met(result: Dataset) -> list[str]:
    """Return sentences on the largest number of facts that one sample meets."""
    most, facts = result.attrs["most_met"], result.sizes["fact"]
    if most == facts:
        count, what = int(result["met"].all("fact").sum()), f"all {facts} facts" if facts > 1 else "the fact"
        return [f"{count} samples meet {what}." if count > 1 else f"One sample meets {what}."]
    best = [str(item) for item in np.atleast_1d(result.attrs["met_most"])]
    if not most:
        return [*_between(result), *(["No sample meets any fact."] if facts > 1 else [])]
    sentences = [*_between(result), f"The largest number of facts that one sample meets is {most}: {best[0]}."]
    if len(best) > 1:
        others = "1 other set" if len(best) == 2 else f"{len(best) - 1} other sets"
        sentences.append(f"{others} of {counted(most, 'fact')} {'is' if len(best) == 2 else 'are'} also met.")
    return sentences


def _between(result: Dataset) -> list[str]:
    """Return a sentence on whether values between the samples may meet all facts."""
    attributes, facts = result.attrs, result.sizes["fact"]
    first = f"No sample meets {f'all {facts} facts' if facts > 1 else 'the fact'}"
    if not attributes["emulated"]:
        return [f"{first}, but there are too few samples to exclude other values."]
    if attributes["between_possible"]:
        share, drawn = float(attributes["between_share"]), int(attributes["drawn"])
        return [
            f"{first}, but there are too few samples to exclude other values. According to a model fitted between them,"
            f" {_percent(share)} of the prior meets {'them' if facts > 1 else 'it'}, {share * drawn:.2g} of"
            f" {counted(drawn, 'drawn sample')}."
        ]
    return [
        f"{first}, and according to a model fitted between the samples no values do: they miss at least one by"
        f" {_apart(result)} or more of its standard errors."
    ]


def _untold(result: Dataset) -> list[str]:
    """Return a sentence on the facts that unreliable runs leave undecided."""
    drawn = int((~result["directed"].values & (result["status"].values == "ran")).sum())
    undecided = [
        f"{name}, {drawn - int(count)}"
        for name, count in zip(result["fact"].values, result["told"].values, strict=True)
        if count < drawn
    ]
    if not undecided:
        return []
    return [
        f"For some of {counted(drawn, 'drawn sample')}, unreliable runs do not decide whether a fact is met:"
        f" {'; '.join(undecided)}. These samples are not counted, and the intervals hold for any outcome of these runs."
    ]


def _first(lines: Sequence[str], what: str) -> list[str]:
    """Return the first lines of a list, and the number of other lines."""
    more = [f"  and {len(lines) - _MOST_PAIRS} more {what}".rstrip()] if len(lines) > _MOST_PAIRS else []
    return [*(f"  {line}" for line in lines[:_MOST_PAIRS]), *more]


def _pairs(result: Dataset) -> list[tuple[str, str]]:
    """Return pairs of facts, the furthest apart first: the verdict, and a line of text."""
    names = [str(name) for name in result["fact"].values]
    pairs = [result.isel(fact=one, other_fact=other) for one, other in itertools.combinations(range(len(names)), 2)]
    pairs.sort(key=lambda pair: -float(pair["together_near"]))
    return [(str(pair["together"].values), _pair_line(result, pair)) for pair in pairs]


def _pair_line(result: Dataset, pair: Dataset) -> str:
    """Return what samples show about a pair: counts, the count expected by chance, a bound, and the nearest sample."""
    first, second = str(pair["fact"].values), str(pair["other_fact"].values)
    inverse = result.sel(fact=second, other_fact=first)
    line = (
        f"{first} | {second}: {int(pair['met_together'])} of {int(pair['told_together'])} samples meet both, those"
        f" that meet one: {int(pair['met_alone'])} and {int(inverse['met_alone'])}"
        f" ({float(pair['together_if_independent']):.2g} would meet both if independent);"
        f" at most {_percent(float(pair['together_share_high']))} of the prior (95 %)"
    )
    if placed := int(pair["met_together_placed"]):
        return f"{line}; {placed} placed ones meet both"
    if tried := int(pair["tried_together"]):
        line += f"; none of {tried} placed ones meets both"
    return f"{line}; the nearest misses one by {_near(float(pair['together_near']))}"


def _triples(result: Dataset) -> list[str]:
    """Return a line for every three facts that no sample meets together."""
    names = ("", "_verdict", "_told", "_tried", "_near", "_share_high")
    columns = [np.atleast_1d(result.attrs[f"unmet{of}"]) for of in names]
    lines = []
    for facts, verdict, decided, tried, near, high in zip(*columns, strict=True):
        if str(facts):
            placed = f", none of {tried} placed ones" if tried else ""
            lines.append(
                f"{facts}: {verdict}; none of {decided} samples{placed}; at most {_percent(float(high))} of the"
                f" prior (95 %); the nearest misses one by {_near(float(near))}"
            )
    return lines


def _near(excess: float) -> str:
    """Return the distance to a fact in units of its scale."""
    return f"{excess:.2g} of its scale"


def _percent(share: float) -> str:
    return f"{100 * share:.2g} %"


def unknowns_table(result: Dataset) -> Table:
    """Return a line for every unknown: its prior, and the values that agree."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    for heading in ("unknown", "prior", "agrees", "narrowed"):
        table.add_column(heading)
    for marginal in marginals(result):
        narrowed = f"yes (by chance in {100 * marginal.chance:.2g} %)" if marginal.significant else ""
        table.add_row(
            plain_name(result[marginal.name]),
            _range(result, marginal, marginal.believed),
            _range(result, marginal, marginal.agrees),
            narrowed,
        )
    return table


def _range(result: Dataset, marginal: Marginal, ends: tuple[object, ...]) -> str:
    if not ends or isinstance(ends[0], str) or ends[0] is None:
        return " | ".join(dict.fromkeys(map(str, ends)))
    coordinate = result[marginal.name]
    shown = coordinate.copy(data=np.full(coordinate.shape, 0.0))
    shown.values[:2] = ends if len(shown) > 1 else ends[:1]
    values, unit = display_values(shown)
    return f"{number_text(float(values[0]))} to {number_text(float(values[min(1, len(values) - 1)]))} {unit}".rstrip()


def agrees_sentences(result: Dataset) -> list[str]:
    """Return sentences on the ranges that agree, their assumptions, and whether there were enough samples."""
    attributes, agrees = result.attrs, result["agrees"].values
    if not agrees.any():
        return ["No sample agrees, because none can be built."]
    if not attributes["emulated"]:
        ran = int((result["status"].values == "ran").sum())
        unknown = counted(len(np.atleast_1d(attributes["unknowns"])), "unknown value")
        return [
            f"There are too few samples to compute which values agree: {ran} ran; a model of {unknown} needs at least"
            f" {attributes['emulator_samples']} whose runs are all reliable. The ranges are those of the prior."
        ]
    if not attributes["between_possible"]:
        return [
            "No values meet all facts, on samples or between them. The ranges are those of the values nearest to the"
            f" facts, which miss them by at least {_apart(result)} standard errors. They are not an estimate."
        ]
    return [
        "Ranges contain 95 % of the values that meet every fact, on samples and between them. They come from a kriging"
        " model of each fact, fitted to the samples, with its errors. They assume that the prior is right,"
        " that each observation lies within its tolerance of the truth, and that the model of the structure"
        " is right.",
        *_coarse(result),
    ]


def _apart(result: Dataset) -> str:
    """Return the smallest distance of the model to the worst fact, in standard errors, with two digits."""
    return number_text(float(f"{float(result.attrs['between_apart']):.2g}"))


def _coarse(result: Dataset) -> list[str]:
    """Return a sentence on facts whose ranges depend on the distance between samples, not on the fact's tolerance."""
    coarse = [
        f"{name} ({float(error):.2g} times)"
        for name, error in zip(result["fact"].values, result["between_error"].values, strict=True)
        if error > 1
    ]
    if not coarse:
        return []
    return [
        "More samples would narrow the ranges: between the samples, the model's standard error exceeds the"
        f" tolerance of {', '.join(coarse)}."
    ]
