"""Colours of structures whose bodies belong to named groups."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.patches import Patch

from forficula.analysis import measure
from forficula.analysis.energy_by_mechanism import energy_shares
from forficula.design import load_design
from forficula.show.export.scene import scene_of
from forficula.show.page.data.shape_mesh import shape_mesh
from forficula.show.page.playback import clip_data, legend_data, make_clip
from forficula.show.structure.painted_shape import BAR_TINTS, TINTS, paint_shape, shape_handles
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import surface_at
from forficula.show.structure.viewpoint import readable_view
from forficula.structure import structure_of
from forficula.study.running.runs import run
from tests.show.joined import joined_run, joined_structure

NAMES = ("fan", "midwing", "clasp")


@pytest.fixture(scope="module")
def parts(reference_run):
    """A fan of bars and membranes, plates whose creases open, and a sheet of nodes, each 0.2 m from the next."""
    stage = {"hold": "0 s", "drive": "none", "until": "time", "name": "settle", "time_limit": "2 ms"}
    short = {"protocol.stages": [stage]}
    others = [run(load_design(name, short)) for name in ("four-plate-snap", "bistable-clasp")]
    return dict(
        zip(NAMES, ((record, 0.2 * place) for place, record in enumerate([reference_run, *others])), strict=True)
    )


@pytest.fixture(scope="module")
def joined(parts):
    return joined_run(parts)


def test_each_group_is_one_region_in_the_order_of_the_groups(joined, parts):
    shape = shape_of(joined.structure)
    assert shape.regions == NAMES
    counts = [np.count_nonzero(shape.face_region == region) for region in range(3)]
    assert counts == [len(shape_of(record.structure).faces) for record, _ in parts.values()]
    # only plates are opaque
    assert shape.solid == (False, True, False)
    assert {bar.region for bar in shape.bars} == {0}


def test_lines_of_every_part_are_drawn_as_in_the_part(joined, parts):
    """The ring fold of the fan is drawn as well, although one colour covers both sides of it."""
    kinds = sorted(line.kind for line in shape_of(joined.structure).lines)
    separate = sorted(
        line.kind
        for record, _ in parts.values()
        for line in shape_of(replace(record.structure, appearance=joined.structure.appearance)).lines
    )
    assert kinds.count("edge") == separate.count("edge")
    assert kinds.count("rim") == separate.count("rim")
    assert kinds.count("crease") >= separate.count("crease")


@pytest.mark.parametrize("name", ["binder2025", "four-plate-snap", "bistable-clasp", "miura-sheet"])
def test_without_groups_or_with_one_colours_depend_on_roles(name):
    structure = structure_of(load_design(name))
    shape = shape_of(structure)
    one = shape_of(replace(structure, groups=joined_structure({"alone": (structure, 0.0)}).groups))
    for item in (shape, one):
        assert not item.grouped
        assert item.regions == shape.regions
        assert all(bar.region is None for bar in item.bars)
    assert all(tube.region is None for tube in shape_mesh(structure).tubes)


def test_bars_of_a_group_have_its_hue_in_figures_and_films(joined):
    surface = surface_at(joined, shape_of(joined.structure), 0.0)
    painted = paint_shape(surface, readable_view([surface]), "red")
    hues = {tuple(np.round(colour / colour.max(), 2)) for colour in painted.colours if 0 < colour.max() < 1}
    for tint in (*TINTS[:3], BAR_TINTS[0]):
        colour = np.array(to_rgb(tint))
        assert any(np.allclose(hue, colour / colour.max(), atol=0.02) for hue in hues), tint


def test_the_legend_names_the_groups_and_no_bar_or_back_of_a_facet(joined):
    shape = shape_of(joined.structure)
    handles = shape_handles(shape, joined.structure, "red", 2.0)
    assert [handle.get_label() for handle in handles if isinstance(handle, Patch)] == list(NAMES)
    assert not {"vein", "back of a facet"} & {handle.get_label() for handle in handles}


def test_meshes_have_the_colours_of_the_groups(joined):
    scene = scene_of(joined, joined.time[:2])
    assert [(region.name, region.colour) for region in scene.regions] == list(zip(NAMES, TINTS, strict=False))
    assert {rod.colour for rod in scene.rods if rod.kind == "bar"} == {BAR_TINTS[0]}


def test_the_page_gets_the_groups_as_regions(joined, reference_run):
    clip = make_clip(joined, measure(reference_run), budget=50_000)
    data = clip_data(clip)
    bars = [tube for tube in data["tubes"] if tube["kind"] == "bar"]
    assert {tube["region"] for tube in bars} == {0}
    assert not any("region" in tube for tube in data["tubes"] if tube["kind"] != "bar")
    entries = [entry for entry in legend_data([clip]) if entry["sample"].startswith("region")]
    assert [entry["text"] for entry in entries] == list(NAMES)
    assert not any("rim" in entry["text"] for entry in legend_data([clip]))


def test_pages_and_figures_have_the_same_colours():
    script = (Path(__file__).parents[3] / "web/src/scheme.js").read_text("utf-8")
    for name, colours in (("TINTS", TINTS), ("BAR_TINTS", BAR_TINTS)):
        listed = re.search(rf"^const {name} = \[(.*)\];$", script, re.MULTILINE)
        assert re.findall(r"#\w{6}", listed.group(1)) == [colour.lower() for colour in colours]


def test_energies_of_parts_are_energies_of_their_mechanisms(joined, reference_run):
    stored = energy_shares(joined).stored
    assert list(stored)[:3] == ["fan: tendons", "fan: membrane", "midwing: creases"]
    np.testing.assert_allclose(stored["fan: tendons"], reference_run.series["tendon_energy"].sum(axis=1), rtol=1e-12)
    np.testing.assert_allclose(stored["fan: membrane"], reference_run.series["membrane_energy"], rtol=1e-12)
