"""Energy landscape of a design, with a run that is sampled finely enough for a comparison."""

from __future__ import annotations

from collections.abc import Callable

from forficula.analysis.simulated_snap import finely_sampled
from forficula.design import Design
from forficula.dynamics import Record
from forficula.dynamics.stepping.simulate import Progress
from forficula.statics import EnergyLandscape, energy_landscape
from forficula.statics.path_dependence import refuse_path_dependence
from forficula.structure import structure_of
from forficula.study.running.runs import run


def landscape_and_run(
    design: Design,
    *,
    simulation: bool,
    progress: Progress | None = None,
    steps: Callable[[str], None] = lambda _: None,
) -> tuple[EnergyLandscape, Record | None]:
    """Compute a design's energy landscape, and run the design if requested.

    Args:
        design: the design.
        simulation: whether to run the design.
        progress: progress callback of the run, which comes first.
        steps: called with a text for each step of the survey.
    """
    refuse_path_dependence(structure_of(design), "energy landscape")  # before the run, which takes longer
    record = run(finely_sampled(design), progress) if simulation else None
    return energy_landscape(design, progress=steps), record
