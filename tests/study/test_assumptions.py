"""Assumptions of a design, changed one at a time: which apply, their effects, and results known without a run."""

import json
from dataclasses import replace

import jsonschema
import numpy as np
import pytest

import forficula as ff
from forficula.analysis import Verdict
from forficula.design import design_from_text, design_text
from forficula.errors import InputError
from forficula.results import json_schema
from forficula.study.assumptions.assumptions import AssumptionRun, Effect, effect_of, run_assumptions
from forficula.study.assumptions.assumptions_file import (
    ASSUMPTIONS_FILE,
    known_assumptions,
    known_text,
    load_assumptions,
    measured_assumptions,
    save_assumptions,
)
from forficula.study.assumptions.modelling_assumptions import ASSUMPTIONS, Assumption, Variant, variant_of
from forficula.study.cycling import least_slow_torques
from tests.assumptions import FLAP, flap

EVERYWHERE = {"half hinge damping", "twice hinge damping", "gravity", "slow rise", "timestep"}
OF_WINGS = EVERYWHERE | {
    *("half other damping", "twice other damping", "tendon height", "membrane mass", "tendon mass", "hinge mass"),
    *("medium", "contact", "stiffer stops", "softer stops", "start", "dry friction"),
}
OF_BENDING = EVERYWHERE | {"no rise", "half other damping", "twice other damping", "medium", "contact", "dry friction"}
APPLY = {
    "binder2025": OF_WINGS | {"armature"},
    "binder2025-built": OF_WINGS,
    "binder2025-joint": EVERYWHERE
    | {"no rise", "tendon height", "tendon mass", "hinge mass", "stiffer stops", "softer stops", "start"}
    | {"dry friction"},
    "letter-fold": OF_BENDING | {"stiffer stops", "softer stops"},
    "bistable-clasp": OF_BENDING,
    "kresling-cell": OF_BENDING,
    # its timestep is "auto", which is determined first
    "four-plate-snap": EVERYWHERE - {"timestep"} | {"no rise", "medium", "contact", "dry friction"},
}


def named(*names):
    return tuple(assumption for assumption in ASSUMPTIONS if assumption.name in names)


def found_of(name):
    design = ff.load_design(name)
    return {assumption.name: variant_of(assumption, design) for assumption in ASSUMPTIONS}


@pytest.mark.parametrize("name", APPLY)
def test_the_assumptions_that_apply_to_each_kind_of_structure_are_changed_and_others_have_a_reason(name):
    result = found_of(name)
    assert {key for key, variant in result.items() if isinstance(variant, Variant)} == APPLY[name]
    assert all(reason.strip() for reason in result.values() if isinstance(reason, str))
    # each changed design can be written to a file
    for variant in result.values():
        if isinstance(variant, Variant):
            assert design_from_text(design_text(variant.design)).hash == variant.design.hash


def test_an_assumption_that_a_design_makes_is_inverted():
    plain, built, joint = found_of("binder2025"), found_of("binder2025-built"), found_of("binder2025-joint")
    assert plain["medium"].label == "in air"
    assert built["medium"].label == "empty space"
    assert built["medium"].design.medium is None
    assert plain["membrane mass"].design.membrane.density == 1200.0
    assert built["membrane mass"].design.membrane.density == 0.0
    assert plain["hinge mass"].design.vein.added_mass == built["hinge mass"].design.vein.added_mass + 1.4e-3
    assert built["tendon mass"].design.tendon.mass == 0.0
    # 3.1 mm: the radius of a bar of 5 mm and half of a thick strap
    assert plain["tendon height"].design.tendon.proximal_offset == pytest.approx(3.1e-3)
    # a twentieth of the 50 and the 10 N cm for folding
    assert plain["dry friction"].design.hinge.friction == 0.025
    assert joint["dry friction"].design.hinge.friction == 0.005
    assert joint["tendon height"].design.tendon.distal_offset == 0.0


def test_creases_get_dry_friction_of_a_share_of_their_moment_at_90_deg_or_lose_theirs():
    (friction,) = named("dry friction")
    letter = ff.load_design("letter-fold")
    added = variant_of(friction, letter).design.crease
    assert added.friction == pytest.approx(0.05 * letter.crease.stiffness * np.pi / 2, rel=0.05)
    group = {"of": "crease 0", "friction": "1 N m/m"}
    rubbing = ff.load_design("letter-fold", {"crease.friction": "1 N m/m", "crease.group": [group]})
    variant = variant_of(friction, rubbing)
    assert variant.label == "no dry friction"
    assert (variant.design.crease.friction, variant.design.crease.group[0].friction) == (0.0, 0.0)
    assert variant_of(friction, flap()).startswith("the creases have no stiffness")


@pytest.mark.parametrize(
    ("name", "settings", "label"),
    [
        ("letter-fold", {"protocol.contact": True, "contact.friction": 0.3}, "no contact"),
        ("two-clasps", {"protocol.contact": True}, "no contact"),
        ("two-clasps", {"protocol.gravity": "9.81 m/s^2"}, "no gravity"),
        ("binder2025-upright", {}, "no gravity"),
        ("binder2025-on-table", {}, "no gravity"),
    ],
)
def test_contact_and_gravity_in_any_direction_are_switched_off(name, settings, label):
    design = ff.load_design(name, settings)
    (variant,) = (variant_of(item, design) for item in named(label.removeprefix("no ")))
    assert (variant.label, variant.design.settled().idle) == (label, ())


def test_tendons_that_differ_from_vein_to_vein_are_all_changed():
    one = {"vein": 0, "stiffness": "10 N/cm", "rest_length": "9 cm", "damping": "0.1 N s/m"}
    ends = {"proximal_attachment": "5.5 cm", "distal_attachment": "5.5 cm"}
    provided = [one | ends, one | ends | {"vein": 2, "damping": "0.3 N s/m"}]
    design = ff.load_design("binder2025").with_values({"tendon": provided})
    (twice,) = named("twice other damping")
    first, none, last = variant_of(twice, design).design.tendons
    assert (first.damping, none, last.damping) == (0.2, None, 0.6)
    (mass,) = named("tendon mass")
    assert all(tendon is None or tendon.mass > 0 for tendon in variant_of(mass, design).design.tendons)


@pytest.fixture(scope="module")
def flapping():
    return run_assumptions(flap())


def test_an_overdamped_hinge_takes_as_long_as_its_damping_and_a_rise_delays_it_by_half_of_itself(flapping):
    # c dq/dt = tau min(t / T, 1): t = c q / tau + T / 2
    creases, torque = 0.21 * FLAP["crease.damping"], 0.3
    as_designed = flapping.own.times["close"]
    assert as_designed == pytest.approx(creases * np.pi / 3 / torque, rel=5e-3)
    times = {run.name: run.times["close"] for run in flapping.runs}
    assert times["twice hinge damping"] == pytest.approx(2 * as_designed, rel=5e-3)
    assert times["half hinge damping"] == pytest.approx(as_designed / 2, rel=2e-2)
    assert times["slow rise"] == pytest.approx(as_designed + 0.2 / 2, rel=5e-3)
    effects = {run.name: run.effect for run in flapping.runs}
    assert {name for name, effect in effects.items() if effect is Effect.NUMBERS} == {
        *("twice hinge damping", "half hinge damping", "slow rise"),
    }
    assert flapping.deciding == ()
    assert flapping.verdict.startswith("closed; none of ")


def test_a_very_slow_torque_agrees_with_statics():
    stages = ff.load_design("binder2025-joint").si_tables()["protocol"]["stages"][:3]
    rise = {"hinge.damping": 1e-4, "protocol.rise": 0.0, "protocol.timestep": 2e-4, "protocol.stages": stages}
    design = ff.load_design("binder2025-joint").with_values(rise)

    def slower(joint):
        later = {"protocol.rise": 1.0, "protocol.stages.1.time_limit": 2.0}
        return Variant(label="far slower", design=joint.with_values(later))

    far = Assumption(name="far slower", meaning="A torque comes at once; instead it rises over 1 s.", change=slower)
    result = run_assumptions(design, assumptions=[*named("slow rise"), far])
    ((least,), *_) = least_slow_torques([design])
    slow, slowest = (0.1 * run.times["fold"] / rise for run, rise in zip(result.runs, (0.3, 1.0), strict=True))
    assert result.own.times["fold"] < 0.02
    assert least < slow < 1.12 * least
    assert least < slowest < 1.05 * least


def test_an_assumption_that_decides_the_verdict_is_confirmed_and_named():
    late = flap({"protocol.stages.0.time_limit": "0.3 s"})
    output = []
    result = run_assumptions(
        late, assumptions=named("twice hinge damping"), progress=lambda stage, *_: output.append(stage)
    )
    ((run,),) = (result.deciding,)
    assert (run.effect, run.verdict, run.times["close"]) == (Effect.VERDICT, Verdict.MOVING, None)
    assert result.verdict == (
        "closed; 1 of 1 changed assumption changes the verdict: twice the damping of hinges (still getting closed)"
    )
    # two runs, and one that confirms at half the timestep
    assert any(stage.startswith("2 of 3 runs") for stage in output)


def a_run(verdict=Verdict.REACHED, time=0.1, goal="close"):
    return AssumptionRun(
        name="gravity",
        label="gravity across the sheet",
        meaning="Nothing weighs.",
        timestep=1e-4,
        verdict=verdict,
        goal=goal,
        word="closed",
        status="closed",
        times={"close": time},
        works={"close": 1.0},
    )


@pytest.mark.parametrize(
    ("run", "effect"),
    [
        (a_run(), Effect.NOTHING),
        (a_run(time=0.1015), Effect.NOTHING),
        (a_run(time=0.103), Effect.NOTHING),  # within the numerical uncertainty
        (a_run(time=0.107), Effect.NUMBERS),
        (a_run(time=None), Effect.NUMBERS),
        (a_run(Verdict.STUCK), Effect.VERDICT),
        (a_run(goal="open"), Effect.VERDICT),
        (a_run(Verdict.UNDECIDED), Effect.UNKNOWN),
        (a_run(Verdict.DIVERGED), Effect.UNKNOWN),
    ],
)
def test_a_change_counts_where_it_exceeds_two_percent_and_the_numerical_uncertainty(run, effect):
    assert effect_of(run, a_run(), {"close.time": 0.005}) is effect
    assert effect_of(run, a_run(Verdict.UNTRUSTED), {}) is Effect.UNKNOWN


def test_table_is_read_back_and_matches_its_schema(flapping, tmp_path):
    save_assumptions(flapping, tmp_path / ASSUMPTIONS_FILE)
    assert load_assumptions(tmp_path / ASSUMPTIONS_FILE) == flapping
    content = json.loads((tmp_path / ASSUMPTIONS_FILE).read_text("utf-8"))
    jsonschema.Draft202012Validator(json_schema("assumptions")).validate(content)
    (tmp_path / ASSUMPTIONS_FILE).write_text('{"design": "x"}')
    with pytest.raises(InputError, match=r"assumptions\.json: not a table of assumptions of forficula"):
        load_assumptions(tmp_path / ASSUMPTIONS_FILE)


def test_the_table_is_a_dataset(flapping):
    table = flapping.to_xarray()
    assert table.sizes == {"run": 1 + len(flapping.runs), "transition": 1}
    assert float(table["time"].sel(run="as designed", transition="close")) == flapping.own.times["close"]
    assert table.attrs["says"] == flapping.verdict


def test_known_assumptions_are_found_in_the_folder_of_the_run_or_beside_it(flapping, tmp_path):
    run, beside = tmp_path / "flap", tmp_path / "flap-assumptions"
    design = flapping.design
    assert known_assumptions(design, run) is None
    save_assumptions(flapping, beside / ASSUMPTIONS_FILE)
    assert known_assumptions(design, run) == (flapping, str(beside))
    assert known_assumptions(design.with_values({"crease.damping": 0.4}), run) is None
    decided = replace(flapping.runs[0], effect=Effect.VERDICT, word="still closing")
    output = known_text(replace(flapping, runs=(decided, *flapping.runs[1:])), "there")
    assert output == (
        f"Assumptions that decide the verdict, 1 of {len(flapping.runs)} changed assumptions: "
        "drives rise over 0.2 s (still closing) (there)."
    )
    (run / ASSUMPTIONS_FILE).parent.mkdir()
    (run / ASSUMPTIONS_FILE).write_text("another file of this name")
    assert known_assumptions(design, run) == (flapping, str(beside))


def test_the_measured_assumptions_of_named_designs_are_those_of_their_present_values(tmp_path):
    """If this fails: run `forficula assumptions NAME` and copy assumptions.json to study/measured/NAME.json."""
    for measured in measured_assumptions():
        assert measured.design.hash == ff.load_design(measured.design.name).hash
    assert known_assumptions(ff.load_design("binder2025"), tmp_path) is not None


def test_the_measured_times_of_the_reference_wing_are_computed_again(reference_outcome):
    (measured,) = (assumption for assumption in measured_assumptions() if assumption.design.name == "binder2025")
    for name, time in measured.own.times.items():
        assert reference_outcome.transitions[name].time == pytest.approx(time, rel=0.02)
    decides = next(run for run in measured.deciding if "damping" in run.name)
    (more,) = named(decides.name)
    again = ff.measure(ff.run(variant_of(more, measured.design).design, confirm=False))
    assert (again.verdict, again.ending.goal) == (decides.verdict, decides.goal)
