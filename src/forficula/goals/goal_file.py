"""Goals in files: named ones, and those of a user."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, ClassVar

from pydantic import BeforeValidator, Field

from forficula.design import Design, check_keys_once, numbered_key, value_from_folder
from forficula.design.file_fields import (
    DESIGN,
    SETTINGS,
    ByKey,
    DesignName,
    FolderName,
    Settings,
    Whole,
    YesOrNo,
    entry,
)
from forficula.design.files.rejection import read_part
from forficula.design.section import Section
from forficula.errors import InputError, error_prefix
from forficula.goals.deviation import SIZE, Deviation, ToleranceEntry, read_deviations
from forficula.goals.goal import Goal, Objective
from forficula.goals.limit import Limit, check_limits, read_limit
from forficula.goals.outcome_quantity import PROBABILITY, OutcomeQuantity, quantities_of, quantity_of
from forficula.goals.parameter import Parameter, RangeEntry, read_parameter
from forficula.names import check_known, listed, one_of
from forficula.study.factors import VALUES
from forficula.study.files.named_file import FileKind, base_design, load_named, named_files
from forficula.study.files.search_file import TorqueSearchTable, read_search
from forficula.study.search_steps import Search

_MOST_OBJECTIVES = 3
_Count = Annotated[Whole, Field(le=1_000_000)]
_Parameters = Annotated[
    dict[str, Any],
    BeforeValidator(ByKey(allowed=f"{VALUES}; or table", entry=RangeEntry)),
]
_Limits = Annotated[
    dict[str, Any], BeforeValidator(ByKey(allowed='">= 5 N cm", "<= 5 N cm", or a list', placeholder="QUANTITY"))
]
_Objectives = Annotated[dict[str, Any], BeforeValidator(ByKey(allowed='"least" or "largest"', placeholder="QUANTITY"))]
_Tolerances = Annotated[dict[str, Any], BeforeValidator(ByKey(allowed=f'{SIZE}, or "none"', entry=ToleranceEntry))]


class GoalSearchTable(TorqueSearchTable):
    """How many designs are tried, and the torques of searches for least torques."""

    runs: _Count = entry("designs that are tried at most; the first fill the space", 512, at_least=1)
    batch: _Count = entry("designs that run side by side", 32, at_least=4)
    neighbours: _Count = entry("designs within the tolerances of one that are tried", 64, at_least=8)
    seed: _Count = entry("random seed", 0, at_least=0)


class GoalFile(Section):
    """A goal as its file has it; a tolerance takes the settings, limits and tolerances of such a file."""

    about: ClassVar[str] = (
        "A forficula goal: what a structure must do, what may vary, and its tolerances; forficula keys --goal lists all"
        " keys"
    )

    name: FolderName = entry("what outputs call it", "goal", left_out="the file's name")
    source: str = entry("where the question comes from", "")
    design: DesignName = DESIGN
    simulate: YesOrNo = entry("whether a run must reach the goals of its protocol; false: statics alone decides", True)
    settings: Settings = SETTINGS
    vary: _Parameters = entry(
        "values that the key may have",
        {},
        left_out="needed",
        examples=(
            '"$key" = { low = "$low", high = "$high" }',
            '"$key" = { low = "$low", high = "$high", step = "$step" }',
            '"$key" = ["$low", "$value", "$high"]',
        ),
    )
    limits: _Limits = entry(
        "what the quantity or key of the design must not fall below, or exceed, beside what the protocol asks for",
        {},
        examples=('${first}_time = "<= 0.5 s"', 'probability = ">= 95 %"'),
    )
    objectives: _Objectives = entry(
        "whether the quantity or key of the design is to be least or largest; two or three objectives give a front",
        {},
        left_out="needed",
        examples=('${first}_work = "least"',),
    )
    tolerances: _Tolerances = entry(
        "by how much the key may deviate when it is built, uniform in both directions; the key all stands for every"
        " positive number with a unit that is not the protocol's",
        {},
        examples=('all = "10 %"', '"$key" = "5 %"', '"$key" = { distribution = "normal", size = "$step" }'),
    )
    search: GoalSearchTable = entry("how many designs are tried", GoalSearchTable())


def _texts(design: Design) -> dict[str, str]:
    """What a new file says beside its keys."""
    return {"limits": f"Quantities are {listed(quantities_of(design))}"}


GOAL = FileKind(word="goal", several="goals", package="forficula.goals", model=GoalFile, texts=_texts)


def load_goal(name_or_path: str | Path) -> Goal:
    """Read a named goal or a goal file.

    Args:
        name_or_path: one of `named_goals`, or the path of a TOML file.

    Raises:
        InputError: no such goal or file, not TOML, an unknown key, or a value that is not allowed.
    """
    return load_named(name_or_path, GOAL, _goal)


def goal_of(tables: Mapping[str, Any]) -> Goal:
    """Build a goal of tables as a file has them, but for `design`, which may be one.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    return _goal(read_part(GoalFile, tables), Path())


def named_goals() -> list[str]:
    """The names of the goals that come with the package."""
    return named_files(GOAL)


def _goal(file: GoalFile, folder: Path) -> Goal:
    base = base_design(file.design, file.settings, folder)
    limits = read_limits(file.limits, base)
    given = tuple(each for each in limits if each.quantity.source == "search" and each.kind == "<=")
    base = with_torques(base, given)
    limits = tuple(each for each in limits if each not in given)
    if any(each.quantity.name == PROBABILITY and each.kind == "<=" for each in limits):
        raise InputError(f'limits.{PROBABILITY}: need a lower limit, such as ">= 95 %"')
    objectives = _objectives(file.objectives, base)
    deviations = deviations_within(file.tolerances, base, folder)
    parameters = _parameters(file.vary, base, folder)
    asked = [*(each.quantity for each in limits), *(each.quantity for each in objectives)]
    _check_asked([*(each.quantity for each in given), *asked], parameters, deviations, simulate=file.simulate)
    _check_varied(asked, given, parameters, base)
    return Goal(
        name=file.name,
        source=file.source,
        base=base,
        parameters=parameters,
        limits=limits,
        given=given,
        objectives=objectives,
        deviations=deviations,
        simulate=file.simulate,
        search=_search(file.search, asked, base),
        runs=file.search.runs,
        batch=file.search.batch,
        neighbours=file.search.neighbours,
        seed=file.search.seed,
    )


def read_limits(given: Mapping[str, Any], base: Design) -> tuple[Limit, ...]:
    """Read the limits of a file by the quantities' names.

    Raises:
        InputError: an unknown quantity, or no limit.
    """
    found = []
    for name, texts in given.items():
        with error_prefix("limits."):
            quantity = quantity_of(base, name)
        with error_prefix(f"limits.{name}: "):
            limits = [read_limit(quantity, text) for text in (texts if isinstance(texts, list) else [texts])]
            check_limits(limits)
        found += limits
    return tuple(found)


def _objectives(given: Mapping[str, Any], base: Design) -> tuple[Objective, ...]:
    found = []
    for name, kind in given.items():
        with error_prefix("objectives."):
            quantity = quantity_of(base, name)
        if kind not in ("least", "largest"):
            raise InputError(f"objectives.{name}: need {one_of(('least', 'largest'), kind)}")
        found.append(Objective(quantity=quantity, kind=kind))
    if not 1 <= len(found) <= _MOST_OBJECTIVES:
        raise InputError(
            f'objectives: need one to three quantities, such as mass = "least", got {len(found) or "none"}'
        )
    return tuple(found)


def with_torques(base: Design, given: Sequence[Limit]) -> Design:
    """The design with the torques of upper limits on least torques as its protocol's."""
    if not given:
        return base
    steps = {step.least_name: step for step in read_search("least-torques", {}, base).steps}
    values: dict[str, object] = {}
    # of several limits on one, the strictest comes last
    for limit in sorted(given, key=lambda each: -each.bound):
        step = steps[limit.quantity.name]
        values[step.key] = step.sign * limit.bound
    return base.with_values(values)


def deviations_within(given: Mapping[str, Any], base: Design, folder: Path) -> tuple[Deviation, ...]:
    """Read the tolerances of a file that lies in a folder.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    within = {
        key: {**value, "intervals_of": str(folder / value["intervals_of"])}
        if isinstance(value, dict) and str(value.get("intervals_of", "")).endswith(".toml")
        else value
        for key, value in given.items()
    }
    with error_prefix("tolerances."):
        return read_deviations(within, base)


def _parameters(given: Mapping[str, Any], base: Design, folder: Path) -> tuple[Parameter, ...]:
    with error_prefix("vary."):
        check_keys_once(given, base)
        return tuple(read_parameter(key, value_from_folder(key, value, folder), base) for key, value in given.items())


def _check_asked(
    asked: Sequence[OutcomeQuantity],
    parameters: Sequence[Parameter],
    deviations: Sequence[Deviation],
    *,
    simulate: bool,
) -> None:
    """Refuse what cannot be known of the designs that are tried."""
    for quantity in asked:
        if quantity.source in ("run", "record", "search") and not simulate:
            raise InputError(f"{quantity.name}: is known by running a design, which simulate = false leaves out")
        if quantity.name == PROBABILITY and not deviations:
            raise InputError(f'{PROBABILITY}: needs tolerances, such as all = "10 %" under [tolerances]')
    if not parameters:
        raise InputError('vary: need at least one key, such as "tendon.stiffness" = { low = "4 N/cm", high = ".." }')


def _check_varied(
    asked: Sequence[OutcomeQuantity], given: Sequence[Limit], parameters: Sequence[Parameter], base: Design
) -> None:
    """Refuse to vary what a limit on a least torque settles, or a search for one tries."""
    names = {each.name for each in (*asked, *(limit.quantity for limit in given)) if each.source == "search"}
    if not names:
        return
    settled = {step.key: step.least_name for step in read_search("least-torques", {}, base).steps}
    varied = {numbered_key(base, each.key): each.key for each in parameters}
    for key, name in settled.items():
        if name in names and (own := varied.get(numbered_key(base, key))) is not None:
            raise InputError(f"vary.{own}: is what {name} is about; need it in one of them")


def _search(table: GoalSearchTable, asked: Sequence[OutcomeQuantity], base: Design) -> Search | None:
    """What a search for least values tries, where one of them is asked for."""
    counts = ("runs", "batch", "neighbours", "seed")
    own = table.model_dump(exclude_unset=True, exclude=set(counts))
    if any(quantity.source == "search" for quantity in asked):
        return read_search("least-torques", own, base)
    check_known(own, counts, "search.")
    return None
