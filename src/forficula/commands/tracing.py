"""The command that traces crease patterns in pictures."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from forficula.errors import InputError
from forficula.options import OpenReport, Out, check_apart, check_folder, finish_folder, note_replaced, options_named


def trace(
    picture: Annotated[
        str,
        Parameter(
            help="Photograph, scan or drawing of a crease pattern (.png, .jpg); or a file of clicked points (.toml) of"
            " a wing, to which a fan is fitted, or of a film, for angles over time."
        ),
    ],
    /,
    *,
    size: Annotated[
        str | None,
        Parameter(
            help='Width and height of the sheet, such as "29.7 x 21 cm", or its longer side, such as "20 cm". Without'
            " corners of the sheet: of the pattern. A file of clicked points has its own scale."
        ),
    ] = None,
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
    """Trace a drawn crease pattern: red mountains, blue valleys, black border; doubtful creases are unassigned."""
    from forficula.goals.clicks.clicks_file import is_clicks

    if is_clicks(picture):
        check_apart(picture, True, {"--size": bool(size), "--corners": bool(corners), "--straighten": bool(straighten)})
        _trace_clicks(picture, out, open_report=open_report)
        return
    if size is None:
        raise InputError('--size: is missing; give width and height of the sheet, such as "29.7 x 21 cm"')
    from forficula.calls.patterns import trace as trace_call
    from forficula.pattern import write_trace
    from forficula.show.folder.trace_folder import PATTERN_FILE, write_trace_folder
    from forficula.show.structure.trace_table import print_trace

    is_file = out.suffix.lower() == ".fold"
    folder = out.with_suffix("") if is_file else out
    check_folder(folder, "trace")
    with options_named(size="--size", corners="--corners", straighten="--straighten"):
        result = trace_call(picture, size, corners=corners, straighten=straighten)
    note_replaced(folder, "trace")
    print_trace(result)
    write_trace_folder(result, folder)
    if is_file:
        write_trace(result, out)
    pattern = out if is_file else folder / PATTERN_FILE
    print(f"fold it with: forficula run {pattern}")
    finish_folder(folder, "trace", show=open_report)


def _trace_clicks(clicks: str, out: Path, *, open_report: bool) -> None:
    """Fit a fan to a file of clicked points, or compute angles over time, and write the results."""
    from forficula.calls.patterns import trace_clicks
    from forficula.goals.clicks.fan_fit import FanFit
    from forficula.show.folder.fan_fit_folder import DESIGN_FILE, write_fan_fit_folder
    from forficula.show.folder.motion_folder import OBSERVATIONS_FILE, write_motion_folder
    from forficula.show.goals.fan_fit_text import print_fan_fit
    from forficula.show.goals.motion_figures import print_motion

    if out.suffix:
        raise InputError(f"--out: need a folder for the results of clicked points, got {out}")
    result = trace_clicks(clicks)
    if isinstance(result, FanFit):
        check_folder(out, "fan fit")
        note_replaced(out, "fan fit")
        print_fan_fit(result)
        write_fan_fit_folder(result, out)
        if result.design is not None:
            print(f"analyse it with: forficula pattern {out / DESIGN_FILE}")
        finish_folder(out, "fan fit", show=open_report)
        return
    check_folder(out, "observed motion")
    note_replaced(out, "observed motion")
    print_motion(result)
    write_motion_folder(result, out)
    if "unknown" in result.observations:
        print(f"identify its unknown values with: forficula identify {out / OBSERVATIONS_FILE}")
    finish_folder(out, "observed motion", show=open_report)
