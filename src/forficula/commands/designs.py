"""Commands about design files and crease patterns."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from forficula.commands.new import USUAL_KIND, Kind
from forficula.errors import InputError
from forficula.options import (
    WHOLE_NUMBER,
    DesignName,
    DrawingUnit,
    OutIfGiven,
    Settings,
    check_apart,
    options_named,
    read_design,
    read_option,
    read_ratio,
    read_settings,
    read_unit,
    setting_texts,
)
from forficula.terminal import note, set_result, warn

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from forficula.design import Design
    from forficula.design.files.key_table import KeyFact
    from forficula.design.section import Section
    from forficula.pattern import CreasePattern
    from forficula.pattern.files.fold_writer import Frame

    Array = NDArray[np.float64]

_LAST_PORT = 65535
_WIDTH = 130  # of tables of keys, in characters
GLOSSARY = "docs/glossary.md"


def keys(
    section: Annotated[str, Parameter(help="List only this section or key, such as tendon or protocol.stages.")] = "",
    /,
    *,
    kind: Kind = USUAL_KIND,
    study: Annotated[bool, Parameter(help="List the keys of a study file.", negative=())] = False,
    goal: Annotated[bool, Parameter(help="List the keys of a goal file.", negative=())] = False,
    observations: Annotated[bool, Parameter(help="List the keys of an observations file.", negative=())] = False,
) -> None:
    """List the keys of a design file with allowed values, defaults and meanings."""
    from forficula.design.files.key_table import key_facts
    from forficula.design.files.kinds import KEYED
    from forficula.names import one_of

    if kind not in KEYED:
        raise InputError(f"--kind: need {one_of(KEYED, kind)}")
    if study + goal + observations > 1:
        raise InputError("keys: need one of --study, --goal and --observations, got several")
    for option, used in (("--study", study), ("--goal", goal), ("--observations", observations)):
        check_apart(option, used, {"--kind": kind != USUAL_KIND})
    facts = key_facts(section, _model(kind, study=study, goal=goal, observations=observations))
    print_keys(facts)
    print(f"\nTerms such as stage, drive, measure, goal and state: {GLOSSARY}")
    set_result([asdict(fact) for fact in facts])


def _model(kind: str, *, study: bool, goal: bool, observations: bool) -> type[Section]:
    """Return the class of the files whose keys are listed."""
    if study:
        from forficula.study.files.study_file import StudyFile

        return StudyFile
    if goal:
        from forficula.goals.goal_file import GoalFile

        return GoalFile
    if observations:
        from forficula.goals.identify.observations_file import ObservationsFile

        return ObservationsFile
    from forficula.design.files.kinds import KEYED

    return KEYED[kind]


def open_design(
    design: DesignName,
    /,
    *,
    settings: Settings = None,
    unit: DrawingUnit = None,
    out: Annotated[
        OutIfGiven,
        Parameter(
            help="Write a page (.html) instead of a workbench. Keys that need no new structure can be set there."
        ),
    ] = None,
    port: Annotated[int | None, WHOLE_NUMBER, Parameter(help="Port of the server; default: any free port.")] = None,
    no_browser: Annotated[bool, Parameter(help="Print the address, and open no browser.", negative=())] = False,
) -> None:
    """Open a workbench in the browser: set any key of a design and see its structure move; ctrl-C ends it."""
    if port is not None and not 1 <= port <= _LAST_PORT:
        raise InputError(f"--port: need 1 to {_LAST_PORT}, got {port}")
    if out is not None:
        from forficula.show.page.live_page import write_live_page
        from forficula.show.page.page import page_path

        if port is not None or no_browser:
            raise InputError(
                f"{'--no-browser' if port is None else '--port'}: --out writes a file, which is not served"
            )
        read_option("--out", lambda: page_path(out))
        write_live_page(read_design(design, settings, unit), out)
        print(f"written to {out}")
        return

    from forficula.workbench import open_workbench

    open_workbench(design, setting_texts(settings), read_unit(unit, design), port, browser=not no_browser)


def scale(
    design: DesignName,
    /,
    *,
    length: Annotated[str, Parameter(help="Ratio of the new to the old size, such as 1/10, 0.1 or 10.")],
    out: Annotated[
        OutIfGiven,
        Parameter(help="New file (.toml); existing files are not overwritten. Default: print the design."),
    ] = None,
    unit: DrawingUnit = None,
    settings: Settings = None,
) -> None:
    """Scale a design to another size with the same materials, and list the dimensionless groups that change."""
    from forficula.design import design_text, save_design, scale_design
    from forficula.files import check_new

    factor = read_ratio("--length", length)
    if out is not None:
        read_option("--out", lambda: check_new(out, ".toml"))
    original = read_design(design, settings, unit)
    try:
        scaled = scale_design(original, factor, natural=True)
    except InputError as error:
        raise InputError(f"--length: {str(error).removeprefix('factor: ')}") from None
    for line in _changed_groups(original, scaled):
        print(line, file=sys.stderr)
    if out is None:
        print(design_text(scaled), end="")
        return
    save_design(scaled, out)
    print(f"written to {out}; run it with: forficula run {out}")


def _changed_groups(original: Design, scaled: Design) -> list[str]:
    """Return one line for each dimensionless group that differs, with both values."""
    from forficula.analysis.groups import changed, groups_of
    from forficula.structure import structure_of

    before, after = (groups_of(structure_of(design), design.protocol.timestep) for design in (original, scaled))
    if before is None or after is None:
        return [f"{scaled.name}: no dimensionless groups, because it has no elastic part that folds"]
    pairs = changed(before, after)
    count = len(before.every)
    if not pairs:
        return [f"{scaled.name} keeps all {count} dimensionless groups: over t / t* it moves identically"]
    return [
        f"{len(pairs)} of {count} dimensionless groups of {scaled.name} change, because gravity and materials are not"
        " scaled:",
        *(f"  {old.label}: {old.value:.3g} -> {new.value:.3g} ({old.meaning})" for old, new in pairs),
    ]


def designs() -> None:
    """List the named designs with their sources and what each one shows."""
    from forficula.design import load_design, named_designs

    named = [
        {"name": name, "source": source, "shows": load_design(name).shows} for name, source in named_designs().items()
    ]
    for facts in named:
        print(f"{facts['name']}\n    {facts['source']}")
        if facts["shows"]:
            print(f"    shows {facts['shows']}")
    set_result(named)


def pattern(
    design: Annotated[
        str,
        Parameter(
            help="A named design, or the path of a design file (.toml), a FOLD file (.fold) or a drawing (.svg, .dxf)."
        ),
    ],
    /,
    *,
    out: Annotated[
        OutIfGiven,
        Parameter(
            help="File to write instead: the pattern (.fold, .svg), or a picture with its faults marked (.png, .pdf)."
        ),
    ] = None,
    unit: Annotated[
        str | None,
        Parameter(help='Length of one unit of a file that states no unit, such as "1 cm".'),
    ] = None,
    settings: Settings = None,
) -> None:
    """Analyse a crease pattern: flat-foldability, faults and degrees of freedom; or write it to a file."""
    from forficula.pattern.files.fold_frame import CHOSEN_UNIT, UNIT_OPTION

    sheet, remarks, frames, attachments = _sheet(design, unit, settings)
    if CHOSEN_UNIT in remarks:
        remarks.remove(CHOSEN_UNIT)
        warn(f"{design}: {CHOSEN_UNIT}; {UNIT_OPTION}")
    if out is None:
        from forficula.pattern import pattern_facts
        from forficula.show.structure.pattern_table import print_pattern

        print_pattern(pattern_facts(sheet), remarks)
        return
    for remark in remarks:
        note(f"{design}: {remark}")
    try:
        _write(sheet, frames, attachments, out)
    except InputError as error:
        # errors of the output name its file
        raise InputError(
            str(error) if str(error).startswith((f"{out}: ", "--out: ")) else f"{design}: {error}"
        ) from None
    print(f"written to {out}")


def _write(
    sheet: CreasePattern, frames: Callable[[], list[Frame]], attachments: Callable[[], Array | None], out: Path
) -> None:
    """Write a pattern or a picture of it, depending on the ending of the file."""
    match out.suffix:
        case ".fold":
            from forficula.pattern import write_fold

            write_fold(sheet, out, frames=frames())
        case ".svg":
            from forficula.pattern import write_svg

            write_svg(sheet, out, attachments())
        case ".png" | ".pdf":
            from forficula.pattern import pattern_facts
            from forficula.show.structure.sheet_figure import draw_sheet
            from forficula.show.style import save_figure

            save_figure(draw_sheet(sheet, pattern_facts(sheet)), out)
        case _:
            raise InputError(f"--out: need a file that ends with .fold, .svg, .png or .pdf, got {out}")


def _sheet(
    name: str, unit: str | None, settings: list[str] | None
) -> tuple[CreasePattern, list[str], Callable[[], list[Frame]], Callable[[], Array | None]]:
    """Return the pattern of a design or file, remarks on the file, its folded states, and the ends of the tendons."""
    from forficula.design import design_frames, design_pattern, load_design
    from forficula.pattern import PATTERN_FILES, read_folded_frames, read_pattern

    kind = PATTERN_FILES.get(Path(name).suffix.lower())
    if kind is None:
        read_unit(unit, name)
        chosen = load_design(name, read_settings(settings))
        return design_pattern(chosen), [], lambda: design_frames(chosen), lambda: _attachments(chosen)
    if settings:
        raise InputError(f"--set: a {kind} file has no values to replace, got {settings[0]}")
    metres = read_unit(unit, name)
    with options_named(unit="--unit"):
        sheet, remarks = read_pattern(name, metres, choose_unit=True)
    return (
        sheet,
        remarks,
        lambda: read_folded_frames(name, metres, choose_unit=True) if kind == "FOLD" else [],
        lambda: None,
    )


def _attachments(design: Design) -> Array | None:
    """Return the ends of the tendons of a design in its flat pattern, m, (end, 3); None without tendons."""
    from forficula.structure import built_points, structure_of

    structure = structure_of(design)
    ends = [point for tendon in structure.tendons for point in tendon.points]
    return built_points(structure)[ends] if ends else None


def print_keys(facts: Sequence[KeyFact]) -> None:
    """Print a table of keys for each section: allowed values, default and meaning."""
    from rich.console import Console
    from rich.table import Table

    console = Console(width=_WIDTH, highlight=False, markup=False)
    sections: dict[str, list[KeyFact]] = {}
    for fact in facts:
        sections.setdefault(fact.key.rpartition(".")[0], []).append(fact)
    for number, (section, inside) in enumerate(sections.items()):
        table = Table(box=None, padding=(0, 2, 0, 0), show_header=number == 0)
        for heading, width in (("key", 26), ("allowed", 26), ("default", 12), ("meaning", None)):
            table.add_column(heading, width=width, overflow="fold")
        for fact in inside:
            table.add_row(fact.key.rpartition(".")[2], fact.allowed, fact.default, fact.meaning)
        if section:
            console.print(*[""] * (number > 0), f"[{section}]", sep="\n", style="bold")
        console.print(table)
