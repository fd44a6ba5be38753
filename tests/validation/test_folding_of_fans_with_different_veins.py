"""A fan with different veins folds flat and rigidly, and its folding ratio is that of independently folded polygons.

The checks share no code with the package. Flat folding is computed in the plane, as complex numbers: crossing a crease
reflects the next facet, z -> a conj(z) + b. A fold that closes around every vertex is a fold of the sheet. The outline
is the convex hull by Andrew's monotone chain, and its area follows from the shoelace formula. For a fan without a hub,
the folded outline is a pentagon with known corners.
"""

import math
from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula import load_design, structure_of
from forficula.analysis.package import flat_package
from forficula.pattern import (
    EarwigFan,
    creases_inside,
    earwig_pattern,
    fan_fold_angles,
    flat_fold,
    folded_coordinates,
    kawasaki_residuals,
    ring_ratios,
    sectors_between,
)
from tests.different_fans import different_fans
from tests.pattern.closing import closure_residual


def reflected_facets(pattern):
    """Fold a pattern flat by reflections; return the folded facets as complex numbers, and the largest gap."""
    flat = pattern.vertices_coords[:, 0] + 1j * pattern.vertices_coords[:, 1]
    sides = {}
    for facet, corners in enumerate(pattern.faces_vertices):
        for one, other in zip(corners, np.roll(corners, -1), strict=True):
            sides.setdefault(frozenset((int(one), int(other))), []).append(facet)
    # a facet's map is z -> turn * z + shift, of the conjugate of z if it is turned over
    maps, queue = {0: (1.0 + 0j, 0j, False)}, [0]

    def mapped(facet, points):
        turn, shift, over = maps[facet]
        return turn * (np.conj(points) if over else points) + shift

    for facet in queue:
        for side, (one, *more) in sides.items():
            if not more or facet not in (one, more[0]):
                continue
            neighbour = more[0] if facet == one else one
            if neighbour in maps:
                continue
            tail, head = (flat[vertex] for vertex in side)
            along = (head - tail) / abs(head - tail)
            # reflection about the crease: z -> along^2 conj(z - tail) + tail, then the map of the facet
            turn, shift, over = maps[facet]
            square, still = along**2, tail - along**2 * np.conj(tail)
            maps[neighbour] = (
                (turn * np.conj(square), turn * np.conj(still) + shift, False)
                if over
                else (turn * square, turn * still + shift, True)
            )
            queue.append(neighbour)
    facets = [mapped(facet, flat[list(corners)]) for facet, corners in enumerate(pattern.faces_vertices)]
    places = {}
    for corners, points in zip(pattern.faces_vertices, facets, strict=True):
        for vertex, point in zip(corners, points, strict=True):
            places.setdefault(vertex, []).append(point)
    gap = max(float(np.ptp(np.real(points)) + np.ptp(np.imag(points))) for points in places.values())
    return facets, np.array([places[vertex][0] for vertex in range(len(flat))]), gap


def hull_area(points):
    """Compute the area of the convex hull of complex numbers by Andrew's monotone chain and the shoelace formula."""
    ordered = sorted({(point.real, point.imag) for point in points.tolist()})

    def chain(places):
        hull = []
        for x, y in places:
            while len(hull) > 1:
                (a, b), (c, d) = hull[-2:]
                if (c - a) * (y - b) - (d - b) * (x - a) > 0:
                    break
                hull.pop()
            hull.append((x, y))
        return hull[:-1]

    x, y = np.array(chain(ordered) + chain(ordered[::-1])).T
    return 0.5 * abs(float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)))


def shoelace(points):
    x, y = points.real, points.imag
    return 0.5 * abs(float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)))


@settings(max_examples=60)
@given(different_fans())
def test_every_ring_vertex_of_different_veins_satisfies_kawasakis_condition(holds, fan):
    residual = np.abs(kawasaki_residuals(earwig_pattern(fan))).max()
    holds("residual of Kawasaki's condition", residual, below=1e-12, unit="rad", by="Kawasaki 1989")


@settings(max_examples=60)
@given(different_fans(), st.one_of(st.just(math.pi), st.floats(0.05, math.pi)))
def test_different_veins_fold_rigidly_each_at_its_rate(holds, agree, fan, pleat):
    pattern, folds = earwig_pattern(fan), fan_fold_angles(fan, pleat)
    left = [
        closure_residual(sectors_between(pattern, vertex, around), folds[around])
        for vertex, around in creases_inside(pattern)
    ]
    holds("rotation left around a vertex", left, below=1e-12, by="Belcastro and Hull 2002")
    if pleat < 3.0:
        roles = np.array(pattern.edges_role)
        ring = np.tan(np.abs(folds[roles == "ring"]).mean() / 2)
        veins = np.tan(np.abs(folds[roles == "proximal"][1:-1]) / 2)
        agree("tan(ring / 2)", ring_ratios(fan)[1:-1] * veins, ring, by="m tan(pleat / 2) of every vein", rel=1e-9)


@settings(max_examples=60)
@given(different_fans())
def test_different_veins_fold_flat_as_reflected_polygons(holds, agree, fan):
    pattern, size = earwig_pattern(fan), fan.proximal_length + fan.distal_length
    facets, places, gap = reflected_facets(pattern)
    holds("gap between reflected facets divided by the vein's length", gap / size, below=1e-12, by="reflections")
    fold = flat_fold(pattern)
    ours = fold.places[:, 0] + 1j * fold.places[:, 1]
    agree("folded positions divided by the vein's length", np.abs(ours - places) / size, 0, by="reflections", abs=1e-12)
    agree("area of the sheet", fold.area / size**2, sum(map(shoelace, facets)) / size**2, by="folded facets", rel=1e-12)
    holds("height of the folded sheet", np.abs(fold.places[:, 2]).max() / size, below=1e-12)


def test_the_folding_ratio_of_a_design_is_that_of_reflected_polygons(agree):
    design = load_design("graded-fan", {"vein.diameter": "1e-9 m"})
    structure = structure_of(design)
    facets, places, _ = reflected_facets(structure.appearance.pattern)
    ratio = sum(map(shoelace, facets)) / hull_area(places)
    agree("folding ratio", flat_package(structure).folding_ratio, ratio, by="hull of reflected polygons", rel=1e-6)


def test_without_a_hub_the_folded_outline_is_a_pentagon(agree):
    """Panels lie on top of one another in a triangle at the centre and a trapezoid that is folded back onto it."""
    ring, distal, sector = 0.12, 0.07, math.radians(16)
    ratios, known = [], []
    for units in (1, 2, 4):
        fan = EarwigFan(proximal_length=ring, distal_length=distal, hub_radius=0.0, sector_angle=sector, units=units)
        _, places, _ = reflected_facets(earwig_pattern(fan))
        half = sector / 2
        chord, tips = ring * math.cos(half), (ring - distal) * math.cos(half)
        near, far = ring * math.sin(half), (ring + distal) * math.sin(half)
        pentagon = tips * far + (chord - tips) * (far + near)
        open_area = 2 * units * (ring + distal) ** 2 * math.sin(sector) / 2
        known.append(open_area / pentagon)
        ratios.append(flat_fold(earwig_pattern(fan)).area / hull_area(places))
        assert flat_fold(earwig_pattern(fan)).layers == 4 * units
    agree("folding ratio of 1, 2 and 4 units", ratios, known, by="pentagon", rel=1e-12)


def test_a_margin_of_half_a_bar_follows_from_steiners_formula(agree):
    design = load_design("binder2025", {"vein.diameter": "4 mm"})
    structure = structure_of(design)
    facets, places, _ = reflected_facets(structure.appearance.pattern)
    # the hull's outline by support widths: the mean width of a convex figure times pi is its perimeter (Cauchy)
    angles = np.linspace(0, math.pi, 20001)[:-1]
    widths = np.ptp(np.real(places[:, None] * np.exp(-1j * angles)), axis=0)
    radius = 0.002
    area = hull_area(places) + radius * math.pi * widths.mean() + math.pi * radius**2
    ratio = sum(map(shoelace, facets)) / area
    agree("folding ratio", flat_package(structure).folding_ratio, ratio, by="Steiner and Cauchy", rel=1e-6)
    assert flat_package(structure).height == 4 * 0.004


def test_layers_of_strips_are_counted():
    strip = structure_of(load_design("letter-fold"))
    assert flat_package(strip).layers == 3
    assert replace(flat_package(strip), folding_ratio=3.0).folding_ratio > flat_package(strip).folding_ratio


def crossed_facets(pattern, folded):
    """Return pairs of facets without a common vertex, where a side of one facet passes through the other."""
    faces = pattern.faces_vertices
    triangles = [(number, face[:1] + face[at : at + 2]) for number, face in enumerate(faces) for at in (1, 2)]
    pairs = set()
    for one, corners in triangles:
        for other, through in triangles:
            if set(faces[one]) & set(faces[other]):
                continue
            plane = folded[list(through)]
            normal = np.cross(plane[1] - plane[0], plane[2] - plane[0])
            for start, end in zip(folded[list(corners)], np.roll(folded[list(corners)], -1, axis=0), strict=True):
                before, after = (start - plane[0]) @ normal, (end - plane[0]) @ normal
                if before * after >= 0:
                    continue
                place = start + before / (before - after) * (end - start)
                sides = np.cross(np.roll(plane, -1, axis=0) - plane, place - plane) @ normal
                if sides.min() > 1e-12 * (normal @ normal):
                    pairs.add((one, other))
    return pairs


def test_rigid_panels_of_the_named_fan_do_not_pass_through_each_other(agree):
    fan = load_design("graded-fan").fan
    pattern = earwig_pattern(fan)
    counts = [
        len(crossed_facets(pattern, folded_coordinates(pattern, fan_fold_angles(fan, math.radians(pleat)))))
        for pleat in (30, 90, 150, 175)
    ]
    agree("pairs of facets that cross at pleats of 30 to 175 deg", counts, 0, by="sides through triangles")
