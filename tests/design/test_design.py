import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import FanDesign, load_design, with_values
from forficula.design.section import Section, field_quantity
from forficula.errors import InputError
from forficula.quantities import parse_quantity

REFERENCE = load_design("binder2025")


def changed(**values):
    return with_values(REFERENCE, {key.replace("__", "."): value for key, value in values.items()})


def refusal(**values):
    with pytest.raises(InputError) as caught:
        changed(**values)
    return str(caught.value).removeprefix("binder2025: ")


def quantities(part, prefix=""):
    """Every key with a unit, its quantity, and its value."""
    for name, field in type(part).model_fields.items():
        value, quantity = getattr(part, name), field_quantity(field)
        if quantity is not None:
            yield f"{prefix}{name}", quantity, value
        elif isinstance(value, Section):
            yield from quantities(value, f"{prefix}{name}.")
        elif isinstance(value, tuple) and value and isinstance(value[0], Section):
            for index, item in enumerate(value):
                yield from quantities(item, f"{prefix}{name}.{index}.")


def test_the_reference_has_its_chosen_values_in_si():
    # chosen values: 12, 10 and 1.5 cm, 20 deg; 5 mm, 1.27 g/cm3; 1 MPa, 0.1 mm, 1 ms, 2 cm; 3 deg
    pattern, vein, membrane, hinge = REFERENCE.pattern, REFERENCE.vein, REFERENCE.membrane, REFERENCE.hinge
    assert (pattern.proximal_length, pattern.distal_length, pattern.hub_radius) == (0.12, 0.10, 0.015)
    assert (pattern.sector_angle, pattern.units) == (math.radians(20), 1)
    assert (vein.diameter, vein.density) == (0.005, 1270.0)
    assert (membrane.youngs_modulus, membrane.thickness, membrane.poisson_ratio) == (1e6, 1e-4, 0.3)
    assert (membrane.damping, membrane.margin) == (1e-3, 0.02)
    assert (hinge.overbend, hinge.damping, hinge.armature) == (math.radians(3), 1e-3, 1e-5)
    assert (REFERENCE.tendon.proximal_attachment, REFERENCE.tendon.distal_attachment) == (0.055, 0.055)
    assert (REFERENCE.tendon.damping, REFERENCE.protocol.timestep, REFERENCE.guard.stretch) == (0.1, 2e-4, 1.02)
    assert REFERENCE.protocol.stages[0].time_limit == 0.3
    assert REFERENCE.protocol.initial_overbend == math.radians(2)
    assert not REFERENCE.protocol.contact
    assert REFERENCE.protocol.gravity == 0


def test_a_design_cannot_be_changed_in_place():
    with pytest.raises(AttributeError, match=r'^stiffness: designs do not change; .*stiffness": "10 N/cm"'):
        REFERENCE.tendon.stiffness = 1.0
    with pytest.raises(AttributeError, match=r'^name: designs do not change; design.with_values\({"name": '):
        REFERENCE.name = "other"


def test_a_section_shows_its_values_with_units():
    assert "rest_length=9 cm" in repr(REFERENCE.tendon)
    assert "timestep=0.2 ms" in repr(REFERENCE.protocol)


def test_tab_completion_lists_names_of_designs_and_none_of_pydantic():
    names = {name for name in dir(REFERENCE) if not name.startswith("_")}
    assert {"tendon", "protocol", "with_values", "hash"} <= names
    assert not {name for name in names if name.startswith(("model_", "parse_", "schema", "once"))}


QUANTITIES = [(key, quantity) for key, quantity, _ in quantities(REFERENCE)]


@pytest.mark.parametrize(("key", "quantity"), QUANTITIES, ids=[key for key, _ in QUANTITIES])
def test_every_quantity_outside_its_bounds_is_refused_with_the_bounds(key, quantity):
    unit = quantity.unit.display
    too_little = parse_quantity(f"-1000 {unit}", quantity.unit)
    if quantity.above == 0 or quantity.at_least == 0:
        rule = ">" if quantity.above == 0 else ">="
        assert refusal(**{key: too_little}) == f"{key}: need {rule} 0, got -1000 {unit}"
    if quantity.above == 0:
        assert refusal(**{key: 0.0}) == f"{key}: need > 0, got 0 {unit}"
    if math.isfinite(min(quantity.below, quantity.at_most)):
        rule = "<" if math.isfinite(quantity.below) else "<="
        too_much = max(-too_little, 2 * min(quantity.below, quantity.at_most))
        assert f"{key}: need {rule} " in refusal(**{key: too_much})
    for number in (math.nan, math.inf, -math.inf):
        assert refusal(**{key: number}) == f"{key}: need a finite number, got {number} {unit}"
    assert "need text with a unit" in refusal(**{key: True})


def test_some_quantities_have_tighter_bounds_from_theory():
    assert refusal(pattern__sector_angle=math.pi) == "pattern.sector_angle: need < 180 deg, got 180 deg"
    assert refusal(hinge__fold_limit=3.2) == "hinge.fold_limit: need <= 180 deg, got 183.3 deg"
    assert refusal(hinge__overbend=math.pi / 2) == "hinge.overbend: need < 90 deg, got 90 deg"


def test_inside_the_package_a_whole_number_is_an_si_number_too():
    assert changed(tendon__rest_length=0).tendon.rest_length == 0.0


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (1.5, "need a whole number, got 1.5"),
        (1.0, "need a whole number, got 1.0"),
        ("1", 'need a whole number without quotes, got "1"'),
        (True, "need a whole number, got true"),
        (math.inf, "need a whole number, got inf"),
        (0, "need >= 1, got 0"),
        (-1, "need >= 1, got -1"),
        (10**400, "need <= 10000, got a whole number of very many digits"),
    ],
)
def test_a_fan_has_a_whole_number_of_units(value, message):
    assert refusal(pattern__units=value) == f"pattern.units: {message}"


@pytest.mark.parametrize("units", [9, 100])
def test_a_fan_that_closes_on_itself_is_refused_with_the_most_units_it_can_have(units):
    # 2 units x 20 deg < 360 deg
    message = refusal(pattern__units=units)
    assert message.startswith("pattern.units: ")
    assert "at most 8 at 20 deg" in message
    assert message.endswith(f"got {units} units")
    assert changed(pattern__units=8).fan.vein_count == 17


def test_a_hub_so_large_that_the_ring_fold_is_along_the_veins_is_refused():
    # hub_radius < proximal_length / tan(sector_angle / 2) = 12 cm / tan(10 deg)
    assert refusal(pattern__hub_radius=0.69).startswith("pattern.hub_radius: need < 68.0554 cm")


# chord of the ring circle over 20 deg
RING_DISTANCE = 2 * math.hypot(0.12, 0.015) * math.sin(math.radians(10))
# from a ring vertex square to the next vein: both are tangents of the hub, 20 deg apart
RING_GAP = 0.12 * math.sin(math.radians(20)) - 0.015 * (1 - math.cos(math.radians(20)))


@settings(deadline=None)
@given(st.floats(1.0001, 10))
def test_veins_that_overlap_at_the_ring_fold_are_refused(excess):
    message = refusal(vein__diameter=excess * RING_GAP)
    assert message.startswith("vein.diameter: the veins overlap at the ring fold: need < 40.14 mm, ")


@settings(deadline=None)
@given(st.floats(1.0001, 10))
def test_a_margin_wider_than_the_panel_is_refused(excess):
    message = refusal(membrane__margin=excess * RING_DISTANCE)
    assert message.startswith("membrane.margin: the margin is wider than the panel at the ring fold: need < 4.2 cm")


@settings(deadline=None)
@given(st.floats(0.01, 0.9999))
def test_veins_and_margins_narrower_than_the_panel_are_taken(share):
    design = changed(vein__diameter=share * RING_GAP, membrane__margin=share * RING_DISTANCE)
    assert design.vein.diameter < design.membrane.margin


@pytest.mark.parametrize(("end", "length"), [("proximal", "12 cm"), ("distal", "10 cm")])
def test_a_tendon_that_is_attached_beyond_its_bar_is_refused(end, length):
    key = f"tendon.{end}_attachment"
    assert refusal(**{key: 0.13}) == f"{key}: lies beyond the bar: need <= pattern.{end}_length, {length}, got 13 cm"
    at_the_end = getattr(REFERENCE.pattern, f"{end}_length")
    assert getattr(changed(**{key: at_the_end}).tendon, f"{end}_attachment") == at_the_end


@pytest.mark.parametrize("degrees", [-181, 3.001, 90])
def test_the_wing_starts_within_the_limits_of_its_hinges(degrees):
    message = refusal(protocol__initial_overbend=math.radians(degrees))
    allowed = "need >= -180 deg (-hinge.fold_limit) and <= 3 deg (hinge.overbend)"
    assert message == f"protocol.initial_overbend: {allowed}, got {degrees} deg"


@pytest.mark.parametrize(
    ("key", "degrees", "allowed"),
    [
        ("folded_angle", 161, "need <= 160 deg (hinge.fold_limit)"),
        ("opened_angle", 3.5, "need >= -160 deg (-hinge.fold_limit) and <= 3 deg (hinge.overbend)"),
        ("opened_angle", -161, "need >= -160 deg (-hinge.fold_limit) and <= 3 deg (hinge.overbend)"),
    ],
)
def test_a_goal_beyond_the_stops_of_the_hinges_is_refused(key, degrees, allowed):
    limits = {"hinge__fold_limit": math.radians(160)}
    message = refusal(**limits, **{f"protocol__{key}": math.radians(degrees)})
    assert message == f"protocol.{key}: {allowed}, got {degrees} deg"
    at_the_stops = changed(protocol__folded_angle=math.pi, protocol__opened_angle=REFERENCE.hinge.overbend)
    assert at_the_stops.protocol.folded_angle == at_the_stops.hinge.fold_limit


@pytest.mark.parametrize("timestep", [1e-300, 6.2e-9, 6.4, 1e300])
def test_an_unusable_timestep_is_refused_with_the_allowed_range(timestep):
    message = refusal(protocol__timestep=timestep)
    assert message.startswith("protocol.timestep: need >= 6.3e-06 ms and <= 6.3 s, so that all stages together, 6.3 s")
    assert changed(protocol__timestep=6.4e-9, protocol__sample_interval=1e-3).protocol.timestep == 6.4e-9


def test_a_record_that_no_memory_holds_is_refused_with_the_interval_that_one_does():
    message = refusal(protocol__timestep=1e-7, protocol__sample_interval=1e-300)
    assert message.startswith("protocol.sample_interval: need >= 0.00189 ms, so that the record of 3 veins over 6.3 s")
    # rows are no closer than steps
    assert changed(protocol__timestep=1e-4, protocol__sample_interval=1e-9).protocol.sample_interval == 1e-9


@pytest.mark.parametrize("key", ["proximal_length", "distal_length", "hub_radius"])
@pytest.mark.parametrize("length", [1e198, 1.1e12])
def test_lengths_beyond_any_world_are_refused(key, length):
    message = refusal(**{f"pattern__{key}": length})
    assert message.startswith(f"pattern.{key}: need >= ")
    assert message.endswith(f"and <= 1e+14 cm, got {100 * length:.4g} cm")


@pytest.mark.parametrize("key", ["proximal_rows", "distal_rows"])
def test_more_rows_of_the_membrane_than_the_engine_holds_are_refused(key):
    rows = [row / 1001 for row in range(1, 1001)]
    assert refusal(**{f"membrane__{key}": [*rows, 0.9999]}).startswith(
        f"membrane.{key}: need at most 1000 entries, got"
    )


@pytest.mark.parametrize("name", ["", "  ", "a\nb", "\x1b[2J", "\x00", "\x85", "\ud800"])
def test_a_stage_has_a_name_that_a_terminal_and_a_file_can_hold(name):
    stages = [stage.model_dump() for stage in REFERENCE.protocol.stages]
    stages[0]["name"] = name
    assert "stages.0.name: need " in refusal(protocol__stages=stages)


@pytest.mark.parametrize("rows", [[0.5, 0.3], [0.3, 0.3], [0.0], [1.0], [-0.1, 0.5], [1.5]])
def test_rows_of_the_membrane_rise_between_0_and_1(rows):
    for key in ("proximal_rows", "distal_rows"):
        message = f"membrane.{key}: need rising shares between 0 and 1, got {rows}"
        assert refusal(**{f"membrane__{key}": rows}) == message


@pytest.mark.parametrize(
    ("key", "value", "rule"),
    [
        ("membrane.poisson_ratio", 0.5, "need < 0.5, got 0.5"),
        ("membrane.poisson_ratio", -0.1, "need >= 0, got -0.1"),
        ("membrane.poisson_ratio", math.nan, "need a finite number, got nan"),
        ("membrane.poisson_ratio", "0.3", 'need a number without quotes, got "0.3"'),
        ("membrane.poisson_ratio", True, "need a number, got true"),
        ("membrane.margin_limit", 1, "need < 1, got 1"),
        ("guard.stretch", 0.9, "need >= 1, got 0.9"),
        ("guard.stretch", True, "need a number, got true"),
        ("guard.stretch", math.inf, "need a finite number, got inf"),
    ],
)
def test_a_number_without_a_unit_has_bounds_and_cannot_be_text_or_boolean(key, value, rule):
    assert refusal(**{key: value}) == f"{key}: {rule}"


@pytest.mark.parametrize(
    "name", ["a/b", "../up", "a\\b", "a\nb", "..", ".", " ", "x:y", "a?", "aux", "NUL", "com1.x", "wing ", "wing."]
)
def test_a_name_can_name_a_folder_and_no_other_place(name):
    assert refusal(name=name).startswith("name: need a name that a folder can have on every system")


@pytest.mark.parametrize("name", ["wing 2", "Flügel", "binder2025-x0.1", "a.b"])
def test_a_name_is_free_otherwise(name):
    assert changed(name=name).name == name


STAGE = {"name": "a", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.1}
FOLD, UNFOLD = STAGE | {"drive": "fold"}, STAGE | {"drive": "unfold"}


@pytest.mark.parametrize(
    ("stages", "message"),
    [
        ([], "need at least 1 entry, got []"),
        ([FOLD], 'need a first stage with drive = "none", which ends in the flat state, got "fold"'),
        (
            [STAGE, UNFOLD],
            'need a stage with drive = "fold" before the one with drive = "unfold", got ["none", "unfold"]',
        ),
        (
            [STAGE, UNFOLD, FOLD],
            'need a stage with drive = "fold" before the one with drive = "unfold", got ["none", "unfold", "fold"]',
        ),
        ([STAGE, FOLD, FOLD], 'need at most one stage with drive = "fold", got 2'),
        ([STAGE, FOLD, UNFOLD, UNFOLD], 'need at most one stage with drive = "unfold", got 2'),
    ],
)
def test_a_protocol_starts_at_rest_and_folds_once_before_it_opens_once(stages, message):
    assert refusal(protocol__stages=stages) == f"protocol.stages: {message}"


@pytest.mark.parametrize("stages", [[STAGE], [STAGE, FOLD], [STAGE, STAGE, FOLD, STAGE], [STAGE, FOLD, UNFOLD]])
def test_a_protocol_may_end_early(stages):
    assert len(changed(protocol__stages=stages).protocol.stages) == len(stages)


def test_a_misspelt_choice_is_answered_with_the_choices():
    assert refusal(pattern__tangent="up") == 'pattern.tangent: need "left" or "right", got "up"'
    assert refusal(pattern__kind="bat") == (
        'pattern.kind: need "earwig-fan", "joint", "miura-ori", "waterbomb", "yoshimura", "kresling", "pleats",'
        ' "vertex" or "fold-file", got "bat"'
    )
    message = 'protocol.stages.0.drive: need "none", "fold" or "unfold", got "pull"'
    assert refusal(**{"protocol.stages.0.drive": "pull"}) == message


def test_a_timestep_may_be_left_to_the_program():
    assert changed(protocol__timestep="auto").protocol.timestep == "auto"
    assert refusal(protocol__timestep="automatic").endswith('got "automatic"; "auto" is allowed, too')


def test_the_hash_names_the_values_whatever_the_design_is_called():
    assert changed(name="other", source="elsewhere").hash == REFERENCE.hash
    assert len(REFERENCE.hash) == 16


@pytest.mark.parametrize(
    ("key", "value"), [(key, value) for key, _, value in quantities(REFERENCE) if value is not None]
)
def test_values_that_differ_in_the_last_bit_have_different_hashes(key, value):
    # a tendon's density needs its area, and that a density
    value, needed = (1000.0, {"tendon.area": 1e-5}) if key == "tendon.density" else (value, {})
    near = math.nextafter(value, 0.0 if value else 1.0)
    assert changed(**needed, **{key: near}).hash != changed(**needed, **{key: value}).hash


def test_the_json_schema_describes_every_key_and_calls_quantities_text():
    schema = FanDesign.model_json_schema()
    for section, properties in schema["$defs"].items():
        for key, entry in properties["properties"].items():
            assert entry.get("description"), f"{section}.{key}"
    stiffness = schema["$defs"]["TendonSection"]["properties"]["stiffness"]
    assert (stiffness["type"], stiffness["examples"]) == ("string", ["10 N/cm"])
    assert schema["$defs"]["FanProtocol"]["properties"]["timestep"]["type"] == "string"
