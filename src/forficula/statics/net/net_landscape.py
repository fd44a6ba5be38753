"""The landscape of a net: its stable states, the saddles between them, and what its drives do."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components, minimum_spanning_tree

from forficula.design import Design
from forficula.errors import InputError
from forficula.statics.landscape import EnergyLandscape, NetSurvey, Pass, Rest
from forficula.statics.net.energy import expand, shape_at
from forficula.statics.net.factor import softest
from forficula.statics.net.minimum import NetRest as NetRest
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_course import Course, drive_course, short_of
from forficula.statics.net.net_of import net_of, own_angles, panels, start_shape
from forficula.statics.net.net_state import NetState, known, mobility, net_state, stored_parts
from forficula.statics.net.passing import panels_pass
from forficula.statics.net.saddle import find_saddle
from forficula.statics.net.stable_states import StableStates, find_stable_states, same_shape
from forficula.statics.net.supports import supported
from forficula.structure import Structure, drive_of, first_state, goal_of, state_of

Progress = Callable[[str], None]

_TRIES = 16  # pushes of a search for stable states
_SHOWN = 4  # states that no protocol names, of which more is worked out
_PATHS, _INCREMENTS = 4, 100  # tried for a saddle, and increments of each
_OFF = 1e-3  # of the net's size: a push off a ridge
_RIDGES = 8
_SAME = 1e-3  # rad; hinges that rest no farther apart do so at one place, to what tables show


def net_landscape(design: Design, structure: Structure, progress: Progress = lambda _: None) -> EnergyLandscape:
    """Survey the statics of sliding points, or of plates in loops or free.

    Args:
        design: of the structure.
        structure: of these.
        progress: is told what is worked out.

    Raises:
        InputError: it is no net.
    """
    net = net_of(structure)
    progress("where it rests, and what its drives do")
    built = start_shape(structure, net)
    first, left = _settled(net, built)
    courses, refused = _courses(structure, net, first)
    rests = _rests(structure, net, first, courses)
    progress("stable states")
    search = find_stable_states(net, [rest.shape for _, rest, _ in rests], tries=_TRIES)
    states = _states(structure, net, search, rests, progress)
    progress("saddles between states")
    passes = _passes(net, states)
    return EnergyLandscape(
        design=design,
        structure=structure,
        rests=_told_rests(structure, net, rests),
        states=tuple(states),
        passes=passes,
        courses=courses,
        remarks=(*left, *refused, *_remarks(structure, search, states, passes, courses)),
        net=NetSurvey(net=net, built=mobility(structure, net, built), search=search),
    )


def slow_courses(structure: Structure) -> tuple[Course, ...]:
    """What the transitions of a net do as their drives grow slowly, one after another; without its other states.

    Raises:
        InputError: it is no net.
    """
    net = net_of(structure)
    first, _ = _settled(net, start_shape(structure, net))
    return tuple(_transition_courses(structure, net, first, through_snaps=False)[0])


def _settled(net: Net, built: NetShape) -> tuple[NetRest, tuple[str, ...]]:
    """Where it comes to rest when let go, pushed off ridges; and what is to be said of that."""
    rest, off = minimum(net, built), 0
    while rest.settled and rest.index and off < _RIDGES:
        held, _ = supported(net)
        mode = np.zeros_like(net.nodes)
        mode[held.free] = softest(expand(held, rest.shape).free, 1)[1][:, 0]
        mode *= _OFF * net.size / mode.flat[np.argmax(np.abs(mode))]
        sides = [minimum(net, shape_at(net, rest.shape.positions + sign * mode, rest.shape.angles)) for sign in (1, -1)]
        rest, off = min(sides, key=lambda each: each.energy), off + 1
    if not off:
        return rest, ()
    return rest, (
        "let go as built, it comes to a ridge from which several ways lead down; the one taken here leads to the lower"
        " of the two ends of its softest mode, or where they are alike along that mode's largest coordinate",
    )


def _courses(structure: Structure, net: Net, first: NetRest) -> tuple[tuple[Course, ...], tuple[str, ...]]:
    """What transitions do, one after another, then what all other drives do; and why some do nothing."""
    courses, refused = _transition_courses(structure, net, first)
    driven = {drive_of(structure, transition.drive).name for transition in structure.transitions}
    done = driven | {part for name in driven for part in name.split(" and ")}
    for drive in structure.drives:
        if drive.name in done or not first.stable or not any(drive.strengths):
            continue
        try:
            courses.append(drive_course(structure, net, first, drive, None))
        except InputError as error:
            refused.append(f'what "{drive.name}" does cannot be told: {error}')
    return tuple(courses), tuple(refused)


def _transition_courses(
    structure: Structure, net: Net, first: NetRest, *, through_snaps: bool = True
) -> tuple[list[Course], list[str]]:
    """What transitions do, each from where the one before left it; and why some cannot be told."""
    courses, refused, here = list[Course](), list[str](), first
    for transition in structure.transitions:
        drive = drive_of(structure, transition.drive)
        if refused or not here.stable or not any(drive.strengths):
            continue
        try:
            courses.append(drive_course(structure, net, here, drive, transition, through_snaps=through_snaps))
        except InputError as error:
            # where the next would begin is not known
            refused.append(f'what "{drive.name}" does, and what comes after it, cannot be told: {error}')
            continue
        here = courses[-1].rest
    return courses, refused


def _rests(
    structure: Structure, net: Net, first: NetRest, courses: Sequence[Course]
) -> tuple[tuple[str, NetRest, bool], ...]:
    """Where it rests, by the names of the protocol."""
    places = [(first_state(structure, [state.name for state in structure.states]), first)]
    by_name = {course.name: course for course in courses}
    places += [(each.state, by_name[each.name].rest) for each in structure.transitions if each.name in by_name]
    found = []
    for name, rest in places:
        state = state_of(structure, name)
        within = state is None or short_of(structure, net, goal_of(structure, state.goal), rest.shape) <= 0
        found.append((name if within or state is None else state.missed, rest, within))
    return tuple(found)


def _told_rests(structure: Structure, net: Net, found: Sequence[tuple[str, NetRest, bool]]) -> tuple[Rest, ...]:
    """The rests of the protocol with what they store, and which of them are at one place."""
    rests = list[Rest]()
    for name, rest, within in found:
        angles = own_angles(structure, rest.shape)
        rests.append(
            Rest(
                name=name,
                angles=angles,
                energy=known(net, rest.energy),
                stored=stored_parts(structure, net, rest.shape),
                stable=rest.stable,
                within=within,
                same_as=next((each.name for each in rests if np.all(np.abs(each.angles - angles) <= _SAME)), ""),
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
    """What is told of states: of those of the protocol, and the lowest others in which no panels pass one another."""
    triangles, states, others = panels(structure), list[NetState](), 0
    for rest, found in zip(search.states, search.counts, strict=True):
        name = _name(net, rest, rests)
        others += not name
        if name or (others <= _SHOWN and not panels_pass(net, rest.shape, triangles)):
            called = name or f"state {len(states) + 1}"
            progress(f"what it withstands: {name}" if name else called)
            states.append(net_state(structure, net, rest, called, found, loads=bool(name)))
    return states


def _name(net: Net, state: NetRest, rests: Sequence[tuple[str, NetRest, bool]]) -> str:
    """What the protocol calls a state, where it rests there; else nothing."""
    for name, rest, within in rests:
        if name and within and rest.stable and same_shape(net, rest.shape, state.shape):
            return name
    return ""


def _passes(net: Net, states: Sequence[NetState]) -> tuple[Pass, ...]:
    """Saddles between neighbours: the pairs of states by which all hang together over the shortest ways.

    A saddle that is found on such a way and joins two other states is kept for these.
    """
    if len(states) < 2:
        return ()
    apart = np.array([[_apart(one.rest.shape, other.rest.shape) for other in states] for one in states])
    tree = minimum_spanning_tree(np.triu(apart, 1)).tocoo()
    found = dict[tuple[int, int], Pass]()
    for start, end in sorted(zip(tree.row.tolist(), tree.col.tolist(), strict=True)):
        saddle = find_saddle(net, states[start].rest, states[end].rest, increments=_INCREMENTS, tries=_PATHS)
        if saddle is None:
            continue
        one, other = (_number(net, states, rest) for rest in saddle.ends)
        if one is not None and other is not None and one != other:
            barriers = saddle.barriers if one < other else saddle.barriers[::-1]
            ends = min(one, other), max(one, other)
            found[ends] = Pass(ends=ends, barriers=barriers, energy=saddle.rest.energy, shape=saddle.rest.shape)
    return tuple(found[ends] for ends in sorted(found))


def _number(net: Net, states: Sequence[NetState], rest: NetRest) -> int | None:
    """The number of the state that a rest is, None for another one."""
    same = (number for number, state in enumerate(states) if same_shape(net, state.rest.shape, rest.shape))
    return next(same, None)


def _apart(one: NetShape, other: NetShape) -> float:
    """How far two shapes differ: by all distances of the nodes, which motions of the whole leave."""
    first, second = (np.linalg.norm(each.positions[:, None] - each.positions[None], axis=2) for each in (one, other))
    return float(np.linalg.norm(first - second)) + 1e-9 * float(np.linalg.norm(one.angles - other.angles))


def _alone(count: int, passes: Sequence[Pass]) -> list[int]:
    """States that no chain of passes joins to the first."""
    if not count:
        return []
    rows, columns = [each.ends[0] for each in passes], [each.ends[1] for each in passes]
    graph = coo_array((np.ones(len(passes)), (rows, columns)), shape=(count, count))
    _, part = connected_components(graph, directed=False)
    return np.flatnonzero(part != part[0]).tolist()


def _remarks(
    structure: Structure,
    search: StableStates,
    states: Sequence[NetState],
    passes: Sequence[Pass],
    courses: Sequence[Course],
) -> list[str]:
    """What is to be known of what was found, and of what was not."""
    whole, count = structure.appearance.whole, len(search.states)
    remarks = [
        f"states were looked for downhill from where the protocol leaves the {whole} and from {search.tries} pushes"
        f" (seed {search.seed}): there may be more than these {count}"
    ]
    if len(states) < count:
        remarks.append(
            f"of {count} states that were found {len(states)} are told of: those that the protocol names, and the"
            f" lowest others in which no panels pass through one another, up to {_SHOWN}"
        )
    remarks += [
        f'in "{state.name}" panels pass through one another, which nothing here keeps them from: a locking law'
        ' (crease.law = "locking") or stops (crease.fold_limit) would'
        for state in states
        if state.passing
    ]
    if search.failed:
        remarks.append(f"{search.failed} of the tries came to rest in no stable state")
    if not count:
        remarks.append("something moves without any force: a crease without a spring, or a support that is missing")
    remarks += [
        f'no saddle was found that leads from "{states[number].name}" to the first of the states'
        for number in _alone(len(states), passes)
    ]
    for course in courses:
        if any(snap.kind != "limit" for snap in course.slow.snaps):
            remarks.append(
                f'under "{course.name}" the way branches, and imperfections decide which branch is taken; here it is'
                " the one that leads further down"
            )
        if course.slow.ended == "lost":
            remarks.append(f'the path under "{course.name}" was followed as far as is shown, and not to its end')
    return remarks
