"""What a page of maps shows, in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from forficula.show.study.map_panel import Panel


def maps_text(
    quantity: str,
    factors: Sequence[str],
    panels: Sequence[Panel],
    units: Sequence[tuple[str, float]],
    *,
    whole: str,
) -> str:
    """Tell what maps show.

    Args:
        quantity: that they show; empty where they show verdicts.
        factors: names of the factors that they are drawn over.
        panels: that are drawn.
        units: of each, in which its values are told, and their factors from SI.
        whole: what sentences call what was run.
    """
    what = f"Maps of the {quantity}" if quantity else f"Map of what became of every {whole}"
    told = "; ".join(_panel_text(panel, *unit) for panel, unit in zip(panels, units, strict=True))
    return f"{what} over {' and '.join(factors)}. {told[:1].upper()}{told[1:]}."


def _panel_text(panel: Panel, unit: str, factor: float) -> str:
    """How many values there are, from where to where, and how many are missing, by reason."""
    values = panel.values.values.astype(float)
    absent = ~np.isfinite(values)
    words, counts = np.unique(
        panel.reasons.transpose(*panel.values.dims).values[absent].astype(str), return_counts=True
    )
    parts = [f"{count} {word}" for word, count in zip(words.tolist(), counts.tolist(), strict=True)]
    if not absent.all():
        present = factor * values[~absent]
        ends = dict.fromkeys(f"{end:.3g}" for end in (present.min(), present.max()))
        parts.insert(0, f"{present.size} of {values.size} have one, {' to '.join(ends)} {unit}".rstrip())
    return f"{panel.title}: {', '.join(parts)}"
