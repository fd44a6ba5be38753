"""A design's landscape and, beside it, a run that is sampled finely enough to be compared."""

from __future__ import annotations

from collections.abc import Callable

from forficula.analysis.simulated_snap import finely_sampled
from forficula.design import Design
from forficula.dynamics import Record
from forficula.dynamics.stepping.simulate import Progress
from forficula.statics import EnergyLandscape, energy_landscape
from forficula.study.running.runs import run


def landscape_and_run(
    design: Design,
    *,
    simulation: bool,
    progress: Progress | None = None,
    steps: Callable[[str], None] = lambda _: None,
) -> tuple[EnergyLandscape, Record | None]:
    """Find a design's energy landscape, and run it where that is wanted.

    Args:
        design: of which.
        simulation: whether to run it, too.
        progress: of the run, which comes first.
        steps: is told what is surveyed.
    """
    record = run(finely_sampled(design), progress) if simulation else None
    return energy_landscape(design, progress=steps), record
