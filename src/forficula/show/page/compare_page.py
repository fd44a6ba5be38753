"""The page that shows several runs side by side, on one clock."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from forficula.analysis import Outcome, measure
from forficula.analysis.run_files import read_run
from forficula.design import Design
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.files import write_text
from forficula.show.page.design_rows import DIGITS, differing_rows
from forficula.show.page.html import Cell, escaped, paragraph, section, table
from forficula.show.page.page import page_html
from forficula.show.page.playback import BUDGET, Clip, clip_data, energy_scale, make_clip
from forficula.show.page.plots import Line, Plot, energy_plot, plot_data
from forficula.show.page.time_spans import shared_spans, span_data
from forficula.show.page.words import angle_range, outcome_sentence, readable

_FEWEST, _MOST = 2, 12


@dataclass(frozen=True, kw_only=True)
class ComparedRun:
    """A run on the page.

    Attributes:
        label: what tells it from the others.
        record: what happened.
        outcome: what it means.
    """

    label: str
    record: Record
    outcome: Outcome


def compare_runs(folders: Sequence[Path], path: Path) -> None:
    """Write a page that shows runs side by side.

    Args:
        folders: that `forficula run` wrote, two to twelve.
        path: of the page; must end with .html.

    Raises:
        InputError: too few or too many folders, one that holds no run, a wrong ending, or it cannot be written.
    """
    if path.suffix != ".html":
        raise InputError(f"--out: need a file that ends with .html, got {path}")
    if not _FEWEST <= len(folders) <= _MOST:
        raise InputError(f"compare: need {_FEWEST} to {_MOST} folders of runs, got {len(folders)}")
    runs = []
    for folder, label in zip(folders, _labels(folders), strict=True):
        record = read_run(folder)
        runs.append(ComparedRun(label=label, record=record, outcome=measure(record)))
    write_text(path, compare_page(runs))


def compare_page(runs: Sequence[ComparedRun]) -> str:
    """Runs as one page: wings side by side, their plots in one, their numbers in columns."""
    clips = [make_clip(run.record, run.outcome, name=run.label, budget=BUDGET // len(runs)) for run in runs]
    labels = [run.label for run in runs]
    sentences = "".join(f"<li>{escaped(outcome_sentence(run.label, run.outcome))}</li>" for run in runs)
    title = f"{', '.join(labels[:-1])} and {labels[-1]}"
    body = "".join(
        (
            f"<header><h1>{escaped(title)}</h1><ol class=outcome>{sentences}</ol></header>\n",
            '<main><div id="player"></div>\n<div id="plots"></div>\n',
            section("Outcomes", table("Side by side", ("", *labels), _outcome_rows(runs)), name="outcome"),
            section("Designs", *_designs(labels, [run.record.design for run in runs]), name="design"),
            "</main>",
        )
    )
    return page_html(f"{title}, compared", body, _data(clips))


def _labels(folders: Sequence[Path]) -> list[str]:
    """Names of the folders, with as many of those above as tell them apart."""
    resolved = [folder.resolve() for folder in folders]
    if len(set(resolved)) < len(resolved):
        twice = next(folder for folder, path in zip(folders, resolved, strict=True) if resolved.count(path) > 1)
        raise InputError(f"compare: need every run once, got {twice} twice")
    for depth in range(1, max(len(path.parts) for path in resolved) + 1):
        labels = ["/".join(map(_printable, path.parts[-depth:])) for path in resolved]
        if len(set(labels)) == len(labels):
            return labels
    return [f"{number}: {_printable(str(path))}" for number, path in enumerate(resolved, start=1)]


def _printable(name: str) -> str:
    """A name of a file as text: on Linux it may hold bytes that are none."""
    return os.fsencode(name).decode("utf-8", "replace")


def _data(clips: Sequence[Clip]) -> dict[str, Any]:
    names = " and ".join(clip.name for clip in clips)
    return {
        "kind": "compare",
        "clips": [clip_data(clip) for clip in clips],
        "spans": [span_data(span) for span in shared_spans(clips)],
        "plots": plot_data([_angles(clips), _energies(clips)]),
        "energy": energy_scale(clips),
        "text": f"The wings of {names} side by side, moving on one clock and seen from one side.",
    }


def _angles(clips: Sequence[Clip]) -> Plot:
    """The hinge that has folded least, of every run: folded means that it is beyond the folded angle."""
    least = [np.degrees(clip.distal_angle.max(axis=1)) for clip in clips]
    furthest = [angle_range(values[[values.argmin()]]) for values in least]
    reached = ", ".join(f"{clip.name} {angle}" for clip, angle in zip(clips, furthest, strict=True))
    return Plot(
        title="distal angle of the hinge folded least",
        unit="deg",
        lines=tuple(Line(name=clip.name, clip=index, values=least[index]) for index, clip in enumerate(clips)),
        text=f"The distal angle of the hinge folded least in every wing; furthest folded: {reached}.",
    )


def _energies(clips: Sequence[Clip]) -> Plot:
    lines = [(clip.name, index, clip.tendon_energy.sum(axis=1)) for index, clip in enumerate(clips)]
    most = ", ".join(f"{name} {readable(float(values.max(initial=0.0)), 'J')}" for name, _, values in lines)
    return energy_plot("energy of all tendons", lines, f"The energy of all tendons of every wing; at most: {most}.")


def _outcome_rows(runs: Sequence[ComparedRun]) -> list[list[str]]:
    outcomes = [run.outcome for run in runs]
    rows = [["status", *(outcome.status for outcome in outcomes)]]
    for name, transitions in (
        ("fold", [outcome.fold for outcome in outcomes]),
        ("unfold", [outcome.unfold for outcome in outcomes]),
    ):
        tried = [f"{name} torque, time, work", *("not tried" for _ in runs)]
        for index, transition in enumerate(transitions, start=1):
            if transition is not None:
                time = "—" if transition.time is None else readable(transition.time, "s")
                tried[index] = f"{readable(transition.torque, 'N m')}, {time}, {readable(transition.work, 'J')}"
        rows.append(tried)
    for name, states in (
        ("flat", [outcome.flat for outcome in outcomes]),
        ("after folding", [outcome.folded_state for outcome in outcomes]),
        ("after unfolding", [outcome.opened_state for outcome in outcomes]),
    ):
        angles = ["—" if state is None else angle_range(np.degrees(state.distal_angle)) for state in states]
        energies = ["—" if state is None else readable(float(state.tendon_energy.sum()), "J") for state in states]
        rows += [[f"distal angles {name}", *angles], [f"tendon energy {name}", *energies]]
    return rows


def _designs(labels: Sequence[str], designs: Sequence[Design]) -> list[str]:
    rows = differing_rows(designs)
    if not rows:
        digits = "" if len({design.hash for design in designs}) == 1 else f", to {DIGITS} digits"
        return [paragraph(f"The designs are the same in every value{digits}.")]
    cells: list[list[str | Cell]] = [[key, *values] for key, values in rows]
    cells.append(["design hash", *(design.hash for design in designs)])
    return [
        paragraph("Only what differs; all other values are the same."),
        table("Values that differ", ("", *labels), cells),
    ]
