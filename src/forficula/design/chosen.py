"""Values of a sheet that its design does not give, each chosen by a rule with a reason."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from forficula.arrays import Array
from forficula.design.sheets.sheet_parts import Crease, FacetSection, largest_extension
from forficula.pattern import CreasePattern, triangulated
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.shared_edges import shared_edges

if TYPE_CHECKING:
    from forficula.design.design import Design

DesignOf = TypeVar("DesignOf", bound="Design")

# m/m, thickness by size of a facet: card of 0.2 mm has facets of 2 cm
_SLENDER = 1 / 100
_DENSITY, _MODULUS, _POISSON = 1270.0, 2e9, 0.3
# length scale of a crease by thickness: the softest of the 25 to 100 that creased sheets have
_ORIGAMI_LENGTH = 100.0
# axial stiffness of bars by stiffness of a crease by length: with less bars stretch visibly, with more steps are short
_STIFF_BARS = 1e4
# how much stiffer a facet bends than a crease where no modulus says it
_STIFF_BENDS = 10.0
# shares of critical damping: a facet that swings on its crease, and sound that crosses a facet
_SWING, _SOUND = 0.5, 0.1


@dataclass(frozen=True, kw_only=True)
class Choice:
    """A value that a rule chooses.

    Attributes:
        section: of the design.
        key: in that section.
        value: SI.
        reason: why it is this one, in a phrase.
    """

    section: str
    key: str
    value: float
    reason: str


def choices(sheet: CreasePattern, facet: FacetSection, crease: Crease) -> tuple[Choice, ...]:
    """Choose what a design leaves out; what is given counts where a rule needs it.

    Args:
        sheet: its pattern, SI.
        facet: its section, with None for what is to be chosen.
        crease: alike.
    """
    made: list[Choice] = []
    size = _facet_size(sheet)
    rigid = facet.kind == "rigid"

    def value(section: str, key: str, rule: tuple[float, str]) -> float:
        """What is given, or else what a rule chooses."""
        given: float | None = getattr(facet if section == "facet" else crease, key)
        if given is None:
            made.append(Choice(section=section, key=key, value=rule[0], reason=rule[1]))
        return rule[0] if given is None else given

    thickness = value("facet", "thickness", (_SLENDER * size, "1/100 of the size of a facet, as card has"))
    density = value("facet", "density", (_DENSITY, "of PETG; paper has 0.8 g/cm^3"))
    if rigid and largest_extension(crease):
        damping = 2 * _SOUND * math.sqrt(largest_extension(crease) * density * thickness * size)
        value("crease", "extension_damping", (damping, "a tenth of critical for a facet on springs in its creases"))
    if rigid and crease.stiffness is not None:
        return tuple(made)
    poisson = value("facet", "poisson_ratio", (_POISSON, "as most plastics have"))
    triangles = triangulated(sheet).pattern
    by_hand = facet.youngs_modulus is None and bool(crease.stiffness)
    modulus = value("facet", "youngs_modulus", _modulus(triangles, thickness, poisson, crease))
    plate = plate_stiffness(modulus, thickness, poisson)
    stiffness = value(
        "crease",
        "stiffness",
        (plate / (_ORIGAMI_LENGTH * thickness), "D / L*, L* of 100 thicknesses (Lechenault et al. 2014: 25 to 100)"),
    )
    if rigid:
        return tuple(made)
    bends = _bend_shares(triangles)
    if len(bends):
        rule = (
            (_STIFF_BENDS * stiffness, "facets ten times as stiff as creases")
            if by_hand
            else (plate * float(bends.mean()), "plate D over a facet's width (Bergou et al. 2006)")
        )
        value("facet", "bend_stiffness", rule)
    sound = math.sqrt(modulus / density)
    value("facet", "stretch_damping", (_SOUND * size / sound, "a tenth of the time in which sound crosses a facet"))
    inertia = density * thickness * size**3 / 3
    damping = 2 * _SWING * math.sqrt(stiffness * inertia)
    value("crease", "damping", (damping, "half of critical for a facet that swings on its crease"))
    return tuple(made)


def with_choices(design: DesignOf, made: Sequence[Choice]) -> DesignOf:
    """A design with values that were chosen for it."""
    changes = {}
    for section in dict.fromkeys(choice.section for choice in made):
        values = {choice.key: choice.value for choice in made if choice.section == section}
        changes[section] = getattr(design, section).model_copy(update=values)
    return design.model_copy(update=changes)


def plate_stiffness(modulus: float, thickness: float, poisson: float) -> float:
    """D = E t^3 / (12 (1 - nu^2)) of a plate that bends, N m (Kirchhoff)."""
    return modulus * thickness**3 / (12 * (1 - poisson**2))


def mean_bar_area(triangles: CreasePattern, thickness: float, poisson: float) -> float:
    """Cross-section of the bars of a sheet of triangles, mean by length, m^2.

    Stretched evenly by a strain e, a sheet of area S and thickness t stores E S t e^2 / (1 - nu), and bars of area A,
    E A e^2 / 2 times the sum of their lengths: the two agree where A = 2 S t / ((1 - nu) sum of lengths), for every
    triangle (Filipov, Liu, Tachi, Schenk and Paulino 2017, doi 10.1016/j.ijsolstr.2017.05.028). A bar on two triangles
    has the areas of both.
    """
    areas = sum(facet_areas(triangles))
    tails, heads = triangles.vertices_coords[triangles.edges_vertices].transpose(1, 0, 2)
    length = float(np.linalg.norm(heads - tails, axis=1).sum())
    return 2 * areas * thickness / ((1 - poisson) * length)


def _modulus(triangles: CreasePattern, thickness: float, poisson: float, crease: Crease) -> tuple[float, str]:
    """Of a material, or by which the bars are stiff enough beside creases of a given stiffness."""
    stiffest = max([crease.stiffness or 0.0, *(group.stiffness or 0.0 for group in crease.group)])
    if not crease.stiffness or not stiffest:
        return _MODULUS, "of PETG, or of paper"
    area = mean_bar_area(triangles, thickness, poisson)
    return _STIFF_BARS * stiffest / area, "E A of bars 1e4 times the stiffness by length of the stiffest crease"


def _facet_size(sheet: CreasePattern) -> float:
    """Root of the area of a facet, mean over all, m."""
    return float(np.mean(np.sqrt(facet_areas(sheet))))


def facet_areas(sheet: CreasePattern) -> list[float]:
    """Areas of the facets, m^2; of one that is not flat, of its projection on its own plane (Newell)."""
    normals = (polygon_normal(sheet.vertices_coords[list(corners)]) for corners in sheet.faces_vertices)
    return [float(np.linalg.norm(normal)) / 2 for normal in normals]


def _bend_shares(triangles: CreasePattern) -> Array:
    """By which D is the stiffness by length of the springs along flat edges, 1/m, (flat edge,).

    Bending by an angle between two triangles of areas A and B across their edge of length l takes 3 D l^2 / (A + B) of
    stiffness (Bergou, Wardetzky, Harmon, Zorin and Grinspun 2006, doi 10.2312/SGP/SGP06/227-230): 3 D l / (A + B) by
    length.
    """
    areas = facet_areas(triangles)
    ends = triangles.vertices_coords[triangles.edges_vertices]
    return np.array(
        [
            3 * float(np.linalg.norm(ends[edge, 1] - ends[edge, 0])) / (areas[left] + areas[right])
            for edge, _, _, left, right in shared_edges(triangles)
            if triangles.edges_assignment[edge] == "F"
        ]
    )
