"""Which kind of results a folder holds, told by a file that only they have."""

from __future__ import annotations

from pathlib import Path

from forficula.errors import InputError

# by kind; an optimisation has a study's table, too
RESULTS = {
    "run": "summary.json",
    "landscape": "landscape.json",
    "convergence study": "convergence.json",
    "table of assumptions": "assumptions.json",
    "material": "material.json",
    "bill of parts": "bill.json",
    "optimisation": "optimum.json",
    "tolerance": "tolerance.json",
    "identification": "identified.json",
    "study": "table.nc",
}
# what a study, or a search, keeps of its rows before there is a table; whoever goes on with it says of which it is
_ROWS = "journal*.jsonl"
_WITH_ROWS = ("optimisation", "tolerance", "identification", "study")


def check_own_kind(folder: Path, own: str) -> None:
    """Refuse a folder that holds results of another kind, of which pages, figures and tables would be replaced.

    Args:
        folder: where results will be written.
        own: their kind, one of `RESULTS`.

    Raises:
        InputError: what the folder holds.
    """
    kinds = [kind for kind, file in RESULTS.items() if (folder / file).is_file()]
    if "optimisation" in kinds and "study" in kinds:
        kinds.remove("study")
    if own in kinds:
        return
    if kinds:
        article = "an" if kinds[0][0] in "aeiou" else "a"
        raise InputError(
            f"need a folder of its own, got {folder}, which holds {article} {kinds[0]} ({RESULTS[kinds[0]]}), whose"
            " page and figures would be replaced; name another one"
        )
    if own not in _WITH_ROWS and any(folder.glob(_ROWS)):
        raise InputError(
            f"need a folder of its own, got {folder}, which holds rows of a study ({next(folder.glob(_ROWS)).name});"
            " name another one"
        )
