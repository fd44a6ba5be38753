"""A landscape as text that a person understands."""

from __future__ import annotations

from collections.abc import Iterator

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
    predicted_snap,
    simulated_snap,
)
from forficula.dynamics import Record
from forficula.quantities import reading_unit
from forficula.show.landscape.landscape_marks import rest_name, rounding_torque, show_angle, show_angles, torque_words
from forficula.show.landscape.net_tables import TextTable, net_tables, net_verdict
from forficula.show.landscape.shown_hinge import ShownHinge, shown_hinge
from forficula.show.structure.labels import shown_angles, title_of
from forficula.statics import EnergyLandscape, FoldPath, HingeLandscape, stable_states
from forficula.statics.snap import FOLD_START
from forficula.statics.tip_stiffness import TipStiffness
from forficula.structure import RigidFold, Transition

_KINDS = {"stop": "on its stop", "minimum": "minimum", "neutral": "range without force"}
_NONE = "none"
_NOTHING = 1e-9  # m, below which a distance is rounding


def print_landscape(landscape: EnergyLandscape, record: Record | None = None, tendon: int | None = None) -> None:
    """Print a landscape, and a run of the same design beside its prediction; args are those of `landscape_table`."""
    Console(width=110, highlight=False).print(landscape_table(landscape, record, tendon))


def landscape_table(
    landscape: EnergyLandscape, record: Record | None = None, tendon: int | None = None
) -> RenderableType:
    """Lay out stable states, barriers, torques, stiffness and snap, and the remarks as sentences.

    What the structure does not have is left out.

    Args:
        landscape: what to show.
        record: a run of its design.
        tendon: number of the one whose hinge stands for all; an inner one if not given.
    """
    shown = shown_hinge(landscape, tendon)
    parts: list[RenderableType] = [Text(_verdict(landscape), style="bold")]
    tables = [_plain(table) for table in net_tables(landscape)]
    if landscape.net is None:
        tables = [_states(landscape, shown), _barriers(landscape, shown), _torques(landscape)]
    if landscape.tips is not None:
        tables.append(_tips(landscape.tips))
    if shown is not None:
        tables.append(_snap(landscape, record, shown))
    for table in tables:
        if table.row_count:
            parts += [Text(), table]
    remarks = [*_simulation_remarks(record, shown), *_rest_remarks(landscape, record), *landscape.remarks]
    if remarks:
        parts += [Text(), *(Text(_sentence(remark)) for remark in remarks)]
    return Group(*parts)


def _verdict(landscape: EnergyLandscape) -> str:
    folds = landscape.partial_folds
    if landscape.net is not None:
        return net_verdict(landscape)
    if landscape.fold_path is None:
        names = [rest_name(each) for each in landscape.rests if each.stable]
        told = f"rests stably: {', '.join(names)}" if names else "rests nowhere stably"
    else:
        names = [state.name for state in stable_states(landscape)]
        told = f"stable along its fold: {', '.join(names)}" if names else "no stable state along its fold"
    stable = sum(fold.stable for fold in folds)
    partly = f"; {stable} of {len(folds)} states with some hinges folded stay" if len(folds) > 2 else ""
    return f"{landscape.design.name}: {told}{partly}"


def _plain(text: TextTable) -> Table:
    table = _table(text.title, *text.headings)
    for row in text.rows:
        table.add_row(*row)
    return table


def _states(landscape: EnergyLandscape, shown: ShownHinge | None) -> Table:
    whole = landscape.structure.appearance.whole
    table = _table("Stable states", "", "", "at", "energy", "held by")
    for name, hinge in () if shown is None else shown.columns:
        for state in hinge.states:
            held = _torque(state.holding_torque) if state.kind == "stop" else ""
            at = _range(hinge.sense * state.angle, hinge.sense * state.far_angle)
            table.add_row(name, _KINDS[state.kind], at, _energy(state.energy), held)
    if landscape.fold_path is not None:
        for each in stable_states(landscape):
            at = f"pleats {_range(each.pleat_angle, each.far_pleat_angle)}"
            bar = landscape.structure.appearance.bar
            held = f"{_torque(each.holding_torque)} a {bar}" if each.kind == "stop" else ""
            table.add_row(f"{whole}, {each.name}", _KINDS[each.kind], at, _energy(each.energy), held)
        return table
    measures = shown_angles(landscape.structure)
    for rest in landscape.rests:
        at = ", ".join(f"{title_of(each)} {show_angles(each, rest.angles)}" for each in measures)
        kind = "not stable" if not rest.stable else f"as {rest.same_as}" if rest.same_as else "rests"
        table.add_row(f"{whole}, {rest.name or 'at the start'}", kind, at, _energy(rest.energy), "")
    return table


def _barriers(landscape: EnergyLandscape, shown: ShownHinge | None) -> Table:
    table, whole = _table("Barriers", "", "energy"), landscape.structure.appearance.whole
    columns = () if shown is None else shown.columns
    overbend = landscape.structure.appearance.overbend
    rows = [(f"{name}, {_way(hinge, overbend)}", hinge.barrier) for name, hinge in columns]
    fold = landscape.structure.rigid_fold
    start = (landscape.rests[0].name if fold is None else fold.start) or "at the start"
    # that of a single hinge is its own
    if len(landscape.hinge_barriers) > len(columns[:1]):
        rows.append((f"{whole}, {start} until its easiest hinge folds alone", landscape.easiest_barrier))
    if fold is not None:
        rows += [
            (f"{whole}, {fold.start} to {fold.end}, all hinges together", landscape.fold_barrier),
            (f"{whole}, {fold.end} to {fold.start}, all hinges together", landscape.unfold_barrier),
        ]
    for name, value in rows:
        table.add_row(name, _NONE if value is None else _energy(value))
    return table


def _way(hinge: HingeLandscape, start: str) -> str:
    """From where to where a hinge's barrier is climbed: from a start so called; with a spring from where it rests."""
    top = hinge.barrier_angle
    if hinge.spring is not None and top is not None:
        start = show_angle(hinge.sense * hinge.states[0].angle)
    return f"{start} to {show_angle(hinge.sense * top) if top else 'straight'}"


def _torques(landscape: EnergyLandscape) -> Table:
    path, fold, rounding = landscape.fold_path, landscape.structure.rigid_fold, rounding_torque(landscape)
    whole = landscape.structure.appearance.whole
    columns = [whole] if path is None else ["rigid panels", f"compliant {whole}"]
    table = _table("Least slow torques, without help from inertia", "", *columns)
    for transition in landscape.structure.transitions:
        slow = _least(landscape.least_torques[transition.name], rounding)
        if landscape.inertial_help[transition.name] is not None:
            slow = f"≤ {slow}"
        along = [] if path is None or fold is None else [_least(_along(path, fold, transition), rounding)]
        where = torque_words(landscape.structure, transition)
        verb = transition.wording.verb
        table.add_row(f"that {'make it ' * (' ' in verb)}{verb}, {where}", *along, slow)
    return table


def _along(path: FoldPath, fold: RigidFold, transition: Transition) -> float | None:
    """The torque that takes rigid panels along their fold, where a transition leads to its end, or else back."""
    return path.fold_torque if transition.state == fold.end else path.unfold_torque


def _least(torque: float | None, rounding: float) -> str:
    return _NONE if torque is None else _torque(torque if torque > rounding else 0.0)


def _tips(tips: TipStiffness) -> Table:
    unit, factor = reading_unit("m", tips.deflection)
    deflection = f"{factor * tips.deflection:.3g} {unit}"
    table = _table("Stiffness at every tip", "", "along folding", "against folding")
    table.add_row(f"flat (along: to {deflection})", _stiffness(tips.flat_along), _stiffness(tips.flat_against))
    table.add_row("unlocked, hinges straight", *map(_stiffness, (tips.unlocked_along, tips.unlocked_against)))
    table.add_row("flat, does not give up to", f"{tips.holding_force:.3g} N", "")
    return table


def _snap(landscape: EnergyLandscape, record: Record | None, shown: ShownHinge) -> Table:
    """How fast one hinge snaps: predicted where it has no spring of its own, and in the run where there is one."""
    structure = landscape.structure
    folded, limit = folded_angle(structure, shown.hinge), fold_limit(structure, shown.hinge)
    snap = None if record is None else simulated_snap(record, shown.tendon)
    hinges = [each for _, each in shown.columns if each.spring is None]
    predicted = [predicted_snap(each.hinge, folded) for each in hinges]
    names = (["ideal hinge"] if shown.ideal is not None else []) + [shown.name] if hinges else []
    headings = ["", *names] + ([f"in the simulated {shown.whole}"] if snap else [])
    kind = "Snap of one hinge alone, without damping" if hinges else f"Snap of {shown.name}"
    table = _table(kind, *headings)
    if not hinges and snap is None:
        return table
    top = "its top" if shown.own.hinge.offset_angle else "straight"
    if hinges:
        table.add_row("time scale t*", *(_time(each.time_scale) for each in hinges))
        table.add_row(f"growth rate at {top}", *(_rate(each.growth_rate) for each in hinges))
    start = f"from {show_angle(FOLD_START)} past {top}"
    rows: list[list[str]] = []
    for angle, of, simulated in (
        (folded, [each.folded_time for each in predicted], None if snap is None else snap.folded_time),
        (limit, [each.fold_time for each in predicted], None if snap is None else snap.fold_time),
    ):
        if angle is None:
            continue
        rows.append([f"{start} to {show_angle(angle)}", *map(_time, of)])
        if snap is not None:
            rows[-1].append(_simulated_time(snap, simulated))
    speed = ["final speed" if hinges else "largest speed", *(_speed(each.final_speed) for each in predicted)]
    if snap is not None:
        speed[0] += "; simulated: the largest" * bool(hinges)
        speed.append(_speed(snap.peak_speed))
    for row in (*rows, speed):
        table.add_row(*row)
    return table


def _simulated_time(snap: SimulatedSnap, time: float | None) -> str:
    return f"folds to {show_angle(snap.largest_fold)} only" if time is None else _time(time)


def _simulation_remarks(record: Record | None, shown: ShownHinge | None) -> Iterator[str]:
    """What became of the simulation, and how finely it was sampled."""
    if record is None:
        return
    outcome, structure = measure(record), record.structure
    snap = None if shown is None else simulated_snap(record, shown.tendon)
    yield f"the simulated {structure.appearance.whole}: {outcome.status}. {outcome.advice}".strip()
    if snap is None or shown is None:
        return
    sampled = f"its {shown.name} is sampled every {_time(snap.sample_interval)}"
    if shown.own.spring is not None:
        yield sampled
        return
    folding = folding_transition(structure, shown.hinge)
    driven = "it is driven" if folding is None else f"it is driven by the {folding.drive} torque"
    others = ", damped, and tied to the membrane" if structure.membranes else " and damped"
    yield f"{sampled}; {driven}{others}, which the prediction is not"


def _rest_remarks(landscape: EnergyLandscape, record: Record | None) -> Iterator[str]:
    """How near to one another the two routes came to rest."""
    apart = {} if record is None else rest_distances(landscape, record)
    if apart:
        told = ", ".join(f"{name} {_readable(max(distance, _NOTHING), 'm')}" for name, distance in apart.items())
        yield f"at rest, distances between vertices in the run differ from those in statics by at most: {told}"


def _sentence(remark: str) -> str:
    """A remark with a capital, unless it begins with a key of a design file, and a full stop."""
    first, _, rest = remark.partition(" ")
    start = first if "." in first else first[0].upper() + first[1:]
    return f"{start} {rest.rstrip('.')}."


def _table(title: str, *headings: str) -> Table:
    table = Table(
        box=None,
        padding=(0, 2, 0, 0),
        title=title,
        title_justify="left",
        show_header=any(headings),
        min_width=len(title),
    )
    for number, heading in enumerate(headings):
        table.add_column(heading, justify="right" if number and heading else "left")
    return table


def _range(start: float, end: float) -> str:
    return show_angle(start) if start == end else f"{show_angle(start)} to {show_angle(end)}"


def _energy(value: float) -> str:
    return _readable(value, "J")


def _torque(value: float) -> str:
    return _readable(value, "N m")


def _time(value: float | None) -> str:
    return _NONE if value is None else _readable(value, "s")


def _rate(value: float | None) -> str:
    return _NONE if value is None else f"{value:.4g} /s"


def _speed(value: float | None) -> str:
    return _NONE if value is None else f"{value:.4g} rad/s"


def _stiffness(value: float | None) -> str:
    return "rigid" if value is None else f"{value:.4g} N/m".replace("-", "−")


def _readable(value: float, si: str) -> str:
    unit, factor = reading_unit(si, abs(value))
    return f"{factor * value:.4g} {unit}"
