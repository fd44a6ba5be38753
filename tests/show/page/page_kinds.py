"""Pages of every kind, from results that are quick to compute, for requirements on all pages."""

import io
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace

import pytest
from PIL import Image

from forficula.analysis import measure
from forficula.design import with_values
from forficula.make.checks.strength_checks import strength_checks
from forficula.make.make_parts import make_parts
from forficula.show.folder.convergence_folder import write_convergence
from forficula.show.folder.cycling_folder import write_cycling
from forficula.show.folder.landscape_folder import write_landscape
from forficula.show.folder.material_folder import write_material
from forficula.show.folder.static_map_folder import write_static_map
from forficula.show.page import write_run_page
from forficula.show.page.compare_page import ComparedRun, compare_page
from forficula.show.page.parts_page import write_parts_page
from forficula.show.page.study_page import write_study_page
from forficula.show.style import COPIES
from forficula.structure import structure_of
from forficula.study import load_study
from forficula.study.convergence.convergence import converge
from forficula.study.convergence.refinement import TIMESTEP
from forficula.study.cycling import CycleRun, Cycling, driven_transitions
from forficula.study.running.kept_runs import KeptRun
from tests.show.page.goal_results import GOAL_KINDS
from tests.show.study.test_maps import many_ends, sampled

# the first group moves and has a script, the next two kinds have none; those of goals have one
MOVING = ("run", "compare", "landscape", "curves", "study", "drawn study", "parts")
_WRITTEN = (*MOVING, "converge", "material")
KINDS = (*_WRITTEN, *GOAL_KINDS)
_FOLDERS = ("convergence", "cycling", "landscape", "material", "static_map")
_GRID = (
    '"tendon.stiffness" = ["10 N/cm", "20 N/cm", "30 N/cm"]\n"tendon.rest_length" = ["0 cm", "3 cm", "6 cm", "9 cm"]'
)
_DRAWN = (
    '"tendon.stiffness" = {distribution = "uniform", low = "10 N/cm", high = "30 N/cm"}\n'
    '"tendon.rest_length" = {distribution = "uniform", low = "0 cm", high = "9 cm"}'
)
_ASK = 'ask = "least-torques"'
_SETTLE = {"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.02}


def write_pages(folder, run, slow_run, landscape, material, write_study_file):
    """Write a page of each of `KINDS`, except those of goals, into a folder; returns their paths.

    Figures are left out of them, which take most of the time: each is a dot with its text.

    Args:
        folder: folder for the pages.
        run: run of the reference; the page of this run also has cycles.
        slow_run: run to compare with `run`.
        landscape: landscape of the reference.
        material: characterised.
        write_study_file: the fixture of that name.
    """

    def grid(path):
        return load_study(write_study_file(path.with_name("grid.toml"), _GRID, _ASK))

    writers: dict[str, Callable[..., None]] = {
        "run": lambda path: _run_with_cycles(run, path),
        "compare": lambda path: path.write_text(_compared(run, slow_run), "utf-8"),
        "landscape": lambda path: _landscape_with_map(landscape, run, grid(path), path),
        "curves": lambda path: write_landscape(landscape, path.parent),
        "study": lambda path: _study(grid(path), run, slow_run, path),
        "drawn study": lambda path: _drawn_study(write_study_file, path),
        "converge": lambda path: _convergence(run, path),
        "material": lambda path: write_material(material, path.parent),
        "parts": _parts,
    }
    paths = {kind: folder / kind / "report.html" for kind in _WRITTEN}
    with _dots_for_figures():
        for kind, path in paths.items():
            path.parent.mkdir()
            writers[kind](path)
    return paths


@contextmanager
def _dots_for_figures() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        for name in _FOLDERS:
            patch.setattr(f"forficula.show.folder.{name}_folder.save_figures", _save_dots)
        yield


def _save_dots(drawings, folder, _=()):
    (folder / COPIES).mkdir(exist_ok=True)
    dot = io.BytesIO()
    Image.new("RGB", (4, 3), "white").save(dot, "PNG")
    for stem in drawings:
        (folder / f"{stem}.png").write_bytes(dot.getvalue())
        svg = '<svg xmlns="http://www.w3.org/2000/svg" width="4" height="3"/>'
        (folder / COPIES / f"{stem}.svg").write_text(svg, "utf-8")
    return {stem: f"The figure {stem}." for stem in drawings}


def _run_with_cycles(run, path):
    write_run_page(run, measure(run), path)
    write_cycling(_cycling(run.design), path.parent)


def _cycling(design):
    """Return two cycles; the second fails and is extrapolated."""
    worked = {"status": "folded and opened", "folded": True, "opened": True, "flat_energy_J": 0.5}
    worked |= {"folded_energy_J": 0.0, "opened_energy_J": 0.5, "fold_time_s": 0.05, "fold_work_J": 1.0}
    worked |= {"unfold_time_s": 0.01, "unfold_work_J": 2.0}
    runs = [
        CycleRun(
            cycle=cycle,
            measured=cycle == 1,
            stiffness=(1 / cycle, 0.9 / cycle, 1.1 / cycle),
            residual_strain=0.01,
            row=worked | row,
            margins={"fold": 70.0, "unfold": 4.0},
        )
        for cycle, row in ((1, {}), (2, {"status": "stuck at -80.0 deg", "folded": False, "opened": False}))
    ]
    return Cycling(
        design=design,
        runs=tuple(runs),
        seen=(1, 1),
        transitions=driven_transitions(structure_of(design)),
        verdict="up to cycle 1",
        remarks=("made up",),
    )


def _compared(run, slow_run):
    named = {"quick": run, "slow": slow_run}
    return compare_page([ComparedRun(label=label, record=item, outcome=measure(item)) for label, item in named.items()])


def _landscape_with_map(landscape, run, study, path):
    write_landscape(landscape, path.parent, run)
    write_static_map(study, many_ends(), path.parent)


def _study(study, run, slow_run, path):
    """A page of a planted table; two of its points can be played."""
    kept = [
        KeptRun(point=point, part=part, folder=f"runs/{point + 1}-{part}", record=item, outcome=measure(item))
        for point, part, item in ((0, "folding", run), (0, "opening", slow_run), (1, "folding", slow_run))
    ]
    write_study_page(study, many_ends(), path, kept, len(kept))


def _drawn_study(write_study_file, path):
    head = f"{_ASK}\n[sampling]\ncount = 12\n"
    file = write_study_file(path.with_name("drawn.toml"), _DRAWN, head)
    write_study_page(load_study(file), sampled(many_ends()), path, (), 0)


def _parts(path):
    """A page of one joint, with a check that holds, one that fails and one that is not made."""
    parts = make_parts("binder2025-joint")
    checks = [check for check in strength_checks(parts) if check.name in ("bending of the pegs", "straps tear")]
    write_parts_page(parts, [*checks, replace(checks[0], ok=False)], path)


def _convergence(run, path):
    settling = with_values(run.design, {"protocol.stages": [_SETTLE]})
    study = converge(settling, TIMESTEP, [4e-4, 2e-4])
    wide = tuple(f"{statuse}, which is wider than a phone" for statuse in study.statuses)
    write_convergence(replace(study, statuses=wide), path.parent)
