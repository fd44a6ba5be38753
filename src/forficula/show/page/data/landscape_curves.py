"""Energy over an angle as data, with the positions of a run: plots that the page's script draws."""

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
from forficula.show.page.parts.run_sentences import readable
from forficula.show.run.energies_figure import stored_energies
from forficula.show.structure.labels import label_of, parts_of, title_of
from forficula.statics import EnergyLandscape, HingeLandscape
from forficula.statics.landscape import fold_states
from forficula.statics.tree.potential import ensemble, stored_energy

Rows = NDArray[np.int64]

_PLACES = 721  # points of a line
_SAME = 1e-9  # rad
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
class EnergyPlot:
    """Plot of energy over an angle, in the structure's own sense of the angle.

    Attributes:
        title: quantity of the vertical axis.
        axis: quantity of the horizontal axis.
        lines: energies computed by statics.
        marks: stable states with their names, each at an angle or over the range of angles at which it rests.
        balls: angles and energies of the run over the frames of its clip; empty without a run.
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


def landscape_curves(
    landscape: EnergyLandscape, record: Record | None = None, tendon: int | None = None, time: Array | None = None
) -> list[EnergyPlot]:
    """Return the energy curves of a landscape: of a tendon and its hinge, and of the structure along its fold.

    Args:
        landscape: the landscape.
        record: a run of the same design.
        tendon: index of the tendon shown as an example; an inner one by default.
        time: times of the record's rows that are shown, s, (frame,); all rows by default.
    """
    rows = np.arange(0 if record is None else len(record.time))
    if record is not None and time is not None:
        rows = np.searchsorted(record.time, time)
    curves = (_of_tendons(landscape, record, tendon, rows), _along_fold(landscape, record, rows))
    return [curve for curve in curves if curve is not None]


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
        "top": None if curve.top is None else sorted(np.degrees(curve.top).tolist()),
        "text": curve.text,
    }


def _of_tendons(landscape: EnergyLandscape, record: Record | None, tendon: int | None, rows: Rows) -> EnergyPlot | None:
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
        if record is None or not _has_same_curve(crossed.actual, actual):
            continue
        energy = record.series["tendon_energy"][rows, crossed.tendon]
        if actual.spring is not None:
            energy = energy + record.series["hinge_energy"][rows, crossed.hinge]
        balls.append(EnergyLine(name=name, angle=record.series["hinge_angle"][rows, crossed.hinge], energy=energy))
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
        + " The balls show the energy of every tendon at its hinge's angle in the run; dots are frames." * bool(balls),
        hinge=shown.hinge,
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


def _along_fold(landscape: EnergyLandscape, record: Record | None, rows: Rows) -> EnergyPlot | None:
    """Return the stored energy along the rigid fold over the mean angle of the folding hinges."""
    path, structure, fold = landscape.fold_path, landscape.structure, landscape.structure.rigid_fold
    if path is None or fold is None:
        return None
    folds = bool(np.any(path.ring_angle))
    axis = f"mean {title_of(hinge_measure(structure, fold.folds[0]))}" if folds else "mean pleat angle"
    balls: tuple[EnergyLine, ...] = ()
    if record is not None:
        angles = record.series["hinge_angle"][rows]
        angle = angles[:, list(fold.folds)].mean(axis=1) if folds else 2 * angles[:, list(fold.turns)].mean(axis=1)
        stored = [values[rows] for name, (values, _) in stored_energies(record).items() if name not in _MOVING]
        balls = (EnergyLine(name="", angle=angle, energy=np.sum(stored, axis=0) + _weight_zero(record)),)
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
        + " The ball shows the energy of the same parts in the run, with inertia and flexible panels." * bool(balls),
    )


def _weight_zero(record: Record) -> float:
    """Return the difference between the reference levels of gravitational energy in a run and in statics, J."""
    if not record.structure.gravity:
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
