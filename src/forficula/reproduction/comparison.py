"""A paper's claims beside what a study finds, and why they differ where known."""

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
    """A study beside the paper that it reproduces.

    Attributes:
        paper: what it is set beside.
        claims: one row a claim, in the paper's order.
    """

    paper: Reproduction
    claims: tuple[Claim, ...]


def check_reproduction(study: Study) -> None:
    """Refuse a study that names a paper and does not ask what that claims; to be called before it runs.

    Raises:
        InputError: there is no such paper, or the study asks for something else, or has other factors.
    """
    paper = named_reproduction(study.reproduces)
    if paper is not None and not study.choices:
        paper.check(study)


def compare(study: Study, table: Dataset) -> Comparison | None:
    """Put what a study finds beside what the paper reports that it reproduces.

    Args:
        study: what was asked.
        table: what came out.

    Returns:
        None where the study names no paper, or varies its factors one at a time: then all but one of its tables are of
        other wings than the paper's.

    Raises:
        InputError: there is no such paper, or the study asks for something else, or has other factors.
    """
    paper = named_reproduction(study.reproduces)
    if paper is None or study.choices:
        return None
    return Comparison(paper=paper, claims=tuple(paper.claims(table)))


def comparison_markdown(comparison: Comparison) -> str:
    """The claims as a table in Markdown, with the count of those that agree above it."""
    paper, rows = comparison.paper, comparison.claims
    told = [row.agrees for row in rows if row.agrees is not None]
    words = {True: "yes", False: "no", None: "cannot tell"}
    lines = [
        f"# {paper.short} beside this study",
        "",
        f"Source: {paper.authors}, {paper.published}.",
        f"{sum(told)} of {len(told)} claims agree"
        + (f"; {len(rows) - len(told)} cannot be told from this table." if len(told) < len(rows) else "."),
        "",
        "| claim | paper | here | agrees | why |",
        "|---|---|---|---|---|",
    ]
    for row in rows:
        value = row.paper if row.mark == "paper" else f"{row.paper} [{row.mark}]"
        cells = (row.claim, value, row.ours, words[row.agrees], row.why)
        lines.append(f"| {' | '.join(cell.replace('|', '/') for cell in cells)} |")
    return "\n".join(lines) + "\n"


def named_reproduction(name: str | None) -> Reproduction | None:
    """Find the paper that a study or a design names under `reproduces`; None where it names none.

    Raises:
        InputError: there is no such paper.
    """
    if name is None:
        return None
    if name not in _NAMED:
        raise InputError(f"reproduces: need one of {', '.join(sorted(_NAMED))}, got {as_written(name)}")
    return _NAMED[name]
