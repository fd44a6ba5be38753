"""Designs of assemblies: parts in files and under keys, joints, and refusals."""

import pickle

import numpy as np
import pytest

from forficula.design import (
    check_keys_once,
    design_from_text,
    design_text,
    key_quantity,
    key_value,
    load_design,
    with_values,
)
from forficula.errors import InputError
from forficula.goals.deviation import positive_keys
from forficula.structure import built_points, structure_of

STAGES = """
[[protocol.stages]]
name = "wait"
drive = "none"
until = "time"
time_limit = "10 ms"
"""
PARTS = """
[part.inner]
based_on = "force-clasp"
[part.outer]
based_on = "force-clasp"
tendon.band.stiffness = "2 N/cm"
crease.damping = "0.1 N m s/rad/m"
"""
MOUNT = """
[[joint]]
name = "mount"
kind = "rigid"
part = "outer"
to = "inner.facet1"
points = ["facet0_vertex0", "facet0_vertex3"]
onto = ["facet1_vertex2", "facet1_vertex5"]
up = [0, 0, 1]
"""


def two(joints=MOUNT, parts=PARTS, stages=STAGES, more=""):
    return f'name = "two"\nsource = "a test"\n{parts}\n{joints}\n{more}\n[protocol]\n{stages}'


@pytest.fixture
def read(tmp_path):
    """Return a function that reads a design from the text of a file."""

    def from_text(text, settings=None):
        file = tmp_path / "two.toml"
        file.write_text(text, encoding="utf-8")
        return load_design(file, settings)

    return from_text


@pytest.fixture
def design(read):
    return read(two())


def test_keys_begin_with_the_name_of_the_part(design):
    assert key_value(design, "inner.tendon.band.stiffness") == pytest.approx(800)
    assert key_value(design, "outer.tendon.band.stiffness") == pytest.approx(200)
    assert key_value(design, "outer.crease.damping") == pytest.approx(0.1)
    assert key_value(design, "inner.crease.damping") == pytest.approx(0.05)


def test_a_setting_changes_one_part(read):
    changed = read(two(), {"inner.tendon.band.stiffness": "3 N/cm", "part.outer.facet.density": "2 g/cm^3"})
    assert key_value(changed, "inner.tendon.band.stiffness") == pytest.approx(300)
    assert key_value(changed, "outer.facet.density") == pytest.approx(2000)
    assert key_value(changed, "inner.facet.density") == pytest.approx(1270)
    assert "inner.tendon.band.stiffness" in changed.source


def test_a_written_design_reads_back_with_the_same_values(design):
    text = design_text(design)
    assert "[part.outer.crease]" in text
    assert "[chosen]" not in text
    again = design_from_text(text)
    assert again.hash == design.hash
    assert design_text(again) == text


def test_a_written_design_marks_chosen_values_of_parts_within_parts(read, tmp_path):
    inner = tmp_path / "inner.toml"
    inner.write_text(two(joints="", parts='[part.sheet]\nbased_on = "miura-sheet"\n'), encoding="utf-8")
    text = design_text(read(two(joints="", parts='[part.inner]\nbased_on = "inner.toml"\n')))
    section = text[text.index("[part.inner.part.sheet.facet]") :]
    assert "poisson_ratio = 0.3  # [chosen]" in section


def test_a_written_design_has_stops_only_in_parts_with_stops_of_bodies(read):
    parts = '[part.sheet]\nbased_on = "miura-sheet"\n[part.wing]\nbased_on = "binder2025"\n'
    design = read(two(joints="", parts=parts, more='[stops]\ntime_constant = "0.4 ms"\n'))
    again = design_from_text(design_text(design))
    assert again.hash == design.hash
    assert again.wing.stops.time_constant == pytest.approx(4e-4)


def test_a_design_crosses_the_border_of_a_process(design):
    again = pickle.loads(pickle.dumps(design))
    assert again.hash == design.hash
    assert structure_of(again).hinges[0].name == "inner.crease0"


def test_a_changed_value_of_a_part_changes_the_hash(design):
    assert with_values(design, {"outer.crease.stiffness": 2.0}).hash != design.hash


def test_an_assembly_may_be_based_on_another(read, tmp_path):
    read(two())
    upper = tmp_path / "upper.toml"
    upper.write_text('based_on = "two.toml"\nname = "upper"\n[part.outer]\nfacet.density = "3 g/cm^3"\n')
    changed = load_design(upper)
    assert key_value(changed, "outer.facet.density") == pytest.approx(3000)
    assert key_value(changed, "outer.tendon.band.stiffness") == pytest.approx(200)
    assert changed.source.startswith("two with other values of outer.facet.density")


def test_an_assembly_based_on_another_may_replace_the_tendons_of_a_part(read, tmp_path):
    read(two())
    upper = tmp_path / "upper.toml"
    upper.write_text(
        'based_on = "two.toml"\nname = "upper"\n[[part.outer.tendon]]\nname = "cord"\nfrom = "edge 1 at 0.5"\n'
        'to = "edge 2 at 0.5"\nstiffness = "3 N/cm"\nrest_length = "5 cm"\n'
    )
    changed = load_design(upper)
    assert [tendon.name for tendon in changed.outer.tendon] == ["cord"]
    assert key_value(changed, "outer.tendon.cord.stiffness") == pytest.approx(300)
    assert [tendon.name for tendon in changed.inner.tendon] == ["band"]


def test_a_part_may_be_an_assembly(read, tmp_path):
    read(two())
    outer = tmp_path / "outer.toml"
    outer.write_text(
        'name = "nested"\n[part.pair]\nbased_on = "two.toml"\n[part.single]\nbased_on = "force-clasp"\n[protocol]\n'
        + STAGES
    )
    nested = load_design(outer)
    assert key_value(nested, "pair.outer.tendon.band.stiffness") == pytest.approx(200)
    assert {hinge.name for hinge in structure_of(nested).hinges} == {
        "pair.inner.crease0",
        "pair.outer.crease0",
        "single.crease0",
    }
    assert pickle.loads(pickle.dumps(nested)).hash == nested.hash


def test_gravity_and_contact_of_the_assembly_apply_to_its_parts(read):
    heavy = read(two(), {"protocol.gravity": "9.81 m/s^2"})
    assert structure_of(heavy).gravity == pytest.approx(9.81)
    assert all(part.protocol.gravity == 9.81 for part in heavy.designs.values())


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            two(joints=MOUNT.replace('part = "outer"', 'part = "outr"')),
            'joint.0.part: need "inner" or "outer", got "outr"',
        ),
        (two(joints=MOUNT.replace("inner.facet1", "inner.facet7")), 'joint.mount.to: need "inner.facet0"'),
        (two(joints=MOUNT.replace("inner.facet1", "facet1")), 'joint.0.to: need "ground" or a body of a part'),
        (
            two(joints=MOUNT.replace("inner.facet1", "outer.facet1")),
            "joint.mount.to: need a body that outer does not carry",
        ),
        (two(joints=MOUNT.replace('"facet0_vertex3"]', '"corner"]')), "joint.mount.points: need"),
        (two(joints=MOUNT.replace("onto =", "position =")), "joint.0.position"),
        (
            two(joints=MOUNT.replace('["facet1_vertex2", "facet1_vertex5"]', '["facet0_vertex0", "facet0_vertex1"]')),
            "joint.mount.onto: need points of inner.facet1, which carries the part, got inner.facet0_vertex0, a point"
            " of inner.facet0",
        ),
        (
            two(joints=MOUNT.replace('["facet0_vertex0", "facet0_vertex3"]', '"facet0_vertex0"')),
            'joint.0.points: need a list of texts such as ["one", "two"], got "facet0_vertex0"',
        ),
        (
            two(joints=MOUNT.replace('kind = "rigid"', 'kind = "glued"')),
            'joint.0.kind: need "rigid", "hinge", "coupling"',
        ),
        (
            two(joints=MOUNT + MOUNT.replace('"mount"', '"again"')),
            "joint.1.part: need a part that joint mount does not carry",
        ),
        (two(joints=MOUNT + MOUNT), "joint.1.name: need a name that no part and no other joint has"),
        (two(parts=PARTS.replace("force-clasp", "force-clsp")), 'part.inner: "force-clsp" is neither a named design'),
        (two(parts=PARTS.replace("[part.outer]", "[part.protocol]")), "part.protocol: need a name that is not a key"),
        (two(parts=PARTS.replace("[part.outer]", "[part.Outer]")), "part: need a name of at most 40 small letters"),
        (two(parts=PARTS.replace("crease.damping", "crease.dampng")), "outer.crease.dampng: unknown key"),
        (two(parts=PARTS.replace("0.1 N m s/rad/m", "-1 N m s/rad/m")), "outer.crease.damping: need >= 0"),
        (two(parts=PARTS.replace("tendon.band", "tendon.bnd")), "outer.tendon.bnd"),
        (two(stages=STAGES.replace('"none"', '"outer.pul"')), 'did you mean "outer.pull"?'),
        (two(stages=STAGES.replace('"time"', '"outer.jaww < 3 deg"')), 'did you mean "outer.jaw"?'),
    ],
)
def test_a_refusal_names_the_key_and_what_is_allowed(read, text, message):
    with pytest.raises(InputError) as error:
        structure_of(read(text))
    assert message in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("other", ["two.toml", "upper.toml", "inside.toml"])
def test_a_part_that_is_based_on_its_own_assembly_is_refused(read, tmp_path, other):
    (tmp_path / "upper.toml").write_text('based_on = "two.toml"\nname = "upper"\n', encoding="utf-8")
    inside = f'name = "inside"\n[part.pair]\nbased_on = "two.toml"\n[protocol]\n{STAGES}'
    (tmp_path / "inside.toml").write_text(inside, encoding="utf-8")
    with pytest.raises(InputError, match=r"two\.toml: is based on itself, directly or through other files"):
        read(two(parts=PARTS.replace("force-clasp", other)))


SPRING = """
[[joint]]
name = "link"
kind = "spring"
from = "inner.facet1_vertex2"
to = "outer.facet1_vertex2"
stiffness = "1 N/cm"
rest_length = "1 cm"
"""
COUPLING = """
[[joint]]
name = "same"
kind = "coupling"
hinges = ["inner.crease0", "outer.crease0"]
"""
PUSH = """
[[drive]]
name = "push"
kind = "force"
of = "outer.facet1_vertex2"
force = "1 N"
direction = [0, 0, 1]
"""


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (two().replace('name = "two"', 'name = "two"\nparts = ["inner"]'), "parts: cannot be set, because"),
        (
            two(parts=PARTS.replace("part.outer", f"part.{'o' * 41}"), joints=""),
            "part: need a name of at most 40 small letters, digits and _ that begins with a letter",
        ),
        (two(joints=MOUNT.replace("[0, 0, 1]", "[0, 1]")), "joint.0.up: need more entries, got [0, 1]"),
        (
            two(joints=MOUNT + SPRING.replace("outer.facet1_vertex2", "outer.facet0_vertex0")),
            "joint.link.to: need points that move relative to each other",
        ),
        (
            two(joints=MOUNT + SPRING + 'ground = ["0 cm", "0 cm", "1 cm"]'),
            'joint.link.ground: needs "ground" as one end',
        ),
        (
            two(joints=MOUNT + COUPLING.replace("outer.crease0", "inner.crease0")),
            "joint.1.hinges: need two different hinges, got twice inner.crease0",
        ),
        (
            two(joints=MOUNT + COUPLING + COUPLING.replace("same", "again")),
            "joint.2.hinges: need hinges that joint same does not couple already",
        ),
        (two(more=PUSH.replace('"outer.facet1_vertex2"', "[]")), "drive.0.of: need names that differ, at least one"),
        (
            two(more=PUSH.replace("outer.facet1", "inner.facet0").replace("vertex2", "vertex0")),
            "drive.push.of: need points that move, got inner.facet0_vertex0, which is fixed to the ground",
        ),
    ],
)
def test_values_without_an_effect_are_refused(read, text, message):
    with pytest.raises(InputError) as error:
        structure_of(read(text))
    assert message in str(error.value)


@pytest.mark.parametrize(
    ("key", "common", "value"),
    [
        ("outer.protocol.gravity", "protocol.gravity", "9 m/s^2"),
        ("part.outer.medium.density", "medium.density", "1 kg/m^3"),
        ("outer.protocol.timestep", "protocol.timestep", "1 s"),
    ],
)
def test_a_setting_of_a_part_that_the_assembly_replaces_is_refused(read, key, common, value):
    with pytest.raises(InputError, match=rf"has no effect in a part; set {common} of the assembly"):
        read(two(), {key: value})


def test_the_later_of_value_and_force_is_the_strength_of_a_drive(read):
    drive = two(more=PUSH.replace("force =", "value ="))
    assert key_value(read(drive, {"drive.push.force": "3 N"}), "drive.push.force") == pytest.approx(3)
    assert key_value(read(two(more=PUSH), {"drive.push.value": "3 N"}), "drive.push.force") == pytest.approx(3)


def test_an_unknown_key_of_a_part_names_the_nearest(design):
    with pytest.raises(
        InputError, match=r"outer\.crease\.stifness: unknown key.*did you mean outer\.crease\.stiffness"
    ):
        with_values(design, {"outer.crease.stifness": 1.0})


def test_the_second_part_lies_where_the_joint_places_it(design):
    structure = structure_of(design)
    numbers = {point.name: number for number, point in enumerate(structure.points)}
    places = built_points(structure)
    for one, other in (
        ("inner.facet1_vertex2", "outer.facet0_vertex0"),
        ("inner.facet1_vertex5", "outer.facet0_vertex3"),
    ):
        np.testing.assert_allclose(places[numbers[one]], places[numbers[other]], atol=1e-15)


def test_all_values_of_a_design_may_be_set_again(design):
    assert with_values(design, design.si_tables()).hash == design.hash


def test_tolerances_of_all_values_leave_out_the_protocols_of_the_parts(design):
    keys = positive_keys(design)
    assert "inner.tendon.band.stiffness" in keys
    assert not [key for key in keys if ".protocol." in key or ".stops." in key or ".make." in key]
    assert all(key_value(design, key) > 0 for key in keys)


def test_settings_of_a_part_may_be_a_table_under_part(read):
    changed = read(two(), {"part": {"inner": {"crease": {"damping": "0.3 N m s/rad/m"}}}})
    assert key_value(changed, "inner.crease.damping") == pytest.approx(0.3)


def test_a_key_with_and_without_part_is_given_twice(read):
    with pytest.raises(InputError, match=r"inner\.crease\.damping: is given twice, also as part\.inner"):
        read(two(), {"inner.crease.damping": "1 N m s/rad/m", "part.inner.crease.damping": "2 N m s/rad/m"})


def test_factors_that_the_assembly_replaces_are_refused(design):
    with pytest.raises(InputError, match=r"inner\.protocol\.timestep: has no effect in a part; use protocol\.timestep"):
        check_keys_once(["inner.protocol.timestep"], design)


def test_a_key_with_part_before_it_is_named_without(design):
    with pytest.raises(InputError, match=r"unknown key; did you mean inner\.crease\.stiffness\?"):
        key_quantity("part.inner.crease.stiffness", type(design))


def test_surroundings_that_a_file_gives_to_a_part_are_reported_as_without_effect(tmp_path):
    file = tmp_path / "pair.toml"
    text = 'based_on = "two-clasps"\n[part.inner.table]\nheight = "-1 m"\n[part.inner.protocol]\ngravity = "1 m/s^2"\n'
    file.write_text(text)
    effect = "has no effect in a part; set {0} of the assembly"
    assert load_design(str(file)).idle == tuple(
        f"inner.{key} {effect.format(key)}" for key in ("table", "protocol.gravity")
    )
    file.write_text(text + '[table]\nheight = "-1 m"\n[protocol]\ngravity = "1 m/s^2"\n')
    assert load_design(str(file)).idle == ()
