"""Designs of sheets of every kind: writing, reading, scaling, and refusals of their sections."""

import numpy as np
import pytest

from forficula.design import design_from_text, design_text, load_design, with_values, write_new_design
from forficula.design.files.kinds import KINDS
from forficula.errors import InputError
from forficula.pattern import write_fold
from forficula.structure import structure_of

STAGE = {"name": "wait", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "1 s"}
BARE = {"tendon": [], "support": [], "drive": [], "measure": [], "protocol.stages": [STAGE]}
PATTERNS = {
    "miura-ori": {"columns": 3, "rows": 2, "long_side": "2 cm", "short_side": "1 cm", "acute_angle": "70 deg"},
    "waterbomb": {"side": "3 cm", "columns": 2, "rows": 2},
    "yoshimura": {"columns": 7, "rows": 2, "base": "2 cm", "height": "1 cm", "closed": True},
    "kresling": {"sides": 5, "radius": "3 cm", "height": "4 cm", "twist": "-30 deg", "end_plates": True},
    "pleats": {"panels": 3, "panel_lengths": ["2 cm"], "width": "5 cm", "assignment": "MV"},
    "vertex": {"sectors": ["80 deg", "90 deg", "100 deg"], "lengths": ["3 cm"]},
}


@pytest.mark.parametrize("kind", PATTERNS)
def test_a_sheet_of_every_kind_is_built_and_reads_back_to_the_bit(kind):
    design = load_design("miura-sheet", BARE | {"pattern": {"kind": kind, **PATTERNS[kind]}})
    structure = structure_of(design)
    assert len(structure.bodies) == len(design.sheet.vertices_coords)
    # nothing is strained as built
    assert [hinge.rest_angle for hinge in structure.hinges] == [hinge.start for hinge in structure.hinges]
    again = design_from_text(design_text(design))
    assert (again.hash, again.sheet.vertices_coords.tobytes()) == (design.hash, design.sheet.vertices_coords.tobytes())


def test_the_sectors_of_a_vertex_are_scaled_to_their_sum():
    design = load_design("bistable-clasp", {"pattern.sector_sum": "350 deg"})
    ends = design.sheet.vertices_coords[1:] / np.linalg.norm(design.sheet.vertices_coords[1:], axis=1)[:, None]
    sectors = np.degrees(np.arccos(np.einsum("ij,ij->i", ends, np.roll(ends, -1, axis=0))))
    unscaled = np.degrees(load_design("bistable-clasp").pattern.sectors)
    assert sectors == pytest.approx(unscaled * 350 / unscaled.sum())
    again = design_from_text(design_text(design))
    assert again.hash == design.hash
    with pytest.raises(InputError, match=r"pattern\.sector_sum: need > 0, got 0 deg"):
        load_design("bistable-clasp", {"pattern.sector_sum": "0 deg"})


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "earwig-fan"])
def test_a_new_file_of_every_kind_is_a_design(kind, tmp_path):
    write_fold(load_design("miura-sheet").sheet, tmp_path / "sheet.fold")
    write_new_design(tmp_path / "new.toml", kind)
    design = load_design(tmp_path / "new.toml")
    assert design.pattern.kind == kind
    assert structure_of(design).drives


@pytest.mark.parametrize(
    ("pattern", "message"),
    [
        ({"kind": "miura-ori", "columns": 0}, r"pattern\.columns: need >= 1, got 0"),
        ({"kind": "miura-ori", "acute_angle": "90 deg"}, r"pattern\.acute_angle: need < 90 deg, got 90 deg"),
        ({"kind": "waterbomb", "side": "2 cm", "columns": 3}, r"pattern\.columns: need columns and rows for a sheet"),
        ({"kind": "kresling"} | PATTERNS["kresling"] | {"twist": "170 deg"}, r"pattern\.twist: need > 0 deg and < 108"),
        ({"kind": "vertex", "sectors": ["80 deg"], "lengths": ["1 cm"]}, "need"),
        (
            {"kind": "yoshimura"} | PATTERNS["yoshimura"] | {"fold": "30 deg"},
            r"pattern\.fold: is for an open sheet",
        ),
    ],
)
def test_a_pattern_that_cannot_be_drawn_is_refused(pattern, message):
    with pytest.raises(InputError, match=message):
        load_design("miura-sheet", BARE | {f"pattern.{key}": value for key, value in pattern.items()})


def test_a_base_of_a_waterbomb_has_two_shapes():
    up, down = (load_design("waterbomb-base", {"pattern.apex": apex}).sheet for apex in ("up", "down"))
    assert up.vertices_coords[2, 2] < up.vertices_coords[0, 2]
    assert down.vertices_coords[2, 2] > down.vertices_coords[0, 2]


def test_a_kind_without_a_pattern_is_refused_with_the_missing_key():
    with pytest.raises(InputError, match=r"pattern\.sides: is missing"):
        with_values(load_design("miura-sheet"), {"pattern.kind": "kresling"})
