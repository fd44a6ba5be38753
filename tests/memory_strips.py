"""A strip of two facets with one crease that is nonlinear, relaxes or wears out; every run is computed once."""

from functools import cache

from forficula.design import design_from_text, with_values
from forficula.dynamics import simulate
from forficula.dynamics.engine.model import compile_model

WIDTH = 0.02
STIFFNESS, BRANCH, TIME = 1.0 * WIDTH, 0.6 * WIDTH, 0.03
MOMENT = 0.012
BRANCHES = {"crease.branches": [{"stiffness": "0.6 N m/rad/m", "time": "30 ms"}]}
DAMAGE = {"crease.damage": {"loss": 0.5, "turn": "90 deg"}}
NONLINEAR = {"crease.quadratic_stiffness": "0.1 N m/rad^2/m", "crease.cubic_stiffness": "0.3 N m/rad^3/m"}
YIELD = {"crease.yield_moment": "0.3 N m/m", "crease.hardening": "0.4 N m/rad/m"}
# the bars of nodes are softer than by default, which allows longer timesteps
FACETS = {
    "nodes": {"facet.kind": "bars", "facet.youngs_modulus": "1e8 Pa", "protocol.timestep": "0.05 ms"},
    "plates": {"facet.kind": "rigid", "facet.thickness": "0.3 mm", "protocol.timestep": "0.2 ms"},
}
STRIP = f"""
name = "strip"
source = "a test"
[pattern]
kind = "pleats"
panels = 2
panel_lengths = ["4 cm", "4 cm"]
width = "2 cm"
assignment = "V"
[facet]
kind = "bars"
[crease]
stiffness = "1 N m/rad/m"
damping = "5e-3 N m s/rad/m"
rest_angle = "flat"
back_limit = "170 deg"
[[support]]
of = "facet 0"
[[drive]]
name = "fold"
kind = "torque"
of = "creases"
value = "{MOMENT} N m"
rise = "10 ms"
[[protocol.stages]]
name = "fold"
drive = "fold"
until = "time"
time_limit = "0.1 s"
[[protocol.stages]]
name = "release"
drive = "none"
until = "time"
time_limit = "60 ms"
"""


@cache
def strip():
    return design_from_text(STRIP)


def changed(facets, **tables):
    values = FACETS[facets]
    for table in tables.values():
        values = values | table
    return with_values(strip(), values)


@cache
def record(facets, relaxes=False, wears=False, bends=False, yields=False):
    laws = ((BRANCHES, relaxes), (DAMAGE, wears), (NONLINEAR, bends), (YIELD, yields))
    design = changed(facets, **{str(number): law for number, (law, present) in enumerate(laws) if present})
    return simulate([compile_model(design)])[0]
