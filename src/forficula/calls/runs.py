"""Calls that run a design, or survey its energy."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from forficula.design import AnyDesign, as_design

if TYPE_CHECKING:
    from forficula.dynamics import Record
    from forficula.dynamics.stepping.simulate import Progress
    from forficula.statics import EnergyLandscape


def run(design: AnyDesign, progress: Progress | None = None, *, confirm: bool = True) -> Record:
    """Take a design through its protocol, as `forficula run` does.

    Args:
        design: or the name of one, or the path of a design file, a FOLD file or a drawing.
        progress: called now and then with the stage's name, the time so far and the longest it can take, s.
        confirm: whether to run the design also at half the timestep and from a slightly different start, for the
            numerical uncertainty of its numbers; a verdict that changes is "undecided". Without, a loop over many
            designs takes a quarter of the time.

    Returns:
        What happened, sampled at the protocol's interval. `measure` says what that came to, `save` writes it. With a
        timestep "auto" its design has the one that was found.

    Raises:
        InputError: no such design, or it cannot be built.

    >>> record = ff.run(design)
    >>> ff.measure(record).status
    'closed and opened'
    """
    from forficula.study.running.runs import run as run_one

    return run_one(as_design(design), progress, confirm=confirm)


def landscape(design: AnyDesign, *, progress: Callable[[str], None] = lambda _: None) -> EnergyLandscape:
    """Survey a design's energy by statics, as `forficula landscape --no-simulation` does.

    Args:
        design: or its name or path.
        progress: is told what is surveyed.

    Raises:
        InputError: no such design, or it cannot be built.

    >>> surveyed = ff.landscape("binder2025")
    >>> f"{1e3 * ff.barrier(surveyed, 'flat', 'folded'):.2f} mJ"
    '2.08 mJ'
    """
    from forficula.statics import energy_landscape

    return energy_landscape(as_design(design), progress=progress)
