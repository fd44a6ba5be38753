"""Calls that run a design many times."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from forficula.calls.journals import journal_folder, seed_of
from forficula.calls.progress import ProgressOption, reporting, runs_done, simulated
from forficula.design import AnyDesign, as_design
from forficula.errors import InputError, error_prefix
from forficula.files import AnyPath, as_path
from forficula.quantities import as_written

if TYPE_CHECKING:
    from numpy.random import Generator

    from forficula.study import Study
    from forficula.study.assumptions.assumptions import Assumptions
    from forficula.study.convergence.convergence import Convergence
    from forficula.study.cycling import Cycling
    from forficula.study.running.run_study import Building, Evaluate
    from forficula.study.running.study_status import StudyStatus
    from forficula.study.tables.study_table import StudyTable

_REFINEMENTS = ("timesteps", "moduli", "meshes")


def converge(
    design: AnyDesign,
    *,
    timesteps: str | Sequence[float] | None = None,
    moduli: str | Sequence[float] | None = None,
    meshes: str | Sequence[float] | None = None,
    progress: ProgressOption = None,
) -> Convergence:
    """Run a design at several timesteps, membrane moduli or meshes, as `forficula converge` does.

    Exactly one of `timesteps`, `moduli` and `meshes` is required.

    Args:
        design: design, its name or its path.
        timesteps: text such as "0.5 0.2 ms", or numbers in s.
        moduli: Young's moduli of the membrane: text such as "0.5 1 2 MPa", or numbers in Pa.
        meshes: factors by which the rows of the membrane's mesh are closer: text such as "1 2", or numbers.
        progress: as in `run`.

    Raises:
        InputError: none or several of the three, or values that are not allowed.

    >>> set(ff.converge(design, timesteps="0.2 0.1 ms").statuses)
    {'closed and opened'}
    """
    from forficula.study.convergence.convergence import converge as converge_design
    from forficula.study.convergence.refinement import MESH, TIMESTEP, YOUNGS_MODULUS, read_values

    every = zip(_REFINEMENTS, (TIMESTEP, YOUNGS_MODULUS, MESH), (timesteps, moduli, meshes), strict=True)
    chosen = [(name, key, values) for name, key, values in every if values is not None]
    if len(chosen) != 1:
        names = ", ".join(name for name, _, _ in chosen) or "none"
        raise InputError(f"converge: need one of {', '.join(_REFINEMENTS)}, got {names}")
    ((name, key, values),) = chosen
    with error_prefix(f"{name}: "), reporting(progress, runs_done) as tell:
        read = read_values(key, values) if isinstance(values, str) else values
        read = [*read] if isinstance(read, Iterable) else read
        if not isinstance(read, Sequence) or not all(isinstance(value, int | float) for value in read):
            raise InputError(f"need text with a unit, or a list of numbers, got {as_written(values)}")
        return converge_design(as_design(design), key, read, progress=tell)


def assumptions(
    design: AnyDesign, *, only: Iterable[str] | None = None, progress: ProgressOption = None
) -> Assumptions:
    """Run a design with one modelling assumption changed at a time, as `forficula assumptions` does.

    Args:
        design: design, its name or its path.
        only: names of the assumptions to change, such as "slow rise"; all that apply if not given.
        progress: as in `run`.

    Returns:
        All runs, and which of them change the verdict.

    Raises:
        InputError: no such design or assumption, or the design cannot be built.

    >>> table = ff.assumptions(design, only=["timestep"])
    >>> table.own.status, table.deciding
    ('closed and opened', ())
    """
    from forficula.study.assumptions.assumptions import run_assumptions
    from forficula.study.assumptions.modelling_assumptions import selected

    read = as_design(design)
    with error_prefix("only: "):
        chosen = selected(only)
    with reporting(progress, simulated) as tell:
        return run_assumptions(read, assumptions=chosen, progress=tell)


def run_cycles(design: AnyDesign, last: int, progress: ProgressOption = None) -> Cycling:
    """Run a design with its tendons as they are after many load cycles, as `forficula run --cycles` does.

    Args:
        design: design, its name or its path; its tendons have a law (`tendon.law`) with drift or softening.
        last: number of the last cycle; each of the first 20 cycles is run, then ten per decade.
        progress: as in `run`.

    Raises:
        InputError: the tendons do not change, the protocol drives no transition, or `last` is not >= 1.

    >>> ff.run_cycles(design, 2)
    Traceback (most recent call last):
    ...
    forficula.errors.InputError: cycles: the design has no tendon.law ... every cycle is like the first
    """
    from forficula.study.cycling import run_cycles as run_all

    read = as_design(design)
    with reporting(progress, runs_done) as tell:
        return run_all(read, last, tell)


def new_study(
    design: AnyDesign,
    factors: Mapping[str, object] | None = None,
    *,
    name: str = "study",
    rng: Generator | int | None = 0,
    **tables: object,
) -> Study:
    """Build a study without a file. `Study.run` runs it, `Study.estimate` estimates its duration.

    Args:
        design: design to vary, its name or its path.
        factors: by key of the design: a list of values, a range, or a distribution, as in a study file; numbers of keys
            with a unit are in SI. None for a study of named changes, `change=[{"name": ..., "values": {...}}]`.
        name: name of the study in outputs.
        rng: seed of factors that are distributions, or a generator that draws the seed; None for a new seed each time.
        **tables: further tables and keys of a study file, such as `ask="least-torques"` or
            `search={"refinements": 2}`; `forficula keys --study` lists them.

    Raises:
        InputError: an unknown key, or a value that is not allowed.

    >>> study = ff.new_study(design, {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]})
    >>> study.run()["status"].values.tolist()
    ['closed and opened', 'closed and opened']
    """
    from forficula.study.factors import written_in_units
    from forficula.study.files.change_file import in_units
    from forficula.study.files.study_file import study_of

    if not (isinstance(rng, int) and rng == 0):
        sampling = tables.get("sampling", {})
        if isinstance(sampling, Mapping):
            tables["sampling"] = {**sampling, "seed": seed_of(rng, None)}
    base = as_design(design)
    if factors is not None:
        tables["factors"] = factors
    for table, values in [*tables.items()]:
        if table in ("factors", "grid") and isinstance(values, Mapping):
            with error_prefix(f"{table}."):
                tables[table] = {key: written_in_units(key, value, type(base)) for key, value in values.items()}
    changes = tables.get("change")
    if isinstance(changes, Sequence) and not isinstance(changes, str):
        tables["change"] = [in_units(change, base) if isinstance(change, Mapping) else change for change in changes]
    return study_of({**tables, "name": name, "design": base})


def run_study(
    study: Study,
    out: AnyPath | None = None,
    *,
    shard: tuple[int, int] = (1, 1),
    threads: int = 0,
    batch: int = 1024,
    cluster: Evaluate | None = None,
    progress: ProgressOption = None,
    building: Building | None = None,
) -> StudyTable | None:
    """Run a study and return its table, as `forficula study` does.

    Args:
        study: study to run.
        out: folder of the journal, in which an interrupted study continues; a temporary one if not given.
        shard: number, from 1 on, and count: only every count-th point is run, so that machines can share a study.
        threads: number of threads; 0 for one per core.
        batch: number of runs side by side.
        cluster: function that runs designs elsewhere, from `dask_cluster`; the cores of this machine if not given.
        progress: as in `run`; `Progress.latest` is the row of the last run.
        building: function that is called with the number of points that are checked, and the number of all, while
            points are checked that do not run here.

    Returns:
        Table with one entry per point; None if points of other shards are missing.

    Raises:
        InputError: the folder contains rows of another study or cannot be written, or a number is not allowed.

    >>> study = ff.new_study(design, {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]})
    >>> ff.run_study(study)["close_time"].sizes
    Frozen({'tendon_left_stiffness': 2})
    """
    from forficula.study import run_study as run_in

    options = {"shard": shard, "threads": threads, "batch": batch, "cluster": cluster, "building": building}
    with journal_folder(out) as folder, reporting(progress, runs_done) as tell:
        table: StudyTable | None = run_in(study, folder, progress=tell, **options)  # type: ignore[arg-type, assignment]
    return table


def collect(study: Study, out: AnyPath, building: Building | None = None) -> StudyTable:
    """Return the table of a study from the rows of all shards; see `Study.collect`.

    >>> study = ff.new_study(design, {"tendon.left.stiffness": ["0.4 N/cm"]})
    >>> table = study.run("shards")
    >>> study.collect("shards").equals(table)
    True
    """
    from forficula.study import collect as collect_from

    table: StudyTable = collect_from(study, as_path(out, "a folder"), building)  # type: ignore[assignment]
    return table


def estimate(
    study: Study, out: AnyPath | None = None, building: Building | None = None, *, shard: tuple[int, int] = (1, 1)
) -> tuple[int, int, float]:
    """Return the largest number of runs, the points to run and their estimated duration, s; see `Study.estimate`.

    >>> most, left, seconds = ff.load_study("binder2025-search").estimate()
    >>> left
    60
    """
    from forficula.study import estimate as estimate_in

    with journal_folder(out) as folder:
        return estimate_in(study, folder, building, shard=shard)


def study_status(study: Study, out: AnyPath) -> StudyStatus:
    """Return which shards of a study are complete, run, or must run again; see `Study.status`.

    >>> study = ff.new_study(design, {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]})
    >>> ff.run_study(study, "parts", shard=(1, 2))
    >>> status = study.status("parts")
    >>> status.complete, status.points_done, status.run_again
    (False, 1, '2')
    """
    from forficula.study.running.study_status import study_status as status_of

    return status_of(study, as_path(out, "a folder"))


def sweep(
    design: AnyDesign,
    factors: Mapping[str, object],
    out: AnyPath | None = None,
    *,
    threads: int = 0,
    rng: Generator | int | None = 0,
    progress: ProgressOption = None,
    **tables: object,
) -> StudyTable:
    """Run a design with values varied, and return a table with one entry per combination.

    Args:
        design: design to vary, its name or its path.
        factors: by key of the design: a list of values, a range, or a distribution, as in `new_study`.
        out: folder of the journal, in which an interrupted sweep continues; a temporary one if not given.
        threads: number of threads; 0 for one per core.
        rng: as in `new_study`.
        progress: as in `run_study`.
        **tables: as in `new_study`.

    Returns:
        Table (an `xarray.Dataset`) whose dimensions are the factors; `to_dataframe` makes a pandas table of it.

    Raises:
        InputError: an unknown key, or a value that is not allowed.

    >>> table = ff.sweep(design, {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]})
    >>> table.to_dataframe()["status"].tolist()
    ['closed and opened', 'closed and opened']
    """
    table = run_study(
        new_study(design, factors, name="sweep", rng=rng, **tables), out, threads=threads, progress=progress
    )
    assert table is not None  # there is one shard
    return table
