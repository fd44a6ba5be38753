"""The page of results that are figures and tables, below a run where one belongs to them."""

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
from forficula.show.page.parts.rich_html import LaidOut, laid_out
from forficula.show.style import COPIES

# what comes with a run stands below this section of its page
_LAST = '<section id="design">'


def results_page(
    kind: str,
    name: str,
    found: LaidOut,
    figures: Iterable[str],
    *,
    run: str = "",
    data: dict[str, Any] | None = None,
) -> str:
    """Results as one page.

    Args:
        kind: of results, such as "landscape", in the title of the window.
        name: of what they are of.
        found: the sentence, the tables and the remarks.
        figures: sections, from `figure_sections`.
        run: what a run beside them came to, in a sentence.
        data: what the page's script shows, if there is such.
    """
    places = "".join(f'<div id="{each}"></div>\n' for each in ("player", "curves", "plots", "readout"))
    told = found.heading.removeprefix(f"{name}: ").rstrip(".")
    sentence = paragraph(f"{told[:1].upper()}{told[1:]}.", "outcome")
    body = "".join(
        (
            f"<header><h1>{escaped(name)}</h1>{sentence}</header>\n<main>",
            paragraph(run, "note"),
            places * (data is not None),
            *figures,
            section("Numbers", *found.tables, name="numbers"),
            section("What to know", remarks(found.sentences), name="remarks"),
            "</main>",
        )
    )
    return page_html(f"{name}: {kind}", body, data)


def figure_sections(folder: Path, headings: Mapping[str, str], texts: Mapping[str, str]) -> list[str]:
    """The figures of a folder, each in a section of its own, in the order of the headings.

    Args:
        folder: in which they lie.
        headings: by the stems of their files.
        texts: that stand for them, likewise; a figure without one is left out.
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
    """Write report.html of results that consist of one table and of the figures of their folder.

    Args:
        folder: of the results, with the figures in it.
        kind: of results, as for `results_page`.
        name: of the design.
        table: as the terminal prints it.
        headings: of the figures, by the stems of their files.
        texts: that describe the figures, likewise.

    Raises:
        InputError: it cannot be written.
    """
    page = results_page(kind, name, laid_out(table), figure_sections(folder, headings, texts))
    write_text(folder / "report.html", page)


def figure_html(folder: Path, stem: str, text: str) -> str:
    """A figure within the page; on a phone that of a journal's column, whose letters can be read there."""
    wide, narrow = folder / f"{stem}.png", folder / COPIES / f"{stem}.svg"
    return (
        f'<figure class="drawn"><picture><source media="(max-width: 560px)" srcset="{_packed(narrow, "svg+xml")}">'
        f'<img src="{_packed(wide, "png")}" alt="{escaped(text)}"></picture></figure>'
    )


def with_section(page: str, name: str, made: str) -> str:
    """A page with one more section: before its design, where it tells that, or else at its end.

    All other text of a page is escaped, so that these marks are its own.

    Args:
        page: HTML.
        name: of the section; one of this name that is there already goes.
        made: HTML, from `forficula.show.page.parts.html.section`.
    """
    before, there, after = page.partition(f'<section id="{name}">')
    if there:
        page = before + after.partition("</section>\n")[2]
    mark = _LAST if _LAST in page else "</main>"
    before, _, after = page.partition(mark)
    return f"{before}{made}{mark}{after}"


def read_page(folder: Path) -> str | None:
    """The page that a folder of results has; None where it has none.

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
