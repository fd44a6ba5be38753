"""Figures drawn again from a folder are the same byte for byte, and errors are reported in one line."""

from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design, save_design, with_values
from forficula.dynamics import save_record
from forficula.errors import InputError
from forficula.files import write_bytes, write_text
from forficula.serial import json_text
from forficula.show.folder import landscape_folder
from forficula.show.folder.assumptions_folder import assumptions_drawings
from forficula.show.folder.convergence_folder import convergence_drawings
from forficula.show.folder.cycling_folder import cycling_drawings, cycling_summary, read_cycling
from forficula.show.folder.landscape_folder import landscape_drawings, write_landscape
from forficula.show.folder.presentation import folder_drawings, write_figure
from forficula.show.folder.run_folder import run_drawings
from forficula.show.folder.static_map_folder import static_map_drawings
from forficula.show.study.maps import map_drawings
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH, figure_files, save_figure
from forficula.structure import structure_of
from forficula.study.assumptions.assumptions_file import save_assumptions
from forficula.study.convergence.convergence import converge
from forficula.study.convergence.convergence_file import load_convergence, save_convergence
from forficula.study.convergence.refinement import TIMESTEP
from forficula.study.cycling import Cycling, driven_transitions
from forficula.study.tables.static_map import map_study, static_map
from tests.assumptions import ASSUMED
from tests.show.folder.test_cycling_folder import STUCK
from tests.show.folder.test_cycling_folder import run as cycle
from tests.show.study.test_maps import TWO, planted

STAGES = [
    {"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.1},
    {"name": "fold", "drive": "fold", "until": "folded", "hold": 0.0, "time_limit": 0.2},
]


@pytest.fixture(scope="module")
def cycling(reference):
    runs = (cycle(1), cycle(2, fold_time_s=None), cycle(3, **STUCK))
    driven = driven_transitions(structure_of(reference))
    return Cycling(
        design=reference, runs=runs, seen=(2, 4), transitions=driven, verdict="Up to cycle 2.", remarks=("Seen.",)
    )


@pytest.fixture(scope="module")
def convergence(reference):
    return converge(with_values(reference, {"protocol.stages": STAGES}), TIMESTEP, [4e-4, 3e-4])


@pytest.fixture(scope="module")
def folders(tmp_path_factory, reference, reference_run, cycling, convergence):
    """A folder of every kind of results, with the files from which its figures are drawn."""
    place = tmp_path_factory.mktemp("out")
    save_record(reference_run, place / "run" / "record.nc")
    for name in ("run", "landscape"):
        save_design(reference, place / name / "design.toml")
    write_text(place / "run" / "cycles.json", json_text(cycling_summary(cycling)))
    write_text(place / "landscape" / "landscape.json", '{"simulation": null, "figures": ["tendon", "wing", "levels"]}')
    save_convergence(convergence, place / "converge" / "convergence.nc")
    save_assumptions(ASSUMED, place / "assumptions" / "assumptions.json")
    for name, table in (("study/table.nc", planted(TWO)), ("landscape/map.nc", slow_maps(reference))):
        write_bytes(place / name, table.to_netcdf(engine="h5netcdf"))
    write_text(place / "material" / "material.json", "{}")
    for name in (*figure_files("fit"), *figure_files("cycles")):
        write_text(place / "material" / name, name)
    return place


def slow_maps(design):
    return static_map(map_study(design, {"tendon.stiffness": "10..20 N/cm step 10"}))


KINDS = {
    "run": ["angles", "cycles", "energy", "folding", "mechanisms", "package", "pattern", "strain"],
    "landscape": ["levels", "map", "tendon", "wing"],
    "converge": ["angles", "times"],
    "assumptions": ["assumptions"],
    "study": ["energy", "fold_times", "status", "torques", "works"],
}


@pytest.mark.parametrize("name", KINDS)
def test_a_folder_offers_the_figures_of_its_results(folders, name):
    assert sorted(folder_drawings(folders / name)) == KINDS[name]


@pytest.mark.usefixtures("undrawn")
@pytest.mark.parametrize(("tendons", "kinds"), [(True, ["levels", "rests", "tendon"]), (False, ["rests"])])
def test_a_landscape_without_a_unique_fold_offers_the_figure_of_equilibria(tmp_path, surveyed, tendons, kinds):
    write_landscape(surveyed("plates" if tendons else "plates without tendons"), tmp_path / "out")
    assert sorted(folder_drawings(tmp_path / "out")) == kinds


def test_a_table_that_does_not_name_its_transitions_is_refused(tmp_path):
    old = planted(TWO)
    del old.attrs["transitions"]
    write_bytes(tmp_path / "table.nc", old.to_netcdf(engine="h5netcdf"))
    with pytest.raises(InputError, match=r"table\.nc: written by an earlier forficula; run `forficula study …` again$"):
        write_figure(tmp_path, "energy", tmp_path / "energy.svg")


def assert_drawn_again(folder, drawings, kind, path):
    """Check that figures drawn from a folder equal those drawn from the data that were written to it."""
    write_figure(folder, kind, path / "again.svg")
    save_figure(drawings[kind](COLUMN_WIDTH), path / "first.svg")
    assert (path / "again.svg").read_bytes() == (path / "first.svg").read_bytes()


@pytest.mark.parametrize("kind", ["pattern", "angles", "energy", "folding", "package"])
def test_the_figures_of_a_run_are_drawn_again(folders, tmp_path, reference_run, reference_outcome, kind):
    assert_drawn_again(folders / "run", run_drawings(reference_run, reference_outcome), kind, tmp_path)


def test_the_figures_of_cycles_of_a_study_and_of_maps_are_drawn_again(folders, tmp_path, cycling, reference):
    assert_drawn_again(folders / "run", cycling_drawings(cycling), "cycles", tmp_path)
    assert_drawn_again(folders / "study", map_drawings(planted(TWO)), "torques", tmp_path)
    assert_drawn_again(folders / "landscape", static_map_drawings(slow_maps(reference)), "map", tmp_path)


@pytest.mark.parametrize(
    ("simulation", "kind", "runs"), [("{}", "tendon", True), ("{}", "wing", False), ("null", "tendon", False)]
)
def test_a_landscape_is_surveyed_again_with_its_run_where_its_figure_shows_one(
    tmp_path, reference, reference_run, surveyed, monkeypatch, simulation, kind, runs
):
    requested = []

    def survey(design, *, simulation):
        requested.append((design.hash, simulation))
        return surveyed("reference"), reference_run if simulation else None

    monkeypatch.setattr(landscape_folder, "landscape_and_run", survey)
    save_design(reference, tmp_path / "design.toml")
    write_text(tmp_path / "landscape.json", f'{{"simulation": {simulation}, "figures": ["tendon", "wing"]}}')
    drawings = landscape_drawings(surveyed("reference"), reference_run if runs else None)
    assert_drawn_again(tmp_path, drawings, kind, tmp_path)
    assert requested == [(reference.hash, runs)]


def test_the_figures_of_a_convergence_study_are_drawn_again(folders, tmp_path, convergence):
    assert_drawn_again(folders / "converge", convergence_drawings(convergence), "times", tmp_path)
    # curves are kept with seven digits; figures show fewer, but not always the same
    write_figure(folders / "converge", "angles", tmp_path / "again.svg")
    assert (tmp_path / "again.svg").read_text().count("<path") > 20


def test_the_figure_of_assumptions_is_drawn_again(folders, tmp_path):
    assert_drawn_again(folders / "assumptions", assumptions_drawings(ASSUMED), "assumptions", tmp_path)


def test_a_convergence_study_is_read_as_it_was_written(folders, convergence):
    read = load_convergence(folders / "converge" / "convergence.nc")
    assert np.array_equal(read.values, convergence.values)
    for name in ("transition_times", "starts"):
        again, first = getattr(read, name), getattr(convergence, name)
        assert list(again) == list(first) == ["fold", "unfold"]
        for transition, times in first.items():
            assert np.array_equal(again[transition], times, equal_nan=True)
    for name in ("key", "design_value", "rows", "statuses", "orders", "tolerance", "fine", "verdict"):
        assert getattr(read, name) == getattr(convergence, name)
    assert read.design.hash == convergence.design.hash
    for again, curve in zip((*read.times, *read.angles), (*convergence.times, *convergence.angles), strict=True):
        assert again == pytest.approx(curve, rel=1e-6)


def test_cycles_are_read_as_they_were_written(folders, cycling):
    read = read_cycling(folders / "run")
    rows = [replace(run, row={name: run.row.get(name) for name in read.runs[0].row}) for run in cycling.runs]
    assert read.runs == tuple(rows)
    assert [transition.name for transition in read.transitions] == ["fold", "unfold"]
    assert (read.seen, read.verdict, read.remarks) == ((2, 4), "Up to cycle 2.", ("Seen.",))


@pytest.mark.parametrize(("width", "points"), [(COLUMN_WIDTH, "252pt"), (PAGE_WIDTH, "511.2pt"), (None, "252pt")])
def test_a_figure_is_as_wide_as_asked_for(folders, tmp_path, width, points):
    write_figure(folders / "study", "works", tmp_path / "a.svg", width)
    assert f'width="{points}"' in (tmp_path / "a.svg").read_text()


@pytest.mark.parametrize("ending", [".png", ".svg", ".pdf"])
def test_the_figures_of_a_material_are_handed_out_as_they_were_written(folders, tmp_path, ending):
    write_figure(folders / "material", "fit", tmp_path / f"a{ending}")
    kept = folders / "material" / ("fit.png" if ending == ".png" else f"figures/fit{ending}")
    assert (tmp_path / f"a{ending}").read_bytes() == kept.read_bytes()


def test_a_material_holds_no_tests_to_draw_another_width_from(folders, tmp_path):
    with pytest.raises(InputError, match=r"--width: .* without its tests: its \.pdf is as wide as a column"):
        write_figure(folders / "material", "fit", tmp_path / "a.pdf", PAGE_WIDTH)
    with pytest.raises(InputError, match="need one of cycles, fit for"):
        write_figure(folders / "material", "angles", tmp_path / "a.pdf")


def test_an_unknown_figure_is_refused_with_the_nearest_and_all(folders, tmp_path):
    kinds = "angles, cycles, energy, folding, mechanisms, package, pattern, strain"
    rule = f'need one of {kinds} for .*run, got "energies"; did you mean energy?'
    with pytest.raises(InputError, match=rule):
        write_figure(folders / "run", "energies", tmp_path / "a.pdf")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("name", "what"),
    [("nowhere", "got no such folder"), ("file", "got a file"), ("empty", "with one of record.nc, .*table.nc in")],
)
def test_a_folder_that_forficula_did_not_write_is_refused(tmp_path, name, what):
    (tmp_path / "empty").mkdir()
    write_text(tmp_path / "file", "")
    with pytest.raises(InputError, match=f"{name}: need a folder that forficula wrote, {what}"):
        write_figure(tmp_path / name, "energy", tmp_path / "a.pdf")


@pytest.mark.parametrize("name", ["record.nc", "table.nc", "map.nc", "convergence.nc", "landscape.json", "cycles.json"])
def test_a_file_that_cannot_be_read_is_named(tmp_path, name):
    save_design(load_design("binder2025"), tmp_path / "design.toml")
    write_text(tmp_path / name, "[]")
    with pytest.raises(InputError, match=name.replace(".", r"\.")):
        write_figure(tmp_path, "energy", tmp_path / "a.pdf")


def test_cycles_of_another_design_are_refused(folders, tmp_path):
    write_text(tmp_path / "cycles.json", (folders / "run" / "cycles.json").read_text("utf-8"))
    save_design(load_design("binder2025", {"tendon.stiffness": "20 N/cm"}), tmp_path / "design.toml")
    with pytest.raises(InputError, match=r"cycles\.json: of another design than .*design\.toml"):
        read_cycling(tmp_path)


def test_another_ending_is_refused_before_anything_is_read(tmp_path):
    with pytest.raises(InputError, match=r"--out: need a file that ends with \.png, \.svg or \.pdf, got .*a\.eps"):
        write_figure(tmp_path / "nowhere", "energy", tmp_path / "a.eps")
