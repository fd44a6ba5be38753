"""The files that an optimisation leaves beside its journal."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from forficula.design import save_design
from forficula.dynamics import versions
from forficula.files import replacing_all, write_bytes, write_text
from forficula.goals.margins import own_limits
from forficula.goals.optimise.neighbours import Neighbours
from forficula.goals.optimise.optimum import Optimum
from forficula.goals.optimise.optimum_table import optimum_csv
from forficula.goals.optimise.telling import told
from forficula.goals.optimise.verification import Verification
from forficula.show.goals.optimum_figures import draw_candidates, draw_front
from forficula.show.goals.optimum_text import optimum_text
from forficula.show.page.goal_page import write_goal_page
from forficula.show.page.rich_html import laid_out
from forficula.show.style import Drawing, save_figures
from forficula.study.kept_runs import KeptRun

OPTIMUM_FILE = "optimum.json"
_DESIGNS = "designs"


def write_optimum(found: Optimum, folder: Path) -> None:
    """Write optimum.json, table.csv, table.nc, the figures, and the best designs as files, ready to run.

    Args:
        found: what the search came to.
        folder: with the journal; what an earlier result left there is replaced.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder) as unfinished:
        write_text(unfinished / OPTIMUM_FILE, json.dumps(optimum_json(found), indent=2, ensure_ascii=False) + "\n")
        write_text(unfinished / "table.csv", optimum_csv(found.table))
        write_bytes(unfinished / "table.nc", found.table.to_netcdf(engine="h5netcdf"))
        save_figures(optimum_drawings(found), unfinished)
    shutil.rmtree(folder / _DESIGNS, ignore_errors=True)
    for number, design in enumerate(found.designs, start=1):
        save_design(design.with_values({"name": f"{found.goal.name}-{number}"}), folder / _DESIGNS / f"{number}.toml")


def write_optimum_report(found: Optimum, kept: Iterable[KeptRun], count: int, folder: Path) -> None:
    """Write the optimisation as one page, `report.html`.

    Args:
        found: what the search came to.
        kept: the runs that can be played, taken one after another.
        count: how many these are.
        folder: of the results.

    Raises:
        InputError: it cannot be written.
    """
    write_goal_page(found, laid_out(optimum_text(found)), folder / "report.html", kept, count)


def optimum_drawings(found: Optimum) -> dict[str, Drawing]:
    """What draws an optimisation, by the stem of its file."""
    drawings: dict[str, Drawing] = {"candidates": lambda width: draw_candidates(found, width)}
    if len(found.goal.objectives) > 1:
        drawings["front"] = lambda width: draw_front(found, width)
    return drawings


def optimum_json(found: Optimum) -> dict[str, Any]:
    """An optimisation as plain data, SI; None where there is no number."""
    goal, effort = found.goal, found.effort
    return {
        "goal": goal.name,
        "design": goal.base.name,
        "design_hash": goal.base.hash,
        "objectives": {each.quantity.name: each.kind for each in goal.objectives},
        "limits": [str(each) for each in (*goal.given, *goal.limits)],
        "feasible": found.feasible,
        "says": told(found),
        "best": [_best(found, each) for each in found.best],
        "discarded": [_best(found, each) for each in found.discarded],
        "designs_tried": effort.tried,
        "runs": effort.runs,
        "runs_spared": effort.spared_runs,
        "ruled_out_by": dict(effort.ruled_out),
        "neighbour_runs": effort.neighbour_runs,
        "neighbours_spared": effort.spared_neighbours,
        "verification_runs": effort.verification_runs,
        "seed": goal.seed,
        "versions": versions(),
    }


def _best(found: Optimum, each: Verification) -> dict[str, Any]:
    """A verified candidate: parameters as a design file has them, quantities in SI."""
    goal, candidate = found.goal, each.candidate
    margins = zip(own_limits(goal), candidate.found.margins, strict=True)
    return {
        "values": dict(candidate.values),
        "quantities": {quantity.name: candidate.value(quantity) for quantity in goal.quantities},
        "margins": {str(limit): margin for limit, margin in margins},
        "works": candidate.found.works if goal.simulate else None,
        "neighbours": _neighbours(candidate.neighbours),
        "holds_when_verified": each.holds,
        "residual_at_a_quarter_of_the_timestep": each.residual,
        "fresh_neighbours": _neighbours(each.fresh),
    }


def _neighbours(of: Neighbours | None) -> dict[str, Any] | None:
    if of is None:
        return None
    low, high = of.interval
    return {"tried": of.tried, "share": of.share, "low": low, "high": high}
