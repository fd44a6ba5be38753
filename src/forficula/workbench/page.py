"""The page of a workbench before anything is asked: its places, and what it begins with."""

from __future__ import annotations

from pathlib import Path

from forficula.design import load_design, named_designs
from forficula.show.page.page import page_html
from forficula.workbench.asked import Asked, Opened, design_source


def workbench_page(opened: Opened) -> str:
    """The page of a workbench, which asks its server for all that it shows of a design."""
    name = design_source(Asked(), opened)
    data = {
        "kind": "workbench",
        "opened": name,
        "settings": dict(opened.settings),
        "designs": [{"name": each, "shows": load_design(each).shows or ""} for each in named_designs()],
    }
    body = '<header><h1></h1></header>\n<main id="workbench"></main>\n'
    return page_html(f"{Path(name).stem}: workbench", body, data, served=True)
