"""The quickstart notebook runs from top to bottom, and what it stores is what its cells give."""

import copy
import json

import pytest

from tests.test_docs import DOCS, cells, loaded

notebook = loaded("extensions/notebook")
PATH = DOCS / "quickstart.ipynb"


@pytest.mark.usefixtures("undrawn")
def test_the_notebook_runs_and_its_stored_outputs_are_those_of_its_cells(tmp_path, monkeypatch):
    assert cells.evaluate("1 + 1", {}) == 2
    monkeypatch.chdir(tmp_path)
    stored = json.loads(PATH.read_text("utf-8"))
    ran = copy.deepcopy(stored)
    notebook.run_notebook(ran)
    assert (tmp_path / "out" / "letter" / "report.html").is_file()
    for before, after in zip(stored["cells"], ran["cells"], strict=True):
        assert media(before) == media(after), "".join(after["source"])
    assert stored["nbformat"] == 4
    assert all(not cell["source"][-1].endswith("\n") for cell in stored["cells"])


def media(cell):
    """Kinds of the outputs of a cell; their last digits may differ between machines."""
    return [(item["output_type"], sorted(item.get("data", {}))) for item in cell.get("outputs", [])]
