"""Exported runs, read back by other programs' libraries, hold the record's positions, angles, strains and numbers."""

import csv
import json
import os
import shutil
import subprocess
import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
import trimesh
from scipy.spatial import KDTree
from scipy.spatial.transform import Rotation

import forficula as ff
from forficula.analysis.strength import membrane_peaks
from forficula.dynamics import save_record
from forficula.show.export.gltf import linear_colour, morph_targets
from forficula.show.export.scene import ball, cylinder, frame_times, rod_directions, sampled, turned
from tests.show.plates import plates_run

WEB = Path(__file__).parents[3] / "web"
Y_UP = Rotation.from_euler("x", -90, degrees=True).as_matrix()
RUNS = ("letter", "wing", "kresling", "plates")
VALIDATE = """
const validator = require("gltf-validator"), read = require("fs").readFileSync;
validator.validateBytes(new Uint8Array(read(process.argv[1]))).then((report) => console.log(JSON.stringify(report)));
"""


@pytest.fixture
def run_of(request):
    """A record by its name in RUNS."""

    def record(name):
        if name == "plates":
            return plates_run()[0]
        return request.getfixturevalue({"wing": "reference_run"}.get(name, f"{name}_run"))

    return record


def points_of(record):
    """Points of bars, plates and facets, and nodes of membranes on them, m, (time, point, 3)."""
    return np.concatenate([record.series["point_position"], record.series["membrane_position"]], axis=1)


def drawn_points(record):
    """Corners and ends of the drawn parts, m, (time, point, 3)."""
    built = record.structure
    parts = (*built.bars, *built.plates, *built.facets, *built.tendons)
    return record.series["point_position"][:, sorted({point for part in parts for point in part.points})]


def rows_at(record, times):
    # files hold times as 4-byte floats
    rows = np.abs(record.time[:, np.newaxis] - times).argmin(axis=0)
    np.testing.assert_allclose(record.time[rows], times, rtol=0, atol=1e-6)
    return rows


class Animation:
    """A .glb file as pygltflib reads it, moved by the rules of the specification."""

    def __init__(self, path):
        self.gltf = pytest.importorskip("pygltflib").GLTF2().load(str(path))
        self.blob = self.gltf.binary_blob()
        channels = self.gltf.animations[0].channels if self.gltf.animations else []
        samplers = self.gltf.animations[0].samplers if self.gltf.animations else []
        self.moving = {
            (channel.target.node, channel.target.path): self.array(samplers[channel.sampler].output)
            for channel in channels
        }
        self.time = self.array(samplers[0].input) if samplers else np.zeros(1)

    def array(self, number):
        accessor = self.gltf.accessors[number]
        view = self.gltf.bufferViews[accessor.bufferView]
        kind = {5126: "<f4", 5123: "<u2", 5125: "<u4"}[accessor.componentType]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor.type]
        start = view.byteOffset + (accessor.byteOffset or 0)
        values = np.frombuffer(self.blob, kind, accessor.count * width, start)
        return values.astype(float if kind == "<f4" else int).reshape(-1, width) if width > 1 else values.astype(float)

    def value(self, number, path, frame, default):
        if (number, path) in self.moving:
            return self.moving[number, path][frame]
        still = getattr(self.gltf.nodes[number], path)
        return np.array(still if still is not None else default, dtype=float)

    def placed(self, number, local, frame):
        """Points of a node in the axes of its parent."""
        scaled = local * self.value(number, "scale", frame, [1, 1, 1])
        turn = Rotation.from_quat(self.value(number, "rotation", frame, [0, 0, 0, 1]))
        return turn.apply(scaled) + self.value(number, "translation", frame, [0, 0, 0])

    def local(self, number, frame):
        """Vertices of a node's mesh, with its morph targets."""
        vertices = []
        for primitive in self.gltf.meshes[self.gltf.nodes[number].mesh].primitives:
            places = self.array(primitive.attributes.POSITION)
            if primitive.targets:
                count = len(primitive.targets)
                weights = self.moving[number, "weights"].reshape(-1, count)[frame]
                for weight, target in zip(weights, primitive.targets, strict=True):
                    key = target["POSITION"] if isinstance(target, dict) else target.POSITION
                    places = places + weight * self.array(key)
            vertices.append(places)
        return np.concatenate(vertices)

    def vertices(self, frame):
        """All vertices of a frame in the axes of the file."""
        root = self.gltf.scenes[0].nodes[0]
        inner = [
            self.placed(child, self.local(child, frame), frame)
            for child in self.gltf.nodes[root].children
            if self.gltf.nodes[child].mesh is not None
        ]
        return self.placed(root, np.concatenate(inner), frame)

    def rod(self, number, frame):
        root = self.gltf.scenes[0].nodes[0]
        return self.placed(root, self.placed(number, np.array([[0.0, 0, 0], [0, 1, 0]]), frame), frame)

    def named(self, beginning):
        return [number for number, node in enumerate(self.gltf.nodes) if (node.name or "").startswith(beginning)]


@pytest.mark.parametrize("name", RUNS)
def test_every_frame_of_an_animation_has_the_corners_and_tendons_of_the_record(run_of, tmp_path, name):
    record = run_of(name)
    ff.export(record, tmp_path / "run.glb")
    animation = Animation(tmp_path / "run.glb")
    rows, span = rows_at(record, animation.time + record.time[0]), record.structure.span
    assert len(rows) > 2
    tendons = np.array([tendon.points for tendon in record.structure.tendons], dtype=int).reshape(-1, 2)
    for frame in np.linspace(0, len(rows) - 1, 7).astype(int):
        ends = record.series["point_position"][rows[frame]][tendons] @ Y_UP.T
        rods, bars = (
            np.array([animation.rod(number, frame) for number in animation.named(kind)]).reshape(-1, 2, 3)
            for kind in ("tendon", "bar")
        )
        np.testing.assert_allclose(rods, ends, rtol=0, atol=1e-6 * span)
        places = np.concatenate([animation.vertices(frame), *rods, *bars])
        away, _ = KDTree(places).query(drawn_points(record)[rows[frame]] @ Y_UP.T)
        assert away.max() <= 1e-6 * span


def test_the_membrane_of_an_animation_follows_the_nodes_of_the_record(reference_run, tmp_path):
    ff.export(reference_run, tmp_path / "run.glb")
    animation = Animation(tmp_path / "run.glb")
    rows = rows_at(reference_run, animation.time)
    (sheet,) = animation.named("sheet")
    faces = {node for triangle in reference_run.triangles.tolist() for node in triangle}
    for frame in (0, len(rows) // 3, len(rows) // 2, len(rows) - 1):
        nodes = reference_run.series["membrane_position"][rows[frame]][sorted(faces)]
        away, _ = KDTree(animation.local(sheet, frame)).query(nodes)
        assert away.max() <= 1e-6 * reference_run.structure.span


def test_an_animation_lasts_as_long_as_the_run_and_is_linear_between_its_frames(reference_run, tmp_path):
    ff.export(reference_run, tmp_path / "run.glb")
    time = Animation(tmp_path / "run.glb").time
    assert time[0] == 0
    assert time[-1] == pytest.approx(reference_run.time[-1] - reference_run.time[0], rel=1e-6)
    assert (np.diff(time) > 0).all()
    kept = frame_times(reference_run)
    points, every = points_of(reference_run), reference_run.time
    flat = points.reshape(len(points), -1)
    drawn = np.stack(
        [np.interp(every, kept, sampled_column(reference_run, kept, column)) for column in range(9)], axis=1
    )
    assert np.abs(drawn - flat[:, :9]).max() <= 1.1e-5 * reference_run.structure.span


def sampled_column(record, times, column):
    return sampled(record, "point_position", times).reshape(len(times), -1)[:, column]


def test_an_animation_has_the_colours_of_the_page(reference_run, tmp_path):
    ff.export(reference_run, tmp_path / "run.glb")
    shades = [
        material.pbrMetallicRoughness.baseColorFactor[:3] for material in Animation(tmp_path / "run.glb").gltf.materials
    ]
    # panels, mountain, valley and joints, as in web/src
    for colour in ("#E2CF9F", "#D55E00", "#0072B2", "#23272b"):
        assert min(np.abs(np.array(shade) - linear_colour(colour)).max() for shade in shades) < 1e-6, colour


@pytest.mark.parametrize("name", RUNS)
def test_trimesh_reads_the_first_frame_of_an_animation(run_of, tmp_path, name):
    record = run_of(name)
    ff.export(record, tmp_path / "run.glb")
    ff.export(record, tmp_path / "start.obj", at=float(frame_times(record)[0]))
    moved, still = (trimesh.load_scene(tmp_path / name) for name in ("run.glb", "start.obj"))
    np.testing.assert_allclose(moved.bounds, still.bounds, rtol=0, atol=2e-6 * record.structure.span)


@pytest.mark.parametrize("name", RUNS)
def test_the_validator_of_khronos_finds_nothing_in_an_animation(run_of, tmp_path, name):
    node = shutil.which("node")
    if node is None:
        pytest.skip("needs node")
    ff.export(run_of(name), tmp_path / "run.glb")
    command = [node, "-e", VALIDATE, str(tmp_path / "run.glb")]
    called = subprocess.run(command, cwd=WEB, capture_output=True, check=False)
    if b"Cannot find module" in called.stderr:
        pytest.skip("needs the npm package gltf-validator in web/")
    issues = json.loads(called.stdout)["issues"]
    assert (issues["numErrors"], issues["numWarnings"]) == (0, 0), issues


@pytest.mark.parametrize("name", RUNS)
def test_an_object_has_the_corners_of_the_moment_and_colours(run_of, tmp_path, name):
    record = run_of(name)
    row = len(record.time) // 2
    ff.export(record, tmp_path / "moment.obj", at=float(record.time[row]))
    read = trimesh.load_scene(tmp_path / "moment.obj")
    places = np.concatenate([mesh.vertices for mesh in read.geometry.values()])
    span = record.structure.span
    if record.structure.plates or record.structure.facets:
        parts = (*record.structure.plates, *record.structure.facets)
        corners = record.series["point_position"][row][sorted({point for part in parts for point in part.points})]
        away, _ = KDTree(places).query(corners @ Y_UP.T)
        assert away.max() <= 1e-6 * span
    assert {tuple(mesh.visual.material.diffuse[:3]) for mesh in read.geometry.values()} >= {(226, 207, 159)}
    assert "map_Kd" not in (tmp_path / "moment.mtl").read_text()


@pytest.mark.parametrize("share", [0.0, 0.3, 0.6, 1.0])
@pytest.mark.parametrize("name", RUNS)
def test_a_solid_is_closed_at_any_moment(run_of, tmp_path, name, share):
    record = run_of(name)
    ff.export(record, tmp_path / "solid.stl", at=float(record.time[0] + share * np.ptp(record.time)))
    read = trimesh.load(tmp_path / "solid.stl")
    assert read.is_watertight
    assert read.volume > 0


@pytest.mark.parametrize("share", [0.0, 0.25, 0.5, 0.75, 1.0])
def test_a_solid_is_closed_where_panels_touch(snap_run, tmp_path, share):
    ff.export(snap_run, tmp_path / "solid.stl", at=float(share * snap_run.time[-1]))
    assert trimesh.load(tmp_path / "solid.stl").is_watertight


def test_a_solid_is_in_millimetres_and_has_the_volume_of_its_panels(letter_run, tmp_path):
    ff.export(letter_run, tmp_path / "solid.stl", at=0.0)
    solid, built = trimesh.load(tmp_path / "solid.stl"), letter_run.structure
    points = letter_run.series["point_position"][0]
    areas = [
        np.linalg.norm(sum(np.cross(points[one], points[other]) for one, other in pairwise([*ends, ends[0]]))) / 2
        for ends in (plate.points for plate in built.plates)
    ]
    volume = sum(area * plate.thickness for area, plate in zip(areas, built.plates, strict=True))
    assert solid.volume == pytest.approx(1e9 * volume, rel=3e-3)


def vtk_frames(path):
    meshio = pytest.importorskip("meshio")
    sets = ElementTree.parse(path).getroot().findall("Collection/DataSet")
    return [(float(entry.get("timestep")), meshio.read(path.parent / entry.get("file"))) for entry in sets]


def test_a_series_for_paraview_has_points_energies_and_strains_of_the_record(reference_run, tmp_path):
    pytest.importorskip("meshio")
    ff.export(reference_run, tmp_path / "run.pvd")
    frames, built = vtk_frames(tmp_path / "run.pvd"), reference_run.structure
    law, triangles = built.membranes[0].law, reference_run.triangles
    rest = np.concatenate([membrane.built for membrane in built.membranes])[triangles]
    areas = np.linalg.norm(np.cross(rest[:, 1] - rest[:, 0], rest[:, 2] - rest[:, 0]), axis=1) / 2
    largest = 0.0
    for (time, mesh), row in zip(frames, rows_at(reference_run, np.array([time for time, _ in frames])), strict=True):
        np.testing.assert_allclose(mesh.points, points_of(reference_run)[row], rtol=0, atol=1e-12)
        data = {
            name: dict(zip((block.type for block in mesh.cells), values, strict=True))
            for name, values in mesh.cell_data.items()
        }
        density = data["energy density (J/m^3)"]["triangle"][: len(triangles)]
        energy = law.thickness * np.sum(areas * density)
        assert energy == pytest.approx(reference_run.series["membrane_energy"][row], rel=1e-6, abs=1e-12), time
        tendons = data["line energy (J)"]["line"][data["part"]["line"] == 4]
        np.testing.assert_allclose(tendons, reference_run.series["tendon_energy"][row], rtol=1e-12)
        largest = max(largest, data["largest principal strain"]["triangle"][: len(triangles)].max())
    assert largest > 0
    assert all(
        time == pytest.approx(reference_run.time[row])
        for (time, _), row in zip(frames, rows_at(reference_run, np.array([t for t, _ in frames])), strict=True)
    )


def test_the_largest_strain_and_stress_in_paraview_are_those_of_the_summary(reference_run, tmp_path):
    pytest.importorskip("meshio")
    peaks = membrane_peaks(reference_run)
    strained = max(peaks, key=lambda peak: abs(peak.strain))
    stressed = max(peaks, key=lambda peak: abs(peak.stress))
    for time, name, expected in (
        (strained.time, "largest principal strain", strained.strain),
        (stressed.stressed_at, "largest principal stress (Pa)", stressed.stress),
    ):
        ff.export(reference_run, tmp_path / "peak.pvd", at=time)
        ((_, mesh),) = vtk_frames(tmp_path / "peak.pvd")
        assert np.nanmax(mesh.cell_data[name][0]) == pytest.approx(expected, rel=1e-9)


def test_a_shorter_series_replaces_a_longer_one(letter_run, tmp_path):
    pytest.importorskip("meshio")
    ff.export(letter_run, tmp_path / "run.pvd")
    ff.export(letter_run, tmp_path / "run.pvd", at=0.01)
    assert [file.name for file in (tmp_path / "run").iterdir()] == ["0000.vtu"]


@pytest.mark.parametrize("name", ["letter", "kresling"])
def test_fold_frames_have_positions_and_hinge_angles_of_the_record(run_of, tmp_path, name):
    record = run_of(name)
    ff.export(record, tmp_path / "run.fold")
    read = json.loads((tmp_path / "run.fold").read_text())
    times = np.array([float(frame["frame_title"].removesuffix(" s")) for frame in read["file_frames"]])
    rows, count = rows_at(record, times), 0
    for frame, row in zip(read["file_frames"], rows, strict=True):
        for number, hinge in enumerate(record.structure.hinges):
            if hinge.edge < 0:
                continue
            angle = frame["edges_foldAngle"][hinge.edge]
            assert angle == pytest.approx(np.degrees(hinge.sense * record.series["hinge_angle"][row, number]), abs=1e-9)
            count += 1
        away, _ = KDTree(record.series["point_position"][row]).query(frame["vertices_coords"])
        assert away.max() <= 1e-9 * record.structure.span
    assert count
    assert len(ff.pattern.read_folded_frames(tmp_path / "run.fold")) == len(rows)


@pytest.mark.parametrize("name", ["letter", "kresling"])
def test_fold_angles_of_hinges_agree_with_positions(run_of, tmp_path, name):
    record = run_of(name)
    ff.export(record, tmp_path / "run.fold")
    read = json.loads((tmp_path / "run.fold").read_text())
    for frame in read["file_frames"][:: max(len(read["file_frames"]) // 10, 1)]:
        places, normals = np.array(frame["vertices_coords"]), {}
        for face in read["faces_vertices"]:
            area = np.cross(places[face], np.roll(places[face], -1, axis=0)).sum(axis=0)
            normals |= {ends: area / np.linalg.norm(area) for ends in pairwise([*face, face[0]])}
        for (tail, head), angle in zip(read["edges_vertices"], frame["edges_foldAngle"], strict=True):
            if (tail, head) in normals and (head, tail) in normals:
                cosine = normals[tail, head] @ normals[head, tail]
                assert cosine == pytest.approx(np.cos(np.radians(angle)), abs=2e-3)


def test_fold_frames_of_the_wing_have_the_angles_of_its_ring_fold(reference_run, tmp_path):
    row = int(np.abs(reference_run.angles("ring")).mean(axis=1).argmax())
    ff.export(reference_run, tmp_path / "wing.fold", at=float(reference_run.time[row]))
    read = json.loads((tmp_path / "wing.fold").read_text())
    (frame,) = read["file_frames"]
    roles = read["forficula:edges_role"]
    angles = [angle for angle, role in zip(frame["edges_foldAngle"], roles, strict=True) if role == "ring"]
    assert len(angles) == 2
    # a panel between two veins folds by about the mean of their hinges
    expected = np.degrees(np.abs(reference_run.angles("ring")[row])).mean()
    assert np.abs(angles).mean() == pytest.approx(expected, abs=3)


def test_a_table_has_all_series_and_measures_with_units(letter_run, tmp_path):
    ff.export(letter_run, tmp_path / "run.csv")
    with (tmp_path / "run.csv").open(newline="") as file:
        header, *rows = csv.reader(file)
    table = dict(zip(header, np.array(rows, dtype=float).T, strict=True))
    assert all(name.endswith(")") for name in header)
    np.testing.assert_array_equal(table["time (s)"], letter_run.time)
    np.testing.assert_array_equal(table["hinge_angle[crease0] (rad)"], letter_run.series["hinge_angle"][:, 0])
    np.testing.assert_array_equal(table["tendon_energy[left] (J)"], letter_run.series["tendon_energy"][:, 0])
    np.testing.assert_array_equal(table["measure mouth (m)"], letter_run.measured("mouth")[:, 0])


@pytest.mark.parametrize("name", RUNS)
def test_the_library_of_usd_reads_the_moving_faces(run_of, tmp_path, name):
    usd, geometry = (pytest.importorskip(f"pxr.{module}") for module in ("Usd", "UsdGeom"))
    record = run_of(name)
    ff.export(record, tmp_path / "run.usda")
    stage = usd.Stage.Open(str(tmp_path / "run.usda"))
    assert geometry.GetStageMetersPerUnit(stage) == 1
    assert geometry.GetStageUpAxis(stage) == "Z"
    duration = (stage.GetEndTimeCode() - stage.GetStartTimeCode()) / stage.GetTimeCodesPerSecond()
    assert duration == pytest.approx(np.ptp(frame_times(record)), rel=1e-6)
    drawn = [prim for prim in stage.Traverse() if prim.HasAttribute("points")]
    codes = sorted({code for prim in drawn for code in prim.GetAttribute("points").GetTimeSamples()})
    rows = rows_at(record, record.time[0] + np.array(codes) / 1000)
    for code, row in [(codes[place], rows[place]) for place in (0, len(rows) // 2, -1)]:
        places = np.concatenate([np.array(prim.GetAttribute("points").Get(code)) for prim in drawn])
        away, _ = KDTree(places).query(drawn_points(record)[row])
        assert away.max() <= 1e-6 * record.structure.span


@pytest.mark.parametrize("ending", ["glb", "usda", "fold"])
def test_a_moment_is_a_file_of_one_frame(letter_run, tmp_path, ending):
    ff.export(letter_run, tmp_path / f"moment.{ending}", at=0.01)
    content = (tmp_path / f"moment.{ending}").read_bytes()
    assert b"animations" not in content
    assert b"timeSamples" not in content
    assert content.count(b"foldedForm") == (ending == "fold")


@pytest.mark.parametrize(
    ("path", "options", "message"),
    [
        ("a.glb", {"to": "gtlf"}, r'^to: need "gltf", .*got "gtlf"; did you mean "gltf"\?$'),
        ("a.gtlf", {}, r"^need a file that ends with \.glb, .* got .*a\.gtlf; did you mean \.glb\?$"),
        ("a.obj", {"to": "stl"}, r"^need a file that ends with \.stl for stl, got .*a\.obj$"),
        ("a.glb", {"at": 1e3}, r"^at: need a time within the run, 0 s to .* got 1000 s$"),
        ("a.obj", {"at": -1.0}, r"^at: need a time within the run"),
        ("a.obj", {"at": float("nan")}, r"^at: need a time within the run"),
        ("a.csv", {"at": 0.1}, r"^at: need none for csv"),
    ],
)
def test_what_cannot_be_exported_is_refused(letter_run, tmp_path, path, options, message):
    with pytest.raises(ff.InputError, match=message):
        ff.export(letter_run, tmp_path / path, **options)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("ending", ["glb", "pvd", "usda", "fold"])
def test_a_run_that_never_moved_has_no_motion_to_export(letter_run, tmp_path, ending):
    still = {name: np.repeat(values[:1], len(values), axis=0) for name, values in letter_run.series.items()}
    with pytest.raises(ff.InputError, match="the structure never moved, so there is no motion"):
        ff.export(replace(letter_run, series=still), tmp_path / f"a.{ending}")
    assert not list(tmp_path.iterdir())
    ff.export(replace(letter_run, series=still), tmp_path / "a.obj")


@pytest.mark.parametrize("ending", ["glb", "obj", "stl", "pvd", "usda", "fold", "csv"])
def test_a_file_that_cannot_be_written_leaves_nothing_behind(letter_run, tmp_path, ending):
    if ending == "pvd":
        pytest.importorskip("meshio")
    (tmp_path / "file").write_text("")
    with pytest.raises(ff.InputError, match="cannot be written"):
        ff.export(letter_run, tmp_path / "file" / f"a.{ending}")
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_a_diverged_run_is_exported_up_to_its_divergence(letter_run, tmp_path):
    series = {name: values.copy() for name, values in letter_run.series.items()}
    half = len(letter_run.time) // 2
    for name in ("hinge_angle", "point_position"):
        series[name][half:] = np.nan
    diverged = replace(letter_run, series=series, diverged_at=float(letter_run.time[half]))
    ff.export(diverged, tmp_path / "run.glb")
    assert Animation(tmp_path / "run.glb").time[-1] == pytest.approx(letter_run.time[half - 1], rel=1e-6)
    ff.export(diverged, tmp_path / "end.obj")
    ff.export(diverged, tmp_path / "end.stl")
    assert np.isfinite(trimesh.load_scene(tmp_path / "end.obj").bounds).all()
    with pytest.raises(ff.InputError, match=r"^at: need a time before the run diverged"):
        ff.export(diverged, tmp_path / "late.obj", at=float(letter_run.time[-1]))


def test_a_structure_without_a_sheet_has_no_fold_file(tmp_path):
    record = ff.run("binder2025-joint", confirm=False)
    with pytest.raises(ff.InputError, match="need a crease pattern or a sheet for a FOLD file"):
        ff.export(record, tmp_path / "joint.fold")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("module", "ending"), [("trimesh", "obj"), ("trimesh", "stl"), ("meshio", "pvd")])
def test_a_missing_library_is_named_with_how_to_install_it(letter_run, tmp_path, monkeypatch, module, ending):
    monkeypatch.setitem(__import__("sys").modules, module, None)
    with pytest.raises(ff.InputError, match=rf'needs? {module}: pip install "forficula\[export\]"$'):
        ff.export(letter_run, tmp_path / f"a.{ending}")
    assert not list(tmp_path.iterdir())


def test_rods_turn_without_twist_also_through_the_opposite_direction():
    angles = np.linspace(0, 2 * np.pi, 9)
    lines = np.stack([np.sin(angles), np.cos(angles), np.zeros(9)], axis=1)[:, np.newaxis]
    lines = np.concatenate([lines, -lines[-1:]])
    turns = rod_directions(lines, np.array([0.0, 1, 0]))
    np.testing.assert_allclose(turned(turns, np.array([0.0, 1, 0])), lines, atol=1e-12)
    np.testing.assert_allclose(
        turned(turns[:-1], np.array([0.0, 0, 1])), np.broadcast_to([0, 0, 1], lines[:-1].shape), atol=1e-12
    )
    assert (np.sum(turns[1:] * turns[:-1], axis=-1) >= 0).all()


def test_cylinders_and_balls_are_closed_and_face_outwards():
    places, _, triangles = cylinder(12)
    assert trimesh.Trimesh(places, triangles).volume == pytest.approx(6 * np.sin(np.pi / 6), rel=1e-9)
    solid = trimesh.Trimesh(*ball())
    assert solid.is_watertight
    assert 0.8 * 4 / 3 * np.pi < solid.volume < 4 / 3 * np.pi


def test_few_morph_targets_give_all_shapes():
    rng = np.random.default_rng(1)
    parts, shares = rng.normal(size=(3, 20, 3)), rng.normal(size=(50, 3))
    places = rng.normal(size=(20, 3)) + np.einsum("ft,tvx->fvx", shares, parts)
    weights, targets = morph_targets(places, 1e-9)
    assert len(targets) == 3
    assert np.abs(weights).max() <= 1
    np.testing.assert_allclose(weights[0], 0, atol=1e-12)
    np.testing.assert_allclose(places[0] + np.einsum("ft,tvx->fvx", weights, targets), places, atol=1e-9)


def test_the_command_writes_into_the_folder_of_the_run(letter_run, tmp_path, capsys):
    from forficula.cli import main

    ff.save(ff.Run(letter_run), tmp_path / "run")
    main(["export", str(tmp_path / "run"), "--to", "gltf"])
    assert (tmp_path / "run" / "motion.glb").is_file()
    main(["export", str(tmp_path / "run"), "--at", "10 ms", "--out", str(tmp_path / "a.stl")])
    assert (tmp_path / "a.stl").is_file()
    for options, message in (
        (["--to", "blend"], 'forficula: --to: need "gltf"'),
        ([], "forficula: --to: need a format"),
        (["--out", "a.blend"], "forficula: --out: need a file that ends with"),
        (["--to", "obj", "--at", "1 h"], "forficula: --at: need a time within the run"),
    ):
        with pytest.raises(SystemExit) as ended:
            main(["export", str(tmp_path / "run"), *options])
        assert ended.value.code == 1
        assert capsys.readouterr().err.startswith(message)


# exports over an older export, and is killed at every third change on the disk
DIES = """
import itertools, json, os, shutil, signal, sys
from pathlib import Path
import forficula as ff
from forficula.files import clear_leftovers
from forficula.show.export import export_times, write_export
CHANGES = {"os.rename", "os.remove", "os.mkdir", "os.rmdir", "open"}
def content(folder):
    return {str(file.relative_to(folder)): file.read_bytes().hex() for file in folder.rglob("*") if file.is_file()}
def main(saved, root, ending, to):
    record = ff.load_run(saved).record
    path, times = root / f"motion.{ending}", export_times(record, to, None)
    old, new = (times[-1:], times[-1:] / 2) if len(times) == 1 else (times[:3], times[:2])
    def write(rows):
        write_export(record, path, to, rows)
    write(new)
    after = content(root)
    shutil.rmtree(root)
    for number in itertools.count(1, 3):
        root.mkdir(parents=True)
        write(old)
        before = content(root)
        child = os.fork()
        if not child:
            left = [number]
            def count(event, arguments):
                if event in CHANGES and str(root) in str(arguments[0]):
                    left[0] -= 1
                    if not left[0]:
                        os.kill(os.getpid(), signal.SIGKILL)
            sys.addaudithook(count)
            write(new)
            os._exit(0)
        _, status = os.waitpid(child, 0)
        clear_leftovers(root)
        left = content(root)
        print(json.dumps("old" if left == before else "new" if left == after else sorted(left)), flush=True)
        shutil.rmtree(root)
        if status == 0:
            return
for ending, to in (("glb", "gltf"), ("pvd", "vtk")):
    main(Path(sys.argv[1]), Path(sys.argv[2]) / to, ending, to)
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_an_export_that_was_killed_leaves_the_old_files_or_the_new_ones(letter_run, tmp_path):
    save_record(letter_run, tmp_path / "record.nc")
    done = subprocess.run(
        [sys.executable, "-c", DIES, tmp_path / "record.nc", tmp_path / "out"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    left = [json.loads(line) for line in done.stdout.splitlines()]
    assert left[-1] == "new"
    assert "old" in left
    assert set(left) == {"old", "new"}
