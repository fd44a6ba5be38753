"""The table of all points of a page, of the data that its script has."""

from __future__ import annotations

from typing import Any

from forficula.show.page.parts.html import paragraph, table

# points beyond which a table is a thing for other programs
_MOST_ROWS = 3000


def has_rows(data: dict[str, Any]) -> bool:
    """Whether a table of the points is one for people."""
    return int(data["points"]) <= _MOST_ROWS


def points_table(data: dict[str, Any]) -> str:
    """Every point as a row; the script adds filter, order and links."""
    if not has_rows(data):
        return paragraph(
            f"The {data['points']} {data['noun']}s are too many for a table here; {data['file']} has them all."
        )
    factors, numbers = data["factors"], _columns(data)
    units = [(each["name"], each["unit"]) for each in factors] + [(each["title"], each["unit"]) for each in numbers]
    named = [f"{name} ({unit})" if unit else name for name, unit in units]
    headings = [data["noun"], *named[: len(factors)], "outcome", *named[len(factors) :]]
    rows = []
    for point, status in enumerate(data["statuses"]):
        values = [factor["texts"][place] for factor, place in zip(factors, places(data, point), strict=True)]
        cells = ["—" if (value := each["values"][point]) is None else f"{value:.4g}" for each in numbers]
        rows.append([str(point + 1), *values, status, *cells])
    return table(f"One row a {data['noun']}, as in {data['file']}; numbers to four digits", headings, rows)


def _columns(data: dict[str, Any]) -> list[dict[str, Any]]:
    """The quantities of which a point has one value."""
    return [each for each in data["quantities"] if each["values"] is not None and not each.get("tried")]


def places(data: dict[str, Any], point: int) -> list[int]:
    """Number of each factor's value at a point: the last factor runs fastest, drawn points have their own values."""
    if data["sampled"]:
        return [point] * len(data["factors"])
    found = []
    for factor in reversed(data["factors"]):
        point, place = divmod(point, len(factor["values"]))
        found.append(place)
    return found[::-1]
