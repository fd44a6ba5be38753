"""What Binder et al. 2025 report of their 60 tendons beside what a study finds, and why they differ where known.

The paper's lengths, masses and times are lost, so its counts, orderings and the shape of its maps are compared, never
its times or energies.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from forficula.study.claims import Comparison, claims
from forficula.study.tendon_search import read_search

if TYPE_CHECKING:
    from xarray import Dataset


def compare_with_paper(table: Dataset) -> list[Comparison]:
    """Put what a study finds beside what the paper reports.

    Args:
        table: of the search for the least torques over tendon stiffness and resting length.

    Returns:
        One row a claim, in the paper's order: one tendon, folding, unfolding, energies and works.

    Raises:
        InputError: the study asks for something else, or has other factors.
    """
    return claims(read_search(table))


def comparison_json(rows: Sequence[Comparison]) -> list[dict[str, Any]]:
    """The rows as plain data; `agrees` is null where it cannot be told."""
    return [asdict(row) for row in rows]


def comparison_markdown(rows: Sequence[Comparison]) -> str:
    """The rows as a table in Markdown, with the count of those that agree above it."""
    told = [row.agrees for row in rows if row.agrees is not None]
    words = {True: "yes", False: "no", None: "cannot tell"}
    lines = [
        "# Binder et al. 2025 beside this study",
        "",
        "Source: Binder, Costi, Izzo, Seidl, Biomimetics 11(1):9, 2025, doi 10.3390/biomimetics11010009.",
        f"{sum(told)} of {len(told)} claims agree"
        + (f"; {len(rows) - len(told)} cannot be told from this table." if len(told) < len(rows) else "."),
        "",
        "| claim | paper | here | agrees | why |",
        "|---|---|---|---|---|",
    ]
    for row in rows:
        paper = row.paper if row.mark == "paper" else f"{row.paper} [{row.mark}]"
        cells = (row.claim, paper, row.ours, words[row.agrees], row.why)
        lines.append(f"| {' | '.join(cell.replace('|', '/') for cell in cells)} |")
    return "\n".join(lines) + "\n"
