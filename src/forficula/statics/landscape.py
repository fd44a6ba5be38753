"""The energy landscape of a design: stable states, transitions between them, and the loads that each state withstands.

Two solvers compute it and check each other: `forficula.statics.tree_landscape` for bodies on joints, in reduced
coordinates, and `forficula.statics.net.net_landscape` for nets, in the coordinates of their nodes.
"""

from __future__ import annotations

import difflib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Annotated

import numpy as np

from forficula.arrays import Array
from forficula.design import Design
from forficula.errors import InputError
from forficula.quantities import Unit, show_value
from forficula.results import Result, pandas_module
from forficula.serial import Joules, Newtons, Written
from forficula.statics.friction import FrictionBand
from forficula.statics.net.driven.net_course import Course
from forficula.statics.net.net import Net, NetShape
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

AT_START = "at the start"  # name of a first state that the protocol does not name


@dataclass(frozen=True, kw_only=True)
class Rest:
    """Resting shape of a structure without drives, after a part of its protocol.

    Attributes:
        name: of the named state, such as "flat", or the protocol's name for having missed it.
        angles: of all hinges, in their own senses, rad, (hinge,).
        energy: J.
        stored: energy by the part that stores it: "tendons", "springs" of joints, "creases" between flaps, springs
            between points ("bars", or "openings" of creases between plates), "couplings", "closures", "membranes" with
            length limits, "weight"; parts that the structure does not have are left out.
        stable: whether it came to rest and no small push drives it away.
        within: whether it is within the bounds of the state.
        same_as: name of the first earlier state that rests at the same angles; empty if there is none.
        shape: of a net; None for a tree, whose angles define its shape.
        contacts: force between each part of a tree and a table, N, by the names of both; None without a table, and for
            a net.
    """

    name: str
    angles: Annotated[Array, Unit("rad")]
    energy: Joules
    stored: Mapping[str, Joules]
    stable: bool
    within: Annotated[bool, Written.NEVER]
    same_as: Annotated[str, Written.OR_NULL] = ""
    shape: Annotated[NetShape | None, Written.NEVER] = None
    contacts: Annotated[Mapping[str, Newtons] | None, Written.IF_KNOWN] = None

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
        shape: of a net at the saddle; None for a tree.
        angles: of all hinges of a tree at the saddle, in their own senses, rad, (hinge,); None for a net, and for a
            tree whose saddles are in its fold path.
    """

    ends: tuple[int, int]
    barriers: tuple[float, float]
    energy: float
    shape: NetShape | None = None
    angles: Array | None = None


@dataclass(frozen=True, kw_only=True)
class LeastTorque:
    """The least slowly growing torque or force of a transition of bodies on joints.

    Attributes:
        name: of the transition.
        drive: drive of the transition.
        least: size of the torque, N m, or of the force, N; None if not even the largest one tried makes the transition,
            if the structure does not rest in the state from which the transition starts, or if the drive has another
            unit.
        span: least and largest of these torques for structures whose hinges are shifted at random by about 0.3 deg at
            the start of the snap; the largest is inf if one of them does not make the transition; None if none does.
        inertial_help: a snap after which inertia may make the transition with less than the least torque, which is then
            an upper bound; None if the slow path has no such snap.
        unit: SI unit of the drive's strength, such as "N m".
        smallest: whether `least` is the smallest drive tried, and therefore an upper bound.
        withstood: least size of the slowly growing drive at which a structure that is at the goal before the transition
            leaves it, if its hinges are shifted as for `span`; None if no drive tried does, or if the structure is not
            at the goal.
    """

    name: str
    drive: Drive
    least: float | None
    span: tuple[float, float] | None
    inertial_help: InertialHelp | None
    unit: str = "N m"
    smallest: bool = False
    withstood: float | None = None

    def __repr__(self) -> str:
        """Name of the transition and torque or force."""
        least = "none was found" if self.least is None else show_value(self.least, self.unit)
        return f"<LeastTorque {self.name}: {least}>"


@dataclass(frozen=True, kw_only=True, eq=False)
class NetSurvey:
    """Net of a landscape, and the extent of the search for its states.

    Attributes:
        net: net of the shapes in states, passes and courses.
        built: mobility of the net as built; None for a net that is too large.
        search: seeded search for stable states; there may be more states than it found.
    """

    net: Net
    built: Mobility | None
    search: StableStates


@dataclass(frozen=True, kw_only=True)
class EnergyLandscape(Result):
    """Energy landscape of a design.

    Attributes:
        design: the design.
        structure: structure of the design.
        rests: where it rests when released from the start of the protocol, and after each transition.
        states: stable states: along the single folding path from its start to its end, or of a net by rising energy;
            for a tree without a single folding path, the different stable ones of the rests.
        passes: between neighbouring states; of a tree without a single folding path between states that its protocol
            reaches one after another, over the highest saddle on a path that may lead through further states; of a net
            with contact between both kinds of pairs.
        courses: effects of slowly growing drives: of the protocol's transitions, and for nets of all other drives.
        remarks: sentences on missing results and on limits of the others.
        hinges: every hinge that one tendon lies across, by tendon, with the hinge's spring.
        fold_path: the structure along its fold; None if rigid panels have no single folding path, and on a table.
        levels: energies with none to all of the independent hinges folded, J, (folding hinge + 1,), of ideal hinges if
            there are any; None if the energies of single hinges do not add up.
        partial_folds: resting shapes after release with some hinges folded.
        hinge_barriers: energy to climb until one hinge of the first state folds alone, J, (hinge,); nan if it never
            does, or if it is folded already.
        tips: resistance to a load at the tips; None without a single folding path.
        net: survey of sliding points, or of plates that are in loops or free; None for a tree of bodies on joints.
        friction_bands: angles at which dry friction holds single hinges in the stable states.
    """

    design: Design
    structure: Structure
    rests: tuple[Rest, ...]
    states: tuple[StableState | NetState | Rest, ...]
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
    friction_bands: tuple[FrictionBand, ...] = ()

    def __repr__(self) -> str:
        """Return the resting states with their energies."""
        rests = ", ".join(f"{rest.name} {show_value(rest.energy, 'J')}" for rest in self.rests)
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
        """Return the first ideal hinge, with both bars perpendicular to its axis; None without bars."""
        return next((hinge.ideal for hinge in self.hinges if hinge.ideal is not None), None)

    @property
    def tendons(self) -> tuple[HingeLandscape, ...]:
        """Return every hinge that one tendon lies across, about its true axis, by tendon."""
        return tuple(hinge.actual for hinge in self.hinges)

    @property
    def least_torques(self) -> Mapping[str, float | None]:
        """Return the least slowly growing torque of each transition of a tree, N m; see `LeastTorque`.

        Transitions of forces are left out.
        """
        courses = (course for course in self.courses if isinstance(course, LeastTorque))
        return {course.name: course.least for course in courses if course.unit != "N"}

    @property
    def least_forces(self) -> Mapping[str, float | None]:
        """Return the least slowly growing force of each transition of a tree that a force makes, N."""
        courses = (course for course in self.courses if isinstance(course, LeastTorque))
        return {course.name: course.least for course in courses if course.unit == "N"}

    @property
    def easiest_barrier(self) -> float | None:
        """Return the least energy to climb until one hinge of the first state folds alone, J.

        It is None if no hinge folds alone, or if the structure does not rest in the first state.
        """
        known = self.hinge_barriers[np.isfinite(self.hinge_barriers)]
        return float(known.min()) if len(known) and self.rests[0].within else None

    @property
    def fold_barrier(self) -> float | None:
        """Return the energy to climb along the fold from its first state, J; None if one of its ends is not stable."""
        return _fold_barrier(self, back=False)

    @property
    def unfold_barrier(self) -> float | None:
        """Return the energy to climb back along the fold, J; None if one of its ends is not stable."""
        return _fold_barrier(self, back=True)


def stable_states(landscape: EnergyLandscape) -> tuple[StableState | NetState | Rest, ...]:
    """Return the stable states of a structure; see `EnergyLandscape.states`."""
    return landscape.states


def stable_rests(rests: Sequence[Rest]) -> tuple[Rest, ...]:
    """Return the different stable ones of the resting shapes of a tree; the first may lack a name and gets one."""
    stable = (rest for rest in rests if rest.stable and not rest.same_as)
    return tuple(rest if rest.name else replace(rest, name=AT_START) for rest in stable)


def fold_states(landscape: EnergyLandscape) -> tuple[StableState, ...]:
    """Return the stable states along a fold; empty without a single folding path."""
    return tuple(state for state in landscape.states if isinstance(state, StableState))


def net_states(landscape: EnergyLandscape) -> tuple[NetState, ...]:
    """Return the stable states of a net; empty for a tree."""
    return tuple(state for state in landscape.states if isinstance(state, NetState))


def net_courses(landscape: EnergyLandscape) -> tuple[Course, ...]:
    """Return the courses of a net under slowly growing drives; empty for a tree."""
    return tuple(course for course in landscape.courses if isinstance(course, Course))


def barrier(landscape: EnergyLandscape, start: str, end: str) -> float:
    """Compute the energy to climb from one stable state to another over the known saddles, J.

    Along a fold all hinges move together. The barrier may be lower if one hinge moves before the others: see
    `EnergyLandscape.hinge_barriers`.

    Args:
        landscape: of a design.
        start: name of a stable state, such as "flat".
        end: name of another, such as "folded".

    Returns:
        Energy from the start to the highest saddle on the path whose highest saddle is lowest; 0 if the path leads only
        downhill.

    Raises:
        InputError: there is no stable state of that name, or no known saddles connect both states.
    """
    states = landscape.states
    numbers = {state.name: number for number, state in enumerate(states)}
    first, last = (_numbered(landscape, numbers, name) for name in (start, end))
    top = _lowest_top(landscape, first, last)
    if top is None:
        alone = landscape.easiest_barrier
        known = "" if alone is None else f"; one hinge folds alone from the first state over {show_value(alone, 'J')}"
        raise InputError(f'{landscape.design.name}: no saddle was found that leads from "{start}" to "{end}"{known}')
    return top - states[first].energy


def _numbered(landscape: EnergyLandscape, numbers: Mapping[str, int], name: str) -> int:
    if name in numbers:
        return numbers[name]
    path, whole = landscape.fold_path, landscape.structure.appearance.whole
    near = difflib.get_close_matches(name, numbers, 1)
    meant = f', did you mean "{near[0]}"?' if near else ""
    why = "" if near or path is None else "".join(f"; {remark}" for remark in path.remarks)
    known = ", ".join(numbers)
    raise InputError(f'{landscape.design.name}: need a stable state of the {whole} ({known}), got "{name}"{meant}{why}')


def _lowest_top(landscape: EnergyLandscape, first: int, last: int) -> float | None:
    """Return the highest energy on the path between two states for which it is lowest; None without a path."""
    tops = {first: landscape.states[first].energy}
    # every round completes at least one state, as in the shortest paths of Bellman and Ford
    for _ in landscape.states:
        for saddle in landscape.passes:
            for start, end in (saddle.ends, saddle.ends[::-1]):
                if start in tops:
                    tops[end] = min(max(tops[start], saddle.energy), tops.get(end, np.inf))
    return tops.get(last)


def fold_path_of(landscape: EnergyLandscape) -> FoldPath:
    """Return the path of a structure along its fold.

    Raises:
        InputError: the structure has no single folding path, or lies on a table.
    """
    rigid_fold(landscape.structure)
    if landscape.fold_path is None:
        raise InputError(f"{landscape.design.name}: the energy along its rigid fold is not computed on a table")
    return landscape.fold_path


def _fold_barrier(landscape: EnergyLandscape, *, back: bool) -> float | None:
    fold = landscape.structure.rigid_fold
    if fold is None or landscape.fold_path is None:
        return None
    ends = (fold.end, fold.start) if back else (fold.start, fold.end)
    names = {state.name for state in landscape.states}
    return barrier(landscape, *ends) if set(ends) <= names else None
