"""A paper, its claims, and the study that reproduces them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from forficula.study import Study

if TYPE_CHECKING:
    from xarray import Dataset


@dataclass(frozen=True, kw_only=True)
class Reproduction:
    """A paper: its citation, its claims, and the part of a wing that its figures show.

    Attributes:
        name: name under `reproduces` in the file of a study or a design.
        short: short citation for titles.
        authors: family names.
        published: journal, volume, year and DOI.
        tendon: number of the folding hinge, from 0, whose tendon the paper's figures of one tendon show.
        hinge: number of the folding hinge, from 0, that the paper's figures of one hinge show.
        fold_count: number of its wings that fold; None if the paper does not report it.
        check: raises an InputError, before it runs, for a study that cannot be compared with the claims.
        claims: compares all claims, in the paper's order, with the table of a study.
    """

    name: str
    short: str
    authors: str
    published: str
    tendon: int
    hinge: int
    fold_count: int | None
    check: Callable[[Study], None]
    claims: Callable[[Dataset], list[Claim]]


@dataclass(frozen=True, kw_only=True)
class Claim:
    """One claim of a paper, compared with the result of a study.

    Attributes:
        claim: the compared quantity.
        paper: value in the paper.
        ours: value in the study.
        agrees: whether both agree; None if the study does not have the necessary results.
        why: a sentence on the reason of a difference; empty without a difference, or if the reason is unknown.
        mark: origin of the paper's value: "paper" if it is reported, "derived" if it follows from reported values.
    """

    claim: str
    paper: str
    ours: str
    agrees: bool | None
    why: str
    mark: str
