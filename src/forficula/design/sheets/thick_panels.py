"""Thick panels of a design's sheet of rigid facets."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from forficula.arrays import Array
from forficula.design.section import ANGLE
from forficula.design.sheets.crease_sections import largest_extension
from forficula.design.sheets.crease_values import crease_key, creases_by_edge, stops
from forficula.design.sheets.sheet_creases import crease_sense
from forficula.errors import InputError
from forficula.pattern.facet_tree import facet_tree
from forficula.pattern.thick.split_sheet import split_sheet
from forficula.pattern.thick.thick_motion import fold_path, largest_angles
from forficula.pattern.thick.thick_sheet import ThickSheet, successive_path, thick_sheet
from forficula.quantities import show_quantity

if TYPE_CHECKING:
    from forficula.design.sheets.sheet import SheetDesign

_KEY = "facet.thickness_method"


def thick_panels(design: SheetDesign) -> ThickSheet | None:
    """Return the thick panels of a sheet; None if no method makes room for the thickness of its facets.

    Raises:
        InputError: the method cannot give the sheet this thickness.
    """
    method = design.facet.thickness_method
    if method is None or method == "none":
        return None
    return thick_sheet(design.drawn_sheet, design.panel_thickness, method, _whole_limits(design))


def panel_path(design: SheetDesign, poses: int) -> Array | None:
    """Return fold angles of thick panels along their fold path, rad, (pose, edge), as `fold_path`."""
    path = fold_path(design.drawn_sheet, _whole_limits(design), poses)
    return None if path is None else _with_strips(design, path)


def closing_path(design: SheetDesign, poses: int) -> Array | None:
    """Return fold angles at which the creases of thick panels close one after another, as `successive_path`.

    Args:
        design: design of the sheet.
        poses: number of poses for each crease.

    Returns:
        None without thick panels, or if creases do not move independently.
    """
    sheet, thick = design.drawn_sheet, thick_panels(design)
    if thick is None or any(link.closes for link in facet_tree(sheet)):
        return None
    folds = np.diag(largest_angles(sheet, _whole_limits(design)))
    return successive_path(thick, _with_strips(design, folds[folds.any(axis=1)]), poses)


def _with_strips(design: SheetDesign, angles: Array) -> Array:
    """Return fold angles of the sheet with strips for those of the drawn sheet, rad, (pose, edge)."""
    if design.facet.thickness_method != "split":
        return angles
    return split_sheet(design.drawn_sheet, design.panel_thickness).path(angles)


def _whole_limits(design: SheetDesign) -> tuple[tuple[float, float], ...]:
    """Return the limits of whole folds: of every edge of the sheet without strips, rad."""
    shares = design.sheet.edges_share.tolist()
    edges = len(design.drawn_sheet.edges_vertices)
    limits = zip(thick_limits(design)[:edges], shares[:edges], strict=True)
    return tuple((low / share, high / share) for (low, high), share in limits)


def thick_limits(design: SheetDesign) -> tuple[tuple[float, float], ...]:
    """Return the least and the largest fold angle of every edge, valley positive, rad."""
    sheet = design.sheet
    limits = [(0.0, 0.0)] * len(sheet.edges_vertices)
    for edge, crease in creases_by_edge(design).items():
        low, high = stops(design, edge, crease)
        limits[edge] = (low, high) if crease_sense(sheet, edge) > 0 else (-high, -low)
    return tuple(limits)


def check_thickness(design: SheetDesign) -> None:
    """Refuse a method for the thickness of facets that the sheet does not allow.

    Raises:
        InputError: the key, the rule and the value.
    """
    method = design.facet.thickness_method
    if method is None:
        return
    if design.facet.kind != "rigid":
        raise InputError(f'{_KEY}: need facet.kind = "rigid" for thick panels, got "{design.facet.kind}"')
    if largest_extension(design.crease):
        raise InputError(f'{_KEY}: need "none" where creases open (crease.extension), got "{method}"')
    for edge, crease in creases_by_edge(design).items():
        low, high = stops(design, edge, crease)
        if method != "tapered" and low < 0:
            raise InputError(
                f'{crease_key(design, edge, "back_limit")}: need 0 deg with {_KEY} = "{method}", because the sides of'
                f" the panels meet when flat, got {show_quantity(-low, ANGLE)} at crease {edge}"
            )
        if method == "tapered" and max(high, -low) >= math.pi:
            raise InputError(
                f"{crease_key(design, edge, 'fold_limit' if high >= math.pi else 'back_limit')}: need < 180 deg with"
                f' {_KEY} = "tapered", which trims panels to this angle, got 180 deg at crease {edge}'
            )
    try:
        thick_panels(design)
    except InputError as error:
        key = "facet.thickness" if str(error).startswith("need <=") else _KEY
        raise InputError(f"{key}: {error}") from None
