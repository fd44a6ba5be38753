"""Quasi-static path of a structure as a view of its page: a clip over the fold, its plots and its events."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from forficula.arrays import Array, Indices
from forficula.quantities import reading_unit, show_value
from forficula.show.page.data.crease_lines import crease_data, reading_signs, sprung_hinges
from forficula.show.page.data.landscape_curves import tendon_energies
from forficula.show.page.data.packing import packed, packed_steps
from forficula.show.page.data.shape_mesh import ShapeMesh, shape_mesh
from forficula.show.page.data.shown_path import BUDGET, is_within, shown_rows
from forficula.show.page.data.time_spans import Span, span_data
from forficula.show.page.parts.efforts import effort_word
from forficula.show.page.parts.plots import Line, Plot, energy_plot, plot_data, reading_lines
from forficula.show.page.parts.run_sentences import readable, reading_range, shape_text
from forficula.show.page.playback import (
    Clip,
    Readings,
    clip_data,
    energy_scale,
    legend_data,
    readings_of,
    structure_noun,
)
from forficula.show.run.state_names import state_letters
from forficula.show.structure.labels import condensed, reading_labels
from forficula.statics import QuasiStaticPath
from forficula.statics.net.net_of import is_net
from forficula.structure import Measure, Structure, first_state, read_angles, state_of

_SECONDS = 6.0  # duration of a path that is played
_PERCENT = 100.0
_ROUNDING = 1e-9  # a moment below this share of the largest one is a rounding error
_LETTERS = {"snap": "S", "branch": "B", "contact": "T", "goal": "G", "lost": "L"}
_NAMES = {"contact": "touch"}  # names of marks that differ from the kinds of events
_PAIRS = 6  # lines of contact forces, with the largest forces
# keys of a clip that do not depend on the motion, which the page takes from the clip of a run
_MESH = (
    *("span_m", "pointCount", "between", "share", "triangles", "regions", "solid", "tubes", "built", "faces", "base"),
    *("joints", "jointRadius", "gravity", "table_m"),
)


def fold_view(
    path: QuasiStaticPath, *, beside_run: bool, budget: int = BUDGET, mesh: ShapeMesh | None = None
) -> dict[str, Any]:
    """Return a path as data for JSON: a view that a page shows alone, or as an alternative to a run.

    Args:
        path: path of the structure.
        beside_run: whether the page has a run of the same structure, from which it takes the mesh.
        budget: largest number of bytes for positions, angles and moments.
        mesh: mesh of the structure, if it is known.
    """
    mesh = shape_mesh(path.structure) if mesh is None else mesh
    rows = shown_rows(path, mesh, budget)
    clip = path_clip(path, mesh, rows)
    along = [("energy", path.stored[rows], "J")] * bool(path.energy)
    along.append((effort_word(path.structure, path.drive), path.strength[rows], path.unit))
    view = pose_view(
        clip,
        path.angles[rows],
        path.moments[rows],
        along,
        name="fold",
        title="slowly along its quasi-static path",
        notes=_notes(path),
        plots=_plots(path, clip, rows),
        beside_run=beside_run,
    )
    view["clips"][0] |= {"marks": _marks(path), "stages": _stages(path)}
    return view


def pose_view(
    clip: Clip,
    angles: Array,
    moments: Array,
    along: Sequence[tuple[str, Array, str]],
    *,
    name: str,
    title: str,
    notes: Sequence[str],
    plots: Sequence[dict[str, Any]],
    beside_run: bool,
) -> dict[str, Any]:
    """Return poses of a structure as data for JSON: a view through which a slider from 0 to 100 % moves.

    Args:
        clip: clip whose times are positions of the slider, %.
        angles: of all hinges, in their own senses, rad, (pose, hinge).
        moments: of their springs, N m, (pose, hinge).
        along: names, values and SI units of numbers beside the slider.
        name: name of the view and of the slider.
        title: phrase on how the structure moves.
        notes: sentences below the picture.
        plots: plots over the slider, from `plot_data`.
        beside_run: whether the page has a run of the same structure, from which it takes the mesh.
    """
    data = clip_data(clip) | {
        "points": packed_steps(clip.points.reshape(len(clip.time), -1)),
        "stages": [{"name": "", "start": 0.0, "end": _PERCENT, "driven": False}],
        "along": [_along_data(*numbers) for numbers in along],
        "creases": crease_data(clip.structure, clip.mesh, angles, moments),
    }
    span = Span(name=name, label=name, start=0.0, end=_PERCENT, origins=(0.0,))
    return {
        "name": name,
        "title": title,
        "whole": structure_noun([clip]),
        "clips": [{key: value for key, value in data.items() if not (beside_run and key in _MESH)}],
        "spans": [span_data(span) | {"unit": "%", "seconds": _SECONDS}],
        "plots": list(plots),
        "energy": energy_scale([clip]),
        "legend": legend_data([clip]),
        "text": f"{shape_text(clip.structure)}, moved {title}.",
        "notes": list(notes),
    }


def path_clip(path: QuasiStaticPath, mesh: ShapeMesh, rows: Indices) -> Clip:
    """Return some points of a path as a clip, with the moments of springs among its readings."""
    energy = {name: values[rows] for name, values in path.energy.items()}
    clip = posed_clip(path.structure, mesh, path.share[rows], path.positions[rows], path.angles[rows], energy)
    return replace(clip, readings=(*clip.readings, *_moments(path, rows)))


def posed_clip(
    structure: Structure, mesh: ShapeMesh, share: Array, positions: Array, angles: Array, energy: Mapping[str, Array]
) -> Clip:
    """Return poses as a clip whose times are positions of a slider, %.

    Args:
        structure: the structure.
        mesh: its mesh.
        share: position of each pose, from 0 to 1, (pose,).
        positions: of points, then of the nodes of membranes, m, (pose, place, 3).
        angles: of all hinges, in their own senses, rad, (pose, hinge).
        energy: stored energy by part, J, (pose,) each.
    """

    def measured(measure: Measure) -> Array:
        if measure.points is None:
            return read_angles(measure, angles)
        one, other = measure.points
        return np.asarray(np.linalg.norm(positions[:, [other]] - positions[:, [one]], axis=2))

    return Clip(
        name=structure.name,
        structure=structure,
        time=_PERCENT * share,
        points=positions[:, mesh.anchors],
        mesh=mesh,
        marks=(),
        stages=(),
        readings=tuple(readings_of(structure, measured)),
        tendon_energy=tendon_energies(structure, positions),
        stored_energy=energy,
        largest_energy={name: float(values.max(initial=0.0)) for name, values in energy.items()},
        rest_length=np.array([[tendon.law.rest_length for tendon in structure.tendons]]),
    )


def _moments(path: QuasiStaticPath, rows: Indices) -> list[Readings]:
    """Return the moments of springs in hinges and creases as readings; none if no hinge has one."""
    structure, hinges = path.structure, sprung_hinges(path.structure, path.moments)
    if not hinges:
        return []
    signs = tuple(reading_signs(structure)[hinges].astype(int).tolist())
    measure = Measure(name="moment of springs", kind="angle", hinges=tuple(hinges), signs=signs, label="moment")
    values = condensed(structure, measure, read_angles(measure, path.moments[rows]))
    largest = float(np.abs(values).max())
    values = np.where(np.abs(values) > _ROUNDING * largest, values, 0.0)
    unit, factor = reading_unit("N m", largest)
    creases = all(structure.hinges[hinge].flaps is not None for hinge in hinges)
    return [
        Readings(
            measure=measure,
            title=f"moment of the springs in {'creases' if creases else 'hinges'}",
            row=f"moment ({unit})",
            unit=unit,
            factor=factor,
            labels=tuple(reading_labels(structure, measure)),
            values=values,
        )
    ]


def _marks(path: QuasiStaticPath) -> list[dict[str, Any]]:
    """Return the start and the events of a path as marks on the slider and in plots."""
    structure = path.structure
    start = state_of(structure, first_state(structure, [state.name for state in structure.states]))
    marks: list[dict[str, Any]] = []
    if start is not None:
        name = start.name if is_within(path, 0, start.goal) else start.missed
        marks.append({"letter": state_letters(structure)[start.name], "name": name, "time": 0.0})
    numbers = dict.fromkeys(_LETTERS, 0)
    for mark in path.marks:
        numbers[mark.kind] += 1
        kind = _NAMES.get(mark.kind, mark.kind)
        name = kind if numbers[mark.kind] == 1 else f"{kind} {numbers[mark.kind]}"
        marks.append({"letter": _LETTERS[mark.kind], "name": name, "time": _PERCENT * mark.share})
    return [mark | {"readings": {}, "tendonEnergy_J": None} for mark in marks]


def _stages(path: QuasiStaticPath) -> list[dict[str, Any]]:
    """Return the parts of a path: at rest, or moving in a snap or after a release at the goal, which are shaded."""
    stages, before = [], 0.0
    for mark in path.marks:
        if mark.kind == "snap":
            stages += [("at rest", before, mark.share), ("snap", mark.share, mark.end)]
            before = mark.end
        elif mark.kind == "goal" and mark.share < 1:
            stages += [("at rest", before, mark.share), ("drive released", mark.share, 1.0)]
            before = 1.0
    stages.append(("at rest", before, 1.0))
    return [
        {"name": name, "start": _PERCENT * start, "end": _PERCENT * end, "driven": name != "at rest"}
        for name, start, end in stages
        if end > start
    ]


def _along_data(name: str, values: Array, si: str) -> dict[str, Any]:
    """Return numbers beside the slider in a legible unit."""
    unit, factor = reading_unit(si, float(np.abs(values).max(initial=0.0)))
    return {"name": name, "unit": unit, "values": packed(factor * values, "f4")}


def _plots(path: QuasiStaticPath, clip: Clip, rows: Indices) -> list[dict[str, Any]]:
    """Return the plots of a path over the fold: energies, drive, readings and strains; the first two have a ball."""
    others = [reading_plot(readings) for readings in clip.readings]
    others += [*_contact_plot(path, rows), *_strain_plot(path, rows)]
    return balled_plots([*energies_plot(clip), _drive_plot(path, rows)], others)


def balled_plots(balls: Sequence[Plot], others: Sequence[Plot]) -> list[dict[str, Any]]:
    """Return plots over the fold as data for JSON, the first ones with a ball on their first line."""
    data = plot_data([*balls, *others])
    return [plot | {"ball": 0} for plot in data[: len(balls)]] + data[len(balls) :]


def energies_plot(clip: Clip) -> list[Plot]:
    """Return the plot of the stored energies of a clip: their sum first, if there are several; none without energy."""
    if not clip.stored_energy:
        return []
    parts = [(name, 0, values) for name, values in clip.stored_energy.items()]
    total = [("total", 0, np.sum([values for *_, values in parts], axis=0))] if len(parts) > 1 else []
    most = ", ".join(f"{name} {readable(value, 'J')}" for name, value in clip.largest_energy.items())
    return [energy_plot("energy", [*total, *parts], f"Stored energy along the path. Largest values: {most}.")]


def _drive_plot(path: QuasiStaticPath, rows: Indices) -> Plot:
    """Return the strength of the drive; of a displacement, its force."""
    forced = bool(np.any(path.force))
    word = "force" if forced else effort_word(path.structure, path.drive)
    values, si = (path.force, "N") if forced else (path.strength, path.unit)
    unit, factor = reading_unit(si, float(np.abs(values).max(initial=0.0)))
    largest = readable(float(values[np.argmax(np.abs(values))]), si)
    lines = [Line(name=path.drive.name, clip=0, values=factor * values[rows])]
    text = f"{word.capitalize()} at which the {path.structure.appearance.whole} is at rest; largest value {largest}."
    if not forced and path.friction.any():
        most = readable(float(np.nanmax(path.friction)), si)
        for name, side in (("growing", 1.0), ("falling", -1.0)):
            lines.append(Line(name=name, clip=0, values=factor * (values + side * np.nan_to_num(path.friction))[rows]))
        text += f" Dry friction increases the {word} by up to {most} while it grows, and reduces it by the same amount"
        text += " while it falls."
    return Plot(
        title=f'{word} of the drive "{path.drive.name}"',
        unit=unit,
        lines=tuple(lines),
        text=text,
    )


def reading_plot(readings: Readings) -> Plot:
    """Return the plot of one measure over the fold."""
    first, last = (reading_range(readings.factor * readings.values[row], readings.unit) for row in (0, -1))
    title = readings.title
    return Plot(
        title=title,
        unit=readings.unit,
        lines=reading_lines(readings),
        text=f"{title[:1].upper()}{title[1:]} along the path: {first} at the start, {last} at the end.",
    )


def _contact_plot(path: QuasiStaticPath, rows: Indices) -> list[Plot]:
    """Return the contact forces of the pairs of parts that press on each other most; none without contact."""
    largest = {name: float(forces.max()) for name, forces in path.contacts.items()}
    shown = sorted(largest, key=lambda name: -largest[name])[:_PAIRS]
    if not shown:
        return []
    unit, factor = reading_unit("N", largest[shown[0]])
    words = ", ".join(f"{name} {readable(largest[name], 'N')}" for name in shown)
    more = f" {len(largest) - len(shown)} further pairs touch with smaller forces." if len(largest) > len(shown) else ""
    return [
        Plot(
            title="contact forces",
            unit=unit,
            lines=tuple(Line(name=name, clip=0, values=factor * path.contacts[name][rows]) for name in shown),
            text=f"Contact forces between parts, without friction. Largest values: {words}.{more}",
        )
    ]


def _strain_plot(path: QuasiStaticPath, rows: Indices) -> list[Plot]:
    """Return the largest strain of each kind of elastic part, %."""
    lines, texts = [], []
    for name, strains in path.strains.items():
        sizes = np.abs(strains[:, np.isfinite(strains).all(axis=0)])
        if sizes.shape[1]:
            largest = _PERCENT * sizes.max(axis=1)
            lines.append(Line(name=name, clip=0, values=largest[rows]))
            texts.append(f"{name} {largest.max():.3g} %".replace("-", "−"))
    text = f"Largest strain of any part at every position. Largest values: {', '.join(texts)}."
    return [Plot(title="largest strain", unit="%", lines=tuple(lines), text=text)] if lines else []


def _notes(path: QuasiStaticPath) -> list[str]:
    """Return sentences on how the path was computed, on its events and on its limits."""
    whole, word = path.structure.appearance.whole, effort_word(path.structure, path.drive)
    first = (
        f'The {word} of the drive "{path.drive.name}" grows so slowly that the {whole} is at rest at every position'
        " outside snaps. Statics compute the shapes, without inertia and damping, and"
        f" {_contact_words(path.structure)}."
    )
    remarks = [f"{remark[:1].upper()}{remark[1:].removesuffix('.')}." for remark in path.remarks]
    return [first, *(mark.text for mark in path.marks), *_loss_notes(path), *remarks]


def _loss_notes(path: QuasiStaticPath) -> list[str]:
    """Return a sentence on the energies that creases dissipate on a path; none if they dissipate nothing."""
    causes = {"crease yielding": "permanent folds", "crease damage": "wear"}
    lost = [f"{show_value(float(values[-1]), 'J', 3)} by {causes[name]}" for name, values in path.losses.items()]
    if not lost:
        return []
    least = _PERCENT * float(path.remaining[-1].min())
    worn = f" At its end wear has left at least {least:.3g} % of the moment of every crease."
    worn = worn if "crease damage" in path.losses else ""
    return [f"On the path creases dissipate {' and '.join(lost)}.{worn}"]


def _contact_words(structure: Structure) -> str:
    """Return a phrase on the contact that the path includes."""
    if structure.contact is None or not is_net(structure):
        return "without contact between bodies"
    return "with contact between facets, but without friction"
