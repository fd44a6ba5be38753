"""Tables with a drawn bar in each row: shares, intervals and margins that are read at a glance, and as numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from forficula.show.page.parts.html import escaped


@dataclass(frozen=True, kw_only=True)
class ShareBar:
    """Bar on the scale that all bars of its column share.

    Attributes:
        start: value at which the bar begins.
        end: value at which the bar ends; it is cut at the end of the scale.
        low: lower end of the interval about `end`; equal to `end` without an interval.
        high: upper end of that interval.
        kind: how the bar looks: "first", "second", "good", "bad" or "open" (without a definite end).
    """

    start: float
    end: float
    low: float
    high: float
    kind: str


@dataclass(frozen=True, kw_only=True)
class BarRow:
    """Row of a table with bars.

    Attributes:
        name: text of the row's first cell.
        lanes: bars by lane, from the top down.
        cells: the same values as text.
        note: smaller text under the name.
    """

    name: str
    lanes: tuple[tuple[ShareBar, ...], ...]
    cells: tuple[str, ...]
    note: str = ""


def bar(end: float, kind: str, *, start: float = 0.0, interval: tuple[float, float] | None = None) -> ShareBar:
    """Return a bar; an interval with an end that is not finite is left out."""
    low, high = interval if interval is not None and all(map(math.isfinite, interval)) else (end, end)
    return ShareBar(start=start, end=end, low=low, high=high, kind=kind)


def percent_text(share: float) -> str:
    """Return a share in per cent to three digits, without the per cent sign."""
    return f"{100 * share:.3g}".replace("-", "−")


def bar_table(
    caption: str, headings: Sequence[str], rows: Sequence[BarRow], scale: tuple[float, float], zero: float = 0.0
) -> str:
    """Return the HTML of a table whose second column contains bars.

    Args:
        caption: text above the table.
        headings: one for each column: the names, the bars, then the other cells.
        rows: rows, each with one cell for every heading after the second.
        scale: lowest and highest value that the bars can show.
        zero: value at which a vertical line crosses all rows, such as a required value.
    """
    head = "".join(f'<th scope="col">{escaped(heading)}</th>' if heading else "<td></td>" for heading in headings)
    line = _percent_along(zero, scale)
    body = "".join(_row(row, scale, line) for row in rows)
    name = caption or ", ".join(filter(None, headings))
    return (
        f'<div class="table" tabindex="0" role="group" aria-label="{escaped(name)}"><table class="numbers bars">'
        f"<caption>{escaped(caption)}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def _row(row: BarRow, scale: tuple[float, float], line: float) -> str:
    note = f"<small>{escaped(row.note)}</small>" if row.note else ""
    lanes = ("".join(_drawn_bar(bar, scale) for bar in lane if not math.isnan(bar.end)) for lane in row.lanes)
    drawn = "".join(f'<span class="lane">{bars}</span>' for bars in lanes)
    cells = "".join(f"<td>{escaped(cell)}</td>" for cell in row.cells)
    drawing = f'<span class="drawn-bars" style="--line:{line:.2f}%" aria-hidden="true">{drawn}</span>'
    return f'<tr><th scope="row">{escaped(row.name)}{note}</th><td>{drawing}</td>{cells}</tr>'


def _drawn_bar(bar: ShareBar, scale: tuple[float, float]) -> str:
    start, end = sorted((_percent_along(bar.start, scale), _percent_along(bar.end, scale)))
    low, high = _percent_along(bar.low, scale), _percent_along(bar.high, scale)
    # an interval that exceeds the scale is drawn without an end mark
    cut = "cut" if bar.high > scale[1] else ""
    whisker = f'<i class="{cut}" style="left:{low:.2f}%;width:{high - low:.2f}%"></i>' if high > low else ""
    return f'<b class="{bar.kind}" style="left:{start:.2f}%;width:{end - start:.2f}%"></b>{whisker}'


def _percent_along(value: float, scale: tuple[float, float]) -> float:
    low, high = scale
    return 100.0 * min(max((value - low) / (high - low), 0.0), 1.0)
