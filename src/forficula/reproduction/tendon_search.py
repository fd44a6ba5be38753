"""Results of a search for the least torques over tendon stiffness and resting length, and the tendons of a paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Array

if TYPE_CHECKING:
    from xarray import Dataset

Mask = NDArray[np.bool_]

FACTORS = ("tendon_stiffness", "tendon_rest_length")
# largest number of tendons that a text names
AS_MANY = 4


@dataclass(frozen=True, kw_only=True)
class TendonSearch:
    """Arrays of the table, (stiffness, rest length), SI; nan and False for missing values.

    Attributes:
        table: of the search.
        stiffness: N/m, (stiffness,).
        rest_length: m, (rest length,).
        folds: whether a torque up to the paper's largest one folds.
        opens: whether it folds and a torque up to the paper's largest one opens it.
        covers: whether the search includes the paper's tendons with torques up to the paper's largest.
        whole: whether it covers the paper's tendons and has no others.
    """

    table: Dataset
    stiffness: Array
    rest_length: Array
    folds: Mask
    opens: Mask
    covers: bool
    whole: bool

    def values(self, name: str) -> Array:
        """Return a variable over stiffness and rest length."""
        return np.asarray(self.table[name].transpose(*FACTORS, ...).values)

    def at(self, stiffness: float, rest_length: float) -> tuple[int, int] | None:
        """Return the indices of a tendon, given in N/cm and cm; None if the study does not have it."""
        row = np.flatnonzero(np.isclose(self.stiffness, 100 * stiffness))
        column = np.flatnonzero(np.isclose(self.rest_length, rest_length / 100, atol=1e-9))
        return (int(row[0]), int(column[0])) if len(row) and len(column) else None

    def name(self, place: Sequence[int]) -> str:
        """Return a tendon in words."""
        return f"k = {self.stiffness[place[0]] / 100:.4g} N/cm, l0 = {100 * self.rest_length[place[1]]:.4g} cm"

    def names(self, where: Mask) -> str:
        """Return tendons in words, at most the first few."""
        places = np.argwhere(where)
        more = f" and {len(places) - AS_MANY} more" if len(places) > AS_MANY else ""
        return "; ".join(self.name(place) for place in places[:AS_MANY]) + more


def read_search(
    table: Dataset,
    *,
    stiffnesses: Sequence[float],
    rest_lengths: Sequence[float],
    fold_torque: float,
    unfold_torque: float,
) -> TendonSearch:
    """Read the results that claims need from the table of a search over tendon stiffness and resting length.

    Args:
        table: with both least torques over `FACTORS`.
        stiffnesses: of the paper's tendons, N/m.
        rest_lengths: of the paper's tendons, m.
        fold_torque: the paper's largest fold torque, N m.
        unfold_torque: the paper's largest unfold torque, N m.
    """
    stiffness, rest_length = (np.asarray(table[name].values, dtype=float) for name in FACTORS)
    fold, unfold = (
        np.asarray(table[name].transpose(*FACTORS).values, dtype=float)
        for name in ("least_fold_torque", "least_unfold_torque")
    )
    covers = float(table["fold_torque"].max()) > fold_torque * (1 - 1e-9) and all(
        np.isclose(ours, papers, atol=1e-9).any()
        for ours, all_of_paper in ((stiffness, stiffnesses), (rest_length, rest_lengths))
        for papers in all_of_paper
    )
    folds = fold <= fold_torque * (1 + 1e-9)
    return TendonSearch(
        table=table,
        stiffness=stiffness,
        rest_length=rest_length,
        folds=folds,
        opens=folds & (unfold <= unfold_torque * (1 + 1e-9)),
        covers=covers,
        whole=covers and folds.size == len(stiffnesses) * len(rest_lengths),
    )
