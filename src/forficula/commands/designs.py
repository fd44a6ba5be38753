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
    read_design,
    read_option,
    read_ratio,
    read_settings,
    read_unit,
    setting_texts,
)
from forficula.quantities import as_written
from forficula.terminal import came_to

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


def keys(
    section: Annotated[str, Parameter(help="Only this section or key, as in tendon or protocol.stages.")] = "",
    /,
    *,
    kind: Kind = USUAL_KIND,
    study: Annotated[bool, Parameter(help="Those of a study file instead.", negative=())] = False,
    goal: Annotated[bool, Parameter(help="Those of a goal file instead.", negative=())] = False,
    observations: Annotated[bool, Parameter(help="Those of an observations file instead.", negative=())] = False,
) -> None:
    """List the keys of a design file: what each may be, what counts where it is left out, and what it means."""
    from forficula.design.files.key_table import key_facts
    from forficula.design.files.kinds import KINDS
    from forficula.names import one_of

    if kind not in KINDS:
        raise InputError(f"--kind: need {one_of(KINDS, kind)}")
    if study + goal + observations > 1:
        raise InputError("keys: need one of --study, --goal and --observations, got several")
    for option, wanted in (("--study", study), ("--goal", goal), ("--observations", observations)):
        check_apart(option, wanted, {"--kind": kind != USUAL_KIND})
    facts = key_facts(section, _model(kind, study=study, goal=goal, observations=observations))
    print_keys(facts)
    came_to([asdict(fact) for fact in facts])


def _model(kind: str, *, study: bool, goal: bool, observations: bool) -> type[Section]:
    """The class of the files whose keys are listed."""
    if study:
        from forficula.study.files.study_file import StudyFile

        return StudyFile
    if goal:
        from forficula.goals.goal_file import GoalFile

        return GoalFile
    if observations:
        from forficula.goals.identify.observations_file import ObservationsFile

        return ObservationsFile
    from forficula.design.files.kinds import KINDS

    return KINDS[kind]


def open_design(
    design: DesignName,
    /,
    *,
    settings: Settings = None,
    unit: DrawingUnit = None,
    out: Annotated[
        OutIfGiven, Parameter(help="Write one .html file instead, for the keys that change while it moves.")
    ] = None,
    port: Annotated[
        int | None, WHOLE_NUMBER, Parameter(help="Where to serve it; any that is free if not given.")
    ] = None,
    no_browser: Annotated[bool, Parameter(help="Print the address only.", negative=())] = False,
) -> None:
    """Open a workbench in the browser: every key of a design to be changed, its structure live; ends with ctrl-C."""
    if port is not None and not 1 <= port <= _LAST_PORT:
        raise InputError(f"--port: need 1 to {_LAST_PORT}, got {port}")
    if out is not None:
        from forficula.show.page.bench_page import write_bench_page
        from forficula.show.page.page import page_path

        if port is not None or no_browser:
            raise InputError(
                f"{'--no-browser' if port is None else '--port'}: --out writes a file, which is not served"
            )
        read_option("--out", lambda: page_path(out))
        write_bench_page(read_design(design, settings, unit), out)
        print(f"written to {out}")
        return

    from forficula.workbench import open_workbench

    open_workbench(design, setting_texts(settings), read_unit(unit), port, browser=not no_browser)


def scale(
    design: DesignName,
    /,
    *,
    length: Annotated[str, Parameter(help="The new size by the old one: 1/10, 0.1, 10.")],
    out: Annotated[
        OutIfGiven, Parameter(help="Where to write it; must end with .toml and not exist. Printed if not given.")
    ] = None,
    unit: DrawingUnit = None,
    settings: Settings = None,
) -> None:
    """Print a design at another size, of the same materials, and say which dimensionless groups it cannot keep."""
    from forficula.design import design_text, save_design, scale_design
    from forficula.files import check_new

    factor = read_ratio("--length", length)
    if out is not None:
        read_option("--out", lambda: check_new(out, ".toml"))
    given = read_design(design, settings, unit)
    try:
        scaled = scale_design(given, factor, natural=True)
    except InputError as error:
        own = str(error).removeprefix("factor: ")
        raise InputError(f"--length: {own}") from None
    for line in _groups_not_kept(given, scaled):
        print(line, file=sys.stderr)
    if out is None:
        print(design_text(scaled), end="")
        return
    save_design(scaled, out)
    print(f"written to {out}; run it with: forficula run {out}")


def _groups_not_kept(given: Design, scaled: Design) -> list[str]:
    """Which groups differ, before and after, one a line."""
    from forficula.analysis.groups import changed, groups_of
    from forficula.structure import structure_of

    before, after = (groups_of(structure_of(each), each.protocol.timestep) for each in (given, scaled))
    if before is None or after is None:
        return [f"{scaled.name}: nothing elastic folds in it, by which groups could be measured"]
    pairs = changed(before, after)
    count = len(before.every)
    if not pairs:
        return [f"{scaled.name} keeps all {count} groups: in t / t* it moves alike"]
    return [
        f"{scaled.name} cannot keep {len(pairs)} of {count} groups, for gravity and materials stay as they are:",
        *(f"  {old.label}: {old.value:.3g} -> {new.value:.3g} ({old.meaning})" for old, new in pairs),
    ]


def designs() -> None:
    """List the named designs, each with its source and what one would look at it for."""
    from forficula.design import load_design, named_designs

    told = [
        {"name": name, "source": source, "shows": load_design(name).shows} for name, source in named_designs().items()
    ]
    for each in told:
        print(f"{each['name']}\n    {each['source']}")
        if each["shows"]:
            print(f"    shows {each['shows']}")
    came_to(told)


def pattern(
    design: Annotated[
        str,
        Parameter(
            help="A named design, or the path of a design file (.toml), of a FOLD file (.fold) or of a drawing "
            "(.svg, .dxf)."
        ),
    ],
    /,
    *,
    out: Annotated[
        OutIfGiven,
        Parameter(
            help="A file that ends with .fold or .svg for the pattern itself, with .png or .pdf for a picture of it "
            "with its faults marked."
        ),
    ] = None,
    unit: Annotated[
        str | None,
        Parameter(help='Length of one unit of a file that names none, as in --unit "1 cm".'),
    ] = None,
    settings: Settings = None,
) -> None:
    """Say what a crease pattern is, where it does not fold flat and how freely it moves, or write it to a file."""
    sheet, remarks, frames, attachments = _sheet(design, unit, settings)
    if out is None:
        from forficula.pattern import pattern_facts
        from forficula.show.structure.pattern_table import print_pattern

        print_pattern(pattern_facts(sheet), remarks)
        return
    for remark in remarks:
        print(f"{design}: {remark}", file=sys.stderr)
    try:
        _write(sheet, frames, attachments, out)
    except InputError as error:
        # what is wrong with the file that is written names it
        raise InputError(
            str(error) if str(error).startswith((f"{out}: ", "--out: ")) else f"{design}: {error}"
        ) from None
    print(f"written to {out}")


def _write(
    sheet: CreasePattern, frames: Callable[[], list[Frame]], attachments: Callable[[], Array | None], out: Path
) -> None:
    """Write a pattern, or a picture of it, by the ending of the file."""
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
    """The pattern of a design or of a file, remarks on how it was read, its folded states and where tendons end."""
    from forficula.design import design_frames, design_pattern, load_design
    from forficula.pattern import PATTERN_FILES, read_folded_frames, read_pattern

    kind = PATTERN_FILES.get(Path(name).suffix.lower())
    if kind is None:
        if unit is not None:
            raise InputError(f"--unit: a design already has units, got {as_written(unit)}")
        chosen = load_design(name, read_settings(settings))
        return design_pattern(chosen), [], lambda: design_frames(chosen), lambda: _attachments(chosen)
    if settings:
        raise InputError(f"--set: a {kind} file has no values to replace, got {settings[0]}")
    metres = read_unit(unit)
    if metres is not None and not metres > 0:
        raise InputError(f"--unit: need > 0, got {as_written(unit)}")
    sheet, remarks = read_pattern(name, metres)
    return sheet, remarks, lambda: read_folded_frames(name, metres) if kind == "FOLD" else [], lambda: None


def _attachments(design: Design) -> Array | None:
    """Where the tendons of a design end in its flat pattern, m, (end, 3)."""
    from forficula.structure import built_points, structure_of

    structure = structure_of(design)
    ends = [point for tendon in structure.tendons for point in tendon.points]
    return built_points(structure)[ends] if ends else None


def print_keys(facts: Sequence[KeyFact]) -> None:
    """Print keys table by table, each with what it may hold, what counts without it, and what it means."""
    from rich.console import Console
    from rich.table import Table

    console = Console(width=_WIDTH, highlight=False, markup=False)
    sections: dict[str, list[KeyFact]] = {}
    for fact in facts:
        sections.setdefault(fact.key.rpartition(".")[0], []).append(fact)
    for number, (section, inside) in enumerate(sections.items()):
        table = Table(box=None, padding=(0, 2, 0, 0), show_header=number == 0)
        for heading, width in (("key", 26), ("may be", 26), ("if left out", 12), ("meaning", None)):
            table.add_column(heading, width=width, overflow="fold")
        for fact in inside:
            table.add_row(fact.key.rpartition(".")[2], fact.allowed, fact.default, fact.meaning)
        if section:
            console.print(*[""] * (number > 0), f"[{section}]", sep="\n", style="bold")
        console.print(table)
