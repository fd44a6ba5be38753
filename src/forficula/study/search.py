"""The least torques that fold a wing and that open it again."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from forficula.design import TORQUE, Design, Stage, with_values
from forficula.quantities import show_quantity
from forficula.study.evaluate import row_key
from forficula.study.journal import Row
from forficula.study.study import Search

Rows = Mapping[str, Row]


def search_designs(design: Design, search: Search, rows: Rows) -> list[Design]:
    """The designs that must run to find the least torques, as far as the rows so far tell.

    Folding is tried with every torque, for it need not be monotone. Opening is tried from the wing folded with
    `fold_with`. Where a refinement is asked, the next torque depends on the last row: ask again until none is missing.
    """
    folding = {torque: fold_design(design, torque) for torque in _torques(design, search, rows, "fold")}
    opening = {
        torque: unfold_design(design, search.fold_with, torque) for torque in _torques(design, search, rows, "unfold")
    }
    return [*folding.values(), *opening.values()]


def search_result(design: Design, search: Search, rows: Rows) -> dict[str, Any]:
    """What the rows say of one point: the least torques (N m), times (s), work and energies (J), and a status.

    Times, work and energies of folding are those at the least torque that folds, likewise of unfolding; None where no
    torque does. `folds` has the folding row of every torque that was tried.
    """
    folds = {torque: rows[row_key(fold_design(design, torque))] for torque in _torques(design, search, rows, "fold")}
    opens = {
        torque: rows[row_key(unfold_design(design, search.fold_with, torque))]
        for torque in _torques(design, search, rows, "unfold")
    }
    least_fold = next((torque for torque, row in folds.items() if row.get("folded")), None)
    least_unfold = next((torque for torque, row in opens.items() if row.get("opened")), None)
    folding = folds[max(folds) if least_fold is None else least_fold]
    opening = opens[max(opens) if least_unfold is None else least_unfold]
    large = f"with {show_quantity(search.fold_with, TORQUE)}: "
    failed = not opening.get("folded")
    return {
        "least_fold_torque": least_fold,
        "least_unfold_torque": least_unfold,
        "fold_time": folding.get("fold_time_s") if least_fold is not None else None,
        "unfold_time": opening.get("unfold_time_s") if least_unfold is not None else None,
        "fold_work": folding.get("fold_work_J") if least_fold is not None else None,
        "unfold_work": opening.get("unfold_work_J") if least_unfold is not None else None,
        "flat_energy": folding.get("flat_energy_J"),
        "folded_energy": folding.get("folded_energy_J") if least_fold is not None else None,
        "opened_energy": opening.get("opened_energy_J") if least_unfold is not None else None,
        "status": folding["status"]
        if least_fold is None
        else f"{large}{opening['status']}"
        if failed
        else opening["status"],
        "fold_status": folding["status"],
        "reference_fold_status": opening["status"] if failed else "folded",
        "folds": folds,
    }


def fold_design(design: Design, torque: float) -> Design:
    """The design whose protocol ends before any unfolding, with a fold torque, N m."""
    drives = [stage.drive for stage in design.protocol.stages]
    stages = design.protocol.stages[: drives.index("unfold")] if "unfold" in drives else design.protocol.stages
    return _with(design, fold_torque=torque, stages=stages)


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
        if any(row is None for row in found):
            return tried
        goal = "folded" if drive == "fold" else "opened"
        least = next((index for index, row in enumerate(found) if row and row.get(goal)), 0)
        if least == 0:
            return tried
        tried.insert(least, (tried[least - 1] + tried[least]) / 2)
    return tried


def _key(design: Design, search: Search, drive: str, torque: float) -> str:
    return row_key(fold_design(design, torque) if drive == "fold" else unfold_design(design, search.fold_with, torque))


def point_design(base: Design, point: Mapping[str, object]) -> Design:
    """The design at a point of a study.

    Raises:
        InputError: the values do not fit together there.
    """
    return with_values(base, dict(point))
