"""Calls that run a design, and that compute its energy landscape."""

from __future__ import annotations

from typing import TYPE_CHECKING

from forficula.calls.progress import Progress, ProgressOption, reporting, simulated
from forficula.design import AnyDesign, as_design, with_values
from forficula.files import AnyPath

if TYPE_CHECKING:
    from collections.abc import Callable

    from forficula.analysis.run import Run
    from forficula.statics import EnergyLandscape, QuasiStaticPath, QuasiStaticPoint


def run(design: AnyDesign, progress: ProgressOption = None, *, confirm: bool = True, device: str | None = None) -> Run:
    """Run a design through its protocol, as `forficula run` does.

    Args:
        design: design, its name, or the path of a design file, a FOLD file or a drawing.
        progress: function that is called with every `Progress`; True shows the progress, False does not, None shows it
            in notebooks and on terminals only.
        confirm: whether to run the design also at half the timestep and from a slightly different start, for the
            numerical uncertainty of the results; a verdict that changes is "undecided". Without it, a loop over many
            designs takes a quarter of the time.
        device: "gpu" simulates in single precision on a graphics processor, "cpu" in double precision on the processor;
            by default `protocol.device` of the design.

    Returns:
        Run with its record, outcome, figures and page. If the timestep is "auto", the design of the run has the
        timestep that was found. A timestep that the law of the tendons does not allow becomes "auto", with a warning,
        unless it was set.

    Raises:
        InputError: no such design, or it cannot be built.

    >>> result = ff.run(design)
    >>> result.outcome.status
    'closed and opened'
    """
    from forficula.analysis.run import Run
    from forficula.study.running.law_timestep import with_timestep_for_law
    from forficula.study.running.runs import run as run_one

    chosen = as_design(design)
    read = with_timestep_for_law(chosen if device is None else with_values(chosen, {"protocol.device": device}))
    with reporting(progress, simulated) as tell:
        return Run(run_one(read, tell, confirm=confirm))


def load_run(path: AnyPath) -> Run:
    """Load a run from its folder, or from its record.nc.

    Args:
        path: folder that `forficula run` or `Run.save` wrote, or the file of a record.

    Raises:
        InputError: no such file, or it contains no record.

    >>> ff.run(design, confirm=False).save("loaded")
    >>> ff.load_run("loaded")
    <Run of letter-fold: closed and opened>
    """
    from forficula.analysis.run import Run
    from forficula.dynamics import load_record

    return Run(load_record(path))


def landscape(design: AnyDesign, points: int = 181, *, progress: ProgressOption = None) -> EnergyLandscape:
    """Compute the energy landscape of a design by statics, as `forficula landscape --no-simulation` does.

    Args:
        design: design, its name or its path.
        points: number of points of each curve.
        progress: as in `run`.

    Returns:
        Stable states with energies, barriers between them, and the least torques or forces of each transition.

    Raises:
        InputError: no such design, or it cannot be built.

    >>> landscape = ff.landscape("binder2025")
    >>> f"{1e3 * landscape.barrier('flat', 'folded'):.2f} mJ"
    '2.08 mJ'
    """
    from forficula.statics import energy_landscape

    read = as_design(design)
    with reporting(progress, lambda step: Progress(task=step)) as tell:
        return energy_landscape(read, points) if tell is None else energy_landscape(read, points, tell)


def quasi_static_path(
    design: AnyDesign,
    transition: str | None = None,
    *,
    near: QuasiStaticPoint | None = None,
    error: float = 2e-3,
    follow: Callable[[QuasiStaticPath], bool] | None = None,
) -> QuasiStaticPath:
    """Compute the shapes through which a slowly growing drive takes a structure, from rest to the goal of a transition.

    The structure is at rest at every point except within snaps. The slider "fold 0 to 100 %" of a page moves along this
    path.

    Args:
        design: design, its name, or the path of a design file, a FOLD file or a drawing.
        transition: name of the transition; by default the first one, or the first drive of a design without
            transitions.
        near: shape on the path of the design before values changed, from `QuasiStaticPath.point`: the path is then
            computed from the nearest equilibrium, first onwards to its end and then back to its start. A shape of a
            structure with other parts is ignored.
        error: largest distance between a point of the structure and its linear interpolation between points of the
            path, as a share of the structure's span; above 0.
        follow: called with the growing path; returns whether to go on. A path that it ends has `complete` False.

    Returns:
        Shapes, drive, energies, moments and strains along the path, with its snaps and branches.

    Raises:
        InputError: no such design or transition, it cannot be built, or it has no drive.

    >>> path = ff.quasi_static_path(design)
    >>> path
    <QuasiStaticPath close: 18 points; snap at 0 %, goal at 100 %>
    >>> path.marks[0].text
    'The structure snaps when the drive "close" reaches 0.203 N cm; the snap releases 68.8 mJ.'
    """
    from forficula.statics import quasi_static_path as path_of

    return path_of(as_design(design), transition, near=near, error=error, follow=follow)
