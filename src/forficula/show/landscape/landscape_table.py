"""A landscape as text that a person understands."""

from __future__ import annotations

from collections.abc import Iterator

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.analysis import measure
from forficula.analysis.simulated_snap import INNER_VEIN, SimulatedSnap, predicted_snap, simulated_snap
from forficula.dynamics import Record
from forficula.names import ordinal
from forficula.quantities import reading_unit
from forficula.show.landscape.landscape_marks import rounding_torque, show_angle
from forficula.statics import EnergyLandscape, stable_states

_KINDS = {"stop": "on its stop", "minimum": "minimum", "neutral": "range without force"}
_NONE = "none"


def print_landscape(landscape: EnergyLandscape, record: Record | None = None, vein: int = INNER_VEIN) -> None:
    """Print a landscape, and a run of the same design beside its prediction; args are those of `landscape_table`."""
    Console(width=110, highlight=False).print(landscape_table(landscape, record, vein))


def landscape_table(landscape: EnergyLandscape, record: Record | None = None, vein: int = INNER_VEIN) -> RenderableType:
    """Lay out stable states, barriers, torques, stiffness and snap, and the remarks as sentences.

    Args:
        landscape: what to show.
        record: a run of its design.
        vein: number of the one, from 0, whose hinge stands for those of the wing.
    """
    parts: list[RenderableType] = [Text(_verdict(landscape), style="bold"), Text()]
    for table in (_states(landscape, vein), _barriers(landscape, vein), _torques(landscape), _tips(landscape)):
        parts += [table, Text()]
    parts.append(_snap(landscape, record, vein))
    remarks = [*_simulation_remarks(record, vein), *landscape.remarks]
    if remarks:
        parts += [Text(), *(Text(_sentence(remark)) for remark in remarks)]
    return Group(*parts)


def _verdict(landscape: EnergyLandscape) -> str:
    folds = landscape.partial_folds
    names = [state.name for state in stable_states(landscape)]
    along = f"stable along its fold: {', '.join(names)}" if names else "no stable state along its fold"
    stable = sum(fold.stable for fold in folds)
    return f"{landscape.design.name}: {along}; {stable} of {len(folds)} states with some hinges folded stay"


def _states(landscape: EnergyLandscape, vein: int) -> Table:
    table = _table("Stable states", "", "", "at", "energy", "held by")
    hinges = (("ideal hinge", landscape.hinge), (f"{ordinal(vein)} hinge of the wing", landscape.tendons[vein]))
    for name, hinge in hinges:
        for state in hinge.states:
            held = _torque(state.holding_torque) if state.kind == "stop" else ""
            at = _range(state.angle, state.far_angle)
            table.add_row(name, _KINDS[state.kind], at, _energy(state.energy), held)
    for each in stable_states(landscape):
        at = f"pleats {_range(each.pleat_angle, each.far_pleat_angle)}"
        held = f"{_torque(each.holding_torque)} a vein" if each.kind == "stop" else ""
        table.add_row(f"wing, {each.name}", _KINDS[each.kind], at, _energy(each.energy), held)
    return table


def _barriers(landscape: EnergyLandscape, vein: int) -> Table:
    table = _table("Barriers", "", "energy")
    for name, value in (
        ("ideal hinge, overbend to straight", landscape.hinge.barrier),
        (f"{ordinal(vein)} hinge of the wing, overbend to straight", landscape.tendons[vein].barrier),
        ("wing, flat until its easiest hinge folds alone", float(landscape.hinge_barriers.min())),
        ("wing, flat to folded, all hinges together", landscape.fold_barrier),
        ("wing, folded to flat, all hinges together", landscape.unfold_barrier),
    ):
        table.add_row(name, _NONE if value is None else _energy(value))
    return table


def _torques(landscape: EnergyLandscape) -> Table:
    wing, rounding = landscape.wing, rounding_torque(landscape)
    table = _table("Least slow torques, without help by inertia", "", "rigid panels", "compliant wing")
    for name, path, slow in (
        ("that fold, on every proximal turn axis", wing.fold_torque, landscape.fold_torque),
        ("that open, on every distal hinge", wing.unfold_torque, landscape.unfold_torque),
    ):
        table.add_row(name, *(_least(torque, rounding) for torque in (path, slow)))
    return table


def _least(torque: float | None, rounding: float) -> str:
    return _NONE if torque is None else _torque(torque if torque > rounding else 0.0)


def _tips(landscape: EnergyLandscape) -> Table:
    tips = landscape.tips
    unit, factor = reading_unit("m", tips.deflection)
    deflection = f"{factor * tips.deflection:.3g} {unit}"
    table = _table("Stiffness at every tip", "", "along folding", "against folding")
    table.add_row(f"flat (along: to {deflection})", _stiffness(tips.flat_along), _stiffness(tips.flat_against))
    table.add_row("unlocked, hinges straight", *map(_stiffness, (tips.unlocked_along, tips.unlocked_against)))
    table.add_row("flat, does not give up to", f"{tips.holding_force:.3g} N", "")
    return table


def _snap(landscape: EnergyLandscape, record: Record | None, vein: int) -> Table:
    design = landscape.design
    folded, limit = design.protocol.folded_angle, design.hinge.fold_limit
    snap = None if record is None else simulated_snap(record, vein)
    hinges = (landscape.hinge, landscape.tendons[vein])
    predicted = [predicted_snap(each.hinge, folded) for each in hinges]
    headings = ["", "ideal hinge", f"{ordinal(vein)} hinge"] + (["in the simulated wing"] if snap else [])
    table = _table("Snap of one hinge alone, without damping", *headings)
    start = show_angle(landscape.hinge.fold_start)
    table.add_row("time scale t*", *(_time(each.time_scale) for each in hinges))
    table.add_row("growth rate at straight", *(_rate(each.growth_rate) for each in hinges))
    ways = [f"from {start} past straight to {show_angle(angle)}" for angle in (folded, limit)]
    to_folded = [ways[0], *(_time(each.folded_time) for each in predicted)]
    to_limit = [ways[1], *(_time(each.fold_time) for each in predicted)]
    speed = ["final speed", *(_speed(each.final_speed) for each in predicted)]
    if snap is not None:
        to_folded.append(_simulated_time(snap, snap.folded_time))
        to_limit.append(_simulated_time(snap, snap.fold_time))
        speed[0] += "; simulated: the largest"
        speed.append(_speed(snap.peak_speed))
    for row in (to_folded, to_limit, speed):
        table.add_row(*row)
    return table


def _simulated_time(snap: SimulatedSnap, time: float | None) -> str:
    return f"folds to {show_angle(snap.largest_fold)} only" if time is None else _time(time)


def _simulation_remarks(record: Record | None, vein: int) -> Iterator[str]:
    """What became of the simulation, and how finely it was sampled."""
    if record is None:
        return
    outcome, snap = measure(record), simulated_snap(record, vein)
    yield f"the simulated wing: {outcome.status}. {outcome.advice}".strip()
    if snap is not None:
        yield (
            f"its {ordinal(vein)} hinge is sampled every {_time(snap.sample_interval)}; it is driven by the fold"
            " torque, damped, and tied to the membrane, which the prediction is not"
        )


def _sentence(remark: str) -> str:
    """A remark with a capital, unless it begins with a key of a design file, and a full stop."""
    first, _, rest = remark.partition(" ")
    start = first if "." in first else first[0].upper() + first[1:]
    return f"{start} {rest.rstrip('.')}."


def _table(title: str, *headings: str) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0), title=title, title_justify="left", show_header=any(headings))
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
