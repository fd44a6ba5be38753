"""Binder et al. 2025: claims of the paper about its 60 tendons, compared with the results of a search.

The paper does not report its lengths, masses and times. Its counts, orderings and the shape of its maps are therefore
compared, but never its times or energies.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import FORMER_WORDS, Ending, Verdict, ending_word
from forficula.arrays import Array
from forficula.errors import InputError
from forficula.reproduction.reproduction import Claim, Reproduction
from forficula.reproduction.tendon_search import AS_MANY, FACTORS, Mask, TendonSearch, read_search
from forficula.study import Study

if TYPE_CHECKING:
    from xarray import Dataset

FOLDED = "folded"
# the paper's largest torques, and the step of its search, N m
_FOLD_TORQUE, _UNFOLD_TORQUE, _TORQUE_STEP = 0.5, 1.0, 0.1
# numbers of the paper's 60 tendons that fold with at most these torques, and of those that open again
_FOLDS, _OPENS = 32, 13
# the paper's tendons, in N/m and m
_STIFFNESSES = tuple(1e3 * stiffness for stiffness in range(1, 7))
_REST_LENGTHS = tuple(1e-2 * length for length in range(10))
# share of the flat energy: smaller energies remain because a state is not completely at rest
_EQUAL = 1e-3
# "much less" in the paper is interpreted as less than half
_MUCH_LESS = 0.5
_LOST = "The paper does not report its lengths and masses; those of the simulation are chosen."
_GEOMETRY = (
    "The boundary depends on hub radius, sector angle and margin, which the paper does not report; those of the"
    " simulation are chosen."
)
_OTHER_TENDONS = "The study does not have the paper's 60 tendons, or no fold torques up to 50 N cm."
_ABSENT = "The study does not have the tendons of this claim."
_UNKNOWN = "The outcome of some tendons is unknown: they need a shorter timestep."
_UNDECIDED = ending_word(Ending(verdict=Verdict.UNDECIDED))
_INCONCLUSIVE = [
    *(
        ending_word(Ending(verdict=verdict))
        for verdict in Verdict
        if not verdict.conclusive and verdict is not Verdict.UNDECIDED
    ),
    *FORMER_WORDS,
]
_NONE_OPENS = "No tendon of the study folds and opens again."
_NO_ERROR = "The paper attributes its one {} to a numerical error; none occurs in the simulation."


def check(study: Study) -> None:
    """Reject a study that is not a search for both least torques over tendon stiffness and resting length.

    Raises:
        InputError: the study computes something else, or has other factors.
    """
    dims = ["sample"] if study.sampled else [factor.dimension for factor in study.factors]
    _check(dims, searched=study.search is not None, opens=study.search is not None and study.search.second is not None)


def _check(dims: Iterable[str], *, searched: bool, opens: bool) -> None:
    if set(dims) != set(FACTORS) or not searched:
        provided = ", ".join(sorted(dim.replace("_", ".", 1) for dim in dims))
        raise InputError(
            f"the paper searched for the least torques over tendon.stiffness and tendon.rest_length, got a study over"
            f" {provided or 'nothing'}"
        )
    if not opens:
        raise InputError("the paper also searched for the least torques that open, got a search without unfold torques")


def claims(table: Dataset) -> list[Claim]:
    """Compare all claims, in the paper's order: one tendon, folding, unfolding, energies and works.

    If the runs of some tendons are inconclusive, claims about all tendons are undecided. Tendons whose verdict depends
    on the timestep give a range of counts, and are left out of the other claims.

    Args:
        table: of the search for the least torques over tendon stiffness and resting length.

    Raises:
        InputError: the table is of a study that computes something else, or has other factors.
    """
    _check(
        [str(dim) for dim in table["outcome"].dims],
        searched="least_fold_torque" in table,
        opens="least_unfold_torque" in table,
    )
    search = read_search(
        table,
        stiffnesses=_STIFFNESSES,
        rest_lengths=_REST_LENGTHS,
        fold_torque=_FOLD_TORQUE,
        unfold_torque=_UNFOLD_TORQUE,
    )
    unknown = np.isin(search.values("outcome").astype(str), _INCONCLUSIVE)
    rows = [
        _tendon_energy(search, 60, 0, "more than 35 J", lambda energy: energy > 35),
        _tendon_energy(search, 10, 0, "about 6 J", lambda energy: round(energy) == 6),
        _count_that_fold(search),
        _long_tendons(search),
        _least_torque(search),
        _fastest(search),
        _least_work(search),
        _large_torque(search),
        _outlier(search),
        _count_that_open(search),
        _first_to_open(search),
        _flat_above_opened(search),
        _opened_above_folded(search),
        _residual_energy(search),
        _works(search),
        _unfold_work(search),
    ]
    if not unknown.any():
        return rows
    return [row if row.agrees is None else replace(row, agrees=None, why=_UNKNOWN) for row in rows]


def _row(
    claim: str, paper: str, ours: str, agrees: bool | np.bool_ | None, why: str = "", mark: str = "paper"
) -> Claim:
    """Return a claim; the reason is kept only if paper and simulation differ."""
    verdict = None if agrees is None else bool(agrees)
    return Claim(claim=claim, paper=paper, ours=ours, agrees=verdict, why="" if verdict else why, mark=mark)


def _tendon_energy(
    search: TendonSearch, stiffness: float, rest_length: float, paper: str, rule: Callable[[float], bool]
) -> Claim:
    """Compare the energy of one tendon when flat: that of the wing divided by its number of equal tendons."""
    claim = f"energy of one tendon when flat, k = {stiffness:g} N/cm, l0 = {rest_length:g} cm"
    place, veins = search.at(stiffness, rest_length), search.table.attrs.get("tendons")
    if place is None or not veins:
        return _row(claim, paper, "not in the study", None, _ABSENT)
    energy = float(search.values("flat_energy")[place]) / int(veins)
    if not math.isfinite(energy):
        return _row(claim, paper, "no value", None)
    return _row(claim, paper, f"{energy:.3g} J", rule(energy))


def _count_that_fold(search: TendonSearch) -> Claim:
    count = int(search.folds.sum())
    ours, agrees, why = _count(search, count, _FOLDS, _GEOMETRY, "fold_outcome")
    return _row("tendons that fold with at most 50 N cm", f"{_FOLDS} of 60", ours, agrees, why)


def _count_that_open(search: TendonSearch) -> Claim:
    ours, agrees, why = _count(search, int(search.opens.sum()), _OPENS, _LOST, "outcome")
    return _row("those of them that open again with at most 100 N cm", f"{_OPENS} of 60", ours, agrees, why)


def _count(search: TendonSearch, count: int, paper: int, why: str, outcome: str) -> tuple[str, bool | None, str]:
    """Return a count in words, whether it equals the paper's, and why not; `outcome` names the outcome variable."""
    ours = f"{count} of {search.folds.size}"
    unknown = np.isin(search.values(outcome).astype(str), _INCONCLUSIVE)
    if unknown.any():
        return f"{ours}; unknown for {search.names(unknown)}", None, _UNKNOWN
    undecided = search.values(outcome).astype(str) == _UNDECIDED
    if search.whole and undecided.any():
        most = count + int(undecided.sum())
        ours = f"{count} to {most} of {search.folds.size}; undecided: {search.names(undecided)}"
        return ours, count <= paper <= most, why
    return (ours, count == paper, why) if search.whole else (ours, None, _OTHER_TENDONS)


def _long_tendons(search: TendonSearch) -> Claim:
    claim, paper = "l0 = 9 cm with k <= 30 N/cm: those that fold", "none"
    places = [place for stiffness in (10, 20, 30) if (place := search.at(stiffness, 9)) is not None]
    if len(places) < 3:
        return _row(claim, paper, "not in the study", None, _ABSENT)
    folds = [place for place in places if search.folds[place]]
    ours = "; ".join(search.name(place) for place in folds) or "none"
    # tests/reproduction/test_binder2025.py checks this reason with the model
    why = (
        "A tendon of 9 cm is slack beyond about 70 deg, where inertia carries the hinges on. With ten times the hinge"
        " damping of the simulation, the wing of 10 N/cm is still there after its second under 50 N cm."
    )
    return _row(claim, paper, ours, not folds, why)


def _least_torque(search: TendonSearch) -> Claim:
    claim, paper = "least folding torque of all", "20 N cm, at k = 10 N/cm"
    torque = np.where(search.folds, search.values("least_fold_torque"), np.inf)
    least = float(torque.min())
    if not math.isfinite(least):
        return _row(claim, paper, "none folds", False)
    easiest = np.isclose(torque, least)
    # a refined search finds a smaller value than the corresponding step of the paper's grid
    step = math.ceil(least / _TORQUE_STEP - 1e-6)
    soft = np.isclose(search.stiffness, 1e3)
    if not search.covers:
        return _row(claim, paper, f"{100 * least:.4g} N cm, at {search.names(easiest)}", None, _OTHER_TENDONS)
    agrees = step == 2 and bool(easiest[soft].any())
    return _row(claim, paper, f"{100 * least:.4g} N cm, at {search.names(easiest)}", agrees, _GEOMETRY)


def _fastest(search: TendonSearch) -> Claim:
    claim, paper = "fastest folding", "k = 10 N/cm, l0 = 0 cm, 50 N cm"
    torques = np.asarray(search.table["fold_torque"].values, dtype=float)
    times = np.where(torques <= _FOLD_TORQUE * (1 + 1e-9), search.values("fold_time_by_torque"), np.nan)
    if not np.isfinite(times).any():
        return _row(claim, paper, "none folds", False)
    fastest = np.argwhere(np.isclose(times, np.nanmin(times), rtol=1e-9))
    ours = "; ".join(f"{search.name(place)}, {100 * torques[place[2]]:.4g} N cm" for place in fastest[:AS_MANY])
    if not search.covers:
        return _row(claim, paper, ours, None, _OTHER_TENDONS)
    agrees = any(
        tuple(place[:2]) == search.at(10, 0) and np.isclose(torques[place[2]], _FOLD_TORQUE) for place in fastest
    )
    return _row(claim, paper, ours, agrees)


def _least_work(search: TendonSearch) -> Claim:
    claim, paper = "least work of folding", "k = 10 N/cm, l0 = 7 to 8 cm"
    work = np.where(search.folds, search.values("fold_work"), np.nan)
    if not np.isfinite(work).any():
        return _row(claim, paper, "none folds", False)
    row, column = np.unravel_index(int(np.nanargmin(work)), work.shape)
    place, papers = (int(row), int(column)), [search.at(10, length) for length in (7, 8)]
    ours = f"{search.name(place)}: {work[place]:.3g} J"
    if not search.covers:
        return _row(claim, paper, ours, None, _OTHER_TENDONS)
    torque = search.values("least_fold_torque")
    same_torque = all(np.isclose(torque[place], torque[other]) for other in papers if other is not None)
    why = (
        "The least torque is the same as at 7 and 8 cm. The work is that torque times the angle through which the veins"
        " turn before the wing is folded, and this angle is smaller in the simulation at this length."
    )
    return _row(claim, paper, ours, place in papers, why if same_torque else "")


def _large_torque(search: TendonSearch) -> Claim:
    claim, paper = "tendons that fold with 500 N cm", "all but one"
    outcome, large, tried, unknown = _folded_at_large_torque(search)
    failed = tried & (outcome != FOLDED)
    ours = f"{int((tried & ~failed).sum())} of {int(tried.sum())} tried"
    ours += f"; not {search.names(failed)}" if failed.any() else ""
    if unknown.any():
        return _row(claim, paper, ours, None, _UNKNOWN, mark="derived")
    if not (search.whole and large and tried.all()):
        why = "The study did not fold all of the paper's 60 tendons with 500 N cm."
        return _row(claim, paper, ours, None, why, mark="derived")
    why = "" if failed.any() else _NO_ERROR.format("failure")
    return _row(claim, paper, ours, failed.sum() == 1, why, mark="derived")


def _outlier(search: TendonSearch) -> Claim:
    claim, paper = "tendons that fold with at most 50 N cm but stick with 500 N cm", "one"
    outcome, large, tried, unknown = _folded_at_large_torque(search)
    stuck = search.folds & tried & (outcome != FOLDED)
    ours = f"{int(stuck.sum())}: {search.names(stuck)}" if stuck.any() else "none"
    if unknown.any():
        return _row(claim, paper, ours, None, _UNKNOWN)
    if not (search.whole and large and tried[search.folds].all()):
        return _row(
            claim,
            paper,
            ours,
            None,
            "The study does not have the paper's 60 tendons, or did not also fold them with 500 N cm.",
        )
    why = "" if stuck.any() else _NO_ERROR.format("outlier")
    return _row(claim, paper, ours, stuck.sum() == 1, why)


def _folded_at_large_torque(search: TendonSearch) -> tuple[NDArray[np.str_], bool, Mask, Mask]:
    """Return the outcome of folding each tendon, whether with 500 N cm, and which were tried or are inconclusive."""
    torque = float(search.table["reference_outcome"].attrs.get("torque", math.nan))
    outcome = search.values("reference_outcome").astype(str)
    unknown = np.isin(outcome, _INCONCLUSIVE)
    tried = ~np.isin(outcome, ["", "nan", "None"]) & ~unknown
    return outcome, bool(np.isclose(torque, 5.0)), tried, unknown


def _first_to_open(search: TendonSearch) -> Claim:
    """Check that with a tendon that opens, all longer ones of its stiffness and all softer ones of its length open."""
    claim, paper = "those that open first", "long l0 and small k"
    if not search.opens.any():
        return _row(claim, paper, "none opens", None, _NONE_OPENS)
    # a tendon that never folds was not driven to open, so it does not count
    longer = _holds_from_first(search.opens, search.folds)
    softer = _holds_from_first(search.opens[::-1].T, search.folds[::-1].T)
    shortest = [
        f"{100 * search.rest_length[np.flatnonzero(opens)[0]]:.4g} cm at {stiffness / 100:.4g} N/cm"
        for stiffness, opens in zip(search.stiffness, search.opens, strict=True)
        if opens.any()
    ]
    return _row(claim, paper, f"shortest that open: {', '.join(shortest)}", longer and softer)


def _holds_from_first(holds: Mask, counts: Mask) -> bool:
    """Return whether a condition holds in each row for all counted entries after the first one that satisfies it."""
    return all(row[can][np.argmax(row[can]) :].all() for row, can in zip(holds, counts, strict=True) if row[can].any())


def _flat_above_opened(search: TendonSearch) -> Claim:
    flat, opened = search.values("flat_energy"), search.values("opened_energy")
    result = np.isfinite(flat) & np.isfinite(opened)
    claim, paper = "tendons' energy, flat and opened", "E_flat > E_opened"
    if not result.any():
        return _row(claim, paper, "none opens", None, _NONE_OPENS)
    apart = (flat - opened)[result] / flat[result]
    higher, count = int((apart > _EQUAL).sum()), int(result.sum())
    equal = bool((np.abs(apart) <= _EQUAL).all())
    ours = f"equal in all {count}" if equal else f"E_flat > E_opened in {higher} of {count}"
    why = "Both states rest at the same stops of the hinges, so the tendons are equally long." if equal else ""
    return _row(claim, paper, ours, higher == count, why)


def _opened_above_folded(search: TendonSearch) -> Claim:
    opened, folded = search.values("opened_energy"), search.values("folded_energy")
    return _ordering("tendons' energy, opened and folded", "E_opened > E_folded", opened, folded)


def _unfold_work(search: TendonSearch) -> Claim:
    work, opened = search.values("unfold_work"), search.values("opened_energy")
    return _ordering("work of unfolding and tendons' energy when opened", "W_unfold > E_opened", work, opened)


def _ordering(claim: str, paper: str, larger: Array, smaller: Array) -> Claim:
    """Compare two quantities: whether one is larger wherever both are known."""
    result = np.isfinite(larger) & np.isfinite(smaller)
    if not result.any():
        return _row(claim, paper, "none opens", None, _NONE_OPENS)
    holds, count = int((larger > smaller)[result].sum()), int(result.sum())
    return _row(claim, paper, f"{paper} in {holds} of {count}", holds == count)


def _residual_energy(search: TendonSearch) -> Claim:
    claim, paper = "tendons' energy left when folded", "some, where l0 is short"
    flat, folded = search.values("flat_energy"), search.values("folded_energy")
    result = np.isfinite(flat) & np.isfinite(folded)
    left = result & (folded > _EQUAL * flat)
    if not result.any():
        return _row(claim, paper, "none folds", None)
    ours = f"in {int(left.sum())} of {int(result.sum())}" + (f": {search.names(left)}" if left.any() else "")
    # if a tendon keeps some energy, so do all shorter ones of its stiffness
    return _row(claim, paper, ours, left.any() and _holds_from_first(left[:, ::-1], result[:, ::-1]))


def _works(search: TendonSearch) -> Claim:
    claim, paper = "work of folding and of unfolding", "W_fold << W_unfold"
    fold, unfold = search.values("fold_work"), search.values("unfold_work")
    result = np.isfinite(fold) & np.isfinite(unfold)
    if not result.any():
        return _row(claim, paper, "none opens", None, _NONE_OPENS)
    share = fold[result] / unfold[result]
    ours = f"W_fold is {share.min():.2g} to {share.max():.2g} of W_unfold in {int(result.sum())}"
    return _row(claim, paper, ours, share.max() < _MUCH_LESS)


BINDER2025 = Reproduction(
    name="binder2025",
    short="Binder et al. 2025",
    authors="Binder, Costi, Izzo, Seidl",
    published="Biomimetics 11(1):9, 2025, doi 10.3390/biomimetics11010009",
    # Figures 5 and 6C
    tendon=1,
    hinge=2,
    fold_count=_FOLDS,
    check=check,
    claims=claims,
)
