"""Descriptions of maps in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from forficula.show.study.map_panel import MapPanel


def maps_text(
    quantity: str,
    factors: Sequence[str],
    panels: Sequence[MapPanel],
    units: Sequence[tuple[str, float]],
    *,
    whole: str,
    shown: str = "",
) -> str:
    """Describe maps.

    Args:
        quantity: quantity that they show; empty for verdicts.
        factors: names of the factors on the axes.
        panels: panels that are drawn.
        units: unit of each panel, with its factor from SI.
        whole: noun for the structure.
        shown: text on what a map of bins shows, or empty.
    """
    what = f"Maps of the {quantity}" if quantity else f"Map of the outcome of every {whole}"
    panel_texts = "; ".join(_panel_text(panel, *unit) for panel, unit in zip(panels, units, strict=True))
    bins = f"{shown}. " if shown else ""
    return f"{what} over {' and '.join(factors)}. {bins}{panel_texts[:1].upper()}{panel_texts[1:]}."


def _panel_text(panel: MapPanel, unit: str, factor: float) -> str:
    """Return the number and range of values, and the number of missing values by reason."""
    values = panel.values.values.astype(float)
    absent = ~np.isfinite(values)
    words, counts = np.unique(
        panel.reasons.transpose(*panel.values.dims).values[absent].astype(str), return_counts=True
    )
    parts = [f"{count} {word}" for word, count in zip(words.tolist(), counts.tolist(), strict=True)]
    if not absent.all():
        present = factor * values[~absent]
        ends = dict.fromkeys(f"{end:.3g}" for end in (present.min(), present.max()))
        parts.insert(0, f"{present.size} of {values.size} have a value, {' to '.join(ends)} {unit}".rstrip())
    return f"{panel.title}: {', '.join(parts)}"
