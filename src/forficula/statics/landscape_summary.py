"""An energy landscape in the form of `landscape.json`."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.quantities import Unit
from forficula.serial import Joules, Metres, NewtonMetres, Newtons, WithUnit, Written, plain
from forficula.statics.friction import FrictionBand
from forficula.statics.landscape import (
    EnergyLandscape,
    LeastTorque,
    NetSurvey,
    Rest,
    fold_states,
    net_courses,
    net_states,
)
from forficula.statics.net.driven.driven_net import prescribes_displacement
from forficula.statics.net.driven.net_course import Course, drive_displacement, reaction
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_of import point_positions
from forficula.statics.net.net_state import Mobility, NetState
from forficula.statics.net.path_increment import PathPoint
from forficula.statics.tree.fold_path import FoldPath, rigid_fold
from forficula.statics.tree.hinge_landscape import HingeLandscape
from forficula.statics.tree.inertial_help import InertialHelp
from forficula.statics.tree.partial_folds import PartialFold
from forficula.statics.tree.tip_stiffness import TipStiffness
from forficula.structure import Structure, drive_unit, driven_motor


@dataclass(frozen=True, kw_only=True)
class StableSummary:
    """A stable state on an energy curve. A neutral state is a range that ends at its far angle.

    Attributes:
        others: name and angles.
        kind: "stop", "minimum" or "neutral".
        energy: J.
        holding_torque: torque that presses the structure onto a stop, N m.
    """

    others: Annotated[Mapping[str, WithUnit | str], Written.BESIDE]
    kind: str
    energy: Joules
    holding_torque: NewtonMetres | None


@dataclass(frozen=True, kw_only=True)
class CurveSummary:
    """Energy over an angle, with stable states and the torques that they withstand.

    Attributes:
        energy: J.
        moment: N m.
        stable_states: in order of the angle.
        barrier: from the first stable state to the top, J.
        others: angles, parts of the energy, torques and times by name.
    """

    energy: Annotated[Array, Unit("J")]
    moment: Annotated[Array, Unit("N m")]
    stable_states: Sequence[StableSummary]
    barrier: Joules | None
    others: Annotated[Mapping[str, WithUnit | Sequence[str] | Sequence[Mapping[str, WithUnit]]], Written.BESIDE]


@dataclass(frozen=True, kw_only=True)
class TendonCurve:
    """A hinge that one tendon lies across, about its true axis.

    Attributes:
        tendon: name.
        hinge: name.
        curve: of the hinge.
    """

    tendon: str
    hinge: str
    curve: Annotated[CurveSummary, Written.BESIDE]


@dataclass(frozen=True, kw_only=True)
class LandscapeSummary:
    """The energy landscape of a design.

    Attributes:
        design: name of the design.
        hinge: the first hinge with both bars perpendicular to its axis; null without such a hinge.
        tendons: every hinge that one tendon lies across.
        wing: the structure along its fold; null without a single folding path.
        levels: energies with none to all of the independent hinges folded, J.
        partial_folds: resting shapes after release with some hinges folded.
        rests: where the structure rests without drives.
        least_torques: least slowly growing torque of every transition of a torque, N m.
        least_torque_ranges: least and largest of these torques for slightly shifted structures, N m.
        least_forces: least slowly growing force of every transition of a force, N.
        withstood_forces: force at which a structure leaves the goal at which it is before the transition, N.
        inertial_help: a snap after which inertia may make a transition with less than the least slow torque.
        tips: stiffness of the tips.
        remarks: sentences on missing results and on limits of the others.
        friction_bands: angles at which dry friction holds single hinges in the stable states.
        saddles: of a tree without a single folding path, between states that its protocol reaches one after another.
        net: states, saddles and courses of sliding points and of plates in loops.
        design_hash: hash of all values of the design.
        simulation: snap of one hinge in a run, beside its prediction; null without a run.
        rests_apart: largest difference of distances between points in the states of the run and of statics, m.
        versions: of the packages that computed the landscape.
        figures: names of the figures in the folder.
    """

    design: str
    hinge: CurveSummary | None
    tendons: Sequence[TendonCurve]
    wing: CurveSummary | None
    levels: Annotated[Array | None, Unit("J")]
    partial_folds: Sequence[PartialFold]
    rests: Sequence[Rest]
    least_torques: Mapping[str, NewtonMetres | None]
    least_torque_ranges: Mapping[str, tuple[NewtonMetres, NewtonMetres]]
    least_forces: Annotated[Mapping[str, Newtons | None] | None, Written.IF_KNOWN]
    withstood_forces: Annotated[Mapping[str, Newtons | None] | None, Written.IF_KNOWN]
    inertial_help: Mapping[str, InertialHelp | None]
    tips: TipStiffness | None
    remarks: Sequence[str]
    friction_bands: Annotated[Sequence[FrictionBand] | None, Written.IF_KNOWN]
    saddles: Annotated[Sequence[Mapping[str, Any]] | None, Written.IF_KNOWN]
    net: Annotated[Mapping[str, Any] | None, Written.IF_KNOWN]
    design_hash: str
    simulation: Mapping[str, Any] | None = None
    rests_apart: Annotated[Mapping[str, Metres | None] | None, Written.IF_KNOWN] = None
    versions: Annotated[Mapping[str, str] | None, Written.IF_KNOWN] = None
    figures: Annotated[Sequence[str] | None, Written.IF_KNOWN] = None


def landscape_summary(landscape: EnergyLandscape) -> dict[str, Any]:
    """Return a landscape as plain data in the form of `landscape.json`."""
    structure, hinge, path = landscape.structure, landscape.hinge, landscape.fold_path
    courses = [course for course in landscape.courses if isinstance(course, LeastTorque)]
    torques, forces = ([course for course in courses if (course.unit == "N") == force] for force in (False, True))
    content = LandscapeSummary(
        design=landscape.design.name,
        hinge=None if hinge is None else _hinge(hinge),
        tendons=[
            TendonCurve(
                tendon=structure.tendons[hinge_law.tendon].name,
                hinge=structure.hinges[hinge_law.hinge].name,
                curve=_hinge(hinge_law.actual),
            )
            for hinge_law in landscape.hinges
        ],
        wing=None if path is None else _fold(landscape, path),
        levels=landscape.levels,
        partial_folds=landscape.partial_folds,
        rests=landscape.rests,
        least_torques=landscape.least_torques,
        least_torque_ranges={torque.name: torque.span for torque in torques if torque.span is not None},
        least_forces=landscape.least_forces or None,
        withstood_forces={force.name: force.withstood for force in forces if force.least == 0} or None,
        inertial_help={torque.name: torque.inertial_help for torque in torques},
        tips=landscape.tips,
        remarks=landscape.remarks,
        friction_bands=landscape.friction_bands or None,
        saddles=_tree_saddles(landscape) or None,
        net=None if landscape.net is None else _net(landscape, landscape.net),
        design_hash=landscape.design.hash,
    )
    written: dict[str, Any] = plain(content)
    return written


def _hinge(hinge: HingeLandscape) -> CurveSummary:
    """Return a hinge with its angles and moments in its own sense."""

    def in_own_sense(angle: ArrayLike | None) -> WithUnit:
        # subtract from 0, so that 0 does not become -0
        return WithUnit(angle if hinge.sense > 0 or angle is None else 0.0 - np.asarray(angle), "rad")

    peak = hinge.peak_opening
    spring = {
        "spring_energy": WithUnit(hinge.spring_energy, "J"),
        "spring_moment": WithUnit(hinge.sense * hinge.spring_moment, "N m"),
    }
    return CurveSummary(
        energy=hinge.energy,
        moment=hinge.sense * hinge.moment,
        stable_states=[
            StableSummary(
                others={"angle": in_own_sense(state.angle), "far_angle": in_own_sense(state.far_angle)},
                kind=state.kind,
                energy=state.energy,
                holding_torque=state.holding_torque,
            )
            for state in hinge.states
        ],
        barrier=hinge.barrier,
        others={
            "angle": in_own_sense(hinge.angle),
            **(spring if hinge.spring is not None else {}),
            "barrier_angle": in_own_sense(hinge.barrier_angle),
            "holding_torque": WithUnit(hinge.holding_torque, "N m"),
            "peak_opening_torque": WithUnit(None if peak is None else peak.torque, "N m"),
            "peak_opening_angle": in_own_sense(None if peak is None else peak.angle),
            "slack_angle": in_own_sense(hinge.slack_angle),
            "time_scale": WithUnit(hinge.time_scale, "s"),
            "growth_rate": WithUnit(hinge.growth_rate, "1/s"),
            "fold_start": WithUnit(hinge.fold_start, "rad"),
            "fold_time": WithUnit(hinge.fold_time, "s"),
            "final_speed": WithUnit(hinge.final_speed, "rad/s"),
            "inertia": WithUnit(hinge.hinge.inertia, "kg m^2"),
            "remarks": hinge.remarks,
        },
    )


def _fold(landscape: EnergyLandscape, path: FoldPath) -> CurveSummary:
    """Return a structure along its fold."""
    states, first = fold_states(landscape), rigid_fold(landscape.structure).start
    holding = next((state.holding_torque for state in states if state.name == first), None)
    torques = {
        "holding_torque": holding,
        "path_fold_torque": path.fold_torque,
        "path_unfold_torque": path.unfold_torque,
        **{f"least_{name}_torque": torque for name, torque in landscape.least_torques.items()},
    }
    return CurveSummary(
        energy=path.energy,
        moment=path.moment,
        stable_states=[
            StableSummary(
                others={
                    "name": state.name,
                    "pleat_angle": WithUnit(state.pleat_angle, "rad"),
                    "far_pleat_angle": WithUnit(state.far_pleat_angle, "rad"),
                    "ring_angle": WithUnit(state.ring_angle, "rad"),
                },
                kind=state.kind,
                energy=state.energy,
                holding_torque=state.holding_torque,
            )
            for state in states
        ],
        barrier=landscape.fold_barrier,
        others={
            "pleat_angle": WithUnit(path.pleat_angle, "rad"),
            "ring_angle": WithUnit(path.ring_angle, "rad"),
            "tendon_energy": WithUnit(path.tendon_energy, "J"),
            "membrane_energy": WithUnit(path.sheet_energy, "J"),
            "saddles": [
                {"pleat_angle": WithUnit(state.coordinate, "rad"), "energy": WithUnit(state.energy, "J")}
                for state in path.states
                if not state.stable
            ],
            "single_hinge_barriers": WithUnit(landscape.hinge_barriers if landscape.rests[0].within else None, "J"),
            "opening_barrier": WithUnit(landscape.unfold_barrier, "J"),
            **{name: WithUnit(torque, "N m") for name, torque in torques.items()},
        },
    )


def _tree_saddles(landscape: EnergyLandscape) -> list[dict[str, Any]]:
    return [
        {
            "between": [landscape.states[end].name for end in saddle.ends],
            "energy": WithUnit(saddle.energy, "J"),
            "barriers": WithUnit(saddle.barriers, "J"),
            "angles": WithUnit(saddle.angles, "rad"),
        }
        for saddle in landscape.passes
        if saddle.angles is not None
    ]


def _net(landscape: EnergyLandscape, survey: NetSurvey) -> dict[str, Any]:
    structure, net, states = landscape.structure, survey.net, net_states(landscape)
    search = survey.search
    return {
        "search": {
            "seed": search.seed,
            "tries": search.tries,
            "found": len(search.states),
            "failed": search.failed,
        },
        "as_built": _mobility(survey.built),
        "states": [_net_state(structure, net, state) for state in states],
        "saddles": [
            {
                "between": [states[end].name for end in saddle.ends],
                "energy": WithUnit(saddle.energy, "J"),
                "barriers": WithUnit(saddle.barriers, "J"),
                **({} if saddle.shape is None else {"positions": _points(structure, net, saddle.shape)}),
            }
            for saddle in landscape.passes
        ],
        "courses": [_course(structure, net, course) for course in net_courses(landscape)],
    }


def _net_state(structure: Structure, net: Net, state: NetState) -> dict[str, Any]:
    kinds = {measure.name: measure.kind for measure in structure.measures}
    return {
        "name": state.name,
        "energy": WithUnit(state.energy, "J"),
        "stored": WithUnit(state.stored, "J"),
        "readings": {
            name: WithUnit(values, "rad" if kinds[name] == "angle" else "m") for name, values in state.readings.items()
        },
        "frequencies": WithUnit(state.frequencies, "Hz"),
        **_mobility(state.mobility),
        "largest_bar_strain": state.strain,
        "largest_stress": WithUnit(state.stress, "Pa"),
        "largest_tendon_extension": state.extension,
        "withstands": [
            {"load": withstood.load, "up_to": WithUnit(withstood.value, withstood.unit), "lost_by": withstood.kind}
            for withstood in state.withstands
        ],
        "panels_pass_through": state.passing,
        **({"contacts": WithUnit(state.contacts, "N")} if structure.has_contacts else {}),
        "found": state.hits,
        "positions": _points(structure, net, state.rest.shape),
    }


def _points(structure: Structure, net: Net, shape: NetShape) -> WithUnit:
    return WithUnit(point_positions(net, shape)[: len(structure.points)], "m")


def _mobility(mobility: Mobility | None) -> dict[str, int | None]:
    return {
        "degrees_of_freedom": None if mobility is None else mobility.degrees_of_freedom,
        "self_stresses": None if mobility is None else mobility.self_stresses,
    }


def _course(structure: Structure, net: Net, course: Course) -> dict[str, Any]:
    drive = course.drive
    unit, size = drive_unit(structure, drive), abs(drive.strength)
    shown, size = ("deg", math.degrees(size)) if unit == "rad" else (unit, size)
    along = "rad" if driven_motor(structure, drive).direction is None else "m"

    def path(points: Sequence[PathPoint]) -> dict[str, Any]:
        forces = [
            reaction(structure, net, drive, point.shape)
            for point in points
            if prescribes_displacement(structure, drive)
        ]
        return {
            "drive": WithUnit([size * point.factor for point in points], shown),
            "gone": WithUnit([drive_displacement(structure, net, drive, point.shape) for point in points], along),
            **({"force": WithUnit(forces, "N")} if forces else {}),
            "energy": WithUnit([point.energy for point in points], "J"),
            "ways_downhill": [point.index for point in points],
        }

    touches = [
        {"parts": list(touch.parts), "drive": WithUnit(size * touch.point.factor, shown)} for touch in course.touches
    ]
    return {
        "name": course.name,
        "drive": drive.name,
        "least": WithUnit(course.least, unit),
        **({} if course.largest_force is None else {"largest_force": WithUnit(course.largest_force, "N")}),
        "ended": course.slow.ended,
        "slow": path(course.slow.points),
        "snaps": [
            {"kind": snap.kind, "drive": WithUnit(size * snap.factor, shown), "released": WithUnit(snap.released, "J")}
            for snap in course.slow.snaps
        ],
        **({"touches": touches} if structure.has_contacts else {}),
        "equilibria": None if course.through is None else path(course.through.points),
        "rests_at": WithUnit(course.rest.energy, "J"),
    }
