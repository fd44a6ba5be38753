"""Sweeps over sheets: groups of creases by name, and the energy of creases and bars."""

import pytest

import forficula as ff
from forficula.design import with_values
from forficula.study import load_study, run_study, table_csv

STUDY = """
design = "miura-sheet"
[settings]
"pattern.columns" = 2
"pattern.rows" = 2
"facet.youngs_modulus" = "1 MPa"
"crease.damping" = "1e-3 N m s/rad/m"
"crease.group" = [{name = "gates", of = "role:zigzag", stiffness = "1e-3 N m/rad/m"}]
tendon = []
measure = []
support = [{of = "facet 0"}]
drive = [{name = "fold", kind = "rest-angle", of = "creases", angle = "10 deg", rise = "0.02 s"}]
"protocol.timestep" = "0.08 ms"
[[settings."protocol.stages"]]
name = "fold"
drive = "fold"
until = "time"
hold = "0 s"
time_limit = "0.025 s"
state = "bent"
[factors]
"crease.group.gates.stiffness" = ["1e-3 N m/rad/m", "4e-3 N m/rad/m"]
"""


def test_a_group_of_creases_is_varied_by_its_name(tmp_path):
    (tmp_path / "gates.toml").write_text(STUDY, "utf-8")
    study = load_study(tmp_path / "gates.toml")
    table = run_study(study, tmp_path / "out")
    assert table is not None
    for point, values in enumerate(study.points):
        outcome = ff.measure(ff.run(with_values(study.base, values), confirm=False))
        state = outcome.states["bent"]
        assert float(table["bent_hinge_energy"][point]) == pytest.approx(state.hinge_energy.sum(), rel=1e-9)
        assert float(table["bent_spring_energy"][point]) == pytest.approx(state.spring_energy.sum(), rel=1e-9)
    # without tendons this is all stored energy
    assert table["bent_energy"].values == pytest.approx(
        (table["bent_hinge_energy"] + table["bent_spring_energy"]).values
    )
    assert table["bent_energy"].attrs["long_name"].startswith("stored energy")
    assert table["bent_hinge_energy"][0] != table["bent_hinge_energy"][1]
    assert "energy of the bars" in table["bent_spring_energy"].attrs["long_name"]
    assert "bent_spring_energy_J" in table_csv(study, table).splitlines()[0]
