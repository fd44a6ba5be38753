"""What becomes of a structure over cycles, on the page of its run."""

from __future__ import annotations

from itertools import chain

from forficula.show.page.html import Cell, paragraph, remarks, section, table
from forficula.show.page.words import readable
from forficula.study.cycling import CycleRun, Cycling

_NONE = "—"


def cycling_section(cycling: Cycling, drawn: str) -> str:
    """The verdict, the figure as HTML, a row for every cycle, and what to know."""
    asked = [(each, each.wording.doing) for each in cycling.transitions]
    headings = ["cycle", "stiffness by the first", "residual strain"]
    headings += [f"{doing}: {what}" for _, doing in asked for what in ("time", "work", "margin")]
    return section(
        "Over cycles",
        paragraph(f"{cycling.verdict[:1].upper()}{cycling.verdict[1:]}.".replace(" -", " −")),
        drawn,
        table("Every cycle that was run", [*headings, "status"], [_row(cycling, run) for run in cycling.runs]),
        remarks(cycling.remarks),
        name="cycles",
    )


def _row(cycling: Cycling, run: CycleRun) -> list[str | Cell]:
    """A cycle; one that the tests of the material did not see, or that did not work, says so."""
    value, *bounds = run.stiffness
    low, high = (f"{bound:.3g}" for bound in bounds)
    numbers = chain.from_iterable(
        (
            _number(run.row.get(f"{each.name}_time_s"), "s"),
            _number(run.row.get(f"{each.name}_work_J"), "J"),
            _number(run.margins.get(each.name), ""),
        )
        for each in cycling.transitions
    )
    return [
        Cell(text=str(run.cycle), note="" if run.measured else "extrapolated"),
        f"{value:.3g} ({low} to {high})",
        f"{100 * run.residual_strain:.3g} %".replace("-", "−"),
        *numbers,
        Cell(text=str(run.row["status"]).replace(" -", " −"), marked=not cycling.works(run)),
    ]


def _number(value: float | None, unit: str) -> str:
    if value is None:
        return _NONE
    return readable(value, unit) if unit else f"{value:.3g}"
