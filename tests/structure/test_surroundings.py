"""Gravity, table, supports and dry friction of designs: keys, structures and refusals."""

import mujoco
import numpy as np
import pytest

import forficula as ff
from forficula.design import load_design
from forficula.design.files.design_file import design_from_text, with_values
from forficula.dynamics import compile_model
from forficula.dynamics.gpu.device import check_device
from forficula.errors import InputError
from forficula.show.structure.surroundings import surroundings_text
from forficula.statics.tree.ensemble import ensemble, ensemble_of
from forficula.statics.tree.fold_path import fold_path
from forficula.structure import held_corners, structure_of, touching_points
from forficula.structure.tree import built_points

SHEET = """
name = "two panels"
source = "a test"
[pattern]
kind = "pleats"
panels = 2
panel_lengths = ["5 cm"]
width = "5 cm"
assignment = "V"
[facet]
kind = "{kind}"
thickness = "1 mm"
density = "1.27 g/cm^3"
{more}
[protocol]
timestep = "0.1 ms"
[[protocol.stages]]
name = "free"
drive = "none"
until = "time"
time_limit = "0.1 s"
"""
WEIGHT = {"protocol.gravity": "9.81 m/s^2"}


def sheet(more="", kind="bars"):
    return design_from_text(SHEET.format(kind=kind, more=more))


@pytest.mark.parametrize(
    ("written", "down"),
    [("-y", (0, -1, 0)), ("x", (1, 0, 0)), ([0, 3, -4], (0, 0.6, -0.8)), ([0, 0, -2], (0, 0, -1))],
)
def test_gravity_acts_along_an_axis_or_a_vector_of_any_length(written, down):
    design = load_design("binder2025-joint", WEIGHT | {"protocol.gravity_direction": written})
    assert structure_of(design).down == pytest.approx(down)
    gravity = compile_model(design).engine.opt.gravity
    np.testing.assert_allclose(gravity / np.linalg.norm(gravity), down)


def test_the_same_direction_in_other_words_is_the_same_design():
    name = load_design("binder2025")
    vector = load_design("binder2025", {"protocol.gravity_direction": [0, 0, -5]})
    assert vector.hash == name.hash
    assert vector.protocol.gravity_direction == "-z"


@pytest.mark.parametrize("direction", ["down", [0, 0, 0], [1, 2], "", [1, 2, "z"]])
def test_a_direction_that_is_none_is_refused(direction):
    with pytest.raises(InputError, match=r"protocol\.gravity_direction: need .*\"-z\""):
        load_design("binder2025", {"protocol.gravity_direction": direction})


def test_a_part_takes_gravity_and_table_from_its_assembly():
    values = WEIGHT | {"protocol.gravity_direction": "x", "table.height": "-1 m"}
    design = load_design("two-clasps", values)
    assert structure_of(design).down == (1, 0, 0)
    assert all(structure_of(part).down == (1, 0, 0) for part in design.designs.values())
    name = next(iter(design.designs))
    with pytest.raises(InputError, match=r"has no effect in a part; set table\.height of the assembly"):
        load_design("two-clasps", {f"{name}.table.height": "-1 m"})


@pytest.mark.parametrize(
    ("name", "count"), [("binder2025-joint", 4), ("binder2025", None), ("letter-fold", 12), ("bistable-miura", None)]
)
def test_bars_plates_panels_and_facets_touch_a_table_at_spheres_of_their_half_thickness(name, count):
    points = touching_points(structure_of(load_design(name)))
    assert count is None or len(points) == count
    assert all(point.radius > 0 for point in points)


def test_a_start_below_the_table_is_refused_with_the_largest_height():
    with pytest.raises(
        InputError, match=r"table\.height: the structure starts below the table: need <= -0\.\d+ cm, .*got 0 cm"
    ):
        compile_model(load_design("binder2025", {"table.height": "0 cm"}))
    compile_model(sheet('[table]\nheight = "-0.5 mm"'))
    with pytest.raises(InputError, match=r"need <= -0\.05 cm"):
        compile_model(sheet('[table]\nheight = "-0.4 mm"'))


def test_a_table_is_normal_to_gravity():
    design = load_design("binder2025-joint", {"table.height": "-4 cm", "protocol.gravity_direction": "-y"})
    engine = compile_model(design).engine
    plane = engine.geom("table")
    turned = np.zeros(9)
    mujoco.mju_quat2Mat(turned, plane.quat)
    np.testing.assert_allclose(turned.reshape(3, 3)[:, 2], (0, 1, 0), atol=1e-12)


def test_the_energy_along_a_rigid_fold_is_refused_on_a_table():
    structures = ensemble([structure_of(load_design("binder2025-on-table"))])
    with pytest.raises(
        InputError, match=r"has no energy along its rigid fold, .*table = \"none\" leaves the table out"
    ):
        fold_path(structures)


def test_a_landscape_on_a_table_lists_what_it_leaves_out():
    values = WEIGHT | {"table.height": "-4 cm", "table.friction": 0.2}
    landscape = ff.landscape(load_design("binder2025-joint", values), points=11)
    text = " ".join(landscape.remarks)
    assert "partial folds and barriers of single hinges are not computed on a table" in text
    assert "statics ignores friction on the table (table.friction = 0.2), which holds the joint" in text
    assert not landscape.partial_folds
    assert landscape.rests[1].contacts == {}


@pytest.mark.parametrize("kind", ["rigid", "bars"])
def test_statics_refuses_a_start_below_the_table(kind):
    with pytest.raises(InputError, match=r"need <= -0\.05 cm, the height of its lowest part, got -0\.04 cm"):
        ff.landscape(sheet('[table]\nheight = "-0.4 mm"', kind))


def test_joints_over_tables_of_several_heights_are_not_laid_out_as_one():
    joints = [load_design("binder2025-joint", WEIGHT | {"table.height": height}) for height in ("-4 cm", "-5 cm")]
    with pytest.raises(InputError, match="need joints that differ in their tendons only, got another table"):
        ensemble_of(joints)
    assert ensemble_of(joints[:1] * 2).cases == 2


def test_a_quasi_static_stage_on_a_table_with_friction_is_refused():
    values = {"protocol.stages.fold.motion": "quasi-static"}
    with pytest.raises(InputError, match=r"statics ignores friction on the table \(table\.friction\)"):
        ff.run(load_design("binder2025-on-table", values))


def test_a_rigid_sheet_turns_about_an_edge_on_the_ground():
    structure = structure_of(sheet('[[support]]\nof = "edge 1"', "rigid"))
    assert [hinge.role for hinge in structure.hinges] == ["support", "crease"]
    np.testing.assert_allclose(structure.hinges[0].axis, (0, 1, 0))


def test_supported_points_of_rigid_facets_are_refused_where_they_are_not_simulated():
    more = '[[support]]\nof = "edge 1"\n[[support]]\nof = "vertex 2"\naxes = "z"\n'
    design = sheet(more, "rigid")
    with pytest.raises(InputError, match="closed loops and supported points take steps of Runge and Kutta"):
        check_device(compile_model(with_values(design, {"protocol.device": "warp-cpu"})))


_PART = """
name = "whole"
source = "a test"
[part.strip]
based_on = "strip.toml"
"""
_STAND = """
[[joint]]
name = "stand"
kind = "rigid"
part = "strip"
points = ["facet0_vertex0"]
position = ["1 cm", "2 cm", "3 cm"]
up = [1, 0, 0]
[protocol]
gravity = "9.81 m/s^2"
gravity_direction = "-x"
"""
_CREASE = """
[crease]
stiffness = "0.2 N m/rad/m"
back_limit = "170 deg"
"""
_VERTICES = (("0", "xyz"), ("3", "xz"), ("2", "yz"), ("5", "z"))
_SUPPORTS = "".join(f'[[support]]\nof = "vertex {vertex}"\naxes = "{axes}"\n' for vertex, axes in _VERTICES)


@pytest.mark.parametrize("more", ["", 'extension = "1e6 N/m^2"\n'], ids=["hinged", "opening"])
def test_supports_of_vertices_turn_with_a_part_of_an_assembly(more, tmp_path):
    """Gravity turns with the part, too, so the crease rests at the same angle."""
    alone = SHEET.format(kind="rigid", more=f"{_CREASE}{more}{_SUPPORTS}")
    (tmp_path / "strip.toml").write_text(alone)
    (tmp_path / "whole.toml").write_text(f"{_PART}{_STAND}{alone[alone.index('[[protocol') :]}")
    design = load_design(str(tmp_path / "whole.toml"))
    np.testing.assert_allclose(structure_of(design).holds[0].axis, (0, 0, -1), atol=1e-15)
    rests = [ff.landscape(case, points=11).rests[0] for case in (design, with_values(design_from_text(alone), WEIGHT))]
    assert rests[0].angles[0] > 0.05
    np.testing.assert_allclose(rests[0].angles, rests[1].angles, atol=1e-7)


def test_supports_of_vertices_hold_to_the_ground_only(tmp_path):
    file = tmp_path / "design.toml"
    file.write_text('based_on = "two-clasps"\nname = "held"\n[[part.outer.support]]\nof = "vertex 0"')
    with pytest.raises(InputError, match=r"part\.outer\.support: need one facet or edge that is held along all axes"):
        structure_of(load_design(str(file)))


def test_supported_points_of_rigid_facets_are_drawn():
    more = '[[support]]\nof = "edge 1"\n[[support]]\nof = "vertex 2"\naxes = "z"\n'
    structure = structure_of(sheet(more, "rigid"))
    held = built_points(structure)[list(held_corners(structure))]
    ends = sheet(more, "rigid").sheet
    expected = {*ends.edges_vertices[1].tolist(), 2}
    np.testing.assert_allclose(sorted(map(tuple, held)), sorted(map(tuple, ends.vertices_coords[sorted(expected)])))
    assert not held_corners(structure_of(sheet('[[support]]\nof = "edge 1"', "rigid")))


def test_facets_that_bend_are_held_along_an_edge():
    structure = structure_of(sheet('[[support]]\nof = "edge 1"\naxes = "xz"'))
    assert [body.slides for body in structure.bodies].count((1,)) == 2


@pytest.mark.parametrize(
    ("more", "kind", "message"),
    [
        ('[[support]]\nof = "edge 99"', "rigid", "support.0.of: need an edge from 0 to 6, got 99"),
        ('[[support]]\nof = "facet 0"\naxes = "x"', "rigid", "support.0.axes: is for edges and vertices"),
        (
            '[[support]]\nof = "vertex 0"\n[crease]\nstart = "9 deg"',
            "rigid",
            "crease.start: need 0 deg for rigid facets that several supports, or vertices, hold",
        ),
        (
            '[crease]\nfriction = "1e-3 N m/m"\ndamage = { loss = 0.5, turn = "10 rad" }',
            "bars",
            "crease.friction: need 0 for a crease that wears out",
        ),
        ('[crease]\nfriction = "-1e-3 N m/m"', "rigid", "crease.friction: need >= 0"),
        ('[table]\nheight = "-1 cm"\nfriction = -0.1', "bars", "table.friction"),
    ],
)
def test_supports_friction_and_tables_that_cannot_be_are_refused(more, kind, message):
    with pytest.raises(InputError) as error:
        sheet(more, kind)
    assert message in str(error.value)


@pytest.mark.parametrize("kind", ["rigid", "bars"])
def test_creases_have_dry_friction_in_proportion_to_their_length(kind):
    structure = structure_of(sheet('[crease]\nfriction = "0.02 N m/m"', kind))
    assert structure.hinges[0].friction == pytest.approx(0.02 * 0.05)


def test_the_description_of_a_picture_has_gravity_and_table():
    text = surroundings_text(structure_of(load_design("binder2025-on-table")))
    assert text == " Gravity of 9.81 m/s^2 acts along (0, 0, -1). A table is at the height -10 mm."
