from forficula.analysis.simulated_snap import finely_sampled
from forficula.design import load_design, with_values
from forficula.study.landscape_and_run import landscape_and_run

SETTLE = {"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.01}


def test_a_landscape_is_that_of_the_design_and_the_run_beside_it_is_sampled_finely():
    design = with_values(load_design("binder2025-joint"), {"protocol.stages": [SETTLE]})
    landscape, record = landscape_and_run(design, simulation=True)
    assert landscape.design.hash == design.hash
    assert record is not None
    assert record.design.hash == finely_sampled(design).hash
