"""Load paths of forficula agree with published examples of MERLIN for the same bars and rotational springs.

K. Liu and G. H. Paulino 2017, "Nonlinear mechanics of non-rigid origami: an efficient computational approach", Proc. R.
Soc. A 473, 20170348, doi 10.1098/rspa.2017.0348. The reference numbers were computed with MERLIN's first version (the
scripts Kresling_Folding, Miura_Bistable and Miura_Folding of its release with that paper, with their parameters and
without plots) under GNU Octave 7.3.0. They are the displacement of the loaded points, the load factor and the stored
energy at some increments. The source was the public repository alejaboterob/origami at commit 7a13428 (with ConfigMiura
from MERLIN2; the Miura examples have 5 x 5 cells in the copy in hugo-peni/ORIGAMI-STUDIO), not the authors' own page,
and only the abstract of the paper was available for comparison. MERLIN has no units; m, N and J are used here.

MERLIN's bars follow Ogden's law. The release uses the exponents 5 and 1: the nominal stress is E ((1 + e)^4 - 1) / 4 at
an engineering strain e. Bars of forficula are linear in e, which is the same law with the exponents 2 and 1. Every
example was therefore run twice. With the exponents 2 and 1 both programs must agree to the precision of their solvers:
MERLIN ends an increment when the last correction of all displacements together is below 1e-6. With the exponents of the
release they differ by the nonlinearity of the law, whose first term is 3/2 e^2.
"""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pytest

from forficula.statics.net.energy import built_shape
from forficula.statics.net.load import no_load
from forficula.statics.net.load_path import LoadPath, load_path
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net import Net
from tests.statics.net.nets import miura, sheet

LIMITS_OF_MERLIN = 2e-5  # relative accuracy of a parabola through three of its increments
LAW = 3 / 2  # times the strain: relative difference of a bar's force between both laws


class Followed(NamedTuple):
    """A path, and the coordinates that the load pushes, each with its factor and sign."""

    net: Net
    path: LoadPath
    pushed: tuple[list[int], int]

    def moved(self, point):
        nodes, axis = self.pushed
        return float(np.mean(self.net.nodes[nodes, axis] - point.shape.positions[nodes, axis]))

    def nearest(self, moved, factor):
        """Return the nearest point of the path, and the point near it with exactly that load factor."""
        size, height = (max(abs(item(point)) for point in self.path.points) for item in (self.moved, _factor))
        near = min(
            self.path.points,
            key=lambda point: np.hypot((self.moved(point) - moved) / size, (point.factor - factor) / height),
        )
        rising = factor > near.factor
        way = {"factor": near.factor, "target": factor, "rising": rising, "step": size / 50}
        return load_path(self.net, near.shape, self.path.load, **way).points[-1]


def _factor(point):
    return point.factor


def follow(net, nodes, axis, *, lock, step, until, increments=150):
    """Push nodes against an axis; springs rest as built and lock within an angle from contact, deg."""
    rest, room = built_shape(net).angles, np.pi - np.deg2rad(lock)
    law = replace(net.creases.law, rest_angle=rest, lock_below=-room, lock_above=room)
    net = replace(net, creases=replace(net.creases, law=law))
    load = no_load(net)
    load.forces[nodes, axis] = -1.0
    start = net.nodes[nodes, axis].mean()

    def over(point):
        return start - point.shape.positions[nodes, axis].mean() > until

    path = load_path(net, built_shape(net), load, step=step, increments=increments, stop=over)
    assert path.ended == "stop"
    return Followed(net=net, path=path, pushed=(nodes, axis))


def kresling(layers, *, step, until):
    """Kresling_Folding: octagons of radius 1, layers of height 1 and 45 deg; EA 500, springs 1e-3 by length.

    The release has five layers; a single one, of the same numbers, has one path.
    """
    sides, nodes, facets = 8, [], []
    for level in range(layers + 1):
        turn = 2 * np.pi / sides * (np.arange(sides) + level)
        nodes.append(np.stack((np.cos(turn), np.sin(turn), 0 * turn + level), axis=1))
        for side in range(sides if level else 0):
            below, beside = (level - 1) * sides + side, (level - 1) * sides + (side + 1) % sides
            facets += [(below, beside, beside + sides), (below, beside + sides, below + sides)]
    net, _ = sheet(np.concatenate(nodes), facets, axial=500.0, crease=1e-3, held=range(sides))
    return follow(net, list(range(layers * sides, (layers + 1) * sides)), 2, lock=45, step=step, until=until)


@pytest.fixture(scope="module")
def cell():
    return kresling(1, step=0.02, until=0.96)


@pytest.fixture(scope="module")
def popped():
    """Miura_Bistable: 5 x 5 cells, sides 2, 60 deg, facets inclined by 30 deg, pushed in the middle."""
    held = [0, (110, 1), (110, 2)] + [(node, axis) for node in range(2, 11, 2) for axis in (0, 2)]
    held += [(110 + node, 2) for node in range(2, 11, 2)]
    nodes, facets = miura(10, 10, side=2.0, other=2.0, fold=np.pi / 6)
    net, _ = sheet(nodes, facets, axial=1e3, crease=0.1, facet=1.0, held=held)
    return follow(net, [60], 2, lock=45, step=0.08, until=2.6)


def folded_sheet(*, stiffer=1.0):
    """Miura_Folding: the same sheet, nearly flat, of far stiffer bars and facets; one edge is pushed to the other."""
    held = (
        [(0, 1)]
        + [(node, 0) for node in range(11)]
        + [(edge + node, 2) for edge in (0, 110) for node in range(0, 11, 2)]
    )
    nodes, facets = miura(10, 10, side=2.0, other=2.0, fold=np.deg2rad(15))
    net, _ = sheet(nodes, facets, axial=1e5 * stiffer, crease=0.1, facet=1e4 * stiffer, held=held)
    return follow(net, list(range(110, 121)), 0, lock=0.1, step=0.4, until=12)


@pytest.fixture(scope="module")
def folded():
    return folded_sheet()


WORDS = {"cell": "a Kresling cell", "popped": "a popped Miura sheet", "folded": "a folded Miura sheet"}
# displacement, load factor and energy of MERLIN, exponents 2 and 1
CELL = [
    (0.04763627, 0.29952872, 0.06441603),
    (0.20726811, 0.34937634, 0.57020657),
    (0.32667364, 0.14038549, 0.80437122),
    (0.45070489, -0.02224558, 0.85541243),
    (0.76828496, -0.07993133, 0.64315487),
    (0.88154259, -0.03801664, 0.58856000),
    (0.93889807, -0.00939354, 0.57734447),
]
POPPED = [
    (0.22016436, 0.79518269, 0.08874882),
    (0.63791475, 1.98429231, 0.69008362),
    (1.23554123, 1.85515571, 1.99671380),
    (1.36498041, 0.50618903, 2.19728859),
    (1.24074271, -0.84795111, 2.22443478),
    (1.75604524, -0.54689805, 1.53084995),
    (2.12594766, 0.81416973, 1.57724253),
    (2.55401423, 2.46431462, 2.27687873),
]
# exponents 5 and 1: strains stay below 6e-5, where both laws agree
FOLDED = [
    (0.29553042, 0.65966603, 1.40159730),
    (0.77839684, 0.83015372, 5.50092526),
    (3.15910231, 0.76406713, 26.81875927),
    (5.78355373, 0.69418150, 47.70542671),
    (11.85234945, 0.69236744, 93.15862889),
]


@pytest.mark.parametrize(("followed", "published"), [("cell", CELL), ("popped", POPPED), ("folded", FOLDED)])
def test_displacements_and_energies_equal_those_of_merlin_at_its_loads(request, agree, followed, published):
    name, followed = WORDS[followed], request.getfixturevalue(followed)
    points = [followed.nearest(moved, factor) for moved, factor, _ in published]
    assert [point.factor for point in points] == [factor for _, factor, _ in published]
    moved, _, energy = zip(*published, strict=True)
    result = [followed.moved(point) for point in points]
    agree(f"displacement of {name}", result, moved, unit="m", by="MERLIN", abs=1e-6)
    agree(f"energy of {name}", [point.energy for point in points], energy, unit="J", by="MERLIN", rel=1e-6)


@pytest.mark.parametrize(
    ("followed", "linear", "release", "strain"),
    [
        ("cell", [(0.123296, 0.4308457), (0.640406, -0.1013869)], [0.4322978, -0.1021259], 0.0127),
        ("popped", [(0.941917, 2.3145698), (1.263116, -1.7604308)], [2.3117834, -1.7516115], 0.0124),
        ("folded", [(1.147417, 0.8463599), (8.655338, 0.6748023)], [0.8463599, 0.6748023], 6e-5),
    ],
)
def test_snap_loads_equal_those_of_merlin(request, agree, followed, linear, release, strain):
    """With linear bars to the precision of limits from increments, with the release's bars to that of the law.

    For these, MERLIN was run with a quarter, a third and a fifth of the release's first load factor, because a parabola
    through increments that are farther apart determines the second limit of the popped sheet only to 2e-4.
    """
    name, followed = WORDS[followed], request.getfixturevalue(followed)
    limits = [event.point for event in followed.path.events if event.kind == "limit"]
    loads = [factor for _, factor in linear]
    agree(
        f"limit loads of {name}", [limit.factor for limit in limits], loads, unit="N", by="MERLIN", rel=LIMITS_OF_MERLIN
    )
    for limit, (moved, _), of_release in zip(limits, linear, release, strict=True):
        # the path is flat there
        agree(f"displacement at the limit, {name}", followed.moved(limit), moved, unit="m", by="MERLIN", rel=1e-3)
        by, allowed = "MERLIN's own bars, as far as they are linear", LIMITS_OF_MERLIN + LAW * strain
        agree(f"limit loads of {name}", limit.factor, of_release, unit="N", by=by, rel=allowed)


@pytest.mark.parametrize(
    ("followed", "rests"),
    [
        ("cell", [(0.428861, 0.861963), (0.953097, 0.579481)]),
        ("popped", [(1.325522, 2.185162), (1.907859, 1.489020)]),
    ],
)
def test_unloaded_rest_shapes_equal_those_of_merlin_up_to_the_nonlinearity_of_its_bars(request, agree, followed, rests):
    name, followed = WORDS[followed], request.getfixturevalue(followed)
    for moved, energy in rests:
        point = followed.nearest(moved, 0.0)
        by, allowed = "MERLIN's own bars, as far as they are linear", LAW * 0.0127
        agree(f"displacement of {name} at rest", followed.moved(point), moved, unit="m", by=by, rel=allowed)
        agree("its energy", point.energy, energy, unit="J", by=by, rel=allowed)


def test_the_popped_miura_sheet_is_stable(agree, popped):
    """The second state of the release's example is stable."""
    rest = minimum(popped.net, popped.nearest(1.907859, 0.0).shape)
    assert rest.stable
    moved = popped.net.nodes[60, 2] - rest.shape.positions[60, 2]
    agree("displacement of its middle", moved, 1.907859, unit="m", by="MERLIN", rel=1e-3)
    agree("its energy", rest.energy, 1.489020, unit="J", by="MERLIN", rel=1e-3)


def test_the_load_path_of_a_tower_of_five_layers_equals_that_of_merlin_until_it_snaps(agree):
    """The release's own number of layers.

    Beyond, there is no one path to compare: several layers may snap, and increments of MERLIN that are as long as the
    release's pass from one branch onto another there, onto different ones with either law.
    """
    tower = kresling(5, step=0.02, until=0.52)
    for moved, factor, energy in [
        (0.18243922, 0.22094027, 0.17766632),
        (0.34999012, 0.32399197, 0.55165869),
        (0.47824383, 0.35592684, 0.90358869),
    ]:
        point = tower.nearest(moved, factor)
        agree("displacement of the tower", tower.moved(point), moved, unit="m", by="MERLIN", abs=1e-6)
        agree("its energy", point.energy, energy, unit="J", by="MERLIN", rel=1e-6)
    limit = next(event.point for event in tower.path.events if event.kind == "limit")
    agree("its limit load", limit.factor, 0.3578908, unit="N", by="MERLIN", rel=LIMITS_OF_MERLIN)
    by, allowed = "MERLIN's own bars, as far as they are linear", LIMITS_OF_MERLIN + LAW * 0.0063
    agree("its limit load", limit.factor, 0.3581151, unit="N", by=by, rel=allowed)


def closed_form(moved):
    """Return load and energy of the sheet with rigid facets, at a displacement of its edge.

    From the width and the two fold angles of a Miura sheet by the inclination of its facets (Schenk and Guest 2013,
    doi 10.1073/pnas.1217998110, equations 1 to 5): ten facets across, 90 inner edges of either kind, each of length 2.
    """
    tangent = np.tan(np.pi / 3)

    def width(tilt):
        return 20 * np.cos(tilt) * tangent / np.sqrt(1 + (np.cos(tilt) * tangent) ** 2)

    def angles(tilt):
        return np.array([2 * tilt, 2 * np.arctan(np.cos(np.pi / 3) * np.tan(tilt))])

    def energy(tilt):
        return 0.1 * 2 * 90 / 2 * np.sum((angles(tilt) - angles(np.deg2rad(15))) ** 2)

    low, high = np.deg2rad(15), np.deg2rad(89)
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if width(np.deg2rad(15)) - width(middle) < moved else (low, middle)
    slope = (energy(low + 1e-5) - energy(low - 1e-5)) / (width(low - 1e-5) - width(low + 1e-5))
    return slope / 11, energy(low)


def test_a_sheet_with_stiffer_facets_approaches_rigid_folding_in_proportion_to_its_compliance(agree, holds, folded):
    """What is left between the release's example and rigid folding is the give of its bars and facets, and no more."""
    left = []
    for followed in (folded, folded_sheet(stiffer=10.0)):
        points = followed.path.points[4::8]
        ways = [(point.factor, point.energy, *closed_form(followed.moved(point))) for point in points]
        left.append([(factor / load - 1, stored / energy - 1) for factor, stored, load, energy in ways])
    known = "rigid facets, Schenk and Guest 2013"
    holds("difference of load and energy from the closed form", np.abs(left[0]).max(), below=4e-4, by=known)
    agree("a tenth of this difference", np.array(left[0]) / 10, left[1], by="facets ten times as stiff", abs=2e-6)
