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
from forficula.show.study.boundary_figure import draw_boundary_map
from forficula.show.study.factor_text import plain_name, value_text, value_with_unit
from forficula.show.study.map_page import draw_page
from forficula.show.study.map_panel import MapPanel, MapView
from forficula.show.study.outcome_looks import OTHER, map_style
from forficula.show.style import PAGE_WIDTH, Drawing
from forficula.study.assumptions.choices import CHOICE
from forficula.study.refine.summary import locates_boundaries
from forficula.study.tables.outcome_kinds import (
    OutcomeKind,
    not_tried_word,
    outcome_kinds,
    studied_transitions,
    table_transitions,
)

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

_MOST_PANELS = 9


def map_drawings(table: Dataset) -> dict[str, Drawing]:
    """Return every map for which a study's table has numbers.

    Args:
        table: table of a search for the least torques or of plain runs: over a grid of factors, with or without
            choices, over samples, or of boundaries.

    Returns:
        Drawings by the stems of their files.
    """
    transitions = table_transitions(table)
    drawings: dict[str, Drawing] = {}
    if locates_boundaries(table):
        drawings["boundaries"] = lambda width: draw_boundary_map(table, width=width)
        if len(_factors(table)) > 2:
            # points at all values of a third factor would cover each other
            return drawings
    drawings["status"] = lambda width: draw_status_map(table, width=width)
    if any(transition.least and transition.least in table for transition in transitions):
        drawings["torques"] = lambda width: draw_torque_maps(table, width=width)
        if not _is_sampled(table) and len(_axes(table)) > 2:
            drawings["torques_moving"] = lambda width: draw_moving_maps(table, width=width)
    if _known(table, *(f"{transition.name}_work" for transition in transitions)):
        drawings["works"] = lambda width: draw_work_maps(table, width=width)
    if _known(table, *(f"{state}_energy" for state in _states(table))):
        drawings["energy"] = lambda width: draw_energy_maps(table, width=width)
    if times_by_value(table) is not None and not _is_sampled(table):
        drawings["fold_times"] = lambda width: draw_first_times(table, width=width)
    return drawings


def draw_torque_maps(
    table: Dataset, x: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH
) -> Figure:
    """Draw the least values with which a structure reaches its states, and reasons for missing values.

    Args:
        table: table of a search for the least values.
        x: factor on the horizontal axis, such as "tendon.rest_length"; by default the second.
        y: factor on the vertical axis; by default the first.
        width: largest width of the figure, inch.

    Raises:
        InputError: the table has no such factor.
    """
    first, *_ = each_least = [transition for transition in table_transitions(table) if transition.least]
    names = {item.least: item.least.replace("_", " ") for item in each_least}
    if "torque" in (reference := table["reference_outcome"].attrs if "reference_outcome" in table else {}):
        after = f", {first.state} with {show_value(reference['torque'], 'N m')}"
        names |= {item.least: f"{names[item.least]}{after}" for item in each_least[1:]}
    quantity = "torque" if all(_unit(table, name) == "N m" for name in names if name in table) else "least value"
    return _draw(table, x, y, names, quantity, width=width)


def draw_moving_maps(table: Dataset, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw maps of the first least values for values of a third factor, one panel for each.

    Args:
        table: table of a search for the least values over a grid of at least three factors. Of many values, some are
            drawn.
        width: width of the figure, inch.
    """
    first = next(
        transition for transition in table_transitions(table) if transition.least and transition.least in table
    )
    upwards, across, moving, *_ = _axes(table)
    with map_style():
        view = _slice(table, [upwards, across, moving], x=across, y=upwards)
        values, reasons = view.table[first.least], missing_reasons(view.table, first.least)
        chosen, few = _few_values(table, moving)
        panels = []
        for index in chosen:
            panel_values = values.isel({moving: index})
            counts = f"{int(panel_values.count())} of {panel_values.size} {first.wording.verb}"
            title = f"{value_with_unit(table[moving], index)}: {counts}"
            why = reasons.isel({moving: index})
            panels.append(MapPanel(title=title, values=panel_values, reasons=why, unit=_unit(table, first.least)))
        quantity, note = first.least.replace("_", " "), few or f"by {plain_name(table[moving])}"
        return draw_page(view, panels, one_scale=True, quantity=quantity, note=note, width=width)


def draw_work_maps(table: Dataset, x: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw the work of transitions, at the least values if these were searched for.

    Args and errors are those of `draw_torque_maps`.
    """
    names = {f"{transition.name}_work": f"work of {transition.wording.noun}" for transition in table_transitions(table)}
    return _draw(table, x, y, names, "work", width=width)


def draw_energy_maps(
    table: Dataset, x: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH
) -> Figure:
    """Draw the tendons' energy in the states on one scale (Binder et al. 2025, Figure 8).

    Args and errors are those of `draw_torque_maps`.
    """
    noun, states = energy_noun(table), _states(table)
    # if springs store energy as well, the title must not suggest the total
    others = any(f"{state}_{of}_energy" in table for state in states for of in ("hinge", "spring"))
    names = {f"{state}_energy": f"{noun if others else 'energy'} when {state}" for state in states}
    return _draw(table, x, y, names, noun, one_scale=True, width=width)


def energy_noun(table: Dataset) -> str:
    """Return the noun for the energies of states in a table: tendons' energy, or all stored energy without tendons."""
    named = [table.get(f"{state}_energy") for state in _states(table)]
    long_names = [str(item.attrs.get("long_name", "")) for item in named if item is not None]
    return "stored energy" if any(name.startswith("stored") for name in long_names) else "tendons' energy"


def draw_status_map(table: Dataset, x: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw the outcome of every structure.

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
    """Draw the time of the first transition over the value that drives it and a factor, for values of another factor.

    As in Binder et al. 2025, Figure 7.

    Args:
        table: table of a search for the least values over a grid.
        panels: factor with one panel for each value; by default the first of several. Of many values, some are drawn.
        y: factor on the vertical axis; by default the second, or the only one.
        width: largest width of the figure, inch.

    Raises:
        InputError: the table has no such factor, or contains samples.
    """
    if _is_sampled(table):
        raise InputError("times over the value need a grid of factors, got samples")
    tried = times_by_value(table)
    if tried is None:
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
        view = _slice(table, [name for name in (panels, y) if name], x=tried.value, y=y)
        times, reasons = view.table[tried.times], view.table[tried.outcomes]
        if panels is None:
            only = MapPanel(title=tried.label, values=times, reasons=reasons, unit="s")
            return draw_page(view, [only], quantity=tried.label, width=width)
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
        return draw_page(view, drawn, one_scale=True, quantity=tried.label, note=few, width=width)


def _few_values(table: Dataset, factor: str) -> tuple[list[int], str]:
    """Return the indices of a factor's values with panels, from end to end, and a note if not all have one."""
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
    """Draw a panel for each variable."""
    with map_style():
        view = table_view(table, x, y)
        panels = [
            MapPanel(
                title=title, values=view.table[name], reasons=missing_reasons(view.table, name), unit=_unit(table, name)
            )
            for name, title in names.items()
            if name in table  # a search may omit the second transition
        ]
        return draw_page(view, panels, one_scale=one_scale, quantity=quantity, width=width)


# ---- the table: its factors, its slices, and reasons for missing values


def _is_sampled(table: Dataset) -> bool:
    return table["outcome"].dims == ("sample",)


def _factors(table: Dataset) -> list[str]:
    """Return the names of the factors, in the study's order; the choices of one-at-a-time factors last."""
    if not _is_sampled(table):
        # maps show the grid that is repeated at every choice
        return sorted((str(name) for name in table["outcome"].dims), key=lambda name: name == CHOICE)
    return [str(name) for name, values in table.coords.items() if values.dims == ("sample",) and name != "sample"]


def _axes(table: Dataset) -> list[str]:
    """Return the names of a grid's factors with several values, in the study's order, without choices."""
    return [name for name in _factors(table) if name != CHOICE and table.sizes[name] > 1]


def _name(factors: Sequence[str], wanted: str) -> str:
    """Return a factor's name in the table, given this name or the factor's key."""
    name = wanted.replace(".", "_")
    if name not in factors:
        raise InputError(f"{wanted}: need a factor of the study, one of {', '.join(factors)}")
    return name


def table_view(table: Dataset, x: str | None = None, y: str | None = None) -> MapView:
    """Return the view over two factors, or over the only one.

    Raises:
        InputError: the table has no such factor.
    """
    factors = _factors(table)
    if len(factors) == 1:
        return _slice(table, factors, x=_name(factors, x or factors[0]), y=None)
    across, upwards = (_name(factors, name) if name else None for name in (x, y))
    # a factor with one value is an axis only if no other factor varies
    free = sorted((name for name in factors if name not in (across, upwards)), key=lambda name: table[name].size == 1)
    upwards = upwards or free.pop(0)
    across = across or free.pop(0)
    if across == upwards:
        raise InputError(f"x and y: need two factors, got {across} twice")
    return _slice(table, [upwards, across], x=across, y=upwards)


def _slice(table: Dataset, kept: Sequence[str], *, x: str, y: str | None) -> MapView:
    """Return a slice at the middle of every factor that is not kept (base design for choices), with a note."""
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
    """Names in a table of the outcomes of the first transition with every value that was tried.

    Attributes:
        value: dimension of the values, such as "fold_torque".
        times: variable of the times.
        outcomes: variable of the outcomes.
        label: title of the time.
    """

    value: str
    times: str
    outcomes: str
    label: str


def times_by_value(table: Dataset) -> TimesByValue | None:
    """Return what a search tried for the first transition; None for a table without a search."""
    for first in studied_transitions(table)[:1]:
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
    """Return the names of the states, beginning with the one before any transition."""
    start = str(table.attrs.get("start_state", ""))
    return [*([start] if start else []), *(transition.state for transition in table_transitions(table))]


# runs without a conclusive verdict
_SILENT = (OutcomeKind.UNDECIDED, OutcomeKind.DIVERGED, OutcomeKind.UNTRUSTED, OutcomeKind.NOT_BUILT)


def missing_reasons(table: Dataset, name: str) -> DataArray:
    """Return the reasons for missing values of a variable."""
    outcome, transitions, kinds = table["outcome"], table_transitions(table), outcome_kinds(table)
    if name.endswith("margin"):
        return outcome
    for kind in SPRUNG:  # energies of other parts are missing for the reason of the state's energy
        name = name.replace(f"_{kind}_energy", "_energy")
    if transitions and name == f"{_states(table)[0]}_energy":
        # every conclusive run has a first state, so the structure of this point lacks such parts
        known = [word for word, kind in kinds.items() if kind not in _SILENT]
        return outcome.copy(data=np.where(np.isin(outcome.values.astype(str), known), OTHER, outcome.values))
    if not transitions or name == "residual":
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
    """Return a function that explains why a later transition has no value, from three outcomes.

    The outcomes are those of the point, of the first transition, and of the first transition with the reference value.

    Args:
        kinds: meanings of words.
        not_tried: word for transitions that were not tried.
        where: text on the reference value of the first transition, or empty.
    """
    stuck_later = next((word for word, kind in kinds.items() if kind is OutcomeKind.STUCK_LATER), OTHER)
    did_first = {word for word, kind in kinds.items() if kind.did_first}
    short_of_first = (OutcomeKind.STUCK, OutcomeKind.UNDER_WAY, OutcomeKind.MOVING, OutcomeKind.LOST)

    def why(outcome: str, first: str, reference: str) -> str:
        if where and reference in did_first:
            # what reaches the first state with the reference value was also run for the later transition
            word = outcome if first in did_first else stuck_later
        elif where and reference:
            word = reference if kinds.get(reference) in _SILENT else f"{reference}{where}"
        else:
            word = not_tried if kinds.get(first) in short_of_first else outcome
        return OTHER if kinds.get(word) in (OutcomeKind.DID_FIRST, OutcomeKind.DID_ALL) else word

    return why
