"""Stable states of a net side by side, and the modes of vibration about them."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from forficula.quantities import reading_unit
from forficula.show.landscape.landscape_marks import shown_value
from forficula.show.landscape.net_pictures import net_pictures, outline_handle, show_pictures
from forficula.show.style import PAGE_WIDTH, describe, figure_style, fit_legend, is_narrow, letter_panels
from forficula.statics import EnergyLandscape
from forficula.statics.landscape import net_states
from forficula.statics.net.energy import shape_at
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_state import NetState

_SWING = 0.12  # largest displacement drawn for a mode, as a share of the net's size
_TITLE, _LEGEND = 0.5, 0.35  # inch
_PAD = 3  # pt, between a shape and its title
_MOST = 4  # largest number of states whose modes are drawn


def draw_states(landscape: EnergyLandscape, width: float = PAGE_WIDTH) -> Figure:
    """Draw the stable states that were found, by rising energy.

    Args:
        landscape: landscape of a net with a stable state.
        width: width of the figure, inch.
    """
    structure, states = landscape.structure, net_states(landscape)
    pictures = net_pictures(landscape, [state.rest.shape for state in states])
    rows = -(-len(states) // min(2 if is_narrow(width) else 4, len(states)))
    columns = -(-len(states) // rows)
    height = min(width / columns * pictures.slope, 2.4) + _TITLE
    with figure_style():
        figure = Figure(figsize=(width, rows * height + _LEGEND * (1 + is_narrow(width))), layout="constrained")
        axes = np.ravel(figure.subplots(rows, columns, squeeze=False))
        show_pictures(pictures, axes, width / columns)
        unit, factor = reading_unit("J", max(abs(state.energy) for state in states))
        for axis, state in zip(axes, states, strict=False):
            words = f"{factor * state.energy + 0.0:.3g} {unit}".replace("-", "−")
            touching = f", {len(state.contacts)} touching pairs" if len(state.contacts) > 1 else ""
            touching = ", one touching pair" if len(state.contacts) == 1 else touching
            axis.set_title(f"{state.name}\n{words}{touching}", pad=_PAD)
        letter_panels(axes[: len(states)].tolist())
        fit_legend(figure, pictures.handles, 4, loc="outside lower center")
        energies = "; ".join(f"{state.name} with {shown_value(state.energy, 'J', 3)}" for state in states)
        what = f"The stable states of the {structure.appearance.whole} {landscape.design.name} in 3-D"
        return describe(figure, f"{what}. {energies}.")


def draw_modes(landscape: EnergyLandscape, width: float = PAGE_WIDTH) -> Figure:
    """Draw the slowest modes about stable states, one row for each, with exaggerated amplitude; states are dotted.

    Args:
        landscape: landscape of a net with a stable state.
        width: width of the figure, inch.
    """
    net, structure = _net(landscape), landscape.structure
    preferred = [state for state in net_states(landscape) if state.withstands] or net_states(landscape)
    states = [state for state in preferred if len(state.modes)][:_MOST]
    count = max(len(state.modes) for state in states)
    columns = min(count, 2 if is_narrow(width) else 4)
    shown = [(state, mode) for state in states for mode in range(min(columns, len(state.modes)))]
    swung = [_swung(net, state, mode) for state, mode in shown]
    pictures = net_pictures(landscape, swung, [state.rest.shape for state, _ in shown])
    height = min(width / columns * pictures.slope, 2.0) + _TITLE
    with figure_style():
        figure = Figure(figsize=(width, len(states) * height + _LEGEND * (1 + is_narrow(width))), layout="constrained")
        grid = figure.subplots(len(states), columns, squeeze=False)
        drawn = [axes for row, state in zip(grid, states, strict=True) for axes in row[: len(state.modes)]]
        for axes in grid.ravel():
            axes.set_axis_off()
        show_pictures(pictures, drawn, width / columns)
        for axes, (state, mode) in zip(drawn, shown, strict=True):
            axes.set_title(f"{state.name}\nmode {mode + 1}, {_hertz(state.frequencies[mode])}", pad=_PAD)
        letter_panels(drawn)
        still = outline_handle("the state at rest; amplitudes are exaggerated")
        fit_legend(figure, [*pictures.handles, still], 4, loc="outside lower center")
        words = "; ".join(f"{state.name} {', '.join(map(_hertz, state.frequencies.tolist()))}" for state in states)
        what = f"The slowest modes of the {structure.appearance.whole} {landscape.design.name} about its states"
        return describe(figure, f"{what}, at full amplitude. {words}.")


def _swung(net: Net, state: NetState, mode: int) -> NetShape:
    """Return a state displaced along a mode by an exaggerated amplitude."""
    shift = state.modes[mode] / np.linalg.norm(state.modes[mode], axis=1).max()
    return shape_at(net, state.rest.shape.positions + _SWING * net.size * shift, state.rest.shape.angles)


def _hertz(frequency: float) -> str:
    return f"{frequency:.3g} Hz"


def _net(landscape: EnergyLandscape) -> Net:
    assert landscape.net is not None
    return landscape.net.net
