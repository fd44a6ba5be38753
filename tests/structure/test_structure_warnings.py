"""Warnings about a structure before it runs."""

import math

import pytest

from forficula.design import load_design, scale_design, with_values
from forficula.structure import structure_of, structure_warnings

REFERENCE = load_design("binder2025")
TPU = {"tendon.area": "12.5 mm^2", "tendon.law": "tpu-82a"}


def warnings(design):
    return structure_warnings(design, structure_of(design))


def test_veins_that_overlap_near_the_hub_are_only_warned_of():
    # where a vein leaves the hub, the next one passes it at hub_radius x (1 - cos 20 deg) = 0.905 mm
    assert warnings(with_values(REFERENCE, {"vein.diameter": 0.90e-3})) == []
    (warning,) = warnings(with_values(REFERENCE, {"vein.diameter": 0.92e-3}))
    assert warning.startswith("neighbouring veins of 0.92 mm overlap within ")


def test_the_warning_gives_the_distance_from_the_hub_where_veins_overlap():
    # axes are 5 mm apart at (5 mm + 0.905 mm) / sin 20 deg = 17.26 mm; found to a thousandth of the length, 0.12 mm
    (warning,) = warnings(REFERENCE)
    distance = float(warning.partition("within ")[2].partition(" mm")[0])
    assert 17.26 - 0.12 <= distance <= 17.26


def test_the_warning_reads_well_for_a_small_wing():
    (warning,) = warnings(scale_design(REFERENCE, 1 / 22))
    assert warning.startswith("neighbouring veins of 0.2273 mm overlap within 0.78 mm of the hub")


def test_a_medium_heavier_than_the_moving_bodies_gives_a_warning():
    def warned(density):
        return [
            warning for warning in warnings(with_values(REFERENCE, {"medium.density": density})) if "medium" in warning
        ]

    assert not warned(1.2)
    (warning,) = warned(1000.0)
    # pi / 4 rho w by area on two panels, from 0.3 of the proximal length on; three veins of 22 cm
    ring, edge, tip = (2 * math.hypot(along, 0.015) * math.sin(math.radians(10)) for along in (0.12, 0.036, 0.22))
    panels = sum((one + other) ** 2 / 2 * length for one, other, length in ((edge, ring, 0.084), (ring, tip, 0.1)))
    share = math.pi / 4 * 1000 * panels / (3 * 1270 * math.pi / 4 * 0.005**2 * 0.22)
    share_in_warning = float(warning.partition("medium is ")[2].partition(" times")[0])
    assert share_in_warning == pytest.approx(share, rel=0.1)


def test_a_tendon_stretched_beyond_the_measured_range_gives_a_warning():
    def warned(rest_length):
        result = warnings(load_design("binder2025", TPU | {"tendon.rest_length": rest_length}))
        return [warning for warning in result if "measured" in warning]

    # the flat tendon is 10.9 cm long
    assert not warned("6 cm")
    (warning,) = warned("5 cm")
    assert warning.startswith("the flat wing stretches its tendons by 118 %, beyond the 100 % up to which tpu-82a was")


def test_a_softening_law_gives_a_warning_that_the_run_is_the_first_cycle():
    def warned(**values):
        law = {"linear_modulus": 4e6, "softening": {"r": 2.0, "m": 1e5}}
        values = {"tendon.law": law, "tendon.rest_length": 0.09, "tendon.area": 12.5e-6} | values
        return [warning for warning in warnings(with_values(load_design("binder2025"), values)) if "soften" in warning]

    (warning,) = warned()
    assert "the first pull" in warning
    assert "--cycles" in warning
    # slack during the whole run
    assert not warned(**{"tendon.rest_length": 0.12})
    assert not warned(**{"tendon.law": {"linear_modulus": 4e6}})


def test_branches_that_relax_while_the_wing_is_folded_are_warned_of():
    def warned(*times, **values):
        law = {"linear_modulus": 4e6, "branches": [{"modulus": 1e6, "time": time} for time in times]}
        values = {"tendon.law": law, "tendon.rest_length": 0.09, "tendon.area": 12.5e-6} | values
        return [warning for warning in warnings(with_values(load_design("binder2025"), values)) if "relax" in warning]

    (warning,) = warned(0.02, 77.0, 0.5)
    assert warning.startswith("Maxwell branches of 20 ms, 0.5 s relax while the wing is folded")
    # it is folded for 2 s at most
    assert warned(1.9)
    assert not warned(2.1)
    assert not warned()
    folding = load_design("binder2025").model_dump()["protocol"]["stages"][:3]
    assert not warned(0.02, **{"protocol.stages": folding})


def test_what_is_true_of_some_tendons_only_names_them():
    short = {f"tendon.{vein}.rest_length": "5 cm" for vein in (0, 2)}
    result = warnings(load_design("binder2025", TPU | {"tendon.rest_length": "6 cm"} | short))
    (warning,) = [item for item in result if "measured" in item]
    assert warning.startswith("tendon0, tendon2: the flat wing stretches its tendons by 118 %")


def test_a_wing_without_tendons_has_no_tendon_warnings():
    assert len(warnings(with_values(REFERENCE, {"tendon": []}))) == 1


def test_contact_settings_without_contact_give_a_warning():
    idle = load_design("binder2025", {"contact.thickness": "1 mm"})
    sentence = "contact.thickness and contact.friction have no effect without contact: need protocol.contact = true"
    assert sentence in structure_warnings(idle, structure_of(idle))
    touching = load_design("binder2025", {"contact.thickness": "1 mm", "protocol.contact": True})
    assert sentence not in structure_warnings(touching, structure_of(touching))
    assert structure_of(touching).contact.thickness == 1e-3
    assert structure_of(load_design("binder2025", {"protocol.contact": True})).contact.thickness == 1e-4


@pytest.mark.parametrize("name", ["binder2025", "binder2025-joint", "letter-fold", "two-clasps"])
def test_a_direction_of_gravity_without_gravity_gives_a_warning(name):
    idle = load_design(name, {"protocol.gravity_direction": "-y"})
    (sentence,) = [warning for warning in warnings(idle) if "gravity" in warning]
    assert sentence.startswith("protocol.gravity_direction has no effect without gravity: need protocol.gravity = ")
    for settings in ({"protocol.gravity": "1.62 m/s^2"}, {"table.height": "-1 m"}):
        assert sentence not in load_design(name, {"protocol.gravity_direction": "-y"} | settings).idle


def test_a_stage_that_ends_at_rest_without_a_hold_gives_a_warning_with_the_remedy():
    number = next(number for number, stage in enumerate(REFERENCE.protocol.stages) if stage.until == "rest")
    stages = [stage.model_dump() for stage in REFERENCE.protocol.stages]

    def warned(**values):
        changed = [stage | values if place == number else stage for place, stage in enumerate(stages)]
        return [text for text in warnings(with_values(REFERENCE, {"protocol.stages": changed})) if "stages" in text]

    (warning,) = warned(hold=0.0)
    assert warning.startswith(f'protocol.stages.{number}: "{stages[number]["name"]}" ends at the first moment')
    assert "turning point of a swing" in warning
    assert warning.endswith('hold = "0.1 s" ends the stage only after the structure has rested for this time')
    assert not warned(hold=0.1)
    assert not warned(hold=0.0, motion="quasi-static")
    assert not warned(hold=0.0, until="time")
