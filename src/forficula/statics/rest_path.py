"""Equilibria of any structure under a load that grows evenly, and the work of its motors."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Generic, Literal, NamedTuple, Protocol, TypeVar

import numpy as np

from forficula.arrays import Array, Flags
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.crease_turn import TurnLosses
from forficula.structure import GrowingLoad, RestPath, RestShape

State = TypeVar("State")
# energies that creases dissipate, J, by the names of `RestPath.creases`
CreaseLosses = Mapping[str, float]

_STEP = 0.04  # first and longest step of the share
_SHORTEST = 1e-9  # step of the share at which a lost equilibrium or a goal is located
_ACCURACY = 1e-9  # of the work in a step, relative to the largest setting times the largest change of its conjugate
_DEPTH = 12  # halvings of a step for the integral of the work
_FOLLOWED = 1e-5  # rad, largest difference of an angle between one step and two steps of half the size
_BRIEFEST = 1e-4  # shortest step of the share that is halved for this reason


class Creep(NamedTuple, Generic[State]):
    """Slow motion to an equilibrium: its end, and the energy that dampers dissipate, J."""

    end: State
    lost: float


class LoadedSystem(Protocol[State]):
    """A structure under a load, as a static solver represents it."""

    def rest(self, share: float, near: State) -> State | None:
        """Return the stable equilibrium at a share of the load near a state; None if there is none."""
        ...

    def creep(self, share: float, start: State) -> Creep[State] | None:
        """Return the motion without inertia from a state to an equilibrium at a share of the load, however far away.

        None if a hinge would move faster than `GrowingLoad.rest_speed`, or if there is no equilibrium.
        """
        ...

    def middle(self, one: State, other: State) -> State:
        """Return the mean of two states, from which their common neighbour is searched."""
        ...

    def conjugates(self, share: float, state: State, /) -> Array:
        """Return the conjugate of every motor's setting, (motor,).

        For a torque or a force, it is the turn or the displacement along the motor. For a change of rest angles or a
        displacement, it is the moment or the force of the motor.
        """
        ...

    def crease_losses(self, before: State, after: State, /) -> CreaseLosses:
        """Return the energies that creases dissipate between two states."""
        ...

    @property
    def relaxes(self) -> bool:
        """Return whether the moment of any hinge depends on time, by Maxwell branches."""
        ...

    @property
    def prescribes(self) -> Flags:
        """Return whether each motor sets a displacement or a rest angle instead of a torque or a force, (motor,)."""
        ...

    def short_of_goal(self, state: State) -> float:
        """Return by how much a state is outside the bounds of the goal; <= 0 within them; inf without bounds."""
        ...

    def shape(self, state: State) -> RestShape:
        """Return the shape of a state."""
        ...


def rest_path(system: LoadedSystem[State], start: State, load: GrowingLoad) -> RestPath:
    """Follow the stable equilibria of a structure under a load that grows evenly, to its goal or its full size.

    The share of the load grows in steps. A step is halved if there is no stable equilibrium near the one before. If
    there is none after a step of 1e-9 either, the equilibrium is lost.

    Maxwell branches follow every hinge at a constant rate in a step. A step of a structure with such branches is halved
    if a hinge turns by a noticeably different angle in two steps of half the size.

    Args:
        system: the structure under the load.
        start: state at which the structure counts as at rest.
        load: the load.
    """
    first, lost, motors = system.rest(load.begin, start), 0.0, len(load.before)
    crept = np.zeros(motors)
    if first is None:
        creep = system.creep(load.begin, start)
        if creep is None:
            none = np.zeros((0, motors))
            return RestPath(share=np.zeros(0), shapes=(), work=none, lost=0.0, creases={}, forces=none, ended="away")
        first, lost = creep
        moved = system.conjugates(load.begin, first) - system.conjugates(load.begin, start)
        crept = np.where(system.prescribes, 0.0, load.settings(load.begin) * moved)
    shares, states = [load.begin], [first]
    ended: Literal["goal", "full", "lost"] = "goal" if system.short_of_goal(first) <= 0 else "full"
    step, steady = _STEP, True
    while ended != "goal" and shares[-1] < 1:
        share = min(shares[-1] + step, 1.0)
        state = system.rest(share, states[-1])
        between = (shares[-1] + share) / 2
        middle = system.rest(between, states[-1]) if system.relaxes and state is not None else None
        if state is not None and middle is not None:
            after = system.rest(share, middle)
            followed = after is not None and _turned(system, state, after) <= _FOLLOWED
            if not followed and step > _BRIEFEST:
                step, steady = step / 2, False
                continue
            state = after
        reached = state is not None and system.short_of_goal(state) <= 0
        if step > _SHORTEST and (state is None or reached):
            step, steady = step / 2, False
            continue
        if state is None:
            ended = "lost"
            break
        if middle is not None:
            shares.append(between)
            states.append(middle)
        shares.append(share)
        states.append(state)
        ended = "goal" if reached else ended
        step, steady = min(2 * step, _STEP) if steady else step, True
    losses = [system.crease_losses(*pair) for pair in pairwise([start, *states])]
    conjugates = np.array([system.conjugates(share, state) for share, state in zip(shares, states, strict=True)])
    return RestPath(
        share=np.array(shares),
        shapes=tuple(system.shape(state) for state in states),
        work=crept + _works(system, load, shares, states, conjugates),
        lost=lost,
        creases={name: np.cumsum([loss[name] for loss in losses]) for name in losses[0]},
        forces=np.where(system.prescribes, conjugates, 0.0),
        ended=ended,
    )


def crease_losses(laws: Sequence[CreaseLaw], losses: TurnLosses) -> CreaseLosses:
    """Return the energies that creases with some laws dissipate in a turn, without those that none can dissipate."""
    present = (
        ("yield", losses.yielding, any(law.yields for law in laws)),
        ("branch", losses.branches, any(law.relaxes for law in laws)),
        ("damage", losses.damage, any(law.wears for law in laws)),
    )
    return {name: float(np.sum(lost)) for name, lost, dissipates in present if dissipates}


def _works(
    system: LoadedSystem[State], load: GrowingLoad, shares: list[float], states: list[State], conjugates: Array
) -> Array:
    """Return the work of every motor since the first row, J, (row, motor).

    The work of a setting s with the conjugate c is the integral of s over c for a torque or a force, and that of c over
    s for a prescribed displacement or rest angle. Because s is linear in the share, both follow from the integral of c
    over the share (for a torque by parts).
    """
    rate = load.after - load.before
    largest = np.abs([load.settings(share) for share in (shares[0], shares[-1])]).max(axis=0)
    allowed = _ACCURACY * float((largest * np.ptp(conjugates, axis=0)).max(initial=0.0))

    def middle(one: _Node[State], other: _Node[State]) -> _Node[State] | None:
        share = (one.share + other.share) / 2
        state = system.rest(share, system.middle(one.state, other.state))
        return None if state is None else _Node(share, state, system.conjugates(share, state))

    def small(error: Array) -> bool:
        return float(np.abs(rate * error).max(initial=0.0)) <= allowed

    # the steps of structures with branches are short enough
    depth = -1 if system.relaxes else _DEPTH
    nodes = [_Node(*node) for node in zip(shares, states, conjugates, strict=True)]
    works = [np.zeros(len(rate))]
    for one, other in pairwise(nodes):
        area = _integral(one, middle(one, other), other, middle, small, depth)
        by_parts = load.settings(other.share) * other.value - load.settings(one.share) * one.value
        works.append(works[-1] + np.where(system.prescribes, rate * area, by_parts - rate * area))
    return np.array(works)


def _turned(system: LoadedSystem[State], one: State, other: State) -> float:
    """Return the largest difference of the angle of a hinge between two states, rad."""
    return float(np.abs(system.shape(one).angles - system.shape(other).angles).max(initial=0.0))


class _Node(NamedTuple, Generic[State]):
    """A share of the load, the state at it, and the values that are integrated over the share."""

    share: float
    state: State
    value: Array


def _integral(
    one: _Node[State],
    middle: _Node[State] | None,
    other: _Node[State],
    between: Callable[[_Node[State], _Node[State]], _Node[State] | None],
    small: Callable[[Array], bool],
    depth: int,
) -> Array:
    """Integrate values between two nodes by Simpson's rule with halved steps (Lyness 1969) and extrapolation.

    Args:
        one: first node.
        middle: node between both; None if there is none.
        other: last node.
        between: returns the node between two others; None if there is none.
        small: returns whether an error of the integral is small enough.
        depth: number of further halvings; < 0 for Simpson's rule alone.
    """
    if middle is None:
        return (other.share - one.share) / 2 * (one.value + other.value)
    whole = _simpson(one, middle, other)
    if depth < 0:
        return whole
    left, right = between(one, middle), between(middle, other)
    if left is None or right is None:
        return whole
    halves = _simpson(one, left, middle) + _simpson(middle, right, other)
    if depth == 0 or small((halves - whole) / 15):
        return np.asarray(halves + (halves - whole) / 15)
    first = _integral(one, left, middle, between, small, depth - 1)
    return np.asarray(first + _integral(middle, right, other, between, small, depth - 1))


def _simpson(one: _Node[State], middle: _Node[State], other: _Node[State]) -> Array:
    return np.asarray((other.share - one.share) / 6 * (one.value + 4 * middle.value + other.value))
