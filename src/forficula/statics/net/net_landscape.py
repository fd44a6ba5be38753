"""Energy landscape of a net: its stable states, the saddles between them, and the effects of its drives."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components, minimum_spanning_tree

from forficula.design import Design
from forficula.errors import InputError
from forficula.statics.friction import friction_remarks
from forficula.statics.landscape import EnergyLandscape, NetSurvey, Pass, Rest
from forficula.statics.net.contact.contact_of import contact_remarks
from forficula.statics.net.driven.driven_net import short_of
from forficula.statics.net.driven.net_course import Course, drive_course, released
from forficula.statics.net.minimum import NetRest as NetRest
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_of import net_of, own_angles, panels, start_shape
from forficula.statics.net.net_state import NetState, mobility, net_state, rounded_energy, stored_parts
from forficula.statics.net.panel_crossing import panels_cross
from forficula.statics.net.rigid_forces import loop_remarks, lost_reason
from forficula.statics.net.saddle import Saddle, find_saddle
from forficula.statics.net.stable_states import StableStates, by_energy, find_stable_states, same_shape
from forficula.statics.planes import table_friction_remarks
from forficula.structure import Structure, drive_of, first_state, goal_of, state_of

Progress = Callable[[str], None]

_TRIES = 16  # pushes of a search for stable states
_SHOWN = 4  # number of listed states that no protocol names
_PATHS, _INCREMENTS = 4, 100  # paths tried for a saddle, and increments of each
_SAME = 1e-3  # rad; resting angles within this difference are equal in tables
_NO_DISTANCE = 1e-12  # between states that a saddle joins; a spanning tree takes 0 for no edge


def net_landscape(design: Design, structure: Structure, progress: Progress = lambda _: None) -> EnergyLandscape:
    """Compute the landscape of sliding points, or of plates that are in loops or free.

    Args:
        design: of the structure.
        structure: a net.
        progress: called with the name of each step of the computation.

    Raises:
        InputError: the structure is not a net.
    """
    net = net_of(structure)
    progress("resting shape and effects of the drives")
    built = start_shape(structure, net)
    first, left = released(net, built)
    courses, refused = _all_courses(structure, net, first)
    rests = _rests(structure, net, first, courses)
    progress("stable states")
    search = find_stable_states(net, [rest.shape for _, rest, _ in rests], tries=_TRIES)
    states = _states(structure, net, search, rests, progress)
    progress("saddles between states")
    search, states, passes = _joined(structure, net, search, states, _protocol_pairs(net, states, rests))
    return EnergyLandscape(
        design=design,
        structure=structure,
        rests=_landscape_rests(structure, net, rests),
        states=tuple(states),
        passes=passes,
        courses=courses,
        remarks=(
            *left,
            *refused,
            *_remarks(structure, net, search, states, passes, courses),
            *contact_remarks(structure),
        ),
        net=NetSurvey(net=net, built=mobility(structure, net, built), search=search),
    )


def slow_courses(structure: Structure) -> tuple[Course, ...]:
    """Compute the courses of a net's transitions under slowly growing drives, without its other states.

    Raises:
        InputError: the structure is not a net.
    """
    net = net_of(structure)
    first, _ = released(net, start_shape(structure, net))
    return tuple(_transition_courses(structure, net, first, through_snaps=False)[0])


def _all_courses(structure: Structure, net: Net, first: NetRest) -> tuple[tuple[Course, ...], tuple[str, ...]]:
    """Return the courses of transitions, one after another, then of all other drives, and why some are missing."""
    courses, refused = _transition_courses(structure, net, first)
    driven = {drive_of(structure, transition.drive).name for transition in structure.transitions}
    done = driven | {part for name in driven for part in name.split(" and ")}
    for drive in structure.drives:
        if drive.name in done or not first.stable or not any(drive.strengths):
            continue
        try:
            courses.append(drive_course(structure, net, first, drive, None))
        except InputError as error:
            refused.append(f'the effect of "{drive.name}" cannot be computed: {error}')
    return tuple(courses), tuple(refused)


def _transition_courses(
    structure: Structure, net: Net, first: NetRest, *, through_snaps: bool = True
) -> tuple[list[Course], list[str]]:
    """Return the courses of transitions, each from the end of the one before, and why some are missing."""
    courses, refused, start = list[Course](), list[str](), first
    for transition in structure.transitions:
        drive = drive_of(structure, transition.drive)
        if refused or not start.stable or not any(drive.strengths):
            continue
        try:
            courses.append(drive_course(structure, net, start, drive, transition, through_snaps=through_snaps))
        except InputError as error:
            # the start of the next transition is unknown
            refused.append(f'the effects of "{drive.name}" and of later transitions cannot be computed: {error}')
            continue
        start = courses[-1].rest
    return courses, refused


def _rests(
    structure: Structure, net: Net, first: NetRest, courses: Sequence[Course]
) -> tuple[tuple[str, NetRest, bool], ...]:
    """Return where the net rests, by the names of the protocol, and whether it is within the named state."""
    places = [(first_state(structure, [state.name for state in structure.states]), first)]
    by_name = {course.name: course for course in courses}
    places += [
        (transition.state, by_name[transition.name].rest)
        for transition in structure.transitions
        if transition.name in by_name
    ]
    result = []
    for name, rest in places:
        state = state_of(structure, name)
        within = state is None or short_of(structure, net, goal_of(structure, state.goal), rest.shape) <= 0
        result.append((name if within or state is None else state.missed, rest, within))
    return tuple(result)


def _landscape_rests(
    structure: Structure, net: Net, named_rests: Sequence[tuple[str, NetRest, bool]]
) -> tuple[Rest, ...]:
    """Return the rests of the protocol with their stored energies, and which of them are equal."""
    rests = list[Rest]()
    for name, rest, within in named_rests:
        angles = own_angles(structure, rest.shape)
        rests.append(
            Rest(
                name=name,
                angles=angles,
                energy=rounded_energy(net, rest.energy),
                stored=stored_parts(structure, net, rest.shape),
                stable=rest.stable,
                within=within,
                same_as=next((rest.name for rest in rests if np.all(np.abs(rest.angles - angles) <= _SAME)), ""),
                shape=rest.shape,
            )
        )
    return tuple(rests)


def _states(
    structure: Structure,
    net: Net,
    search: StableStates,
    rests: Sequence[tuple[str, NetRest, bool]],
    progress: Progress,
) -> list[NetState]:
    """Return the listed states: those of the protocol, and the lowest others in which no panels cross."""
    triangles, states, others = panels(structure), list[NetState](), 0
    for rest, result in zip(search.states, search.counts, strict=True):
        name = _name(net, rest, rests)
        others += not name
        if name or (others <= _SHOWN and not panels_cross(net, rest.shape, triangles)):
            label = name or f"state {len(states) + 1}"
            progress(f"loads that it withstands: {name}" if name else label)
            states.append(net_state(structure, net, rest, label, result, loads=bool(name)))
    return states


def _name(net: Net, state: NetRest, rests: Sequence[tuple[str, NetRest, bool]]) -> str:
    """Return the protocol's name of a state; empty if it has none."""
    for name, rest, within in rests:
        if name and within and rest.stable and same_shape(net, rest.shape, state.shape):
            return name
    return ""


def _protocol_pairs(
    net: Net, states: Sequence[NetState], rests: Sequence[tuple[str, NetRest, bool]]
) -> list[tuple[int, int]]:
    """Return the pairs of states that a protocol reaches one after another with contact, by number.

    Plates on joints in a tree are a net only with contact. Without it, passes join these pairs.
    """
    if net.contact is None:
        return []
    numbers = [_state_number(net, states, rest) for _, rest, _ in rests]
    pairs = [
        (min(one, other), max(one, other))
        for one, other in pairwise(numbers)
        if one is not None and other is not None and one != other
    ]
    return list(dict.fromkeys(pairs))


def _joined(
    structure: Structure,
    net: Net,
    search: StableStates,
    listed: Sequence[NetState],
    further: Sequence[tuple[int, int]] = (),
) -> tuple[StableStates, list[NetState], tuple[Pass, ...]]:
    """Find saddles between neighbouring states: pairs that form the minimum spanning tree, and further ones.

    A saddle that joins two other states than the requested ones is kept for those. A state beyond a saddle that the
    search has missed, such as the mirror image of a listed one, is listed as well, and its neighbours are tried.

    Returns:
        The search and the listed states, with these states, by rising energy; and the passes.
    """
    states, passes, tried = list(listed), dict[tuple[int, int], Pass](), set[tuple[int, int]]()
    saddles = list[Saddle]()
    while pairs := list(dict.fromkeys([*_neighbours(states, passes.keys(), tried), *(set(further) - tried)])):
        count = len(states)
        for start, end in pairs:
            tried.add((start, end))
            ends = states[start].rest, states[end].rest
            saddle = find_saddle(net, *ends, increments=_INCREMENTS, tries=_PATHS, known=saddles)
            if saddle is None:
                continue
            for rest in saddle.ends:
                if _is_missing(structure, net, search, states, rest):
                    states.append(net_state(structure, net, rest, f"state {len(states) + 1}", 0, loads=False))
            one, other = (_state_number(net, states, rest) for rest in saddle.ends)
            if one is not None and other is not None and one != other:
                barriers = saddle.barriers if one < other else saddle.barriers[::-1]
                pair = min(one, other), max(one, other)
                passes[pair] = Pass(ends=pair, barriers=barriers, energy=saddle.rest.energy, shape=saddle.rest.shape)
        if len(states) == count:
            break
    order = by_energy([state.energy for state in states])
    added = states[len(listed) :]
    rests = [*zip(search.states, search.counts, strict=True), *((state.rest, 0) for state in added)]
    rests = [rests[number] for number in by_energy([rest.energy for rest, _ in rests])]
    search = replace(search, states=tuple(rest for rest, _ in rests), counts=tuple(hits for _, hits in rests))
    return search, [states[number] for number in order], _renumbered(passes.values(), order)


def _neighbours(
    states: Sequence[NetState], joined: Collection[tuple[int, int]], tried: Collection[tuple[int, int]]
) -> list[tuple[int, int]]:
    """Return the pairs of a minimum spanning tree that are neither joined nor tried; joined states have no distance."""
    if len(states) < 2:
        return []
    apart = np.array([[_shape_difference(one.rest.shape, other.rest.shape) for other in states] for one in states])
    for pair in joined:
        apart[pair] = _NO_DISTANCE
    for pair in set(tried) - set(joined):
        apart[pair] = 0.0  # no edge
    tree = minimum_spanning_tree(np.triu(apart, 1)).tocoo()
    return sorted(set(zip(tree.row.tolist(), tree.col.tolist(), strict=True)) - set(joined))


def _is_missing(
    structure: Structure, net: Net, search: StableStates, states: Sequence[NetState], rest: NetRest
) -> bool:
    """Return whether a rest is a stable state that the search has missed and that may be listed."""
    if not rest.stable or _state_number(net, states, rest) is not None:
        return False
    if any(same_shape(net, known.shape, rest.shape) for known in search.states):
        return False  # found, but not listed
    others = sum(not state.withstands for state in states)
    return others < _SHOWN and not panels_cross(net, rest.shape, panels(structure))


def _renumbered(passes: Iterable[Pass], order: Sequence[int]) -> tuple[Pass, ...]:
    """Return passes with the places of their states in an order, by these places."""
    result = []
    for course_pass in passes:
        one, other = (order.index(end) for end in course_pass.ends)
        barriers = course_pass.barriers if one < other else course_pass.barriers[::-1]
        result.append(replace(course_pass, ends=(min(one, other), max(one, other)), barriers=barriers))
    return tuple(sorted(result, key=lambda course_pass: course_pass.ends))


def _state_number(net: Net, states: Sequence[NetState], rest: NetRest) -> int | None:
    """Return the number of the state that an equilibrium belongs to; None if it is not listed."""
    same = (number for number, state in enumerate(states) if same_shape(net, state.rest.shape, rest.shape))
    return next(same, None)


def _shape_difference(one: NetShape, other: NetShape) -> float:
    """Return the difference of two shapes by all distances of nodes, which rigid-body motions do not change."""
    first, second = (np.linalg.norm(state.positions[:, None] - state.positions[None], axis=2) for state in (one, other))
    return float(np.linalg.norm(first - second)) + 1e-9 * float(np.linalg.norm(one.angles - other.angles))


def _unconnected_states(count: int, passes: Sequence[Pass]) -> list[int]:
    """Return the states that no chain of passes joins to the first."""
    if not count:
        return []
    rows, columns = [saddle.ends[0] for saddle in passes], [saddle.ends[1] for saddle in passes]
    graph = coo_array((np.ones(len(passes)), (rows, columns)), shape=(count, count))
    _, part = connected_components(graph, directed=False)
    return np.flatnonzero(part != part[0]).tolist()


def _remarks(
    structure: Structure,
    net: Net,
    search: StableStates,
    states: Sequence[NetState],
    passes: Sequence[Pass],
    courses: Sequence[Course],
) -> list[str]:
    """Return remarks on the extent of the results and on missing ones."""
    whole, count = structure.appearance.whole, len(search.states)
    remarks = [
        *friction_remarks(structure),
        *table_friction_remarks(structure),
        f"the search for stable states of the {whole} started from the states of the protocol and from {search.tries}"
        f" random pushes (seed {search.seed}): there may be more than the {count} found",
    ]
    if len(states) < count:
        remarks.append(
            f"{len(states)} of the {count} states found are listed: those that the protocol names, and up to {_SHOWN}"
            " others of lowest energy in which no panels pass through one another"
        )
    remarks += [
        f'in "{state.name}" panels pass through one another, because contact is off: contact (protocol.contact = true),'
        ' a locking law (crease.law = "locking") or stops (crease.fold_limit) prevent it'
        for state in states
        if state.passing
    ]
    if search.failed:
        remarks.append(f"{search.failed} of the tries ended in no stable state")
    if not count:
        remarks.append("a part can move without any force: a crease has no spring, or a support is missing")
    unconnected = _unconnected_states(len(states), passes)
    remarks += [
        f'no saddles were found that connect "{states[number].name}" to the first state' for number in unconnected
    ]
    for course in courses:
        if any(snap.kind != "limit" for snap in course.slow.snaps):
            remarks.append(
                f'under "{course.name}" the path branches, and imperfections decide which branch a structure takes;'
                " the branch of lower energy is shown"
            )
        if course.slow.ended == "lost":
            remarks.append(
                f'the path under "{course.name}" was followed only as far as shown, not to its end{lost_reason(net)}'
            )
        resting = [point.shape for point in course.slow.points] + [snap.after.shape for snap in course.slow.snaps]
        remarks += loop_remarks(net, f'on the path under "{course.name}"', [*resting, course.rest.shape])
    remarks += loop_remarks(net, "in states without load", [state.rest.shape for state in states])
    return remarks
