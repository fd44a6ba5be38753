"""The command that traces crease patterns in pictures."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from forficula.options import OpenReport, Out, check_folder, finish_folder, note_replaced, options_named


def trace(
    picture: Annotated[str, Parameter(help="Photograph, scan or drawing of a crease pattern (.png, .jpg).")],
    /,
    *,
    size: Annotated[
        str,
        Parameter(
            help='Width and height of the sheet, such as "29.7 x 21 cm", or its longer side, such as "20 cm". Without'
            " corners of the sheet: of the pattern."
        ),
    ],
    corners: Annotated[
        str | None,
        Parameter(
            help="Corners of the sheet, x,y in pixels, clockwise from the upper left one, such as"
            ' "12,30 900,41 880,700 20,690"; none for a scan. By default they are found where the sheet is brighter'
            " than its ground."
        ),
    ] = None,
    straighten: Annotated[
        str | None,
        Parameter(
            help="Make the pattern exactly symmetric and flat-foldable, if no vertex moves by more than this, such as"
            ' "0.5 mm".'
        ),
    ] = None,
    out: Annotated[
        Out,
        Parameter(
            help="Output folder; or a FOLD file (.fold): the other results are then in the folder of the same name."
        ),
    ] = Path("out/trace"),
    open_report: OpenReport = False,
) -> None:
    """Trace a drawn crease pattern: red mountains, blue valleys, black border; what is doubtful is unassigned."""
    from forficula.calls.patterns import trace as trace_call
    from forficula.pattern import write_trace
    from forficula.show.folder.trace_folder import PATTERN_FILE, write_trace_folder
    from forficula.show.structure.trace_table import print_trace

    is_file = out.suffix.lower() == ".fold"
    folder = out.with_suffix("") if is_file else out
    check_folder(folder, "trace")
    note_replaced(folder, "trace")
    with options_named(size="--size", corners="--corners", straighten="--straighten"):
        result = trace_call(picture, size, corners=corners, straighten=straighten)
    print_trace(result)
    write_trace_folder(result, folder)
    if is_file:
        write_trace(result, out)
    pattern = out if is_file else folder / PATTERN_FILE
    print(f"fold it with: forficula run {pattern}")
    finish_folder(folder, "trace", show=open_report)
