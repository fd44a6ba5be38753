"""The crease pattern with its tendons."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.design import Design
from forficula.design.places import tendon_ends
from forficula.pattern import CreasePattern, earwig_pattern, hub_points, ring_vertices, tips
from forficula.quantities import reading_unit, show_value
from forficula.show.style import BLACK, BLUE, ORANGE, PAGE_WIDTH, VERMILION, describe, figure_style, is_narrow

_STYLES = {"M": (VERMILION, "-.", "mountain"), "V": (BLUE, "--", "valley"), "B": (BLACK, "-", "border")}
_WIDEST = 4.6  # inch: it has one part, which a page would only blow up


def draw_pattern(design: Design, width: float = PAGE_WIDTH) -> Figure:
    """Draw the crease pattern of a design, its hub circle and its tendons, at most as wide as `width` in inch."""
    fan = design.fan
    pattern = earwig_pattern(fan)
    unit, factor = reading_unit("m", float(np.abs(pattern.vertices_coords).max()))
    points = factor * pattern.vertices_coords[:, :2]
    with figure_style():
        extent = np.ptp(points, axis=0)
        width = min(width, _WIDEST)
        tall = min(2.0, max(0.3, extent[1] / extent[0]))
        figure = Figure(figsize=(width, (width - 0.5) * tall + 0.9), layout="constrained")
        axes = figure.subplots()
        for (start, end), assignment in zip(pattern.edges_vertices, pattern.edges_assignment, strict=True):
            colour, style, _ = _STYLES[assignment]
            axes.plot(*points[[start, end]].T, style, color=colour, lw=1.1)
        angle = np.linspace(0, 2 * np.pi, 200)
        radius = factor * fan.hub_radius
        axes.plot(radius * np.cos(angle), radius * np.sin(angle), ":", color="0.5", lw=0.8)
        for start, end in zip(*tendon_ends(hub_points(fan), ring_vertices(fan), tips(fan), design), strict=True):
            axes.plot(*factor * np.column_stack([start, end])[:2], "o-", color=ORANGE, ms=3.5, lw=3, alpha=0.6)
        for vein, tip in enumerate(factor * tips(fan)[:, :2]):
            outwards = tip / np.linalg.norm(tip)
            axes.annotate(f"{vein}", tip, 8 * outwards, textcoords="offset points", ha="center", va="center")
        axes.set_aspect("equal")
        axes.set_xlabel(f"x ({unit})")
        axes.set_ylabel(f"y ({unit})")
        axes.margins(0.06)
        handles = [Line2D([], [], color=colour, ls=style, label=name) for colour, style, name in _STYLES.values()]
        handles.append(Line2D([], [], color=ORANGE, marker="o", ms=3.5, lw=3, alpha=0.6, label="tendon"))
        handles.append(Line2D([], [], color="0.5", ls=":", label="hub"))
        figure.legend(handles=handles, loc="outside upper center", ncols=3 if is_narrow(width) else 5)
        return describe(figure, _tell(design, pattern))


def _tell(design: Design, pattern: CreasePattern) -> str:
    """The pattern in words."""
    counts = {name: sum(each == kind for each in pattern.edges_assignment) for kind, (_, _, name) in _STYLES.items()}
    creases = f"{counts['mountain']} mountain and {counts['valley']} valley creases"
    lengths = ", ".join(
        f"{name} {show_value(length, 'm')}"
        for name, length in (
            ("proximal length", design.pattern.proximal_length),
            ("distal length", design.pattern.distal_length),
            ("hub radius", design.pattern.hub_radius),
        )
    )
    return (
        f"Crease pattern of {design.name}: {design.fan.vein_count} veins, {creases}. {lengths[0].upper()}{lengths[1:]}."
    )
