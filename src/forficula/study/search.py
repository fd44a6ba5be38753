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

_FOLDING = {"fold_time": "s", "fold_work": "J", "folded_energy": "J"}
_OPENING = {"unfold_time": "s", "unfold_work": "J", "opened_energy": "J"}


def search_designs(design: Design, search: Search, rows: Rows) -> list[Design]:
    """The designs that must run to find the least torques, as far as the rows so far tell.

    Folding is tried with every torque, for it need not be monotone, and only the least that folds is also released.
    Opening is tried where some torque folds, from the wing folded with `fold_with`, rising, up to the least torque that
    opens; a search without unfold torques leaves that out. What runs next can depend on the last rows: ask again until
    none is missing.
    """
    fold_torques = _torques(design, search, rows, "fold")
    wanted = [fold_design(design, torque) for torque in fold_torques]
    folds = [rows.get(row_key(each)) for each in wanted]
    if any(row is None for row in folds):
        return wanted
    least = _least(dict(zip(fold_torques, folds, strict=True)), "folded")
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
    """What the rows say of one point: the least torques (N m), times (s), work and energies (J), and a status.

    Times, work and energies of folding are those at the least torque that folds, likewise of unfolding; None where no
    torque does.
    """
    folds = {torque: rows[row_key(fold_design(design, torque))] for torque in _torques(design, search, rows, "fold")}
    # there are none above the least torque that opens, nor where no torque folds
    opens = {
        torque: rows.get(row_key(unfold_design(design, search.fold_with, torque)))
        for torque in _torques(design, search, rows, "unfold")
    }
    least_fold, least_unfold = _least(folds, "folded"), _least(opens, "opened")
    folding = folds[max(folds)] if least_fold is None else rows[row_key(release_design(design, least_fold))]
    opening = opens.get(max(opens, default=0.0) if least_unfold is None else least_unfold) or {}
    result = {
        "least_fold_torque": least_fold,
        "least_unfold_torque": least_unfold,
        "flat_energy": folding.get("flat_energy_J"),
        "fold_status": folding["status"],
        "reference_fold_status": "folded" if opening.get("folded") else opening.get("status", ""),
        "status": folding["status"],
    }
    if least_fold is not None:
        result |= {name: folding[f"{name}_{unit}"] for name, unit in _FOLDING.items()}
        result["status"] = _status(search, folding, opening)
    if least_unfold is not None:
        result |= {name: opening[f"{name}_{unit}"] for name, unit in _OPENING.items()}
    return result


def _status(search: Search, folding: Row, opening: Row) -> str:
    """How a wing that some torque folds opened, and what failed before: its release, folding with the large torque."""
    if not search.unfold_torques:
        return str(folding["status"])
    large = f"with {show_quantity(search.fold_with, TORQUE)}: {opening['status']}"
    if not folding["folded"]:
        return f"{folding['status']}; {large}"
    return str(opening["status"]) if opening.get("folded") else large


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
