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
    """A paper: how it is cited, what it claims, and which part of a wing its figures show.

    Attributes:
        name: by which the file of a study or a design names it under `reproduces`.
        short: the paper in a title.
        authors: by their family names.
        published: where and when.
        tendon: number of the hinge that folds, from 0, whose tendon its figures of one tendon show.
        hinge: number of the hinge that folds, from 0, that its figures of one hinge show.
        fold_count: how many of its wings fold; None where it does not say.
        check: refuses a study that does not ask what the claims are about, by an InputError, before it runs.
        claims: all of its claims beside the table of such a study, in the paper's order.
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
    """One claim of a paper beside what a study finds.

    Attributes:
        claim: what is compared.
        paper: what the paper reports.
        ours: what the study's table says.
        agrees: None where the table does not have what it takes to tell.
        why: a sentence on the difference, empty where there is none or it is not known.
        mark: where the paper's value comes from: "paper", or "derived" from what it says.
    """

    claim: str
    paper: str
    ours: str
    agrees: bool | None
    why: str
    mark: str
