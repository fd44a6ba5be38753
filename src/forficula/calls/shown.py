"""Calls that draw and write results."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Literal

from forficula.design import Design
from forficula.errors import InputError
from forficula.files import AnyPath, as_path
from forficula.names import one_of
from forficula.results import check_own_kind

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from forficula.dynamics import Record

_WIDEST = 100  # inch, of a figure


def figure(of: object, kind: str | None = None, *, width: float | Literal["column", "page"] = "column") -> Figure:
    """Draw a figure of some results, as `forficula figure` does.

    Args:
        of: a folder that a command wrote, or a record, a landscape, a study's table, a convergence study,
            assumptions, a material, or what became of cycles.
        kind: which figure, by the name of its picture in the folder; may be left out where there is one only.
        width: of a journal's column or page, or inch.

    Raises:
        InputError: no such kind, another width, or nothing that has figures.

    >>> ff.figure(record, "angles", width="page").savefig("angles.pdf")
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
    run: Record | AnyPath,
    path: AnyPath,
    *,
    size: tuple[int, int] | None = None,
    fps: int | None = None,
    slower: float | None = None,
    strain: bool = False,
) -> None:
    """Film a run, as `forficula film` does.

    Args:
        run: its record or its folder.
        path: .mp4 or .gif.
        size: pixels across and upwards, both even; 1280 x 720, or 800 x 450 for .gif.
        fps: pictures a second; 30, or 15 for .gif.
        slower: how many times slower than the run its moves are; each takes about 3.5 s if not given.
        strain: whether membranes have the colours of their largest strains.

    Raises:
        InputError: no such run, another ending, a choice that is not allowed, or it cannot be written.

    >>> ff.film(record, "short.gif", size=(160, 160), fps=1, slower=2)
    """
    from forficula.dynamics import as_record
    from forficula.show.film.film import check_choices, check_film, write_film

    file = as_path(path, "a file that ends with .mp4 or .gif")
    check_film(file)
    check_choices(size, fps, slower)
    write_film(as_record(run), file, size=size, rate=fps, slowed=slower, strain=strain)


def page(of: object, path: AnyPath, *, engine: bool = True) -> None:
    """Write a result as one HTML file that opens in any browser without a network.

    Args:
        of: a result, or the folder of one; a design is written as the page in which a reader moves its structure, as
            `forficula open` writes it.
        path: of the page; must end with .html.
        engine: whether the simulator is in the page of a run, with which a reader moves the structure; it takes 3.5 MB.
            The page of a folder of other results is copied as it is.

    Raises:
        InputError: no result that has a page of its own, another ending, or it cannot be written.

    >>> ff.page(record, "run.html")
    """
    from forficula.show.folder.presentation import write_page
    from forficula.show.page.bench_page import write_bench_page
    from forficula.show.page.page import page_path

    file = page_path(path)
    if isinstance(of, Design):
        write_bench_page(of, file)
    else:
        write_page(of, file, engine=engine)


def compare(folders: Iterable[AnyPath], path: AnyPath) -> None:
    """Show runs side by side on one clock, as `forficula compare` does: a page.

    Args:
        folders: of the runs, two to twelve.
        path: of the page; must end with .html.

    Raises:
        InputError: too few or too many folders, one that holds no run, or it cannot be written.

    >>> import os
    >>> for folder in ("one", "two"):
    ...     os.mkdir(folder)
    ...     ff.save_record(record, f"{folder}/record.nc")
    >>> ff.compare(["one", "two"], "both.html")
    """
    from forficula.show.page import compare_runs

    if not isinstance(folders, Iterable) or isinstance(folders, str | bytes):
        raise InputError(f"compare: need a list of 2 to 12 folders of runs, got {folders!r}")
    runs = [as_path(folder, "the folder of a run, as save(record, folder) leaves it") for folder in folders]
    compare_runs(runs, as_path(path, "a file that ends with .html"))


def save(result: object, folder: AnyPath) -> None:
    """Write a result to a folder, as its command does.

    Args:
        result: of `run`, `landscape`, `converge`, `assumptions`, `characterise`, `identify`, `make_parts`, which are
            checked without a record, or `run_study`, `collect`, `tolerance` or `optimise`, of which no runs are kept to
            be played.
        folder: made where it is missing; what an earlier result of the kind left there is replaced.

    Raises:
        InputError: nothing that a command writes, or the folder cannot be written or holds results of another kind.

    >>> ff.save(record, "there")
    >>> ff.load_record("there").design.name
    'letter-fold'
    """
    if folder == "":  # which would be the current one
        raise InputError('need a folder, got ""')
    from forficula.show.folder.presentation import presentation, result_kind

    place, kind = as_path(folder, "a folder"), result_kind(result)
    write = presentation(kind).write
    if write is None:
        raise InputError(f"a {kind.name} is written by its command, from its file; got a {type(result).__name__}")
    if kind.marker:
        check_own_kind(place, kind.name)
    write(result, place)
