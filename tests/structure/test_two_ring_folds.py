"""Two ring folds, folded by geometry alone: the layers of a stack are one pitch apart and do not intersect.

Rigid panels would close their pleats flat and then fold at both ring folds. So every vein and the margins on it are
turned over about the axis of the proximal bar, one vein after another, stacked a pitch apart, and folded by 90 deg at
both ring folds. Only the membrane between the margin of one vein and the axis of the next is stretched.
"""

import math
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, reject, settings
from hypothesis import strategies as st
from scipy.optimize import lsq_linear
from scipy.spatial.transform import Rotation

import forficula as ff
from forficula.analysis.crossing_panels import crossing_depths, panel_meshes
from forficula.pattern import EarwigFan, hub_points, ring_directions, ring_vertices
from forficula.structure import Structure, structure_of
from forficula.structure.fans.vein import Vein
from forficula.structure.tree import built_frames

REFERENCE = ff.load_design("binder2025", {"pattern.ring_folds": 2})


@dataclass(frozen=True)
class Stack:
    """A fan folded flat, its layers a pitch apart."""

    fan: EarwigFan
    structure: Structure

    def placed(self, bodies, places):
        """Where points of the flat sheet on these bodies lie, m, (point, 3)."""
        pairs = zip(np.asarray(bodies).tolist(), places, strict=True)
        return np.array([self._placed(*divmod(body, 3), place) for body, place in pairs])

    def _placed(self, vein, bar, place):
        axis = ring_directions(self.fan)[vein]
        for fold in reversed(range(bar)):
            hinge = ring_vertices(self.fan, fold=fold)[vein]
            # odd veins are valleys, and fold to the other side
            quarter = Rotation.from_rotvec((-1) ** vein * math.pi / 2 * axis)
            place = hinge + quarter.apply(place - hinge)
        return self._pleated(vein, place) + np.array([0, 0, self.fan.pitch * self._layer(vein)])

    def _pleated(self, vein, place):
        """Turned over about every proximal bar from this one to the first."""
        flat = replace(self.fan, ring_folds=1, pitch=0.0, gusset_height=0.0)
        hub, ring = hub_points(flat), ring_vertices(flat)
        for number in range(vein, 0, -1):
            along = (ring - hub)[number] / np.linalg.norm((ring - hub)[number])
            place = ring[number] + Rotation.from_rotvec(math.pi * along).apply(place - ring[number])
        return place

    def _layer(self, vein):
        """How many layers lie inside a vein; distal layers come to lie below the proximal ones."""
        return vein if self.fan.tangent == "right" else self.fan.vein_count - 1 - vein

    def bars(self):
        """Ends of the bars of every vein, (vein, bar, end, 3)."""
        origins, frames = built_frames(self.structure)
        ends = [
            self.placed([bar.body] * 2, [origins[bar.body], origins[bar.body] + frames[bar.body] @ bar.end])
            for bar in self.structure.bars
        ]
        return np.array(ends).reshape(self.fan.vein_count, 3, 2, 3)

    def crossing(self):
        """The largest depth of a panel inside another, m."""
        origins, frames = built_frames(self.structure)
        nodes = []
        for surface in (membrane.surface for membrane in self.structure.membranes):
            flat = origins[surface.bodies] + np.einsum("nij,nj->ni", frames[surface.bodies], surface.places)
            places = self.placed(surface.bodies, flat)
            nodes += [places[np.unique(surface.triangles[surface.panels == n])] for n in range(len(surface.names))]
        panels = zip(panel_meshes(self.structure), nodes, strict=True)
        return max(
            crossing_depths(one, current[None], other, present[None])[0]
            for (one, current), (other, present) in combinations(panels, 2)
        )


def stack_of(design):
    return Stack(fan=design.fan, structure=structure_of(design))


@st.composite
def thick_fans(draw):
    """Fans that a design accepts, their layers at least as far apart as their veins are thick."""
    diameter = draw(st.floats(1e-4, 6e-3))
    values = {
        "pattern.units": draw(st.integers(1, 3)),
        "pattern.tangent": draw(st.sampled_from(["left", "right"])),
        "pattern.hub_radius": draw(st.one_of(st.just(0.0), st.floats(0.001, 0.03))),
        "pattern.sector_angle": math.radians(draw(st.floats(8, 30))),
        "pattern.pitch": diameter * draw(st.floats(1, 2)),
        "vein.diameter": diameter,
        "membrane.thickness": diameter / 50,
        "membrane.margin": draw(st.floats(0.001, 0.05)),
        "membrane.margin_limit": draw(st.floats(0.1, 0.95)),
        "guard.stretch": 10.0,
    }
    try:
        return REFERENCE.with_values(values)
    except ff.InputError:
        reject()


def distance(one, other):
    """Distance of two straight segments, m: the minimum of a convex function of the positions on them."""
    ways = np.column_stack([one[1] - one[0], other[0] - other[1]])
    return float(np.sqrt(2 * lsq_linear(ways, other[0] - one[0], bounds=(0, 1)).cost))


@settings(max_examples=15)
@given(thick_fans())
def test_no_panels_intersect_when_layers_fold_rigidly(design):
    assert stack_of(design).crossing() == 0


@settings(max_examples=15)
@given(thick_fans())
def test_rigidly_folded_layers_lie_a_pitch_apart_and_bars_beside_each_other(design):
    pitch, bars = design.fan.pitch, stack_of(design).bars()
    proximal, distal = bars[:, 0, :, 2], bars[:, 2, :, 2]
    # level, and one layer above the other, no matter which vein has the lowest layer
    for heights in (proximal, distal):
        assert np.ptp(heights, axis=1) == pytest.approx(0, abs=1e-12)
        assert np.abs(np.diff(heights[:, 0])) == pytest.approx(pitch, rel=1e-9)
    lowest, highest = (order(pairs) for order, pairs in ((np.min, proximal), (np.max, distal)))
    assert lowest - highest == pytest.approx(design.fan.gusset_height, rel=1e-9)
    for one, other in combinations(bars[:4], 2):
        apart = min(distance(current, present) for current in one for present in other)
        assert apart >= pitch * (1 - 1e-6)


@pytest.mark.parametrize("tangent", ["left", "right"])
def test_margins_parallel_to_tilted_ring_folds_would_intersect_the_next_layer(monkeypatch, tangent):
    """The construction avoids this intersection, and this check detects it."""
    wide = REFERENCE.with_values({"pattern.units": 2, "pattern.tangent": tangent, "membrane.margin": "2.9 cm"})
    assert stack_of(wide).crossing() == 0
    monkeypatch.setattr(Vein, "margin_along", lambda *_: None)
    # structures of a design are cached, and another name gives another cache entry
    assert stack_of(wide.with_values({"name": "leaning"})).crossing() > 1e-4
