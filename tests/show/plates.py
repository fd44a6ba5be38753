"""Plates in a row, built by hand: a structure without veins, for tests of everything that draws runs."""

from dataclasses import replace

import numpy as np

from forficula.analysis import Outcome, measure
from forficula.design import Design, Protocol, StageSection
from forficula.dynamics import Record, StageEnd
from forficula.material.law.tendon_law import TendonLaw
from forficula.pattern import CreasePattern
from forficula.structure import (
    GROUND,
    Appearance,
    Body,
    Drive,
    Hinge,
    Measure,
    Motor,
    Plate,
    Point,
    RestState,
    StageGoal,
    Structure,
    Tendon,
    Transition,
    Wording,
)

WIDTH, LENGTH = 0.1, 0.08  # m
# structures that tests draw, by description
PARTS = {
    "whole": {},
    "with a pattern": {"pattern": True},
    "without tendons": {"tendons": False},
    "without motors": {"motors": False},
    "unmeasured": {"measured": False},
}
# corners of each plate, in its own axes; the last one is not convex
CORNERS = (
    ((0.0, 0.0), (LENGTH, 0.0), (LENGTH, WIDTH), (0.0, WIDTH)),
    ((0.0, 0.0), (LENGTH, 0.0), (LENGTH, WIDTH), (0.0, WIDTH)),
    ((0.0, 0.0), (0.06, 0.0), (0.035, 0.05), (0.06, WIDTH), (0.0, WIDTH)),
)
LEAST, MOST = np.radians(-3.0), np.radians(175.0)


def plates_structure(*, tendons: bool = True, motors: bool = True, measured: bool = True, pattern: bool = False):
    """Return three plates in a row, without some of their parts, or with a crease pattern."""
    bodies = [
        Body(
            name=f"plate{number}",
            role="base" if number == 0 else "flap",
            parent=number - 1 if number else GROUND,
            position=np.array([LENGTH if number else 0.0, 0.0, 0.0]),
            frame=np.eye(3),
        )
        for number in range(3)
    ]
    points, plates = [], []
    for body, corners in enumerate(CORNERS):
        first = len(points)
        points += [
            Point(name=f"corner{body}.{number}", role="corner", body=body, place=np.array([*corner, 0.0]))
            for number, corner in enumerate(corners)
        ]
        numbers = tuple(range(first, len(points)))
        plates.append(Plate(body=body, points=numbers, thickness=1e-3, density=1270.0))
    points += [
        Point(name="near", role="attachment", body=0, place=np.array([0.04, 0.05, 0.0])),
        Point(name="far", role="attachment", body=1, place=np.array([0.04, 0.05, 0.0])),
    ]
    hinges = tuple(
        Hinge(
            name=f"hinge{body}",
            role="crease",
            body=body,
            axis=np.array([0.0, 1.0, 0.0]),
            sense=-1,
            lower=LEAST,
            upper=MOST,
            stiffness=2e-3,
            damping=5e-4,
            armature=1e-6,
            start=np.radians(-1.0),
            label=f"crease {body}",
        )
        for body in (1, 2)
    )
    law = TendonLaw(rest_length=0.03, stiffness=(50.0, 0.0, 0.0), damping=(0.02, 0.0, 0.0))
    built = Structure(
        name="three-plates",
        bodies=tuple(bodies),
        points=tuple(points),
        plates=tuple(plates),
        hinges=hinges,
        tendons=(Tendon(name="pull", role="tendon", points=(13, 14), law=law, longest=0.08),) if tendons else (),
        span=2 * LENGTH + 0.06,
        mass=0.05,
        appearance=Appearance(pattern=_pattern()) if pattern else Appearance(),
    )
    return _with_protocol(built, motors=motors, measured=measured)


def _pattern() -> CreasePattern:
    """Return the pattern of the plates, with a mountain and a valley between them."""
    outline = [(0.0, 0.0), (0.08, 0.0), (0.16, 0.0), (0.22, 0.0), (0.195, 0.05), (0.22, 0.1), (0.16, 0.1), (0.08, 0.1)]
    places = [(*place, 0.0) for place in [*outline, (0.0, 0.1)]]
    border = [(index, (index + 1) % 9) for index in range(9)]
    return CreasePattern(
        vertices_coords=np.array(places),
        edges_vertices=np.array([*border, (1, 7), (2, 6)]),
        edges_assignment=tuple("BBBBBBBBBMV"),
        edges_fold_angle=np.array([*[np.nan] * 9, -np.pi, np.pi]),
        faces_vertices=((0, 1, 7, 8), (1, 2, 6, 7), (2, 3, 4, 5, 6)),
    )


def _with_protocol(built: Structure, *, motors: bool, measured: bool) -> Structure:
    count = len(built.hinges) + measured

    def bounds(name, least=-np.inf, most=np.inf):
        low, high = np.full(count, -np.inf), np.full(count, np.inf)
        low[0], high[0] = least, most
        return StageGoal(name=name, kind="bounds", least=low, most=high)

    closed, opened = bounds("closed", least=np.radians(120)), bounds("open", most=0.0)
    measures = (
        Measure(name="fold_angle", kind="angle", hinges=(0, 1), signs=(1, 1), label="fold angle"),
        Measure(name="mouth", kind="distance", points=(0, 11), label="mouth"),
    )
    words = {
        "close": Wording(
            done="closed", verb="close", doing="closing", stays="closed", time="closing time", noun="closing"
        ),
        "open": Wording(done="closed and opened", verb="open", doing="opening", stays="open", time="opening time",
                        noun="opening", did="opened again"),
    }  # fmt: skip
    ways = (("close", 1, closed, "smallest"), ("open", 3, opened, "largest"))
    return replace(
        built,
        motors=(Motor(name="crease", hinges=(0, 1)),) if motors else (),
        drives=tuple(
            Drive(name=name, shares=(share,), rise=0.0, key=f"drive.{name}", strength=torque, where="on a crease")
            for name, share, torque in (("close", 1.0, 0.06), ("open", -1.0, 0.2))
        )
        if motors
        else (),
        measures=measures if measured else (),
        goals=(closed, opened),
        states=(
            RestState(name="flat", goal="open", missed="not flat", unknown="not flat"),
            RestState(name="closed", goal="closed", missed="not closed", unknown="after closing"),
            RestState(name="open", goal="open", missed="not open", unknown="after opening"),
        ),
        stage_states=("flat", "", "closed", "", "open"),
        transitions=tuple(
            Transition(
                name=name,
                drive=name,
                stage=stage,
                goal=goal.name,
                state=goal.name,
                released=goal.name,
                measure="fold_angle",
                furthest=furthest,
                begun=None,
                wording=words[name],
            )
            for name, stage, goal, furthest in ways
        )
        if motors and measured
        else (),
    )


STAGES = (
    ("settle", "none", "time", 0.05),
    ("close", "close", "closed", 0.08),
    ("release closed", "none", "rest", 0.2),
    ("open", "open", "open", 0.05),
    ("release open", "none", "rest", 0.2),
)
FLAT, SHUT = np.radians(-3.0), np.radians((172.0, 160.0))


def plates_design(*, motors: bool = True) -> Design:
    """Return the protocol: the plates settle, close, rest, open and rest."""
    stages = [
        StageSection(name=name, drive=drive, until=until, hold="0 s", time_limit=f"{10 * limit} s")
        for name, drive, until, limit in STAGES[: 5 if motors else 1]
    ]
    protocol = Protocol(
        timestep="0.1 ms",
        sample_interval="1 ms",
        rest_speed="20 deg/s",
        window="20 ms",
        gravity="0 m/s^2",
        contact=False,
        stages=stages,
    )
    return Design(name="three-plates", source="made up", protocol=protocol)


def plates_run(*, motors: bool = True, **parts: bool) -> tuple[Record, Outcome]:
    """Return a run of the plates as from a simulation, with angles that follow a formula."""
    structure, design = plates_structure(motors=motors, **parts), plates_design(motors=motors)
    lasts = [limit for *_, limit in STAGES[: len(design.protocol.stages)]]
    ends = np.round(np.cumsum(lasts), 9)
    time = np.round(np.arange(0, ends[-1] + 5e-4, 1e-3), 9)
    angles = _angles(time, ends)
    places = _places(structure, angles)
    lengths = np.zeros((len(time), len(structure.tendons)))
    for number, tendon in enumerate(structure.tendons):
        one, other = tendon.points
        lengths[:, number] = np.linalg.norm(places[:, one] - places[:, other], axis=1)
    tendon_energy = 25.0 * np.maximum(lengths - 0.03, 0) ** 2
    hinge_energy = 1e-3 * angles**2
    rates = np.gradient(angles, time, axis=0)
    stored = tendon_energy.sum(axis=1) + hinge_energy.sum(axis=1)
    damped = -5e-4 * np.concatenate([[0], np.cumsum((rates**2).sum(axis=1)[1:] * np.diff(time))])
    stop_work = -2e-3 * np.concatenate([[0], np.cumsum(np.abs(np.diff(angles.sum(axis=1))))])
    work = stored - stored[0] - damped - stop_work
    count = len(structure.motors)
    series = {
        "hinge_angle": angles,
        "tendon_length": lengths,
        "tendon_energy": tendon_energy,
        "hinge_energy": hinge_energy,
        "membrane_energy": np.zeros(len(time)),
        "kinetic_energy": 5e-6 * (rates**2).sum(axis=1),
        "gravitational_energy": np.zeros(len(time)),
        "motor_power": np.zeros((len(time), count)),
        "motor_work": np.repeat(work[:, np.newaxis], count, axis=1),
        "hinge_damping_work": damped if count else -(stored - stored[0]),
        "elastic_damping_work": np.zeros(len(time)),
        "stop_work": stop_work if count else np.zeros(len(time)),
        "point_position": places,
        "membrane_position": np.zeros((len(time), 0, 3)),
    }
    if any(measure.points for measure in structure.measures):
        series["distance"] = np.linalg.norm(places[:, 0] - places[:, 11], axis=1)[:, np.newaxis]
    stages = tuple(
        StageEnd(
            stage=stage,
            start=float(start),
            end=float(end),
            goal_time=None if stage.until == "time" else float(end - 0.2 * last),
            at_rest=True,
            at_goal=True,
        )
        for stage, start, end, last in zip(design.protocol.stages, [0.0, *ends], ends, lasts, strict=False)
    )
    record = Record(design=design, structure=structure, time=time, series=series, stages=stages, diverged_at=None)
    return record, measure(record)


def _angles(time, ends):
    """Return angles from flat to shut and back, with a decaying bounce, rad, (time, hinge)."""
    angles = np.full((len(time), 2), FLAT)
    for start, way, swing in zip(ends[0::2], (1.0, -1.0), (-0.2, 0.05), strict=False):
        since = np.maximum(time - start, 0)
        share = np.clip(since / 0.05, 0, 1) ** 2
        bounce = np.where(
            since > 0.05, swing * np.exp(-(since - 0.05) / 0.02) * np.sin(2 * np.pi * (since - 0.05) / 0.03), 0
        )
        angles += (way * share[:, np.newaxis]) * (SHUT - FLAT) + bounce[:, np.newaxis] * [1.0, 0.6]
    return angles


def _places(structure, angles):
    """Return the positions of the points, m, (time, point, 3): each plate is turned about its side."""
    places = np.zeros((len(angles), len(structure.points), 3))
    origins, turn = np.zeros((len(angles), 3)), np.zeros(len(angles))
    for body in range(3):
        if body:
            origins = origins + LENGTH * np.column_stack([np.cos(turn), np.zeros(len(turn)), np.sin(turn)])
            turn = turn + angles[:, body - 1]
        for number, point in enumerate(structure.points):
            if point.body == body:
                x, y, _ = point.place
                places[:, number] = origins + np.column_stack(
                    [x * np.cos(turn), np.full(len(turn), y), x * np.sin(turn)]
                )
    return places
