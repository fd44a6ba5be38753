"""Study files: named studies and those of a user."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

from pydantic import AfterValidator, BeforeValidator, Field

from forficula.design import (
    NO_LAW,
    Design,
    check_keys_once,
    key_quantity,
    key_value,
    names_law,
    numbered_key,
    value_from_folder,
)
from forficula.design.file_fields import DESIGN, SETTINGS, ByKey, DesignName, FolderName, Settings, Whole, entry
from forficula.design.files.provenance import check_paper
from forficula.design.files.rejection import read_section
from forficula.design.section import Section
from forficula.errors import InputError, error_prefix
from forficula.quantities import as_written
from forficula.structure import drive_keys, structure_of
from forficula.study.assumptions.choices import one_at_a_time, with_own_word
from forficula.study.changes import ChangePlan
from forficula.study.factors import MOST_VALUES, Factor, Factors, Grid, read_factor
from forficula.study.files.change_file import ChangeTable, read_changes
from forficula.study.files.named_file import FileKind, base_design, load_named, named_files
from forficula.study.files.search_file import SearchTable, read_search
from forficula.study.points import SampledPoints, grid_points
from forficula.study.refine.boundary_plan import OUTCOME, VERDICT, BoundaryPlan
from forficula.study.refine.lattice import DIVISIONS, read_axis
from forficula.study.search_steps import Search
from forficula.study.study import Study

REFINE = "refine"
Widths = Annotated[dict[str, Any], BeforeValidator(ByKey(allowed='width such as "0.1 cm"'))]
_MOST_FACTORS = 3


def _boundary(value: object) -> object:
    if isinstance(value, str):
        return value
    if not isinstance(value, list | tuple) or not all(isinstance(state, str) for state in value):
        raise InputError(f'need "{OUTCOME}", "{VERDICT}" or a list of states, got {as_written(value)}')
    return tuple(value)


Boundary = Annotated[Any, "text, or list of states", BeforeValidator(_boundary)]


class PointSampling(Section):
    """Sampling of points from distributions, or where outcomes change."""

    method: Literal["random", "sobol", "refine"] = entry(
        'sampling method; "refine" starts from the grid of the values under [factors] and places points where outcomes'
        " change, until each boundary is between two points that are one width apart",
        "sobol",
    )
    count: Annotated[Whole | None, Field(le=MOST_VALUES)] = entry(
        "number of points (random, sobol)", left_out="needed", at_least=1, examples=("count = 64",)
    )
    seed: Whole = entry("random seed (random, sobol)", 0, at_least=0)
    width: Widths = entry(
        'largest distance of the two points on both sides of a boundary (refine); "5 %" of the value for a key under'
        " `logarithmic`",
        {},
        left_out="by `divisions`",
    )
    divisions: Annotated[Whole, Field(le=100_000)] = entry(
        "number of widths in an interval of the initial grid, for keys without a width (refine)", DIVISIONS, at_least=1
    )
    logarithmic: tuple[str, ...] = entry("keys whose intervals are divided by equal ratios (refine)", ())
    boundary: Boundary = entry(
        'what changes at a boundary (refine): "outcome", "verdict", or a list of states that are reached or not',
        OUTCOME,
    )
    probes: Annotated[Whole, Field(le=1024)] = entry(
        "number of points in each cell of the initial grid, which reveal islands of another outcome (refine)",
        1,
        at_least=0,
    )
    most_points: Annotated[Whole, Field(le=MOST_VALUES)] = entry(
        "number of points at which refinement stops (refine)", 100_000, at_least=1
    )


class StudyFile(Section):
    """Content of a study file."""

    about: ClassVar[str] = (
        "A forficula study: every point of its factors is a run of its design; forficula keys --study lists all keys"
    )

    name: FolderName = entry("name of the study in outputs", "study", left_out="the file's name")
    source: str = entry("source of the values in this file", "")
    reproduces: Annotated[str, AfterValidator(check_paper)] | None = entry(
        "paper whose maps are compared with this study"
    )
    design: DesignName = DESIGN
    ask: Literal["run", "least-torques", "least-value"] = entry(
        "what to compute at every point: a run, or the least torques or least value that [search] defines", "run"
    )
    vary: Literal["grid", "one-at-a-time", "pairs"] = entry(
        "combine all values of all factors, or change one factor of the base at a time; changes under [[change]] are"
        " made one at a time, or also in pairs",
        "grid",
    )
    settings: Settings = SETTINGS
    factors: Factors = entry(
        "values of the key; all combinations of several lists or ranges are run",
        {},
        left_out="needed",
        examples=(
            '"$key" = ["$low", "$value", "$high"]',
            '"$key" = "$low_number..$high step $low"',
            '"$key" = { distribution = "uniform", low = "$low", high = "$high" }',
        ),
    )
    change: tuple[ChangeTable, ...] = entry(
        "instead of [factors]: named changes, such as mechanisms that are removed or weakened; the study reports with"
        " which of them all transitions still succeed",
        (),
        examples=(
            'name = "half the $key"\nmultiply = { "$key" = 0.5 }',
            'name = "another $key"\nvalues = { "$key" = "$low" }',
        ),
    )
    grid: Grid = entry("values that are combined with every change (one-at-a-time)", {})
    sampling: PointSampling | None = entry(
        "sampling of factors that are distributions, or refinement of a grid where outcomes change"
    )
    search: SearchTable | None = entry('values to try, with ask = "least-torques" or "least-value"')


STUDY = FileKind(word="study", several="studies", package="forficula.study", model=StudyFile)


def load_study(name_or_path: str | Path) -> Study:
    """Read a named study or a study file.

    Args:
        name_or_path: one of `named_studies`, or the path of a TOML file.

    Raises:
        InputError: no such study or file, not TOML, an unknown key, or a value that is not allowed.
    """
    return load_named(name_or_path, STUDY, _study)


def study_of(tables: Mapping[str, Any]) -> Study:
    """Build a study from tables as in a study file; `design` may be a `Design`.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    return _study(read_section(StudyFile, tables), Path())


def named_studies() -> list[str]:
    """Return the names of the studies that the package contains."""
    return named_files(STUDY)


def _study(file: StudyFile, folder: Path) -> Study:
    base = base_design(file.design, file.settings, folder)
    if file.change:
        return _study_of_changes(file, base, folder)
    if file.vary == "pairs":
        raise InputError('vary: "pairs" needs changes with names, under [[change]]')
    factors = read_factors(file.factors, "factors", folder, base)
    drawn = [factor for factor in factors if factor.distribution is not None]
    if drawn and len(drawn) < len(factors):
        raise InputError("factors: need either all of them as distributions or none, got both kinds")
    if "vary" in file.model_fields_set and drawn:
        raise InputError(f'vary: needs factors that are lists or ranges, got distributions with "{file.vary}"')
    if file.vary == "grid":  # one at a time, a setting is the value from which a factor is varied
        check_not_settled(file.settings, "factors", factors, base)
    grid = _repeated_grid(file, factors, folder, base)
    refined = file.sampling is not None and file.sampling.method == REFINE
    if file.sampling is not None and not drawn and not refined:
        raise InputError('sampling: needs factors that are distributions, or method = "refine", got lists and ranges')
    search = _search(file, base, {factor.key: f"factors.{factor.key}" for factor in (*factors, *grid)})
    boundaries = _boundaries(file, factors, base, search) if refined else None
    choices: tuple[Mapping[str, object], ...] = ()
    if file.vary == "one-at-a-time":
        factors = tuple(with_own_word(base, factor) for factor in factors)
        choices = one_at_a_time(base, factors)
    points: Sequence[Mapping[str, object]]
    if drawn:
        sampling = file.sampling or PointSampling()
        if sampling.count is None:
            raise InputError(f"sampling.count: is missing; give it (whole number, >= 1, <= {MOST_VALUES})")
        _check_unused(sampling, "refine", ("width", "divisions", "logarithmic", "boundary", "probes", "most_points"))
        points = SampledPoints(factors, sampling.method, sampling.count, sampling.seed)
    elif choices:
        points = tuple({**choice, **point} for choice in choices for point in grid_points(grid, len(choices)))
    else:
        points = grid_points(factors)
    return Study(
        name=file.name,
        source=file.source,
        base=base,
        factors=factors,
        points=points,
        sampled=bool(drawn) or boundaries is not None,
        search=search,
        choices=choices,
        grid=grid,
        reproduces=file.reproduces,
        boundaries=boundaries,
    )


def _boundaries(file: StudyFile, factors: tuple[Factor, ...], base: Design, search: Search | None) -> BoundaryPlan:
    """Read the plan of a study that locates boundaries."""
    sampling = file.sampling
    assert sampling is not None
    if file.vary != "grid":
        raise InputError(f'vary: need "grid" for method = "refine" under [sampling], got "{file.vary}"')
    if len(factors) > _MOST_FACTORS:
        raise InputError(f'factors: need at most {_MOST_FACTORS} for method = "refine", got {len(factors)}')
    if file.reproduces is not None:
        raise InputError('reproduces: a study with method = "refine" is not compared with a paper; leave it out')
    _check_unused(sampling, '" or "'.join(("random", "sobol")), ("count", "seed"))
    keys = {numbered_key(base, factor.key): factor.key for factor in factors}
    widths, logarithmic = {}, set()
    for name, table in (("width", list(sampling.width)), ("logarithmic", list(sampling.logarithmic))):
        for key in table:
            with error_prefix(f"sampling.{name}: "):
                if numbered_key(base, key) not in keys:
                    raise InputError(f"need a key under [factors], one of {', '.join(keys.values())}, got {key}")
            if name == "width":
                widths[keys[numbered_key(base, key)]] = sampling.width[key]
            else:
                logarithmic.add(keys[numbered_key(base, key)])
    axes = tuple(
        read_axis(
            factor,
            base,
            width=widths.get(factor.key),
            divisions=sampling.divisions,
            logarithmic=factor.key in logarithmic,
        )
        for factor in factors
    )
    plan = BoundaryPlan(axes=axes, boundary=sampling.boundary, probes=sampling.probes, most_points=sampling.most_points)
    _check_boundary(plan, base, search)
    if (count := math.prod(len(axis.grid) for axis in axes)) > plan.most_points:
        raise InputError(
            f"sampling.most_points: need at least the {count} points of the initial grid, got {plan.most_points}"
        )
    return plan


def _check_boundary(plan: BoundaryPlan, base: Design, search: Search | None) -> None:
    """Reject a boundary that the study cannot distinguish."""
    structure = structure_of(base)
    searched = {step.drive for step in search.steps} if search is not None else None
    states = [
        transition.state for transition in structure.transitions if searched is None or transition.drive in searched
    ]
    allowed = f'"{OUTCOME}", "{VERDICT}" or a list of states ({", ".join(states)})'
    if isinstance(plan.boundary, str):
        if plan.boundary not in (OUTCOME, VERDICT):
            raise InputError(f"sampling.boundary: need {allowed}, got {as_written(plan.boundary)}")
        return
    if not plan.boundary:
        raise InputError(f"sampling.boundary: need {allowed}, got an empty list")
    for state in plan.boundary:
        if state not in states:
            raise InputError(f"sampling.boundary: need {allowed}, got {as_written(state)}")


def _check_unused(sampling: PointSampling, methods: str, keys: Sequence[str]) -> None:
    """Reject keys of another sampling method, which would have no effect."""
    for key in keys:
        if key in sampling.model_fields_set:
            raise InputError(f'sampling.{key}: needs method = "{methods}", got "{sampling.method}"')


def _study_of_changes(file: StudyFile, base: Design, folder: Path) -> Study:
    """Build a study of named changes, which are made one at a time, or in pairs, too."""
    for name in ("factors", "grid", "sampling", "reproduces"):
        if getattr(file, name):
            raise InputError(f"{name}: need a study without it if there are changes under [[change]]")
    if "vary" in file.model_fields_set and file.vary == "grid":
        raise InputError('vary: need "one-at-a-time" or "pairs" for changes under [[change]], got "grid"')
    plan = read_changes(file.change, folder, base, pairs=file.vary == "pairs")
    keys = {key: f"change {name} ({key})" for name, key in _changed_keys(plan)}
    return Study(
        name=file.name,
        source=file.source,
        base=base,
        factors=(),
        points=tuple(plan.values(point) for point in range(len(plan.together))),
        sampled=False,
        search=_search(file, base, keys),
        plan=plan,
    )


def _changed_keys(plan: ChangePlan) -> Iterator[tuple[str, str]]:
    for change in plan.changes:
        for key in change.values:
            yield change.name, key


def read_factors(table: Mapping[str, object], name: str, folder: Path, base: Design) -> tuple[Factor, ...]:
    """Read a table of factors.

    Args:
        table: values by dotted key.
        name: name of the table.
        folder: folder that paths are relative to.
        base: the design that is varied.

    Raises:
        InputError: the table is empty, a value is not allowed, or a value is given under two names.
    """
    if not table:
        raise InputError(f'{name}: need a table with at least one, such as "tendon.stiffness" = "10..60 N/cm step 10"')
    with error_prefix(f"{name}."):
        check_keys_once(table, base)
        table = {_strength_key(base, key): value for key, value in table.items()}
        factors = [read_factor(key, value_from_folder(key, value, folder), type(base)) for key, value in table.items()]
        for factor in factors:
            now, quantity = key_value(base, factor.key), key_quantity(factor.key, factor.model)
            if factor.distribution is not None and quantity is None and not isinstance(now, float):
                raise InputError(f"{factor.key}: need a list or a range; only numbers with fractions are drawn")
    return tuple(factors)


def _strength_key(base: Design, key: str) -> str:
    """Return the key of a drive's strength if the key `value` stands for it; any other key unchanged."""
    drive, _, last = numbered_key(base, key).rpartition(".")
    if last != "value":
        return key
    strengths = {numbered_key(base, strength).rpartition(".")[0]: strength for strength in drive_keys(base)}
    return strengths.get(drive, key)


def check_not_settled(settings: Mapping[str, object], name: str, factors: Sequence[Factor], base: Design) -> None:
    """Reject a factor whose key is also under `settings`, because the setting would have no effect.

    Args:
        settings: settings of the file.
        name: name of the table of factors.
        factors: factors that have a value in every run.
        base: the design that is varied.

    Raises:
        InputError: the first such factor.
    """
    settled = {numbered_key(base, key): key for key in settings}
    for factor in factors:
        if names_law(factor.key) and NO_LAW in factor.values:
            continue  # a tendon whose law is removed keeps the stiffness of this law
        if (other_name := settled.get(numbered_key(base, factor.key))) is not None:
            alias = "" if other_name == factor.key else f", as {other_name}"
            raise InputError(f"{name}.{factor.key}: is under [settings], too{alias}; need it in one of them")


def _repeated_grid(file: StudyFile, factors: tuple[Factor, ...], folder: Path, base: Design) -> tuple[Factor, ...]:
    """Read the factors whose grid is repeated at every change of the factors that vary one at a time."""
    if "grid" not in file.model_fields_set:
        return ()
    if file.vary != "one-at-a-time":
        raise InputError('grid: needs vary = "one-at-a-time"; otherwise all factors are a grid, under [factors]')
    grid = read_factors(file.grid, "grid", folder, base)
    check_not_settled(file.settings, "grid", grid, base)
    if twice := {factor.key for factor in grid} & {factor.key for factor in factors}:
        raise InputError(f"grid.{min(twice)}: is under [factors], too; need it in one of them")
    if drawn := [factor.key for factor in grid if factor.distribution is not None]:
        raise InputError(f"grid.{drawn[0]}: need a list or a range, got a distribution")
    return grid


def _search(file: StudyFile, base: Design, varied: Mapping[str, str]) -> Search | None:
    """Read the search of a study and check that its key does not vary; None if the study runs the protocol.

    Args:
        file: content of the study file.
        base: the design that is varied.
        varied: for every key that varies, the text that names it in messages.
    """
    if file.ask == "run":
        if file.search is not None:
            raise InputError('search: needs ask = "least-torques" or "least-value"')
        return None
    table = {} if file.search is None else file.search.model_dump(exclude_unset=True)
    search = read_search(file.ask, table, base)
    searched_keys = {step.key for step in search.steps}
    if file.ask == "least-torques":
        searched_keys |= {drive.key for drive in structure_of(base).drives}
    if conflicts := searched_keys & varied.keys():
        raise InputError(
            f'{varied[min(conflicts)]}: is what "{file.ask}" looks for; give it under [search], or ask "run"'
        )
    return search
