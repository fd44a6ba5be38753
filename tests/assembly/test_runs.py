"""Runs of assemblies: one part alone, parts that are turned, and joints of each kind."""

import math
import re

import numpy as np
import pytest

from forficula.design import design_from_text, design_text, load_design, scale_design, with_values
from forficula.dynamics import compile_model, energy_balance, simulate, why_not_portable
from forficula.errors import InputError
from forficula.structure import built_points, structure_of
from forficula.structure.contact.touching_parts import touching_parts

SHORT = {"binder2025": 0.02, "letter-fold": 0.02, "force-clasp": 0.005, "kresling-cell": 0.002}
WAIT = """
[protocol]
timestep = "{step:g} ms"
sample_interval = "0.5 ms"
rest_speed = "2 deg/s"
window = "1 ms"

[[protocol.stages]]
name = "wait"
drive = "{drive}"
until = "time"
time_limit = "{limit:g} ms"
"""


def assembly(parts, joints="", *, step=0.05, drive="none", limit=5.0, more=""):
    """Return an assembly that is driven for some milliseconds."""
    text = f'name = "whole"\nsource = "a test"\n{parts}\n{joints}\n{more}\n'
    return text + WAIT.format(step=step, drive=drive, limit=limit)


def read(tmp_path, text):
    file = tmp_path / "whole.toml"
    file.write_text(text, encoding="utf-8")
    return load_design(file)


def simulated(design):
    return simulate([compile_model(design)])[0]


@pytest.mark.parametrize("name", SHORT)
def test_an_assembly_of_one_part_reproduces_that_part_bit_for_bit(name, tmp_path):
    alone = load_design(name)
    drive = next(drive.name for drive in structure_of(alone).drives)
    step = 1e3 * alone.protocol.timestep
    stages = [{"name": "wait", "drive": "none", "until": "time", "hold": 0.0, "time_limit": SHORT[name] / 2}]
    if name not in ("force-clasp", "kresling-cell", "letter-fold"):
        stages.append({**stages[0], "name": "drive", "drive": drive})
    alone = with_values(alone, {"protocol.stages": stages, "protocol.sample_interval": 5e-4})
    text = design_text(alone)
    whole = f'name = "whole"\nsource = "a test"\n[part.wing]\nbased_on = "{name}"\n'
    protocol = text[text.index("[protocol]") :]
    protocol = re.sub(
        r"(?m)^(fold_torque|unfold_torque|initial_overbend|folded_angle|opened_angle|arrival|driven_veins).*$",
        "",
        protocol,
    )
    protocol = protocol.replace(f'drive = "{drive}"', f'drive = "wing.{drive}"')
    if (stops := re.search(r"(?ms)^\[stops\]\n.*?\n\n", text)) is not None:
        protocol = f"{stops.group()}{protocol}"
    joined = read(tmp_path, whole + protocol)
    one, other = simulated(alone), simulated(joined)
    assert one.series.keys() == other.series.keys()
    for key, values in one.series.items():
        np.testing.assert_array_equal(values, other.series[key], err_msg=key)
    assert step == 1e3 * joined.protocol.timestep


TURNED = """
[[joint]]
name = "stand"
kind = "rigid"
part = "wing"
points = ["hub0", "tip2"]
position = ["1 cm", "2 cm", "3 cm"]
along = [1, 2, -2]
up = [0, 1, 1]
"""


def test_a_turned_fan_folds_as_one_that_is_not(tmp_path):
    parts = '[part.wing]\nbased_on = "binder2025"\n'
    still, turned = (
        simulated(read(tmp_path, assembly(parts, joints, drive="wing.fold", step=0.2, limit=20)))
        for joints in ("", TURNED)
    )
    angles, others = (record.series["hinge_angle"] for record in (still, turned))
    assert np.abs(angles[-1]).max() > math.radians(20)
    np.testing.assert_allclose(others, angles, atol=1e-7)
    for key in ("tendon_energy", "membrane_energy", "kinetic_energy"):
        np.testing.assert_allclose(turned.series[key], still.series[key], rtol=1e-5, atol=1e-9)
    places = built_points(turned.structure)
    names = [point.name for point in turned.structure.points]
    hub, tip = (places[names.index(f"wing.{name}")] for name in ("hub0", "tip2"))
    np.testing.assert_allclose(hub, [0.01, 0.02, 0.03], atol=1e-15)
    np.testing.assert_allclose((tip - hub) / np.linalg.norm(tip - hub), np.array([1, 2, -2]) / 3, atol=1e-12)


PLATE = """
[part.{name}]
based_on = "letter-fold"
pattern.panels = 2
pattern.panel_lengths = ["10 cm"]
pattern.width = "6 cm"
pattern.assignment = "V"
facet.thickness = "1 mm"
facet.density = "1.2 g/cm^3"
crease.stiffness = "0 N m/rad/m"
crease.damping = "0 N m s/rad/m"
crease.start = "0 deg"
crease.back_limit = "90 deg"
tendon = []
measure = []
drive = []
[[part.{name}.support]]
of = "facet 0"
[[part.{name}.protocol.stages]]
name = "wait"
drive = "none"
until = "time"
time_limit = "1 s"
"""


def two_plates(tmp_path, joints, *, more="", drive="none", limit=50.0, step=0.1):
    parts = PLATE.format(name="one") + PLATE.format(name="two").replace("facet.density", "facet.density")
    return read(tmp_path, assembly(parts, joints, step=step, drive=drive, limit=limit, more=more))


def test_a_rigid_coupling_ties_two_angles_by_its_ratio(tmp_path):
    coupling = '[[joint]]\nname = "tie"\nkind = "coupling"\nhinges = ["one.crease1", "two.crease1"]\nratio = -0.5\n'
    push = '[[drive]]\nname = "push"\nkind = "torque"\nof = "one.crease1"\nvalue = "1 N cm"\n'
    names = [hinge.name for hinge in structure_of(two_plates(tmp_path, "")).hinges]
    coupling = coupling.replace("crease1", names[0].partition(".")[2])
    push = push.replace("one.crease1", names[0])
    record = simulated(two_plates(tmp_path, coupling, more=push, drive="push"))
    one, two = record.series["hinge_angle"].T
    assert one[-1] > math.radians(5)
    np.testing.assert_allclose(two, -0.5 * one, atol=1e-3 * one[-1])
    # both plates turn about their ends with m L^2 / 3: (1 + 1/4) I a'' = T
    mass = 1200 * 0.1 * 0.06 * 1e-3
    inertia = 1.25 * mass * (0.1**2 / 3 + 1e-3**2 / 12)
    np.testing.assert_allclose(one, 0.01 / inertia * record.time**2 / 2, rtol=0.02, atol=1e-4)


def test_a_spring_and_a_tendon_between_parts_store_their_closed_forms_and_the_balance_closes(tmp_path):
    joints = """
[[joint]]
name = "aside"
kind = "rigid"
part = "two"
points = ["facet0_vertex0"]
position = ["0 cm", "12 cm", "0 cm"]
"""
    for name, kind, part, across, stiffness in (("spring", "spring", "one", 0, 1), ("band", "tendon", "two", 12, 2)):
        joints += f"""
[[joint]]
name = "{name}"
kind = "{kind}"
from = "{part}.facet1_vertex2"
to = "ground"
ground = ["20 cm", "{across} cm", "5 cm"]
stiffness = "{stiffness} N/cm"
rest_length = "2 cm"
damping = "0 N s/m"
"""
    record = simulated(two_plates(tmp_path, joints, limit=30, step=0.02))
    names = [point.name for point in record.structure.points]
    place = record.series["point_position"]
    for part, ground, energy, stiffness in (
        ("one", [0.2, 0, 0.05], record.series["spring_energy"][:, 0], 100),
        ("two", [0.2, 0.12, 0.05], record.series["tendon_energy"][:, 0], 200),
    ):
        length = np.linalg.norm(place[:, names.index(f"{part}.facet1_vertex2")] - ground, axis=1)
        np.testing.assert_allclose(
            energy,
            stiffness / 2 * (length - 0.02 if part == "one" else np.maximum(length - 0.02, 0)) ** 2,
            rtol=1e-9,
            atol=1e-12,
        )
    balance = energy_balance(record)
    assert abs(balance.residual) < 5e-3


HINGE = """
[[joint]]
name = "axle"
kind = "hinge"
part = "two"
points = ["facet0_vertex0", "facet0_vertex3"]
position = ["0 cm", "30 cm", "0 cm"]
stiffness = "0.5 N m/rad"
rest_angle = "10 deg"
"""


def test_a_part_swings_on_its_hinge_with_the_period_of_a_rigid_body(tmp_path):
    design = two_plates(tmp_path, HINGE, limit=60)
    closed = with_values(design, {"two.crease.stiffness": 1e3, "two.crease.rest_angle": 0.0})  # both plates as one
    record = simulated(closed)
    number = [hinge.name for hinge in record.structure.hinges].index("axle")
    mass = 1200 * 0.2 * 0.06 * 1e-3
    inertia = mass * (0.2**2 / 3 + 1e-3**2 / 12)
    angle = math.radians(10) * (1 - np.cos(math.sqrt(0.5 / inertia) * record.time))
    np.testing.assert_allclose(record.series["hinge_angle"][:, number], angle, atol=math.radians(0.4))


def test_the_hinge_of_a_part_without_a_body_that_is_fixed_needs_a_mass(tmp_path):
    joint = """
[[joint]]
name = "claval line"
kind = "hinge"
part = "wing"
points = ["hub0", "ring0"]
position = ["0 cm", "0 cm", "0 cm"]
"""
    text = assembly('[part.wing]\nbased_on = "binder2025"\n', joint)
    with pytest.raises(InputError, match=r"joint\.claval line\.mass: need > 0 g"):
        structure_of(read(tmp_path, text))
    structure = structure_of(read(tmp_path, text.replace("[[joint]]\n", '[[joint]]\nmass = "3 g"\n')))
    assert sum(mass.mass for mass in structure.masses) == pytest.approx(3e-3)


@pytest.mark.parametrize("mass", ["0 g", "3 g"])
def test_a_hinge_needs_a_part_that_a_support_holds(mass, tmp_path):
    joint = f"""
[[joint]]
name = "axle"
kind = "hinge"
part = "sheet"
points = ["vertex0", "vertex1"]
position = ["0 cm", "0 cm", "0 cm"]
mass = "{mass}"
"""
    text = assembly('[part.sheet]\nbased_on = "miura-sheet"\nsupport = []\n', joint)
    with pytest.raises(InputError, match=r"joint\.axle\.part: need a part that a support holds"):
        structure_of(read(tmp_path, text))


CARRIED = """
[[joint]]
name = "stand"
kind = "rigid"
part = "wing"
to = "sheet.vertex8"
"""
FANS = '[part.one]\nbased_on = "binder2025"\n[part.two]\nbased_on = "binder2025"\n'


@pytest.mark.parametrize(
    ("parts", "joints", "contact", "message"),
    [
        (
            '[part.sheet]\nbased_on = "miura-sheet"\n[part.wing]\nbased_on = "letter-fold"\n',
            CARRIED,
            "false",
            "joint.stand.to: need a body that can turn",
        ),
        (
            '[part.clasp]\nbased_on = "binder2025-joint"\n',
            "",
            "true",
            "protocol.contact: need false, because contact is modelled for none of the parts, got true",
        ),
        (
            FANS + "contact.friction = 0.3\n",
            "",
            "true",
            "need one friction and one compliance of contact in all parts, and one thickness in all fans, got those of"
            " two",
        ),
        (
            FANS + 'contact.time_constant = "0.4 ms"\n',
            "",
            "true",
            "need one friction and one compliance of contact in all parts, and one thickness in all fans, got those of"
            " two",
        ),
    ],
)
def test_parts_that_cannot_be_simulated_together_are_refused(parts, joints, contact, message, tmp_path):
    text = assembly(parts, joints).replace("[protocol]", f"[protocol]\ncontact = {contact}")
    with pytest.raises(InputError) as error:
        structure_of(read(tmp_path, text))
    assert message in str(error.value)


def test_a_derived_time_constant_of_contact_applies_to_all_parts():
    clasps = load_design("two-clasps", {"protocol.contact": True})
    derived = clasps.with_contact_time(5e-5)
    assert [part.contact.time_constant for part in derived.designs.values()] == [5e-5, 5e-5]
    assert structure_of(derived).contact.stops.time_constant == 5e-5
    assert not structure_of(derived).contact.automatic
    assert derived.with_contact_time(1e-5) is derived
    assert design_from_text(design_text(derived)).hash == derived.hash
    apart = load_design("two-clasps")
    assert apart.with_contact_time(5e-5) is apart


def test_a_page_does_not_simulate_a_force_on_a_body_that_turns(tmp_path):
    push = """
[[drive]]
name = "gust"
kind = "force"
of = "wing.tip0"
force = "0.1 N"
direction = [0, 0, -1]
"""
    reasons = [
        why_not_portable(compile_model(read(tmp_path, assembly('[part.wing]\nbased_on = "binder2025"\n', more=more))))
        for more in ("", push)
    ]
    assert reasons == ["", "a force acts on a body that turns, and a page does not compute its work"]


def test_the_balance_of_a_fan_beside_facets_that_bend_closes_under_forces_on_both(tmp_path):
    parts = '[part.cell]\nbased_on = "kresling-cell"\n[part.wing]\nbased_on = "binder2025"\n'
    pushes = "".join(
        f"""
[[drive]]
name = "{name}"
kind = "force"
of = "{point}"
force = "2 N"
direction = [0, 0, -1]
rise = "1 ms"
"""
        for name, point in (("press", "cell.vertex8"), ("gust", "wing.tip0"))
    )
    text = assembly(parts, step=0.01, limit=4, more=pushes).replace('"none"', '["press", "gust"]')
    record = simulated(read(tmp_path, text))
    assert energy_balance(record).residual < 1e-3
    works = dict(zip((motor.name for motor in record.structure.motors), record.series["motor_work"][-1], strict=True))
    assert works["press"] > 0
    assert works["gust"] > 0


TWIST = """
[[drive]]
name = "twist"
kind = "torque"
of = ["sheet.zigzag", "sheet.straight"]
value = "2 N cm"
"""


def test_a_torque_of_the_assembly_does_not_change_the_rest_angles_that_a_part_drives(tmp_path):
    structure = structure_of(read(tmp_path, assembly('[part.sheet]\nbased_on = "miura-sheet"\n', more=TWIST)))
    kinds = [motor.kind for motor in structure.motors]
    shares = {drive.name: dict(zip(kinds, drive.shares, strict=True)) for drive in structure.drives}
    assert shares["sheet.fold"] == {"rest-angle": 1.0, "torque": 0.0}
    assert shares["twist"] == {"rest-angle": 0.0, "torque": 1.0}


def test_torques_on_the_same_hinges_need_the_same_no_load_speed(tmp_path):
    more = TWIST.replace('"sheet.zigzag", "sheet.straight"', '"sheet.crease0", "sheet.crease1"')
    text = assembly('[part.sheet]\nbased_on = "letter-fold"\n', more=more)
    assert len(structure_of(read(tmp_path, text)).motors) == 1
    text = text.replace('value = "2 N cm"', 'value = "2 N cm"\nno_load_speed = "90 deg/s"')
    with pytest.raises(InputError, match=r"drive\.twist\.no_load_speed: need that of .* none, got 90 deg/s"):
        structure_of(read(tmp_path, text))


def test_the_hindwing_is_locked_withstands_a_gust_and_folds_after_a_pulse_without_a_motor_on_the_fan():
    whole = load_design("earwig-hindwing")
    names = [stage.name for stage in whole.protocol.stages]
    stages = [stage.si_tables() for stage in whole.protocol.stages[: names.index("snap") + 1]]
    design = with_values(whole, {"protocol.stages": [*stages[:-1], stages[-1] | {"state": "folded"}]})
    record = simulated(design)
    ends = {end.stage.name: end for end in record.stages}
    assert list(ends) == ["settle", "gust", "calm", "pulse", "snap"]
    assert all(ends[name].goal_time is not None for name in ("settle", "calm", "snap"))
    assert ends["snap"].goal_time - ends["pulse"].start < 0.2
    assert energy_balance(record).residual < 5e-3
    works = record.series["motor_work"][-1]
    for motor, work in zip(record.structure.motors, works, strict=True):
        assert bool(work) == (motor.name in ("midwing.middle", "gust")), motor.name
    assert design_from_text(design_text(whole)).hash == whole.hash


def test_panels_of_the_hindwing_touch_and_the_balance_closes():
    whole = load_design("earwig-hindwing")
    stages = {stage.name: stage.si_tables() | {"hold": 0.0} for stage in whole.protocol.stages}
    snap = stages["snap"] | {"until": "fan.distal_angle < -90 deg", "state": "folding"}
    chosen = [stages["settle"] | {"until": "time", "time_limit": 0.05}, stages["pulse"], snap]
    design = with_values(whole, {"protocol.contact": True, "protocol.stages": chosen})
    record = simulated(design)
    # the plates of the mid-wing mechanism snap faster than the contact of a first run withstands
    assert "need a contact.time_constant shorter than 0.4 ms" in record.doubt
    assert record.stages[-1].goal_time is not None
    assert energy_balance(record).residual < 5e-3


def test_a_scaled_hindwing_moves_similarly_in_scaled_time_and_its_energies_scale_with_volume():
    whole = load_design("earwig-hindwing")
    pulse = next(stage for stage in whole.protocol.stages if stage.name == "pulse")
    whole = with_values(whole, {"protocol.stages": [pulse.si_tables()]})
    one, other = (simulated(design) for design in (whole, scale_design(whole, 0.5)))
    np.testing.assert_allclose(2 * other.time, one.time, atol=1e-12)
    angles = one.series["hinge_angle"]
    assert np.ptp(angles, axis=0).max() > math.radians(5)
    np.testing.assert_allclose(other.series["hinge_angle"], angles, atol=1e-9)
    for name in ("tendon", "hinge", "coupling", "spring", "membrane", "kinetic"):
        energies = one.series[f"{name}_energy"]
        np.testing.assert_allclose(8 * other.series[f"{name}_energy"], energies, atol=1e-9 * energies.max(), rtol=1e-6)


LEAVES = """
[part.{name}.pattern]
kind = "pleats"
panels = 2
panel_lengths = ["10 cm"]
width = "6 cm"
assignment = "V"
[part.{name}.facet]
kind = "rigid"
thickness = "2 mm"
density = "1 g/cm^3"
{method}
[part.{name}.crease]
stiffness = "1e-3 N m/rad/m"
rest_angle = "0 deg"
[[part.{name}.protocol.stages]]
name = "wait"
drive = "none"
until = "time"
time_limit = "1 s"
"""
TURN = """
[[joint]]
kind = "hinge"
name = "turn"
part = "b"
points = ["facet0_vertex0", "facet0_vertex3"]
"""


def leaves(tmp_path, joint, method=""):
    """Two sheets of two panels; the vertices at the end of one lie on those at the start of the other."""
    parts = "".join(LEAVES.format(name=name, method=method) for name in "ab")
    return read(tmp_path, assembly(parts, TURN + joint, step=0.1).replace("[protocol]", "[protocol]\ncontact = true"))


@pytest.mark.parametrize(("method", "shared"), [("", 2), ('thickness_method = "hinge-shift"', 0)])
def test_thickness_is_ignored_at_a_joint_as_at_a_crease_unless_panels_have_room_for_it(tmp_path, method, shared):
    carried = 'to = "a.facet1"\nonto = ["facet1_vertex2", "facet1_vertex5"]\n'
    structure = structure_of(leaves(tmp_path, carried, method))
    parts = touching_parts(structure, structure.contact)
    bodies = [structure.bodies[structure.points[point].body].name for point in parts.points]
    ends = [
        {parts.vertices[node] for node, body in enumerate(bodies) if body == name} for name in ("a.facet1", "b.facet0")
    ]
    assert len(ends[0] & ends[1]) == shared


def test_vertices_of_parts_that_only_coincide_as_built_touch_each_other(tmp_path):
    beside = 'position = ["20 cm", "0 cm", "0 cm"]\nalong = [0, 1, 0]\n'
    with pytest.raises(InputError, match=r"facet a\.facet1 and facet b\.facet0 .* at the start"):
        simulated(leaves(tmp_path, beside))
