"""Conclusions from a study of named changes: which mechanisms are redundant, which are essential, which pairs fail."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING

import numpy as np

from forficula.analysis import Verdict
from forficula.analysis.margin import margin_column
from forficula.arrays import Flags
from forficula.design.files.tables import REMOVED
from forficula.names import counted, listed
from forficula.quantities import reading_unit
from forficula.study.changes import CHANGE, ChangePlan, OmittedPair
from forficula.study.tables.outcome_kinds import reached_all, studied_transitions, whole_of

if TYPE_CHECKING:
    from xarray import Dataset

# coordinates of a table of named changes: the names of both changes, and the changed values as text
FIRST, SECOND, CHANGED_VALUES = "first_change", "second_change", "changed_values"
# margin of all transitions together
MARGIN = "margin"
_OMITTED = "omitted_pairs"
_MOST_LISTED = 12


@dataclass(frozen=True, kw_only=True)
class ChangedRun:
    """Result of a structure with changes.

    Attributes:
        names: names of the changes; none for the unchanged design.
        place: index along the dimension of the changes.
        works: whether all transitions succeeded; None without a conclusive verdict.
        margin: margin of all transitions, in [-1, 1]; nan if it is unknown.
        outcome: outcome in a few words.
    """

    names: tuple[str, ...]
    place: int
    works: bool | None
    margin: float
    outcome: str


@dataclass(frozen=True, kw_only=True)
class Redundancy:
    """Results of a study of named changes.

    Attributes:
        unchanged: result of the unchanged design.
        alone: results of every change alone, in the study's order.
        pairs: results of two changes together.
        omitted: pairs that were not made, with the reason.
        task: what the structure does if all transitions succeed, such as "the wing folds and opens again".
        removes: whether a change removes a part of the design.
    """

    unchanged: ChangedRun
    alone: tuple[ChangedRun, ...]
    pairs: tuple[ChangedRun, ...]
    omitted: tuple[OmittedPair, ...]
    task: str
    removes: bool

    @property
    def tolerated(self) -> tuple[ChangedRun, ...]:
        """Changes with which the structure still makes all transitions; none if the unchanged design does not.

        A mechanism that such a change removes is redundant.
        """
        return tuple(run for run in self.alone if run.works) if self.unchanged.works else ()

    @property
    def fatal(self) -> tuple[ChangedRun, ...]:
        """Changes with which it does not, although the unchanged design does; a mechanism so removed is essential."""
        return tuple(run for run in self.alone if run.works is False) if self.unchanged.works else ()

    @property
    def failing_pairs(self) -> tuple[ChangedRun, ...]:
        """Pairs with which it does not, although it does with either change alone."""
        harmless = {run.names[0] for run in self.tolerated}
        return tuple(run for run in self.pairs if run.works is False and harmless.issuperset(run.names))

    @property
    def repaired_pairs(self) -> tuple[ChangedRun, ...]:
        """Pairs with which it makes all transitions, although it does not with one of the changes alone."""
        fatal = {run.names[0] for run in self.fatal}
        return tuple(run for run in self.pairs if run.works and fatal.intersection(run.names))

    @property
    def nearest(self) -> ChangedRun | None:
        """The change with the least margin with which the structure still makes all transitions."""
        known = [run for run in self.tolerated if np.isfinite(run.margin)]
        return min(known, key=lambda run: run.margin, default=None)


def redundancy(table: Dataset) -> Redundancy:
    """Read the results of a study of named changes from its table."""
    works, sizes = _works(table), table.sizes[CHANGE]
    verdicts = [Verdict(str(verdict)) for verdict in table["verdict"].values]
    margins = table[MARGIN].values if MARGIN in table else np.full(sizes, np.nan)
    runs = [
        ChangedRun(
            names=tuple(name for name in (str(table[FIRST].values[place]), str(table[SECOND].values[place])) if name),
            place=place,
            works=bool(works[place]) if verdicts[place].conclusive else None,
            margin=float(margins[place]),
            outcome=str(table["outcome"].values[place]),
        )
        for place in range(sizes)
    ]
    return Redundancy(
        unchanged=runs[0],
        alone=tuple(run for run in runs if len(run.names) == 1),
        pairs=tuple(run for run in runs if len(run.names) > 1),
        omitted=tuple(
            OmittedPair(names=(entry["names"][0], entry["names"][1]), why=entry["why"])
            for entry in json.loads(table.attrs.get(_OMITTED, "[]"))
        ),
        task=_task(table),
        removes=any(f" {REMOVED}" in str(text) for text in table[CHANGED_VALUES].values),
    )


def _works(table: Dataset) -> Flags:
    """Return whether all transitions succeeded at every point; in a search, with any of the values that were tried."""
    transitions = studied_transitions(table)
    if not transitions:
        return np.asarray(table["verdict"].values == str(Verdict.REACHED))
    if transitions[0].least:
        return np.asarray(np.all([np.isfinite(table[transition.least].values) for transition in transitions], axis=0))
    return np.asarray(reached_all(table, transitions).values, dtype=bool)


def _task(table: Dataset) -> str:
    """Return what a structure does that makes all transitions, such as "the wing folds and opens again"."""
    does = [transition.wording.does for transition in studied_transitions(table)]
    if not does:
        return f"the {whole_of(table)} settles"
    return f"the {whole_of(table)} {listed(does)}{' again' if len(does) > 1 and 'again' not in does[-1] else ''}"


def omitted_text(plan: ChangePlan) -> str:
    """Return the pairs that a study does not make as text for an attribute of its table."""
    return json.dumps([asdict(pair) for pair in plan.omitted])


def redundancy_sentences(table: Dataset) -> list[str]:
    """Return the conclusions of a study of named changes as sentences."""
    report = redundancy(table)
    if not report.unchanged.works:
        working = [run.names[0] for run in report.alone if run.works]
        rest = f" Changes with which {report.task}: {_listed(working)}." if working else ""
        return [
            f"The unchanged design fails or has no reliable result ({report.unchanged.outcome}), so no mechanism can be"
            f" judged redundant.{rest}"
        ]
    sentences = [f"Unchanged, {report.task}{_margin_text(report.unchanged, ' with a margin of ')}."]
    if report.tolerated:
        which = _listed(run.names[0] for run in report.tolerated)
        means = " (a mechanism that such a change removes is redundant)" if report.removes else ""
        count = f"{len(report.tolerated)} of {counted(len(report.alone), 'change')}"
        sentences.append(f"{count} {'is' if len(report.tolerated) == 1 else 'are'} tolerated{means}: {which}.")
    if report.nearest is not None and len(report.tolerated) > 1:
        sentences.append(f"The least margin of these is{_margin_text(report.nearest, ' ')}: {report.nearest.names[0]}.")
    if report.fatal:
        which = _listed(map(_failure, report.fatal))
        means = " (a mechanism that one of them removes is essential)" if report.removes else ""
        sentences.append(f"Changes that make it fail{means}: {which}.")
    if unknown := [run.names[0] for run in report.alone if run.works is None]:
        sentences.append(f"Changes without a reliable result: {_listed(unknown)}.")
    return [*sentences, *_pair_sentences(report)]


def _pair_sentences(report: Redundancy) -> list[str]:
    """Return the conclusions on pairs of changes; none if no pair was made."""
    if not report.pairs and not report.omitted:
        return []
    harmless = {run.names[0] for run in report.tolerated}
    tried = [run for run in report.pairs if harmless.issuperset(run.names)]
    sentences = []
    if tried:
        failing = report.failing_pairs
        which = f": {_listed(map(_failure, failing))}" if failing else ""
        verb = "fails" if len(failing) == 1 else "fail"
        sentences.append(
            f"Of {counted(len(tried), 'pair')} of tolerated changes, {len(failing) or 'none'} {verb}{which}."
        )
        if unknown := sum(run.works is None for run in tried):
            sentences.append(f"{unknown} of these pairs {'has' if unknown == 1 else 'have'} no reliable result.")
    if report.repaired_pairs:
        names = _listed(map(_label, report.repaired_pairs))
        sentences.append(f"Pairs with which it succeeds, although one of the changes alone makes it fail: {names}.")
    if report.omitted:
        why = "; ".join(f"{' + '.join(pair.names)}, because {pair.why}" for pair in report.omitted[:_MOST_LISTED])
        more = f"; and {len(report.omitted) - _MOST_LISTED} more" if len(report.omitted) > _MOST_LISTED else ""
        sentences.append(f"Pairs that were not combined: {why}{more}.")
    return sentences


def _label(run: ChangedRun) -> str:
    return " + ".join(run.names)


def _failure(run: ChangedRun) -> str:
    return f"{_label(run)} ({run.outcome}{_margin_text(run, ', margin ')})"


def _margin_text(run: ChangedRun, before: str) -> str:
    return f"{before}{margin_number(run.margin)}" if np.isfinite(run.margin) else ""


def margin_number(margin: float) -> str:
    """Return a margin with its sign and two decimals; a margin that rounds to 0 has three."""
    text = f"{margin:.2f}" if abs(margin) >= 0.005 or not margin else f"{margin:.3f}"
    return text.replace("-", "−")


def _listed(texts: Iterable[str]) -> str:
    """List texts, the first ones of many; with semicolons, because names of changes may contain commas."""
    items = list(texts)
    if len(items) > _MOST_LISTED:
        items = [*items[:_MOST_LISTED], f"{len(items) - _MOST_LISTED} more"]
    return "; ".join(items)


def change_rows(table: Dataset) -> tuple[list[str], list[list[str]]]:
    """Return headings, and rows of the unchanged design and of every change alone.

    Columns are the margins of all transitions, or the least values of a search, and the outcome.
    """
    transitions = studied_transitions(table)
    numbers = [
        (f"{transition.name} margin", margin_column(transition.name), 1.0)
        for transition in transitions
        if margin_column(transition.name) in table
    ]
    if MARGIN in table and len(numbers) != 1:
        numbers.append(("margin", MARGIN, 1.0))
    for transition in transitions:
        if transition.least:
            largest = float(np.nanmax(np.abs(table[transition.least].values), initial=0.0))
            unit, factor = reading_unit(table[transition.least].attrs["units"], largest)
            numbers.append((f"{transition.least.replace('_', ' ')} ({unit})", transition.least, factor))
    rows = []
    for place, label in enumerate(table[CHANGE].values.tolist()):
        if table[SECOND].values[place]:
            continue
        values = [factor * float(table[name].values[place]) for _, name, factor in numbers]
        cells = ["—" if not np.isfinite(value) else margin_number(value) for value in values]
        rows.append([label, *cells, str(table["outcome"].values[place])])
    return ["change", *(heading for heading, *_ in numbers), "outcome"], rows
