"""The wing in space at a few moments of a run."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from forficula.analysis import Outcome
from forficula.design.places import mesh_rows, tendon_ends
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit
from forficula.show.style import ORANGE, PAGE_WIDTH, figure_style

Array = NDArray[np.float64]

_PROXIMAL, _DISTAL = "#DDCBA4", "#8FB8D8"
_LIGHT = np.array([0.25, -0.35, 0.9])
_ELEVATION, _AZIMUTH = np.radians(38.0), np.radians(-62.0)


def draw_folding(record: Record, outcome: Outcome) -> Figure:
    """Draw the wing flat, on its way, folded, on its way back and opened, all at one scale and from one side."""
    moments = _moments(record, outcome)
    with figure_style():
        columns = 4
        times = _time_texts([time for _, time in moments])
        rows = -(-(len(moments) + 1) // columns)  # one place for the legend
        drawn = [_scene(record, time) for _, time in moments]
        corners = np.concatenate([np.concatenate(polygons) for polygons, _, _, _ in drawn])
        low, high = corners.min(axis=0), corners.max(axis=0)
        aspect = (high - low)[1] / (high - low)[0]
        width = PAGE_WIDTH / columns
        figure = Figure(figsize=(PAGE_WIDTH, rows * (width * aspect + 0.25)), layout="constrained")
        for axes, (name, time), scene in zip(
            np.ravel(figure.subplots(rows, columns, squeeze=False)), moments, drawn, strict=False
        ):
            polygons, colours, veins, tendons = scene
            axes.add_collection(PolyCollection(polygons, facecolors=colours, edgecolors="0.35", linewidths=0.3))
            axes.add_collection(LineCollection(veins, colors="0.15", linewidths=1.3, capstyle="round"))
            axes.add_collection(LineCollection(tendons, colors=ORANGE, linewidths=1.0))
            axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
            axes.set_title(f"{name}, {times[time]}", pad=2)
        for axes in figure.axes:
            axes.set_axis_off()
        _legend(figure.axes[len(moments)], high - low, low)
        return figure


def _legend(axes: Axes, size: Array, low: Array) -> None:
    """What the colours mean, and a scale bar of about a third of the picture."""
    axes.set(xlim=(low[0], low[0] + size[0]), ylim=(low[1], low[1] + size[1]), aspect="equal")
    bar = 10.0 ** np.floor(np.log10(size[0] / 2))
    bar *= next(steps for steps in (5, 2, 1) if steps * bar <= size[0] / 2)
    left, height = low[0] + 0.15 * size[0], low[1] + 0.12 * size[1]
    axes.plot([left, left + bar], [height, height], color="black", lw=1.5)
    unit, factor = reading_unit("m", bar)
    axes.text(left + bar / 2, height + 0.04 * size[1], f"{factor * bar:.4g} {unit}", ha="center", va="bottom")
    axes.legend(
        handles=[
            Patch(facecolor=_PROXIMAL, edgecolor="0.35", label="proximal panel"),
            Patch(facecolor=_DISTAL, edgecolor="0.35", label="distal panel"),
            Line2D([], [], color="0.15", lw=1.3, label="vein"),
            Line2D([], [], color=ORANGE, lw=1.0, label="tendon"),
        ],
        loc="upper left",
    )


def _moments(record: Record, outcome: Outcome) -> list[tuple[str, float]]:
    """Names and times: the states, and between them moments at equal progress of the fold."""
    moments: list[tuple[str, float]] = []
    for state, name, drive in (
        (outcome.flat, "a flat", "fold"),
        (outcome.folded_state, "b folded" if outcome.folded else "not folded", "unfold"),
        (outcome.opened_state, "c opened" if outcome.opened else "not opened", None),
    ):
        if state is not None:
            moments.append((name, state.time))
        for end in record.stages:
            if end.stage.drive == drive:
                moments += [(end.stage.name, time) for time in _halfway(record, end)]
    return moments or [("start", 0.0), ("last", float(record.data.time[-1]))]


def _time_texts(times: list[float]) -> dict[float, str]:
    """Times in one unit, with four significant digits or as many as tell them apart."""
    unit, factor = reading_unit("s", max(times))
    for digits in range(4, 18):
        texts = {time: f"{factor * time:#.{digits}g} {unit}" for time in times}
        if len(set(texts.values())) == len(texts):
            break
    return texts


def _halfway(record: Record, end: StageEnd) -> list[float]:
    """Times in a stage at which the fold has gone a third and two thirds of its way there."""
    window = record.data.sel(time=slice(end.start, end.end))
    progress = (window["turn_angle"].mean("vein") * 2 - window["distal_angle"].mean("vein")).values
    done = np.maximum.accumulate(np.abs(progress - progress[0]))
    return [float(window.time[int(np.searchsorted(done, share * done[-1]))]) for share in (1 / 3, 2 / 3)]


def _scene(record: Record, time: float) -> tuple[list[Array], list[tuple[float, ...]], list[Array], list[Array]]:
    """Projected panels, back to front, with their shades; projected bars; projected tendons."""
    now = record.data.sel(time=time, method="nearest")
    veins, nodes = now["vein_position"].values, now["membrane_position"].values
    hub, ring, tip = veins[:, 0], veins[:, 1], veins[:, 2]
    membrane = record.design.membrane
    rows = len(membrane.proximal_rows) + len(membrane.distal_rows) + 2
    nodes = nodes.reshape(len(veins) - 1, rows, 2, 3)
    quads, tints = [], []
    for panel in range(len(veins) - 1):
        along = mesh_rows(hub[panel], ring[panel], tip[panel], record.design)
        for row in range(rows - 1):
            tint = _PROXIMAL if row < len(membrane.proximal_rows) else _DISTAL
            edge, far = nodes[panel, :, 0], nodes[panel, :, 1]
            # the strip between vein and margin is wing, too
            for near, beyond in ((along, edge), (edge, far)):
                quads.append(np.array([near[row], near[row + 1], beyond[row + 1], beyond[row]]))
                tints.append(tint)
    order = np.argsort([_depth(quad.mean(axis=0)) for quad in quads])
    tendons = zip(*tendon_ends(hub, ring, tip, record.design), strict=True)
    return (
        [_project(quads[index]) for index in order],
        [_shade(quads[index], tints[index]) for index in order],
        [_project(vein) for vein in veins],
        [_project(np.array(pair)) for pair in tendons],
    )


def _project(points: Array) -> Array:
    """Parallel projection, (..., 3) -> (..., 2)."""
    right = np.array([-np.sin(_AZIMUTH), np.cos(_AZIMUTH), 0.0])
    up = np.cross(_towards_eye(), right)
    return np.stack([points @ right, points @ up], axis=-1)


def _towards_eye() -> Array:
    return np.array([np.cos(_ELEVATION) * np.cos(_AZIMUTH), np.cos(_ELEVATION) * np.sin(_AZIMUTH), np.sin(_ELEVATION)])


def _depth(point: Array) -> float:
    return float(point @ _towards_eye())


def _shade(quad: Array, tint: str) -> tuple[float, ...]:
    """Lambert shading of both sides alike."""
    normal = np.cross(quad[2] - quad[0], quad[3] - quad[1])
    length = np.linalg.norm(normal)
    facing = abs(float(normal @ _LIGHT)) / length / np.linalg.norm(_LIGHT) if length > 0 else 0.0
    return (*(np.array(to_rgb(tint)) * (0.55 + 0.45 * facing)), 0.92)
