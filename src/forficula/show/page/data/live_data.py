"""Data of a run's structure for the engine in its page: its model, its protocol in steps, and values to change."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from forficula.analysis.advice import SHORTER_STEP
from forficula.analysis.verdict import ENDING_TEXTS
from forficula.design import Design, design_text, key_quantity, with_values
from forficula.dynamics import (
    Knob,
    Model,
    SteppedProtocol,
    compile_model,
    goal_in_units,
    knobs_of,
    portable_model,
    stepped_protocol,
    why_not_portable,
)
from forficula.dynamics.engine.closures import APART_TEXT
from forficula.names import listed
from forficula.quantities import READING_UNITS, Unit, show_quantity
from forficula.show.page.data.packed_arrays import PackedArrays
from forficula.show.page.parts.design_rows import key_meanings
from forficula.show.page.parts.run_sentences import LIVE_OUTCOME_TEXTS
from forficula.show.structure.labels import role_groups
from forficula.structure import (
    Measure,
    StageGoal,
    Structure,
    Transition,
    first_driven_stage,
    goal_of,
    measure_of,
    sums_of,
)

_MOST_STRENGTH = 3.0  # largest strength of a drive on its slider, as a multiple of the design's


def live_data(
    design: Design,
    shown: Sequence[Measure],
    anchors: Sequence[int],
    ranges: Mapping[str, tuple[float, float]] | None = None,
) -> dict[str, Any]:
    """Return the data with which the engine in a page simulates a design.

    Args:
        design: the design that ran, with its timestep.
        shown: measures in the order of the page's readings.
        anchors: indices of the points that are drawn, then of nodes of membranes, as in a `ShapeMesh`.
        ranges: lowest and highest values, SI, by the keys that a study varies.

    Returns:
        Data for JSON; only "refused", with the reason, if the engine would simulate the structure differently.
    """
    model = compile_model(design)
    if why := why_not_portable(model):
        return {"refused": why}
    arrays, protocol = PackedArrays(), stepped_protocol(model)
    candidates = [*_drive_knobs(model, protocol), *(_knob_data(model.design, knob) for knob in knobs_of(model))]
    knobs = [
        _widened(candidate, *(ranges or {}).get(candidate["key"], ()))
        for candidate in candidates
        if candidate is not None
    ]
    if missing := sorted(set(ranges or {}) - {knob["key"] for knob in knobs}):
        return {"refused": f"{listed(missing)} cannot be changed in a compiled model"}
    data = {
        **_model_data(model, arrays),
        **_structure_data(model, anchors),
        "readings": [_reading(model.structure, measure) for measure in shown],
        "protocol": _protocol_data(protocol),
        "course": _course_data(model),
        "texts": {
            "endings": ENDING_TEXTS,
            "apart": APART_TEXT,
            # without statics and an energy balance the page has less advice than a run
            "advice": {"diverged": SHORTER_STEP, "untrusted": SHORTER_STEP},
            "outcome": LIVE_OUTCOME_TEXTS,
            "reading_units": READING_UNITS,
        },
        "knobs": knobs,
        "design": {"name": design.name, "text": design_text(design)},
    }
    return data | {"arrays": arrays.text()}


def _model_data(model: Model, arrays: PackedArrays) -> dict[str, Any]:
    portable = portable_model(model)
    return {
        "source": portable.source,
        "numbers": {name: arrays.doubles(values) for name, values in portable.numbers.items()},
        "layout": {name: values.tolist() for name, values in portable.layout.items()},
        "options": {name: values.tolist() for name, values in portable.options.items()},
        "start": arrays.doubles(portable.start),
    }


def _structure_data(model: Model, anchors: Sequence[int]) -> dict[str, Any]:
    """Return the indices in the engine of hinges, motors, tendons and distances, and the points that are drawn."""
    structure, built = model.structure, model.in_units
    count, mesh = len(structure.points), model.mesh
    # index of the position of each degree of freedom of a joint
    positions = np.array(model.engine.jnt_qposadr)[model.engine.dof_jntid].tolist()
    bodies, places, names = [], [], []
    for number in anchors:
        if number < count:
            names.append(read_aloud(structure.points[number].name))
            bodies.append(int(model.carriers[number]))
            places += np.asarray(built.points[number].place).tolist()
        else:
            names.append(f"membrane {number - count}")
            bodies.append(int(model.engine.flex_vertbodyid[model.first_node + number - count]))
            places += np.asarray(mesh.places[number - count]).tolist()
    return {
        "units": {"length": model.units.length, "time": model.units.time, "energy": model.units.energy},
        "anchors": {"names": names, "bodies": bodies, "places": places},
        "hinges": {"positions": model.folds.joints.tolist(), "speeds": model.folds.speeds.tolist()}
        | {"senses": model.folds.senses.tolist()},
        "controls": model.motors.tolist(),
        "brakes": model.brakes.tolist(),
        "brakeWays": [
            {"control": control, "motor": int(model.brakes[control])}
            | {"way": [[dof, float(direction[dof]), positions[dof]] for dof in np.flatnonzero(direction).tolist()]}
            for control, direction in enumerate(model.jacobian)
            if model.brakes[control] >= 0
        ],
        "motors": [
            {"kind": motor.kind, "hinges": list(motor.hinges), "pushed": model.pushed[number].tolist()}
            for number, motor in enumerate(structure.motors)
        ],
        "tendons": {
            "numbers": model.tendons.tolist(),
            "points": [[int(model.sites[point]) for point in tendon.points] for tendon in structure.tendons],
            "springs": [_spring(model, number) for number in range(len(built.tendons))],
            "stiffness": [list(tendon.law.stiffness) for tendon in built.tendons],
        },
        "distances": model.distances.tolist(),
        "gaps": [*map(list, zip(model.gaps.tolist(), model.gap_lengths, strict=True))],
        "size": structure.span / model.units.length,
        "sums": [_reading(structure, measure)["parts"] for measure in sums_of(structure)],
    }


def _spring(model: Model, tendon: int) -> dict[str, Any] | None:
    """Return where the engine has the stiffness of a linear tendon that can go slack: a force divided by a width.

    None for other tendons.
    """
    law = model.in_units.tendons[tendon].law
    if not model.lets_go[tendon] or any(law.stiffness[1:]) or not law.stiffness[0]:
        return None
    engine = model.engine
    muscle = engine.actuator(f"{model.in_units.tendons[tendon].name}_spring0")
    force = float(muscle.biasprm[2])
    return {"at": int(muscle.id) * engine.actuator_biasprm.shape[1] + 2, "width": force / law.stiffness[0]}


def read_aloud(name: str) -> str:
    """Return the name of a point as it is read aloud: "facet1_vertex2" becomes "facet 1 vertex 2"."""
    return re.sub(r"(?<=[a-z])(?=[0-9])", " ", name.replace("_", " "))


def _reading(structure: Structure, measure: Measure) -> dict[str, Any]:
    """Return what a measure reads: sums of angles with their signs, or the index of a distance."""
    if measure.points is not None:
        apart = [measure.name for measure in structure.measures if measure.points is not None]
        return {"distance": apart.index(measure.name)}
    signs = dict(zip(measure.hinges, measure.signs, strict=True))
    parts = [[[hinge, signs[hinge]] for hinge in part] for part in measure.parts]
    return {"parts": parts, "groups": list(role_groups(structure, measure).values())}


def _protocol_data(protocol: SteppedProtocol) -> dict[str, Any]:
    return {
        "timestep": protocol.timestep,
        "explicit": protocol.explicit,
        "largestGap": protocol.largest_gap,
        "restSpeeds": protocol.rest_speeds.tolist(),
        "window": protocol.window,
        "stuck": protocol.stuck,
        "leastHold": protocol.least_hold,
        "interval": protocol.interval,
        "lowest": _bounds(protocol.lowest),
        "highest": _bounds(protocol.highest),
        "drives": [
            {
                "name": drive.drive.name,
                "key": drive.drive.key,
                "strength": drive.drive.strength,
                "torques": drive.torques.tolist(),
                "rise": drive.rise,
            }
            for drive in protocol.drives
        ],
        "stages": [
            {"name": stage.name, "drives": list(stage.drives), "hold": stage.hold, "limit": stage.limit}
            | _goal_data(stage.goal)
            for stage in protocol.stages
        ],
    }


def _course_data(model: Model) -> dict[str, Any]:
    """Return the states and transitions of the protocol, with their words."""
    structure = model.structure
    return {
        "stageStates": list(structure.stage_states),
        "states": [
            {"name": state.name, "missed": state.missed, "unknown": state.unknown}
            | {"bounds": _goal_data(_goal_named(model, state.goal))}
            for state in structure.states
        ],
        "transitions": [_transition_data(model, transition) for transition in structure.transitions],
    }


def _transition_data(model: Model, transition: Transition) -> dict[str, Any]:
    structure, words = model.structure, transition.wording
    measure = measure_of(structure, transition.measure)
    reading = None if measure is None else _reading(structure, measure) | {"groups": []}
    length = model.units.length
    # distances are in the model's units
    begun = transition.begun
    return {
        "name": transition.name,
        "drive": transition.drive,
        "stage": transition.stage,
        "begins": first_driven_stage(structure, model.design.protocol.stages, transition),
        "goal": transition.goal,
        "asked": _goal_data(_goal_named(model, transition.goal)),
        "state": transition.state,
        "released": _goal_data(_goal_named(model, transition.released)),
        "reading": reading,
        "furthest": transition.furthest,
        "kind": transition.kind,
        "begun": None if begun is None else begun / (length if transition.kind == "distance" else 1),
        "words": {name: getattr(words, name) for name in ("verb", "done", "doing", "stays", "did")},
    }


def _goal_named(model: Model, name: str) -> StageGoal:
    return goal_in_units(model, goal_of(model.structure, name))


def _goal_data(goal: StageGoal) -> dict[str, Any]:
    return {"until": goal.name, "kind": goal.kind, "least": _bounds(goal.least), "most": _bounds(goal.most)}


def _bounds(values: Any) -> list[float | None]:
    """Return bounds for JSON, which has no infinite numbers: None where there is no bound."""
    return [value if np.isfinite(value) else None for value in np.asarray(values, dtype=float).tolist()]


def _drive_knobs(model: Model, protocol: SteppedProtocol) -> list[dict[str, Any] | None]:
    """Return sliders for the strengths of the protocol's drives."""
    used = {number for stage in protocol.stages for number in stage.drives}
    sliders: list[dict[str, Any] | None] = []
    for number in sorted(used):
        driven = protocol.drives[number]
        strength, quantity = driven.drive.strength, key_quantity(driven.drive.key, type(model.design))
        if quantity is None or not strength:
            continue
        most = _MOST_STRENGTH * strength
        low, high = sorted((0.0, most))
        data = _slider(model.design, driven.drive.key, quantity.unit, strength, low, high)
        sliders.append(data and data | {"drive": number, "title": f"strength of {driven.drive.name}"})
    return sliders


def _knob_data(design: Design, knob: Knob) -> dict[str, Any] | None:
    data = _slider(design, knob.key, knob.unit, knob.value, knob.lowest, knob.highest)
    return data and data | {
        "changes": [
            {
                "field": change.field,
                "places": change.places.tolist(),
                "low": change.low.tolist(),
                "slopes": change.slopes.tolist(),
            }
            for change in knob.changes
        ]
    }


def _widened(knob: dict[str, Any], *ends: float) -> dict[str, Any]:
    """Widen a slider so that its range includes some values."""
    lowest, highest = min((knob["lowest"], *ends)), max((knob["highest"], *ends))
    further = lowest - knob["lowest"]
    changes = [
        change | {"low": [low + slope * further for low, slope in zip(change["low"], change["slopes"], strict=True)]}
        for change in knob.get("changes", [])
    ]
    return knob | {"lowest": lowest, "highest": highest} | ({"changes": changes} if changes else {})


def _slider(design: Design, key: str, unit: Unit, value: float, low: float, high: float) -> dict[str, Any] | None:
    """Return a slider over values of a key; None if the design file has no line for the key."""
    line = _line_of(design, key, low if value != low else high)
    if line is None:
        return None
    shown, factor = _display(unit, max(abs(low), abs(high)))
    return {
        "key": key,
        "title": dict(key_meanings(design)).get(key) or key,
        "unit": shown,
        "factor": factor,
        "value": value,
        "lowest": low,
        "highest": high,
        "line": line,
    }


def _display(unit: Unit, largest: float) -> tuple[str, float]:
    """Return the unit in which a design file writes a value, and its factor from SI."""
    number, _, name = show_quantity(largest or 1.0, unit, 17).partition(" ")
    return name, float(number) / (largest or 1.0)


def _line_of(design: Design, key: str, other: float) -> dict[str, Any] | None:
    """Return the line of a design file that contains a key's value: its index and the text before and after the value.

    None if there is no such line.
    """
    try:
        texts = [design_text(item).splitlines() for item in (design, with_values(design, {key: other}))]
    except ValueError:
        return None
    lines, changed_lines = ([line for line in text if not line.startswith("source = ")] for text in texts)
    if len(lines) != len(changed_lines):
        return None
    differing = [number for number, pair in enumerate(zip(lines, changed_lines, strict=True)) if pair[0] != pair[1]]
    if len(differing) != 1:
        return None
    line, twin = lines[differing[0]], changed_lines[differing[0]]
    same = next(place for place, letters in enumerate(zip(line, twin, strict=False)) if letters[0] != letters[1])
    before = line.rfind('"', 0, same)
    after = line.find('"', before + 1)
    if before < 0 or after < 0:
        return None
    return {"number": texts[0].index(line), "before": line[: before + 1], "after": line[after:]}
