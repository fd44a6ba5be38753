"""First line of a landscape: number of stable states, barriers between them, and what holds them."""

from __future__ import annotations

from contextlib import suppress
from itertools import combinations

from forficula.errors import InputError
from forficula.names import listed
from forficula.quantities import show_value
from forficula.show.landscape.landscape_marks import shown_value
from forficula.statics import EnergyLandscape
from forficula.statics.landscape import AT_START, barrier, fold_states, net_states

_MOST_NAMED = 4  # states
_COUNTS = ("no stable state", "monostable", "bistable")


def headline(landscape: EnergyLandscape) -> str:
    """Return whether a design is bistable, its barriers, and the force or torque that holds each state."""
    groups = _separate_states(landscape)
    names = [group[0] for group in groups]
    count = _COUNTS[len(names)] if len(names) < len(_COUNTS) else f"multistable, {len(names)} stable states"
    if landscape.net is not None and len(names) > 0:
        count += ", as far as the search found"
    more = ", ..." * (len(names) > _MOST_NAMED)
    states = f" ({', '.join(names[:_MOST_NAMED])}{more})" if names else ""
    parts = [f"{landscape.design.name}: {count}{states}"]
    parts += [f"it moves without force from {first} to {listed(others)}" for first, *others in groups if others]
    parts += [text for text in (_barriers(landscape), _holds(landscape), _partial_folds(landscape)) if text]
    return "; ".join(parts)


def _separate_states(landscape: EnergyLandscape) -> list[list[str]]:
    """Group the names of the states between which the structure moves without force: they are not locked."""
    groups: list[list[str]] = []
    for state in landscape.states:
        near = [group for group in groups if any(_moves_freely(landscape, name, state.name) for name in group)]
        groups = [group for group in groups if group not in near]
        groups.append([*(name for group in near for name in group), state.name])
    return groups


def _moves_freely(landscape: EnergyLandscape, one: str, other: str) -> bool:
    with suppress(InputError):  # no saddle was found between them
        return not barrier(landscape, one, other) and not barrier(landscape, other, one)
    return False


def _barriers(landscape: EnergyLandscape) -> str:
    """Return the barriers of the two-way transition whose lower barrier is the largest.

    Transitions between states that the protocol names precede all others. Without a known saddle between the states of
    a tree, it is the barrier of one hinge that folds alone.
    """
    names = [group[0] for group in _separate_states(landscape)]
    if landscape.net is None and landscape.fold_path is None and not landscape.passes:
        alone = landscape.easiest_barrier
        start = landscape.rests[0].name or AT_START
        return "" if alone is None else f"barrier {show_value(alone, 'J')} to fold one hinge from {start}"
    result = {}
    for one, other in combinations(names[:_MOST_NAMED], 2):
        with suppress(InputError):  # no saddle was found between them
            result[one, other] = barrier(landscape, one, other), barrier(landscape, other, one)
    named = {rest.name for rest in landscape.rests}
    result = {ends: heights for ends, heights in result.items() if named.issuperset(ends)} or result
    if not result:
        return "no barrier was found between them" if len(names) > 1 else ""
    one, other = max(result, key=lambda ends: min(result[ends]))
    present, back = (show_value(value, "J") for value in result[one, other])
    return f"barrier {present} from {one} to {other}, {back} back"


def _holds(landscape: EnergyLandscape) -> str:
    """Return the torque that presses each state onto a stop, or the smallest load that each state withstands."""
    bar = landscape.structure.appearance.bar
    texts = [
        f"{state.name} is held by {show_value(state.holding_torque, 'N m')} per {bar}"
        for state in fold_states(landscape)
        if state.holding_torque
    ]
    for state in net_states(landscape)[:_MOST_NAMED]:
        if state.withstands:
            weakest = min(state.withstands, key=lambda held: abs(held.value))
            value = shown_value(weakest.value, weakest.unit, 3)
            lost = f"holds beyond {value}" if weakest.kind == "none" else f"is lost at {value}"
            texts.append(f"{state.name} {lost} ({weakest.load})")
    if not texts and landscape.fold_path is None and landscape.net is None:
        held = [
            stop.holding_torque for hinge in landscape.hinges for stop in hinge.actual.states if stop.holding_torque
        ]
        if held:
            texts.append(f"a hinge is held by {show_value(min(held), 'N m')}")
    return listed(texts[:2])


def _partial_folds(landscape: EnergyLandscape) -> str:
    folds = landscape.partial_folds
    stable = sum(fold.stable for fold in folds)
    if len(folds) <= 2:
        return ""
    return f"{stable} of {len(folds)} combinations of folded hinges are stable"
