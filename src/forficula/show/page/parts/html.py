"""Pieces of HTML from text."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Cell:
    """A cell of a table.

    Attributes:
        text: what stands in it.
        note: what stands under it, smaller.
        marked: whether it should catch the eye.
        failed: whether it says that something fails, and is red.
    """

    text: str
    note: str = ""
    marked: bool = False
    failed: bool = False


def escaped(text: str) -> str:
    """Text that HTML reads as text, in an attribute, too."""
    return html.escape(text, quote=True)


def table(
    caption: str,
    headings: Sequence[str],
    rows: Iterable[Sequence[str | Cell]],
    *,
    groups: Sequence[tuple[str, int]] = (),
    numbers: bool = True,
) -> str:
    """A table whose first column names the rows.

    Args:
        caption: above it.
        headings: one a column; all empty for none.
        rows: cells, the first one the row's name.
        groups: headings above the headings, each with how many columns it spans.
        numbers: whether the other columns are numbers and stand to the right.
    """
    kind = ' class="numbers"' if numbers else ""
    above = "".join(_heading(text, f'colgroup" colspan="{span}') for text, span in groups)
    head = "".join(_heading(heading, "col") for heading in headings)
    above, head = f'<tr class="groups">{above}</tr>' * bool(groups), f"<tr>{head}</tr>" * any(headings)
    body = "".join(_row(cells) for cells in rows)
    titled = f"<caption>{escaped(caption)}</caption>" if caption else ""
    # the keyboard scrolls only what it can stop at; the script, where there is one, leaves stops only where it scrolls
    name = caption or ", ".join(filter(None, headings)) or "table"
    place = f'<div class="table" tabindex="0" role="group" aria-label="{escaped(name)}">'
    return (
        f"{place}<table{kind}>{titled}"
        f"{f'<thead>{above}{head}</thead>' * bool(above or head)}<tbody>{body}</tbody></table></div>"
    )


def paragraph(text: str, kind: str = "") -> str:
    """A paragraph; nothing for no text."""
    return f"<p{f' class={kind}' if kind else ''}>{escaped(text)}</p>" if text else ""


def remarks(sentences: Iterable[str]) -> str:
    """A list of sentences, each with a capital, unless it begins with a key, and a full stop; nothing for none."""
    items = "".join(f"<li>{escaped(_sentence(each))}</li>" for each in sentences)
    return f'<ul class="warnings">{items}</ul>' if items else ""


def section(heading: str, *parts: str, name: str = "") -> str:
    """A section under a heading; nothing where it would be empty."""
    inside = "".join(parts)
    identity = f' id="{name}"' if name else ""
    return f"<section{identity}><h2>{escaped(heading)}</h2>{inside}</section>\n" if inside else ""


def _sentence(text: str) -> str:
    key = "." in text.partition(" ")[0].rstrip(".,:")
    return f"{(text if key else text[:1].upper() + text[1:]).rstrip('.')}."


def _heading(text: str, scope: str) -> str:
    return f'<th scope="{scope}">{escaped(text)}</th>' if text else "<td></td>"


def _row(cells: Sequence[str | Cell]) -> str:
    first, *others = (Cell(text=cell) if isinstance(cell, str) else cell for cell in cells)
    marked = ' class="changed"' if any(cell.marked for cell in (first, *others)) else ""
    values = "".join(f"<td>{_inside(cell)}</td>" for cell in others)
    return f'<tr{marked}><th scope="row">{_inside(first)}</th>{values}</tr>'


def red(html: str) -> str:
    """HTML in the colour of what fails."""
    return f'<strong class="fails">{html}</strong>'


def _inside(cell: Cell) -> str:
    note = f"<small>{escaped(cell.note)}</small>" if cell.note else ""
    text = escaped(cell.text)
    if cell.failed:
        text = red(text)
    return f"{f'<mark>{text}</mark>' if cell.marked else text}{note}"
