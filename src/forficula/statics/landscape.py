"""The energy landscape of a design: states, transitions between them, and what each state withstands.

Two solvers find it, which check each other: `forficula.statics.tree_landscape` for bodies on joints, in reduced
coordinates, and `forficula.statics.net.net_landscape` for nets, in the coordinates of their nodes.
"""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Annotated

import numpy as np

from forficula.arrays import Array
from forficula.design import Design
from forficula.errors import InputError
from forficula.quantities import Unit, show_value
from forficula.results import Result, pandas_module
from forficula.serial import Joules, Written
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_course import Course
from forficula.statics.net.net_state import Mobility, NetState
from forficula.statics.net.stable_states import StableStates
from forficula.statics.tree.fold_path import FoldPath, StableState, rigid_fold
from forficula.statics.tree.hinge_landscape import CrossedHinge, HingeLandscape
from forficula.statics.tree.inertial_help import InertialHelp
from forficula.statics.tree.partial_folds import PartialFold
from forficula.statics.tree.tip_stiffness import TipStiffness
from forficula.structure import Drive, Structure

if TYPE_CHECKING:
    from forficula.results import DataFrame


@dataclass(frozen=True, kw_only=True)
class Rest:
    """Where a structure rests without drives, after a part of its protocol.

    Attributes:
        name: of the state that a protocol names, such as "flat"; where it is none, what the protocol calls that.
        angles: of all hinges, in their own senses, rad, (hinge,).
        energy: J.
        stored: the same by what stores it: "tendons", "springs", "couplings", "membranes" with length limits, "weight";
            what the structure does not have is left out.
        stable: whether it came to rest and no small push drives it on.
        within: whether it is within the bounds of the state.
        same_as: name of the first state before it that rests at the same angles; empty where none does.
        shape: of a net; None of a tree, whose angles say all.
    """

    name: str
    angles: Annotated[Array, Unit("rad")]
    energy: Joules
    stored: Mapping[str, Joules]
    stable: bool
    within: Annotated[bool, Written.NEVER]
    same_as: Annotated[str, Written.OR_NULL] = ""
    shape: Annotated[NetShape | None, Written.NEVER] = None

    def __repr__(self) -> str:
        """Name and energy."""
        return f"<Rest {self.name}: {show_value(self.energy, 'J')}, {'stable' if self.stable else 'not stable'}>"


@dataclass(frozen=True, kw_only=True, eq=False)
class Pass:
    """The transition between two neighbouring stable states over a saddle.

    Attributes:
        ends: numbers of the states.
        barriers: energies to climb from either end, J.
        energy: of the saddle, J.
        shape: of a net at the saddle; None of a tree, whose saddles are in its fold path.
    """

    ends: tuple[int, int]
    barriers: tuple[float, float]
    energy: float
    shape: NetShape | None = None


@dataclass(frozen=True, kw_only=True)
class LeastTorque:
    """The least slowly growing torque of a transition of bodies on joints.

    Attributes:
        name: of the transition.
        drive: that makes it.
        least: size of the torque, N m; None where not even the largest that was tried makes the transition, or where
            the structure does not rest in the state from which the transition starts.
        span: the least and the largest of these torques for a structure whose hinges are shifted at random by about
            0.3 deg where it begins to snap; the largest is inf where one is not made at all. None where none is made.
        inertial_help: a snap after which inertia may make the transition with less than the least torque, which is then
            an upper bound; None where the slow path has no such snap.
    """

    name: str
    drive: Drive
    least: float | None
    span: tuple[float, float] | None
    inertial_help: InertialHelp | None

    def __repr__(self) -> str:
        """Name of the transition and torque."""
        least = "none was found" if self.least is None else show_value(self.least, "N m")
        return f"<LeastTorque {self.name}: {least}>"


@dataclass(frozen=True, kw_only=True, eq=False)
class NetSurvey:
    """Net of a landscape, and the extent of the search for its states.

    Attributes:
        net: whose shapes are in states, passes and courses.
        built: how the net can move as built; None for a net too large.
        search: for stable states. The search is seeded: there may be more states.
    """

    net: Net
    built: Mobility | None
    search: StableStates


@dataclass(frozen=True, kw_only=True)
class EnergyLandscape(Result):
    """Energy landscape of a design.

    Attributes:
        design: the design.
        structure: what is built of it.
        rests: where it rests when let go from where the protocol starts it, and after each transition.
        states: stable states, along the one way to fold from its start to its end, or of a net by rising energy; empty
            for a tree that has no one way to fold.
        passes: between neighbouring states.
        courses: what slowly growing drives do: those of the protocol's transitions, and for nets all others, too.
        remarks: sentences on what does not exist, and what to know of the rest.
        hinges: every hinge that one tendon lies across, by tendon; with the hinge's spring.
        fold_path: the structure along its fold; None where rigid panels have no one way to fold.
        levels: energies of independent hinges, ideal ones where there are such, none to all of them folded, J,
            (folding hinge + 1,); None where those of single hinges do not add up.
        partial_folds: let go with some hinges folded.
        hinge_barriers: energy to climb until one hinge of the first state folds alone, J, (hinge,); nan where it never
            does, or is folded.
        tips: resistance to a load at the tips; None where there is no one way to fold.
        net: of points that slide, and of plates in loops or free; None for a tree of bodies on joints.
    """

    design: Design
    structure: Structure
    rests: tuple[Rest, ...]
    states: tuple[StableState | NetState, ...]
    passes: tuple[Pass, ...]
    courses: tuple[LeastTorque | Course, ...]
    remarks: tuple[str, ...]
    hinges: tuple[CrossedHinge, ...] = ()
    fold_path: FoldPath | None = None
    levels: Array | None = None
    partial_folds: tuple[PartialFold, ...] = ()
    hinge_barriers: Array = field(default_factory=lambda: np.zeros(0))
    tips: TipStiffness | None = None
    net: NetSurvey | None = None

    def __repr__(self) -> str:
        """Where it rests, with energies."""
        rests = ", ".join(f"{each.name} {show_value(each.energy, 'J')}" for each in self.rests)
        return f"<EnergyLandscape of {self.design.name}: {rests or f'{len(self.remarks)} remarks'}>"

    def barrier(self, start: str, end: str) -> float:
        """Return the energy to climb from one stable state to another, J; see the function `barrier`.

        Args:
            start: name of a stable state, such as "flat".
            end: name of another, such as "folded".

        Raises:
            InputError: no stable state of that name, or no known saddle leads from one to the other.
        """
        return barrier(self, start, end)

    def to_dataframe(self) -> DataFrame:
        """Return the stable states as a pandas table: name and energy, J."""
        pandas = pandas_module()

        rows = [(state.name, state.energy) for state in self.states]
        return pandas.DataFrame(rows, columns=["state", "energy_J"]).set_index("state")

    @property
    def hinge(self) -> HingeLandscape | None:
        """The first ideal hinge, with both bars square to its axis; None where there are no bars to be so."""
        return next((each.ideal for each in self.hinges if each.ideal is not None), None)

    @property
    def tendons(self) -> tuple[HingeLandscape, ...]:
        """Every hinge that one tendon lies across, about its true axis, by tendon."""
        return tuple(each.own for each in self.hinges)

    @property
    def least_torques(self) -> Mapping[str, float | None]:
        """Sizes of the least slowly growing torques of a tree's transitions, N m, by transition; see `LeastTorque`."""
        return {each.name: each.least for each in self.courses if isinstance(each, LeastTorque)}

    @property
    def easiest_barrier(self) -> float | None:
        """Energy to climb until one hinge of the first state folds alone, J.

        None where none does, or where it does not rest there.
        """
        known = self.hinge_barriers[np.isfinite(self.hinge_barriers)]
        return float(known.min()) if len(known) and self.rests[0].within else None

    @property
    def fold_barrier(self) -> float | None:
        """Energy to climb along the fold from its first state, J; None where one of its ends is no stable state."""
        return _fold_barrier(self, back=False)

    @property
    def unfold_barrier(self) -> float | None:
        """Energy to climb back along the fold, J; None where one of its ends is no stable state."""
        return _fold_barrier(self, back=True)


def stable_states(landscape: EnergyLandscape) -> tuple[StableState | NetState, ...]:
    """The stable states of a structure: along its fold, from camber to folded, or of a net by rising energy.

    Raises:
        InputError: it is a tree that has no one way to fold.
    """
    if landscape.net is None:
        rigid_fold(landscape.structure)
    return landscape.states


def fold_states(landscape: EnergyLandscape) -> tuple[StableState, ...]:
    """The stable states along a fold; none where there is no one way to fold."""
    return tuple(state for state in landscape.states if isinstance(state, StableState))


def net_states(landscape: EnergyLandscape) -> tuple[NetState, ...]:
    """The stable states of a net; none of a tree."""
    return tuple(state for state in landscape.states if isinstance(state, NetState))


def net_courses(landscape: EnergyLandscape) -> tuple[Course, ...]:
    """What slowly growing drives do to a net; none of a tree."""
    return tuple(course for course in landscape.courses if isinstance(course, Course))


def barrier(landscape: EnergyLandscape, start: str, end: str) -> float:
    """Energy to climb from one stable state to another, over the saddles that are known, J.

    Along a fold all hinges move together. A structure may climb less where one hinge goes before the others: see
    `EnergyLandscape.hinge_barriers`.

    Args:
        landscape: of a design.
        start: name of a stable state, such as "flat".
        end: name of another, such as "folded".

    Returns:
        Up to the highest saddle between them, on the way whose highest saddle is lowest; 0 where it is downhill all
        along.

    Raises:
        InputError: there is no stable state of that name, or no known saddles lead from one to the other.
    """
    states = stable_states(landscape)
    numbers = {state.name: number for number, state in enumerate(states)}
    first, last = (_number_of(landscape, numbers, name) for name in (start, end))
    top = _lowest_top(landscape, first, last)
    if top is None:
        raise InputError(f'{landscape.design.name}: no saddle was found that leads from "{start}" to "{end}"')
    return top - states[first].energy


def _number_of(landscape: EnergyLandscape, numbers: Mapping[str, int], name: str) -> int:
    if name in numbers:
        return numbers[name]
    path, whole = landscape.fold_path, landscape.structure.appearance.whole
    near = difflib.get_close_matches(name, numbers, 1)
    meant = f', did you mean "{near[0]}"?' if near else ""
    why = "" if near or path is None else "".join(f"; {remark}" for remark in path.remarks)
    known = ", ".join(numbers)
    raise InputError(f'{landscape.design.name}: need a stable state of the {whole} ({known}), got "{name}"{meant}{why}')


def _lowest_top(landscape: EnergyLandscape, first: int, last: int) -> float | None:
    """The highest energy on the way from one state to another whose highest energy is lowest; None without a way."""
    tops = {first: landscape.states[first].energy}
    # every round settles at least one state, as with the shortest ways of Bellman and Ford
    for _ in landscape.states:
        for each in landscape.passes:
            for here, there in (each.ends, each.ends[::-1]):
                if here in tops:
                    tops[there] = min(max(tops[here], each.energy), tops.get(there, np.inf))
    return tops.get(last)


def fold_path_of(landscape: EnergyLandscape) -> FoldPath:
    """The path of a structure along its fold.

    Raises:
        InputError: it has no one way to fold.
    """
    rigid_fold(landscape.structure)
    assert landscape.fold_path is not None
    return landscape.fold_path


def _fold_barrier(landscape: EnergyLandscape, *, back: bool) -> float | None:
    fold = landscape.structure.rigid_fold
    if fold is None:
        return None
    ends = (fold.end, fold.start) if back else (fold.start, fold.end)
    names = {state.name for state in landscape.states}
    return barrier(landscape, *ends) if set(ends) <= names else None
