"""Run a notebook from top to bottom and store what its cells print and return: text and figures.

    python docs/extensions/notebook.py docs/quickstart.ipynb

Jupyter is not needed. HTML, such as the page of a run that plays, is not stored, because it is large.
"""

from __future__ import annotations

import base64
import contextlib
import io
import json
import sys
from pathlib import Path
from typing import Any

from cells import evaluate


def run_notebook(notebook: dict[str, Any]) -> None:
    """Run all code cells in the working folder and replace their outputs.

    Args:
        notebook: content of the file, which is changed.
    """
    names: dict[str, Any] = {"__name__": "__main__"}
    for number, cell in enumerate(item for item in notebook["cells"] if item["cell_type"] == "code"):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            value = evaluate("".join(cell["source"]), names)
        cell["execution_count"] = number + 1
        cell["outputs"] = []
        if printed.getvalue():
            cell["outputs"].append({"output_type": "stream", "name": "stdout", "text": _lines(printed.getvalue())})
        if value is not None:
            data = _data(value)
            result = {"output_type": "execute_result", "execution_count": number + 1, "metadata": {}, "data": data}
            cell["outputs"].append(result)


def _data(value: object) -> dict[str, Any]:
    """Return what a notebook stores of a value, by type of media."""
    text = {"text/plain": _lines(repr(value))}
    if not hasattr(value, "savefig"):
        return text
    content = io.BytesIO()
    value.savefig(content, format="png", dpi=80)
    return {"image/png": base64.b64encode(content.getvalue()).decode() + "\n", **text}


def _lines(text: str) -> list[str]:
    return text.splitlines(keepends=True)


if __name__ == "__main__":
    path = Path(sys.argv[1]).resolve()
    content = json.loads(path.read_text("utf-8"))
    run_notebook(content)
    path.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", "utf-8")
