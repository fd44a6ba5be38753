"""The command that computes the energy landscape of a design by statics."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from forficula.commands.cost import CountEstimate, RunEstimate, write_survey_estimate
from forficula.errors import InputError, error_prefix
from forficula.options import (
    DesignName,
    DrawingUnit,
    OkIf,
    OpenReport,
    OutIfGiven,
    Settings,
    Tolerate,
    check_apart,
    check_folder,
    check_verdicts,
    exit_status,
    finish_folder,
    note_replaced,
    read_design,
    read_settings,
    setting_texts,
)
from forficula.terminal import result_first, warn

if TYPE_CHECKING:
    from collections.abc import Callable

    from forficula.analysis import Verdict
    from forficula.design import Design
    from forficula.dynamics import Record
    from forficula.statics import EnergyLandscape


def landscape(
    design: DesignName,
    /,
    *,
    settings: Settings = None,
    unit: DrawingUnit = None,
    out: Annotated[OutIfGiven, Parameter(help="Output folder; default: out/<name of the design>-landscape.")] = None,
    open_report: OpenReport = False,
    simulation: Annotated[
        bool, Parameter(help="Also simulate the design and compare the run with the static prediction.")
    ] = True,
    over: Annotated[
        list[str] | None,
        Parameter(
            help="Also map which values of a key let the design fold and reopen quasi-statically, such as --over"
            ' tendon.rest_length="0..9 cm step 1"; may be repeated.',
            negative=(),
        ),
    ] = None,
    simulated: Annotated[
        Path | None,
        Parameter(help="Folder of a study of this design over the keys of --over, to compare with the map."),
    ] = None,
    tolerate: Tolerate = False,
    ok_if: OkIf = None,
) -> int:
    """Compute the energy landscape of a design by statics: stable states, barriers and what each state withstands."""
    with result_first() as release:
        varied = read_settings(over, "--over", 'tendon.rest_length="0..9 cm step 1"')
        check_apart("--no-simulation", not simulation, {"--ok-if": bool(ok_if), "--tolerate": tolerate})
        if repeated := varied.keys() & setting_texts(settings).keys():
            raise InputError(f"--over: {min(repeated)} is also under --set; need it in one of them")
        chosen = read_design(design, settings, unit)
        if simulation:
            from forficula.study.running.law_timestep import with_timestep_for_law

            chosen = with_timestep_for_law(chosen)
        folder = out or Path("out") / f"{chosen.name}-landscape"
        check_verdicts(ok_if)
        check_folder(folder, "landscape")
        if simulated is not None and not over:
            raise InputError("--simulated: needs --over with the keys of the study")
        write_map = _map(chosen, varied, simulated) if over else None

        from forficula.show.landscape.landscape_table import print_headline

        note_replaced(folder, "landscape")
        surveyed, record = _survey(chosen, simulation=simulation)
        # before anything is drawn
        print_headline(surveyed)
        release()
    verdict = _write(surveyed, record, folder)
    if write_map is not None:
        write_map(folder)
    finish_folder(folder, "landscape", show=open_report)
    return exit_status([] if verdict is None else [verdict], tolerate=tolerate, ok_if=ok_if)


def _map(design: Design, varied: dict[str, object], simulated: Path | None) -> Callable[[Path], None]:
    """Check the options of a static map, and return the function that computes, writes and prints it."""
    from forficula.show.folder.static_map_folder import print_static_map, read_simulated, write_static_map
    from forficula.show.progress import map_progress
    from forficula.structure import structure_of
    from forficula.study.tables.static_map import map_study, static_map

    with error_prefix("--over: "):
        study = map_study(design, varied)
    compared = None if simulated is None else read_simulated(simulated, design)

    def write(folder: Path) -> None:
        whole = structure_of(design).appearance.whole
        progress, estimate = map_progress(whole), CountEstimate("points of the map")

        def update(done: int, count: int) -> None:
            estimate.update(done, count)
            progress(done, count)

        table = static_map(study, update)
        write_static_map(study, table, folder, compared)
        print_static_map(table, whole, compared)

    return write


def _survey(design: Design, *, simulation: bool) -> tuple[EnergyLandscape, Record | None]:
    """Compute the landscape of a design, and simulate it if wanted; warn of its structure and its timestep."""
    from forficula.dynamics import timestep_warnings
    from forficula.show.progress import survey_progress, waiting
    from forficula.structure import structure_of, structure_warnings
    from forficula.study.landscape_and_run import landscape_and_run
    from forficula.study.running.numerical_settings import finds_settings

    structure = structure_of(design)
    whole = structure.appearance.whole
    for warning in structure_warnings(design, structure):
        warn(warning)
    if simulation:
        with waiting("computing the timestep limit"):
            warnings = timestep_warnings(design)
        for warning in warnings:
            warn(warning)
    write_survey_estimate(structure)
    first = f"building the {whole}" if simulation else "surveying its energy"
    with survey_progress(first, "surveying") as (progress, steps):
        estimate = RunEstimate(progress, searches=finds_settings(design), stages=design.protocol.stages)
        return landscape_and_run(design, simulation=simulation, progress=estimate, steps=steps)


def _write(landscape: EnergyLandscape, record: Record | None, folder: Path) -> Verdict | None:
    """Print the tables of a landscape and write its files; returns the verdict of the run, if there is one."""
    from forficula.analysis import measure
    from forficula.reproduction import shown_tendon
    from forficula.show.folder.landscape_folder import write_landscape
    from forficula.show.landscape.landscape_table import print_landscape

    tendon = shown_tendon(landscape.design)
    print_landscape(landscape, record, tendon)
    write_landscape(landscape, folder, record, tendon)
    return None if record is None else measure(record).verdict
