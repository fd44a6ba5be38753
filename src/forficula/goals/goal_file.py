"""Goal files: named goals and those of a user."""

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
from forficula.design.files.rejection import read_section
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
    """Size of the search, and the torques of searches for least torques."""

    runs: _Count = entry("largest number of designs to try; the first ones fill the space", 512, at_least=1)
    batch: _Count = entry("number of designs that run in parallel", 32, at_least=4)
    neighbours: _Count = entry(
        "number of variants within the tolerances that are run to compute the probability of a design", 64, at_least=8
    )
    seed: _Count = entry("random seed", 0, at_least=0)


class GoalFile(Section):
    """Content of a goal file. `forficula tolerance` uses the settings, limits and tolerances of such a file."""

    about: ClassVar[str] = (
        "A forficula goal: what a structure must do, what may vary, and its tolerances; forficula keys --goal lists all"
        " keys"
    )

    name: FolderName = entry("name of the goal in outputs", "goal", left_out="the file's name")
    source: str = entry("source of the goal", "")
    design: DesignName = DESIGN
    simulate: YesOrNo = entry(
        "true: a simulated run must reach the goals of its protocol; false: only statics is computed", True
    )
    settings: Settings = SETTINGS
    vary: _Parameters = entry(
        "values that the key may have in a design",
        {},
        left_out="needed",
        examples=(
            '"$key" = { low = "$low", high = "$high" }',
            '"$key" = { low = "$low", high = "$high", step = "$step" }',
            '"$key" = ["$low", "$value", "$high"]',
        ),
    )
    limits: _Limits = entry(
        "lower or upper limit of a quantity or key of the design, in addition to the goals of the protocol",
        {},
        examples=('${first}_time = "<= 0.5 s"', 'probability = ">= 95 %"'),
    )
    objectives: _Objectives = entry(
        "minimise or maximise a quantity or key of the design; two or three objectives give a Pareto front",
        {},
        left_out="needed",
        examples=('${first}_work = "least"',),
    )
    tolerances: _Tolerances = entry(
        'manufacturing tolerance of the key, uniform in both directions unless stated; the key "all" means every'
        " positive number with a unit that is not in the protocol",
        {},
        examples=('all = "10 %"', '"$key" = "5 %"', '"$key" = { distribution = "normal", size = "$step" }'),
    )
    search: GoalSearchTable = entry("size and seed of the search", GoalSearchTable())


def _texts(design: Design) -> dict[str, str]:
    """Return the texts of a new file that depend on its design."""
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
    """Build a goal from tables as in a goal file; `design` may be a `Design`.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    return _goal(read_section(GoalFile, tables), Path())


def named_goals() -> list[str]:
    """Return the names of the goals that the package contains."""
    return named_files(GOAL)


def _goal(file: GoalFile, folder: Path) -> Goal:
    base = base_design(file.design, file.settings, folder)
    limits = read_limits(file.limits, base)
    torque_limits = tuple(limit for limit in limits if limit.quantity.source == "search" and limit.kind == "<=")
    base = with_torques(base, torque_limits)
    limits = tuple(limit for limit in limits if limit not in torque_limits)
    if any(limit.quantity.name == PROBABILITY and limit.kind == "<=" for limit in limits):
        raise InputError(f'limits.{PROBABILITY}: need a lower limit, such as ">= 95 %"')
    objectives = _objectives(file.objectives, base)
    deviations = deviations_within(file.tolerances, base, folder)
    parameters = _parameters(file.vary, base, folder)
    quantities = [*(limit.quantity for limit in limits), *(objective.quantity for objective in objectives)]
    _check_computable(
        [*(limit.quantity for limit in torque_limits), *quantities], parameters, deviations, simulate=file.simulate
    )
    _check_varied(quantities, torque_limits, parameters, base)
    return Goal(
        name=file.name,
        source=file.source,
        base=base,
        parameters=parameters,
        limits=limits,
        torque_limits=torque_limits,
        objectives=objectives,
        deviations=deviations,
        simulate=file.simulate,
        search=_search(file.search, quantities, base),
        runs=file.search.runs,
        batch=file.search.batch,
        neighbours=file.search.neighbours,
        seed=file.search.seed,
    )


def read_limits(table: Mapping[str, Any], base: Design) -> tuple[Limit, ...]:
    """Read the limits of a file, a table by names of quantities.

    Raises:
        InputError: an unknown quantity, or an invalid limit.
    """
    limits = []
    for name, texts in table.items():
        with error_prefix("limits."):
            quantity = quantity_of(base, name)
        with error_prefix(f"limits.{name}: "):
            of_name = [read_limit(quantity, text) for text in (texts if isinstance(texts, list) else [texts])]
            check_limits(of_name)
        limits += of_name
    return tuple(limits)


def _objectives(table: Mapping[str, Any], base: Design) -> tuple[Objective, ...]:
    objectives = []
    for name, kind in table.items():
        with error_prefix("objectives."):
            quantity = quantity_of(base, name)
        if kind not in ("least", "largest"):
            raise InputError(f"objectives.{name}: need {one_of(('least', 'largest'), kind)}")
        objectives.append(Objective(quantity=quantity, kind=kind))
    if not 1 <= len(objectives) <= _MOST_OBJECTIVES:
        raise InputError(
            f'objectives: need one to three quantities, such as mass = "least", got {len(objectives) or "none"}'
        )
    return tuple(objectives)


def with_torques(base: Design, limits: Sequence[Limit]) -> Design:
    """Return the design whose protocol has the torques of the upper limits on least torques."""
    if not limits:
        return base
    steps = {step.result_name: step for step in read_search("least-torques", {}, base).steps}
    values: dict[str, object] = {}
    # of several limits on one torque, the strictest comes last
    for limit in sorted(limits, key=lambda limit: -limit.bound):
        step = steps[limit.quantity.name]
        values[step.key] = step.sign * limit.bound
    return base.with_values(values)


def deviations_within(table: Mapping[str, Any], base: Design, folder: Path) -> tuple[Deviation, ...]:
    """Read the tolerances of a file in a folder.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    tolerances = {
        key: {**value, "intervals_of": str(folder / value["intervals_of"])}
        if isinstance(value, dict) and str(value.get("intervals_of", "")).endswith(".toml")
        else value
        for key, value in table.items()
    }
    with error_prefix("tolerances."):
        return read_deviations(tolerances, base)


def _parameters(table: Mapping[str, Any], base: Design, folder: Path) -> tuple[Parameter, ...]:
    with error_prefix("vary."):
        check_keys_once(table, base)
        return tuple(read_parameter(key, value_from_folder(key, value, folder), base) for key, value in table.items())


def _check_computable(
    quantities: Sequence[OutcomeQuantity],
    parameters: Sequence[Parameter],
    deviations: Sequence[Deviation],
    *,
    simulate: bool,
) -> None:
    """Reject quantities that cannot be computed for the designs that are tried."""
    for quantity in quantities:
        if quantity.source in ("run", "record", "search") and not simulate:
            raise InputError(f"{quantity.name}: is known by running a design, which simulate = false leaves out")
        if quantity.name == PROBABILITY and not deviations:
            raise InputError(f'{PROBABILITY}: needs tolerances, such as all = "10 %" under [tolerances]')
    if not parameters:
        raise InputError('vary: need at least one key, such as "tendon.stiffness" = { low = "4 N/cm", high = ".." }')


def _check_varied(
    quantities: Sequence[OutcomeQuantity], limits: Sequence[Limit], parameters: Sequence[Parameter], base: Design
) -> None:
    """Reject varying a key whose value a limit on a least torque sets, or a search for a least torque tries."""
    names = {
        quantity.name
        for quantity in (*quantities, *(limit.quantity for limit in limits))
        if quantity.source == "search"
    }
    if not names:
        return
    settled = {step.key: step.result_name for step in read_search("least-torques", {}, base).steps}
    varied = {numbered_key(base, parameter.key): parameter.key for parameter in parameters}
    for key, name in settled.items():
        if name in names and (key_in_file := varied.get(numbered_key(base, key))) is not None:
            raise InputError(f"vary.{key_in_file}: is what {name} is about; need it in one of them")


def _search(table: GoalSearchTable, quantities: Sequence[OutcomeQuantity], base: Design) -> Search | None:
    """Read the search for least torques if a limit or objective needs it, else None."""
    counts = ("runs", "batch", "neighbours", "seed")
    search_keys = table.model_dump(exclude_unset=True, exclude=set(counts))
    if any(quantity.source == "search" for quantity in quantities):
        return read_search("least-torques", search_keys, base)
    check_known(search_keys, counts, "search.")
    return None
