"""Calls that draw and write results."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Literal

from forficula.design import Design
from forficula.errors import InputError, error_prefix
from forficula.files import AnyPath, as_path
from forficula.names import one_of
from forficula.results import check_own_kind

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from forficula.dynamics import AnyRun

_WIDEST = 100  # inch, of a figure
_FEWEST_COMPARED, _MOST_COMPARED = 2, 12


def figure(of: object, kind: str | None = None, *, width: float | Literal["column", "page"] = "column") -> Figure:
    """Draw a figure of a result, as `forficula figure` does.

    Args:
        of: result, such as a run, a landscape or the table of a study, or the folder of one.
        kind: name of the figure, which is that of its file in the folder; may be left out where there is only one.
        width: of a journal's column or page, or a number in inches.

    Raises:
        InputError: no such figure or width, or no result that has figures.

    >>> ff.figure(result, "angles", width="page").savefig("angles.pdf")
    """
    from forficula.show.folder.presentation import drawings_of
    from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH

    drawings = drawings_of(of)
    name = next(iter(drawings)) if kind is None and len(drawings) == 1 else kind
    if name not in drawings:
        raise InputError(f"kind: need {one_of(sorted(drawings), name)}")
    inches: object = {"column": COLUMN_WIDTH, "page": PAGE_WIDTH}.get(width) if isinstance(width, str) else width
    if not (isinstance(inches, int | float) and 1 <= inches <= _WIDEST):
        raise InputError(f'width: need "column", "page" or 1 to {_WIDEST} inch, got {width!r}')
    return drawings[name](inches)


def film(
    run: AnyRun,
    path: AnyPath,
    *,
    size: tuple[int, int] | None = None,
    fps: int | None = None,
    slower: float | None = None,
    strain: bool = False,
) -> None:
    """Film a run, as `forficula film` does.

    Args:
        run: run, its record or its folder.
        path: path of the film; must end with .mp4 or .gif.
        size: width and height in pixels, both even; 1280 x 720, or 800 x 450 for .gif, if not given.
        fps: frames per second; 30, or 15 for .gif, if not given.
        slower: factor by which the film is slower than the run; each transition takes about 3.5 s if not given.
        strain: whether membranes are coloured by their largest strain.

    Raises:
        InputError: no such run, another ending, an option that is not allowed, or the file cannot be written.

    >>> ff.film(result, "short.gif", size=(160, 160), fps=1, slower=2)
    """
    from forficula.dynamics import as_record
    from forficula.show.film.film import check_choices, check_film, write_film

    file = as_path(path, "a file that ends with .mp4 or .gif")
    check_film(file)
    check_choices(size, fps, slower)
    write_film(as_record(run), file, size=size, rate=fps, slowed=slower, strain=strain)


def export(run: AnyRun, path: AnyPath, *, to: str | None = None, at: float | None = None) -> None:
    """Write a run to a file of another program, as `forficula export` does.

    Args:
        run: run, its record or its folder.
        path: path of the file.
        to: "gltf" (.glb, an animation: m, y up), "obj" (.obj, one moment: m, y up), "stl" (.stl, the solid of one
            moment: mm, z up), "vtk" (.pvd, a series for ParaView: m), "usd" (.usda, an animation: m, z up), "fold"
            (.fold, frames with fold angles) or "csv" (.csv, all series); that of the ending of the path if not given.
        at: time of the only moment to write, s; if not given, the whole motion, and for "obj" and "stl" its end.

    Raises:
        InputError: no such run or format, another ending, a time outside of the run, a structure that never moved, a
            library that is not installed, or files that cannot be written.

    >>> ff.export(result, "motion.glb")
    >>> ff.export(result, "folded.fold", at=0.01)
    """
    from forficula.dynamics import as_record
    from forficula.show.export import check_format, export_times, format_of, write_export

    if to is not None:
        with error_prefix("to: "):
            check_format(to)
    file = as_path(path, "the path of a file")
    chosen = format_of(file, to)
    record = as_record(run)
    with error_prefix("" if at is None else "at: "):
        times = export_times(record, chosen, at)
    write_export(record, file, chosen, times)


def page(of: object, path: AnyPath, *, engine: bool = True) -> None:
    """Write a result as one HTML file that opens in any browser without a network.

    Args:
        of: result, or the folder of one. The page of a design simulates its structure in the browser, as that of
            `forficula open` does.
        path: path of the page; must end with .html.
        engine: whether the page of a run contains the simulator (3.5 MB), so that a reader can move the structure. The
            page in a folder of another result is copied as it is.

    Raises:
        InputError: no result that has a page, another ending, or the file cannot be written.

    >>> ff.page(result, "run.html")
    """
    from forficula.show.folder.presentation import write_page
    from forficula.show.page.live_page import write_live_page
    from forficula.show.page.page import page_path

    file = page_path(path)
    if isinstance(of, Design):
        write_live_page(of, file)
    else:
        write_page(of, file, engine=engine)


def compare(runs: Iterable[AnyRun], path: AnyPath) -> None:
    """Show runs side by side on one clock, as `forficula compare` does: a page.

    Args:
        runs: two to twelve runs, or their folders. Paths of FOLD files with frames of the same pattern may be among
            them; a plot shows the distance of every run from the frames.
        path: path of the page; must end with .html.

    Raises:
        InputError: too few or too many runs, a folder without a run, or the page cannot be written.

    >>> other = ff.run(design.with_values({"tendon.left.stiffness": "0.4 N/cm"}), confirm=False)
    >>> ff.compare([result, other], "both.html")
    """
    from forficula.show.page import compare_runs

    if not isinstance(runs, Iterable) or isinstance(runs, str | bytes):
        raise InputError(f"compare: need a list of 2 to 12 runs or their folders, got {runs!r}")
    file = as_path(path, "a file that ends with .html")
    listed = list(runs)
    folders = [as_path(run, "the folder of a run") for run in listed if isinstance(run, str | os.PathLike)]
    if len(folders) == len(listed):
        compare_runs(folders, file)
        return
    from forficula.analysis import measure
    from forficula.dynamics import as_record
    from forficula.files import write_text
    from forficula.show.page.compare_page import ComparedRun, compare_page, is_fold
    from forficula.show.page.data.fold_distance import read_motion
    from forficula.show.page.page import page_path

    if not _FEWEST_COMPARED <= len(listed) <= _MOST_COMPARED:
        raise InputError(f"compare: need {_FEWEST_COMPARED} to {_MOST_COMPARED} runs, got {len(listed)}")
    motions = [read_motion(as_path(run, "a FOLD file")) for run in listed if is_fold(run)]
    records = [as_record(run) for run in listed if not is_fold(run)]
    names = [record.design.name for record in records]
    labels = [name if names.count(name) == 1 else f"{number}: {name}" for number, name in enumerate(names, start=1)]
    compared = [
        ComparedRun(label=label, record=record, outcome=measure(record))
        for label, record in zip(labels, records, strict=True)
    ]
    write_text(page_path(file), compare_page(compared, motions))


def save(result: object, folder: AnyPath) -> None:
    """Write a result to a folder, as its command does.

    Args:
        result: any result of a call. Parts are checked without a run; the pages of studies, tolerances and optima
            contain no runs to play.
        folder: created if it is missing; an earlier result of the same kind in it is replaced.

    Raises:
        InputError: no result that a command writes, or the folder cannot be written or contains another kind of result.

    >>> ff.save(result, "there")
    >>> ff.load_run("there").design.name
    'letter-fold'
    """
    if folder == "":  # would be the current folder
        raise InputError('need a folder, got ""')
    from forficula.show.folder.presentation import presentation, result_kind

    path, kind = as_path(folder, "a folder"), result_kind(result)
    write = presentation(kind).write
    if write is None:
        raise InputError(f"a {kind.name} is written by its command, from its file; got a {type(result).__name__}")
    if kind.marker:
        check_own_kind(path, kind.name)
    write(result, path)
