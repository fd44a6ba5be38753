"""A frame of a film: the structure, its state, and plots of its energy below."""

from __future__ import annotations

import math
import textwrap

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from forficula.analysis.order_of_events import moment_texts, ordered_motions
from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.quantities import reading_unit, round_below, show_value
from forficula.show.film.film_clock import FilmCut
from forficula.show.run.energies_figure import stored_energies
from forficula.show.structure.painted_shape import PaintedShape, paint_shape, shape_handles
from forficula.show.structure.shape import Shape, shape_of
from forficula.show.structure.surface import at_time, face_strains, surface_at
from forficula.show.structure.viewpoint import readable_view
from forficula.show.style import ENERGY_COLOURS, LINE_STYLES, PAGE_WIDTH, STRAIN_COLOURS, figure_style
from forficula.structure import hinge_groups, springs_name

Picture = NDArray[np.uint8]

# positions in the frame, in shares of it: left, low, width, height
_STRAIN_BAR = (0.72, 0.845, 0.25, 0.018)
_PICTURE, _BAR, _KEY = (0.03, 0.32, 0.94, 0.54), (0.72, 0.945, 0.25, 0.018), (0.775, 0.03, 0.2, 0.24)
_BELOW_STRAIN_BAR = 0.44  # height of the picture below both bars
_PLOTS_LEFT, _PLOTS_RIGHT, _PLOTS_LOW, _PLOTS_HIGH, _PLOTS_GAP = 0.08, 0.735, 0.105, 0.25, 0.025
# share of a time below which the next smaller unit is used: 300.0 ms is easier to follow than 0.3 s
_HALF = 0.5
_MOST_ENTRIES = 7  # largest number of entries that fit into the legend's area
_ORDER, _ORDER_LETTERS = 0.69, 50  # right end of the order of events, in widths of the frame, and its letters per line
_LEAD = 0.04  # time shown before and after a move, as a share of it


class FilmFrame:
    """Frame that is drawn repeatedly: fixed parts are drawn once, moving parts every time."""

    def __init__(
        self, record: Record, cuts: tuple[FilmCut, ...], size: tuple[int, int], *, strain: bool = False
    ) -> None:
        """Draw the fixed parts.

        Args:
            record: the simulated motion.
            cuts: parts of the film.
            size: size of the frame, pixels across and upwards.
            strain: whether membranes are coloured by their largest strains.
        """
        self._record, self._shape = record, shape_of(record.structure)
        ends = [surface_at(record, self._shape, time) for cut in cuts for time in (cut.first, cut.last)]
        self._view = readable_view(ends)
        self._norm = Normalize(0, _largest(record, record.series["tendon_energy"], cuts) or 1.0)
        self._strains = Normalize(0, self._largest_strain(cuts) or 1e-6) if strain else None
        with figure_style():
            dpi = size[0] / PAGE_WIDTH
            # slightly more than whole pixels, because rounding could remove one
            figure = Figure(figsize=((size[0] + 0.01) / dpi, (size[1] + 0.01) / dpi), dpi=dpi)
            self._canvas = FigureCanvasAgg(figure)
            self._axes = _picture_axes(figure, self._corners(cuts), size, _BELOW_STRAIN_BAR if strain else _PICTURE[3])
            figure.text(0.03, 0.97, record.design.name, va="top", color="0.35")
            self._words = figure.text(0.03, 0.925, "", fontsize=11, fontweight="bold", va="top")
            self._clock = figure.text(0.03, 0.865, "", va="top", color="0.25")
            self._order = figure.text(_ORDER, 0.97, "", va="top", ha="right", color="0.25", fontsize=7)
            self._cursors = _plots(figure, record, cuts)
            if record.structure.tendons:
                _colour_bar(figure, self._norm)
            if self._strains is not None:
                _strain_bar(figure, self._strains)
            _key(figure, self._shape, record, strain)
            self._moving = [self._words, self._clock, self._order, *(line for _, _, line in self._cursors)]
            for artist in self._moving:
                artist.set_animated(True)
            self._canvas.draw()  # type: ignore[no-untyped-call]
        self._still = self._canvas.copy_from_bbox(figure.bbox)  # type: ignore[no-untyped-call]

    def draw(self, cut: FilmCut, time: float) -> Picture:
        """Draw the frame of a time of the run.

        Args:
            cut: part of the film.
            time: time in the run, s.

        Returns:
            Red, green and blue of every pixel, 0 to 255, the highest row first, (height, width, 3).
        """
        colours = ENERGY_COLOURS(self._norm(at_time(self._record, "tendon_energy", time)))
        surface = surface_at(self._record, self._shape, time)
        faces = None
        if self._strains is not None:
            faces = STRAIN_COLOURS(self._strains(face_strains(self._shape, surface)))[:, :3]
        painted = paint_shape(surface, self._view, colours, faces)
        self._words.set_text(cut.words)
        self._clock.set_text(_clock_text(cut, time))
        self._order.set_text(_order_text(self._record, cut))
        for shown, scale, cursor in self._cursors:
            now = float(np.clip(time, shown.first, shown.last))
            cursor.set_xdata([scale * (now - _zero(shown))] * 2)
            cursor.set_visible(time >= shown.first)
        with figure_style():
            self._canvas.restore_region(self._still)  # type: ignore[no-untyped-call]
            self._paste(painted)
            for artist in self._moving:
                artist.axes.draw_artist(artist) if artist.axes else self._canvas.figure.draw_artist(artist)
        drawn: Picture = np.asarray(self._canvas.buffer_rgba())[..., :3]  # type: ignore[no-untyped-call]
        return drawn

    def _paste(self, painted: PaintedShape) -> None:
        """Draw the structure onto the fixed parts, below words and cursors."""
        pixels = np.asarray(self._canvas.buffer_rgba())[::-1]  # type: ignore[no-untyped-call]
        size = np.array(pixels.shape[1::-1])
        low, high = self._axes.transData.transform(painted.corners)
        first, last = (np.clip(item, 0, size).astype(int) for item in (np.floor(low), np.ceil(high)))
        start, beside = self._axes.transData.inverted().transform([first, first + 1])
        width, height = (last - first).tolist()
        drawn = painted.picture(start, float(beside[0] - start[0]), (width, height))[::-1]
        under, opacity = pixels[first[1] : last[1], first[0] : last[0], :3], drawn[..., 3:] / np.float32(255)
        under[:] = np.rint(opacity * drawn[..., :3] + (1 - opacity) * under)

    def _largest_strain(self, cuts: tuple[FilmCut, ...]) -> float:
        """Return the largest strain of a face at the samples of the film."""
        times = self._record.time
        shown = times[(times >= cuts[0].first) & (times <= cuts[-1].last)]
        surfaces = (surface_at(self._record, self._shape, float(time)) for time in shown)
        return max((float(face_strains(self._shape, surface).max(initial=0.0)) for surface in surfaces), default=0.0)

    def _corners(self, cuts: tuple[FilmCut, ...]) -> Array:
        """Return all positions of the structure's parts in the picture, m, (point, 2)."""
        times = np.concatenate([np.linspace(cut.first, cut.last, 25) for cut in cuts])
        surfaces = [surface_at(self._record, self._shape, time) for time in times]
        drawn = [np.concatenate([surface.bars.reshape(-1, 3), surface.faces.reshape(-1, 3)]) for surface in surfaces]
        flat, radius = self._view.project(np.concatenate(drawn)), self._shape.thickness / 2
        return np.concatenate([flat - radius, flat + radius])


def _picture_axes(figure: Figure, corners: Array, size: tuple[int, int], height: float) -> Axes:
    """Return axes of a height, in shares of the frame, that contain all positions, with a scale bar."""
    axes = figure.add_axes((*_PICTURE[:3], height))
    axes.set_axis_off()
    low, high = corners.min(axis=0), corners.max(axis=0)
    middle, extent = (low + high) / 2, high - low
    shape = _PICTURE[2] * size[0] / (height * size[1])
    half = max(extent[0], extent[1] * shape) / 2 * np.array([1.0, 1 / shape]) * 1.02
    axes.set(xlim=(middle[0] - half[0], middle[0] + half[0]), ylim=(middle[1] - half[1], middle[1] + half[1]))
    bar = round_below(extent[0] / 4)
    left, foot = middle - 0.97 * half
    axes.plot([left, left + bar], [foot, foot], color="black", lw=1.5, solid_capstyle="butt")
    axes.text(left + bar / 2, foot + 0.03 * half[1], show_value(bar, "m"), ha="center", va="bottom")
    return axes


def _plots(figure: Figure, record: Record, cuts: tuple[FilmCut, ...]) -> list[tuple[FilmCut, float, Line2D]]:
    """Draw the energy over the time of every move, side by side; return the part, the factor from s, and the cursor."""
    moves = [cut for cut in cuts if cut.slowed is not None]
    energies = _energies(record)
    unit, factor = reading_unit("J", max(_largest(record, values, cuts) for values, _ in energies.values()))
    width = (_PLOTS_RIGHT - _PLOTS_LEFT - _PLOTS_GAP * (len(moves) - 1)) / len(moves)
    cursors: list[tuple[FilmCut, float, Line2D]] = []
    first: Axes | None = None
    for place, cut in enumerate(moves):
        left = _PLOTS_LEFT + place * (width + _PLOTS_GAP)
        axes = figure.add_axes((left, _PLOTS_LOW, width, _PLOTS_HIGH - _PLOTS_LOW), sharey=first)
        lasts = cut.last - cut.first
        time_unit, scale = reading_unit("s", _HALF * lasts)
        rows = (record.time >= cut.first - _LEAD * lasts) & (record.time <= cut.last + _LEAD * lasts)
        time = scale * (record.time[rows] - _zero(cut))
        for (values, colour), style in zip(energies.values(), LINE_STYLES, strict=False):
            axes.plot(time, factor * values[rows], style, color=colour)
        axes.set_xlim(scale * (cut.first - _LEAD * lasts - _zero(cut)), scale * (cut.last + _LEAD * lasts - _zero(cut)))
        axes.set_title(cut.words, fontsize=7, pad=2)
        axes.set_xlabel(f"time ({time_unit})", fontsize=7, labelpad=1)
        if first is None:
            first = axes
            axes.set_ylabel(f"energy ({unit})", fontsize=7)
        else:
            axes.tick_params(labelleft=False)
        cursors.append((cut, scale, axes.axvline(0, color="black", lw=0.9)))
    return cursors


def _zero(cut: FilmCut) -> float:
    """Return the zero of a plot's time, s in the run."""
    return cut.stage.start if cut.stage is not None else 0.0


def _colour_bar(figure: Figure, norm: Normalize) -> None:
    unit, factor = reading_unit("J", float(norm.vmax or 1.0))
    axes = figure.add_axes(_BAR)
    scaled = Normalize(0, factor * float(norm.vmax or 1.0))
    bar = figure.colorbar(ScalarMappable(scaled, ENERGY_COLOURS), cax=axes, orientation="horizontal")
    bar.outline.set_visible(False)
    bar.ax.tick_params(length=2, pad=1)
    bar.set_label(f"energy of a tendon ({unit})", fontsize=7, labelpad=1)


def _strain_bar(figure: Figure, norm: Normalize) -> None:
    axes = figure.add_axes(_STRAIN_BAR)
    scaled = Normalize(0, 100 * float(norm.vmax or 0.0))
    bar = figure.colorbar(ScalarMappable(scaled, STRAIN_COLOURS), cax=axes, orientation="horizontal")
    bar.outline.set_visible(False)
    bar.ax.tick_params(length=2, pad=1)
    bar.set_label("Green strain of the membrane (%)", fontsize=7, labelpad=1)


def _energies(record: Record) -> dict[str, tuple[Array, str]]:
    """Return the energies to plot, J, (time,), with colours: elastic ones; the kinetic energy without any."""
    stored = stored_energies(record)
    elastic = ("tendons", "membrane", springs_name(record.structure), *hinge_groups(record.structure))
    springs = [name for name in stored if name in elastic]
    return {name: stored[name] for name in springs or ["kinetic"]}


def _key(figure: Figure, shape: Shape, record: Record, strain: bool) -> None:
    """Draw the legend."""
    axes = figure.add_axes(_KEY)
    axes.set_axis_off()
    every = shape_handles(shape, record.structure, ENERGY_COLOURS(0.95), 2.4)
    handles = [item for item in every if not (strain and isinstance(item, Patch))]
    for (name, (_, colour)), style in zip(_energies(record).items(), LINE_STYLES, strict=False):
        of = f"{'energy ' * (style == LINE_STYLES[0])}of the {name}"
        label = "kinetic energy" if name == "kinetic" else of
        handles.append(Line2D([], [], color=colour, ls=style, label=label))
    # a long legend extends upwards beside the picture
    many = len(handles) > _MOST_ENTRIES
    axes.legend(
        handles=handles,
        loc="lower left" if many else "center left",
        borderaxespad=0,
        handlelength=1.6,
        labelspacing=0.2 if many else 0.5,
    )


def _clock_text(cut: FilmCut, time: float) -> str:
    """Return the time, with a resolution of a thousandth of the part, and the speed of the film."""
    if cut.slowed is None:
        unit, factor = reading_unit("s", cut.last)
        return f"{factor * time:.{_decimals(factor * cut.last)}f} {unit}"
    unit, factor = reading_unit("s", _HALF * (cut.last - cut.first))
    slower = f"{cut.slowed:.3g} times slower" if cut.slowed >= 1 else f"{1 / cut.slowed:.3g} times faster"
    return f"{factor * (time - _zero(cut)):.{_decimals(factor * (cut.last - cut.first))}f} {unit}, {slower}"


def _order_text(record: Record, cut: FilmCut) -> str:
    """Return when groups of hinges pass the middle of their travel, if they move one after another."""
    if cut.stage is None or cut.slowed is None:
        return ""
    stage = record.stages.index(cut.stage)
    motions = ordered_motions(record, stage)
    if not motions:
        return ""
    moments = moment_texts(record, stage, [motion.middle for motion in motions])
    groups = (f"{motion.group} at {moment}" for motion, moment in zip(motions, moments, strict=True))
    return textwrap.fill(f"half-way: {', '.join(groups)}", _ORDER_LETTERS)


def _decimals(largest: float) -> int:
    return max(0, 2 - math.floor(math.log10(largest))) if largest > 0 else 0


def _largest(record: Record, values: Array, cuts: tuple[FilmCut, ...]) -> float:
    """Return the largest value of a series, (time, ...), within the film."""
    rows = (record.time >= cuts[0].first) & (record.time <= cuts[-1].last)
    return float(np.nanmax(values[rows], initial=0.0))
