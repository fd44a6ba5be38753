"""A landscape as text."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.analysis import measure
from forficula.analysis.simulated_rests import rest_distances
from forficula.analysis.simulated_snap import (
    SimulatedSnap,
    fold_limit,
    folded_angle,
    folding_transition,
    hinge_name,
    inner_hinge,
    simulated_snap,
)
from forficula.dynamics import Record
from forficula.quantities import show_value
from forficula.show.landscape.headline import headline
from forficula.show.landscape.landscape_marks import (
    reading_words,
    rounding_torque,
    show_angle,
    show_angles,
    shown_value,
    slow_path_text,
    torque_location,
    touching_text,
    withstood_text,
)
from forficula.show.structure.labels import shown_angles, stress_text, title_of
from forficula.statics import CrossedHinge, EnergyLandscape, HingeLandscape
from forficula.statics.landscape import AT_START, LeastTorque, fold_states, net_courses, net_states
from forficula.statics.net.net_state import Mobility, NetState
from forficula.statics.tree.snap import FOLD_START
from forficula.statics.tree.tip_stiffness import TipStiffness
from forficula.structure import Structure, drive_unit

# cells of a row by the headings of their columns, the name of the row first
Row = dict[str, str]

_MEASURES = 5  # largest number of measures in a table
_LONGEST = 24  # largest number of letters of a drive's location
_LEFT = ("", "kind")  # headings of columns that contain words
_KINDS = {"stop": "on its stop", "minimum": "minimum", "neutral": "range without torque"}
_NONE = "none"
_NOTHING = 1e-9  # m, distances below this are rounding errors


def print_headline(landscape: EnergyLandscape) -> None:
    """Print the first line of a landscape, at once."""
    Console(width=110, highlight=False).print(Text(headline(landscape), style="bold"), soft_wrap=True)
    sys.stdout.flush()


def print_landscape(landscape: EnergyLandscape, record: Record | None = None, tendon: int | None = None) -> None:
    """Print a landscape, compared with a run of the same design; args are those of `landscape_table`."""
    Console(width=110, highlight=False).print(landscape_table(landscape, record, tendon, first_line=False))


def landscape_table(
    landscape: EnergyLandscape, record: Record | None = None, tendon: int | None = None, *, first_line: bool = True
) -> RenderableType:
    """Return tables of stable states, barriers, torques, stiffness and snap, and the remarks as sentences.

    Tables without contents are left out.

    Args:
        landscape: the landscape.
        record: a run of the same design.
        tendon: index of the tendon whose hinge is shown as an example; an inner one by default.
        first_line: whether the table begins with the headline.
    """
    shown = inner_hinge(landscape, tendon)
    tables = (
        _table("Stable states", _states(landscape, shown)),
        _table("Mobility of the states, and stress in their parts", _moves(landscape)),
        _table("Barriers", _barriers(landscape, shown)),
        _table(f"Least slow {_drives(landscape)}, without help from inertia", _torques(landscape)),
        _table("Motion under slowly growing drives", _courses(landscape)),
        _table("Loads that states withstand", _withstands(landscape)),
        _table("Stiffness at every tip", _tips(landscape.tips)),
        *_snap(landscape, record, shown),
    )
    parts: list[RenderableType] = [Text(headline(landscape), style="bold")] if first_line else []
    for table in tables:
        if table.row_count:
            parts += [Text(), table]
    remarks = [*_simulation_remarks(record, shown), *_rest_remarks(landscape, record), *landscape.remarks]
    if remarks:
        parts += [Text(), *(Text(_sentence(remark)) for remark in remarks)]
    return Group(*parts)


def _states(landscape: EnergyLandscape, shown: CrossedHinge | None) -> Iterator[Row]:
    """Yield the states of the shown hinge and of the whole; without a search for stable states, all equilibria."""
    whole, bar = landscape.structure.appearance.whole, landscape.structure.appearance.bar
    for name, hinge in _hinges(landscape, shown):
        for place in hinge.states:
            yield {
                "": name,
                "kind": _KINDS[place.kind],
                "at": _range(hinge.sense * place.angle, hinge.sense * place.far_angle),
                "energy": show_value(place.energy, "J"),
                "held by": show_value(place.holding_torque, "N m") if place.kind == "stop" else "",
            }
    yield from (_net_row(landscape.structure, state) for state in net_states(landscape))
    for state in fold_states(landscape):
        yield {
            "": f"{whole}, {state.name}",
            "kind": _KINDS[state.kind],
            "at": f"pleats {_range(state.pleat_angle, state.far_pleat_angle)}",
            "energy": show_value(state.energy, "J"),
            "held by": f"{show_value(state.holding_torque, 'N m')} a {bar}" if state.kind == "stop" else "",
        }
    if landscape.fold_path is not None or landscape.net is not None:
        return
    measures = shown_angles(landscape.structure)
    for rest in landscape.rests:
        yield {
            "": f"{whole}, {rest.name or AT_START}",
            "kind": "not stable" if not rest.stable else f"as {rest.same_as}" if rest.same_as else "rests",
            "at": ", ".join(f"{title_of(item)} {show_angles(item, rest.angles)}" for item in measures),
            "energy": show_value(rest.energy, "J"),
            **({} if rest.contacts is None else {"touching": touching_text(rest.contacts)}),
        }


def _hinges(landscape: EnergyLandscape, shown: CrossedHinge | None) -> list[tuple[str, HingeLandscape]]:
    """Return the shown hinge by name, with its ideal counterpart first if there is one."""
    if shown is None:
        return []
    actual = f"{hinge_name(landscape.structure, shown.tendon)} of the {landscape.structure.appearance.whole}"
    return [*([] if shown.ideal is None else [("ideal hinge", shown.ideal)]), (actual, shown.actual)]


def _net_row(structure: Structure, state: NetState) -> Row:
    titles = {measure.name: measure.label or measure.name for measure in structure.measures}
    return {
        "": state.name,
        "energy": shown_value(state.energy, "J", 3),
        **{part: shown_value(energy, "J", 3) for part, energy in state.stored.items()},
        **{
            titles[name]: reading_words(structure, name, readings.tolist())
            for name, readings in list(state.readings.items())[:_MEASURES]
        },
        **({"touching": touching_text(state.contacts)} if structure.has_contacts else {}),
    }


def _moves(landscape: EnergyLandscape) -> Iterator[Row]:
    """Yield the mobility of a net, as built and in its states, and the strain and stress of its parts."""
    if landscape.net is None:
        return
    states = net_states(landscape)
    tendons = any(state.extension for state in states)
    yield {"": "as built", "slowest": "", **_freedoms(landscape.net.built), "strain": "", "stress": ""}
    for state in states:
        yield {
            "": state.name,
            "slowest": f"{state.frequencies[0]:.3g} Hz" if len(state.frequencies) else "",
            **_freedoms(state.mobility),
            "strain": f"{100 * state.strain:.2g} %",
            "stress": stress_text(state.stress, landscape.structure.strength),
            **({"tendon extension": f"{100 * state.extension:.3g} %"} if tendons else {}),
        }


def _freedoms(mobility: Mobility | None) -> Row:
    return {
        "freedoms": "" if mobility is None else str(mobility.degrees_of_freedom),
        "self-stresses": "" if mobility is None else str(mobility.self_stresses),
    }


def _barriers(landscape: EnergyLandscape, shown: CrossedHinge | None) -> Iterator[Row]:
    whole, columns = landscape.structure.appearance.whole, _hinges(landscape, shown)
    overbend = landscape.structure.appearance.overbend
    rows = [(f"{name}, {_climb(hinge, overbend)}", hinge.barrier) for name, hinge in columns]
    fold = landscape.structure.rigid_fold
    start = (landscape.rests[0].name if fold is None else fold.start) or AT_START
    # a single hinge has its own barrier only
    if len(landscape.hinge_barriers) > len(columns[:1]):
        rows.append((f"{whole}, {start} until its weakest hinge folds alone", landscape.easiest_barrier))
    if landscape.fold_path is not None and fold is not None:
        rows += [
            (f"{whole}, {fold.start} to {fold.end}, all hinges together", landscape.fold_barrier),
            (f"{whole}, {fold.end} to {fold.start}, all hinges together", landscape.unfold_barrier),
        ]
    for name, value in rows:
        yield {"": name, "energy": _NONE if value is None else show_value(value, "J")}
    for course_pass in landscape.passes:
        one, other = (landscape.states[end].name for end in course_pass.ends)
        forward, back = (shown_value(barrier, "J", 3) for barrier in course_pass.barriers)
        if landscape.net is not None:
            yield {"": f"{one} to {other}", "forward": forward, "back": back}
        # other trees have their passes along the fold, or of their only hinge
        elif course_pass.angles is not None:
            yield {"": f"{whole}, {one} to {other}", "energy": forward}
            yield {"": f"{whole}, {other} to {one}", "energy": back}


def _climb(hinge: HingeLandscape, start: str) -> str:
    """Return the angles between which a hinge's barrier is measured; from the rest angle if the hinge has a spring."""
    top = hinge.barrier_angle
    if hinge.spring is not None and top is not None:
        start = show_angle(hinge.sense * hinge.states[0].angle)
    return f"{start} to {show_angle(hinge.sense * top) if top else 'straight'}"


def _torques(landscape: EnergyLandscape) -> Iterator[Row]:
    """Yield the least drives of the transitions of a tree of joints: along its rigid fold, and of the whole."""
    structure, path, fold = landscape.structure, landscape.fold_path, landscape.structure.rigid_fold
    rounding, whole = rounding_torque(landscape), structure.appearance.whole
    courses = {course.name: course for course in landscape.courses if isinstance(course, LeastTorque)}
    for transition in structure.transitions:
        # the effects of transitions after one that statics cannot follow are not known
        course, verb = courses.get(transition.name), transition.wording.verb
        if course is None:
            continue
        bound = "≤ " * (course.inertial_help is not None or course.smallest)
        slow = bound + _least(course.least, rounding, course.unit)
        name = f"that {'make it ' * (' ' in verb)}{verb}, {torque_location(structure, transition)}"
        if path is None or fold is None:
            yield {"": name, whole: slow}
        else:
            along = path.fold_torque if transition.state == fold.end else path.unfold_torque
            yield {"": name, "rigid panels": _least(along, rounding), f"compliant {whole}": slow}
        if course.withstood is not None:
            kept = f"that make it leave the goal of {transition.name}, {torque_location(structure, transition)}"
            yield {"": kept, whole: show_value(course.withstood, course.unit)}


def _drives(landscape: EnergyLandscape) -> str:
    """Return what the drives of transitions are: torques, forces, or both."""
    units = {course.unit for course in landscape.courses if isinstance(course, LeastTorque)}
    return {frozenset({"N"}): "forces", frozenset({"N", "N m"}): "torques and forces"}.get(frozenset(units), "torques")


def _least(least: float | None, rounding: float, unit: str = "N m") -> str:
    if least is None:
        return _NONE
    return show_value(least if least > rounding or unit != "N m" else 0.0, unit)


def _courses(landscape: EnergyLandscape) -> Iterator[Row]:
    """Yield the path of a net under each drive: snaps, the strength at its goal, and the energy released."""
    structure = landscape.structure
    for course in net_courses(landscape):
        unit, where = drive_unit(structure, course.drive), course.drive.where
        released = sum(snap.released for snap in course.slow.snaps)
        yield {
            "": f"{course.name}, {where}" if 0 < len(where) <= _LONGEST else course.name,
            "on the way": slow_path_text(structure, course),
            "at its goal": "" if course.least is None else shown_value(course.least, unit, 3),
            "energy released": shown_value(released, "J", 3) if course.slow.snaps else "",
        }


def _withstands(landscape: EnergyLandscape) -> Iterator[Row]:
    """Yield a row for each load, with the value up to which each state withstands the load."""
    states = [state for state in net_states(landscape) if state.withstands]
    held = {
        (state.name, withstand.load): withstood_text(withstand) for state in states for withstand in state.withstands
    }
    for load in dict.fromkeys(load for _, load in held):
        yield {"": load, **{state.name: held.get((state.name, load), "") for state in states}}


def _tips(tips: TipStiffness | None) -> Iterator[Row]:
    if tips is None:
        return
    flat = f"flat (along: to {show_value(tips.deflection, 'm', 3)})"
    for name, along, against in (
        (flat, _stiffness(tips.flat_along), _stiffness(tips.flat_against)),
        ("unlocked, hinges straight", _stiffness(tips.unlocked_along), _stiffness(tips.unlocked_against)),
        ("flat, folds beyond", f"{tips.holding_force:.3g} N", ""),
    ):
        yield {"": name, "along folding": along, "against folding": against}


def _snap(landscape: EnergyLandscape, record: Record | None, shown: CrossedHinge | None) -> Iterator[Table]:
    """Yield the snap of one hinge: predicted if it has no spring, and simulated if there is a run."""
    if shown is None:
        return
    structure = landscape.structure
    folded, limit = folded_angle(structure, shown.hinge), fold_limit(structure, shown.hinge)
    snap = None if record is None else simulated_snap(record, shown)
    name = hinge_name(structure, shown.tendon)
    alone = {"ideal hinge": shown.ideal, name: shown.actual}
    hinges = {of: item for of, item in alone.items() if item is not None and item.spring is None}
    top = "its top" if shown.actual.hinge.offset_angle else "straight"
    start, simulated = f"from {show_angle(FOLD_START)} past {top}", f"in the simulated {structure.appearance.whole}"
    rows = list[Row]()
    if hinges:
        rows.append({"": "time scale t*", **{of: _time(hinge.time_scale) for of, hinge in hinges.items()}})
        rates = {of: _rate(hinge.growth_rate) for of, hinge in hinges.items()}
        rows.append({"": f"growth rate at {top}", **rates})
    if hinges or snap is not None:
        if folded is not None:
            times = {of: _time(hinge.time_to(folded)) for of, hinge in hinges.items()}
            timed = {} if snap is None else {simulated: _simulated_time(snap, snap.folded_time)}
            rows.append({"": f"{start} to {show_angle(folded)}", **times, **timed})
        times = {of: _time(hinge.fold_time) for of, hinge in hinges.items()}
        timed = {} if snap is None else {simulated: _simulated_time(snap, snap.fold_time)}
        rows.append({"": f"{start} to {show_angle(limit)}", **times, **timed})
        speed = "largest speed"
        if hinges:
            speed = f"final speed{'; simulated: the largest' * (snap is not None)}"
        speeds = {of: _speed(hinge.final_speed) for of, hinge in hinges.items()}
        rows.append({"": speed, **speeds, **({} if snap is None else {simulated: _speed(snap.peak_speed)})})
    yield _table("Snap of one hinge alone, without damping" if hinges else f"Snap of {name}", rows)


def _simulated_time(snap: SimulatedSnap, time: float | None) -> str:
    return f"folds to {show_angle(snap.largest_fold)} only" if time is None else _time(time)


def _simulation_remarks(record: Record | None, shown: CrossedHinge | None) -> Iterator[str]:
    """Yield remarks on the outcome of the simulation and on its sampling interval."""
    if record is None:
        return
    outcome, structure = measure(record), record.structure
    snap = None if shown is None else simulated_snap(record, shown)
    yield f"the simulated {structure.appearance.whole}: {outcome.status}. {outcome.advice}".strip()
    if snap is None or shown is None:
        return
    sampled = f"its {hinge_name(structure, shown.tendon)} is sampled every {_time(snap.sample_interval)}"
    if shown.actual.spring is not None:
        yield sampled
        return
    folding = folding_transition(structure, shown.hinge)
    driven = "it is driven" if folding is None else f"it is driven by the {folding.drive} torque"
    others = ", damped, and tied to the membrane" if structure.membranes else " and damped"
    yield f"{sampled}; {driven}{others}, which the prediction is not"


def _rest_remarks(landscape: EnergyLandscape, record: Record | None) -> Iterator[str]:
    """Yield a remark on the distance between the rest states of statics and of the simulation."""
    apart = {} if record is None else rest_distances(landscape, record)
    if apart:
        distances = ", ".join(f"{name} {show_value(max(distance, _NOTHING), 'm')}" for name, distance in apart.items())
        yield f"at rest, distances between vertices in the run differ from those in statics by at most: {distances}"


def _sentence(remark: str) -> str:
    """Return a remark with a capital, unless it begins with a key of a design file, and a full stop."""
    first, _, rest = remark.partition(" ")
    start = first if "." in first else first[0].upper() + first[1:]
    return f"{start} {rest.rstrip('.')}."


def _table(title: str, rows: Iterable[Row]) -> Table:
    """Lay out rows; the columns are those of any row, and a cell that a row lacks stays empty."""
    rows = list(rows)
    headings = list(dict.fromkeys(heading for row in rows for heading in row))
    table = Table(
        box=None,
        padding=(0, 2, 0, 0),
        title=title,
        title_justify="left",
        show_header=any(headings),
        min_width=len(title),
    )
    for heading in headings:
        table.add_column(heading, justify="left" if heading in _LEFT else "right")
    for row in rows:
        table.add_row(*(row.get(heading, "") for heading in headings))
    return table


def _range(start: float, end: float) -> str:
    return show_angle(start) if start == end else f"{show_angle(start)} to {show_angle(end)}"


def _time(value: float | None) -> str:
    return _NONE if value is None else show_value(value, "s")


def _rate(value: float | None) -> str:
    return _NONE if value is None else f"{value:.4g} /s"


def _speed(value: float | None) -> str:
    return _NONE if value is None else f"{value:.4g} rad/s"


def _stiffness(value: float | None) -> str:
    return "rigid" if value is None else f"{value:.4g} N/m".replace("-", "−")
