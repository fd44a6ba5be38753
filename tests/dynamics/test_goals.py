"""Goals given as text, lists of drives, and named states, in runs."""

from dataclasses import replace

import numpy as np
import pytest

import forficula as ff
from forficula.analysis import Verdict, measure, summary
from forficula.design import StageSection, with_values
from forficula.dynamics import compile_model, simulate
from forficula.dynamics.stepping.stage_plan import stage_torques
from forficula.structure import Measure, RestState, built_points, structure_of
from tests.elastic_joint import joint, stage
from tests.places import places
from tests.structures import compiled

SHORT = with_values(
    ff.load_design("binder2025"),
    {
        "tendon.rest_length": 0.05,
        "protocol.timestep": 4e-4,
        "stops.time_constant": 2e-3,
        "protocol.window": 0.01,
        "protocol.residual_limit": 0.02,
        "protocol.folded_angle": "150 deg",
        "protocol.stages.0.time_limit": 0.02,
        **{f"protocol.stages.{stage}.time_limit": 0.1 for stage in (1, 2, 3, 4)},
        **{f"protocol.stages.{stage}.hold": 0.01 for stage in (2, 3, 4)},
    },
)


def assert_same_bits(record, other):
    assert record.time.tobytes() == other.time.tobytes()
    for name, values in record.series.items():
        assert values.tobytes() == other.series[name].tobytes(), name
    ends, others = ([replace(end, stage=None) for end in item.stages] for item in (record, other))
    assert ends == others


@pytest.fixture(scope="module")
def by_name():
    return ff.run(SHORT, confirm=False)


@pytest.mark.parametrize(
    "values",
    [
        {"protocol.stages.1.until": "ring < -150 deg"},
        {"protocol.stages.1.until": "distal_angle < -150 deg"},
        {"protocol.stages.1.drive": ["fold"]},
        {"protocol.stages.1.drive": ["none", "fold"]},
        {f"protocol.stages.{number}.state": name for number, name in ((0, "flat"), (2, "folded"), (4, "opened"))},
    ],
    ids=["role", "measure", "a list of one", "a list with none", "states by name"],
)
def test_goals_given_as_text_give_the_same_bits_as_named_goals(by_name, values):
    record = ff.run(with_values(SHORT, values), confirm=False)
    assert_same_bits(record, by_name)
    ours, theirs = measure(record), measure(by_name)
    assert theirs.holds["folded"]
    assert (ours.status, ours.holds, ours.transitions) == (theirs.status, theirs.holds, theirs.transitions)
    assert repr(ours.states) == repr(theirs.states)


def test_a_stage_ends_where_all_hinges_of_a_role_have_passed_its_bound():
    every_step = with_values(SHORT, {"protocol.sample_interval": 4e-4, "protocol.least_hold": 0.0})
    record = ff.run(with_values(every_step, {"protocol.stages.1.until": "turn > 10 deg"}), confirm=False)
    fold = record.stages[1]
    turned = np.degrees(record.angles("turn"))
    rows = (record.time > fold.start + 1e-9) & (record.time < fold.end - 1e-9)
    assert rows.sum() > 3
    assert (turned[rows].min(axis=1) < 10).all()
    assert turned[np.argmin(np.abs(record.time - fold.end))].min() >= 10
    assert fold.goal_time == pytest.approx(fold.end, abs=1e-12)
    output = measure(record).stages[1]
    assert (output.goal, output.reached, output.time) == ("turn > 10 deg", True, pytest.approx(fold.end - fold.start))


def test_a_bound_that_is_never_met_is_a_goal_that_was_missed():
    weak = {"protocol.stages.1.until": "ring < -179.9 deg", "protocol.fold_torque": 1e-3}
    record = ff.run(with_values(SHORT, weak), confirm=False)
    outcome = measure(record)
    assert outcome.verdict in (Verdict.STUCK, Verdict.MOVING)
    assert [stage.name for stage in outcome.stages] == ["settle", "fold"]
    assert (outcome.stages[1].reached, outcome.stages[1].time) == (False, None)


def test_the_drives_of_one_stage_are_taken_together():
    model = compile_model(with_values(SHORT, {"protocol.rise": "5 ms"}))
    fold, unfold = (next(drive for drive in model.in_units.drives if drive.name == name) for name in ("fold", "unfold"))
    both = StageSection(name="both", drive=["fold", "unfold"], until="time", hold="0 s", time_limit="1 s")
    assert stage_torques(model, both) == ((fold.strengths, 0.005), (unfold.strengths, 0.005))
    assert stage_torques(model, both.model_copy(update={"drive": "none"})) == ()


def test_a_state_that_a_stage_names_is_that_of_its_end():
    values = {"protocol.stages.1.state": "folded", "protocol.stages.3.state": "opened"}
    record = ff.run(with_values(SHORT, values), confirm=False)
    outcome = measure(record)
    assert outcome.states["flat"] is None
    assert outcome.states["folded"].time == record.stages[1].end
    # under the torque, when its goal is reached
    row = np.flatnonzero(np.abs(record.time - record.stages[1].end) < 1e-9)
    readings = outcome.states["folded"].readings["distal_angle"]
    assert readings.mean == pytest.approx(record.angles("ring")[row[0]], rel=1e-12)
    assert (readings.mean <= -np.radians(150)).all()
    assert summary(record, outcome, {})["states"]["flat"] is None


# ---- distances


def with_gap(*, until="time", **protocol):
    """Return the reference with a gauge between its outer tips, and a protocol of one driven stage."""
    settle = SHORT.protocol.stages[0]
    fold = SHORT.protocol.stages[1].model_copy(update={"until": until, "time_limit": 0.1})
    changed = SHORT.protocol.model_copy(
        update={"stages": (settle, fold), "sample_interval": SHORT.protocol.timestep, "least_hold": 0.0, **protocol}
    )

    def build(design, _):
        structure = structure_of(design)
        tips = [number for number, point in enumerate(structure.points) if point.role == "tip"]
        gap = Measure(name="gap", kind="distance", points=(tips[0], tips[-1]), label="gap")
        watching = replace(structure, measures=(*structure.measures, gap), goals=(), states=(), transitions=())
        narrow = RestState(name="narrow", goal="gap < 1 m", missed="not narrow", unknown="after folding")
        return replace(watching, states=(narrow,), stage_states=("", "narrow"))

    return compiled(SHORT.model_copy(update={"protocol": changed}), build)


@pytest.fixture(scope="module")
def watched():
    return simulate([with_gap()])[0]


def test_a_measured_distance_is_that_of_its_two_points(watched):
    tips = places(watched, "tip")
    apart = np.linalg.norm(tips[:, -1] - tips[:, 0], axis=1)
    assert np.ptp(apart) > 0.01
    assert watched.measured("gap")[:, 0] == pytest.approx(apart, abs=1e-9)
    # as built, with all hinges at 0
    points = built_points(watched.structure)
    ends = watched.structure.measures[-1].points
    flat = np.linalg.norm(points[ends[1]] - points[ends[0]])
    assert watched.measured("gap")[0, 0] == pytest.approx(flat, rel=0.01)
    assert watched.data["distance"].attrs["units"] == "m"


def test_a_sparse_record_keeps_the_distance(watched):
    (sparse,) = simulate([with_gap()], sparse=True)
    assert sparse.measured("gap")[-1].tobytes() == watched.measured("gap")[-1].tobytes()


@pytest.mark.parametrize("share", [0.2, 0.5, 0.8])
def test_a_goal_on_a_distance_ends_its_stage_at_the_step_after_it_is_crossed(watched, share):
    gap, start = watched.measured("gap")[:, 0], watched.stages[1].start
    driven = watched.time >= start - 1e-9
    low, high = gap[driven].min(), gap[driven][0]
    bound = float(f"{100 * (high - share * (high - low)):.4f}")  # cm
    (record,) = simulate([with_gap(until=f"gap < {bound} cm")])
    end = record.stages[1]
    timestep = record.design.protocol.timestep
    crossed = watched.time[driven][np.argmax(gap[driven] < bound / 100)]
    assert end.end == pytest.approx(crossed + timestep, abs=1e-9)
    assert end.goal_time == end.end
    assert record.measured("gap")[-1, 0] < bound / 100


def test_a_state_reads_a_distance_as_a_length(watched):
    outcome = measure(watched)
    state = outcome.states["narrow"]
    rows = watched.time >= watched.stages[1].end - watched.design.protocol.window - 1e-9
    gap = watched.measured("gap")[rows]
    assert state.readings["gap"].mean == pytest.approx(gap.mean(axis=0), rel=1e-12)
    assert (state.readings["gap"].low, state.readings["gap"].high) == (gap.min(), gap.max())
    assert state.coordinates[-1] == pytest.approx(gap.mean(), rel=1e-12)
    assert state.within
    assert outcome.state_names == {"narrow": "narrow"}
    output = summary(watched, outcome, {})["states"]["narrow"]
    assert output["gap_m"] == pytest.approx([gap.mean()], rel=1e-12)
    assert len(output["distal_angle_deg"]) == 3


SLOW = {
    "stops.time_constant": "4 ms",
    "drive.close.rise": "2 s",
    "protocol.timestep": "1 ms",
    "protocol.stages.1.time_limit": "4 s",
}


def test_nothing_is_stuck_while_its_torque_rises():
    """Rising to 3 N cm in 2 s, the torque reaches 0.203 N cm, held by the stops, at 0.135 s: later than a window."""
    letter = ff.load_design("letter-fold", SLOW)
    assert letter.protocol.window < 0.203 / 3 * 2
    outcome = measure(ff.run(letter, confirm=False))
    assert outcome.ending.verdict is Verdict.REACHED
    assert outcome.transitions["close"].time > 0.135
    cut = measure(ff.run(with_values(letter, {"protocol.stages.1.time_limit": "0.12 s"}), confirm=False))
    assert cut.ending.verdict is Verdict.MOVING
    assert cut.status == "at rest while its torque was still rising when its stage ended"
    weak = measure(ff.run(with_values(letter, {"drive.close.value": "0.1 N cm"}), confirm=False))
    assert (weak.ending.verdict, weak.status) == (Verdict.STUCK, "did not get closed")
    # 0.3 s flat, 2 s rise, a window to count as stuck
    assert weak.states["closed"].time == pytest.approx(2.4)


@pytest.mark.parametrize(
    ("drive", "rise", "ends"),
    [("fold", 0.02, (0.02, 0.2)), ("none", 0.02, (0.0, 1e-3))],
    ids=["driven", "undriven"],
)
def test_rest_is_a_goal_only_once_all_drives_of_the_stage_have_risen(drive, rise, ends):
    loaded = stage("load", drive, "rest", limit=0.2)
    values = {"protocol.rise": rise, "protocol.fold_torque": 0.05}
    record = ff.run(joint(**values, **{"protocol.stages": [stage("settle", limit=0.2), loaded]}), confirm=False)
    load = record.stages[1]
    timestep = record.design.protocol.timestep
    assert load.goal_time is not None
    assert ends[0] < load.end - load.start < ends[1]
    assert load.goal_time >= load.start + ends[0] - timestep / 2


LOOSE_STRIP = """
name = "strip"
[pattern]
kind = "pleats"
panels = 2
panel_lengths = ["4 cm"]
width = "3 cm"
assignment = "V"
[facet]
kind = "rigid"
thickness = "0.5 mm"
density = "0.8 g/cm^3"
[crease]
stiffness = "0.02 N m/rad/m"
rest_angle = "0 deg"
damping = "0.02 N m s/rad/m"
[[drive]]
name = "close"
kind = "torque"
of = "creases"
value = "0.6 N cm"
[protocol]
timestep = "0.2 ms"
[[protocol.stages]]
name = "close"
drive = "close"
until = "creases > 60 deg"
state = "closed"
time_limit = "0.5 s"
"""


@pytest.mark.parametrize("places", [["facet 0"], ["vertex 0", "vertex 1", "vertex 3"]])
def test_a_goal_on_a_crease_is_met_at_its_angle_however_the_strip_is_held(tmp_path, places):
    """Facets that are held at vertices move freely, and the engine's positions begin with theirs."""
    supports = "".join(f'[[support]]\nof = "{place}"\n' for place in places)
    (tmp_path / "strip.toml").write_text(LOOSE_STRIP + supports)
    record = ff.run(ff.load_design(tmp_path / "strip.toml"), confirm=False)
    angle = np.degrees(record.angles("crease")[:, 0])
    at_goal = float(np.interp(record.stages[0].goal_time, record.time, angle))
    assert (record.outcome.verdict, at_goal) == (Verdict.REACHED, pytest.approx(60, abs=0.5))
