"""Figures of maps: cells over two factors, samples over two, or points over one, and reasons for missing values."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Colormap, ListedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.textpath import TextPath

from forficula.arrays import Array, Flags
from forficula.show.study.bins import binned_page
from forficula.show.study.factor_text import display_values, factor_label, number_text, plain_name
from forficula.show.study.map_panel import MapPanel, MapView
from forficula.show.study.maps_text import maps_text
from forficula.show.study.outcome_looks import INK, OutcomeLook, ink_of, known_words, look_of
from forficula.show.style import (
    BLUE,
    PAGE_WIDTH,
    colours_of,
    describe,
    fit_legend,
    is_narrow,
    letter_panels,
)
from forficula.study.tables.outcome_kinds import whole_of

# largest number of values for which cells contain numbers and every value has a tick
_MOST_NUMBERS = 12
# largest number of cells along a factor that have frames and hatches of their own
_MOST_FRAMED = 60
_NUMBER, _CELL_FILLED = 6.0, 0.86  # pt, size of a number in a cell; its largest width, as a share of the cell
_POINTS_HEIGHT, _STRIP = 1.7, 0.15  # inch, height of axes with points; strip of failures, as a share of the values
_ONE_UNIT = 1e-2  # ratio of sizes down to which panels have one unit
_SHAPE = {"handleheight": 1.4, "handlelength": 2.2, "fontsize": 7}
_LEGEND_HEIGHT = 0.4  # inch, height that is reserved for the legend below the maps
_APART = 0.12  # distance of maps with colour bars, as a share of a map's width

# units of a kind of quantity, and their factors from SI
_READABLE = {
    "N m": (("N cm", 1e2), ("N mm", 1e3), ("µN m", 1e6), ("nN m", 1e9)),
    "J": (("J", 1.0), ("mJ", 1e3), ("µJ", 1e6), ("nJ", 1e9)),
    "s": (("s", 1.0), ("ms", 1e3), ("µs", 1e6)),
}


@dataclass(frozen=True, kw_only=True)
class _Scale:
    """Unit of a quantity, its factor from SI, and its colour scale; `single` is whether all values are equal."""

    unit: str
    factor: float
    norm: Normalize
    colours: Colormap
    empty: bool
    single: bool

    @property
    def ends(self) -> tuple[float, float]:
        """Return the least and the largest value, in the unit."""
        return float(self.norm.vmin or 0.0), float(self.norm.vmax or 0.0)


def draw_page(
    view: MapView,
    panels: Sequence[MapPanel],
    *,
    one_scale: bool = False,
    quantity: str = "",
    note: str = "",
    width: float = PAGE_WIDTH,
) -> Figure:
    """Draw all panels with their colour bars, a legend of reasons for missing values, and the name of the slice.

    Args:
        view: axes and table of the maps.
        panels: panels to draw.
        one_scale: whether all panels share a colour scale.
        quantity: quantity of the panels.
        note: text above the panels, after that of the view.
        width: largest width of the figure, inch.
    """
    view, panels, shown = binned_page(view, panels)
    cells = not view.sampled and (view.y is not None or not panels[0].unit)
    columns = _columns(len(panels), width)
    width = width if columns > 1 else min(width, 0.6 * PAGE_WIDTH)
    figure, grid = _empty_page(view, len(panels), columns, width, cells)
    scales = [_scale(panels)] * len(panels) if one_scale else _own_scales(panels)
    for index, (axes, panel, scale) in enumerate(zip(grid, panels, scales, strict=True)):
        axes.set_title(_wrapped(panel.title, width / columns))
        if cells:
            _draw_cells(axes, view, panel, scale)
        else:
            _draw_points(axes, view, panel, scale, quantity)
        if index + columns >= len(panels):
            axes.set_xlabel(factor_label(view.table[view.x]))
        if view.y and index % columns == 0:
            axes.set_ylabel(factor_label(view.table[view.y]))
        elif view.y:
            axes.tick_params(labelleft=False)
        if (cells or view.y) and not one_scale and not scale.empty:
            _colour_bar(figure, [axes], f"{quantity} ({scale.unit})", scale)
            # keeps the bar's label next to its map
            layout = figure.get_layout_engine()
            assert isinstance(layout, ConstrainedLayoutEngine)
            layout.set(wspace=_APART)
    if (cells or view.y) and one_scale and not scales[0].empty:
        _colour_bar(figure, grid, f"{quantity} ({scales[0].unit})", scales[0])
    letter_panels(grid)
    if text := "\n".join(part for part in (", ".join(part for part in (view.note, note) if part), shown) if part):
        figure.suptitle(_wrapped_lines(text, width), fontsize=8)
    _legend(figure, view, panels, cells=cells)
    if cells and max(_across_and_upwards(view)) <= _MOST_NUMBERS:
        _write_numbers(figure, view, list(zip(grid, panels, scales, strict=True)))
    factors = [plain_name(view.table[name]) for name in (view.y, view.x) if name]
    return describe(
        figure,
        maps_text(
            quantity,
            factors,
            panels,
            [(scale.unit, scale.factor) for scale in scales],
            whole="bin" if shown else whole_of(view.table),
            shown=shown,
        ),
    )


def _empty_page(view: MapView, count: int, columns: int, width: float, cells: bool) -> tuple[Figure, list[Axes]]:
    """Return a figure with axes for a number of panels, with the height of their cells."""
    rows = math.ceil(count / columns)
    upwards = _across_and_upwards(view)[1]
    height = (
        float(np.clip((0.27 if rows == 1 else 0.21) * upwards, 0.9 if rows == 1 else 1.2, 3.2))
        if cells
        else _POINTS_HEIGHT
    )
    figure = Figure(figsize=(width, rows * (height + 0.5) + 0.75), layout="constrained")
    grid = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes in grid[count:]:
        axes.remove()
    return figure, list(grid[:count])


def _across_and_upwards(view: MapView) -> tuple[int, int]:
    """Return the number of cells across and upwards."""
    return view.table[view.x].size, view.table[view.y].size if view.y else 1


def _wrapped(title: str, width: float) -> str:
    """Wrap a title to a width, inch."""
    return textwrap.fill(title, max(12, int(13 * width)))


def _wrapped_lines(text: str, width: float) -> str:
    """Wrap every line of a text to the width of a page, inch."""
    return "\n".join(textwrap.fill(line, int(17 * width)) for line in text.split("\n"))


def _columns(panels: int, width: float) -> int:
    if is_narrow(width):
        return 1 if panels <= 3 else 2
    return {1: 1, 2: 2, 4: 2}.get(panels, 3)


def _scale(panels: Sequence[MapPanel]) -> _Scale:
    """Return one scale for all values of some panels."""
    values = np.concatenate([panel.values.values.astype(float).ravel() for panel in panels])
    finite = values[np.isfinite(values)]
    empty, units = not len(finite), _READABLE.get(panels[0].unit, ((panels[0].unit, 1.0),))
    low, high = (0.0, 0.0) if empty else (float(finite.min()), float(finite.max()))
    largest = max(abs(low), abs(high))
    unit, factor = next((pair for pair in units if largest * pair[1] >= 0.999), units[-1] if largest else units[0])
    single = low == high
    if single:
        low, high = low - 0.1 * largest - (not largest), high + 0.1 * largest + (not largest)
    return _Scale(
        unit=unit,
        factor=factor,
        norm=Normalize(low * factor, high * factor),
        colours=colours_of(panels[0].unit),
        empty=empty,
        single=single and not empty,
    )


def _own_scales(panels: Sequence[MapPanel]) -> list[_Scale]:
    """Return a scale for each panel; panels of the same quantity have the same unit, unless their sizes differ much."""
    scales = [_scale([panel]) for panel in panels]
    common = _scale(panels)
    for number, (panel, scale) in enumerate(zip(panels, scales, strict=True)):
        share = common.factor / scale.factor
        if panel.unit == panels[0].unit and not scale.empty and share >= _ONE_UNIT:
            low, high = (share * end for end in scale.ends)
            scales[number] = replace(scale, unit=common.unit, factor=common.factor, norm=Normalize(low, high))
    return scales


def _colour_bar(figure: Figure, axes: list[Axes], label: str, scale: _Scale) -> None:
    mappable = ScalarMappable(scale.norm, scale.colours)
    # below two narrow columns, which take the whole width
    beneath = is_narrow(figure.get_figwidth()) and len(axes) > 3
    bar = figure.colorbar(
        mappable, ax=axes, pad=0.015, aspect=25, fraction=0.06, location="bottom" if beneath else "right"
    )
    bar.set_label(label, labelpad=1.5)
    if scale.single:
        bar.set_ticks([sum(scale.ends) / 2])
    bar.outline.set_visible(False)


def _missing(view: MapView, panel: MapPanel) -> dict[str, Flags]:
    """Return where values are missing, by reason, in the panel's order of dimensions."""
    absent = ~np.isfinite(panel.values.values.astype(float))
    words = panel.reasons.transpose(*panel.values.dims).values.astype(str)
    known = known_words(view.table)
    order = [*known, *sorted(set(words[absent].tolist()) - set(known))]
    return {word: where for word in order if (where := absent & (words == word)).any()}


def _legend(figure: Figure, view: MapView, panels: Sequence[MapPanel], *, cells: bool) -> None:
    """Draw a legend of every reason that a panel shows."""
    words = list(dict.fromkeys(word for panel in panels for word in _missing(view, panel)))
    handles: list[Patch | Line2D] = []
    for word in words:
        look = look_of(view.table, word)
        if cells:
            handles.append(Patch(facecolor=look.face, hatch=look.hatch, edgecolor=INK, lw=0.4, label=word))
        else:
            handles.append(Line2D([], [], ls="", marker=look.marker, color=ink_of(look), ms=5, label=word))
    if handles:
        narrow = is_narrow(figure.get_figwidth())
        shape = {"handleheight": 1.3, "handlelength": 1.6, "fontsize": 6} if narrow and len(handles) > 4 else _SHAPE
        legend = fit_legend(figure, handles, 4, loc="outside lower center", columnspacing=1.2, **shape)
        # the maps keep their height
        more = legend.get_window_extent().height / figure.dpi - _LEGEND_HEIGHT
        figure.set_figheight(figure.get_figheight() + max(more, 0.0))


def _draw_cells(axes: Axes, view: MapView, panel: MapPanel, scale: _Scale) -> None:
    """Draw a cell for each pair of values, evenly spaced unless the factor is a continuous axis."""
    order = [name for name in (view.y, view.x) if name]
    panel = replace(panel, values=panel.values.transpose(*order), reasons=panel.reasons.transpose(*order))
    values = _cells(view, panel, scale)
    edges = [_edges(view, name, count) for name, count in ((view.x, values.shape[1]), (view.y, values.shape[0]))]
    fine = view.bins or max(values.shape) > _MOST_FRAMED
    frame = {"rasterized": True} if fine else {"edgecolors": "white", "linewidth": 0.4}
    if np.isfinite(values).any():
        shown = np.ma.masked_invalid(values)
        axes.pcolormesh(*edges, shown, cmap=scale.colours, norm=scale.norm, **frame)
    for word, where in _missing(view, panel).items():
        look = look_of(view.table, word)
        if fine:
            _draw_area(axes, edges, np.atleast_2d(where), look)
            continue
        axes.pcolor(
            *edges,
            np.ma.masked_array(np.zeros(values.shape), ~np.atleast_2d(where)),
            cmap=ListedColormap([look.face]),
            hatch=look.hatch,
            edgecolor="white" if look.face == "0.86" else INK,
            linewidth=0.25,
        )
    axes.set(xlim=edges[0][[0, -1]], ylim=edges[1][[0, -1]])
    axes.tick_params(length=0)
    for name, axis in ((view.x, axes.xaxis), (view.y, axes.yaxis)):
        if name in view.edges:
            if _is_log(view.edges[str(name)]):
                (axes.set_xscale if axis is axes.xaxis else axes.set_yscale)("log")
            axis.set_tick_params(which="both", length=2)
            continue
        shown_values = display_values(view.table[name])[0] if name else np.array([])
        step = math.ceil(len(shown_values) / _MOST_NUMBERS) or 1
        places = range(0, len(shown_values), step)
        axis.set_ticks(list(places), [number_text(shown_values[place].item()) for place in places])


def _edges(view: MapView, name: str | None, count: int) -> Array:
    """Return the boundaries of the cells along a factor: in its display unit if it is a continuous axis."""
    if name is None or name not in view.edges:
        return np.arange(count + 1, dtype=np.float64) - 0.5
    factor = view.table[name]
    edges, _ = display_values(factor.__class__(view.edges[name], attrs=factor.attrs))
    return np.asarray(edges)


def _is_log(edges: Array) -> bool:
    return bool(edges[0] > 0 and not np.allclose(np.diff(edges), edges[1] - edges[0], rtol=1e-6))


def _draw_area(axes: Axes, edges: Sequence[Array], where: Flags, look: OutcomeLook) -> None:
    """Draw small cells of one outcome as areas with a common hatch."""
    cells = np.ma.masked_array(np.zeros(where.shape), ~where)
    axes.pcolormesh(*edges, cells, cmap=ListedColormap([look.face]), rasterized=True)
    if look.hatch and min(where.shape) > 1:
        # areas extend from the middles of the cells to the outer edges of the map
        places = [np.concatenate([sides[:1], (sides[1:] + sides[:-1]) / 2, sides[-1:]]) for sides in edges]
        covered = np.pad(where.astype(float), 1, mode="edge")
        with rc_context({"hatch.color": INK}):
            axes.contourf(*places, covered, levels=[0.5, 1.5], colors="none", hatches=[look.hatch])


def _cells(view: MapView, panel: MapPanel, scale: _Scale) -> Array:
    """Return values in the scale's unit, (upwards, across)."""
    values = panel.values.transpose(*(name for name in (view.y, view.x) if name)).values
    return np.atleast_2d(values.astype(float) * scale.factor)


def _write_numbers(figure: Figure, view: MapView, drawn: Sequence[tuple[Axes, MapPanel, _Scale]]) -> None:
    """Write every value into its cell, in a legible colour, with as many digits as fit into all maps."""
    cells = [(axes, scale, _cells(view, panel, scale)) for axes, panel, scale in drawn]
    if not any(np.isfinite(values).any() for _, _, values in cells):
        return
    layout = figure.get_layout_engine()
    assert layout is not None
    layout.execute(figure)  # determines the width of the cells
    fonts = FontProperties(size=_NUMBER)
    for digits in (3, 2, 1):
        texts = [_short_texts(values, digits) for _, _, values in cells]
        widths = {
            text: TextPath((0, 0), text, prop=fonts).get_extents().width for item in texts for text in item.values()
        }
        room = min(72 * axes.get_window_extent().width / figure.dpi / values.shape[1] for axes, _, values in cells)
        if max(widths.values(), default=0.0) <= _CELL_FILLED * room:
            break
    else:
        return
    for (axes, scale, values), item in zip(cells, texts, strict=True):
        for (row, column), text in item.items():
            red, green, blue, _ = scale.colours(scale.norm(values[row, column]))
            ink = "black" if 0.299 * red + 0.587 * green + 0.114 * blue > 0.5 else "white"
            axes.text(column, row, text, ha="center", va="center", fontsize=_NUMBER, color=ink)


def _short_texts(values: Array, digits: int) -> dict[tuple[int, ...], str]:
    """Return numbers by cell, with a number of digits for the largest one; large numbers as integers."""
    largest = float(np.nanmax(np.abs(values), initial=0.0))
    decimals = digits - math.floor(math.log10(largest)) if largest else 0
    texts = {}
    for place, value in np.ndenumerate(values):
        if np.isfinite(value):
            rounded = round(float(value), decimals) + 0.0
            texts[place] = f"{rounded:.{digits}g}" if abs(rounded) < 10**digits else f"{rounded:.0f}"
    return texts


def _space_for_failures(axes: Axes, values: Array, failures: bool) -> None:
    """Set the vertical range to the values; below it, a strip without numbers where failures are marked."""
    low, high = (float(values.min()), float(values.max())) if len(values) else (0.0, 1.0)
    span = (high - low) or 0.2 * abs(high) or 1.0
    bottom = low - 0.08 * span
    axes.set_ylim(bottom - failures * _STRIP * span, high + 0.08 * span)
    if failures:
        axes.axhline(bottom, color="0.8", lw=0.5, zorder=0)
        axes.set_yticks([tick for tick in axes.get_yticks() if bottom <= tick <= high + 0.08 * span])


def _draw_points(axes: Axes, view: MapView, panel: MapPanel, scale: _Scale, quantity: str) -> None:
    """Draw samples over two factors, coloured by value; or values over one factor, with failures at the bottom."""
    values = panel.values.values.astype(float) * scale.factor
    across = _positions(axes, view, "x")
    missing = _missing(view, panel)
    if view.y:
        upwards = _positions(axes, view, "y")
        present = np.isfinite(values)
        if present.any():
            positions = across[present], upwards[present]
            axes.scatter(*positions, c=values[present], cmap=scale.colours, norm=scale.norm, s=16, ec=INK, lw=0.3)
        foot = axes.transData
    else:
        upwards = np.full(len(values), 0.055 if panel.unit else 0.5)
        foot = axes.get_xaxis_transform()
        margin = 0.05 * float(np.ptp(across)) or 0.5
        axes.set_xlim(across.min() - margin, across.max() + margin)
        if panel.unit:
            axes.plot(across, values, "o" if view.sampled else "o-", color=BLUE, ms=3.5)
            axes.set_ylabel(f"{quantity or panel.title} ({scale.unit})")
            _space_for_failures(axes, values[np.isfinite(values)], any(where.any() for where in missing.values()))
        else:
            axes.set_yticks([])
    for word, where in missing.items():
        look = look_of(view.table, word)
        axes.plot(
            across[where], upwards[where], ls="", marker=look.marker, color=ink_of(look), ms=4, mew=0.8, transform=foot
        )


def _positions(axes: Axes, view: MapView, which: str) -> Array:
    """Return the positions of a factor's values on an axis; words are numbered."""
    values, _ = display_values(view.table[view.x if which == "x" else str(view.y)])
    if values.dtype.kind in "iuf":
        return values.astype(float)
    words, places = np.unique(values.astype(str), return_inverse=True)
    axis = axes.xaxis if which == "x" else axes.yaxis
    axis.set_ticks(list(range(len(words))), list(words))
    return places.astype(float)
