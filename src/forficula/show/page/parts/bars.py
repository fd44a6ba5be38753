"""Tables with a drawn bar in each row: shares, intervals and margins that are read at a glance, and as numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from forficula.show.page.parts.html import escaped


@dataclass(frozen=True, kw_only=True)
class ShareBar:
    """A bar on a scale that all of its column share.

    Attributes:
        start: where it begins.
        end: where it ends; beyond the scale it is cut off.
        low: lower end of the interval about its end; as `end` where there is none.
        high: upper end.
        kind: "first", "second", "good", "bad" or "open", of what has no end, which have looks of their own.
    """

    start: float
    end: float
    low: float
    high: float
    kind: str


@dataclass(frozen=True, kw_only=True)
class BarRow:
    """A row of a table.

    Attributes:
        name: what it is of.
        lanes: bars, lane below lane.
        cells: that tell them in numbers.
        note: under the name, smaller.
    """

    name: str
    lanes: tuple[tuple[ShareBar, ...], ...]
    cells: tuple[str, ...]
    note: str = ""


def bar(end: float, kind: str, *, start: float = 0.0, interval: tuple[float, float] | None = None) -> ShareBar:
    """A bar, from 0 where nothing else is said; without an interval where its ends are not finite."""
    low, high = interval if interval is not None and all(map(math.isfinite, interval)) else (end, end)
    return ShareBar(start=start, end=end, low=low, high=high, kind=kind)


def percent_text(share: float) -> str:
    """A share in per cent, without its sign, to three digits."""
    return f"{100 * share:.3g}".replace("-", "−")


def bar_table(
    caption: str, headings: Sequence[str], rows: Sequence[BarRow], scale: tuple[float, float], zero: float = 0.0
) -> str:
    """A table whose second column has bars.

    Args:
        caption: above it.
        headings: one a column: of the names, of the bars, of each cell.
        rows: all with as many cells as there are headings for.
        scale: the ends of what the bars can show.
        zero: where a line across all rows stands, such as what is needed.
    """
    head = "".join(f'<th scope="col">{escaped(each)}</th>' if each else "<td></td>" for each in headings)
    line = _share(zero, scale)
    body = "".join(_row(row, scale, line) for row in rows)
    name = caption or ", ".join(filter(None, headings))
    return (
        f'<div class="table" tabindex="0" role="group" aria-label="{escaped(name)}"><table class="numbers bars">'
        f"<caption>{escaped(caption)}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def _row(row: BarRow, scale: tuple[float, float], line: float) -> str:
    note = f"<small>{escaped(row.note)}</small>" if row.note else ""
    lanes = ("".join(_drawn(each, scale) for each in lane if not math.isnan(each.end)) for lane in row.lanes)
    drawn = "".join(f'<span class="lane">{bars}</span>' for bars in lanes)
    cells = "".join(f"<td>{escaped(cell)}</td>" for cell in row.cells)
    place = f'<span class="drawn-bars" style="--line:{line:.2f}%" aria-hidden="true">{drawn}</span>'
    return f'<tr><th scope="row">{escaped(row.name)}{note}</th><td>{place}</td>{cells}</tr>'


def _drawn(bar: ShareBar, scale: tuple[float, float]) -> str:
    start, end = sorted((_share(bar.start, scale), _share(bar.end, scale)))
    low, high = _share(bar.low, scale), _share(bar.high, scale)
    # an interval that goes on beyond the scale has no end there
    cut = "cut" if bar.high > scale[1] else ""
    about = f'<i class="{cut}" style="left:{low:.2f}%;width:{high - low:.2f}%"></i>' if high > low else ""
    return f'<b class="{bar.kind}" style="left:{start:.2f}%;width:{end - start:.2f}%"></b>{about}'


def _share(value: float, scale: tuple[float, float]) -> float:
    low, high = scale
    return 100.0 * min(max((value - low) / (high - low), 0.0), 1.0)
