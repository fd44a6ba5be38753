"""Layout shared by the pages of goals: the result, points to select and to play back, a table, and the question."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from forficula.dynamics import versions
from forficula.show.page.data.kept_run_data import runs_data
from forficula.show.page.page import page_html
from forficula.show.page.parts.html import escaped, paragraph, remarks, section, table
from forficula.show.page.parts.points_table import has_rows, points_table
from forficula.show.page.parts.rich_html import PrintedResult
from forficula.study.running.kept_runs import KeptRun


def samples_page(
    *,
    name: str,
    kind: str,
    printed: PrintedResult,
    before: Iterable[str],
    after: Iterable[str] = (),
    data: dict[str, Any],
    views: dict[str, Any],
    headings: tuple[str, str],
    about: Sequence[str],
    kept: Iterable[KeptRun],
    count: int,
    csv: str,
) -> str:
    """Return a page of points.

    Args:
        name: name of the goal or design.
        kind: kind of results, for the title of the window.
        printed: the sentence, the tables and the remarks of the terminal.
        before: sections before the points, HTML.
        after: sections after the points, HTML.
        data: points, from `samples_data`.
        views: plots of the points that the script draws: `order` of "lines", "plane" and "pairs"; `lines`, keys or
            names of the axes of parallel coordinates; `plane`, those of the axes `x` and `y` of a scatter plot, with a
            `title`; `pairs`, those of the pair plots, and `marginals`; `front`, indices of the Pareto-optimal points;
            `best`, index of the best point or None, and `best_word`, its label.
        headings: headings of the table of all points and of the section about the question.
        about: HTML of the question and its settings.
        kept: runs that the page can play back.
        count: number of these runs.
        csv: contents of `table.csv`; empty for none.
    """
    shown = {
        "kind": "goals",
        "study": data,
        "views": views,
        "runs": runs_data(kept, count),
        "csv": csv if csv and has_rows(data) else None,
    }
    return page_html(f"{name}: {kind}", _body(name, printed, before, after, data, headings, about), shown)


def _body(
    name: str,
    printed: PrintedResult,
    before: Iterable[str],
    after: Iterable[str],
    data: dict[str, Any],
    headings: tuple[str, str],
    about: Sequence[str],
) -> str:
    """Return the contents of a page of points, from the sentence down to the question."""
    heading = printed.heading.removeprefix(f"{name}: ").rstrip(".")
    sentence = paragraph(f"{heading[:1].upper()}{heading[1:]}." if heading else "", "outcome")
    return "".join(
        (
            f'<header><h1>{escaped(name)}</h1>{sentence}</header>\n<main class="study">',
            *before,
            '<div id="explorer"></div>\n',
            *after,
            section("Numbers", *printed.tables, name="numbers"),
            section("What to know", remarks(printed.sentences), name="remarks"),
            section(headings[0], points_table(data), name="points"),
            section(headings[1], *about, name="about"),
            "</main>",
        )
    )


def about_rows(rows: Sequence[Sequence[str]], design_hash: str, source: str, command: str) -> list[str]:
    """Return the question as a table, with the versions and the command that repeats it."""
    every = [*rows, *([name, version] for name, version in versions().items()), ["design hash", design_hash]]
    return [
        paragraph(f"Source: {source}" if source else "", "note"),
        table("Settings and versions", ("", ""), every, numbers=False),
        paragraph("The same command repeats this with the same numbers, or continues an interrupted search."),
        f"<pre><code>{escaped(command)}</code></pre>",
    ]
