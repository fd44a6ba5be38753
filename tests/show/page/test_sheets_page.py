"""Pages of sheets whose facets bend."""

import json

import numpy as np

from forficula.show.page.parts.outcome_tables import outcome_tables
from forficula.show.page.playback import make_clip
from forficula.show.page.run_page import playback_data, run_page
from tests.show.sheets import sheet_run


def test_many_creases_have_few_lines_and_few_cells():
    record, outcome = sheet_run("miura with a tendon")
    data = playback_data(make_clip(record, outcome))
    assert [line["name"] for line in data["plots"][0]["lines"]] == [
        "smallest",
        "median straight",
        "median zigzag",
        "largest",
    ]
    assert "of 24 creases" in data["plots"][0]["text"]
    assert data["text"].startswith("A sheet of 16 facets, 56 bars, 24 creases, 16 facet bends and 1 tendon")
    json.dumps(data, allow_nan=False)
    tables = "".join(outcome_tables(outcome))
    assert "all tendons, creases, facet bends and bars" in tables
    assert "work of the drives" in tables


def test_the_page_of_a_sheet_works_in_a_browser(watch, tmp_path):
    record, outcome = sheet_run("miura with a tendon")
    (tmp_path / "sheet.html").write_text(run_page(record, outcome), "utf-8")
    opened = watch(tmp_path / "sheet.html")
    page = opened.page
    page.get_by_role("button", name="b folded").click()
    opened.settle()
    assert opened.messages == []
    vertices = np.array(page.evaluate("Array.from(forficula.player.stage.views[0].shape.vertices)")).reshape(-1, 3)
    corners = record.series["point_position"][np.argmin(np.abs(record.time - outcome.states["folded"].time))]
    assert np.linalg.norm(corners[:, None] - vertices[None], axis=2).min(axis=1).max() < 1e-6
    # one row for each crease: more than four would be too wide beside one another
    assert page.locator("#readout thead th").first.inner_text() == "fold angle (deg)"
    rows = page.locator("#readout tbody tr").all()
    assert [bool(row.locator("td").first.inner_text()) for row in rows[:4]] == [True] * 4
