"""Page of results that consist of figures and tables, below a run if there is one."""

from __future__ import annotations

import base64
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from rich.console import RenderableType

from forficula.errors import InputError
from forficula.files import write_text
from forficula.show.page.page import page_html
from forficula.show.page.parts.html import escaped, paragraph, remarks, section
from forficula.show.page.parts.rich_html import PrintedResult, printed_result
from forficula.show.style import COPIES

# sections that are added later, such as a landscape, are placed before this section
_LAST = '<section id="design">'


def results_page(
    kind: str,
    name: str,
    printed: PrintedResult,
    figures: Iterable[str],
    *,
    run: str = "",
    data: dict[str, Any] | None = None,
    missing: str = "",
) -> str:
    """Return results as one page.

    Args:
        kind: kind of results, such as "landscape", for the title of the window.
        name: name of the design.
        printed: the sentence, the tables and the remarks of the terminal.
        figures: sections, from `figure_sections`.
        run: a sentence on the outcome of a run of the same design.
        data: data for the page's script, if any.
        missing: a sentence on what this page does not show.
    """
    elements = "".join(f'<div id="{item}"></div>\n' for item in ("player", "curves", "plots", "readout"))
    heading = printed.heading.removeprefix(f"{name}: ").rstrip(".")
    sentence = paragraph(f"{heading[:1].upper()}{heading[1:]}.", "outcome")
    body = "".join(
        (
            f"<header><h1>{escaped(name)}</h1>{sentence}</header>\n<main>",
            paragraph(run, "note"),
            elements * (data is not None),
            paragraph(missing, "note"),
            *figures,
            section("Numbers", *printed.tables, name="numbers"),
            section("What to know", remarks(printed.sentences), name="remarks"),
            "</main>",
        )
    )
    return page_html(f"{name}: {kind}", body, data)


def figure_sections(folder: Path, headings: Mapping[str, str], texts: Mapping[str, str]) -> list[str]:
    """Return the figures of a folder, each in a section, in the order of the headings.

    Args:
        folder: folder that contains the figures.
        headings: headings by the stems of the files.
        texts: descriptions by the stems of the files; a figure without one is left out.
    """
    return [
        section(heading, figure_html(folder, stem, texts[stem]), name=stem)
        for stem, heading in headings.items()
        if stem in texts
    ]


def write_results_page(
    folder: Path,
    kind: str,
    name: str,
    table: RenderableType,
    headings: Mapping[str, str],
    texts: Mapping[str, str],
) -> None:
    """Write report.html of results that consist of one table and of the figures in their folder.

    Args:
        folder: folder of the results, with the figures.
        kind: kind of results, as for `results_page`.
        name: name of the design.
        table: table as the terminal prints it.
        headings: headings of the figures, by the stems of their files.
        texts: descriptions of the figures, by the stems of their files.

    Raises:
        InputError: it cannot be written.
    """
    page = results_page(kind, name, printed_result(table), figure_sections(folder, headings, texts))
    write_text(folder / "report.html", page)


def figure_html(folder: Path, stem: str, text: str) -> str:
    """Return a figure for a page; phones get the version for a journal's column, whose letters are legible there."""
    wide, narrow = folder / f"{stem}.png", folder / COPIES / f"{stem}.svg"
    return (
        f'<figure class="drawn"><picture><source media="(max-width: 560px)" srcset="{_packed(narrow, "svg+xml")}">'
        f'<img src="{_packed(wide, "png")}" alt="{escaped(text)}"></picture></figure>'
    )


def with_section(page: str, name: str, section_html: str) -> str:
    """Return a page with one more section, before its design section or else at its end.

    All other text of a page is escaped, so these marks occur only where the page itself has them.

    Args:
        page: HTML.
        name: name of the section; an existing section of this name is replaced.
        section_html: HTML, from `forficula.show.page.parts.html.section`.
    """
    before, existing, after = page.partition(f'<section id="{name}">')
    if existing:
        page = before + after.partition("</section>\n")[2]
    mark = _LAST if _LAST in page else "</main>"
    before, _, after = page.partition(mark)
    return f"{before}{section_html}{mark}{after}"


def read_page(folder: Path) -> str | None:
    """Return the page of a folder of results; None if it has none.

    Raises:
        InputError: it cannot be read.
    """
    path = folder / "report.html"
    try:
        return path.read_text("utf-8")
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None


def _packed(path: Path, kind: str) -> str:
    return f"data:image/{kind};base64,{base64.b64encode(path.read_bytes()).decode('ascii')}"
