"""Short digests of the numbers of today, so that a later version can be held to them bit for bit.

`python tests/validation/digests.py` computes all of them and compares, `--write` keeps them in
`reference_digests.json`, `--only NAME` does one case, or those whose names begin so. Words have digests, too. Where
things go by other names than when the digests were kept, only the functions under "where a number is found" change; its
old name stays, and what is new is not compared.

Last bits depend on the processor and on the versions of numpy, scipy and MuJoCo: the case "canary" computes what uses
none of our code, and where it comes out otherwise than kept, the digests say nothing. There, check out the commit that
made them, run it with `--write --kept PATH`, and compare with `--kept PATH`.
"""

from __future__ import annotations

import argparse
import csv
import dataclasses
import enum
import hashlib
import importlib.metadata
import io
import json
import math
import re
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq, least_squares
from scipy.spatial.transform import Rotation

import forficula as ff
from forficula.analysis.summary import summary
from forficula.design import Design
from forficula.dynamics import Record
from forficula.statics import EnergyLandscape, landscape_summary
from forficula.statics.hinge_landscape import HingeLandscape
from forficula.study.convergence import converge
from forficula.study.evaluate import evaluate, row_key
from forficula.study.static_map import map_study, static_map
from forficula.study.table import table_csv

KEPT = Path(__file__).with_name("reference_digests.json")
_LETTERS = 16
_NOT_NUMBERS = ("design", "design_hash", "versions")

Settings = dict[str, object]

_COARSE: Settings = {"protocol.timestep": "0.2 ms"}
_FINE: Settings = {"protocol.timestep": "0.1 ms"}
_THREE: Settings = {"pattern.units": 3, "pattern.sector_angle": "15 deg"}
_FOUR: Settings = {"pattern.units": 4, "pattern.sector_angle": "13 deg"}
_FIVE: Settings = {"pattern.units": 5, "pattern.sector_angle": "12 deg"}
_MAXWELL = [{"modulus": "1 MPa", "time": "2 ms"}, {"modulus": "0.5 MPa", "time": "50 ms"}]
_FULL_LAW = {
    "linear_modulus": "4.8 MPa",
    "quadratic_modulus": "-1 MPa",
    "cubic_modulus": "1 MPa",
    "linear_viscosity": "300 Pa s",
    "quadratic_viscosity": "2 Pa s^2",
    "branches": _MAXWELL[:1],
    "yield_strain": "10 %",
    "residual_strain": "2 %",
}
# settings over binder2025, as a user writes them
DESIGNS: dict[str, Settings] = {
    "one-unit": _COARSE,
    "one-unit-auto": {"protocol.timestep": "auto", "tendon.rest_length": "8 cm", "protocol.rest_speed": "10 deg/s"},
    "one-unit-rise": {
        **_FINE,
        "tendon.stiffness": "20 N/cm",
        "tendon.rest_length": "8.5 cm",
        "protocol.rise": "50 ms",
        "protocol.fold_torque": "100 N cm",
        "protocol.unfold_torque": "200 N cm",
    },
    "one-unit-tpu-82a": {**_COARSE, "tendon.law": "tpu-82a", "tendon.area": "12.5 mm^2"},
    "one-unit-full-law": {
        **_FINE,
        "tendon.law": _FULL_LAW,
        "tendon.area": "18.75 mm^2",
        "protocol.fold_torque": "100 N cm",
        "protocol.folded_angle": "100 deg",
    },
    "one-unit-left-membrane": {
        **_FINE,
        "pattern.tangent": "left",
        "membrane.youngs_modulus": "0.4 MPa",
        "membrane.proximal_rows": [0.3, 0.6],
        "membrane.distal_rows": [0.5],
        "tendon.proximal_attachment": "5 cm",
        "protocol.folded_angle": "90 deg",
    },
    "one-unit-diverges": {"protocol.timestep": "5 ms"},
    "two-units-contact-gravity": {
        **_FINE,
        "pattern.units": 2,
        "protocol.contact": True,
        "protocol.gravity": "9.81 m/s^2",
        "protocol.fold_torque": "100 N cm",
    },
    "two-units-maxwell": {
        **_FINE,
        "pattern.units": 2,
        "tendon.law": {"linear_modulus": "4.8 MPa", "branches": _MAXWELL},
        "tendon.area": "18.75 mm^2",
        "protocol.fold_torque": "100 N cm",
    },
    "three-units-yield": {
        **_FINE,
        **_THREE,
        "tendon.law": {"linear_modulus": "4.8 MPa", "linear_viscosity": "480 Pa s", "yield_strain": "10 %"},
        "tendon.area": "15 mm^2",
        "tendon.rest_length": "8 cm",
        "protocol.fold_torque": "200 N cm",
    },
    "four-units-resilin-gravity-rise": {
        **_FINE,
        **_FOUR,
        "tendon.law": {"based_on": "resilin", "linear_modulus": "1 MPa"},
        "tendon.area": "60 mm^2",
        "protocol.gravity": "9.81 m/s^2",
        "protocol.rise": "20 ms",
        "protocol.fold_torque": "100 N cm",
    },
    "five-units": {**_FINE, **_FIVE, "protocol.fold_torque": "100 N cm"},
    "five-units-all": {
        **_FINE,
        **_FIVE,
        "pattern.tangent": "left",
        "membrane.youngs_modulus": "1.5 MPa",
        "tendon.law": _FULL_LAW,
        "tendon.area": "18.75 mm^2",
        "protocol.contact": True,
        "protocol.gravity": "9.81 m/s^2",
        "protocol.rise": "20 ms",
        "protocol.fold_torque": "200 N cm",
    },
}
LANDSCAPES: dict[str, Settings] = {
    "one-unit": {},
    "two-units-law": {
        "pattern.units": 2,
        "tendon.law": _FULL_LAW,
        "tendon.area": "18.75 mm^2",
    },
    "one-unit-left-membrane": DESIGNS["one-unit-left-membrane"],
}
# sparse runs, whose sums go other ways than those of a run with a record
ROWS = ("one-unit", "one-unit-tpu-82a", "two-units-contact-gravity", "three-units-yield")
# patterns that differ
PATTERNS = ("one-unit", "one-unit-left-membrane", "two-units-maxwell", "three-units-yield", "five-units-all")
TENDONS = {"tendon.stiffness": "10..60 N/cm step 10", "tendon.rest_length": "0..9 cm step 1"}

Numbers = dict[str, Any]


# Where a number is found, by the name that it had when the digests were kept.


_JOINTS = ("sweep", "lift", "turn", "distal")


def record_series(record: Record) -> dict[str, np.ndarray]:
    """Every array of a record by its name."""
    series = dict(record.series)
    angles = series.pop("hinge_angle")
    for number, joint in enumerate(_JOINTS):
        series[f"{joint}_angle"] = angles[:, number::4]
    for kind in ("work", "power"):
        motors = series.pop(f"motor_{kind}")
        series |= {f"{name}_{kind}": motors[:, number] for number, name in enumerate(("proximal", "distal"))}
    if "point_position" in series:
        points = series.pop("point_position")
        # hub end, ring vertex and tip of each vein, which has its two attachments before the tip
        series["vein_position"] = np.stack([points[:, place::5] for place in (0, 1, 4)], axis=2)
    return {**series, "time": record.time, "triangles": record.triangles}


def stage_numbers(record: Record) -> Numbers:
    """How the stages went, each number as a list by stage, and the ending of the run."""
    stages = {
        name: [getattr(end, name) for end in record.stages]
        for name in ("start", "end", "goal_time", "at_rest", "at_goal")
    }
    return {**stages, "diverged_at": record.diverged_at, "doubt": record.doubt}


def measured_numbers(record: Record) -> Numbers:
    """What a record means."""
    outcome = ff.measure(record)
    numbers: Numbers = {
        "status": outcome.status,
        "advice": outcome.advice,
        "folded": outcome.holds["folded"],
        "opened": outcome.holds["opened"],
        "ending.verdict": outcome.ending.verdict,
        "ending.goal": outcome.ending.goal,
        "ending.angle": outcome.ending.reading,
        "ending.time": outcome.ending.time,
        "ending.residual": outcome.ending.residual,
        "ending.why": outcome.ending.why,
        **dict(_fields(outcome.energy_balance, "energy_balance")),
    }
    for name, state in (("flat", "flat"), ("folded_state", "folded"), ("opened_state", "opened")):
        found = outcome.states[state]
        if found is None:
            numbers[name] = None
            continue
        reading = found.readings["distal_angle"]
        numbers |= {f"{name}.distal_angle{kind}": getattr(reading, field) for kind, field in _READINGS.items()}
        kept = ("time", "tendon_length", "tendon_energy", "membrane_energy")
        numbers |= {f"{name}.{field}": getattr(found, field) for field in kept}
    for name, transition in outcome.transitions.items():
        # what was a torque then is how strong any drive is
        fields = dict(_fields(transition, name))
        numbers |= {re.sub(r"\.strength$", ".torque", field): value for field, value in fields.items()}
    return numbers


_READINGS = {"": "mean", "_low": "low", "_high": "high"}


def summary_of(record: Record) -> Numbers:
    """The summary, but for what names the design and the versions."""
    whole = summary(record, ff.measure(record), versions={})
    return dict(_fields({name: value for name, value in whole.items() if name not in _NOT_NUMBERS}))


def landscape_numbers(landscape: EnergyLandscape) -> Numbers:
    """Every number of a landscape that has a digest, by the name that its digest was kept by."""
    since = ("structure.", "rests.", "states.", "passes.", "courses.", "hinges.", "fold_path.turns", "fold_path.folds")
    numbers = {_kept_name(name): value for name, value in _fields(landscape) if not name.startswith(since)}
    assert landscape.fold_path is not None
    return {
        **numbers,
        **dict(_fields(landscape.hinge, "hinge")),
        **dict(_fields(landscape.tendons, "tendons")),
        **dict(_fields(tuple(each.ideal for each in landscape.hinges), "ideal_hinges")),
        "wing.veins": landscape.fold_path.turns,
        **{f"{name}_torque": torque for name, torque in landscape.least_torques.items()},
    }


def _kept_name(name: str) -> str:
    # a name is a part of its digest, so a field that is called otherwise since keeps its old name here
    name = re.sub(r"^fold_path\.", "wing.", name)
    return re.sub(r"^(partial_folds\.\d+)\.angles$", r"\1.distal_angle", name)


def landscape_summary_of(landscape: EnergyLandscape) -> Numbers:
    """The landscape's summary, but for what names the design."""
    whole = landscape_summary(landscape)
    for part, since in _SINCE.items():
        whole[part] = [{name: value for name, value in each.items() if name not in since} for each in whole[part]]
    return dict(_fields({name: value for name, value in whole.items() if name not in _NOT_NUMBERS}))


# keys of a landscape's lists that are younger than the digests
_SINCE = {
    "tendons": ("tendon", "hinge"),
    "partial_folds": ("independent_energy_J",),
    "rests": ("stored_J", "same_as"),
}


def search_numbers(folder: Path) -> Numbers:
    """The table of the search over 60 tendons: its variables, and its text by column."""
    study = ff.load_study("binder2025-search")
    table = ff.run_study(study, folder)
    assert table is not None
    columns = zip(*csv.reader(io.StringIO(table_csv(study, table))), strict=True)
    return {
        **{f"table.{name}": table[name].values for name in table.variables},
        **{f"csv.{name}": cells for name, *cells in columns},
    }


def map_numbers() -> Numbers:
    """The static map of the 60 tendons by variable."""
    table = static_map(map_study(ff.load_design("binder2025"), TENDONS))
    return {str(name): table[name].values for name in table.variables}


def row_numbers() -> Numbers:
    """Rows of sparse runs side by side, by design; their keys are hashes and left out."""
    designs = [_design(DESIGNS[name]) for name in ROWS]
    names = {row_key(design): name for design, name in zip(designs, ROWS, strict=True)}
    numbers: Numbers = {}
    for row in evaluate(designs):
        numbers |= {f"{names[row['key']]}.{name}": value for name, value in row.items() if name != "key"}
    return numbers


def convergence_numbers() -> Numbers:
    """Two timesteps and two meshes beside a design's own."""
    design = _design({"tendon.rest_length": "8 cm", "protocol.rest_speed": "10 deg/s"})
    found = {
        "timestep": converge(design, "protocol.timestep", [2e-4, 1e-4, 5e-5]),
        "mesh": converge(design, "membrane.rows", [1, 2]),
    }
    numbers: Numbers = {}
    for key, result in found.items():
        numbers |= {f"{key}.{name}": value for name, value in _fields(result)}
        for transition in ("fold", "unfold"):
            numbers[f"{key}.{transition}_times"] = result.transition_times[transition]
            numbers[f"{key}.{transition}_starts"] = result.starts[transition]
            numbers |= dict(_fields(result.orders[transition], f"{key}.{transition}_order"))
    return numbers


def pattern_numbers(name: str) -> Numbers:
    """The crease pattern of a design."""
    return dict(_fields(ff.earwig_pattern(_design(DESIGNS[name]).fan)))


def _design(settings: Mapping[str, object]) -> Design:
    return ff.load_design("binder2025", settings)


def run_numbers(name: str) -> Numbers:
    """Everything that a run leaves and what is made of it."""
    record = ff.run(_design(DESIGNS[name]), confirm=False)
    return {
        **{f"record.{name}": array for name, array in record_series(record).items()},
        **{f"stages.{name}": value for name, value in stage_numbers(record).items()},
        **{f"measure.{name}": value for name, value in measured_numbers(record).items()},
        **{f"summary.{name}": value for name, value in summary_of(record).items()},
        "timestep": record.design.protocol.timestep,
    }


def survey_numbers(name: str) -> Numbers:
    """Everything that a landscape tells."""
    landscape = ff.energy_landscape(_design(LANDSCAPES[name]))
    return {
        **{f"landscape.{name}": value for name, value in landscape_numbers(landscape).items()},
        **{f"summary.{name}": value for name, value in landscape_summary_of(landscape).items()},
    }


def _search() -> Numbers:
    with tempfile.TemporaryDirectory() as folder:
        return search_numbers(Path(folder))


# The cases.

CASES: dict[str, Callable[[], Numbers]] = {
    **{f"run/{name}": partial(run_numbers, name) for name in DESIGNS},
    **{f"landscape/{name}": partial(survey_numbers, name) for name in LANDSCAPES},
    **{f"pattern/{name}": partial(pattern_numbers, name) for name in PATTERNS},
    "rows": row_numbers,
    "convergence": convergence_numbers,
    "static-map-60-tendons": map_numbers,
    "search-60-tendons": _search,
}
# some seconds altogether
FEW = (
    "run/one-unit",
    "run/two-units-maxwell",
    "landscape/one-unit",
    "pattern/five-units-all",
)


def digests(case: str) -> dict[str, str]:
    """Digests of a case by quantity."""
    return {name: digest(name, value) for name, value in CASES[case]().items()}


def differences(kept: Mapping[str, str], found: Mapping[str, str]) -> list[str]:
    """Quantities that are not as kept, with why; what is new is none of them."""
    return [
        f"{name}: {'differs' if name in found else 'is not there'}"
        for name, value in kept.items()
        if found.get(name) != value
    ]


def digest(name: str, value: object) -> str:
    """Digest of an array with its shape and type, or of plain data as JSON, whose floats have all their digits."""
    content = hashlib.sha256(name.encode())
    if isinstance(value, np.ndarray) and value.dtype != object and value.dtype.kind not in "UST":
        content.update(f"{value.shape} {value.dtype.str}".encode())
        content.update(np.ascontiguousarray(value).tobytes())
    else:
        content.update(json.dumps(value, sort_keys=True, default=_plain).encode())
    return content.hexdigest()[:_LETTERS]


def _plain(value: object) -> object:
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, enum.Enum):
        return value.value
    raise TypeError(f"no digest of {type(value).__name__}")


def _fields(value: object, name: str = "") -> Iterator[tuple[str, object]]:
    """Every number of a data class or a table, and of those in it, by dotted name; none of a design."""
    if isinstance(value, Design):
        return
    inner: Mapping[str, object] | None = value if isinstance(value, Mapping) and value else None
    if dataclasses.is_dataclass(value):
        inner = {field.name: getattr(value, field.name) for field in dataclasses.fields(value)}
        if isinstance(value, HingeLandscape):
            inner["fold_time"] = value.fold_time  # for whoever asks
    if inner is not None:
        for key, each in inner.items():
            yield from _fields(each, f"{name}.{key}" if name else key)
    elif isinstance(value, tuple) and any(dataclasses.is_dataclass(each) for each in value):
        yield f"{name}.count", len(value)
        for number, each in enumerate(value):
            yield from _fields(each, f"{name}.{number}")
    elif isinstance(value, tuple) and any(isinstance(each, np.ndarray) for each in value):
        for number, each in enumerate(value):
            yield f"{name}.{number}", each
    else:
        yield name, value


# What uses none of our code.

_PENDULUM = """
<mujoco>
  <option timestep="2e-4" integrator="Euler" tolerance="1e-12" jacobian="dense"><flag energy="enable"/></option>
  <default><geom contype="0" conaffinity="0" density="1270"/></default>
  <worldbody>
    <body name="a"><joint axis="0 1 0" damping="1e-3" armature="1e-5" range="-40 90" limited="true"/>
      <joint axis="1 0 0" damping="1e-3" armature="1e-5"/>
      <geom type="cylinder" size=".0025" fromto="0 0 0 .12 0 0"/><site name="p" pos=".065 0 0"/>
      <body name="b" pos=".12 0 0"><joint name="fold" axis=".05 .99 0" damping="1e-3" armature="1e-5" range="-3 170"
        limited="true"/>
        <geom type="cylinder" size=".0025" fromto="0 0 0 .1 .01 0"/><site name="d" pos=".055 .0055 0"/></body></body>
    <body name="c" pos="0 .04 0"><joint axis="1 1 0" damping="1e-3" armature="1e-5"/>
      <geom type="cylinder" size=".0025" fromto="0 0 0 .12 .01 0"/></body>
  </worldbody>
  <deformable>
    <flex name="sheet" dim="2" radius="5e-5" body="a c a c b" element="0 1 3 0 3 2 2 3 4"
      vertex=".04 0 0  .04 .003 0  .12 0 0  .12 .01 0  .05 .005 0">
      <contact contype="0" conaffinity="0" selfcollide="none"/>
      <elasticity young="1e6" poisson="0.3" damping="1e-3" thickness="1e-4" elastic2d="stretch"/></flex>
  </deformable>
  <tendon>
    <spatial stiffness="1000" damping=".1" springlength="0 .09"><site site="p"/><site site="d"/></spatial>
  </tendon>
  <actuator><general joint="fold"/></actuator>
</mujoco>
"""


def canary() -> dict[str, str]:
    """Digests of what the engine and the libraries compute here, and their versions."""
    model = mujoco.MjModel.from_xml_string(_PENDULUM)
    data = mujoco.MjData(model)
    data.qvel[:] = 0.1
    path = []
    for step in range(1000):
        data.ctrl[:] = 0.5 * (step > 300) - 1.0 * (step > 700)
        mujoco.mj_step(model, data)
        path.append(np.concatenate([data.qpos, data.qvel, data.energy, data.ten_length]))
    assert np.isfinite(path).all()
    random = np.random.default_rng(12)
    values = random.normal(size=(60, 37))
    square = values[:37].T @ values[:37] + np.eye(37)
    positive = np.abs(values) + 0.1
    numbers: Numbers = {
        "engine": np.array(path),
        "elementwise": np.stack(
            [
                *(function(values) for function in (np.sin, np.cos, np.tan, np.exp, np.arctan, np.tanh, np.square)),
                *(function(positive) for function in (np.sqrt, np.log, np.reciprocal)),
                *(function(values, positive) for function in (np.arctan2, np.hypot, np.divide)),
                positive**1.7,
                np.arccos(np.tanh(values)),
                np.degrees(values),
            ]
        ),
        "python": [
            [math.sin(x), math.exp(x), math.hypot(x, 0.3), math.atan2(x, 0.7), abs(x) ** 2.3] for x in values[0]
        ],
        "cumsum": np.cumsum(values, axis=0),
        "sums": np.concatenate([values.sum(axis=0), values.mean(axis=1), [values.sum(), values.std()]]),
        "products": np.concatenate([values @ square, np.einsum("ij,jk,lk->il", values, square, square)], axis=1),
        "small products": np.stack([values[:3, :3] @ values[row : row + 3, 3:6] for row in range(50)]),
        "eigh": np.concatenate([each.ravel() for each in np.linalg.eigh(square)]),
        "stacked eigh": np.linalg.eigh(square[:12, :12] + np.arange(5)[:, None, None] * np.eye(12))[1],
        "solve": np.linalg.solve(square, values[0]),
        "inv": np.linalg.inv(square[:12, :12]),
        "det": np.linalg.det(values[:48].reshape(-1, 4, 4)),
        "lstsq": np.linalg.lstsq(values, values[:, 0] ** 2, rcond=None)[0],
        "norm": np.linalg.norm(values, axis=1),
        "interp": np.interp(values, np.sort(values[0]), values[1]),
        "brentq": [brentq(lambda x, y=y: math.cos(x) - y * x, 0, 2) for y in np.abs(values[0]) + 0.5],
        "quad": quad(lambda x: math.exp(-x * x) * math.sin(3 * x), 0, 2)[0],
        "least_squares": least_squares(lambda x: np.exp(x) - values[0, :3] ** 2 - 0.1, np.zeros(3)).x,
        "rotation": Rotation.from_rotvec(values[:, :3]).as_matrix(),
    }
    versions = {f"version of {name}": importlib.metadata.version(name) for name in ("mujoco", "numpy", "scipy")}
    return {**versions, **{name: digest(name, value) for name, value in numbers.items()}}


def kept_digests(path: Path = KEPT) -> dict[str, dict[str, str]]:
    """The digests that were kept, by case and quantity."""
    kept: dict[str, dict[str, str]] = json.loads(path.read_text("utf-8"))
    return kept


def main() -> int:
    """Compute, and compare or keep."""
    parser = argparse.ArgumentParser(description="Digests of the numbers of today, compared with those that were kept.")
    parser.add_argument("--write", action="store_true", help="keep them instead")
    parser.add_argument("--only", metavar="NAME", default="", help="the case of this name, or those that begin so")
    parser.add_argument("--kept", metavar="PATH", type=Path, default=KEPT, help="file with those that were kept")
    arguments = parser.parse_args()
    chosen = [case for case in CASES if case == arguments.only] or [
        case for case in CASES if case.startswith(arguments.only)
    ]
    if not chosen:
        parser.error(f"no case of that name; there are {', '.join(CASES)}")
    if not arguments.write and not arguments.kept.exists():
        parser.error(f"{arguments.kept}: no such file")
    kept = kept_digests(arguments.kept) if arguments.kept.exists() else {}
    here = canary()
    other = differences(kept.get("canary", {}), here)
    if other:
        print("the canary differs, so last bits may:", "; ".join(other))
    if arguments.write and arguments.only and other:
        parser.error("the kept digests come from other libraries or another processor: write all of them or none")
    found, failed = {"canary": here}, False
    for case in chosen:
        start = time.perf_counter()
        found[case] = digests(case)
        told = differences(kept.get(case, {}), found[case])
        failed |= bool(told) or case not in kept
        print(
            f"{case}: {len(found[case])} quantities, {len(found[case].keys() - kept.get(case, {}).keys())} new,"
            f" {len(told)} differ, {time.perf_counter() - start:.1f} s",
            flush=True,
        )
        for line in told:
            print(f"    {line}", flush=True)
    if arguments.write:
        whole = {**kept, **found} if arguments.only else found
        arguments.kept.write_text(json.dumps(whole, indent=1) + "\n", "utf-8")
        print(f"written to {arguments.kept.name}")
        return 0
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
