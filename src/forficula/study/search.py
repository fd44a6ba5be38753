"""The least torques that fold a wing and that open it again."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from forficula.analysis import FOLDED, Verdict, ending_word
from forficula.design import TORQUE, Design, Stage, with_values
from forficula.quantities import show_quantity
from forficula.study.evaluate import row_ending, row_key
from forficula.study.journal import Row
from forficula.study.study import Search

Rows = Mapping[str, Row]

_FOLDING = {"fold_time": "s", "fold_work": "J", "folded_energy": "J"}
_OPENING = {"unfold_time": "s", "unfold_work": "J", "opened_energy": "J"}


def search_designs(design: Design, search: Search, rows: Rows) -> list[Design]:
    """The designs that must run to find the least torques, as far as the rows so far tell.

    Folding is tried with every torque, for it need not be monotone, and only the least that folds is also released.
    Opening is tried where there is a least torque that folds, from the wing folded with `fold_with`, rising, up to the
    least torque that opens; a search without unfold torques leaves that out. What runs next can depend on the last
    rows: ask again until none is missing.
    """
    fold_torques = _torques(design, search, rows, "fold")
    wanted = [fold_design(design, torque) for torque in fold_torques]
    folds = [rows.get(row_key(each)) for each in wanted]
    if any(row is None for row in folds):
        return wanted
    least, _ = _decided({torque: row for torque, row in zip(fold_torques, folds, strict=True) if row}, "folded")
    if least is None:
        return wanted
    wanted.append(release_design(design, least))
    for torque in _torques(design, search, rows, "unfold"):
        wanted.append(unfold_design(design, search.fold_with, torque))
        if rows.get(row_key(wanted[-1]), {}).get("opened"):
            break
    return wanted


def most_runs(search: Search) -> int:
    """How many runs a point takes at most."""
    return len(search.fold_torques) + 1 + len(search.unfold_torques) + 2 * search.refinements


def search_result(design: Design, search: Search, rows: Rows) -> dict[str, Any]:
    """What the rows say of one point: the least torques (N m), times (s), work and energies (J), and its ending.

    Times, work and energies of folding are those at the least torque that folds, likewise of unfolding; None where no
    torque does.
    """
    folds = {torque: rows[row_key(fold_design(design, torque))] for torque in _torques(design, search, rows, "fold")}
    least_fold, folding = _decided(folds, "folded")
    # there are none above the least torque that opens
    opens = {
        torque: row
        for torque in _torques(design, search, rows, "unfold")
        if least_fold is not None
        and (row := rows.get(row_key(unfold_design(design, search.fold_with, torque)))) is not None
    }
    if least_fold is not None:
        folding = rows[row_key(release_design(design, least_fold))]
        if not Verdict(folding["verdict"]).tells:
            least_fold, opens = None, {}
    least_unfold, opening = _decided(opens, "opened")
    residuals = [
        row["residual"] for row in (*folds.values(), folding, *opens.values()) if row.get("residual") is not None
    ]
    result = {
        "least_fold_torque": least_fold,
        "least_unfold_torque": least_unfold,
        "flat_energy": folding.get("flat_energy_J"),
        "fold_outcome": ending_word(row_ending(folding)),
        "reference_outcome": _reference(opening),
        "residual": max(residuals, default=None),
        **_ending(search, folding, opening),
    }
    if least_fold is not None:
        result |= {name: folding[f"{name}_{unit}"] for name, unit in _FOLDING.items()}
    if least_unfold is not None:
        result |= {name: opening[f"{name}_{unit}"] for name, unit in _OPENING.items()}
    return result


def _decided(found: Mapping[float, Row], goal: str) -> tuple[float | None, Row]:
    """The least torque that reaches a goal and its row, or none and the row that says why.

    That is the first one, as the torques rise, that says nothing of the wing: below what reaches the goal it may hide a
    lesser torque that does. Otherwise it is that of the largest torque; an empty one where nothing was tried.
    """
    least = _least(found, goal)
    for torque, row in found.items():
        if not Verdict(row["verdict"]).tells:
            return None, row
        if torque == least:
            return least, row
    return None, found[max(found)] if found else {}


def _reference(opening: Row) -> str:
    """How a wing folded with the large torque, in a word; empty where that was not tried."""
    if not opening:
        return ""
    return FOLDED if opening["folded"] else ending_word(row_ending(opening))


def _ending(search: Search, folding: Row, opening: Row) -> dict[str, Any]:
    """How a wing that some torque folds opened, or what failed before: its release, folding with the large torque."""
    told = folding if not (folding.get("folded") and opening) else opening
    word = ending_word(row_ending(told))
    ending = {"status": told["status"], "verdict": told["verdict"], "outcome": word}
    large = show_quantity(search.fold_with, TORQUE)
    if told is folding:
        if opening:
            ending["status"] += f"; with {large}: {opening['status']}"
    elif not opening["folded"]:
        ending["status"] = f"with {large}: {opening['status']}"
        if Verdict(opening["verdict"]).tells:
            ending["outcome"] = f"{word} with {large}"
    return ending


def fold_design(design: Design, torque: float) -> Design:
    """The design whose protocol ends with folding, with a fold torque, N m."""
    drives = [stage.drive for stage in design.protocol.stages]
    last = drives.index("fold") + 1 if "fold" in drives else len(drives)
    return _with(design, fold_torque=torque, stages=design.protocol.stages[:last])


def release_design(design: Design, torque: float) -> Design:
    """The design whose protocol ends before any unfolding, with a fold torque, N m."""
    drives = [stage.drive for stage in design.protocol.stages]
    last = drives.index("unfold") if "unfold" in drives else len(drives)
    return _with(design, fold_torque=torque, stages=design.protocol.stages[:last])


def unfold_design(design: Design, fold_torque: float, unfold_torque: float) -> Design:
    """The design with both torques, N m."""
    return _with(design, fold_torque=fold_torque, unfold_torque=unfold_torque, stages=design.protocol.stages)


def _with(design: Design, stages: Sequence[Stage], **torques: float) -> Design:
    """Replace what was checked when it was read."""
    return design.model_copy(
        update={"protocol": design.protocol.model_copy(update={"stages": tuple(stages), **torques})}
    )


def _torques(design: Design, search: Search, rows: Rows, drive: str) -> list[float]:
    """Torques to try, rising: the grid, and halves of the step below the least that works as far as it is known."""
    tried = list(search.fold_torques if drive == "fold" else search.unfold_torques)
    for _ in range(search.refinements):
        found = [rows.get(_key(design, search, drive, torque)) for torque in tried]
        goal = "folded" if drive == "fold" else "opened"
        least = next((index for index, row in enumerate(found) if row is None or row.get(goal)), 0)
        if least == 0 or found[least] is None:
            return tried
        tried.insert(least, (tried[least - 1] + tried[least]) / 2)
    return tried


def _least(found: Mapping[float, Row | None], goal: str) -> float | None:
    """The least torque whose row says that the goal was reached."""
    return next((torque for torque, row in found.items() if row is not None and row.get(goal)), None)


def _key(design: Design, search: Search, drive: str, torque: float) -> str:
    return row_key(fold_design(design, torque) if drive == "fold" else unfold_design(design, search.fold_with, torque))


def point_design(base: Design, point: Mapping[str, object]) -> Design:
    """The design at a point of a study.

    Raises:
        InputError: the values do not fit together there.
    """
    return with_values(base, dict(point))
