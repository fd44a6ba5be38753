"""Energies over time: stored energies, and the work done and dissipated."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.quantities import reading_unit, show_value
from forficula.show.run.missed_goal import stalled_stage
from forficula.show.run.time_axes import mark_waits, row_legend, shade_stages, time_rows, time_spans
from forficula.show.structure.drive_labels import acting
from forficula.show.style import (
    BLACK,
    BLUE,
    GREEN,
    LINE_STYLES,
    ORANGE,
    PAGE_WIDTH,
    PURPLE,
    SKY,
    VERMILION,
    describe,
    figure_style,
)
from forficula.structure import hinge_groups, springs_name

_SHORT = 12  # letters of a label; three labels of this length fit into a row of a column


def draw_energies(record: Record, width: float = PAGE_WIDTH) -> Figure:
    """Draw stored energies over time, and below them the work done and dissipated; the width is in inches.

    For a run that missed a goal, the changes since the stage that should have reached the goal.
    """
    stored, name = stored_energies(record), "energy"
    if (stalled := stalled_stage(record)) is not None:
        # small changes would be invisible beside large constant energies
        first, name = int(np.argmax(record.time >= stalled.start)), "change of energy"
        stored = {part: (values - values[first], colour) for part, (values, colour) in stored.items()}
    tables = {name: stored, "work since the start": _accounts(record)}
    with figure_style():
        figure, rows = time_rows(record, list(tables), width, height=4.4)
        for axes_row, (label, series) in zip(rows, tables.items(), strict=True):
            unit, factor = reading_unit("J", max(float(np.abs(values).max()) for values, _ in series.values()))
            axes_row[0].set_ylabel(f"{label} ({unit})")
            for axes, span in zip(axes_row, time_spans(record), strict=True):
                for index, (name, (values, colour)) in enumerate(series.items()):
                    style, time, drawn = LINE_STYLES[index % len(LINE_STYLES)], record.time, values
                    if name == "kinetic":
                        time, drawn = _with_peak(record, values)
                    axes.plot((time - span.start) * span.scale, drawn * factor, style, color=colour, label=name)
                shade_stages(axes, record, span)
                mark_waits(axes, record, span)
            short = len(series) == 3 and max(map(len, series)) <= _SHORT
            row_legend(axes_row, width, columns=3 if short else 2)
        return describe(figure, _energies_text(record))


def _with_peak(record: Record, kinetic: Array) -> tuple[Array, Array]:
    """Return times, s, and kinetic energies, or changes, J, including a peak between two samples."""
    if record.kinetic_peak is None:
        return record.time, kinetic
    at, most = record.kinetic_peak
    place = int(np.searchsorted(record.time, at))
    change = float(kinetic[0] - record.series["kinetic_energy"][0])
    return np.insert(record.time, place, at), np.insert(kinetic, place, most + change)


def stored_energies(record: Record) -> dict[str, tuple[Array, str]]:
    """Return the stored energies of the structure's parts by name, J, (time,), with their colours."""
    series, structure = record.series, record.structure
    stored: dict[str, tuple[Array, str]] = {}
    if structure.tendons:
        stored["tendons"] = (series["tendon_energy"].sum(axis=1), BLUE)
    if structure.membranes:
        stored["membrane"] = (series["membrane_energy"], ORANGE)
    if "hinge_energy" in series:
        for (kind, hinges), colour in zip(hinge_groups(structure).items(), (SKY, GREEN, PURPLE), strict=False):
            stored[kind] = (series["hinge_energy"][:, list(hinges)].sum(axis=1), colour)
    if "spring_energy" in series:
        stored[springs_name(structure)] = (series["spring_energy"].sum(axis=1), BLACK)
    if "coupling_energy" in series:
        stored["couplings"] = (series["coupling_energy"].sum(axis=1), SKY)
    if "friction_spring_energy" in series:
        stored["friction springs"] = (series["friction_spring_energy"], BLUE)
    stored["kinetic"] = (series["kinetic_energy"], VERMILION)
    if "branch_energy" in series:
        stored["Maxwell branches"] = (series["branch_energy"].sum(axis=1), GREEN)
    if structure.gravity:
        stored["gravitational"] = (series["gravitational_energy"], PURPLE)
    return stored


def largest_energies(record: Record) -> dict[str, float]:
    """Return the maximum of each energy, J; that of the kinetic energy includes steps between rows."""
    most = {name: float(values.max()) for name, (values, _) in stored_energies(record).items()}
    return most if record.kinetic_peak is None else most | {"kinetic": record.kinetic_peak[1]}


def _accounts(record: Record) -> dict[str, tuple[Array, str]]:
    """Return the work done and dissipated, J, (time,), with colours."""
    series, structure = record.series, record.structure
    accounts: dict[str, tuple[Array, str]] = {}
    if structure.motors:
        accounts[f"done by {acting(structure)}"] = (record.work, BLACK)
    hinged = hinge_groups(structure).keys() <= {"hinges"}
    accounts[f"dissipated by {'hinge' if hinged else 'fold'} damping"] = (-series["hinge_damping_work"], GREEN)
    accounts["dissipated by stops"] = (-series["stop_work"], VERMILION)
    damped = [name for name in ("tendons", "membranes", "springs") if getattr(structure, name)]
    if damped:
        alone = {"tendons": "dissipated by tendons", "springs": f"dissipated by {springs_name(structure)}"}
        name = alone.get(damped[0]) if len(damped) == 1 else None
        accounts[name or "dissipated by other damping"] = (-series["elastic_damping_work"], SKY)
    for name, words, colour in (
        ("friction_work", "dissipated by dry friction", ORANGE),
        ("contact_work", "dissipated by contacts", BLUE),
        ("branch_damping_work", "dissipated by branches", ORANGE),
        ("letting_go_work", "branches that gave way", PURPLE),
        ("yield_work", "dissipated by yielding", PURPLE),
        ("crease_yield_work", "dissipated by yielding creases", ORANGE),
        ("crease_branch_work", "dissipated by branches of creases", BLUE),
        ("crease_damage_work", "dissipated by wear of creases", PURPLE),
        ("drag_work", "dissipated by drag", BLUE),
    ):
        if name in series:
            accounts[words] = (-series[name], colour)
    return accounts


def _energies_text(record: Record) -> str:
    """Describe the energies."""
    largest = ", ".join(f"{name} {show_value(value, 'J')}" for name, value in largest_energies(record).items())
    name, structure = record.design.name, record.structure
    work = f"; work of the {acting(structure)}: {show_value(float(record.work[-1]), 'J')}" if structure.motors else ""
    return f"Stored energies and work over time in a run of {name}. Largest: {largest}{work}."
