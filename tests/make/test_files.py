"""Files of parts, as independent programs read them."""

import csv
import io
import json
import os
import subprocess
import sys
from dataclasses import replace
from itertools import combinations

import lib3mf
import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

import forficula as ff
from forficula.make.checks.check import Check
from forficula.make.checks.check_parts import mesh_checks
from forficula.make.files.bill import bill_json, bill_of
from forficula.make.files.print_orientation import file_names, open_edges, print_mesh, printed_pieces
from forficula.make.files.printing import print_files
from forficula.make.files.three_mf import BED, GAP, places_on_bed
from forficula.make.solid.mesh import Mesh
from forficula.serial import plain
from forficula.show.folder.parts_folder import write_parts
from forficula.show.style import figure_files
from tests.make.one_figure import write_with_one_figure
from tests.make.readers import (
    faults_of_stl,
    faults_of_three_mf,
    meshes_of,
    pieces_of,
    read_three_mf,
    with_a_flipped_triangle,
)

CHECK = Check(name="stop", part="fold0", ok=True, value=np.pi, limit=float("nan"), unit="rad", text="it holds")
# tolerance for values that are rounded to 0.1 um
ROUNDED = 1e-4
# writes the joint to a given path
WRITE = """\
import sys
from pathlib import Path
from forficula.make.make_parts import make_parts
from tests.make.one_figure import write_with_one_figure
write_with_one_figure(make_parts("binder2025-joint"), Path(sys.argv[1]))
"""


@pytest.fixture(scope="module")
def joint():
    return ff.make.parts("binder2025-joint")


@pytest.fixture(scope="module")
def folder(joint, tmp_path_factory):
    folder = tmp_path_factory.mktemp("parts")
    write_with_one_figure(joint, folder)
    return folder


@pytest.fixture(scope="module")
def in_place(joint_of):
    return joint_of(**{"make.hinge": "print-in-place", "make.straps": 1})


def sheet_alone(parts):
    return replace(parts, parts=(), joints=(), straps=())


def contents(folder):
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*.*")}


@pytest.mark.parametrize("made", ["joint", "made_section", "in_place"])
def test_every_mesh_of_every_file_is_closed_and_oriented(made, request):
    files = print_files(request.getfixturevalue(made))
    assert faults_of_three_mf(files["parts.3mf"]) == []
    stl = {name: faults_of_stl(content) for name, content in files.items() if name.endswith(".stl")}
    assert len(stl) >= 2
    assert {name: faults for name, faults in stl.items() if faults} == {}


def test_a_flipped_triangle_is_found_in_either_file(folder):
    files = contents(folder)
    assert faults_of_three_mf(with_a_flipped_triangle(files["parts.3mf"])) == [
        "proximal0, petg is not manifold and oriented"
    ]
    assert "is not of one winding" in faults_of_stl(with_a_flipped_triangle(files["stl/distal0.stl"]))


def test_objects_are_named_by_part_and_material_and_have_it_in_mm(joint, folder):
    model, _ = read_three_mf(contents(folder)["parts.3mf"])
    assert model.GetUnit() == lib3mf.ModelUnit.MilliMeter
    assert [mesh.GetName() for mesh in meshes_of(model)] == ["proximal0, petg", "distal0, petg", "strap0, tpu-82a"]
    materials = []
    for mesh in meshes_of(model):
        resource, property_id, has = mesh.GetObjectLevelProperty()
        assert has
        materials.append(model.GetBaseMaterialGroupByID(resource).GetName(property_id))
    assert materials == ["petg", "petg", "tpu-82a"]
    # the pin is bought
    assert [part.name for part in joint.parts if not part.printed] == ["pin_fold0"]


def test_pieces_lie_on_the_bed_beside_one_another(joint, folder):
    model, _ = read_three_mf(contents(folder)["parts.3mf"])
    pieces = list(pieces_of(model))
    assert [name for name, _ in pieces].count("strap0, tpu-82a") == 2
    volumes = {part.name: part.volume * 1e9 for part in joint.parts}
    for name, triangles in pieces:
        assert triangles.min(axis=(0, 1))[2] == 0
        volume = np.einsum("ti,ti->", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])) / 6
        assert volume == pytest.approx(volumes[name.partition(",")[0]], rel=ROUNDED)
    boxes = [(item.min(axis=(0, 1))[:2], item.max(axis=(0, 1))[:2]) for _, item in pieces]
    for (low, high), (least, most) in combinations(boxes, 2):
        assert (low >= most + GAP - 1e-3).any() or (least >= high + GAP - 1e-3).any()


def test_a_bar_is_printed_on_its_flat(joint, folder):
    by_name = {part.name: part for part in joint.parts}
    for name in ("proximal0", "distal0"):
        mesh = trimesh.load(io.BytesIO(contents(folder)[f"stl/{name}.stl"]), file_type="stl")
        assert mesh.volume == pytest.approx(by_name[name].volume * 1e9, rel=ROUNDED)
        assert mesh.bounds[0] == pytest.approx(0, abs=1e-6)
        bottom = mesh.triangles[:, :, 2].max(axis=1) == 0
        # along x, as wide as a flat 45 deg up a bar of 5.5 mm
        flat = 5.5 * np.sqrt(0.5)
        assert mesh.area_faces[bottom].sum() > 0.9 * flat * 100
        assert np.ptp(mesh.triangles[bottom].reshape(-1, 3), axis=0)[0] > 100


@given(st.lists(st.tuples(st.floats(1, 300), st.floats(1, 100)), max_size=12))
def test_boxes_on_a_bed_keep_apart_and_stay_on_it(sizes):
    places = places_on_bed(sizes)
    corners = [(place, place + np.array(size)) for place, size in zip(places, sizes, strict=True)]
    for (low, high), (least, most) in combinations(corners, 2):
        assert (low >= most + GAP - 1e-9).any() or (least >= high + GAP - 1e-9).any()
    assert all((low >= 0).all() and high[0] <= max(BED, *(size[0] for size in sizes)) for low, high in corners)


def test_the_same_design_is_the_same_bytes_in_another_process(folder, tmp_path):
    environment = os.environ | {"PYTHONHASHSEED": "7"}
    subprocess.run([sys.executable, "-c", WRITE, str(tmp_path / "again")], check=True, env=environment)
    assert contents(tmp_path / "again") == contents(folder)


def test_a_bill_has_masses_from_densities_with_sources(joint, folder):
    bill = json.loads((folder / "bill.json").read_text())
    rows = {row["part"]: row for row in bill["parts"]}
    assert {name: row["comes"] for name, row in rows.items()} == {
        **{"proximal0": "printed", "distal0": "printed", "pin_fold0": "bought", "strap0": "printed", "sheet": "cut"}
    }
    assert rows["strap0"]["count"] == 2
    # a pin of 2 mm in a hinge 10 mm wide, steel
    assert rows["pin_fold0"]["size_mm"] == pytest.approx([10, 2, 2], abs=0.01)
    assert rows["pin_fold0"]["mass_g"] == pytest.approx(7.9 * np.pi / 4 * 0.2**2, rel=1e-5)
    petg = next(item for item in bill["totals"] if item["material"] == "petg")
    assert petg["mass_g"] == pytest.approx(sum(1270e3 * part.volume for part in joint.parts[:2]), rel=1e-5)
    assert petg["density_source"] == "data sheets"
    assert bill["files"] == sorted(name for name in contents(folder) if name != "bill.json")
    table = list(csv.DictReader(io.StringIO((folder / "bill.csv").read_text())))
    assert [row["part"] for row in table] == list(rows)
    assert float(table[0]["mass_g"]) == rows["proximal0"]["mass_g"]
    # part for which the design names no material
    assert (table[-1]["part"], table[-1]["material"], table[-1]["mass_g"]) == ("sheet", "", "")


def test_a_mass_without_a_density_is_unknown(joint):
    bare = tuple(replace(part, stock=replace(part.stock, density=None)) for part in joint.parts[1:2])
    bill = bill_json(bill_of(replace(joint, parts=(joint.parts[0], *bare, *joint.parts[2:]))))
    assert [row["mass_g"] is None for row in bill["parts"]][:2] == [False, True]
    assert None in [total["mass_g"] for total in bill["totals"]]


def test_checks_have_their_unit_behind_their_keys():
    assert plain([CHECK]) == [
        {"name": "stop", "part": "fold0", "ok": True, "value_deg": 180.0, "limit_deg": None, "text": "it holds"}
    ]
    assert {"value_N_m", "limit_N_m"} < set(plain(replace(CHECK, unit="N m")))


@pytest.mark.usefixtures("undrawn")
def test_earlier_parts_are_removed_and_other_files_stay(joint, tmp_path):
    write_parts(joint, (), tmp_path)
    (tmp_path / "stl" / "mine.stl").write_text("mine")
    write_parts(sheet_alone(joint), (CHECK,), tmp_path)
    lists = {"bill.csv", "bill.json", "checks.json", "design.toml", "parts.html"}
    assert set(contents(tmp_path)) == {*lists, *figure_files("sheet"), "sheet.dxf", "sheet.svg", "stl/mine.stl"}
    assert json.loads((tmp_path / "checks.json").read_text())[0]["text"] == "it holds"


def test_a_folder_is_written_whole_or_not_at_all(joint, tmp_path):
    (tmp_path / "sheet.dxf").mkdir()
    with pytest.raises(ff.InputError, match=r"sheet\.dxf: need a file or nothing there, got a folder"):
        write_parts(sheet_alone(joint), (), tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["sheet.dxf"]


def test_a_foreign_bill_removes_nothing_outside_its_folder(joint, tmp_path):
    (tmp_path / "kept.stl").write_text("kept")
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "bill.json").write_text('{"files": ["../kept.stl", "stl/..", 3, "/etc", "design.toml"]}')
    write_parts(sheet_alone(joint), (), tmp_path / "parts")
    assert (tmp_path / "kept.stl").read_text() == "kept"


def test_names_of_files_are_plain_and_differ():
    assert file_names(["strap0", "Strap0", "a/b", "a b", ""]) == ["strap0", "Strap0-2", "a_b", "a_b-2", "part"]


def test_an_open_surface_is_detected(joint, monkeypatch):
    strap = joint.parts[3]
    mesh = print_mesh(strap)
    flipped = Mesh(points=mesh.points, triangles=np.vstack([mesh.triangles[:-1], mesh.triangles[-1:, ::-1]]))
    assert open_edges(mesh) == 0
    assert open_edges(flipped) > 0
    assert open_edges(Mesh(points=mesh.points, triangles=mesh.triangles[:-1])) == 3
    alone = replace(joint, parts=(strap,), joints=())
    assert [(check.name, check.ok) for check in mesh_checks(alone)] == [("closed surface", True)]
    monkeypatch.setattr("forficula.make.checks.check_parts.print_mesh", lambda _: flipped)
    assert [check.ok for check in mesh_checks(alone)] == [False]


def test_halves_printed_in_place_are_one_piece_and_fuse_if_too_close(joint_of, in_place):
    content = print_files(in_place)["stl/proximal0_and_distal0.stl"]
    assert trimesh.load(io.BytesIO(content), file_type="stl").body_count == 2
    result = {}
    for overbend in ("3 deg", "12 deg"):
        made = joint_of(**{"make.hinge": "print-in-place", "make.straps": 1, "hinge.overbend": overbend})
        assert [piece.name for piece in printed_pieces(made)] == ["proximal0 and distal0", "strap0"]
        (result[overbend],) = (check for check in mesh_checks(made) if check.name == "apart as printed")
    assert (result["3 deg"].ok, result["12 deg"].ok) == (False, True)
    # faces outside of the clearance around the knuckles, 3 deg apart
    assert result["3 deg"].value == pytest.approx(3.4e-3 * np.sin(np.radians(3)), rel=0.05)
    assert "they fuse" in result["3 deg"].text
