"""The largest strains, stresses and folds of a run as rows of text with units."""

from __future__ import annotations

from forficula.analysis.strength import fold_peak, permanent_fold, strain_peaks, worn_crease
from forficula.dynamics import Record
from forficula.quantities import show_value
from forficula.show.structure.labels import stress_text

STRENGTH_HEADINGS = ("", "strain", "stress", "where", "at")


def strength_rows(record: Record) -> list[list[str]]:
    """Return the largest strains of bars, membranes and tendons and the largest folds, with `STRENGTH_HEADINGS`.

    Empty for a structure without facets that bend and without creases that yield or wear.
    """
    lasting = permanent_fold(record)
    kept = []
    if lasting is not None:
        kept = [[f"permanent fold: {show_value(lasting.angle, 'rad')}", "", "", lasting.crease, "the end"]]
    if (worn := worn_crease(record)) is not None:
        kept.append([f"moment left after wear: {100 * worn.remaining:.3g} %", "", "", worn.crease, "the end"])
    if not record.structure.facets:
        return kept
    rows = [
        [
            peak.kind,
            f"{100 * peak.strain:.3g} %",
            "" if peak.stress is None else stress_text(peak.stress, peak.withstood),
            peak.part,
            show_value(peak.time, "s"),
        ]
        for peak in strain_peaks(record)
    ]
    furthest = fold_peak(record)
    if furthest is not None:
        angle, time = show_value(furthest.angle, "rad"), show_value(furthest.time, "s")
        rows.append([f"creases: {angle}", "", "", furthest.crease, time])
    return [*rows, *kept]
