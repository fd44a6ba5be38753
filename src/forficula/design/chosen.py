"""Rules that choose the values of a sheet that its design does not give, with a reason for each value."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from forficula.arrays import Array
from forficula.design.sheets.crease_law_section import CreaseLawSection
from forficula.design.sheets.crease_sections import Crease, group_values, largest_extension, with_law
from forficula.design.sheets.sheet_sections import FacetSection
from forficula.pattern import CreasePattern, triangulated
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.shared_edges import shared_edges

if TYPE_CHECKING:
    from forficula.design.design import Design

DesignOf = TypeVar("DesignOf", bound="Design")

# thickness divided by the size of a facet: card of 0.2 mm has facets of 2 cm
_THICKNESS_RATIO = 1 / 100
_DENSITY, _MODULUS, _POISSON = 1270.0, 2e9, 0.3
# length scale L* of a crease divided by the thickness: creased sheets have 25 to 100, and 100 is the softest
_ORIGAMI_LENGTH = 100.0
# axial stiffness of a bar divided by the stiffness per length of a crease: with a smaller ratio the bars stretch
# visibly, with a larger one the timestep is short
_BAR_RATIO = 1e4
# bending stiffness of a facet divided by that of a crease, where no modulus is given
_BEND_RATIO = 10.0
# shares of critical damping: of a facet that swings on its crease, and of a sound wave that crosses a facet
_SWING_DAMPING, _SOUND_DAMPING = 0.5, 0.1


@dataclass(frozen=True, kw_only=True)
class Choice:
    """A value that a rule chooses.

    Attributes:
        section: section of the design.
        key: key in that section.
        value: chosen value, SI.
        reason: phrase that says why this value was chosen.
    """

    section: str
    key: str
    value: float
    reason: str


def choices(sheet: CreasePattern, facet: FacetSection, crease: Crease) -> tuple[Choice, ...]:
    """Choose the values that a design leaves out; the rules use the values that are given.

    Args:
        sheet: crease pattern of the design, SI.
        facet: section of the facets, with None for values to be chosen.
        crease: section of the creases, with None for values to be chosen.
    """
    made: list[Choice] = []
    law, crease = crease.law, with_law(crease)
    size = _facet_size(sheet)
    rigid = facet.kind == "rigid"

    def value(section: str, key: str, rule: tuple[float, str]) -> float:
        """Return the value of the design, or else the choice of a rule."""
        from_design: float | None = getattr(facet if section == "facet" else crease, key)
        if from_design is None:
            made.append(Choice(section=section, key=key, value=rule[0], reason=rule[1]))
        return rule[0] if from_design is None else from_design

    by_size = (_THICKNESS_RATIO * size, "1/100 of the size of a facet, as in card")
    of_law = law.thickness if isinstance(law, CreaseLawSection) else None
    thickness = value("facet", "thickness", by_size if of_law is None else (of_law, "to which crease.law applies"))
    density = value("facet", "density", (_DENSITY, "of PETG; paper has 0.8 g/cm^3"))
    if rigid and largest_extension(crease):
        damping = 2 * _SOUND_DAMPING * math.sqrt(largest_extension(crease) * density * thickness * size)
        reason = "a tenth of critical damping of a facet on the springs of its creases"
        value("crease", "extension_damping", (damping, reason))
    if rigid and crease.stiffness is not None:
        return tuple(made)
    poisson = value("facet", "poisson_ratio", (_POISSON, "of most plastics"))
    triangles = triangulated(sheet).pattern
    from_creases = facet.youngs_modulus is None and bool(crease.stiffness)
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
            (_BEND_RATIO * stiffness, "facets ten times as stiff as creases")
            if from_creases
            else (plate * float(bends.mean()), "plate stiffness D divided by a facet's width (Bergou et al. 2006)")
        )
        value("facet", "bend_stiffness", rule)
    sound = math.sqrt(modulus / density)
    crossing = (_SOUND_DAMPING * size / sound, "a tenth of the time in which sound crosses a facet")
    value("facet", "stretch_damping", crossing)
    inertia = density * thickness * size**3 / 3
    damping = 2 * _SWING_DAMPING * math.sqrt(stiffness * inertia)
    value("crease", "damping", (damping, "half of critical damping of a facet that swings on its crease"))
    return tuple(made)


def with_choices(design: DesignOf, made: Sequence[Choice]) -> DesignOf:
    """Return a design with the values that were chosen for it."""
    changes = {}
    for section in dict.fromkeys(choice.section for choice in made):
        values = {choice.key: choice.value for choice in made if choice.section == section}
        changes[section] = getattr(design, section).model_copy(update=values)
    return design.model_copy(update=changes)


def plate_stiffness(modulus: float, thickness: float, poisson: float) -> float:
    """Compute the bending stiffness of a plate, D = E t^3 / (12 (1 - nu^2)), N m (Kirchhoff)."""
    return modulus * thickness**3 / (12 * (1 - poisson**2))


def mean_bar_area(triangles: CreasePattern, thickness: float, poisson: float) -> float:
    """Compute the cross-section of the bars of a sheet of triangles, averaged by length, m^2.

    Under a uniform strain e, a sheet of area S and thickness t stores E S t e^2 / (1 - nu). Bars of area A store
    E A e^2 / 2 times the sum of their lengths. For every triangle the energies are equal if
    A = 2 S t / ((1 - nu) sum of lengths) (Filipov, Liu, Tachi, Schenk and Paulino 2017,
    doi 10.1016/j.ijsolstr.2017.05.028). A bar that borders two triangles has the sum of their areas.
    """
    areas = sum(facet_areas(triangles))
    tails, heads = triangles.vertices_coords[triangles.edges_vertices].transpose(1, 0, 2)
    length = float(np.linalg.norm(heads - tails, axis=1).sum())
    return 2 * areas * thickness / ((1 - poisson) * length)


def _modulus(triangles: CreasePattern, thickness: float, poisson: float, crease: Crease) -> tuple[float, str]:
    """Choose Young's modulus: that of a material, or one that makes the bars much stiffer than the given creases."""
    stiffest = max([crease.stiffness or 0.0, *(group_values(group).get("stiffness", 0.0) for group in crease.group)])
    if not crease.stiffness or not stiffest:
        return _MODULUS, "of PETG, or of paper"
    area = mean_bar_area(triangles, thickness, poisson)
    return _BAR_RATIO * stiffest / area, "E A of bars 1e4 times the stiffness per length of the stiffest crease"


def _facet_size(sheet: CreasePattern) -> float:
    """Compute the mean over all facets of the square root of their area, m."""
    return float(np.mean(np.sqrt(facet_areas(sheet))))


def facet_areas(sheet: CreasePattern) -> list[float]:
    """Compute the areas of the facets, m^2; of a facet that is not flat, its projection on its mean plane (Newell)."""
    normals = (polygon_normal(sheet.vertices_coords[list(corners)]) for corners in sheet.faces_vertices)
    return [float(np.linalg.norm(normal)) / 2 for normal in normals]


def _bend_shares(triangles: CreasePattern) -> Array:
    """Compute the stiffness per length of the springs along flat edges, divided by D, 1/m, (flat edge,).

    Two triangles of areas A and B bend about their common edge of length l with a stiffness of 3 D l^2 / (A + B), which
    is 3 D l / (A + B) per length (Bergou, Wardetzky, Harmon, Zorin and Grinspun 2006, doi 10.2312/SGP/SGP06/227-230).
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
