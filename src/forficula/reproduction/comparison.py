"""Comparison of a paper's claims with the results of a study, with reasons for known differences."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from forficula.errors import InputError
from forficula.quantities import as_written
from forficula.reproduction.binder2025 import BINDER2025
from forficula.reproduction.reproduction import Claim, Reproduction
from forficula.study import Study

if TYPE_CHECKING:
    from xarray import Dataset

_NAMED = {paper.name: paper for paper in (BINDER2025,)}


@dataclass(frozen=True, kw_only=True)
class Comparison:
    """Comparison of a study with the paper that it reproduces.

    Attributes:
        paper: the paper.
        claims: one row per claim, in the paper's order.
    """

    paper: Reproduction
    claims: tuple[Claim, ...]


def check_reproduction(study: Study) -> None:
    """Reject a study that names a paper but cannot be compared with its claims; call this before the study runs.

    Raises:
        InputError: there is no such paper, the study computes something else, or it has other factors.
    """
    paper = named_reproduction(study.reproduces)
    if paper is not None and not study.choices:
        paper.check(study)


def compare(study: Study, table: Dataset) -> Comparison | None:
    """Compare the results of a study with the claims of the paper that it reproduces.

    Args:
        study: the study.
        table: its results.

    Returns:
        None if the study names no paper, or if it varies its factors one at a time, because all but one of its tables
        are then of other wings than the paper's.

    Raises:
        InputError: there is no such paper, the study computes something else, or it has other factors.
    """
    paper = named_reproduction(study.reproduces)
    if paper is None or study.choices:
        return None
    return Comparison(paper=paper, claims=tuple(paper.claims(table)))


def comparison_markdown(comparison: Comparison) -> str:
    """Return the claims as a table in Markdown, preceded by the number of claims that agree."""
    paper, rows = comparison.paper, comparison.claims
    decided = [row.agrees for row in rows if row.agrees is not None]
    words = {True: "yes", False: "no", None: "unknown"}
    lines = [
        f"# {paper.short} compared with this study",
        "",
        f"Source: {paper.authors}, {paper.published}.",
        f"{sum(decided)} of {len(decided)} claims agree"
        + (f"; {len(rows) - len(decided)} cannot be decided from this table." if len(decided) < len(rows) else "."),
        "",
        "| claim | paper | study | agrees | why |",
        "|---|---|---|---|---|",
    ]
    for row in rows:
        value = row.paper if row.mark == "paper" else f"{row.paper} [{row.mark}]"
        cells = (row.claim, value, row.ours, words[row.agrees], row.why)
        lines.append(f"| {' | '.join(cell.replace('|', '/') for cell in cells)} |")
    return "\n".join(lines) + "\n"


def named_reproduction(name: str | None) -> Reproduction | None:
    """Return the paper that a study or a design names under `reproduces`; None if it names none.

    Raises:
        InputError: there is no such paper.
    """
    if name is None:
        return None
    if name not in _NAMED:
        raise InputError(f"reproduces: need one of {', '.join(sorted(_NAMED))}, got {as_written(name)}")
    return _NAMED[name]
