"""Read and check the table `search` of a study or goal file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

from pydantic import ConfigDict, Field

from forficula.analysis import Verdict, verdict_word
from forficula.design import TORQUE, Design, key_quantity, key_value
from forficula.design.file_fields import Whole, entry
from forficula.design.section import Section
from forficula.errors import InputError, error_prefix
from forficula.names import check_known, one_of
from forficula.quantities import Unit, as_written, format_quantity, parse_quantity
from forficula.structure import Drive, Structure, Transition, drive_of, first_state, structure_of
from forficula.study.factors import Values, range_values
from forficula.study.search_steps import Scan, Search, SearchStep

_MOST_TORQUES = 1000  # each value costs one run per point


class TorqueSearchTable(Section):
    """The table `search` of a goal file. In keys, DRIVE stands for the name of a drive of the design."""

    model_config = ConfigDict(extra="allow")

    DRIVE_torques: Values = entry(
        "rising torques to try when least torques are searched for",
        left_out="the drive's",
        examples=('${first}_torques = "0..50 N cm step 10"', '${second}_torques = "10..100 N cm step 10"'),
    )
    DRIVE_with: Annotated[Any, "N cm"] = entry(
        "torque of the first drive while the least torque of the second is searched for",
        left_out="the design's",
        examples=('${first}_with = "50 N cm"',),
    )
    refinements: Annotated[Whole, Field(le=20)] = entry(
        "number of times the last step of a search is halved", 0, at_least=0
    )
    scan: Scan | None = entry(
        "values to try: all of them (full), or only those whose result does not follow from that of a larger torque"
        " that stayed short of its goal (bracket)",
        left_out='"bracket" for torques, "full" for other values',
        examples=('scan = "full"',),
    )


class SearchTable(TorqueSearchTable):
    """The table `search` of a study file."""

    key: str | None = entry(
        "key whose least value is searched for (least-value)", left_out="needed", examples=('key = "$key"',)
    )
    values: Values = entry(
        "values to try (least-value)",
        left_out="needed",
        examples=('values = ["$low", "$value", "$high"]',),
    )
    state: str | None = entry(
        "state that must be reached (least-value)", left_out="the first", examples=('state = "$state"',)
    )


def read_search(ask: str, table: Mapping[str, Any], base: Design) -> Search:
    """Read the table `search` of a study or goal file.

    Args:
        ask: "least-torques" searches for the least torques of the first two transitions of the base, with keys such as
            `fold_torques`, `fold_with`, `unfold_torques`. "least-value" has `key`, `values` and the `state` to reach.
        table: the values in the table. Default torques are those that the drive tries, or ten up to the drive's own.
        base: the design that is varied.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    structure = structure_of(base)
    if not structure.transitions:
        raise InputError(f'ask: "{ask}" needs a design that a protocol drives to a state, got {base.name}')
    start = first_state(structure, structure.stage_states)
    if ask == "least-value":
        return _value_search(table, base, structure, start)
    first, *others = structure.transitions[:2]
    names = [f"{transition.name}_torques" for transition in (first, *others)]
    check_known(table, (names[0], f"{first.name}_with", *names[1:], "refinements", "scan"), "search.")
    drives = [drive_of(structure, transition.drive) for transition in (first, *others)]
    steps = [
        _torque_step(transition, drive, table, none=transition is not first)
        for transition, drive in zip((first, *others), drives, strict=True)
    ]
    if len({step.key for step in steps}) < len(steps):
        raise InputError(
            f"least torques need transitions with drives of their own, got {steps[0].key} for both {first.name}"
            f' and {others[0].name}; a study with ask = "least-value" searches for one'
        )
    # with the drive's own torque, a point gives the same result as a run of the same values
    default_torque = format_quantity(abs(drives[0].strength) or steps[0].values[-1], TORQUE)
    name = f"{first.name}_with"
    return Search(
        first=steps[0],
        second=next((step for step in steps[1:] if step.values), None),
        reference=_rising(name, [table.get(name, default_torque)], TORQUE, none=False)[0],
        next_drive=next((transition.drive for transition in others), None),
        start_state=start,
        refinements=table.get("refinements", 0),
        scan=table.get("scan", "bracket"),
    )


def _value_search(table: Mapping[str, Any], base: Design, structure: Structure, start: str) -> Search:
    """Return a search for the least value of a key with which a state is reached."""
    check_known(table, ("key", "values", "state", "refinements", "scan"), "search.")
    if table.get("scan") == "bracket":
        raise InputError(
            'search.scan: needs ask = "least-torques" for "bracket", because of other values a smaller one may succeed'
            " where a larger one fails"
        )
    states = {transition.state: transition for transition in structure.transitions}
    state, key = table.get("state", next(iter(states))), table.get("key")
    if state not in states:
        raise InputError(f"search.state: need {one_of(list(states), str(state))}")
    if key is None:
        raise InputError('search.key: is missing; give the key whose least value is asked for: "tendon.stiffness"')
    quantity = key_quantity(key, type(base))
    if quantity is None:
        raise InputError(f"search.key: need a key whose value has a unit, got {key}")
    # raises an error for list entries that do not exist
    key_value(base, key)
    transition = states[state]
    step = SearchStep(
        transition=transition.name,
        drive=transition.drive,
        state=state,
        done=transition.wording.done,
        missed=verdict_word(Verdict.STUCK, transition.wording),
        key=key,
        values=_rising("values", table.get("values"), quantity.unit, none=False),
        unit=quantity.unit,
    )
    return Search(
        first=step,
        second=None,
        reference=0.0,
        next_drive=None,
        start_state=start,
        refinements=table.get("refinements", 0),
    )


def _torque_step(transition: Transition, drive: Drive, table: Mapping[str, Any], *, none: bool) -> SearchStep:
    name = f"{transition.name}_torques"
    return SearchStep(
        transition=transition.name,
        drive=transition.drive,
        state=transition.state,
        done=transition.wording.done,
        missed=verdict_word(Verdict.STUCK, transition.wording),
        key=drive.key,
        values=_rising(name, table.get(name, drive.tries or _tenths(drive.strength)), TORQUE, none=none),
        unit=TORQUE,
        sign=-1.0 if drive.strength < 0 else 1.0,
    )


def _tenths(torque: float) -> list[str]:
    """Return ten torques up to the size of a torque, or 0 for a torque of 0."""
    torques = [abs(torque) * tenths / 10 for tenths in range(1, 11)] if torque else [0.0]
    return [format_quantity(value, TORQUE) for value in torques]


def _rising(key: str, entry: object, unit: Unit, *, none: bool) -> tuple[float, ...]:
    """Read a list or a range: torques rise from 0 or more; values of other keys rise or fall."""
    what = "torques" if unit is TORQUE else "values"
    values = range_values(f"search.{key}", entry) if isinstance(entry, str) else entry
    if not isinstance(values, list | tuple) or not (values or none):
        raise InputError(f'search.{key}: need {what} such as "0..50 {unit.display} step 10", got {entry!r}')
    if len(values) > _MOST_TORQUES:
        raise InputError(f"search.{key}: need at most {_MOST_TORQUES} {what}, got {len(values)}")
    with error_prefix(f"search.{key}: "):
        numbers = tuple(parse_quantity(value, unit) for value in values)
    rising = sorted(set(numbers))
    if key == "values":
        if list(numbers) not in (rising, rising[::-1]):
            raise InputError(f"search.{key}: need values that rise, or that fall, got {as_written(entry)}")
    elif list(numbers) != rising or min(numbers, default=0.0) < 0:
        raise InputError(
            f"search.{key}: need rising torques >= 0, whose sign is that of the drive, got {as_written(entry)}"
        )
    return numbers
