"""Contact of facets, plates and bars in runs: forces, rest states, refusals and measured overlaps."""

import math

import numpy as np
import pytest

import forficula as ff
from forficula.analysis.contact_overlap import contact_overlap, contact_text, overlap_of
from forficula.analysis.run_files import write_run_files
from forficula.analysis.run_warnings import run_warnings
from forficula.analysis.summary import summary
from forficula.dynamics import compile_model, load_record, resolving_time_constant, simulate, with_timestep
from forficula.dynamics.engine.contact_forces import ContactForces
from forficula.dynamics.engine.contact_geometry import contact_geometry
from forficula.errors import InputError
from forficula.structure import built_points, structure_of
from forficula.structure.contact.distances import node_from_triangle, side_from_side, squared_sines
from forficula.structure.contact.pairs import near_pairs, parts_that_cross
from forficula.structure.contact.touching_parts import touching_parts
from forficula.study.running.runs import run_each
from tests.plate_sheets import LENGTH, strip

THICK = 1e-3
CLOSE = [
    {"name": "close", "kind": "torque", "of": "creases", "value": "0.02 N m", "rise": "2 ms"},
]


def closing(panels=2, *, letters="V", time=0.02, **values):
    """Panels that a torque on every crease closes, with contact."""
    stages = [{"name": "close", "drive": "close", "until": "time", "hold": 0.0, "time_limit": time}]
    chosen = {
        "drive": CLOSE,
        "crease.start": math.radians(178),
        "crease.damping": 0.02,
        "protocol.contact": True,
        "protocol.timestep": 5e-5,
        "protocol.sample_interval": 2e-3,
    }
    return strip(panels, letters=letters, stages=stages, **(chosen | values))


@pytest.fixture(scope="module")
def closed():
    """Run of two panels until they rest on each other."""
    return ff.run(closing(), confirm=False)


@pytest.mark.parametrize("shape", [node_from_triangle, side_from_side])
def test_weights_times_normals_are_the_gradient_of_the_distance(shape):
    corners = np.random.default_rng(1).normal(size=(100, 4, 3))
    nearest = shape(corners)
    slopes = np.zeros_like(corners)
    for place in np.ndindex(4, 3):
        step = np.zeros((4, 3))
        step[place] = 1e-6
        slopes[(slice(None), *place)] = (shape(corners + step).distances - shape(corners - step).distances) / 2e-6
    np.testing.assert_allclose(nearest.weights[:, :, None] * nearest.normals[:, None], slopes, atol=1e-8)
    np.testing.assert_allclose(nearest.weights.sum(axis=1), 0, atol=1e-12)


def test_the_gradient_of_the_angle_between_sides_is_exact():
    corners = np.random.default_rng(2).normal(size=(50, 4, 3))
    slopes = np.zeros_like(corners)
    for place in np.ndindex(4, 3):
        step = np.zeros((4, 3))
        step[place] = 1e-6
        slopes[(slice(None), *place)] = (squared_sines(corners + step)[0] - squared_sines(corners - step)[0]) / 2e-6
    np.testing.assert_allclose(squared_sines(corners)[1], slopes, atol=1e-7)


def test_forces_of_contact_have_no_resultant_and_no_moment():
    design = ff.load_design("miura-sheet", {"support": [], "protocol.contact": True, "contact.friction": 0.3})
    model = compile_model(design)
    geometry = contact_geometry(model)
    random = np.random.default_rng(3)
    position, velocity = np.array(model.engine.qpos0), random.normal(size=model.engine.nv)
    slides = geometry.placement.slides[geometry.carriers]
    _, places, _ = geometry.nodes(position)
    # the sheet is crumpled until facets touch
    forces = np.zeros(0)
    for size in np.linspace(0.1, 2, 40):
        crumpled = position.copy()
        crumpled[slides.ravel()] += size * random.normal(size=places.size)
        forces, overlaps, _ = ContactForces([model]).forces(np.array([0]), crumpled[None], velocity[None])
        if overlaps[0] > 0:
            break
    pushes = forces[0][slides]
    _, places, _ = geometry.nodes(crumpled)
    scale = np.abs(pushes).max()
    assert scale > 0
    np.testing.assert_allclose(pushes.sum(axis=0), 0, atol=1e-9 * scale)
    # friction springs of a shape that is displaced from the one at which facets began to touch
    contact, still = ContactForces([model]), np.zeros_like(velocity[None])
    contact.forces(np.array([0]), crumpled[None], still)
    shifted = crumpled + 1e-4 * random.normal(size=places.size)
    held, _, _ = contact.forces(np.array([0]), shifted[None], still)
    _, moved, _ = geometry.nodes(shifted)
    scale = np.abs(held).max()
    assert contact.friction_springs[0].energy > 0
    np.testing.assert_allclose(held[0][slides].sum(axis=0), 0, atol=1e-9 * scale)
    np.testing.assert_allclose(np.cross(moved, held[0][slides]).sum(axis=0), 0, atol=1e-9 * scale * np.ptp(moved))
    # forces of dampers along sliding velocities act at both nearest points, a thickness apart
    smooth = compile_model(design.with_values({"contact.friction": 0.0}))
    forces, _, _ = ContactForces([smooth]).forces(np.array([0]), crumpled[None], velocity[None])
    moment = np.cross(places, forces[0][slides]).sum(axis=0)
    np.testing.assert_allclose(moment, 0, atol=1e-9 * scale * np.ptp(places))


def test_two_panels_rest_one_thickness_apart_and_the_balance_closes(closed):
    folded = math.pi - closed.series["hinge_angle"][-1, 0]
    assert LENGTH * math.sin(folded) == pytest.approx(THICK, rel=0.01)
    assert ff.measure(closed).energy_balance.residual < 1e-6
    assert closed.series["contact_work"][-1] < 0


def test_the_recorded_overlap_agrees_with_that_of_separate_geometry(closed):
    overlap = contact_overlap(closed)
    parts = touching_parts(closed.structure, closed.structure.contact)
    for row in (-1, len(closed.time) // 2):
        places = closed.series["point_position"][row][parts.points]
        pairs = near_pairs(parts, places, 0.0)
        expected = max(float((pairs.thickness - pairs.nearest(places).distances).max(initial=0.0)), 0.0)
        assert overlap_of(parts, places)[0] == pytest.approx(expected, abs=1e-6 * THICK)
    assert overlap.share <= overlap.share_in_steps < 0.1
    assert not any("overlap" in text for text in run_warnings(closed))


def test_structures_side_by_side_have_the_bits_of_each_alone():
    values = [(0.02, 0.0), (0.01, 0.0), (0.01, 0.3)]
    designs = [closing(time=0.012, **{"crease.damping": one, "contact.friction": other}) for one, other in values]
    models = [compile_model(design) for design in designs]
    for together, model in zip(simulate(models), models, strict=True):
        (alone,) = simulate([model])
        assert alone.series["contact_overlap"][-1] > 0
        assert alone.series.keys() == together.series.keys()
        for name, series in alone.series.items():
            np.testing.assert_array_equal(together.series[name], series)
    assert alone.series["friction_spring_energy"].max() > 0


def test_a_structure_that_follows_another_one_keeps_the_overlap_of_their_common_stages():
    def closing_and_resting(time):
        ends = {"until": "time", "hold": 0.0}
        stages = [
            {"name": "close", "drive": "close", "time_limit": 0.012, **ends},
            {"name": "rest", "drive": "none", "time_limit": time, **ends},
        ]
        return closing(**{"protocol.stages": stages, "crease.damping": 0.01, "contact.friction": 0.3})

    designs = [closing_and_resting(time) for time in (0.002, 0.003)]
    _, together = [record.series for _, record in run_each(designs)]
    (alone,) = [record.series for _, record in run_each(designs[1:])]
    assert alone["contact_overlap"][-1] > 0
    for name in ("contact_overlap", "friction_spring_energy", "hinge_angle"):
        assert together[name][-1] == alone[name][-1]


def test_facets_that_bend_are_one_thickness_apart():
    values = {
        "facet.kind": "membrane",
        "facet.youngs_modulus": 2e7,
        "facet.poisson_ratio": 0.3,
        "crease.start": 0.0,
        "crease.stiffness": 1e-3,
        "crease.fold_limit": None,
        "crease.back_limit": None,
        "contact.time_constant": 8e-4,
        "protocol.timestep": 1e-4,
    }
    record = ff.run(closing(time=0.24, **values), confirm=False)
    # the facets twist a little, so the distances of the corners that lie on each other are compared
    places = record.series["point_position"][-1]
    np.testing.assert_allclose(np.linalg.norm(places[[0, 3]] - places[[2, 5]], axis=1), THICK, rtol=0.02)
    assert ff.measure(record).energy_balance.residual < 0.005


def test_a_contact_that_is_too_soft_makes_a_run_unreliable():
    record = ff.run(
        closing(time=0.02, **{"contact.time_constant": 5e-3, "crease.damping": 0.0, "crease.start": 3.0}), confirm=False
    )
    assert record.overlaps
    assert "need a contact.time_constant shorter than 5 ms, such as 0.83" in record.doubt
    assert ff.measure(record).verdict == "untrusted"
    assert any("of their thickness" in text for text in run_warnings(record))


def test_the_time_constant_of_an_advice_reduces_an_overlap_to_about_a_tenth():
    values = {"crease.damping": 0.0, "crease.start": 3.0, "protocol.timestep": 2e-5}
    before = ff.run(closing(**values, **{"contact.time_constant": 1.2e-3}), confirm=False).record
    deep = before.series["contact_overlap"][-1]
    assert 0.15 < deep < 0.5
    need = resolving_time_constant(before.structure.contact, deep)
    after = ff.run(closing(**values, **{"contact.time_constant": need}), confirm=False).record
    assert after.series["contact_overlap"][-1] == pytest.approx(0.1, abs=0.02)


# panels that snap shut so fast that they pass through each other with the first time constant that a run tries
FAST = {"crease.damping": 0.0, "crease.start": 3.0, "contact.thickness": 1e-4}


@pytest.fixture(scope="module")
def derived():
    """Run of fast panels, and its second runs, with contact switched on and nothing else."""
    return ff.run(closing(**FAST)).record


def test_a_run_derives_a_time_constant_with_which_parts_overlap_by_at_most_a_tenth(derived):
    first, last = derived.contact_runs
    assert (first.time_constant, first.timestep) == (4e-4, 5e-5)
    assert first.overlap > 0.5
    assert last.overlap == derived.series["contact_overlap"][-1] <= 0.1
    assert last.timestep <= last.time_constant / 8
    assert ff.measure(derived).verdict == "reached"
    assert not any("overlap" in text for text in run_warnings(derived))
    # the second run differs only in the timestep
    assert [check.timestep for check in derived.checks] == [last.timestep / 2]
    assert ff.measure(derived).confirmation.agree


def test_a_run_with_the_derived_time_constant_and_timestep_has_the_same_bits(derived):
    again = ff.run(derived.design, confirm=False).record
    np.testing.assert_array_equal(again.series["hinge_angle"], derived.series["hinge_angle"])
    assert again.contact_runs == ()


def test_the_derived_time_constant_is_in_the_files_of_a_run_and_in_the_terminal(derived, tmp_path):
    written = summary(derived, ff.measure(derived), {})["contact_overlap"]
    last = derived.contact_runs[-1]
    assert (written["time_constant_s"], written["derived"]) == (last.time_constant, True)
    assert [run["overlap"] for run in written["runs"]] == [run.overlap for run in derived.contact_runs]
    derived.save(tmp_path / "record.nc")
    assert load_record(tmp_path / "record.nc").contact_runs == derived.contact_runs
    write_run_files(derived, ff.measure(derived), tmp_path)
    line = 'time_constant = "0.046 ms"  # derived by the run; "auto" derives it again'
    assert line in (tmp_path / "design.toml").read_text("utf-8").splitlines()
    text = contact_text(derived)
    assert text.startswith(
        "The run derived contact.time_constant = 46 µs and a timestep of 5.556 µs. With these values,"
    )
    assert text.endswith("and in earlier runs by 100 % with 0.4 ms.")


def test_a_time_constant_of_a_design_is_kept(closed):
    record = ff.run(closing(**FAST, **{"contact.time_constant": 4e-4}), confirm=False).record
    assert record.contact_runs == ()
    assert ff.measure(record).verdict == "untrusted"
    assert not summary(closed, ff.measure(closed), {})["contact_overlap"]["runs"][1:]


def test_the_shortest_timestep_of_a_design_limits_the_time_constant():
    record = ff.run(closing(**FAST, **{"protocol.shortest_timestep": 1e-5}), confirm=False).record
    assert [run.time_constant for run in record.contact_runs] == [4e-4]
    assert contact_text(record).endswith("overlap by 100 % of their thickness.")
    assert ff.measure(record).verdict == "untrusted"


def test_a_timestep_is_shortened_only_where_parts_touch(tmp_path):
    apart = ff.run(closing(time=2e-3, **{"crease.start": 0.0, "protocol.timestep": 2e-4}), confirm=False).record
    assert apart.design.protocol.timestep == 2e-4
    assert contact_text(apart) == ""
    assert [(run.time_constant, run.overlap) for run in apart.contact_runs] == [(4e-4, 0.0)]
    write_run_files(apart, ff.measure(apart), tmp_path)
    assert '"0.4 ms"  # derived by the run; "auto" derives it again' in (tmp_path / "design.toml").read_text("utf-8")
    touching = ff.run(closing(**(FAST | {"contact.thickness": THICK, "protocol.timestep": 2e-4})), confirm=False).record
    assert [(run.time_constant, run.timestep) for run in touching.contact_runs] == [(4e-4, 5e-5)]
    assert ff.measure(touching).verdict == "reached"


@pytest.mark.parametrize("values", [{"protocol.timestep": 2e-3}, {"contact.thickness": 1e-5}])
def test_a_run_is_repeated_where_parts_pass_through_each_other_within_a_step(values):
    """No contact force acts in the first run, because the parts are apart before and after every step."""
    record = ff.run(closing(**(FAST | values)), confirm=False).record
    assert ff.measure(record).verdict == "reached"
    assert record.contact_runs[0].overlap > 0.5
    assert record.contact_runs[-1].overlap <= 0.1
    assert math.degrees(record.series["hinge_angle"].max()) < 180


def test_an_automatic_timestep_is_shortened_until_it_resolves_contact():
    # the first timestep of the search is half the time constant, in which the panels pass through each other
    values = {"crease.damping": 0.0, "crease.start": 3.0, "protocol.timestep": "auto"}
    record = ff.run(closing(**values), confirm=False)
    assert not record.overlaps
    assert ff.measure(record).verdict == "reached"


def test_an_automatic_timestep_may_be_a_power_of_ten():
    design = closing(**{"protocol.timestep": "auto", "contact.time_constant": "80 us"})
    assert with_timestep(design).protocol.timestep == 1e-5


def test_a_bouncy_contact_needs_a_shorter_timestep():
    bouncy = {"contact.damping_ratio": 0.1, "contact.time_constant": 4e-4}
    record = ff.run(closing(**bouncy), confirm=False)
    assert ff.measure(record).verdict == "untrusted"
    steps = [
        with_timestep(closing(**{"protocol.timestep": "auto", "contact.damping_ratio": ratio})).protocol.timestep
        for ratio in (1.0, 0.5, 0.25)
    ]
    np.testing.assert_allclose(steps, [5e-5, 5e-5, 2e-5], rtol=0.3)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"contact.thickness": "12 cm"}, "contact.thickness: facet 0 and facet 1 are nearer than that at the start"),
        (
            {"crease.start": math.radians(179.9)},
            "contact.thickness: facet 0 and facet 1 are nearer than that at the start: need <= 0.1745 mm, got 1 mm",
        ),
    ],
)
def test_parts_that_overlap_at_the_start_are_named_with_the_largest_thickness(values, message):
    with pytest.raises(InputError) as error:
        compile_model(closing(**values))
    assert str(error.value).startswith(message)


def test_parts_that_cross_at_the_start_are_named():
    # both outer panels of a letter fold are closed beyond the middle
    design = closing(3, **{"support": [{"of": "facet 1"}], "crease.start": math.radians(175)})
    with pytest.raises(InputError) as error:
        compile_model(design)
    assert str(error.value).startswith("protocol.contact: facet 0 and facet 2 pass through each other at the start")


def test_sheets_as_built_do_not_cross():
    for name in ("miura-sheet", "kresling-cell", "waterbomb-base", "earwig-midwing"):
        structure = structure_of(ff.load_design(name, {"protocol.contact": True}))
        parts = touching_parts(structure, structure.contact)
        assert not parts_that_cross(parts, built_points(structure)[parts.points])


def test_friction_of_panels_closes_the_balance():
    smooth, rough = (ff.run(closing(**{"contact.friction": friction}), confirm=False) for friction in (0.0, 0.5))
    lost = [ff.measure(record).energy_balance.contacts for record in (smooth, rough)]
    assert all(ff.measure(record).energy_balance.residual < 0.005 for record in (smooth, rough))
    assert lost[1] != lost[0]


def test_the_summary_has_the_overlap(closed):
    written = summary(closed, ff.measure(closed), {})
    assert written["contact_overlap"]["share_in_steps"] == closed.series["contact_overlap"][-1]
    assert written["energy_balance"]["contacts_J"] > 0


def test_a_run_in_whose_last_step_panels_pass_through_each_other_is_unreliable():
    # one step turns the second panel from 178 deg to beyond 190 deg; no force is computed after this step
    values = {"crease.damping": 0.002, "protocol.sample_interval": 0.02, "protocol.timestep": 0.02}
    record = ff.run(closing(**values, **{"contact.time_constant": 2e-3}), confirm=False).record
    assert math.degrees(record.series["hinge_angle"][-1, 0]) > 190
    assert record.series["contact_overlap"].tolist() == [0.0, 1.0]
    assert record.doubt.startswith("parts that touch overlap by 100 % of their thickness")
