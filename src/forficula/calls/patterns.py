"""Calls about crease patterns."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from forficula.design import AnyDesign, as_design
from forficula.errors import InputError
from forficula.files import AnyPath
from forficula.pattern import CreasePattern

if TYPE_CHECKING:
    from forficula.goals.clicks.fan_fit import FanFit
    from forficula.goals.clicks.motion import ObservedMotion
    from forficula.pattern import PatternFacts, Trace


def pattern_facts(design: AnyDesign | CreasePattern) -> PatternFacts:
    """Analyse a crease pattern, as `forficula pattern` does: degrees of freedom, faults, flat-foldability.

    Args:
        design: design, its name, the path of a design file, a FOLD file or a drawing, or a crease pattern.

    >>> ff.pattern_facts("binder2025").title
    'earwig fan, 1 unit, 3 veins'
    """
    from forficula.design import design_pattern
    from forficula.pattern import pattern_facts as facts_of

    return facts_of(design if isinstance(design, CreasePattern) else design_pattern(as_design(design)))


def trace(
    picture: Any,
    size: str | float | Sequence[float],
    *,
    corners: str | Sequence[Sequence[float]] | None = None,
    straighten: str | float | None = None,
) -> Trace:
    """Trace a drawn crease pattern in a photograph, a scan or a drawing, as `forficula trace` does.

    Args:
        picture: path of a PNG or JPEG file, or an array of shape (height, width) or (height, width, 3) with whole
            numbers from 0 to 255, or numbers from 0 to 1.
        size: width and height of the sheet whose corners are found or given, such as "29.7 x 21 cm" or (0.297, 0.21) in
            m. One length is that of its longer side; the other side is then estimated. Without corners the size is that
            of the pattern.
        corners: corners of the sheet, x and y in pixels from the upper left corner of the picture, clockwise from the
            upper left one; "none" for a scan. If not given, they are found where the sheet is brighter than its ground.
        straighten: largest movement, such as "0.5 mm" or in m, by which vertices may move to make the pattern exactly
            symmetric and flat-foldable. By default nothing moves.

    Raises:
        InputError: a picture that cannot be read, a size or corners that are not allowed, no lines that enclose faces,
            or a movement beyond `straighten`.

    >>> import numpy as np
    >>> drawing = np.full((300, 400), 255)
    >>> drawing[[50, 51, 250, 251], 50:352] = 0
    >>> drawing[50:252, [50, 51, 200, 201, 350, 351]] = 0
    >>> ff.trace(drawing, "15 cm", corners="none")
    <Trace of a picture: 6 vertices, 7 edges, 1 doubtful>
    """
    from forficula.pattern.picture.picture_file import picture_of_array, read_picture
    from forficula.pattern.picture.trace_options import read_corners, read_length, read_size
    from forficula.pattern.picture.trace_picture import straightened_trace, trace_picture

    lengths = read_size(size)
    places, rectify = read_corners(corners)
    tolerance = None if straighten is None else read_length(straighten, "straighten")
    shown = read_picture(picture) if isinstance(picture, str | os.PathLike) else picture_of_array(picture)
    try:
        traced = trace_picture(shown, lengths, places, rectify=rectify)
    except InputError as error:
        raise InputError(f"{shown.name}: {error}" if shown.name else str(error)) from None
    return traced if tolerance is None else straightened_trace(traced, tolerance)


def trace_clicks(clicks: AnyPath | Mapping[str, object]) -> FanFit | ObservedMotion:
    """Fit a fan to clicked points of a wing, or compute angles over time from a film, as `forficula trace` does.

    Args:
        clicks: path of a file of clicked points, the name of one that the package contains, or its tables. Lists of
            points may be arrays of pixels, x to the right and y downwards, with nan where a point was not clicked. A
            film has a key `frame`.

    Returns:
        The fitted fan, with intervals of its numbers and deviations by vein; or angles over time, with observations for
        `identify`.

    Raises:
        InputError: no such file, a value that is not allowed, or points that do not determine the fan.

    >>> ff.trace_clicks("imitated-wing")
    <Fan of imitated-wing: 7 veins, 2.59 mm, 3.35 mm, 0.331 mm, 12.5 deg, residual 0.13 mm>
    """
    from forficula.goals.clicks.clicks_file import result_of_file, result_of_tables

    if isinstance(clicks, Mapping):
        return result_of_tables(clicks, Path())
    return result_of_file(os.fspath(clicks))
