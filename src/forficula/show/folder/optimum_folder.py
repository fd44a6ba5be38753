"""Files of an optimisation, in addition to its journal."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from forficula.design import save_design
from forficula.design.design import DesignIdentity
from forficula.dynamics import versions
from forficula.files import replacing_all, write_bytes, write_text
from forficula.goals.goal import own_limits
from forficula.goals.optimise.candidate import Neighbours, Verification
from forficula.goals.optimise.optimum import Effort, Optimum
from forficula.goals.optimise.optimum_table import optimum_csv
from forficula.goals.optimise.summary import summary_sentences
from forficula.goals.optimise.trials import Relaxation
from forficula.serial import Seconds, Written, json_text
from forficula.show.folder.notebook_cell import printed_with_figure
from forficula.show.folder.presentation import Presentation
from forficula.show.goals.optimum_figures import draw_candidates, draw_front
from forficula.show.goals.optimum_text import optimum_text
from forficula.show.page.goal_page import write_goal_page
from forficula.show.page.parts.rich_html import printed_result
from forficula.show.style import Drawing, save_figures
from forficula.study.running.kept_runs import KeptRun

OPTIMUM_FILE = "optimum.json"


def write_optimum(optimum: Optimum, folder: Path) -> None:
    """Write the best designs as design files, optimum.json, table.csv, table.nc and the figures.

    Args:
        optimum: the result.
        folder: folder with the journal; files of an earlier result are replaced.

    Raises:
        InputError: the folder cannot be written.
    """
    names = [f"best-{index:02d}.toml" for index in range(1, len(optimum.designs) + 1)]
    names = ["best.toml"] if len(names) == 1 else names
    with replacing_all(folder, [path.name for path in folder.glob("best*.toml")]) as unfinished:
        for name, design in zip(names, optimum.designs, strict=True):
            save_design(design, unfinished / name)
        write_text(unfinished / OPTIMUM_FILE, json_text(optimum_summary(optimum)))
        write_text(unfinished / "table.csv", optimum_csv(optimum.table))
        write_bytes(unfinished / "table.nc", optimum.table.to_netcdf(engine="h5netcdf"))
        save_figures(optimum_drawings(optimum), unfinished)


def optimum_drawings(optimum: Optimum) -> dict[str, Drawing]:
    """Return the drawings of an optimisation by the stems of their files."""
    drawings: dict[str, Drawing] = {"candidates": lambda width: draw_candidates(optimum, width)}
    if len(optimum.goal.objectives) > 1:
        drawings["front"] = lambda width: draw_front(optimum, width)
    return drawings


def write_optimum_report(optimum: Optimum, kept: Iterable[KeptRun], count: int, folder: Path) -> None:
    """Write the page of an optimisation, `report.html`.

    Args:
        optimum: the result.
        kept: runs to play back, read one after another.
        count: number of these runs.
        folder: folder of the results.

    Raises:
        InputError: it cannot be written.
    """
    write_goal_page(optimum, printed_result(optimum_text(optimum)), folder / "report.html", kept, count)


@dataclass(frozen=True, kw_only=True)
class VerifiedDesign:
    """Design that meets a goal, with its verification. Quantities are in SI."""

    values: Mapping[str, Any]
    quantities: Mapping[str, float | None]
    least_margin: float
    neighbours: Neighbours | None
    fresh_neighbours: Neighbours | None
    timestep: Seconds | None
    margin_at_quarter_timestep: float | None
    residual_at_quarter_timestep: float | None
    holds: bool


@dataclass(frozen=True, kw_only=True)
class OptimumSummary:
    """Optimisation as in `optimum.json`."""

    goal: str
    design: Annotated[DesignIdentity, Written.BESIDE]
    objectives: Mapping[str, str]
    limits: Sequence[str]
    says: Sequence[str]
    best: Sequence[VerifiedDesign]
    discarded: Sequence[VerifiedDesign]
    effort: Effort
    would_have_to_give: Mapping[str, Relaxation]
    seed: int
    versions: Mapping[str, str]


def optimum_summary(optimum: Optimum) -> OptimumSummary:
    """Return the contents of `optimum.json`."""
    goal = optimum.goal
    names = [*map(str, own_limits(goal)), "works"]
    return OptimumSummary(
        goal=goal.name,
        design=goal.base.identity,
        objectives={objective.quantity.name: objective.kind for objective in goal.objectives},
        limits=[str(limit) for limit in (*goal.torque_limits, *goal.limits)],
        says=summary_sentences(optimum),
        best=[_verified(optimum, item) for item in optimum.best],
        discarded=[_verified(optimum, item) for item in optimum.discarded],
        effort=optimum.effort,
        would_have_to_give={names[relaxation.limit]: relaxation for relaxation in optimum.relaxations},
        seed=goal.seed,
        versions=versions(),
    )


def _verified(optimum: Optimum, verification: Verification) -> VerifiedDesign:
    candidate = verification.candidate
    return VerifiedDesign(
        values=candidate.values,
        quantities={quantity.name: candidate.value(quantity) for quantity in optimum.goal.quantities},
        least_margin=candidate.screened.least,
        neighbours=candidate.neighbours,
        fresh_neighbours=verification.fresh,
        timestep=verification.timestep,
        margin_at_quarter_timestep=None if verification.finer is None else verification.finer.least,
        residual_at_quarter_timestep=verification.residual,
        holds=verification.holds,
    )


def _write(optimum: Optimum, folder: Path) -> None:
    """Write an optimum without kept runs: its page plays none."""
    write_optimum(optimum, folder)
    write_optimum_report(optimum, (), 0, folder)


PRESENTATION = Presentation(
    drawings=optimum_drawings,
    cell=lambda optimum: printed_with_figure(optimum_text(optimum), optimum_drawings(optimum)),
    copied="a search are not drawn again",
    write=_write,
)
