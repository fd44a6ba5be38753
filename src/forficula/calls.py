"""What every command does, as one call: designs by name or path in, records, tables, figures and files out.

In the examples, `ff` is forficula, `design` is `ff.load_design("letter-fold")`, and `record` a run of it.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal

from forficula.design import AnyDesign, Design, as_design
from forficula.errors import InputError
from forficula.files import as_path
from forficula.names import one_of
from forficula.quantities import as_written

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from xarray import Dataset

    from forficula.dynamics import Record
    from forficula.dynamics.simulate import Progress
    from forficula.goals import Goal
    from forficula.goals.identify import Observations
    from forficula.goals.optimise import Optimum, SoFar
    from forficula.make.part import PartSet
    from forficula.pattern import PatternFacts
    from forficula.statics import EnergyLandscape
    from forficula.study import Study
    from forficula.study.convergence import Convergence

AnyPath = str | os.PathLike[str]
_OPTIONS = ("timesteps", "moduli", "meshes")
_WIDEST = 100  # inch, of a figure


def run(design: AnyDesign, progress: Progress | None = None) -> Record:
    """Take a design through its protocol, as `forficula run` does.

    Args:
        design: or the name of one, or the path of a design file, a FOLD file or a drawing.
        progress: called now and then with the stage's name, the time so far and the longest it can take, s.

    Returns:
        What happened, sampled at the protocol's interval. `measure` says what that came to, `save` writes it. With a
        timestep "auto" its design has the one that was found.

    Raises:
        InputError: no such design, or it cannot be built.

    >>> record = ff.run(design)
    >>> ff.measure(record).status
    'closed and opened'
    """
    from forficula.study.runs import run as run_one

    return run_one(as_design(design), progress)


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


def converge(
    design: AnyDesign,
    *,
    timesteps: str | Sequence[float] | None = None,
    moduli: str | Sequence[float] | None = None,
    meshes: str | Sequence[float] | None = None,
    progress: Callable[[int, int, dict[str, Any]], None] | None = None,
) -> Convergence:
    """Run a design at several timesteps, membrane moduli or meshes, as `forficula converge` does.

    Args:
        design: or its name or path.
        timesteps: as in "0.5 0.2 ms", or s; this, `moduli` or `meshes`.
        moduli: of the membrane, as in "0.5 1 2 MPa", or Pa.
        meshes: by how much its rows are closer, as in "1 2".
        progress: called with the runs done, all runs, and what the last came to.

    Raises:
        InputError: none of the three, several of them, or values that are not allowed.

    >>> set(ff.converge(design, timesteps="0.4 0.2 ms").statuses)
    {'closed and opened'}
    """
    from forficula.study.convergence import converge as converge_design
    from forficula.study.refinement import MESH, TIMESTEP, YOUNGS_MODULUS, read_values

    every = zip(_OPTIONS, (TIMESTEP, YOUNGS_MODULUS, MESH), (timesteps, moduli, meshes), strict=True)
    given = [(name, key, values) for name, key, values in every if values is not None]
    if len(given) != 1:
        names = ", ".join(name for name, _, _ in given) or "none"
        raise InputError(f"converge: need one of {', '.join(_OPTIONS)}, got {names}")
    ((name, key, values),) = given
    try:
        read = read_values(key, values) if isinstance(values, str) else values
        read = [*read] if isinstance(read, Iterable) else read
        if not isinstance(read, Sequence) or not all(isinstance(value, int | float) for value in read):
            raise InputError(f"need text with a unit, or a list of numbers, got {as_written(values)}")
        return converge_design(as_design(design), key, read, progress=progress)
    except InputError as error:
        raise InputError(f"{name}: {error}") from None


def new_study(
    design: AnyDesign,
    factors: Mapping[str, object],
    *,
    name: str = "study",
    **tables: object,
) -> Study:
    """Build a study without a file: `run_study` runs it, `estimate` says how long that takes.

    Args:
        design: that is varied, or its name or path.
        factors: by key of the design: a list of values, a range, or a distribution, as in a study file.
        name: what outputs call it.
        **tables: what else a study file may have, such as `ask="least-torques"` or `search={"refinements": 2}`; the
            command `forficula keys --study` lists them.

    Raises:
        InputError: an unknown key, or a value that is not allowed.

    >>> asked = ff.new_study(design, {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]})
    >>> ff.run_study(asked, out="asked")["status"].values.tolist()
    ['closed and opened', 'closed and opened']
    """
    from forficula.study.study_file import study_of

    return study_of(
        {
            **tables,
            "name": name,
            "design": as_design(design),
            "factors": dict(factors) if isinstance(factors, Mapping) else factors,
        }
    )


def identify(
    observations: Observations | AnyPath | Mapping[str, object],
    out: AnyPath,
    *,
    threads: int = 0,
    progress: Callable[[int, int, Sequence[Any]], None] | None = None,
) -> Dataset:
    """Say which values of what is unknown agree with what was seen, as `forficula identify` does.

    Args:
        observations: or named ones, or the path of an observations file, or its tables, as in
            `{"design": design, "unknown": {"tendon.left.stiffness": [...]}, "fact": [...]}`.
        out: folder with the rows of runs; what was stopped goes on there.
        threads: 0 for one a core.
        progress: called after every batch with the samples done, all samples, and those so far.

    Returns:
        Over samples and facts: what was found, how far it is from each fact, and what agrees.

    Raises:
        InputError: no such observations, values that are not allowed, or a folder of others.

    >>> seen = {"name": "closes", "quantity": "close_time", "absent": "9 s", "at_most": "1 s"}
    >>> lost = {"tendon.left.stiffness": ["0.4 N/cm", "0.6 N/cm"]}
    >>> asked = {"design": design, "unknown": lost, "sampling": {"samples": 2, "directed": 0}, "fact": [seen]}
    >>> ff.identify(asked, out="seen")["met"].values.tolist()
    [[True], [True]]
    """
    from forficula.goals.identify import Observations, load_observations, observations_of
    from forficula.goals.identify.run_identify import identify as identify_in

    match observations:
        case Observations():
            asked = observations
        case Mapping():
            asked = observations_of({"name": "observations", **observations})
        case _:
            asked = load_observations(as_path(observations, "observations, their name or the path of their file"))
    return identify_in(asked, as_path(out, "a folder"), threads=threads, progress=progress)


def optimise(
    goal: Goal | AnyPath | Mapping[str, object],
    out: AnyPath,
    *,
    threads: int = 0,
    progress: Callable[[SoFar], None] | None = None,
) -> Optimum:
    """Look for the designs that do best what a goal asks, as `forficula optimise` does.

    Args:
        goal: or the name of one, the path of a goal file, or its tables, in which `design` may be a design.
        out: folder with the rows of runs; what was stopped goes on there.
        threads: 0 for one a core.
        progress: called after every row with how far it is and the best so far.

    Returns:
        Its `designs` are the best ones, its `table` has all that were tried.

    Raises:
        InputError: no such goal, values that are not allowed, or a folder of another design.

    >>> asked = {
    ...     "name": "holds",
    ...     "design": "binder2025-joint",
    ...     "simulate": False,
    ...     "vary": {"tendon.area": {"low": "1 mm^2", "high": "9 mm^2"}},
    ...     "limits": {"hinge_holding_torque": ">= 8 N cm"},
    ...     "objectives": {"mass": "least"},
    ...     "search": {"runs": 48, "batch": 16},
    ... }
    >>> found = ff.optimise(asked, "held")
    >>> f"{1e6 * found.designs[0].tendons[0].area:.2f} mm^2"
    '4.71 mm^2'
    """
    from forficula.goals import Goal, goal_of, load_goal
    from forficula.goals.optimise import optimise_goal

    if isinstance(goal, Mapping):
        goal = goal_of(goal)
    if not isinstance(goal, Goal):
        goal = load_goal(as_path(goal, "a named goal, or the path of a goal file"))
    return optimise_goal(goal, as_path(out, "a folder"), threads=threads, progress=progress)


def tolerance(
    design: AnyDesign,
    out: AnyPath,
    *,
    tolerances: Mapping[str, object] | None = None,
    limits: Mapping[str, object] | None = None,
    goal: AnyPath | None = None,
    minutes: float = 5.0,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[int, int, dict[str, Any]], None] | None = None,
) -> Dataset:
    """Say how likely a design works as it is built, and what decides it, as `forficula tolerance` does.

    Args:
        design: or its name or path.
        out: folder with the rows of runs; what was stopped goes on there.
        tolerances: by key, as in a goal file; 10 %, uniform, on every positive value with a unit that is not the
            protocol's where there are none.
        limits: by quantity, as in a goal file, beside what the protocol asks for.
        goal: or its name or path, whose tolerances and limits count where none are given, and whose settings hold for
            the design but for what it varies.
        minutes: how long it may take; more time gives narrower intervals.
        seed: of the points within the tolerances.
        threads: 0 for one a core.
        progress: called after every run with the runs done, the most that there are, and the row.

    Returns:
        Probabilities, indices, how far each value may go alone, and all samples; `says` among its attributes has what
        follows, in sentences.

    Raises:
        InputError: no such design or goal, values that are not allowed, or a folder of another design.

    >>> built = ff.tolerance(design, "built", tolerances={"facet.thickness": "1 %"}, minutes=0.01)
    >>> built["outcome"].values[0]
    'closed and opened'
    """
    from forficula.goals.tolerance import assess_tolerance
    from forficula.goals.tolerance.question_file import question_of
    from forficula.goals.tolerance.tolerance_table import tolerance_table

    named = None if goal is None else as_path(goal, "a named goal, or the path of a goal file")
    question = question_of(as_design(design), tolerances, limits, named)
    folder = as_path(out, "a folder")
    found = assess_tolerance(question, folder, minutes=minutes, seed=seed, threads=threads, progress=progress)
    return tolerance_table(found)


def pattern_facts(design: AnyDesign) -> PatternFacts:
    """Say what a design's crease pattern is, as `forficula pattern` does: freedoms, faults, flat-foldability.

    Args:
        design: or its name, or the path of a design file, a FOLD file or a drawing.

    >>> ff.pattern_facts("binder2025").title
    'earwig fan, 1 unit, 3 veins'
    """
    from forficula.design import design_pattern
    from forficula.pattern import pattern_facts as facts_of

    return facts_of(design_pattern(as_design(design)))


def figure(of: object, kind: str | None = None, *, width: float | Literal["column", "page"] = "column") -> Figure:
    """Draw a figure of some results, as `forficula figure` does.

    Args:
        of: a folder that a command wrote, or a record, a landscape, a study's table, a convergence study, a
            material, or what became of cycles.
        kind: which figure, by the name of its picture in the folder; may be left out where there is one only.
        width: of a journal's column or page, or inch.

    Raises:
        InputError: no such kind, another width, or nothing that has figures.

    >>> ff.figure(record, "angles", width="page").savefig("angles.pdf")
    """
    from forficula.show.folder.figure_kinds import drawings_of
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


def page(of: Record | Design | PartSet | AnyPath, path: AnyPath, *, engine: bool = True) -> None:
    """Write a run, or parts to make with their checks, as one HTML file that plays in any browser without a network.

    Args:
        of: a record, the folder of a run, parts, or a design, whose structure a reader then moves, as `forficula open`
            writes it.
        path: of the page; must end with .html.
        engine: whether the simulator is in the page of a run, with which a reader moves the structure; it takes 3.5 MB.

    Raises:
        InputError: no such run, another ending, or it cannot be written.

    >>> ff.page(record, "run.html")
    """
    from forficula.analysis import measure
    from forficula.dynamics import as_record
    from forficula.make.check_parts import check_parts
    from forficula.make.part import PartSet
    from forficula.show.page import write_run_page
    from forficula.show.page.bench_page import write_bench_page
    from forficula.show.page.page import page_path
    from forficula.show.page.parts_page import write_parts_page

    file = page_path(path)
    if isinstance(of, PartSet):
        write_parts_page(of, check_parts(of), file)
        return
    if isinstance(of, Design):
        write_bench_page(of, file)
        return
    record = as_record(of)
    write_run_page(record, measure(record), file, engine=engine)


def compare(folders: Iterable[AnyPath], path: AnyPath) -> None:
    """Show runs side by side on one clock, as `forficula compare` does: a page.

    Args:
        folders: of the runs, two to twelve.
        path: of the page; must end with .html.

    Raises:
        InputError: too few or too many folders, one that holds no run, or it cannot be written.

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
    """Write a record, a landscape, a convergence study, a material or parts to a folder, as its command does.

    Args:
        result: of `run`, `landscape`, `converge`, `characterise` or `make_parts`, which are checked without a record.
        folder: made where it is missing; what an earlier result of the kind left there is replaced.

    Raises:
        InputError: nothing that a command writes, or the folder cannot be written.

    >>> ff.save(record, "there")
    >>> ff.load_record("there").design.name
    'letter-fold'
    """
    from forficula.analysis import measure
    from forficula.dynamics import Record
    from forficula.make.check_parts import check_parts
    from forficula.make.part import PartSet
    from forficula.material.characterisation import Characterisation
    from forficula.show import write_run
    from forficula.show.folder.convergence_folder import write_convergence
    from forficula.show.folder.landscape_folder import write_landscape
    from forficula.show.folder.material_folder import write_material
    from forficula.show.folder.parts_folder import write_parts
    from forficula.statics import EnergyLandscape
    from forficula.study.convergence import Convergence
    from forficula.study.made_comparison import MadeComparison, comparison_or_why

    if folder == "":  # which would be the current one
        raise InputError('need a folder, got ""')
    folder = as_path(folder, "a folder")
    match result:
        case Record():
            write_run(result, measure(result), folder)
        case EnergyLandscape():
            write_landscape(result, folder)
        case Convergence():
            write_convergence(result, folder)
        case Characterisation():
            write_material(result, folder)
        case PartSet():
            compared = comparison_or_why(result) if result.joints else None
            made = compared if isinstance(compared, MadeComparison) else None
            write_parts(result, check_parts(result), folder, compared=made)
        case _:
            raise InputError(
                f"need a record, a landscape, a convergence study, a material or parts, got a {type(result).__name__}"
            )
