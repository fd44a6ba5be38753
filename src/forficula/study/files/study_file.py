"""Study files: named studies and those of a user."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

from pydantic import AfterValidator, Field

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
from forficula.design.file_fields import DESIGN, SETTINGS, DesignName, FolderName, Settings, Whole, entry
from forficula.design.files.provenance import check_paper
from forficula.design.files.rejection import read_section
from forficula.design.section import Section
from forficula.errors import InputError, error_prefix
from forficula.structure import structure_of
from forficula.study.assumptions.choices import one_at_a_time, with_own_word
from forficula.study.changes import ChangePlan
from forficula.study.factors import MOST_VALUES, Factor, Factors, Grid, read_factor
from forficula.study.files.change_file import ChangeTable, read_changes
from forficula.study.files.named_file import FileKind, base_design, load_named, named_files
from forficula.study.files.search_file import SearchTable, read_search
from forficula.study.points import SampledPoints, grid_points
from forficula.study.search_steps import Search
from forficula.study.study import Study


class PointSampling(Section):
    """Sampling of points from distributions."""

    method: Literal["random", "sobol"] = entry("sampling method", "sobol")
    count: Annotated[Whole, Field(le=MOST_VALUES)] = entry(
        "number of points", ..., at_least=1, examples=("count = 64",)
    )
    seed: Whole = entry("random seed", 0, at_least=0)


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
    sampling: PointSampling | None = entry("sampling of factors that are distributions")
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
    if file.sampling is not None and not drawn:
        raise InputError("sampling: needs factors that are distributions, got lists and ranges")
    search = _search(file, base, {factor.key: f"factors.{factor.key}" for factor in (*factors, *grid)})
    choices: tuple[Mapping[str, object], ...] = ()
    if file.vary == "one-at-a-time":
        factors = tuple(with_own_word(base, factor) for factor in factors)
        choices = one_at_a_time(base, factors)
    points: Sequence[Mapping[str, object]]
    if drawn:
        with error_prefix("sampling."):
            sampling = file.sampling or read_section(PointSampling, {})
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
        sampled=bool(drawn),
        search=search,
        choices=choices,
        grid=grid,
        reproduces=file.reproduces,
    )


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
        factors = [read_factor(key, value_from_folder(key, value, folder), type(base)) for key, value in table.items()]
        for factor in factors:
            now, quantity = key_value(base, factor.key), key_quantity(factor.key, factor.model)
            if factor.distribution is not None and quantity is None and not isinstance(now, float):
                raise InputError(f"{factor.key}: need a list or a range; only numbers with fractions are drawn")
    return tuple(factors)


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
