"""Maps of least slow torques, with those of a simulation for comparison."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from forficula.show.study.map_page import draw_page
from forficula.show.study.map_panel import MapPanel, MapView
from forficula.show.study.maps import table_view
from forficula.show.study.outcome_looks import map_style
from forficula.show.style import PAGE_WIDTH, is_narrow
from forficula.study.tables.map_comparison import NOT_SIMULATED, compare_maps, simulated_values
from forficula.study.tables.outcome_kinds import OutcomeKind, table_transitions, word_of

if TYPE_CHECKING:
    from xarray import DataArray, Dataset


def draw_static_maps(statics: Dataset, simulated: Dataset | None = None, width: float = PAGE_WIDTH) -> Figure:
    """Draw the least slowly growing torques of every transition, over the first two factors.

    Args:
        statics: table from `static_map`.
        simulated: table of a search for the least torques with the same factors; its torques are drawn beside, with a
            map
                of the differences.
        width: largest width of the figure, inch.

    Raises:
        InputError: the tables have different factors.
    """
    torques = {
        transition.least: transition.wording.does
        for transition in table_transitions(statics)
        if transition.least in statics
    }
    with map_style():
        if simulated is None:
            view = table_view(statics)
            panels = [_panel(view, name, f"{verb} under a slow torque") for name, verb in torques.items()]
            return draw_page(view, panels, quantity="torque", one_scale=True, width=width)
        extra = {}
        for name in torques:
            extra[f"simulated_{name}"] = simulated_values(statics, simulated, name)
            extra[f"verdict_{name}"] = compare_maps(statics, simulated, name)
        # a structure without this energy was not run at all
        energies = simulated_values(statics, simulated, _of_every_run(statics, simulated))
        extra["simulated"] = energies.copy(data=np.isfinite(energies.values))
        view = table_view(statics.assign(extra))
        panels = []
        for name, verb in torques.items():
            panels += [
                _panel(view, name, f"{verb} under a slow torque"),
                _panel(view, name, f"{verb}, simulated", simulated=True),
                _verdicts(view, name, verb),
            ]
        if is_narrow(width):  # a column for each transition
            panels = [panels[place] for row in range(3) for place in range(row, len(panels), 3)]
        return draw_page(view, panels, quantity="torque", one_scale=True, width=width)


def _of_every_run(statics: Dataset, simulated: Dataset) -> str:
    """Return the name of a number that a simulated table has for every run."""
    start = f"{statics.attrs['start_state']}_energy"
    return start if start in simulated else "residual"


def _panel(view: MapView, name: str, title: str, simulated: bool = False) -> MapPanel:
    table = view.table
    values = table[f"simulated_{name}"] if simulated else table[name]
    before, *_ = table_transitions(table)
    first = name == before.least
    why = np.full(values.shape, word_of(table, OutcomeKind.STUCK if first else OutcomeKind.STUCK_LATER), dtype=object)
    # a state in which the structure does not rest has no energy, and no transition starts there
    if not first and not simulated:
        lost = np.isnan(table[f"{before.state}_energy"].values)
        why[lost] = table["outcome"].values[lost]
    if simulated:
        verdict = table[f"verdict_{name}"].values
        why[verdict == NOT_SIMULATED] = word_of(table, OutcomeKind.NOT_TRIED)
        why[~table["simulated"].values] = NOT_SIMULATED
    else:
        not_built = word_of(table, OutcomeKind.NOT_BUILT)
        why[table["outcome"].values == not_built] = not_built
    return MapPanel(title=title, values=values, reasons=values.copy(data=why), unit="N m")


def _verdicts(view: MapView, name: str, verb: str) -> MapPanel:
    words: DataArray = view.table[f"verdict_{name}"]
    nothing = words.copy(data=np.full(words.shape, np.nan))
    return MapPanel(title=f"{verb}: compared", values=nothing, reasons=words, unit="N m")
