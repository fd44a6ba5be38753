"""A crease pattern: its creases, and the vertices that do not fold flat with their deviations."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patheffects import Normal, Stroke

from forficula.pattern import (
    ASSIGNMENTS,
    CreasePattern,
    PatternFacts,
    VertexCreases,
    VertexFacts,
    fault_labels,
    vertex_creases,
)
from forficula.quantities import reading_unit, show_value
from forficula.show.structure.crease_lines import add_sheet_legend, draw_creases, sheet_axes
from forficula.show.structure.flat_net import FlatNet, flat_net
from forficula.show.style import PAGE_WIDTH, PURPLE, describe, figure_style

_MOST_LABELS = 8
_LETTER, _LINE = 4.2, 9.5  # pt, slightly more than the width of a letter and the height of a line
_AWAY = 7.0  # pt, distance of a label from its vertex
_ASIDE = 0.4  # sine of a direction above which labels are above, or below, the vertex
_RING, _MANY = 7.0, 50  # diameter of a ring, pt; number of vertices from which it is halved
_BESIDE = 0.8  # inch of the figure's width outside the axes


def draw_sheet(pattern: CreasePattern, facts: PatternFacts, width: float = PAGE_WIDTH) -> Figure:
    """Draw a crease pattern, laid flat.

    Rings mark vertices that do not fold flat. Labels at the worst ones give the deviation of the sum of alternate
    sectors, an odd number of creases, or the difference of mountains and valleys.

    Args:
        pattern: the pattern.
        facts: facts about the pattern.
        width: largest width of the figure, inch.
    """
    faults = sorted((item for item in facts.inside if fault_labels(item)), key=_weight, reverse=True)
    net, (unit, factor) = flat_net(pattern), reading_unit("m", max(facts.size))
    with figure_style():
        figure, axes = sheet_axes(factor * net.pattern.vertices_coords, factor * max(facts.size), unit, width)
        handles = draw_creases(axes, net, factor)
        if net.view:
            axes.set_xlabel(f"{axes.get_xlabel()}, {net.view}")
        if faults:
            handles.append(_mark(axes, net, faults, factor, figure.get_figwidth()))
        add_sheet_legend(figure, handles, 4)
        return describe(figure, _text(facts, faults))


def _weight(vertex: VertexFacts) -> tuple[float, int]:
    """Return the sort key of a vertex: an odd number of creases first, then by falling deviation."""
    lacks = vertex.missing if vertex.check is not None and vertex.missing > vertex.check.allowed else 0.0
    return lacks, -vertex.vertex


def _mark(axes: Axes, net: FlatNet, faults: list[VertexFacts], factor: float, width: float) -> Line2D:
    """Mark vertices with rings, and label as many as fit into a width, inch; return the legend's entry."""
    pattern, points = net.built, factor * net.places(net.built.vertices_coords)
    rings, many = points[[fault.vertex for fault in faults]], len(faults) > _MANY
    wide = _RING / 2 if many else _RING
    axes.plot(*rings.T, "o", ms=wide, mec=PURPLE, mfc="none", mew=0.6 if many else 1.2, zorder=3)
    low, size = points.min(axis=0), np.ptp(points, axis=0)
    across = 72 * (width - _BESIDE)
    around = {crease.vertex: crease for crease in vertex_creases(pattern)}
    taken: list[tuple[float, float, float, float]] = []
    for fault, place in zip(faults, (rings - low) * across / size[0], strict=True):
        words = "\n".join(fault_labels(fault))
        x, y = _towards(pattern, around[fault.vertex], inwards=float(np.sign(across / 2 - place[0])))
        long, tall = _LETTER * max(map(len, words.split("\n"))), _LINE * (words.count("\n") + 1)
        left = place[0] + _AWAY * x - (long if x < 0 else 0.0)
        bottom = place[1] + _AWAY * y - (0.0 if y > _ASIDE else tall if y < -_ASIDE else tall / 2)
        box = (left, left + long, bottom, bottom + tall)
        if left < 0 or left + long > across or any(_meet(box, other) for other in taken):
            continue
        taken.append(box)
        axes.plot(*points[fault.vertex], "o", ms=wide, mec=PURPLE, mfc=PURPLE, zorder=3)
        axes.annotate(
            words,
            points[fault.vertex],
            (_AWAY * x, _AWAY * y),
            textcoords="offset points",
            ha="right" if x < 0 else "left",
            va="bottom" if y > _ASIDE else "top" if y < -_ASIDE else "center",
            fontsize=7,
            path_effects=[Stroke(linewidth=2, foreground="white"), Normal()],
            zorder=4,
        )
        if len(taken) == _MOST_LABELS:
            break
    fill = PURPLE if len(taken) == len(faults) else "none"
    label = f"does not fold flat ({len(faults)})"
    return Line2D([], [], marker="o", ls="none", ms=wide, mec=PURPLE, mfc=fill, label=label)


def _towards(pattern: CreasePattern, around: VertexCreases, inwards: float) -> tuple[float, float]:
    """Return the direction with most space for a label; of equal sectors the one towards the centre."""
    if len(around.edges) == 0:
        return 1.0, 0.0
    first = pattern.vertices_coords[pattern.edges_vertices[around.edges[0]].sum() - around.vertex]
    along = first - pattern.vertices_coords[around.vertex]
    starts = math.atan2(along[1], along[0]) + np.concatenate([[0.0], np.cumsum(around.sectors[:-1])])
    middles = starts + around.sectors / 2
    best = int(np.argmax(np.round(around.sectors, 2) + 0.1 * inwards * np.cos(middles)))
    return math.cos(middles[best]), math.sin(middles[best])


def _meet(one: tuple[float, float, float, float], other: tuple[float, float, float, float]) -> bool:
    """Return whether two boxes (left, right, bottom, top) overlap."""
    return one[0] < other[1] and other[0] < one[1] and one[2] < other[3] and other[2] < one[3]


def _text(facts: PatternFacts, faults: list[VertexFacts]) -> str:
    """Describe the sheet."""
    edges = ", ".join(f"{count} {ASSIGNMENTS[letter]}" for letter, count in facts.edges.items())
    size = " by ".join(show_value(length, "m") for length in facts.size[: 2 if facts.flat else 3])
    drawn_as = "" if facts.flat else " The sheet is folded, and drawn unfolded."
    verdict = "Every interior vertex folds flat." if facts.flat else ""
    if faults:
        worst = max((fault.missing for fault in faults if math.isfinite(fault.missing)), default=0.0)
        lacks = f", by up to {math.degrees(worst):.2g} deg" if worst > 1e-6 else ""
        verdict = f"{len(faults)} of {len(facts.inside)} interior vertices do not fold flat{lacks}."
    title = facts.title[:1].upper() + facts.title[1:]
    return f"{title}, {size}.{drawn_as} Edges: {edges}. {verdict}".rstrip()
