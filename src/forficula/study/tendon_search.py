"""The tendons of a search for the least torques, and which of them the paper has."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from forficula.errors import InputError

if TYPE_CHECKING:
    from xarray import Dataset

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

# the paper's largest torques, N m
FOLD_TORQUE, UNFOLD_TORQUE = 0.5, 1.0
# how many of the paper's 60 tendons fold with at most these, and how many of them open again
PAPER_FOLDS, PAPER_OPENS = 32, 13
# tendons in words, of many
AS_MANY = 4
_FACTORS = ("tendon_stiffness", "tendon_rest_length")
# the paper's tendons, in N/m and m
_STIFFNESSES = 1e3 * np.arange(1, 7)
_REST_LENGTHS = 1e-2 * np.arange(10)


@dataclass(frozen=True, kw_only=True)
class TendonSearch:
    """The table's arrays, (stiffness, rest length), SI; nan and False where there is none.

    Attributes:
        stiffness: N/m, (stiffness,).
        rest_length: m, (rest length,).
        folds: whether a torque of at most 50 N cm folds.
        opens: whether, besides, a torque of at most 100 N cm opens.
        covers: whether the paper's 60 tendons are among these, tried with up to 50 N cm.
    """

    table: Dataset
    stiffness: Array
    rest_length: Array
    folds: Mask
    opens: Mask
    covers: bool

    @property
    def whole(self) -> bool:
        """Whether the tendons are the paper's 60 and no others."""
        return self.covers and self.folds.size == len(_STIFFNESSES) * len(_REST_LENGTHS)

    def values(self, name: str) -> Array:
        """A variable over stiffness and rest length."""
        return np.asarray(self.table[name].transpose(*_FACTORS, ...).values)

    def at(self, stiffness: float, rest_length: float) -> tuple[int, int] | None:
        """Place of a tendon, given in N/cm and cm, or None where the study does not have it."""
        row = np.flatnonzero(np.isclose(self.stiffness, 100 * stiffness))
        column = np.flatnonzero(np.isclose(self.rest_length, rest_length / 100, atol=1e-9))
        return (int(row[0]), int(column[0])) if len(row) and len(column) else None

    def name(self, place: Sequence[int]) -> str:
        """A tendon in words."""
        return f"k = {self.stiffness[place[0]] / 100:.4g} N/cm, l0 = {100 * self.rest_length[place[1]]:.4g} cm"

    def names(self, where: Mask) -> str:
        """Tendons in words, the first few of many."""
        places = np.argwhere(where)
        more = f" and {len(places) - AS_MANY} more" if len(places) > AS_MANY else ""
        return "; ".join(self.name(place) for place in places[:AS_MANY]) + more


def read_search(table: Dataset) -> TendonSearch:
    """Take what the claims are about from the table of a search over tendon stiffness and resting length.

    Raises:
        InputError: the study asks for something else, or has other factors.
    """
    dims = set(table["outcome"].dims)
    if dims != set(_FACTORS) or "least_fold_torque" not in table:
        given = ", ".join(sorted(str(dim).replace("_", ".", 1) for dim in dims))
        raise InputError(
            f"the paper searched for the least torques over tendon.stiffness and tendon.rest_length, got a study over"
            f" {given or 'nothing'}"
        )
    if "least_unfold_torque" not in table:
        raise InputError("the paper searched for the least torques that open, too, got a search without unfold torques")
    stiffness, rest_length = (np.asarray(table[name].values, dtype=float) for name in _FACTORS)
    fold, unfold = (
        np.asarray(table[name].transpose(*_FACTORS).values, dtype=float)
        for name in ("least_fold_torque", "least_unfold_torque")
    )
    covers = float(table["fold_torque"].max()) > FOLD_TORQUE * (1 - 1e-9) and all(
        np.isclose(ours, papers, atol=1e-9).any()
        for ours, all_of_paper in ((stiffness, _STIFFNESSES), (rest_length, _REST_LENGTHS))
        for papers in all_of_paper
    )
    return TendonSearch(
        table=table,
        stiffness=stiffness,
        rest_length=rest_length,
        folds=fold <= FOLD_TORQUE * (1 + 1e-9),
        opens=(fold <= FOLD_TORQUE * (1 + 1e-9)) & (unfold <= UNFOLD_TORQUE * (1 + 1e-9)),
        covers=covers,
    )
