"""A claim of a paper beside what we find."""

from __future__ import annotations

from dataclasses import dataclass


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
