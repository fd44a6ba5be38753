"""Energy over an angle as data, with the positions of a run or of a path: plots that the page's script draws."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import scipy

from forficula.analysis.simulated_snap import inner_hinge
from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.quantities import reading_unit
from forficula.show.landscape.landscape_marks import hinge_measure
from forficula.show.landscape.tendon_figure import WIDEST, tendon_curves
from forficula.show.page.data.packing import packed
from forficula.show.page.parts.run_sentences import readable
from forficula.show.run.energies_figure import stored_energies
from forficula.show.structure.labels import label_of, parts_of, title_of
from forficula.statics import EnergyLandscape, HingeLandscape
from forficula.statics.landscape import fold_states
from forficula.statics.net.net_of import is_net
from forficula.statics.tree.ensemble import ensemble
from forficula.statics.tree.potential import stored_energy
from forficula.structure import Structure

_PLACES = 721  # points of a line
_SAME = 1e-9  # rad
# sentences on the balls of a curve, by what moves
_TENDON_BALLS = {
    "run": " The balls show the energy of every tendon at its hinge's angle in the run; dots are frames.",
    "fold": " The balls show the energy of every tendon at its hinge's angle on the path.",
}
_FOLD_BALL = {
    "run": " The ball shows the energy of the same parts in the run, with inertia and flexible panels.",
    "fold": " The ball shows the energy of the same parts on the path.",
}
_MOVING = ("kinetic", "Maxwell branches")  # energies that are zero at rest, so statics does not have them


@dataclass(frozen=True, kw_only=True)
class EnergyLine:
    """Energies over an angle: a line, or the positions of a run by frame.

    Attributes:
        name: name in the legend.
        angle: rad, (place,).
        energy: J, (place,).
    """

    name: str
    angle: Array
    energy: Array


@dataclass(frozen=True, kw_only=True)
class Travel:
    """Positions of a structure, in time or along a path, on the curves of its landscape.

    Attributes:
        noun: what moves, in the legend: "run" or "fold".
        angles: of all hinges, in their own senses, rad, (frame, hinge).
        tendon_energy: J, (frame, tendon).
        hinge_energy: energy of the springs of hinges, J, (frame, hinge).
        energy: stored energy of all parts, with the zero of statics, J, (frame,).
    """

    noun: str
    angles: Array
    tendon_energy: Array
    hinge_energy: Array
    energy: Array


@dataclass(frozen=True, kw_only=True)
class EnergyPlot:
    """Plot of energy over an angle, in the structure's own sense of the angle.

    Attributes:
        title: quantity of the vertical axis.
        axis: quantity of the horizontal axis.
        lines: energies computed by statics.
        marks: stable states with their names, each at an angle or over the range of angles at which it rests.
        balls: angles and energies over the frames of a run or path; empty without one.
        noun: what the balls show, as in `Travel`; empty without balls.
        top: range of angles around a barrier to show enlarged, rad; None if no enlargement is needed.
        text: sentences that describe the plot.
        hinge: index of the hinge whose angle is the horizontal axis; None for the mean of the folding hinges.
    """

    title: str
    axis: str
    lines: tuple[EnergyLine, ...]
    marks: tuple[EnergyLine, ...]
    balls: tuple[EnergyLine, ...]
    top: tuple[float, float] | None
    text: str
    hinge: int | None = None
    noun: str = ""


def landscape_curves(
    landscape: EnergyLandscape, travel: Travel | None = None, tendon: int | None = None
) -> list[EnergyPlot]:
    """Return the energy curves of a landscape: of a tendon and its hinge, and of the structure along its fold.

    Args:
        landscape: the landscape.
        travel: positions of the same structure, which balls show.
        tendon: index of the tendon shown as an example; an inner one by default.
    """
    curves = (_of_tendons(landscape, travel, tendon), _along_fold(landscape, travel))
    return [curve for curve in curves if curve is not None]


def run_travel(record: Record, time: Array | None = None) -> Travel:
    """Return the positions of a run.

    Args:
        record: the run.
        time: times of the record's rows that are shown, s, (frame,); all rows by default.
    """
    rows = np.arange(len(record.time)) if time is None else np.searchsorted(record.time, time)
    angles = record.series["hinge_angle"][rows]
    stored = [values[rows] for name, (values, _) in stored_energies(record).items() if name not in _MOVING]
    return Travel(
        noun="run",
        angles=angles,
        tendon_energy=record.series["tendon_energy"][rows],
        hinge_energy=record.series["hinge_energy"][rows] if "hinge_energy" in record.series else np.zeros_like(angles),
        energy=np.sum([np.zeros(len(rows)), *stored], axis=0) + _weight_zero(record),
    )


def posed_travel(structure: Structure, angles: Array, positions: Array, energy: Array) -> Travel:
    """Return the positions of a structure along a path.

    Args:
        structure: the structure.
        angles: of all hinges, in their own senses, rad, (pose, hinge).
        positions: of its points, m, (pose, point, 3).
        energy: stored energy of all parts, J, (pose,).
    """
    stiffness, rest, quadratic, cubic = (
        np.array([getattr(hinge, key) for hinge in structure.hinges])
        for key in ("stiffness", "rest_angle", "quadratic", "cubic")
    )
    turned = angles - rest
    return Travel(
        noun="fold",
        angles=angles,
        tendon_energy=tendon_energies(structure, positions),
        hinge_energy=stiffness / 2 * turned**2 + turned**3 * (quadratic / 3 + turned * cubic / 4),
        energy=energy,
    )


def tendon_energies(structure: Structure, positions: Array) -> Array:
    """Return the energies of the tendons, J, (pose, tendon), from the positions of points, m, (pose, point, 3)."""
    energies = [
        tendon.law.elastic.energy(
            np.linalg.norm(positions[:, tendon.points[1]] - positions[:, tendon.points[0]], axis=1)
        )
        for tendon in structure.tendons
    ]
    return np.array(energies).reshape(len(energies), len(positions)).T


def curve_data(curve: EnergyPlot) -> dict[str, Any]:
    """Return a curve as data for JSON, in degrees and in one unit of energy."""
    unit, factor = reading_unit("J", max(float(line.energy.max()) for line in curve.lines))

    def course(line: EnergyLine) -> dict[str, Any]:
        places, values = packed(np.degrees(line.angle), "f4"), packed(factor * line.energy, "f4")
        return {"name": line.name, "places": places, "values": values}

    first = curve.lines[0]
    return {
        "title": curve.title,
        "unit": unit,
        "axis": curve.axis,
        # as in figures, the axis runs from the start to the folded state
        "backwards": bool(first.angle[-1] < first.angle[0]),
        "lines": [course(line) for line in curve.lines],
        "marks": [course(mark) for mark in curve.marks],
        "balls": [course(ball) for ball in curve.balls],
        "along": curve.noun,
        "top": None if curve.top is None else sorted(np.degrees(curve.top).tolist()),
        "text": curve.text,
    }


def _of_tendons(landscape: EnergyLandscape, travel: Travel | None, tendon: int | None) -> EnergyPlot | None:
    """Return the energy of one tendon and its hinge; with a ball for every tendon that has the same curve."""
    shown, structure = inner_hinge(landscape, tendon), landscape.structure
    if shown is None:
        return None
    actual, title = shown.actual, title_of(hinge_measure(structure, shown.hinge))
    *drawn, last = tendon_curves(landscape, shown)
    ideal = drawn[:1] if shown.ideal is not None and drawn else []
    # the curve of the hinge comes first: with a spring it is the sum of both, which is last in the list
    drawn = [last, *drawn[len(ideal) :]] if actual.spring is not None else [*drawn[len(ideal) :], last]
    drawn += ideal
    names = parts_of([label_of(structure.tendons[hinge.tendon]) for hinge in landscape.hinges]).names
    balls = []
    for name, crossed in zip(names, landscape.hinges, strict=True):
        if travel is None or not _has_same_curve(crossed.actual, actual):
            continue
        energy = travel.tendon_energy[:, crossed.tendon]
        if actual.spring is not None:
            energy = energy + travel.hinge_energy[:, crossed.hinge]
        balls.append(EnergyLine(name=name, angle=travel.angles[:, crossed.hinge], energy=energy))
    barrier, top = "", None
    if actual.barrier is not None and actual.barrier_angle is not None:
        start, reach = actual.hinge.overbend, actual.hinge.overbend - actual.barrier_angle
        barrier = f" The barrier is {readable(actual.barrier, 'J')}."
        if reach < WIDEST:
            top = (
                actual.sense * (start + 0.15 * reach),
                actual.sense * max(start - 2.5 * reach, -actual.hinge.fold_limit),
            )
    lines = [_smooth(name, hinge, energy, moment) for hinge, energy, moment, name, _ in drawn]
    sprung = actual.spring is not None
    return EnergyPlot(
        title="tendon and spring of one hinge" if sprung else "energy of one tendon",
        axis=title,
        lines=tuple(lines),
        marks=tuple(
            _mark("", (actual.sense * state.angle, actual.sense * state.far_angle), state.energy, lines[0])
            for state in actual.states
        ),
        balls=tuple(balls),
        top=top,
        text=f"Energy over the {title} of one hinge, from statics.{barrier}"
        + ("" if travel is None else _TENDON_BALLS[travel.noun] * bool(balls)),
        hinge=shown.hinge,
        noun="" if travel is None else travel.noun,
    )


def _smooth(name: str, hinge: HingeLandscape, energy: Array, moment: Array) -> EnergyLine:
    """Interpolate a line at enough angles for a barrier a few degrees wide to look smooth; the moment is its slope."""
    rising = hinge.angle[::-1]
    angle = np.unique(np.concatenate([rising, np.linspace(rising[0], rising[-1], _PLACES)]))[::-1]
    spline = scipy.interpolate.CubicHermiteSpline(rising, energy[::-1], -moment[::-1])
    return EnergyLine(name=name, angle=hinge.sense * angle, energy=spline(angle))


def _has_same_curve(hinge: HingeLandscape, actual: HingeLandscape) -> bool:
    """Return whether two hinges have the same energy curve."""
    if hinge.spring is None or actual.spring is None:
        return hinge.sense == actual.sense and hinge.spring is actual.spring
    both = actual.stored_energy(actual.angle), hinge.stored_energy(actual.angle)
    return hinge.sense == actual.sense and bool(np.allclose(*both, rtol=0, atol=1e-6 * float(both[0].max())))


def _along_fold(landscape: EnergyLandscape, travel: Travel | None) -> EnergyPlot | None:
    """Return the stored energy along the rigid fold over the mean angle of the folding hinges."""
    path, structure, fold = landscape.fold_path, landscape.structure, landscape.structure.rigid_fold
    if path is None or fold is None:
        return None
    folds = bool(np.any(path.ring_angle))
    axis = f"mean {title_of(hinge_measure(structure, fold.folds[0]))}" if folds else "mean pleat angle"
    balls: tuple[EnergyLine, ...] = ()
    if travel is not None:
        angles = travel.angles
        angle = angles[:, list(fold.folds)].mean(axis=1) if folds else 2 * angles[:, list(fold.turns)].mean(axis=1)
        balls = (EnergyLine(name="", angle=angle, energy=travel.energy),)
    along = -path.ring_angle if folds else path.pleat_angle
    line = EnergyLine(name="rigid panels, quasi-static", angle=path.pleat_angle, energy=path.energy)
    states = [
        _mark(state.name, (state.pleat_angle, state.far_pleat_angle), state.energy, line)
        for state in fold_states(landscape)
    ]
    line, *states = (replace(state, angle=np.interp(state.angle, path.pleat_angle, along)) for state in (line, *states))
    stable = ", ".join(f"{state.name} {readable(float(state.energy[0]), 'J')}" for state in states)
    whole = structure.appearance.whole
    return EnergyPlot(
        title=f"energy of the {whole} along its fold",
        axis=axis,
        lines=(line,),
        marks=tuple(states),
        balls=balls,
        top=None,
        text=f"Energy stored by the {whole} along the only fold of its rigid panels; stable: {stable or 'none'}."
        + ("" if travel is None else _FOLD_BALL[travel.noun]),
        noun="" if travel is None else travel.noun,
    )


def _weight_zero(record: Record) -> float:
    """Return the difference between the reference levels of gravitational energy in a run and in statics, J.

    Both are 0 at the origin where statics solve a structure as a net.
    """
    if not record.structure.gravity or is_net(record.structure):
        return 0.0
    first = stored_energy(ensemble([record.structure]), record.series["hinge_angle"][:1]).get("weight", np.zeros(1))
    return float(first[0] - record.series["gravitational_energy"][0])


def _mark(name: str, ends: tuple[float, float], energy: float, line: EnergyLine) -> EnergyLine:
    """Return the mark of a stable state: a point, or the part of a line along which the structure rests."""
    low, high = sorted(ends)
    between = (line.angle >= low - _SAME) & (line.angle <= high + _SAME)
    if high - low <= _SAME:
        return EnergyLine(name=name, angle=np.array([low]), energy=np.array([energy]))
    return EnergyLine(name=name, angle=line.angle[between], energy=line.energy[between])
