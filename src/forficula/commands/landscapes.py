"""The command that surveys a design without simulating."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from forficula.errors import InputError
from forficula.options import (
    DesignName,
    DrawingUnit,
    OkIf,
    OutIfGiven,
    Settings,
    Tolerate,
    check_apart,
    check_folder,
    check_verdicts,
    exit_status,
    read_design,
    read_settings,
    setting_texts,
    tell_replaced,
    tell_written,
)

if TYPE_CHECKING:
    from forficula.analysis import Verdict
    from forficula.design import Design


def landscape(
    design: DesignName,
    /,
    *,
    settings: Settings = None,
    unit: DrawingUnit = None,
    out: Annotated[
        OutIfGiven, Parameter(help="Folder for the results; out/<name of the design>-landscape if not given.")
    ] = None,
    simulation: Annotated[
        bool, Parameter(help="Run the design, too, and show it beside what statics predicts.")
    ] = True,
    over: Annotated[
        list[str] | None,
        Parameter(
            help='Map what folds and opens slowly over a key, as in --over tendon.rest_length="0..9 cm step 1"; may be'
            " repeated.",
            negative=(),
        ),
    ] = None,
    simulated: Annotated[
        Path | None, Parameter(help="Folder of a study of this design over the same keys, to compare the map with.")
    ] = None,
    tolerate: Tolerate = False,
    ok_if: OkIf = None,
) -> int:
    """Survey a design's energy by statics: stable states, barriers, paths of its drives, what it withstands, snap."""
    varied = read_settings(over, "--over", 'tendon.rest_length="0..9 cm step 1"')
    check_apart("--no-simulation", not simulation, {"--ok-if": bool(ok_if), "--tolerate": tolerate})
    if twice := varied.keys() & setting_texts(settings).keys():
        raise InputError(f"--over: {min(twice)} is under --set, too; need it in one of them")
    chosen = read_design(design, settings, unit)
    folder = out or Path("out") / f"{chosen.name}-landscape"
    check_verdicts(ok_if)
    check_folder(folder, "landscape")
    if simulated is not None and not over:
        raise InputError("--simulated: needs --over with the keys of the study")
    if not over:
        verdict = _survey(chosen, folder, simulation)
    else:
        from forficula.show.folder.static_map_folder import print_static_map, read_simulated, write_static_map
        from forficula.show.progress import map_progress
        from forficula.structure import structure_of
        from forficula.study.tables.static_map import map_study, static_map

        study = map_study(chosen, varied)
        beside = None if simulated is None else read_simulated(simulated, chosen)
        verdict = _survey(chosen, folder, simulation)
        whole = structure_of(chosen).appearance.whole
        table = static_map(study, map_progress(whole))
        write_static_map(study, table, folder, beside)
        print_static_map(table, whole, beside)
    tell_written(folder, "landscape")
    return exit_status([] if verdict is None else [verdict], tolerate=tolerate, ok_if=ok_if)


def _survey(design: Design, folder: Path, simulation: bool) -> Verdict | None:
    """Write and print the landscape of one design, and a run of it where one is wanted; hand on what that came to."""
    from forficula.analysis import measure
    from forficula.dynamics import timestep_warnings
    from forficula.reproduction import shown_tendon
    from forficula.show.folder.landscape_folder import write_landscape
    from forficula.show.landscape.landscape_table import print_landscape
    from forficula.show.progress import survey_progress, waiting
    from forficula.structure import structure_of, structure_warnings
    from forficula.study.landscape_and_run import landscape_and_run

    tendon, structure = shown_tendon(design), structure_of(design)
    whole = structure.appearance.whole
    tell_replaced(folder, "landscape")
    for warning in structure_warnings(design, structure):
        print(f"warning: {warning}", file=sys.stderr)
    if structure.contact is not None:
        print("warning: at rest everything passes through everything: contact is of runs only", file=sys.stderr)
    if simulation:
        with waiting(f"working out the timestep that the {whole} allows"):
            warnings = timestep_warnings(design)
        for warning in warnings:
            print(f"warning: {warning}", file=sys.stderr)
    first = f"building the {whole}" if simulation else "surveying its energy"
    with survey_progress(first, "surveying") as (progress, steps):
        landscape, record = landscape_and_run(design, simulation=simulation, progress=progress, steps=steps)
    write_landscape(landscape, folder, record, tendon)
    print_landscape(landscape, record, tendon)
    return None if record is None else measure(record).verdict
