"""Small designs of sheets for tests: any pattern, of stiff bars, held by its first facet, without damping."""

import numpy as np

from forficula.design import load_design, with_values
from forficula.design.sheets.sheet_tables import sheet_values

BARS = {
    "facet.kind": "bars",
    "facet.thickness": 2e-4,
    "facet.density": 1270.0,
    "facet.poisson_ratio": 0.3,
    "facet.stretch_damping": 0.0,
    "crease.stiffness": 0.02,
    "crease.rest_angle": "flat",
    "crease.damping": 0.0,
    "support": [{"of": "facet 0"}],
    "tendon": [],
    "measure": [],
    "drive": [],
    "protocol.least_hold": 0.0,
    "protocol.sample_interval": 1e-3,
}


def stage(drive="none", until="time", limit=0.1, hold=0.0):
    return {"name": f"{drive} {until}", "drive": drive, "until": until, "hold": hold, "time_limit": limit}


def sheet_design(pattern, values):
    """A design of a crease pattern, of bars unless the values say otherwise."""
    return with_values(load_design("miura-sheet"), BARS | {"pattern": sheet_values(pattern)} | values)


def fold_angles(record):
    """Fold angles of the creases, valley positive, rad, (time, crease), and the numbers of their edges."""
    hinges = record.structure.hinges
    creases = [number for number, hinge in enumerate(hinges) if hinge.name.startswith("crease")]
    senses = np.array([hinges[number].sense for number in creases])
    edges = [int(hinges[number].name.removeprefix("crease")) for number in creases]
    return senses * record.series["hinge_angle"][:, creases], np.array(edges)


def stored_energy(record):
    """What creases, bends and bars store, J, (time,)."""
    return record.series["hinge_energy"].sum(axis=1) + record.series["spring_energy"].sum(axis=1)
