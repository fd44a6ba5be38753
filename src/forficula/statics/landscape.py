"""Energy landscapes of a design: its tendons' hinges, where it rests, and what leads from state to state."""

from __future__ import annotations

import difflib
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Literal

import numpy as np

from forficula.arrays import Array
from forficula.design import TORQUE, Design
from forficula.displayed import Displayed
from forficula.errors import InputError
from forficula.quantities import show_quantity, show_value
from forficula.statics.equilibrium import Equilibria, PathState, barrier_between
from forficula.statics.fold_path import FoldPath, fold_path, rigid_fold
from forficula.statics.hinge import TendonHinge, tendon_hinge
from forficula.statics.hinge_landscape import HingeLandscape, HingeSpring, hinge_landscape
from forficula.statics.inertial_help import InertialHelp, inertial_help
from forficula.statics.net_landscape import NetLandscape
from forficula.statics.partial_folds import (
    PartialFold,
    fold_levels,
    partial_folds,
    single_hinge_barriers,
    soft_stiffness,
)
from forficula.statics.potential import Ensemble, ensemble, slight_energy, stored_energy
from forficula.statics.quasi_static import (
    SlowTransition,
    at_goal,
    crosses,
    least_slow_torque,
    start_state,
    state_after,
    state_beyond,
)
from forficula.statics.slow_remarks import slow_remarks
from forficula.statics.sprung_hinge import sprung_landscape
from forficula.statics.tip_stiffness import TipStiffness, tip_stiffness
from forficula.structure import Structure, Transition, drive_of, first_state, goal_of, state_of

# torques tried on hinges that tendons cross, by the largest moment of a tendon against it
_MOST_OPENING = 4.0
# by which hinges are shifted where a structure begins to snap, rad: not at all, and three times by about 0.3 deg
_KICKS = (0.0, *[math.radians(0.3)] * 3)
_STRAIGHT = math.radians(1)  # what counts as straight
_SAME = math.radians(0.05)  # hinges that rest no farther apart do so at one place, to what tables show


@dataclass(frozen=True, kw_only=True)
class Rest:
    """Where a structure rests without torques.

    Attributes:
        name: of the state that a protocol names, such as "flat"; where it is none, what the protocol calls that.
        angles: of all hinges, in their own senses, rad, (hinge,).
        energy: J.
        stored: the same by what stores it: "tendons", "springs", "couplings", "membranes" with length limits, "weight";
            what the structure does not have is left out.
        stable: whether it came to rest and no small push drives it on.
        within: whether it is within the bounds of the state.
        same_as: name of the first state before it that rests at the same angles; empty where none does.
    """

    name: str
    angles: Array
    energy: float
    stored: Mapping[str, float]
    stable: bool
    within: bool
    same_as: str = ""


@dataclass(frozen=True, kw_only=True)
class EnergyLandscape(Displayed):
    """What statics says of a design.

    Attributes:
        design: the design.
        structure: what is built of it.
        hinge: one ideal hinge, with both bars square to its axis; None where there are no bars to be so.
        tendons: every hinge that one tendon lies across, about its true axis, by tendon; with the hinge's spring.
        ideal_hinges: the same with both bars square to the axis; None for those that have no bars to be so.
        fold_path: the structure along its fold; None where rigid panels have no one way to fold.
        levels: energies of independent hinges, ideal ones where there are such, none to all of them folded, J,
            (folding hinge + 1,); None where those of single hinges do not add up.
        partial_folds: let go with some hinges folded.
        hinge_barriers: energy to climb until one hinge of the first state folds alone, J, (hinge,); nan where it never
            does, or is folded.
        rests: where it rests when let go from where the protocol starts it, and from where each transition leads.
        least_torques: by transition, the size of the least slowly growing torque that makes it, N m; None where not
            even the largest that was tried does, or where it does not rest in the state that it would start from. Those
            of a net are in its courses.
        least_torque_ranges: by transition, the least and the largest of these torques for a structure whose hinges are
            shifted at random by about 0.3 deg where it begins to snap; the largest is inf where one is not made at all.
        inertial_help: by transition, a snap after which inertia may make it with less than that torque, which is then
            an upper bound; None where the slow path has no such snap.
        tips: resistance to a load at the tips; None where there is no one way to fold.
        remarks: sentences on what does not exist, and what to know of the rest.
        net: stable states, saddles and paths of points that slide, and of plates in loops or free; None for a tree of
            bodies on joints.
    """

    design: Design
    structure: Structure
    hinge: HingeLandscape | None
    tendons: tuple[HingeLandscape, ...]
    ideal_hinges: tuple[HingeLandscape | None, ...]
    fold_path: FoldPath | None
    levels: Array | None
    partial_folds: tuple[PartialFold, ...]
    hinge_barriers: Array
    rests: tuple[Rest, ...]
    least_torques: Mapping[str, float | None]
    least_torque_ranges: Mapping[str, tuple[float, float]]
    inertial_help: Mapping[str, InertialHelp | None]
    tips: TipStiffness | None
    remarks: tuple[str, ...]
    net: NetLandscape | None = None

    def __repr__(self) -> str:
        """Where it rests, with energies."""
        rests = ", ".join(f"{each.name} {show_value(each.energy, 'J')}" for each in self.rests)
        return f"<EnergyLandscape of {self.design.name}: {rests or f'{len(self.remarks)} remarks'}>"

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
        return _barrier_or_none(self, back=False)

    @property
    def unfold_barrier(self) -> float | None:
        """Energy to climb back along the fold, J; None where one of its ends is no stable state."""
        return _barrier_or_none(self, back=True)


@dataclass(frozen=True, kw_only=True)
class StableState:
    """A stable state of a structure along its fold.

    Attributes:
        name: the start of the fold, such as "flat", the first, where it is flat or cambered; its end, such as
            "folded", the last; "partly folded" between them; "anywhere" where nothing moves it all along.
        kind: "stop", pressed onto the end of the path; "minimum"; "neutral", a range without any force.
        pleat_angle: rad; of a neutral range the end nearer to flat.
        far_pleat_angle: the other end of a neutral range, rad; otherwise the pleat angle.
        ring_angle: fold angle of the ring creases there, rad.
        energy: J.
        holding_torque: on every hinge that turns, that presses it onto the end of the path, N m.
    """

    name: str
    kind: Literal["stop", "minimum", "maximum", "neutral"]
    pleat_angle: float
    far_pleat_angle: float
    ring_angle: float
    energy: float
    holding_torque: float


def tree_landscape(design: Design, structure: Structure, points: int) -> EnergyLandscape:
    """Survey the statics of bodies on joints; see `forficula.statics.survey.energy_landscape`."""
    structures = ensemble([structure])
    tendons, ideal_hinges = tendon_landscapes(structure, points)
    hinge = next((each for each in ideal_hinges if each is not None), None)
    path = None if structure.rigid_fold is None else fold_path(structures, points)
    start = start_state(structures)
    first = first_state(structure, [state.name for state in structure.states])
    rests, most = [_rest(structures, first, start)], {}
    slow: dict[str, SlowTransition | None] = {}
    helps: dict[str, InertialHelp | None] = {}
    ranges: dict[str, tuple[float, float]] = {}
    peak = max((each.peak_opening.torque for each in tendons if each.peak_opening is not None), default=0.0)
    before, held = start, True
    for transition in structure.transitions:
        most[transition.name] = _largest_torque(structures, transition, peak)
        found, start_of_next = None, state_beyond(structures, transition)
        rests.append(_rest(structures, transition.state, start_of_next, rests))
        # from where it does not rest nothing leads on
        if held:
            largest = most[transition.name]
            several = structures.repeated(len(_KICKS))
            begins = np.tile(before.position, (len(_KICKS), 1))
            shifted = least_slow_torque(several, begins, transition, largest, recorded=True, kicks=_KICKS)
            found = replace(shifted, torque=shifted.torque[:1], position=shifted.position[:1])
            if np.isfinite(shifted.torque).any():
                torques = np.where(np.isnan(shifted.torque), np.inf, shifted.torque)
                ranges[transition.name] = float(torques.min()), float(torques.max())
            start_of_next = state_after(structures, transition, found.torque, found.position)
        slow[transition.name] = found
        helps[transition.name] = _help(structures, transition, found)
        before = start_of_next
        held = bool(at_goal(structures, before.position, goal_of(structure, transition.released))[0])
    return EnergyLandscape(
        design=design,
        structure=structure,
        hinge=hinge,
        tendons=tendons,
        ideal_hinges=ideal_hinges,
        fold_path=path,
        levels=fold_levels(structure),
        partial_folds=partial_folds(structures, start.position),
        hinge_barriers=single_hinge_barriers(structures, start.position),
        rests=tuple(rests),
        least_torques={name: None if each is None else _known(each.torque[0]) for name, each in slow.items()},
        least_torque_ranges=ranges,
        inertial_help=helps,
        tips=None if path is None else tip_stiffness(structures, start.position),
        remarks=(
            *structure.remarks,
            *_tendon_remarks(structure, ideal_hinges, tendons),
            *_shared_remarks(structure),
            *_friction_remarks(structure),
            *(() if path is None else path.remarks),
            *_start_remarks(structure, start.position[0]),
            *(
                remark
                for transition in structure.transitions
                for remark in slow_remarks(
                    structure,
                    transition,
                    most[transition.name],
                    slow[transition.name],
                    ranges.get(transition.name),
                    helps[transition.name],
                )
            ),
        ),
    )


def stable_states(landscape: EnergyLandscape) -> tuple[StableState, ...]:
    """The stable states of a structure along its fold, from camber to folded.

    Raises:
        InputError: it has no one way to fold.
    """
    path = fold_path_of(landscape)
    return tuple(
        StableState(
            name=_name(state, landscape),
            kind=state.kind,
            pleat_angle=state.coordinate,
            far_pleat_angle=state.far_coordinate,
            ring_angle=float(np.interp(state.coordinate, path.pleat_angle, path.ring_angle)),
            energy=state.energy,
            holding_torque=state.press * 2 / path.turns,
        )
        for state in path.states
        if state.stable
    )


def barrier(landscape: EnergyLandscape, start: str, end: str) -> float:
    """Energy to climb along the fold from one stable state to another, J, all hinges together.

    A structure may climb less where one hinge goes before the others: see `EnergyLandscape.hinge_barriers`.

    Args:
        landscape: of a design.
        start: name of a stable state, such as "flat".
        end: name of another, such as "folded".

    Returns:
        Up to the highest state between them; 0 where it is downhill all along.

    Raises:
        InputError: there is no stable state of that name.
    """
    path, by_name = fold_path_of(landscape), {state.name: state for state in stable_states(landscape)}
    whole = landscape.structure.appearance.whole
    ends: list[PathState] = []
    for name in (start, end):
        if name not in by_name:
            near = difflib.get_close_matches(name, by_name, 1)
            meant = f', did you mean "{near[0]}"?' if near else ""
            why = "" if near else "".join(f"; {remark}" for remark in path.remarks)
            known = ", ".join(by_name)
            raise InputError(
                f'{landscape.design.name}: need a stable state of the {whole} ({known}), got "{name}"{meant}{why}'
            )
        place = by_name[name].pleat_angle
        ends.append(next(state for state in path.states if state.stable and state.coordinate == place))
    return barrier_between(path.states, *ends)


def fold_path_of(landscape: EnergyLandscape) -> FoldPath:
    """The path of a structure along its fold.

    Raises:
        InputError: it has no one way to fold.
    """
    rigid_fold(landscape.structure)
    assert landscape.fold_path is not None
    return landscape.fold_path


def _barrier_or_none(landscape: EnergyLandscape, *, back: bool) -> float | None:
    fold = landscape.structure.rigid_fold
    if fold is None:
        return None
    ends = (fold.end, fold.start) if back else (fold.start, fold.end)
    names = {state.name for state in stable_states(landscape)}
    return barrier(landscape, *ends) if set(ends) <= names else None


def _name(state: PathState, landscape: EnergyLandscape) -> str:
    path, fold = fold_path_of(landscape), rigid_fold(landscape.structure)
    ring = float(np.interp(state.far_coordinate, path.pleat_angle, path.ring_angle))
    folded = state_of(landscape.structure, fold.end)
    most = None if folded is None else goal_of(landscape.structure, folded.goal).most[list(fold.folds)]
    enough = most is not None and bool(np.all(-ring <= most))
    closed = enough or state.far_coordinate >= math.pi
    if state.coordinate <= 0:
        return "anywhere" if closed else fold.start
    return fold.end if closed else f"partly {fold.end}"


def _rest(structures: Ensemble, name: str, found: Equilibria, earlier: Sequence[Rest] = ()) -> Rest:
    state, position = state_of(structures.structure, name), found.position[0]
    goal = None if state is None else goal_of(structures.structure, state.goal)
    within = goal is None or bool(at_goal(structures, found.position[:1], goal)[0])
    slight = slight_energy(structures)

    def known(energy: Array) -> float:
        return float(energy[0]) if abs(energy[0]) > slight else 0.0

    return Rest(
        name=name if within or state is None else state.missed,
        angles=position,
        energy=known(found.energy),
        stored={part: known(energy) for part, energy in stored_energy(structures, found.position[:1]).items()},
        stable=bool(found.rests[0] and found.stiffness[0] > -soft_stiffness(structures)),
        within=within,
        same_as=next((each.name for each in earlier if np.all(np.abs(each.angles - position) <= _SAME)), ""),
    )


def _largest_torque(structures: Ensemble, transition: Transition, peak: float) -> float:
    """The largest torque tried for a transition, N m: the drive's; of one on hinges that tendons cross, more."""
    drive = drive_of(structures.structure, transition.drive)
    own = abs(drive.strength)
    return max(_MOST_OPENING * peak, own) if crosses(structures, drive) else own


def _help(structures: Ensemble, transition: Transition, found: SlowTransition | None) -> InertialHelp | None:
    if found is None or not found.torque[0] > 0:
        return None
    return inertial_help(structures, found.paths[0], drive_of(structures.structure, transition.drive))


def _known(value: float) -> float | None:
    return None if math.isnan(value) else float(value)


def tendon_landscapes(
    structure: Structure, points: int
) -> tuple[tuple[HingeLandscape, ...], tuple[HingeLandscape | None, ...]]:
    """Every hinge that one tendon lies across, and its ideal one, by tendon; those that are alike are surveyed once."""

    @cache
    def survey(hinge: TendonHinge, spring: HingeSpring | None) -> HingeLandscape:
        if spring is not None:
            return sprung_landscape(hinge, spring, points)
        return hinge_landscape(hinge, points, overbend=structure.appearance.overbend)

    own: list[HingeLandscape] = []
    ideal: list[HingeLandscape | None] = []
    for tendon in structure.tendons:
        if tendon.crossing is None:
            continue
        crossed, hinge = structure.hinges[tendon.crossing.hinge], tendon_hinge(structure, tendon, tendon.crossing)
        spring = HingeSpring(stiffness=crossed.stiffness, rest_angle=hinge.sense * crossed.rest_angle)
        sprung = spring if spring.stiffness else None
        own.append(survey(hinge, sprung))
        square = None if tendon.ideal is None else tendon_hinge(structure, tendon, tendon.ideal)
        ideal.append(None if square is None else survey(square, sprung))
    return tuple(own), tuple(ideal)


def _tendon_remarks(
    structure: Structure, ideal: Sequence[HingeLandscape | None], tendons: Sequence[HingeLandscape]
) -> tuple[str, ...]:
    """What is said of the tendons' hinges: of the ideal ones, and of the true ones where those are slack otherwise.

    What holds for some tendons only is said with their names.
    """
    labels = [tendon.label or tendon.name for tendon in structure.tendons if tendon.crossing is not None]
    of: dict[str, list[str]] = {}
    for label, square, hinge in zip(labels, ideal, tendons, strict=True):
        remarks = hinge.remarks if square is None else square.remarks
        # where both are slack, the angles differ a little
        if square is not None and square.hinge.pulls != hinge.hinge.pulls:
            whose = structure.appearance.whole
            remarks = (*remarks, *(f"about the {whose}'s own hinge axes {remark}" for remark in hinge.remarks))
        for remark in remarks:
            of.setdefault(remark, []).append(label)
    return tuple(
        remark if len(names) == len(labels) else f"{', '.join(names)}: {remark}" for remark, names in of.items()
    )


def _shared_remarks(structure: Structure) -> tuple[str, ...]:
    """What the landscapes of single hinges leave out where more than one tendon acts on some of them."""
    of: dict[int, list[str]] = {}
    for tendon in structure.tendons:
        if tendon.crossing is not None:
            of.setdefault(tendon.crossing.hinge, []).append(tendon.label or tendon.name)
    remarks = [
        f"{', '.join(names)} lie across one hinge, {structure.hinges[hinge].label or structure.hinges[hinge].name}: its"
        f" landscapes have one of them each, all else is of all"
        for hinge, names in of.items()
        if len(names) > 1
    ]
    across = [tendon.label or tendon.name for tendon in structure.tendons if tendon.crossing is None]
    if across and of:
        remarks.append(f"the landscapes of single hinges leave out what lies across several: {', '.join(across)}")
    return tuple(remarks)


def _friction_remarks(structure: Structure) -> tuple[str, ...]:
    largest = max((hinge.friction for hinge in structure.hinges), default=0.0)
    if not largest:
        return ()
    return (
        f"the landscape leaves out the dry friction of up to {show_quantity(largest, TORQUE)} of hinges: it holds"
        " states more firmly, and torques that move them are larger",
    )


def _start_remarks(structure: Structure, angles: Array) -> tuple[str, ...]:
    if structure.rigid_fold is None:
        return ()
    least = float(angles[list(structure.rigid_fold.folds)].min())
    if least >= -_STRAIGHT:
        return ()
    return (
        f"let go flat, the compliant {structure.appearance.whole} does not stay so: a hinge goes to"
        f" {math.degrees(least):.4g} deg;"
        " its flat state, and what is said of it, is that",
    )
