"""Sheets whose facets bend, and short runs of them, for tests of everything that draws runs."""

from functools import cache

from forficula.analysis import measure
from forficula.design import load_design
from forficula.dynamics import compile_model, simulate

_REST = {"name": "rest", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "4 ms", "state": "rests"}
_FOLD = {"name": "fold", "drive": "fold", "until": "creases > 18 deg", "state": "folded", "time_limit": "0.1 s"}
_TENDON = {"name": "corner", "from": "vertex 0", "to": "vertex 24", "stiffness": "0.1 N/cm", "rest_length": "9 cm"}
_QUICK = {"protocol.timestep": "0.04 ms", "protocol.sample_interval": "0.4 ms"}
_STAGES = {"protocol.stages": [_REST, _FOLD | {"hold": "1 ms"}]}
_LOOSE = {"support": [], "drive": [], "measure": [], "tendon": [], "protocol.stages": [_REST]}
# named designs with settings, by description
SHEETS = {
    "miura with a tendon": ("miura-sheet", {"tendon": [_TENDON], "drive.fold.rise": "5 ms"} | _STAGES),
    "membrane": ("miura-sheet", _LOOSE | {"facet.kind": "membrane", "crease.rest_angle": "60 deg"}),
    "flat": ("miura-sheet", _LOOSE | {"pattern.fold": "0 deg", "crease.rest_angle": "60 deg"}),
    "tower": ("kresling-cell", _LOOSE | {"crease.rest_angle": "90 deg"}),
    "single vertex": ("waterbomb-base", _LOOSE | {"crease.rest_angle": "flat"}),
}


@cache
def sheet_run(name):
    """Return the record of a run, and its outcome."""
    design, values = SHEETS[name]
    (record,) = simulate([compile_model(load_design(design, _QUICK | values))])
    return record, measure(record)
