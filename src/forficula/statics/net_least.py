"""The least drives that make the transitions of a net when they grow slowly, and where it rests after each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.statics.net.minimum import Rest
from forficula.statics.net.net import Net
from forficula.statics.net.net_of import net_of, start_shape
from forficula.statics.net_course import drive_course, short_of
from forficula.statics.net_landscape import settled
from forficula.statics.net_state import readings
from forficula.structure import Structure, drive_of, first_state, state_of

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, eq=False)
class SlowState:
    """Where a net rests without drives, let go as built or after a slowly grown drive.

    Attributes:
        name: of the state that the protocol has there; "" where it names none.
        held: whether it rests within that state's bounds.
        energy: stored, J.
        readings: of the measures, by name, rad or m, each (coordinate,).
    """

    name: str
    held: bool
    energy: float
    readings: Mapping[str, Array]


@dataclass(frozen=True, kw_only=True, eq=False)
class SlowTransition:
    """A transition under a drive that grows slowly.

    Attributes:
        name: of the transition.
        least: size of the drive at which its goal is first reached, in its SI unit; None where it never is.
        state: where it rests when let go there; None where the goal is never reached.
    """

    name: str
    least: float | None
    state: SlowState | None


def slow_transitions(structure: Structure) -> tuple[SlowState | None, tuple[SlowTransition, ...]]:
    """Make the transitions of a protocol one after another by slowly growing drives, each from where the last one led.

    The same as the courses of a landscape (`net_landscape`), without what is drawn of them: some tenths of a second for
    each transition of a small sheet. It ends at the first that is not made.

    Args:
        structure: of sliding points, or of plates in loops or free.

    Returns:
        Where it first rests, None where it does not come to rest; and what became of the transitions, of those that
        follow one that was not made, neither least drive nor state.

    Raises:
        InputError: it is no net, or a drive would carry it away.
    """
    net = net_of(structure)
    here, _ = settled(net, start_shape(structure, net))
    names = [state.name for state in structure.states]
    made = [_nothing(transition.name) for transition in structure.transitions]
    if not here.stable:
        return None, tuple(made)
    first = _slow_state(structure, net, here, first_state(structure, names))
    for number, transition in enumerate(structure.transitions):
        drive = drive_of(structure, transition.drive)
        if not any(drive.strengths):
            break
        course = drive_course(structure, net, here, drive, transition, through=False)
        if course.least is None or not course.rest.stable:
            break
        here = course.rest
        state = _slow_state(structure, net, here, transition.state)
        made[number] = SlowTransition(name=transition.name, least=course.least, state=state)
    return first, tuple(made)


def _nothing(name: str) -> SlowTransition:
    return SlowTransition(name=name, least=None, state=None)


def _slow_state(structure: Structure, net: Net, rest: Rest, name: str) -> SlowState:
    state = state_of(structure, name)
    return SlowState(
        name=name,
        held=state is None or short_of(structure, net, state.bounds, rest.shape) <= 0,
        energy=rest.energy,
        readings={each.name: readings(structure, net, each, rest.shape) for each in structure.measures},
    )
