"""The largest strains, stresses and folds of a run, computed from given positions, compared with closed forms."""

from dataclasses import replace

import numpy as np
import pytest

import forficula as ff
from forficula.analysis import run_warnings
from forficula.analysis.strength import fold_peak, strain_peaks
from forficula.design import load_design, with_values
from forficula.dynamics import Record
from forficula.show.run.strength_rows import strength_rows
from forficula.structure import structure_of

STRETCH = 1.02


def planted(kind):
    """Return a record of a sheet as built, then stretched evenly by 2 % along x."""
    design = load_design("miura-sheet", {"facet.kind": kind, "pattern.fold": "0 deg", "support": []})
    structure = structure_of(design)
    built = np.array([body.position for body in structure.bodies])
    places = np.array([built, built * [STRETCH, 1.0, 1.0], built])
    ends = np.array([spring.points for spring in structure.springs], dtype=int).reshape(-1, 2)
    lengths = np.linalg.norm(places[:, ends[:, 1]] - places[:, ends[:, 0]], axis=2)
    stiffness, rest = ([getattr(spring, name) for spring in structure.springs] for name in ("stiffness", "rest_length"))
    angles = np.zeros((3, len(structure.hinges)))
    angles[1, 4], angles[2, -1] = np.radians(-50), np.radians(80)
    return Record(
        design=design,
        structure=structure,
        time=np.array([0.0, 0.1, 0.2]),
        series={
            "membrane_position": places if structure.membranes else places[:, :0],
            "spring_force": np.array(stiffness) * (lengths - rest),
            "hinge_angle": angles,
        },
        stages=(),
        diverged_at=None,
    )


def test_a_bar_along_the_pull_has_its_strain_and_the_stress_of_its_stiffness():
    record = planted("bars")
    (peak,) = strain_peaks(record)
    spring = next(spring for spring in record.structure.springs if spring.name == peak.part)
    start, end = (record.structure.bodies[point].position for point in spring.points)
    along = (end - start) / np.linalg.norm(end - start)
    expected = np.hypot(STRETCH * along[0], along[1]) - 1
    assert peak.kind == "bars"
    assert peak.time == 0.1
    assert peak.strain == pytest.approx(expected, rel=1e-9)
    # stiffness = E A / L
    modulus = spring.stiffness * spring.rest_length / spring.area
    assert peak.stress == pytest.approx(modulus * expected, rel=1e-9)
    assert modulus == pytest.approx(record.design.settled().facet.youngs_modulus, rel=1e-9)


def test_a_membrane_that_is_pulled_one_way_has_the_stress_of_plane_stress():
    record = planted("membrane")
    (peak,) = strain_peaks(record)
    law = record.structure.membranes[0].law
    # Green strain; the width is fixed
    strain = (STRETCH**2 - 1) / 2
    assert (peak.kind, peak.part, peak.time) == ("membranes", "sheet", 0.1)
    assert peak.strain == pytest.approx(strain, rel=1e-9)
    assert peak.stress == pytest.approx(law.youngs_modulus * strain / (1 - law.poisson_ratio**2), rel=1e-9)


def test_the_largest_stress_of_a_membrane_is_found_where_it_is_pulled_both_ways_by_less():
    record = planted("membrane")
    built, stretched, _ = record.series["membrane_position"]
    both = built * [1.018, 1.018, 1.0]
    (peak,) = strain_peaks(
        replace(record, series=record.series | {"membrane_position": np.array([built, stretched, both])})
    )
    law = record.structure.membranes[0].law
    assert peak.strain == pytest.approx((STRETCH**2 - 1) / 2, rel=1e-9)
    assert peak.stress == pytest.approx(law.youngs_modulus * (1.018**2 - 1) / 2 / (1 - law.poisson_ratio), rel=1e-9)
    assert (peak.time, peak.stressed_at) == (0.1, 0.2)


def test_the_crease_that_folds_furthest_is_named_and_no_bend_is():
    peak = fold_peak(planted("bars"))
    assert (peak.crease, peak.time) == ("crease4", 0.1)
    assert np.degrees(peak.angle) == pytest.approx(-50)


def test_a_diverged_run_has_no_strains():
    record = replace(planted("bars"), diverged_at=0.15)
    assert strain_peaks(record) == ()
    assert fold_peak(record) is None


def test_a_bar_with_a_stress_above_its_strength_gives_a_warning():
    """The same run with a strength above and below its largest stress."""
    stage = {"name": "fold", "drive": "fold", "until": "time", "hold": 0.0, "time_limit": 0.02}
    values = {"pattern.columns": 1, "pattern.rows": 2, "measure": [], "support": []}
    values |= {"protocol.timestep": 2e-5, "protocol.stages": [stage], "facet.youngs_modulus": 2e7}
    design = with_values(load_design("miura-sheet"), values)
    (bars,) = (peak for peak in strain_peaks(ff.run(design, confirm=False)) if peak.kind == "bars")
    assert bars.withstood is None
    for share, output in ((2.0, 0), (0.5, 1)):
        record = ff.run(with_values(design, {"facet.strength": share * abs(bars.stress)}), confirm=False)
        assert sum("facet.strength" in text for text in run_warnings(record)) == output
        (row,) = (row for row in strength_rows(record) if row[0] == "bars")
        assert f"{100 / share:.3g} % of its strength" in row[2]
