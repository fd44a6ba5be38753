"""The files that a search for the best design leaves beside its journal."""

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
from forficula.goals.optimise.telling import told
from forficula.goals.optimise.trials import Relaxation
from forficula.serial import Seconds, Written, json_text
from forficula.show.folder.cell import printed_with_figure
from forficula.show.folder.presentation import Presentation
from forficula.show.goals.optimum_figures import draw_candidates, draw_front
from forficula.show.goals.optimum_text import optimum_text
from forficula.show.page.goal_page import write_goal_page
from forficula.show.page.parts.rich_html import laid_out
from forficula.show.style import Drawing, save_figures
from forficula.study.running.kept_runs import KeptRun

OPTIMUM_FILE = "optimum.json"


def write_optimum(found: Optimum, folder: Path) -> None:
    """Write the best designs as design files, optimum.json, table.csv, table.nc and the figures.

    Args:
        found: what the search came to.
        folder: with the journal; what an earlier result left there is replaced.

    Raises:
        InputError: the folder cannot be written.
    """
    names = [f"best-{each:02d}.toml" for each in range(1, len(found.designs) + 1)]
    names = ["best.toml"] if len(names) == 1 else names
    with replacing_all(folder, [path.name for path in folder.glob("best*.toml")]) as unfinished:
        for name, design in zip(names, found.designs, strict=True):
            save_design(design, unfinished / name)
        write_text(unfinished / OPTIMUM_FILE, json_text(optimum_summary(found)))
        write_text(unfinished / "table.csv", optimum_csv(found.table))
        write_bytes(unfinished / "table.nc", found.table.to_netcdf(engine="h5netcdf"))
        save_figures(optimum_drawings(found), unfinished)


def optimum_drawings(found: Optimum) -> dict[str, Drawing]:
    """What draws a search, by the stem of its file."""
    drawings: dict[str, Drawing] = {"candidates": lambda width: draw_candidates(found, width)}
    if len(found.goal.objectives) > 1:
        drawings["front"] = lambda width: draw_front(found, width)
    return drawings


def write_optimum_report(found: Optimum, kept: Iterable[KeptRun], count: int, folder: Path) -> None:
    """Write the search as one page, `report.html`.

    Args:
        found: what the search came to.
        kept: the runs that can be played, taken one after another.
        count: how many these are.
        folder: of the results.

    Raises:
        InputError: it cannot be written.
    """
    write_goal_page(found, laid_out(optimum_text(found)), folder / "report.html", kept, count)


@dataclass(frozen=True, kw_only=True)
class VerifiedDesign:
    """A design that meets a goal, and how it does where the search did not look. Quantities are in SI."""

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
    """The result of a search for the best design, as `optimum.json` has it."""

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


def optimum_summary(found: Optimum) -> OptimumSummary:
    """Return the result of a search as `optimum.json` has it."""
    goal = found.goal
    names = [*map(str, own_limits(goal)), "works"]
    return OptimumSummary(
        goal=goal.name,
        design=goal.base.identity,
        objectives={each.quantity.name: each.kind for each in goal.objectives},
        limits=[str(each) for each in (*goal.given, *goal.limits)],
        says=told(found),
        best=[_verified(found, each) for each in found.best],
        discarded=[_verified(found, each) for each in found.discarded],
        effort=found.effort,
        would_have_to_give={names[each.limit]: each for each in found.relaxations},
        seed=goal.seed,
        versions=versions(),
    )


def _verified(found: Optimum, each: Verification) -> VerifiedDesign:
    candidate = each.candidate
    return VerifiedDesign(
        values=candidate.values,
        quantities={quantity.name: candidate.value(quantity) for quantity in found.goal.quantities},
        least_margin=candidate.found.least,
        neighbours=candidate.neighbours,
        fresh_neighbours=each.fresh,
        timestep=each.timestep,
        margin_at_quarter_timestep=None if each.finer is None else each.finer.least,
        residual_at_quarter_timestep=each.residual,
        holds=each.holds,
    )


def _write(found: Optimum, folder: Path) -> None:
    """Write an optimum without kept runs, so its page plays none."""
    write_optimum(found, folder)
    write_optimum_report(found, (), 0, folder)


PRESENTATION = Presentation(
    drawings=optimum_drawings,
    cell=lambda found: printed_with_figure(optimum_text(found), optimum_drawings(found)),
    copied="a search are not drawn again",
    write=_write,
)
