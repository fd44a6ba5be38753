"""Energy landscape of bodies on joints in a tree, computed in the coordinates of their hinges."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.design import Design
from forficula.statics.friction import friction_bands, friction_remarks
from forficula.statics.landscape import EnergyLandscape, LeastTorque, Pass, Rest, stable_rests
from forficula.statics.tree.ensemble import Ensemble, ensemble, slight_energy
from forficula.statics.tree.equilibrium import Equilibria
from forficula.statics.tree.fold_path import FoldPath, fold_path, fold_states
from forficula.statics.tree.hinge_landscape import CrossedHinge, crossed_hinges
from forficula.statics.tree.inertial_help import InertialHelp, inertial_help
from forficula.statics.tree.partial_folds import (
    fold_levels,
    partial_folds,
    single_hinge_barriers,
    soft_stiffness,
)
from forficula.statics.tree.planes import table_forces
from forficula.statics.tree.potential import hinge_angles, potential, stored_energy
from forficula.statics.tree.quasi_static import (
    SlowTransition,
    at_goal,
    drive_kinds,
    is_led,
    largest_torque,
    least_slow_torque,
    start_state,
    state_after,
    state_beyond,
    withstood_torques,
)
from forficula.statics.tree.saddle import level_between, saddle_between
from forficula.statics.tree.tip_stiffness import tip_stiffness
from forficula.statics.tree_remarks import (
    coupling_remarks,
    ignored_contact_remarks,
    is_smallest,
    shared_remarks,
    slow_remarks,
    stage_remarks,
    start_remarks,
    table_remarks,
    tendon_remarks,
    withstood_remark,
    yield_remarks,
)
from forficula.structure import Structure, Transition, drive_of, drive_unit, first_state, goal_of, state_of

# shifts of hinges at the start of a snap, rad: one case without, and three cases with about 0.3 deg
_KICKS = (0.0, *[math.radians(0.3)] * 3)
_FINE = 721  # number of angles in the search for the highest energy between two states of one hinge
# largest drives tried on a structure at its goal, as multiples of the largest one for a transition; their steps differ
_HARDEST = (10.0, 100.0)
_SAME = math.radians(0.05)  # resting angles within this difference are equal in tables


def tree_landscape(design: Design, structure: Structure, points: int) -> EnergyLandscape:
    """Compute the landscape of bodies on joints; see `forficula.statics.survey.energy_landscape`."""
    structures = ensemble([structure])
    hinges = crossed_hinges(structure, points)
    # shapes of the rigid fold and of partial folds may be below a table
    on_table = structure.table is not None
    path = None if structure.rigid_fold is None or on_table else fold_path(structures, points)
    start = start_state(structures)
    rests, courses, slow_paths, torque_remarks = _protocol(structures, start, hinges)
    stable = stable_rests(rests)
    bands = friction_bands(structures, [(rest.name, rest.angles[: structures.size]) for rest in stable])
    passes, missing = _state_passes(structures, rests, slow_paths) if path is None else (_passes(path), ())
    return EnergyLandscape(
        design=design,
        structure=structure,
        rests=rests,
        states=stable if path is None else fold_states(structure, path),
        passes=passes,
        courses=courses,
        remarks=(
            *structure.remarks,
            *tendon_remarks(structure, hinges),
            *shared_remarks(structure),
            *friction_remarks(structure, bands),
            *ignored_contact_remarks(structure),
            *table_remarks(structure),
            *(() if path is None else path.remarks),
            *start_remarks(structure, start.position[0]),
            *torque_remarks,
            *stage_remarks(design, structure),
            *missing,
            *coupling_remarks(structures, hinges, rests),
        ),
        hinges=hinges,
        fold_path=path,
        levels=None if on_table else fold_levels(structure),
        partial_folds=() if on_table else partial_folds(structures, start.position),
        hinge_barriers=np.zeros(0) if on_table else single_hinge_barriers(structures, start.position),
        friction_bands=bands,
        tips=None if path is None else tip_stiffness(structures, start.position),
    )


def _protocol(
    structures: Ensemble, start: Equilibria, hinges: Sequence[CrossedHinge]
) -> tuple[tuple[Rest, ...], tuple[LeastTorque, ...], tuple[Array, ...], tuple[str, ...]]:
    """Compute where a structure rests after each transition, the least torques of transitions, and remarks on them.

    The shapes through which each transition leads, (step, joint), come before the remarks; none for an unknown path.

    Args:
        structures: only the first case is used.
        start: first resting shape.
        hinges: every hinge that one tendon lies across.
    """
    structure = structures.structure
    rests = [_rest(structures, first_state(structure, [state.name for state in structure.states]), start)]
    courses, paths, remarks = list[LeastTorque](), list[Array](), list[str]()
    before, held = start, True
    for transition in structure.transitions:
        drive, largest = drive_of(structure, transition.drive), largest_torque(structures, transition, hinges)
        kinds = drive_kinds(structure, drive)
        followed = kinds <= {"torque", "force", "rest-angle"}
        if not followed and structures.coupled:
            remarks.append(
                f'the effects of "{transition.name}" and of later transitions are not computed: the statics of bodies'
                f" on joints in a tree cannot follow the {' and '.join(sorted(kinds))} of its drive, a run can"
            )
            break
        slow, span, withstood, after = None, None, np.zeros(0), before
        # joints that springs couple cannot all be at their stops: such a structure rests where the drive leads it
        led = held and is_led(structures, drive)
        if not led:
            after = state_beyond(structures, transition)
            rests.append(_rest(structures, transition.state, after, rests))
        # no transition starts from a state in which the structure does not rest
        if held and followed:
            several = structures.repeated(len(_KICKS))
            begins = np.tile(before.position, (len(_KICKS), 1))
            shifted = least_slow_torque(several, begins, transition, largest, recorded=True, kicks=_KICKS)
            slow = replace(shifted, torque=shifted.torque[:1], position=shifted.position[:1])
            if np.isfinite(shifted.torque).any():
                torques = np.where(np.isnan(shifted.torque), np.inf, shifted.torque)
                span = float(torques.min()), float(torques.max())
            after = state_after(structures, transition, slow.torque, slow.position)
            paths.append(slow.paths[0].position)
            sign = -1.0 if drive.strength < 0 else 1.0
            remarks += yield_remarks(structures, transition.name, slow.paths[0], sign * np.array(drive.shares))
            if led:
                rests.append(_rest(structures, transition.state, after, rests))
        else:
            paths.append(np.zeros((0, structures.size)))
        # torques in N m and forces in N are reported, and nothing else
        measured = kinds in ({"torque"}, {"force"})
        if not measured:
            slow, span = None, None
        helped, unit = _inertial_help(structures, transition, slow), drive_unit(structure, drive)
        # a drive that acts on a structure at its goal tests whether the structure stays there
        if slow is not None and slow.torque[0] == 0:
            withstood = np.concatenate(
                [withstood_torques(several, begins, transition, times * largest, _KICKS) for times in _HARDEST]
            )
        courses.append(
            LeastTorque(
                name=transition.name,
                drive=drive,
                least=None if slow is None or math.isnan(slow.torque[0]) else float(slow.torque[0]),
                span=span,
                inertial_help=helped,
                unit=unit,
                smallest=is_smallest(slow, largest),
                withstood=float(withstood.min()) if np.isfinite(withstood).any() else None,
            )
        )
        if measured:
            remarks += slow_remarks(structure, transition, largest, slow, span, helped)
            if len(withstood):
                remarks.append(withstood_remark(structure, transition, withstood, _HARDEST[-1] * largest))
        else:
            remarks.append(
                f'the least slowly growing drive of "{transition.name}" is not computed, because it is no torque or'
                f" force alone but a {' and a '.join(sorted(kinds)).replace('-', ' ')}"
            )
        before, held = after, bool(at_goal(structures, after.position, goal_of(structure, transition.released))[0])
    return tuple(rests), tuple(courses), tuple(paths), tuple(remarks)


def _passes(path: FoldPath) -> tuple[Pass, ...]:
    """Return the passes between consecutive stable states along a fold, over the highest energy between them."""
    places = [place for place, state in enumerate(path.states) if state.stable]
    passes = []
    for number, (low, high) in enumerate(pairwise(places)):
        top = max(state.energy for state in path.states[low : high + 1])
        barriers = (top - path.states[low].energy, top - path.states[high].energy)
        passes.append(Pass(ends=(number, number + 1), barriers=barriers, energy=top))
    return tuple(passes)


def _state_passes(
    structures: Ensemble, rests: Sequence[Rest], paths: Sequence[Array]
) -> tuple[tuple[Pass, ...], tuple[str, ...]]:
    """Return the passes between states that follow one another in the protocol, and remarks on those not found.

    Args:
        structures: only the first case is used.
        rests: where the structure rests, at the start and after every transition.
        paths: shapes through which the transitions lead, rad, (step, joint) each.
    """
    states, whole = stable_rests(rests), structures.structure.appearance.whole
    if structures.size == 1:
        return _hinge_passes(structures, states), ()
    numbers = _state_numbers(rests)
    between: dict[tuple[int, int], list[Array]] = {}
    for first, second, path in zip(numbers, numbers[1:], paths, strict=False):
        if first is not None and second is not None and first != second:
            low, high = sorted((first, second))
            between.setdefault((low, high), []).append(path if first == low else path[::-1])
    passes, remarks = list[Pass](), list[str]()
    for (low, high), led in between.items():
        one, other = states[low], states[high]
        if level_between(structures, one.angles[: structures.size], other.angles[: structures.size]):
            passes.append(Pass(ends=(low, high), barriers=(0.0, 0.0), energy=one.energy, angles=one.angles))
            remarks.append(f'between the states "{one.name}" and "{other.name}", the {whole} moves without force')
            continue
        saddle = saddle_between(structures, one.angles[: structures.size], other.angles[: structures.size], led)
        if saddle is None:
            remarks.append(f'no saddle was found between the states "{one.name}" and "{other.name}"')
            continue
        energy = max(saddle.energy, one.energy, other.energy)
        passes.append(
            Pass(
                ends=(low, high),
                barriers=(energy - one.energy, energy - other.energy),
                energy=energy,
                angles=hinge_angles(structures, saddle.position[None])[0],
            )
        )
    return tuple(passes), tuple(remarks)


def _state_numbers(rests: Sequence[Rest]) -> list[int | None]:
    """Return the number of the stable state in which the structure rests each time; None if it is not stable."""
    numbers, count, named = list[int | None](), 0, dict[str, int | None]()
    for rest in rests:
        number = named.get(rest.same_as) if rest.same_as else count if rest.stable else None
        count += number == count
        named.setdefault(rest.name, number)
        numbers.append(number)
    return numbers


def _hinge_passes(structures: Ensemble, states: Sequence[Rest]) -> tuple[Pass, ...]:
    """Return the passes between stable states of a single hinge, over the highest energy between their angles.

    There are none with several hinges, because paths between their states are not computed.
    """
    if structures.size != 1:
        return ()

    def energy(angles: Array) -> Array:
        return potential(structures.repeated(len(angles)), angles[:, None])[0]

    passes = []
    order = sorted(range(len(states)), key=lambda number: float(states[number].angles[0]))
    for ends in map(sorted, pairwise(order)):
        first, last = (states[end] for end in ends)
        angles = np.linspace(first.angles[0], last.angles[0], _FINE)
        highest = int(energy(angles).argmax())
        around = sorted((angles[max(highest - 1, 0)], angles[min(highest + 1, _FINE - 1)]))
        refined = scipy.optimize.minimize_scalar(
            lambda angle: -energy(np.array([angle]))[0], bounds=around, method="bounded", options={"xatol": 1e-10}
        )
        top = max(-float(refined.fun), first.energy, last.energy)
        barriers = (top - first.energy, top - last.energy)
        passes.append(Pass(ends=(ends[0], ends[1]), barriers=barriers, energy=top))
    return tuple(passes)


def _rest(structures: Ensemble, name: str, equilibria: Equilibria, earlier: Sequence[Rest] = ()) -> Rest:
    state = state_of(structures.structure, name)
    goal = None if state is None else goal_of(structures.structure, state.goal)
    within = goal is None or bool(at_goal(structures, equilibria.position[:1], goal)[0])
    slight = slight_energy(structures)

    def known(energy: Array) -> float:
        return float(energy[0]) if abs(energy[0]) > slight else 0.0

    angles = hinge_angles(structures, equilibria.position[:1])[0]
    return Rest(
        name=name if within or state is None else state.missed,
        angles=angles,
        energy=known(equilibria.energy),
        stored={part: known(energy) for part, energy in stored_energy(structures, equilibria.position[:1]).items()},
        stable=bool(equilibria.rests[0] and equilibria.stiffness[0] > -soft_stiffness(structures)),
        within=within,
        same_as=next((rest.name for rest in earlier if np.all(np.abs(rest.angles - angles) <= _SAME)), ""),
        contacts=None
        if structures.structure.table is None
        else table_forces(structures.planes, equilibria.position[:1])[0],
    )


def _inertial_help(structures: Ensemble, transition: Transition, slow: SlowTransition | None) -> InertialHelp | None:
    if slow is None or not slow.torque[0] > 0:
        return None
    return inertial_help(structures, slow.paths[0], drive_of(structures.structure, transition.drive))
