"""Curves of energy over an angle as data, and where a run is on them: what the page's script draws."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import scipy
from numpy.typing import NDArray

from forficula.analysis.simulated_snap import inner_hinge
from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.quantities import reading_unit
from forficula.show.landscape.landscape_marks import hinge_measure
from forficula.show.landscape.tendon_figure import WIDEST, tendon_curves
from forficula.show.page.data.packing import packed
from forficula.show.page.parts.words import readable
from forficula.show.run.energies_figure import stored_energies
from forficula.show.structure.labels import label_of, parts_of, title_of
from forficula.statics import EnergyLandscape, HingeLandscape
from forficula.statics.landscape import fold_states
from forficula.statics.tree.potential import ensemble, stored_energy

Rows = NDArray[np.int64]

_PLACES = 721  # of a line
_SAME = 1e-9  # rad
_MOVING = ("kinetic", "Maxwell branches")  # energies that are none at rest, so that statics has none of them


@dataclass(frozen=True, kw_only=True)
class DrawnCourse:
    """Energies over an angle: a line, or where a run is, by frame.

    Attributes:
        name: in the key of the plot.
        angle: rad, (place,).
        energy: J, (place,).
    """

    name: str
    angle: Array
    energy: Array


@dataclass(frozen=True, kw_only=True)
class Curve:
    """A plot of energy over an angle, in the sense in which the structure has it.

    Attributes:
        title: what the energy is of.
        axis: what the angle is.
        lines: by statics.
        marks: stable states with their names, each from where to where it rests.
        balls: the run's own readings and energies over the frames of its clip; empty without a run.
        top: from where to where a barrier is seen close up, rad; None where that needs no close-up.
        text: what the plot shows, in sentences.
        hinge: number of the one whose angle it is over; None of the mean of those that fold.
    """

    title: str
    axis: str
    lines: tuple[DrawnCourse, ...]
    marks: tuple[DrawnCourse, ...]
    balls: tuple[DrawnCourse, ...]
    top: tuple[float, float] | None
    text: str
    hinge: int | None = None


def landscape_curves(
    landscape: EnergyLandscape, record: Record | None = None, tendon: int | None = None, time: Array | None = None
) -> list[Curve]:
    """The curves of energy that a landscape has: of tendons over their hinges, and of all along the fold.

    Args:
        landscape: whose curves.
        record: a run of the same design.
        tendon: number of the one that stands for all; an inner one if not given.
        time: of the record's rows that are shown, s, (frame,); all if not given.
    """
    rows = np.arange(0 if record is None else len(record.time))
    if record is not None and time is not None:
        rows = np.searchsorted(record.time, time)
    found = (_of_tendons(landscape, record, tendon, rows), _along_fold(landscape, record, rows))
    return [curve for curve in found if curve is not None]


def curve_data(curve: Curve) -> dict[str, Any]:
    """A curve as data for JSON, in deg and in one unit of energy."""
    unit, factor = reading_unit("J", max(float(line.energy.max()) for line in curve.lines))

    def course(each: DrawnCourse) -> dict[str, Any]:
        places, values = packed(np.degrees(each.angle), "f4"), packed(factor * each.energy, "f4")
        return {"name": each.name, "places": places, "values": values}

    first = curve.lines[0]
    return {
        "title": curve.title,
        "unit": unit,
        "axis": curve.axis,
        # as in the figures: from where it begins to where it is folded
        "backwards": bool(first.angle[-1] < first.angle[0]),
        "lines": [course(each) for each in curve.lines],
        "marks": [course(each) for each in curve.marks],
        "balls": [course(each) for each in curve.balls],
        "top": None if curve.top is None else sorted(np.degrees(curve.top).tolist()),
        "text": curve.text,
    }


def _of_tendons(landscape: EnergyLandscape, record: Record | None, tendon: int | None, rows: Rows) -> Curve | None:
    """One tendon over the angle of its hinge, with its hinge's spring; a ball for every tendon that has this curve."""
    shown, structure = inner_hinge(landscape, tendon), landscape.structure
    if shown is None:
        return None
    own, title = shown.own, title_of(hinge_measure(structure, shown.hinge))
    *drawn, last = tendon_curves(landscape, shown)
    ideal = drawn[:1] if shown.ideal is not None and drawn else []
    # what holds of the hinge itself comes first: with a spring the sum of both, which is the last
    drawn = [last, *drawn[len(ideal) :]] if own.spring is not None else [*drawn[len(ideal) :], last]
    drawn += ideal
    names = parts_of([label_of(structure.tendons[each.tendon]) for each in landscape.hinges]).names
    balls = []
    for name, crossed in zip(names, landscape.hinges, strict=True):
        if record is None or not _alike(crossed.own, own):
            continue
        energy = record.series["tendon_energy"][rows, crossed.tendon]
        if own.spring is not None:
            energy = energy + record.series["hinge_energy"][rows, crossed.hinge]
        balls.append(DrawnCourse(name=name, angle=record.series["hinge_angle"][rows, crossed.hinge], energy=energy))
    barrier, top = "", None
    if own.barrier is not None and own.barrier_angle is not None:
        start, reach = own.hinge.overbend, own.hinge.overbend - own.barrier_angle
        barrier = f" The barrier is {readable(own.barrier, 'J')}."
        if reach < WIDEST:
            top = own.sense * (start + 0.15 * reach), own.sense * max(start - 2.5 * reach, -own.hinge.fold_limit)
    lines = [_smooth(name, hinge, energy, moment) for hinge, energy, moment, name, _ in drawn]
    sprung = own.spring is not None
    return Curve(
        title="tendon and spring of one hinge" if sprung else "energy of one tendon",
        axis=title,
        lines=tuple(lines),
        marks=tuple(
            _mark("", (own.sense * each.angle, own.sense * each.far_angle), each.energy, lines[0])
            for each in own.states
        ),
        balls=tuple(balls),
        top=top,
        text=f"Energy over the {title} of one hinge, by statics.{barrier}"
        + " Every tendon has a ball, at its energy and its hinge's angle in the run; dots are its frames."
        * bool(balls),
        hinge=shown.hinge,
    )


def _smooth(name: str, hinge: HingeLandscape, energy: Array, moment: Array) -> DrawnCourse:
    """A line with so many places that a barrier of a few degrees is round; the moment is its slope."""
    rising = hinge.angle[::-1]
    angle = np.unique(np.concatenate([rising, np.linspace(rising[0], rising[-1], _PLACES)]))[::-1]
    spline = scipy.interpolate.CubicHermiteSpline(rising, energy[::-1], -moment[::-1])
    return DrawnCourse(name=name, angle=hinge.sense * angle, energy=spline(angle))


def _alike(hinge: HingeLandscape, own: HingeLandscape) -> bool:
    """Whether a hinge has a curve of its own in the plot of another: with springs only what both store alike is one."""
    if hinge.spring is None or own.spring is None:
        return hinge.sense == own.sense and hinge.spring is own.spring
    both = own.stored_energy(own.angle), hinge.stored_energy(own.angle)
    return hinge.sense == own.sense and bool(np.allclose(*both, rtol=0, atol=1e-6 * float(both[0].max())))


def _along_fold(landscape: EnergyLandscape, record: Record | None, rows: Rows) -> Curve | None:
    """All that a structure stores along its rigid fold, over the mean angle of the hinges that fold."""
    path, structure, fold = landscape.fold_path, landscape.structure, landscape.structure.rigid_fold
    if path is None or fold is None:
        return None
    folds = bool(np.any(path.ring_angle))
    axis = f"mean {title_of(hinge_measure(structure, fold.folds[0]))}" if folds else "mean pleat angle"
    balls: tuple[DrawnCourse, ...] = ()
    if record is not None:
        angles = record.series["hinge_angle"][rows]
        angle = angles[:, list(fold.folds)].mean(axis=1) if folds else 2 * angles[:, list(fold.turns)].mean(axis=1)
        stored = [values[rows] for name, (values, _) in stored_energies(record).items() if name not in _MOVING]
        balls = (DrawnCourse(name="", angle=angle, energy=np.sum(stored, axis=0) + _weight_zero(record)),)
    along = -path.ring_angle if folds else path.pleat_angle
    line = DrawnCourse(name="rigid panels, slowly", angle=path.pleat_angle, energy=path.energy)
    states = [
        _mark(each.name, (each.pleat_angle, each.far_pleat_angle), each.energy, line) for each in fold_states(landscape)
    ]
    line, *states = (replace(each, angle=np.interp(each.angle, path.pleat_angle, along)) for each in (line, *states))
    told = ", ".join(f"{each.name} {readable(float(each.energy[0]), 'J')}" for each in states)
    whole = structure.appearance.whole
    return Curve(
        title=f"energy of the {whole} along its fold",
        axis=axis,
        lines=(line,),
        marks=tuple(states),
        balls=balls,
        top=None,
        text=f"What the {whole} stores along the one way in which rigid panels fold; stable: {told or 'none'}."
        + " The ball is at what the same parts store in the run, fast and with panels that give way." * bool(balls),
    )


def _weight_zero(record: Record) -> float:
    """By how much statics counts the energy of the weight from lower than a run does, J."""
    if not record.structure.gravity:
        return 0.0
    first = stored_energy(ensemble([record.structure]), record.series["hinge_angle"][:1]).get("weight", np.zeros(1))
    return float(first[0] - record.series["gravitational_energy"][0])


def _mark(name: str, ends: tuple[float, float], energy: float, line: DrawnCourse) -> DrawnCourse:
    """A stable state: a place, or the part of a line along which it rests."""
    low, high = sorted(ends)
    between = (line.angle >= low - _SAME) & (line.angle <= high + _SAME)
    if high - low <= _SAME:
        return DrawnCourse(name=name, angle=np.array([low]), energy=np.array([energy]))
    return DrawnCourse(name=name, angle=line.angle[between], energy=line.energy[between])
