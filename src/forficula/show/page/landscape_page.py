"""The page of a landscape: its figures and its numbers, on which nothing moves."""

from __future__ import annotations

import base64
from collections.abc import Mapping
from pathlib import Path

from forficula.show.landscape.net_tables import net_tables, net_verdict
from forficula.show.page.html import escaped, paragraph, section, table
from forficula.show.page.page import page_html
from forficula.statics import EnergyLandscape

_HEADINGS = {
    "states": "Stable states",
    "barriers": "Barriers between them",
    "courses": "What drives do",
    "modes": "How it swings",
}


def landscape_page(landscape: EnergyLandscape, folder: Path, texts: Mapping[str, str]) -> str:
    """A landscape of points that slide as one page.

    Args:
        landscape: what is shown.
        folder: in which its figures lie.
        texts: that stand for them, by the stems of their files.
    """
    shown = [
        section(_HEADINGS[stem], _image(folder / f"{stem}.png", texts[stem]), name=stem)
        for stem in _HEADINGS
        if stem in texts
    ]
    tables = [table(each.title, each.headings, each.rows) for each in net_tables(landscape)]
    remarks = "".join(f"<li>{escaped(remark[:1].upper() + remark[1:])}.</li>" for remark in landscape.remarks)
    body = "".join(
        (
            f"<header><h1>{escaped(landscape.design.name)}</h1>",
            f"{paragraph(f'{net_verdict(landscape)}.', 'outcome')}</header>\n<main>",
            *shown,
            section("Numbers", *tables, name="numbers"),
            section("Remarks", f"<ul>{remarks}</ul>" * bool(remarks), name="remarks"),
            "</main>",
        )
    )
    return page_html(f"{landscape.design.name}: landscape", body, None)


def _image(path: Path, text: str) -> str:
    """A figure within the page."""
    packed = base64.b64encode(path.read_bytes()).decode("ascii")
    return f'<p><img src="data:image/png;base64,{packed}" alt="{escaped(text)}" style="max-width: 100%"></p>'
