"""Maps of a study: torques, works, energies, times and verdicts over any two of its factors."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from forficula.analysis import SPRUNG
from forficula.errors import InputError
from forficula.quantities import show_value
from forficula.show.study.factor_text import plain_name, value_text, value_with_unit
from forficula.show.study.map_page import draw_page
from forficula.show.study.map_panel import MapPanel, MapView
from forficula.show.study.outcome_looks import OTHER, map_style
from forficula.show.style import PAGE_WIDTH, Drawing
from forficula.study.assumptions.choices import CHOICE
from forficula.study.tables.outcome_kinds import (
    OutcomeKind,
    asked_transitions,
    not_tried_word,
    outcome_kinds,
    table_transitions,
)

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

_MOST_PANELS = 9


def map_drawings(table: Dataset) -> dict[str, Drawing]:
    """Find every map that a study's table has the numbers for.

    Args:
        table: of the search for the least torques or of plain runs, over a grid of factors, with or without choices,
            or over samples.

    Returns:
        What draws them, by the stem of their file.
    """
    transitions = table_transitions(table)
    drawings: dict[str, Drawing] = {"status": lambda width: draw_status_map(table, width=width)}
    if any(each.least and each.least in table for each in transitions):
        drawings["torques"] = lambda width: draw_torque_maps(table, width=width)
        if not _is_sampled(table) and len(_axes(table)) > 2:
            drawings["torques_moving"] = lambda width: draw_moving_maps(table, width=width)
    if _known(table, *(f"{each.name}_work" for each in transitions)):
        drawings["works"] = lambda width: draw_work_maps(table, width=width)
    if _known(table, *(f"{state}_energy" for state in _states(table))):
        drawings["energy"] = lambda width: draw_energy_maps(table, width=width)
    if times_by_value(table) is not None and not _is_sampled(table):
        drawings["fold_times"] = lambda width: draw_first_times(table, width=width)
    return drawings


def draw_torque_maps(
    table: Dataset, x: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH
) -> Figure:
    """Draw the least values that bring a structure to its states, and why there is none where there is none.

    Args:
        table: of a search for the least values.
        x: factor across, such as "tendon.rest_length"; by default the second.
        y: factor upwards; by default the first.
        width: of the figure at most, inch.

    Raises:
        InputError: the table has no such factor.
    """
    first, *_ = each_least = [each for each in table_transitions(table) if each.least]
    names = {each.least: each.least.replace("_", " ") for each in each_least}
    if "torque" in (reference := table["reference_outcome"].attrs if "reference_outcome" in table else {}):
        after = f", {first.state} with {show_value(reference['torque'], 'N m')}"
        names |= {each.least: f"{names[each.least]}{after}" for each in each_least[1:]}
    quantity = "torque" if all(_unit(table, name) == "N m" for name in names if name in table) else "least value"
    return _draw(table, x, y, names, quantity, width=width)


def draw_moving_maps(table: Dataset, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw how the map of the first least values moves with a third factor: a panel for each of its values.

    Args:
        table: of a search for the least values over a grid of three factors or more. Of many values some are drawn.
        width: of the figure, inch.
    """
    first = next(each for each in table_transitions(table) if each.least and each.least in table)
    upwards, across, moving, *_ = _axes(table)
    with map_style():
        view = _slice(table, [upwards, across, moving], x=across, y=upwards)
        values, reasons = view.table[first.least], missing_reasons(view.table, first.least)
        chosen, few = _few_values(table, moving)
        panels = []
        for index in chosen:
            here = values.isel({moving: index})
            title = f"{value_with_unit(table[moving], index)}: {int(here.count())} of {here.size} {first.wording.verb}"
            why = reasons.isel({moving: index})
            panels.append(MapPanel(title=title, values=here, reasons=why, unit=_unit(table, first.least)))
        quantity, note = first.least.replace("_", " "), few or f"by {plain_name(table[moving])}"
        return draw_page(view, panels, one_scale=True, quantity=quantity, note=note, width=width)


def draw_work_maps(table: Dataset, x: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw the work that transitions take, at the least values where these were searched for.

    Args and errors are those of `draw_torque_maps`.
    """
    names = {f"{each.name}_work": f"work of {each.wording.noun}" for each in table_transitions(table)}
    return _draw(table, x, y, names, "work", width=width)


def draw_energy_maps(
    table: Dataset, x: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH
) -> Figure:
    """Draw the tendons' energy in the states on one scale (Binder et al. 2025, Figure 8).

    Args and errors are those of `draw_torque_maps`.
    """
    noun, states = energy_noun(table), _states(table)
    # where springs store some, too, no one is to take it for the whole
    others = any(f"{state}_{of}_energy" in table for state in states for of in ("hinge", "spring"))
    names = {f"{state}_energy": f"{noun if others else 'energy'} when {state}" for state in states}
    return _draw(table, x, y, names, noun, one_scale=True, width=width)


def energy_noun(table: Dataset) -> str:
    """What the energies of states in a table are: the tendons', or all that is stored where there are none."""
    named = [table.get(f"{state}_energy") for state in _states(table)]
    told = [str(each.attrs.get("long_name", "")) for each in named if each is not None]
    return "stored energy" if any(each.startswith("stored") for each in told) else "tendons' energy"


def draw_status_map(table: Dataset, x: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw what became of every structure.

    Args and errors are those of `draw_torque_maps`.
    """
    with map_style():
        view = table_view(table, x, y)
        outcomes = view.table["outcome"]
        nothing = outcomes.copy(data=np.full(outcomes.shape, np.nan))
        return draw_page(view, [MapPanel(title="outcome", values=nothing, reasons=outcomes, unit="")], width=width)


def draw_first_times(
    table: Dataset, panels: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH
) -> Figure:
    """Draw the time that the first transition takes over the value that drives it and a factor, for values of another.

    As in Binder et al. 2025, Figure 7.

    Args:
        table: of a search for the least values over a grid.
        panels: factor with one panel a value; by default the first of several. Of many values, some are drawn.
        y: factor upwards; by default the second, or the only one.
        width: of the figure, inch.

    Raises:
        InputError: the table has no such factor, or has samples.
    """
    if _is_sampled(table):
        raise InputError("times over the value need a grid of factors, got samples")
    found = times_by_value(table)
    if found is None:
        raise InputError("times over the value need a search for the least values")
    factors = _factors(table)
    panels, y = (_name(factors, name) if name else None for name in (panels, y))
    free = [name for name in factors if name not in (panels, y)]
    if len(factors) > 1:
        panels = panels or free.pop(0)
    y = y or (free or factors).pop(0)
    if panels == y:
        raise InputError(f"panels and y: need two factors, got {y} twice")
    with map_style():
        view = _slice(table, [name for name in (panels, y) if name], x=found.value, y=y)
        times, reasons = view.table[found.times], view.table[found.outcomes]
        if panels is None:
            only = MapPanel(title=found.label, values=times, reasons=reasons, unit="s")
            return draw_page(view, [only], quantity=found.label, width=width)
        chosen, few = _few_values(table, panels)
        drawn = [
            MapPanel(
                title=value_text(table[panels], index),
                values=times.isel({panels: index}),
                reasons=reasons.isel({panels: index}),
                unit="s",
            )
            for index in chosen
        ]
        return draw_page(view, drawn, one_scale=True, quantity=found.label, note=few, width=width)


def _few_values(table: Dataset, factor: str) -> tuple[list[int], str]:
    """Which of a factor's values have a panel, from end to end, and a note where that is not all."""
    count = table.sizes[factor]
    chosen = np.unique(np.linspace(0, count - 1, min(count, _MOST_PANELS)).round().astype(int)).tolist()
    note = f"{len(chosen)} of {count} values of {plain_name(table[factor])}" if len(chosen) < count else ""
    return chosen, note


def _draw(
    table: Dataset,
    x: str | None,
    y: str | None,
    names: dict[str, str],
    quantity: str,
    *,
    width: float,
    one_scale: bool = False,
) -> Figure:
    """A page with a panel a variable."""
    with map_style():
        view = table_view(table, x, y)
        panels = [
            MapPanel(
                title=title, values=view.table[name], reasons=missing_reasons(view.table, name), unit=_unit(table, name)
            )
            for name, title in names.items()
            if name in table  # a search may leave the second transition out
        ]
        return draw_page(view, panels, one_scale=one_scale, quantity=quantity, width=width)


# ---- the table: its factors, what is drawn of it, and why a value is missing


def _is_sampled(table: Dataset) -> bool:
    return table["outcome"].dims == ("sample",)


def _factors(table: Dataset) -> list[str]:
    """Names of the factors, in the study's order; choices of one at a time, which stand for the rest of them, last."""
    if not _is_sampled(table):
        # maps are of the grid that is repeated at every choice
        return sorted((str(name) for name in table["outcome"].dims), key=lambda name: name == CHOICE)
    return [str(name) for name, values in table.coords.items() if values.dims == ("sample",) and name != "sample"]


def _axes(table: Dataset) -> list[str]:
    """Names of the factors of a grid that have several values, in the study's order; those of choices have none."""
    return [name for name in _factors(table) if name != CHOICE and table.sizes[name] > 1]


def _name(factors: Sequence[str], wanted: str) -> str:
    """A factor's name in the table, from that or from its key."""
    name = wanted.replace(".", "_")
    if name not in factors:
        raise InputError(f"{wanted}: need a factor of the study, one of {', '.join(factors)}")
    return name


def table_view(table: Dataset, x: str | None = None, y: str | None = None) -> MapView:
    """What to draw over two factors, or over the only one.

    Raises:
        InputError: the table has no such factor.
    """
    factors = _factors(table)
    if len(factors) == 1:
        return _slice(table, factors, x=_name(factors, x or factors[0]), y=None)
    across, upwards = (_name(factors, name) if name else None for name in (x, y))
    # a factor with one value is no axis as long as another one varies
    free = sorted((name for name in factors if name not in (across, upwards)), key=lambda name: table[name].size == 1)
    upwards = upwards or free.pop(0)
    across = across or free.pop(0)
    if across == upwards:
        raise InputError(f"x and y: need two factors, got {across} twice")
    return _slice(table, [upwards, across], x=across, y=upwards)


def _slice(table: Dataset, kept: Sequence[str], *, x: str, y: str | None) -> MapView:
    """The middle of every factor that is not kept, of choices the base, and a note that says so."""
    if _is_sampled(table):
        return MapView(table=table, x=x, y=y, note="", sampled=True)
    middle = {name: 0 if name == CHOICE else table.sizes[name] // 2 for name in _factors(table) if name not in kept}
    note = ", ".join(value_text(table[name], index) for name, index in middle.items() if table.sizes[name] > 1)
    return MapView(table=table.isel(middle), x=x, y=y, note=f"at {note}" if note else "", sampled=False)


def _known(table: Dataset, *names: str) -> bool:
    return any(name in table and bool(np.isfinite(table[name]).any()) for name in names)


def _unit(table: Dataset, name: str) -> str:
    return str(table[name].attrs.get("units", ""))


@dataclass(frozen=True, kw_only=True)
class TimesByValue:
    """Names in a table of what became of the first transition asked for with every value that was tried.

    Attributes:
        value: the dimension of the values, such as "fold_torque".
        times: the times.
        outcomes: what became of it.
        label: what the time is called.
    """

    value: str
    times: str
    outcomes: str
    label: str


def times_by_value(table: Dataset) -> TimesByValue | None:
    """Find what a search tried for the first transition; None where the table is of none."""
    for first in asked_transitions(table)[:1]:
        for by in ("torque", "value"):
            times = f"{first.name}_time_by_{by}"
            if times in table:
                return TimesByValue(
                    value=str(table[times].dims[-1]),
                    times=times,
                    outcomes=f"{first.name}_outcome_by_{by}",
                    label=first.wording.time,
                )
    return None


def _states(table: Dataset) -> list[str]:
    """Names of the states, the first one before any transition."""
    start = str(table.attrs.get("start_state", ""))
    return [*([start] if start else []), *(each.state for each in table_transitions(table))]


def missing_reasons(table: Dataset, name: str) -> DataArray:
    """Why a variable has no value, wherever it has none."""
    outcome, transitions, kinds = table["outcome"], table_transitions(table), outcome_kinds(table)
    for kind in SPRUNG:  # all are of the state
        name = name.replace(f"_{kind}_energy", "_energy")
    if not transitions or name in (f"{_states(table)[0]}_energy", "residual"):
        return outcome
    first = transitions[0]
    first_outcome = table.get(f"{first.name}_outcome", outcome)
    if name in (first.least, f"{first.name}_time", f"{first.name}_work", f"{first.state}_energy"):

        def why_not_first(word: str) -> str:
            return OTHER if word in kinds and kinds[word].did_first else word

        return first_outcome.copy(data=np.vectorize(why_not_first, otypes=[object])(first_outcome.values))
    searched = "reference_outcome" in table
    reference = table["reference_outcome"] if searched else outcome.copy(data=outcome.values)
    where = f" with {100 * reference.attrs['torque']:.4g} N cm" if searched else ""
    why = np.vectorize(_why_not_later(kinds, not_tried_word(transitions), where), otypes=[object])
    return outcome.copy(data=why(outcome.values, first_outcome.values, reference.values))


def _why_not_later(kinds: Mapping[str, OutcomeKind], not_tried: str, where: str) -> Callable[[str, str, str], str]:
    """What says why a later transition was missed, of its outcome, of the first, and of the first as it was before.

    Args:
        kinds: what words mean.
        not_tried: the word for what was not tried.
        where: with which value the first was done before, or nothing.
    """
    stuck_later = next((word for word, kind in kinds.items() if kind is OutcomeKind.STUCK_LATER), OTHER)
    did_first = {word for word, kind in kinds.items() if kind.did_first}
    silent = (OutcomeKind.UNDECIDED, OutcomeKind.DIVERGED, OutcomeKind.UNTRUSTED, OutcomeKind.NOT_BUILT)
    short_of_first = (OutcomeKind.STUCK, OutcomeKind.UNDER_WAY, OutcomeKind.MOVING, OutcomeKind.LOST)

    def why(outcome: str, first: str, reference: str) -> str:
        if where and reference in did_first:
            # what the reference value alone brings to the first state was asked for the later one, too
            word = outcome if first in did_first else stuck_later
        elif where and reference:
            word = reference if kinds.get(reference) in silent else f"{reference}{where}"
        else:
            word = not_tried if kinds.get(first) in short_of_first else outcome
        return OTHER if kinds.get(word) in (OutcomeKind.DID_FIRST, OutcomeKind.DID_ALL) else word

    return why
