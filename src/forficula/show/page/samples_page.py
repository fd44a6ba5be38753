"""What the pages of goals have in common: what was found, points to choose and to play, a table, and what was asked."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from forficula.dynamics import versions
from forficula.show.page.data.kept_run_data import runs_data
from forficula.show.page.page import page_html
from forficula.show.page.parts.html import escaped, paragraph, remarks, section, table
from forficula.show.page.parts.points_table import has_rows, points_table
from forficula.show.page.parts.rich_html import LaidOut
from forficula.study.running.kept_runs import KeptRun


def samples_page(
    *,
    name: str,
    kind: str,
    found: LaidOut,
    told: Iterable[str],
    more: Iterable[str] = (),
    data: dict[str, Any],
    views: dict[str, Any],
    headings: tuple[str, str],
    about: Sequence[str],
    kept: Iterable[KeptRun],
    count: int,
    csv: str,
) -> str:
    """A page of points.

    Args:
        name: of what was asked.
        kind: of results, in the title of the window.
        found: the sentence, the tables and the remarks.
        told: sections that stand before the points, HTML.
        more: sections after them.
        data: the points, from `samples_data`.
        views: what the script draws of them: `order` of "lines", "plane" and "pairs"; `lines`, keys or names of the
            axes of parallel coordinates; `plane`, those of the two over which points lie, `x` and `y`, with a `title`;
            `pairs`, those of the pair plots, and `marginals`; `front`, numbers of the points that none beats; `best`,
            the number of the best or None, and `best_word`, what that is called.
        headings: of the table of all points and of what was asked.
        about: what was asked, HTML.
        kept: the runs that can be played.
        count: how many these are.
        csv: the text of `table.csv`; empty for none.
    """
    shown = {
        "kind": "goals",
        "study": data,
        "views": views,
        "runs": runs_data(kept, count),
        "csv": csv if csv and has_rows(data) else None,
    }
    return page_html(f"{name}: {kind}", _body(name, found, told, more, data, headings, about), shown)


def _body(
    name: str,
    found: LaidOut,
    told: Iterable[str],
    more: Iterable[str],
    data: dict[str, Any],
    headings: tuple[str, str],
    about: Sequence[str],
) -> str:
    """What stands on a page of points, from the sentence down to what was asked."""
    heading = found.heading.removeprefix(f"{name}: ").rstrip(".")
    sentence = paragraph(f"{heading[:1].upper()}{heading[1:]}." if heading else "", "outcome")
    return "".join(
        (
            f'<header><h1>{escaped(name)}</h1>{sentence}</header>\n<main class="study">',
            *told,
            '<div id="explorer"></div>\n',
            *more,
            section("Numbers", *found.tables, name="numbers"),
            section("What to know", remarks(found.sentences), name="remarks"),
            section(headings[0], points_table(data), name="points"),
            section(headings[1], *about, name="about"),
            "</main>",
        )
    )


def about_rows(rows: Sequence[Sequence[str]], design_hash: str, source: str, command: str) -> list[str]:
    """What was asked as a table, with the versions and the command that repeats it."""
    every = [*rows, *([name, version] for name, version in versions().items()), ["design hash", design_hash]]
    return [
        paragraph(f"Source: {source}" if source else "", "note"),
        table("What was asked, and with what", ("", ""), every, numbers=False),
        paragraph("The same command repeats it with the same numbers, or goes on where it stopped."),
        f"<pre><code>{escaped(command)}</code></pre>",
    ]
