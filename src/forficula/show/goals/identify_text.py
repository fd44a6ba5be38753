"""What an identification came to, in lines of text."""

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
# what is said of pairs of one verdict, in this order
_PAIRS = {
    Together.EXCLUDED: "Exclude one another, as far as samples tell, for each is met by some, and none meets both",
    Together.UNTRIED: "Met together by none, though each is by some; no sample was placed to meet both",
    Together.OPEN: "Met together by none, but samples lie too far apart to say that no values between them do",
    Together.NEARLY: "Met together by none, but nearly so by one",
    Together.PLACED: "Met together by samples that were placed, and by none that was drawn",
    Together.RARE: "Met together by none, and the rarer one by too few for that to tell anything",
}


def print_identification(result: Dataset) -> None:
    """Print how far each fact can be met, which exclude one another, and what agrees."""
    Console(width=_NARROW, highlight=False, markup=False).print(identification_text(result))


def identification_text(result: Dataset) -> Group:
    """How far each fact can be met, which exclude one another, and what agrees."""
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
    """How many samples there are of what."""
    told = result.attrs
    count = len(np.atleast_1d(told["unknowns"]))
    missing = f", {told['could_not_run']} of which cannot be built" if told["could_not_run"] else ""
    placed = f" and {told['placed']} placed where they may meet what none met" if told["placed"] else ""
    return (
        f"{told['name']}: {counted(told['drawn'], 'sample')} of {counted(count, 'unknown value')} of"
        f" {told['design']} drawn{placed}{missing};"
        f" {counted(told['runs'], 'run')}"
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
    sentences = [*_not_built(result), *_most_met(result), *_untold(result)]
    found = _pairs(result)
    for word, words in _PAIRS.items():
        these = [line for verdict, line in found if verdict == word]
        if these:
            sentences += [f"{words}:", *_first(these, "pairs")]
    unmet = _triples(result)
    if unmet:
        sentences += ["Met by no sample all three together, though any two of them are:", *_first(unmet, "")]
    never = [
        str(name)
        for name, met in zip(result["fact"].values, result["met"].any("sample").values, strict=True)
        if not met
    ]
    return [*sentences, f"Met by none at all: {', '.join(never)}."] if never else sentences


def _not_built(result: Dataset) -> list[str]:
    """How many samples there is no design of, and the most frequent reason."""
    why = Counter(str(status) for status in result["status"].values if status != "ran")
    if not why:
        return []
    ((reason, _),) = why.most_common(1)
    return [f"{counted(why.total(), 'sample')} cannot be built, mostly: {reason}"]


def _most_met(result: Dataset) -> list[str]:
    """How many facts one sample meets at most, and which."""
    most, facts = result.attrs["most_met"], result.sizes["fact"]
    if most == facts:
        count, what = int(result["met"].all("fact").sum()), f"all {facts} facts" if facts > 1 else "the fact"
        return [f"{count} samples meet {what}." if count > 1 else f"One sample meets {what}."]
    best = [str(each) for each in np.atleast_1d(result.attrs["met_most"])]
    if not most:
        return [*_between(result), *(["No sample meets any fact."] if facts > 1 else [])]
    sentences = [*_between(result), f"The most that one sample meets is {most}: {best[0]}."]
    if len(best) > 1:
        others = "1 other set" if len(best) == 2 else f"{len(best) - 1} other sets"
        sentences.append(f"{others} of {counted(most, 'fact')} {'is' if len(best) == 2 else 'are'} met, too.")
    return sentences


def _between(result: Dataset) -> list[str]:
    """Whether values between the samples may meet what no sample does."""
    told, facts = result.attrs, result.sizes["fact"]
    first = f"No sample meets {f'all {facts} facts' if facts > 1 else 'the fact'}"
    if not told["emulated"]:
        return [f"{first}, but samples are too few to say whether other values do."]
    if told["between_possible"]:
        share, drawn = float(told["between_share"]), int(told["drawn"])
        return [
            f"{first}, but samples are too few to say that no values do: by a model fitted between them,"
            f" {_percent(share)} of what is believed meets {'them' if facts > 1 else 'it'}, {share * drawn:.2g} of"
            f" {counted(drawn, 'drawn sample')}."
        ]
    return [
        f"{first}, and by a model fitted between the samples no values do: they miss at least one by"
        f" {_apart(result)} of its standard errors or more."
    ]


def _untold(result: Dataset) -> list[str]:
    """Of which facts runs leave open whether drawn samples meet them."""
    drawn = int((~result["directed"].values & (result["status"].values == "ran")).sum())
    told = [
        f"{name}, {drawn - int(count)}"
        for name, count in zip(result["fact"].values, result["told"].values, strict=True)
        if count < drawn
    ]
    if not told:
        return []
    return [
        f"Of {counted(drawn, 'drawn sample')}, runs that are not to be trusted leave open whether they meet:"
        f" {'; '.join(told)}. These are not counted, and the intervals hold whatever they would have come to."
    ]


def _first(lines: Sequence[str], what: str) -> list[str]:
    """The first lines of many, and how many more there are."""
    more = [f"  and {len(lines) - _MOST_PAIRS} more {what}".rstrip()] if len(lines) > _MOST_PAIRS else []
    return [*(f"  {line}" for line in lines[:_MOST_PAIRS]), *more]


def _pairs(result: Dataset) -> list[tuple[str, str]]:
    """Pairs of facts, those first that no sample comes near to: the verdict, and a line on them."""
    names = [str(name) for name in result["fact"].values]
    pairs = [result.isel(fact=one, other_fact=other) for one, other in itertools.combinations(range(len(names)), 2)]
    pairs.sort(key=lambda pair: -float(pair["together_near"]))
    return [(str(pair["together"].values), _pair_line(result, pair)) for pair in pairs]


def _pair_line(result: Dataset, pair: Dataset) -> str:
    """What samples say of a pair: counts, what would be if it were by chance, a bound, and how near one comes."""
    first, second = str(pair["fact"].values), str(pair["other_fact"].values)
    turned = result.sel(fact=second, other_fact=first)
    line = (
        f"{first} | {second}: by {int(pair['met_together'])} of {int(pair['told_together'])} that tell, by either alone"
        f" {int(pair['met_alone'])} and {int(turned['met_alone'])}"
        f" ({float(pair['together_if_independent']):.2g} if independent);"
        f" at most {_percent(float(pair['together_share_high']))} of what is believed (95 %)"
    )
    if placed := int(pair["met_together_placed"]):
        return f"{line}; by {placed} placed"
    if tried := int(pair["tried_together"]):
        line += f"; by none of {tried} placed to"
    return f"{line}; the nearest misses one by {_near(float(pair['together_near']))}"


def _triples(result: Dataset) -> list[str]:
    """A line for every three facts that no sample meets together."""
    names = ("", "_verdict", "_told", "_tried", "_near", "_share_high")
    columns = [np.atleast_1d(result.attrs[f"unmet{of}"]) for of in names]
    lines = []
    for facts, verdict, told, tried, near, high in zip(*columns, strict=True):
        if str(facts):
            by = f", none of {tried} placed to" if tried else ""
            lines.append(
                f"{facts}: {verdict}; by none of {told} that tell{by}; at most {_percent(float(high))} of what is"
                f" believed (95 %); the nearest misses one by {_near(float(near))}"
            )
    return lines


def _near(excess: float) -> str:
    """By how much of its scale a fact is missed."""
    return f"{excess:.2g} of its scale"


def _percent(share: float) -> str:
    return f"{100 * share:.2g} %"


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


def _range(result: Dataset, marginal: Marginal, ends: tuple[object, ...]) -> str:
    if not ends or isinstance(ends[0], str) or ends[0] is None:
        return " | ".join(dict.fromkeys(map(str, ends)))
    coordinate = result[marginal.name]
    shown = coordinate.copy(data=np.full(coordinate.shape, 0.0))
    shown.values[:2] = ends if len(shown) > 1 else ends[:1]
    values, unit = display_values(shown)
    return f"{number_text(float(values[0]))} to {number_text(float(values[min(1, len(values) - 1)]))} {unit}".rstrip()


def agrees_sentences(result: Dataset) -> list[str]:
    """What is taken for what agrees, what that assumes, and whether the samples were enough."""
    told, agrees = result.attrs, result["agrees"].values
    if not agrees.any():
        return ["None agrees, for none can be built."]
    if not told["emulated"]:
        ran = int((result["status"].values == "ran").sum())
        unknown = counted(len(np.atleast_1d(told["unknowns"])), "unknown value")
        return [
            f"Too few samples to say what agrees: {ran} ran; a model between the samples of {unknown} needs at least"
            f" {told['emulator_samples']} whose runs are all reliable. The ranges are what is believed."
        ]
    if not told["between_possible"]:
        return [
            "No values meet all facts, on samples or between them: the ranges are of the values whose facts are"
            f" least far off, at best {_apart(result)} standard errors. They are no estimate."
        ]
    return [
        "Ranges hold 95 % of the values that meet every fact, on samples and between them. They come from a kriging"
        " model of each fact, fitted to the samples, with its errors. They assume that values are as likely as"
        " believed, that each observation lies within its tolerance of the truth, and that the model of the structure"
        " is right.",
        *_coarse(result),
    ]


def _apart(result: Dataset) -> str:
    """By how many standard errors of the model between the samples the worst fact is missed at best, two digits."""
    return number_text(float(f"{float(result.attrs['between_apart']):.2g}"))


def _coarse(result: Dataset) -> list[str]:
    """The facts whose ranges are as wide as the samples' distance makes them, and not as the fact's tolerance does."""
    coarse = [
        f"{name} ({float(error):.2g} times)"
        for name, error in zip(result["fact"].values, result["between_error"].values, strict=True)
        if error > 1
    ]
    if not coarse:
        return []
    return [
        "More samples would narrow the ranges: between the samples the model's standard error is larger than the"
        f" tolerance of {', '.join(coarse)}."
    ]
