"""Conversion of terminal output (rich) into HTML."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import zip_longest

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.show.page.parts.html import table


@dataclass(frozen=True, kw_only=True)
class PrintedResult:
    """Result that was laid out for the terminal, converted to HTML.

    Attributes:
        heading: the result in one sentence, bold in the terminal; empty for none.
        tables: HTML of the tables, each with its title.
        sentences: the other sentences.
    """

    heading: str
    tables: tuple[str, ...]
    sentences: tuple[str, ...]


def printed_result(renderable: RenderableType) -> PrintedResult:
    """Split the terminal output of a result; a line in italics is the title of the table after it."""
    heading, title, tables, sentences = "", "", [], []
    for part in renderable.renderables if isinstance(renderable, Group) else [renderable]:
        match part:
            case Table():
                headings = [_plain(column.header) for column in part.columns]
                cells = [[_plain(cell) for cell in column.cells] for column in part.columns]
                caption = title if part.title is None else _plain(part.title)
                if any(cells):
                    tables.append(table(caption, headings, list(zip_longest(*cells, fillvalue=""))))
                title = ""
            case Text() if "bold" in str(part.style):
                heading = part.plain
            case Text() if "italic" in str(part.style):
                title = part.plain
            case _:
                sentences.append(_plain(part))
    return PrintedResult(heading=heading, tables=tuple(tables), sentences=tuple(filter(None, sentences)))


def _plain(cell: object) -> str:
    return cell.plain if isinstance(cell, Text) else str(cell)
