"""Table of all points of a page, built from the data for the page's script."""

from __future__ import annotations

from typing import Any

from forficula.show.page.parts.html import paragraph, table

# a table with more points is not legible on a page [chosen]
_MOST_ROWS = 3000


def has_rows(data: dict[str, Any]) -> bool:
    """Return whether the page shows a table of its points."""
    return int(data["points"]) <= _MOST_ROWS


def points_table(data: dict[str, Any]) -> str:
    """Return a table with one row for each point; the page's script adds filter, order and links."""
    if not has_rows(data):
        return paragraph(
            f"A table of {data['points']} {data['noun']}s is too long for this page; {data['file']} lists all."
        )
    factors, numbers = data["factors"], _columns(data)
    units = [(factor["name"], factor["unit"]) for factor in factors] + [
        (number["title"], number["unit"]) for number in numbers
    ]
    named = [f"{name} ({unit})" if unit else name for name, unit in units]
    headings = [data["noun"], *named[: len(factors)], "outcome", *named[len(factors) :]]
    rows = []
    for point, status in enumerate(data["statuses"]):
        values = [factor["texts"][index] for factor, index in zip(factors, places(data, point), strict=True)]
        cells = ["—" if (value := number["values"][point]) is None else f"{value:.4g}" for number in numbers]
        rows.append([str(point + 1), *values, status, *cells])
    return table(f"One row for each {data['noun']}, as in {data['file']}; numbers to four digits", headings, rows)


def _columns(data: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the quantities with one value for each point."""
    return [item for item in data["quantities"] if item["values"] is not None and not item.get("tried")]


def places(data: dict[str, Any], point: int) -> list[int]:
    """Return the index of each factor's value at a point; the last factor of a grid varies fastest."""
    if data["sampled"]:
        return [point] * len(data["factors"])
    indices = []
    for factor in reversed(data["factors"]):
        point, index = divmod(point, len(factor["values"]))
        indices.append(index)
    return indices[::-1]
