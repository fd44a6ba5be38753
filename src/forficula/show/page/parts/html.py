"""HTML elements built from text."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

_LONG = 24  # letters of a cell beyond which its text may continue on a second line


@dataclass(frozen=True, kw_only=True)
class Cell:
    """Cell of a table.

    Attributes:
        text: text of the cell.
        note: smaller text under it.
        marked: whether the cell is highlighted.
        failed: whether the cell reports a failure and is red.
    """

    text: str
    note: str = ""
    marked: bool = False
    failed: bool = False


def escaped(text: str) -> str:
    """Escape text for HTML elements and attributes."""
    return html.escape(text, quote=True)


def table(
    caption: str,
    headings: Sequence[str],
    rows: Iterable[Sequence[str | Cell]],
    *,
    groups: Sequence[tuple[str, int]] = (),
    numbers: bool = True,
) -> str:
    """Return the HTML of a table whose first column names the rows.

    Args:
        caption: text above the table.
        headings: one for each column; no head row if all are empty.
        rows: cells; the first cell is the row's name.
        groups: headings above the headings, each with the number of columns that it spans.
        numbers: whether the other columns contain numbers and are aligned right.
    """
    kind = ' class="numbers"' if numbers else ""
    above = "".join(_heading(text, f'colgroup" colspan="{span}') for text, span in groups)
    head = "".join(_heading(heading, "col") for heading in headings)
    above, head = f'<tr class="groups">{above}</tr>' * bool(groups), f"<tr>{head}</tr>" * any(headings)
    body = "".join(_row(cells) for cells in rows)
    titled = f"<caption>{escaped(caption)}</caption>" if caption else ""
    # only a focusable element scrolls by keyboard; the page's script removes the focus from tables that do not scroll
    name = caption or ", ".join(filter(None, headings)) or "table"
    opening_tag = f'<div class="table" tabindex="0" role="group" aria-label="{escaped(name)}">'
    return (
        f"{opening_tag}<table{kind}>{titled}"
        f"{f'<thead>{above}{head}</thead>' * bool(above or head)}<tbody>{body}</tbody></table></div>"
    )


def abreast(parts: Iterable[str], width: float) -> str:
    """Return HTML of parts beside one another where there is space, below one another otherwise; without empty parts.

    Args:
        parts: HTML, such as that of tables.
        width: least width of a part, in letters.
    """
    items = "".join(f"<div>{part}</div>" for part in parts if part)
    return f'<div class="abreast" style="--width: {width:g}rem">{items}</div>' if items else ""


def paragraph(text: str, kind: str = "") -> str:
    """Return a paragraph; empty for no text."""
    return f"<p{f' class={kind}' if kind else ''}>{escaped(text)}</p>" if text else ""


def remarks(sentences: Iterable[str]) -> str:
    """Return a list of sentences with full stops and capitals (except before a key); empty for no sentences."""
    items = "".join(f"<li>{escaped(_sentence(sentence))}</li>" for sentence in sentences)
    return f'<ul class="warnings">{items}</ul>' if items else ""


def section(heading: str, *parts: str, name: str = "") -> str:
    """Return a section under a heading; empty if it has no contents."""
    contents = "".join(parts)
    identity = f' id="{name}"' if name else ""
    return f"<section{identity}><h2>{escaped(heading)}</h2>{contents}</section>\n" if contents else ""


def _sentence(text: str) -> str:
    key = "." in text.partition(" ")[0].rstrip(".,:")
    return f"{(text if key else text[:1].upper() + text[1:]).rstrip('.')}."


def _heading(text: str, scope: str) -> str:
    return f'<th scope="{scope}">{escaped(text)}</th>' if text else "<td></td>"


def _row(cells: Sequence[str | Cell]) -> str:
    first, *others = (Cell(text=cell) if isinstance(cell, str) else cell for cell in cells)
    marked = ' class="changed"' if any(cell.marked for cell in (first, *others)) else ""
    values = "".join(
        f"<td{' class=long' if len(cell.text) > _LONG else ''}>{_cell_contents(cell)}</td>" for cell in others
    )
    return f'<tr{marked}><th scope="row">{_cell_contents(first)}</th>{values}</tr>'


def red(html: str) -> str:
    """Return HTML in the colour of failures."""
    return f'<strong class="fails">{html}</strong>'


def _cell_contents(cell: Cell) -> str:
    note = f"<small>{escaped(cell.note)}</small>" if cell.note else ""
    text = escaped(cell.text)
    if cell.failed:
        text = red(text)
    return f"{f'<mark>{text}</mark>' if cell.marked else text}{note}"
