"""Clicked points of a fan, from a file or from arrays, and the design of the fan that fits them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, ClassVar

import numpy as np

from forficula.design import Design, load_design, scale_design
from forficula.design.file_fields import FolderName, entry
from forficula.design.section import Section
from forficula.errors import InputError
from forficula.goals.clicks.clicked_scale import clicked_point, clicked_points, picture_matrix, to_metres
from forficula.goals.clicks.different_veins import DifferentVeins
from forficula.goals.clicks.fan_fit import ROLES, FanFit, fit_fan
from forficula.goals.clicks.fan_least_squares import FanClicks
from forficula.names import listed
from forficula.pattern.picture.picture_file import read_picture
from forficula.quantities import as_written
from forficula.structure import structure_of

_REFERENCE = "binder2025"  # the design whose other values a fitted fan takes, scaled to its size
_Points = Annotated[Any, "list of [x, y] in pixels, [] where a point was not clicked"]


class FanClicksFile(Section):
    """Content of a file with clicked points of a fan."""

    about: ClassVar[str] = "Forficula clicks: points of a fan in a picture"

    name: FolderName = entry("name of the wing in outputs", "", left_out="the file's name")
    source: str = entry("source of the picture", "")
    picture: str | None = entry("path of the picture, which is drawn under the fit; not needed for the fit")
    scale: _Points = entry("two points at a known distance", left_out="needed without corners")
    length: Annotated[Any, "length"] = entry("distance of the two points of scale")
    corners: _Points = entry(
        "four corners of a rectangle in the plane of the wing, clockwise from the upper left one",
        left_out="needed without scale",
    )
    size: Annotated[Any, 'text such as "20 x 15 cm"'] = entry("width and height between the corners")
    ring: _Points = entry("points where the veins cross the ring fold, in the order of the veins", left_out="needed")
    tip: _Points = entry("ends of the veins, in the same order", left_out="needed")
    base: _Points = entry("points where the veins touch the hub, in the same order")
    hub: Annotated[Any, "[x, y] in pixels"] = entry("centre of the hub")
    numbers: Annotated[Any, "list of whole numbers"] = entry(
        "number of every clicked vein, if some veins between them were not clicked",
        left_out="derived from the angles between the veins",
    )


def fan_clicks(file: FanClicksFile, folder: Path) -> FanClicks:
    """Return the clicked points of a file, in m.

    Args:
        file: content of the file.
        folder: folder that the path of the picture is relative to.

    Raises:
        InputError: a value that is not allowed.
    """
    matrix = picture_matrix(file.scale, file.length, file.corners, file.size)
    lists = {key: clicked_points(value, key) for key in ROLES if (value := getattr(file, key)) is not None}
    for key in ("ring", "tip"):
        if key not in lists:
            raise InputError(f"{key}: is missing; give one point for each vein, or [] where it was not clicked")
    counts = {key: len(points) for key, points in lists.items()}
    if len(set(counts.values())) > 1:
        per_key = listed([f"{count} in {key}" for key, count in counts.items()])
        raise InputError(f"{min(counts, key=lambda key: counts[key])}: need the same number of veins, got {per_key}")
    count = counts["ring"]
    points = np.full((count, 3, 2), np.nan)
    for key, places in lists.items():
        points[:, ROLES.index(key)] = to_metres(matrix, places)
    return FanClicks(
        points=points,
        hub=None if file.hub is None else to_metres(matrix, clicked_point(file.hub, "hub")),
        numbers=_numbers(file.numbers, count),
        matrix=matrix,
        picture=None if file.picture is None else read_picture(folder / file.picture),
        name=file.name,
    )


def _numbers(value: object, count: int) -> tuple[int, ...] | None:
    if value is None:
        return None
    numbers = value.tolist() if isinstance(value, np.ndarray) else value
    rule = f"numbers: need {count} whole numbers that begin with 0 and rise, one for each clicked vein"
    if not isinstance(numbers, Sequence) or isinstance(numbers, str) or len(numbers) != count:
        raise InputError(f"{rule}, got {as_written(numbers)}")
    whole = all(isinstance(number, int) and not isinstance(number, bool) for number in numbers)
    if not whole or numbers[0] != 0 or sorted(set(numbers)) != list(numbers):
        raise InputError(f"{rule}, got {as_written(numbers)}")
    return tuple(numbers)


def fitted_fan(clicks: FanClicks) -> FanFit:
    """Fit a fan to clicked points, and add the designs of the fan and of the fan with different veins.

    The other values of the designs are those of binder2025, scaled to the size of the fan.

    Raises:
        InputError: too few points, or points that do not determine the fan.
    """
    fit = fit_fan(clicks)
    units = max((fit.vein_count) // 2, 1)
    values = {
        "pattern.proximal_length": _rounded(fit.proximal_length.value),
        "pattern.distal_length": _rounded(fit.distal_length.value),
        "pattern.hub_radius": _rounded(fit.hub_radius.value),
        "pattern.sector_angle": math.radians(_rounded(math.degrees(fit.sector_angle.value))),
        "pattern.units": units,
        "pattern.tangent": fit.tangent,
    }
    name, doubts = clicks.name or "fitted-fan", list(fit.doubts)
    try:
        design = _design(values, name, "fitted to clicked points of a picture")
    except InputError as error:
        design = None
        doubts.append(f"No design has these values: {error}.")
    return replace(fit, design=design, different=_with_design(fit.different, values, name), doubts=tuple(doubts))


def _rounded(value: float) -> float:
    """Return a value with six significant digits, more than clicks determine."""
    return float(f"{value:.6g}")


def _with_design(different: DifferentVeins | None, common: Mapping[str, object], name: str) -> DifferentVeins | None:
    if different is None:
        return None
    values = dict(common)
    for key, sizes in (
        ("proximal_length", different.proximal_lengths),
        ("distal_length", different.distal_lengths),
        ("sector_angle", different.sector_angles),
    ):
        mean = float(np.mean(sizes))
        values[f"pattern.{key}"] = _rounded(mean)
        values[f"pattern.{key.split('_')[0]}_shares"] = [round(size / mean, 6) for size in sizes]
    values["pattern.hub_radius"] = _rounded(different.hub_radius)
    try:
        design = _design(values, f"{name}-different-veins", "veins fitted one by one to clicked points of a picture")
    except InputError:
        return different
    return replace(different, design=design)


def _design(values: Mapping[str, object], name: str, source: str) -> Design:
    reference = load_design(_REFERENCE)
    pattern = reference.pattern  # type: ignore[attr-defined]
    factor = min(
        float(values[f"pattern.{key}"]) / getattr(pattern, key)  # type: ignore[arg-type]
        for key in ("proximal_length", "distal_length")
    )
    # the damping of membranes is scaled, too: 1 ms is longer than a small wing takes to fold, and needs steps of 0.1 µs
    scaled = scale_design(reference, factor)
    about = f"pattern {source}; other values are those of {_REFERENCE}, scaled to {factor:.4g} times its size"
    design = scaled.with_values(
        {**values, "name": name, "source": about, "shows": None, "reproduces": None, "protocol.timestep": "auto"}
    )
    structure_of(design)
    return design
