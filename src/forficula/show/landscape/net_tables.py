"""The numbers of a net's landscape as tables of text, for the terminal and for a page."""

from __future__ import annotations

from dataclasses import dataclass

from forficula.show.landscape.net_words import course_words, held_words, reading_words, shown_value
from forficula.show.structure.labels import stress_text
from forficula.statics import EnergyLandscape
from forficula.statics.net_landscape import NetLandscape
from forficula.structure import Structure, drive_unit

_MOST = 5  # measures whose readings are told
_LONGEST = 24  # letters of where a drive acts


@dataclass(frozen=True, kw_only=True)
class TextTable:
    """A table of text.

    Attributes:
        title: above it.
        headings: of the columns.
        rows: cells, the first one the row's name.
    """

    title: str
    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def net_tables(landscape: EnergyLandscape) -> tuple[TextTable, ...]:
    """Stable states, barriers, what drives do and what states withstand; those without a row are left out."""
    net, structure = landscape.net, landscape.structure
    if net is None:
        return ()
    tables = [
        _states(structure, net),
        _moves(structure, net),
        _barriers(net),
        _courses(structure, net),
        _withstands(net),
    ]
    return tuple(table for table in tables if table.rows)


def net_verdict(landscape: EnergyLandscape) -> str:
    """How many stable states there are, in a sentence."""
    assert landscape.net is not None
    names = [state.name for state in landscape.net.states]
    what = f"{len(names)} stable states were found" if len(names) != 1 else "one stable state was found"
    return f"{landscape.design.name}: {what}{': ' * bool(names)}{', '.join(names)}"


def _states(structure: Structure, net: NetLandscape) -> TextTable:
    parts = list(dict.fromkeys(part for state in net.states for part in state.stored))
    measures = list(net.states[0].readings)[:_MOST] if net.states else []
    titles = {measure.name: measure.label or measure.name for measure in structure.measures}
    return TextTable(
        title="Stable states",
        headings=("", "energy", *parts, *(titles[name] for name in measures)),
        rows=tuple(
            (
                state.name,
                shown_value(state.energy, "J", 3),
                *(shown_value(state.stored[part], "J", 3) for part in parts),
                *(reading_words(structure, name, state.readings[name].tolist()) for name in measures),
            )
            for state in net.states
        ),
    )


def _moves(structure: Structure, net: NetLandscape) -> TextTable:
    """How it can move, and what its parts bear."""
    tendons = any(state.extension for state in net.states)
    built = ("as built", "", *_freedoms(net.built), "", "", *[""] * tendons)
    return TextTable(
        title="How it can move there, and what its parts bear",
        headings=("", "slowest", "freedoms", "self-stresses", "strain", "stress", *["tendon extension"] * tendons),
        rows=(
            built,
            *(
                (
                    state.name,
                    f"{state.frequencies[0]:.3g} Hz" if len(state.frequencies) else "",
                    *_freedoms(state.mobility),
                    f"{100 * state.strain:.2g} %",
                    stress_text(state.stress, structure.strength),
                    *[f"{100 * state.extension:.3g} %"] * tendons,
                )
                for state in net.states
            ),
        ),
    )


def _freedoms(found: object) -> tuple[str, str]:
    freedoms, stresses = (getattr(found, name, "") for name in ("degrees_of_freedom", "self_stresses"))
    return str(freedoms), str(stresses)


def _barriers(net: NetLandscape) -> TextTable:
    rows = []
    for each in net.passes:
        one, other = (net.states[end].name for end in each.ends)
        there, back = (shown_value(barrier, "J", 3) for barrier in each.barriers)
        rows.append((f"{one} to {other}", there, back))
    title = "Barriers, over the saddles that were found"
    return TextTable(title=title, headings=("", "there", "back"), rows=tuple(rows))


def _courses(structure: Structure, net: NetLandscape) -> TextTable:
    rows = []
    for course in net.courses:
        unit = drive_unit(structure, course.drive)
        least = "" if course.least is None else shown_value(course.least, unit, 3)
        released = sum(snap.released for snap in course.slow.snaps)
        freed = shown_value(released, "J", 3) if course.slow.snaps else ""
        where = course.drive.where
        name = f"{course.name}, {where}" if 0 < len(where) <= _LONGEST else course.name
        rows.append((name, course_words(structure, course), least, freed))
    headings = ("", "grows slowly", "at its goal", "snaps free")
    return TextTable(title="What drives do", headings=headings, rows=tuple(rows))


def _withstands(net: NetLandscape) -> TextTable:
    told = [state for state in net.states if state.withstands]
    loads = dict.fromkeys(each.load for state in told for each in state.withstands)
    by_state = [{each.load: held_words(each) for each in state.withstands} for state in told]
    return TextTable(
        title="What states withstand",
        headings=("", *(state.name for state in told)),
        rows=tuple((load, *(held.get(load, "") for held in by_state)) for load in loads),
    )
