"""The wing in space at a few moments of a run."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from forficula.analysis import Outcome
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit
from forficula.show.structure.painted_wing import DISTAL, PROXIMAL, VEIN, PaintedWing, paint_wing, wing_view
from forficula.show.structure.wing_surface import wing_surface
from forficula.show.style import ORANGE, PAGE_WIDTH, describe, figure_style, is_narrow

Array = NDArray[np.float64]

_CELLS = 16  # to the length of a vein: the more, the larger the file


def draw_folding(record: Record, outcome: Outcome, width: float = PAGE_WIDTH) -> Figure:
    """Draw the wing flat, on its way, folded, on its way back and opened, all at one scale and from one side.

    Args:
        record: what happened.
        outcome: what it means.
        width: of the figure, inch.
    """
    moments = _moments(record, outcome)
    with figure_style():
        columns = 2 if is_narrow(width) else 4
        times = time_texts([time for _, time in moments])
        rows = -(-(len(moments) + 1) // columns)  # one place for the legend
        drawn = [_painted(record, time) for _, time in moments]
        corners = np.concatenate([wing.polygons.reshape(-1, 2) for wing in drawn])
        low, high = corners.min(axis=0), corners.max(axis=0)
        height = width / columns * (high - low)[1] / (high - low)[0]
        figure = Figure(figsize=(width, rows * (height + 0.25)), layout="constrained")
        for axes, (name, time), wing in zip(
            np.ravel(figure.subplots(rows, columns, squeeze=False)), moments, drawn, strict=False
        ):
            # edges of the same colour, or else seams show between the polygons
            axes.add_collection(
                PolyCollection(list(wing.polygons), facecolors=wing.colours, edgecolors="face", linewidths=0.3)
            )
            axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
            axes.set_title(f"{name}, {times[time]}", pad=2)
        for axes in figure.axes:
            axes.set_axis_off()
        _legend(figure.axes[len(moments)], high - low, low)
        told = "; ".join(f"{name} at {times[time]}" for name, time in moments)
        return describe(figure, f"The wing {record.design.name} in space at {len(moments)} moments of a run. {told}.")


def time_texts(times: list[float]) -> dict[float, str]:
    """Times (s) in one unit, with four significant digits or as many as tell them apart."""
    unit, factor = reading_unit("s", max(times))
    for digits in range(4, 18):
        texts = {time: f"{factor * time:#.{digits}g} {unit}" for time in times}
        if len(set(texts.values())) == len(texts):
            break
    return texts


def _painted(record: Record, time: float) -> PaintedWing:
    design = record.design
    return paint_wing(wing_surface(record, time), design, wing_view(design), ORANGE, cells=_CELLS)


def _legend(axes: Axes, size: Array, low: Array) -> None:
    """What the colours mean, and a scale bar of about a third of the picture."""
    axes.set(xlim=(low[0], low[0] + size[0]), ylim=(low[1], low[1] + size[1]), aspect="equal")
    bar = 10.0 ** np.floor(np.log10(size[0] / 2))
    bar *= next(steps for steps in (5, 2, 1) if steps * bar <= size[0] / 2)
    left, height = low[0] + 0.15 * size[0], low[1] + 0.05 * size[1]
    axes.plot([left, left + bar], [height, height], color="black", lw=1.5)
    unit, factor = reading_unit("m", bar)
    axes.text(left + bar / 2, height + 0.04 * size[1], f"{factor * bar:.4g} {unit}", ha="center", va="bottom")
    axes.legend(
        handles=[
            Patch(facecolor=PROXIMAL, label="proximal panel"),
            Patch(facecolor=DISTAL, label="distal panel"),
            Line2D([], [], color=VEIN, lw=2.0, label="vein"),
            Line2D([], [], color=ORANGE, lw=2.0, label="tendon"),
        ],
        loc="upper left",
        borderaxespad=0,
    )


def _moments(record: Record, outcome: Outcome) -> list[tuple[str, float]]:
    """Names and times: the states, and between them moments at equal progress of the fold."""
    moments: list[tuple[str, float]] = []
    for state, name, drive in (
        (outcome.flat, f"a {outcome.flat_name}", "fold"),
        (outcome.folded_state, "b folded" if outcome.folded else outcome.folded_name, "unfold"),
        (outcome.opened_state, "c opened" if outcome.opened else outcome.opened_name, None),
    ):
        if state is not None:
            moments.append((name, state.time))
        for end in record.stages:
            if end.stage.drive == drive:
                moments += [(end.stage.name, time) for time in _halfway(record, end)]
    return moments or [("start", 0.0), ("last", float(record.data.time[-1]))]


def _halfway(record: Record, end: StageEnd) -> list[float]:
    """Times in a stage at which the fold has gone a third and two thirds of its way there."""
    window = record.data.sel(time=slice(end.start, end.end))
    progress = (window["turn_angle"].mean("vein") * 2 - window["distal_angle"].mean("vein")).values
    done = np.maximum.accumulate(np.abs(progress - progress[0]))
    return [float(window.time[int(np.searchsorted(done, share * done[-1]))]) for share in (1 / 3, 2 / 3)]
