"""Results of goals for one joint, from real runs, fast enough for tests."""

from dataclasses import dataclass

import numpy as np
import xarray
from scipy.stats import qmc

from forficula.design import key_value, with_values
from forficula.goals.assessor import open_assessor
from forficula.goals.deviation import deviating_values, read_deviations
from forficula.goals.goal_file import goal_of
from forficula.goals.optimise.optimise import optimise_goal
from forficula.goals.optimise.optimum import candidates_to_keep
from forficula.quantities import parse_quantity
from forficula.show.page.goal_page import write_goal_page
from forficula.show.page.identify_page import write_identify_page
from forficula.show.page.parts.rich_html import PrintedResult
from forficula.show.page.tolerance_page import VerdictGrid, write_tolerance_page
from forficula.structure import structure_of
from forficula.study.running.kept_runs import RunToKeep, kept_runs
from forficula.study.tables.outcome_kinds import transitions_text

SETTINGS = {
    "stops": {"time_constant": "2 ms"},
    "protocol": {
        "timestep": "0.4 ms",
        "sample_interval": "2 ms",
        "stages": {"snap": {"time_limit": "0.5 s"}, "release opened": {"time_limit": "0.5 s"}},
    },
}
VARY = {
    "tendon.rest_length": {"low": "5.5 cm", "high": "7 cm"},
    "tendon.area": {"low": "3 mm^2", "high": "8 mm^2"},
    "pattern.sense": ["valley", "mountain"],
}
TABLES = {
    "name": "a-joint-that-holds",
    "source": "a question of ours",
    "design": "binder2025-joint",
    "settings": SETTINGS,
    "vary": VARY,
    "limits": {"hinge_holding_torque": ">= 5 N cm", "probability": ">= 90 %"},
    "objectives": {"mass": "least", "hinge_holding_torque": "largest"},
    "tolerances": {"tendon.rest_length": "2 %", "tendon.area": "2 %"},
    "search": {"neighbours": 8, "batch": 8, "runs": 16},
}
GOAL_KINDS = ("optimise", "tolerance", "identify")
CSV = "sample,margin\n1,0.5\n"
OFF = {
    "tendon.rest_length": "5 %",
    "tendon.area": "10 %",
    "tendon.distal_offset": "10 %",
    "hinge.overbend": {"distribution": "normal", "size": "0.2 deg"},
}


@dataclass(frozen=True, kw_only=True)
class Tried:
    """A question, its result, and the kept runs."""

    subject: object
    table: xarray.Dataset
    kept: list


def tried_goal(folder, tables=TABLES):
    """The best designs of a goal, and the runs of some."""
    result = optimise_goal(goal_of(tables), folder)
    runs = candidates_to_keep(result, 4)
    return Tried(subject=result, table=result.table, kept=list(kept_runs(runs, folder)))


def tried_tolerance(folder, count=32):
    """A joint built many times, with invented sensitivity indices."""
    design = goal_of(TABLES).base
    deviations = read_deviations(OFF, design)
    shares = qmc.Sobol(len(deviations), rng=np.random.default_rng(3)).random(count)
    offsets = np.array([deviation.offsets(column) for deviation, column in zip(deviations, shares.T, strict=True)]).T
    points = [deviating_values(design, deviations, row) for row in offsets]
    designs = [with_values(design, values) for values in points]
    with open_assessor(folder, design) as assess:
        rows = assess(designs, ["run"], points=points)
    works = [row["verdict"] == "reached" for row in rows]
    margin = [min(row["fold_margin"], row["unfold_margin"]) for row in rows]
    coordinates = {
        deviation.key.replace(".", "_"): _column("sample", _factor(deviation.key, design), points)
        for deviation in deviations
    }
    answers = np.where(works, "works", "fails").astype(object)
    samples = {"answer": ("sample", answers), "margin": (("result", "sample"), [margin])}
    samples |= {name: ("sample", *values[1:]) for name, values in coordinates.items()}
    samples["outcome"] = _words("sample", rows)["outcome"]
    table = xarray.Dataset(samples | _made_up(deviations, works), {"result": ["margin"], "fact": ["works"]})
    table.attrs["transitions"] = transitions_text(structure_of(design), None)
    tells = [works.index(True), works.index(False)]
    return Tried(subject=(design, deviations), table=table, kept=_kept(tells, designs, folder))


def _made_up(deviations, works):
    """Invented indices and distances to failures, in the shape of `tolerance_table`."""
    keys = [deviation.key for deviation in deviations]
    first = np.array([0.6, 0.25, 0.02])
    off = {"first_index": 0.0, "first_index_low": -0.08, "first_index_high": 0.1}
    off |= {"total_index": 0.12, "total_index_low": 0.03, "total_index_high": 0.25}
    nan = np.nan
    return {
        "factor": keys,
        "group": [*keys[:2], "the others"],
        **{name: (("result", "group"), [first + item]) for name, item in off.items()},
        "fails_down": ("factor", [0.4, nan, 1.6, nan]),
        "fails_up": ("factor", [nan, 0.7, 2.4, nan]),
        "works_down": ("factor", [0.3, 3.0, 1.5, 3.0]),
        "works_up": ("factor", [3.0, 0.6, 2.3, 3.0]),
        "probability": ("fact", [np.mean(works)]),
        "probability_low": ("fact", [np.mean(works) - 0.1]),
        "probability_high": ("fact", [min(np.mean(works) + 0.1, 1.0)]),
        "works": ("fact", [sum(works)]),
        "fails": ("fact", [len(works) - sum(works)]),
    }


def made_up_cells(design, deviations):
    """An invented map over the first two values."""
    first, second = deviations[:2]
    ends = np.linspace(-1.5, 1.5, 9)
    across, upwards = (
        key_value(design, item.key) + ends * item.width(key_value(design, item.key)) for item in (first, second)
    )
    works = ends[None] - ends[:, None] < 1.2
    return VerdictGrid(first=first.key, second=second.key, across=across, upwards=upwards, works=works)


def write_pages_of_goals(folder):
    """Write a page of each kind into a folder of its own; returns the results and the page's path, by kind."""
    paths = {kind: folder / kind / "report.html" for kind in GOAL_KINDS}
    for path in paths.values():
        path.parent.mkdir(parents=True)
    result = PrintedResult(heading="a question: made up", tables=(), sentences=("made up for a test",))
    tried = tried_goal(paths["optimise"].parent)
    write_goal_page(tried.subject, result, paths["optimise"], tried.kept, len(tried.kept))
    off = tried_tolerance(paths["tolerance"].parent)
    design, deviations = off.subject
    cells = made_up_cells(design, deviations)
    write_tolerance_page(design, deviations, off.table, result, paths["tolerance"], off.kept, len(off.kept), CSV, cells)
    seen = Tried(subject=None, table=tried_identification(off.table), kept=[])
    write_identify_page(seen.table, result, paths["identify"])
    return {kind: (item, paths[kind]) for kind, item in zip(GOAL_KINDS, (tried, off, seen), strict=True)}


def tried_identification(table):
    """Facts derived from the runs of a tolerance analysis, in the shape of an identification."""
    names = [str(name) for name in table.data_vars if "key" in table[name].attrs]
    facts = ["it works", "stiff", "slack", "never"]
    rest, area = table["tendon_rest_length"].values, table["tendon_area"].values
    works = table["answer"].values == "works"
    far = np.array(
        [
            1.0 - works,
            np.clip(np.median(area) - area, 0, None) / area,
            np.clip(rest - 0.999 * np.median(rest), 0, None) + np.clip(area - 0.999 * np.median(area), 0, None),
            np.ones(len(rest)),
        ]
    ).T
    met = far == 0
    count = met.sum(axis=1)
    words = np.full((4, 4), "met together", dtype=object)
    words[3], words[:, 3], words[1, 2], words[2, 1] = *["one is never met"] * 2, *["exclude one another"] * 2
    share = met.mean(axis=0)
    return xarray.Dataset(
        {
            "distance": (("sample", "fact"), far),
            "scaled_distance": (("sample", "fact"), 3 * far),
            "met": (("sample", "fact"), met),
            "agrees": ("sample", count >= 2),
            "directed": ("sample", np.arange(len(rest)) > len(rest) - 6),
            "status": ("sample", np.full(len(rest), "ran", dtype=object)),
            "fact_units": ("fact", np.array(["", "m^2", "m", ""], dtype=object)),
            "fact_source": ("fact", np.array(["made up for a test"] * 4, dtype=object)),
            "met_share": ("fact", share),
            "met_share_low": ("fact", np.clip(share - 0.1, 0, 1)),
            "met_share_high": ("fact", np.clip(share + 0.1, 0, 1)),
            "together": (("fact", "other_fact"), words),
        },
        {**{name: table[name].variable for name in names}, "fact": facts, "other_fact": facts},
        {
            "name": "a-joint-that-was-seen",
            "source": "a question of ours",
            "design": "binder2025-joint",
            "design_hash": "0123456789abcdef",
            "unknowns": names,
            "drawn": len(rest) - 5,
            "placed": 5,
            "runs": len(rest),
            "seed": 0,
        },
    )


def _factor(key, design):
    from forficula.study.factors import Factor

    return Factor(key=key, model=type(design))


def _column(dimension, factor, points):
    values = [point[factor.key] for point in points]
    attributes = {"key": factor.key, "long_name": factor.key}
    if factor.unit is None:
        return dimension, np.array(values, dtype=object), attributes
    attributes |= {"units": factor.unit.si, "display": factor.unit.display}
    return dimension, [parse_quantity(value, factor.unit) for value in values], attributes


def _words(dimension, rows):
    names = ("status", "outcome", "verdict")
    return {name: (dimension, np.array([str(row[name]) for row in rows], dtype=object)) for name in names}


def _kept(points, designs, folder):
    runs = [
        RunToKeep(point=int(point), part="run", name=f"{point + 1:02d}", design=designs[point])
        for point in dict.fromkeys(points)
    ]
    return list(kept_runs(runs, folder))


if __name__ == "__main__":
    import sys
    from pathlib import Path

    write_pages_of_goals(Path(sys.argv[1]))
