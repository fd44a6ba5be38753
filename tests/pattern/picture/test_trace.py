import json
import math
from functools import cache

import jsonschema
import numpy as np
import pytest
from PIL import ImageDraw

import forficula as ff
from forficula import InputError
from forficula.cli import main
from forficula.design import design_pattern, load_design
from forficula.pattern import miura_pattern, pleat_pattern, read_fold, strip_pattern, vertex_pattern, waterbomb_base
from forficula.pattern.picture.trace_options import read_corners, read_size
from tests.pattern.picture.drawn_pictures import (
    INKS,
    Distortion,
    compared,
    drawn_page,
    photographed,
    scanned,
)

SMALL = (560, 450)
PATTERNS = {
    "miura": miura_pattern(3, 3, 0.03, 0.025, math.radians(60)),
    "waterbomb": waterbomb_base(0.1),
    "pleats": pleat_pattern([0.03, 0.02, 0.04], 0.07, "MV"),
    "vertex": vertex_pattern([math.radians(angle) for angle in (60, 100, 120, 80)], 0.06, "MMMV"),
    "strip": strip_pattern(0.12, 0.1, math.radians(20), math.radians(20), 0.08, valley=True),
}
BLACK = dict.fromkeys(INKS, (20, 20, 20))


@cache
def photograph(name, **options):
    distortion = Distortion(
        **{"size": SMALL, "blur": 0.8} | {key: options.pop(key) for key in ("blur", "noise") if key in options}
    )
    return photographed(*drawn_page(PATTERNS[name], 600, line=0.005, **options), distortion, seed=3)


@cache
def traced(name, **options):
    picture = photograph(name, **options)
    return ff.trace(picture.pixels, picture.page)


@pytest.mark.parametrize(("name", "dashed"), [(name, False) for name in PATTERNS] + [("miura", True)])
def test_a_photographed_drawing_is_traced_completely(name, dashed):
    trace = traced(name, dashed=dashed) if dashed else traced(name)
    result = compared(PATTERNS[name], photograph(name, dashed=dashed) if dashed else photograph(name), trace)
    assert result.complete, result
    assert result.error < 0.002
    assert trace.corner_source == "sheet"
    assert not trace.is_doubtful


def test_errors_of_vertices_agree_with_their_standard_errors():
    trace, pattern = traced("miura"), PATTERNS["miura"]
    places = photograph("miura").vertices
    order = [
        int(np.argmin(np.linalg.norm(places - [vertex.picture_x, vertex.picture_y], axis=1)))
        for vertex in trace.vertices
    ]
    offset = trace.pattern.vertices_coords[:, :2] - pattern.vertices_coords[order, :2]
    offset -= offset.mean(axis=0)
    error = np.sqrt(np.mean(offset**2))
    expected = np.median([vertex.standard_error for vertex in trace.vertices])
    # the corners of the sheet add an error that all vertices share
    assert 0.2 * expected < error < 10 * expected


def test_dashes_decide_on_black_creases_and_solid_ones_stay_unassigned():
    dashed = photographed(
        *drawn_page(PATTERNS["waterbomb"], 750, dashed=True, inks=BLACK, line=0.005),
        Distortion(size=(700, 560)),
        seed=3,
    )
    trace = ff.trace(dashed.pixels, dashed.page)
    assert compared(PATTERNS["waterbomb"], dashed, trace).complete
    solid = photographed(
        *drawn_page(PATTERNS["waterbomb"], 600, inks=BLACK, line=0.005), Distortion(size=SMALL), seed=3
    )
    trace = ff.trace(solid.pixels, solid.page)
    result = compared(PATTERNS["waterbomb"], solid, trace)
    assert (result.right, result.unassigned, result.wrong) == (8, 8, 0)
    assert {edge.doubt for edge in trace.edges if edge.letter == "U"} == {
        "a solid black line between two faces may be a crease or a cut"
    }


def test_a_colour_between_two_kinds_is_unassigned():
    inks = INKS | {"M": (120, 40, 190)}  # violet: neither blue nor magenta
    picture = photographed(*drawn_page(PATTERNS["pleats"], 600, inks=inks, line=0.005), Distortion(size=SMALL), seed=3)
    trace = ff.trace(picture.pixels, picture.page)
    result = compared(PATTERNS["pleats"], picture, trace)
    assert (result.right, result.unassigned, result.wrong) == (9, 1, 0)
    (doubt,) = {edge.doubt for edge in trace.edges if edge.doubt}
    assert "between two kinds of lines" in doubt


def test_a_missing_piece_of_the_border_is_no_border():
    page, places, _ = drawn_page(PATTERNS["waterbomb"], 600)
    pen = np.asarray(page).copy()
    low, high = places.min(axis=0), places.max(axis=0)
    pen[int(low[1]) + 20 : int(high[1]) - 20, int(high[0]) - 6 :] = 250  # the right side is not drawn
    trace = ff.trace(pen, "10 cm", corners="none")
    assert trace.is_doubtful
    assert "nowhere" in " ".join(trace.doubts)
    rim = [edge for edge in trace.edges if "not a black border" in edge.doubt]
    assert rim
    assert {edge.letter for edge in rim} == {"U"}


def test_words_beside_the_pattern_are_reported_and_not_part_of_it():
    page, places, size = drawn_page(PATTERNS["waterbomb"], 600)
    ImageDraw.Draw(page).text((30, 5), "Waterbomb base, 10 cm", fill=(0, 0, 0), font_size=24)
    scan = scanned(page, places, size)
    trace = ff.trace(scan.pixels, "10 cm", corners="none")
    assert compared(PATTERNS["waterbomb"], scan, trace).complete
    assert trace.free_ends
    assert "not part of the pattern" in " ".join(trace.doubts)


def test_lines_that_merge_at_the_hub_of_a_fan_are_doubtful():
    fan = design_pattern(load_design("binder2025"))
    picture = photographed(*drawn_page(fan, 900), Distortion(size=(800, 560)), seed=3)
    trace = ff.trace(picture.pixels, picture.page)
    result = compared(fan, picture, trace)
    assert result.wrong == 0
    assert trace.is_doubtful
    assert not result.silent


def test_rough_corners_move_to_the_sheets_own():
    picture = photograph("pleats")
    rough = picture.corners + np.array([[3, -2], [-4, 1], [2, 3], [-3, -3]])
    trace = ff.trace(picture.pixels, picture.page, corners=rough.tolist())
    assert trace.corner_source == "given"
    used = np.array([(corner.x, corner.y) for corner in trace.corners])
    assert np.abs(used - picture.corners).max() < 0.5
    assert compared(PATTERNS["pleats"], picture, trace).error < 0.002


def test_a_scan_has_the_size_of_its_pattern_and_its_perspective_is_doubtful_unless_it_is_said_to_be_a_scan():
    scan = scanned(*drawn_page(PATTERNS["miura"], 700))
    height, width = np.ptp(PATTERNS["miura"].vertices_coords[:, :2], axis=0)[::-1]
    trace = ff.trace(scan.pixels, max(height, width), corners="none")
    assert (trace.width, trace.height) == (pytest.approx(width, rel=2e-3), pytest.approx(height, rel=2e-3))
    assert compared(PATTERNS["miura"], scan, trace).complete
    assert not trace.is_doubtful
    assert "No edge of a sheet was found" in " ".join(ff.trace(scan.pixels, "10 cm").doubts)


def test_one_length_gives_the_other_from_the_perspective_with_a_doubt():
    picture = photograph("vertex")
    trace = ff.trace(picture.pixels, f"{max(picture.page)} m")
    assert compared(PATTERNS["vertex"], picture, trace).error < 0.1
    assert "was estimated from" in " ".join(trace.doubts)


@pytest.mark.parametrize("seed", range(3))
def test_degraded_pictures_report_doubt_and_never_a_wrong_letter(seed):
    rng = np.random.default_rng(seed)
    bad = Distortion(
        size=SMALL,
        perspective=0.1,
        turn=float(rng.uniform(-20, 20)),
        light=0.6,
        cast=0.2,
        blur=float(rng.uniform(1, 3)),
        noise=float(rng.uniform(0.02, 0.1)),
        quality=30,
    )
    name = list(PATTERNS)[seed]
    picture = photographed(*drawn_page(PATTERNS[name], 600, dashed=seed == 1), bad, seed=seed)
    try:
        trace = ff.trace(picture.pixels, picture.page, corners=picture.corners.tolist())
    except InputError:
        return
    result = compared(PATTERNS[name], picture, trace)
    assert result.wrong == 0
    assert not result.silent


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"size": "20"}, "size: "),
        ({"size": "0 cm"}, "size: need > 0"),
        ({"size": [0.2, 0.1, 0.1]}, "size: need one length or width and height, got 3 numbers"),
        ({"corners": "1,2 3,4"}, "corners: need .* clockwise from the upper left one"),
        ({"corners": [[0, 0], [0, 500], [600, 500], [600, 0]]}, "need the four corners of the sheet in their order"),
        ({"straighten": "0 mm"}, "straighten: need > 0"),
    ],
)
def test_options_that_are_not_allowed_are_named(change, message):
    options = {"size": "20 cm"} | change
    with pytest.raises(InputError, match=message):
        ff.trace(photograph("pleats").pixels, options.pop("size"), **options)


def test_pictures_without_a_pattern_are_refused_in_words():
    with pytest.raises(InputError, match="need lines on the sheet, got none"):
        ff.trace(np.full((300, 400), 230, np.uint8), "20 cm")
    with pytest.raises(InputError, match="need a sheet that is brighter than its lines"):
        ff.trace(np.zeros((300, 400), np.uint8), "20 cm")


def test_sizes_are_read_with_one_or_two_lengths():
    assert read_size("29.7 x 21 cm") == (pytest.approx(0.297), pytest.approx(0.21))
    assert read_size("300 mm x 20 cm") == (pytest.approx(0.3), pytest.approx(0.2))
    assert read_size("20 cm") == (pytest.approx(0.2), None)
    assert read_size((0.3, 0.2)) == (0.3, 0.2)
    assert read_corners("none") == (None, False)


def test_the_command_writes_a_fold_file_that_designs_accept_and_a_report(tmp_path, capsys):
    picture = photograph("miura")
    picture.picture.save(tmp_path / "sheet.png")
    width, height = (1000 * side for side in picture.page)
    size = f"{width:.6f} x {height:.6f} mm"
    out = tmp_path / "found.fold"
    main(["trace", str(tmp_path / "sheet.png"), "--size", size, "--straighten", "1 mm", "--out", str(out), "--json"])
    written = json.loads(capsys.readouterr().out)
    jsonschema.validate(written, ff.results.json_schema("trace"))
    assert written["name"] == "sheet.png"
    assert written["straightening"]["largest_m"] < 1e-3
    assert len(written["vertices"]) == 16
    document = json.loads(out.read_text("utf-8"))
    assert document["frame_unit"] == "m"
    assert document["forficula:picture"]["metres_per_pixel"] == pytest.approx(written["pixel_size_m"])
    assert document["frame_description"].startswith("Traced in sheet.png; one pixel")
    assert {path.name for path in (tmp_path / "found").iterdir()} >= {
        "pattern.fold",
        "trace.json",
        "report.html",
        "trace.png",
    }
    pattern = read_fold(out)
    assert not np.abs(ff.pattern.kawasaki_residuals(pattern)).max() > 1e-9
    design = load_design(out)
    assert design_pattern(design).edges_assignment == pattern.edges_assignment
    assert len(ff.structure_of(design).facets) == 9
    main(["figure", str(tmp_path / "found"), "--kind", "trace", "--out", str(tmp_path / "figure.png")])
    assert (tmp_path / "figure.png").is_file()
    # a trace that fails replaces nothing, and does not report that it does
    with pytest.raises(SystemExit):
        main(["trace", str(tmp_path / "sheet.png"), "--size", size, "--straighten", "100 cm", "--out", str(out)])
    said = capsys.readouterr().err
    assert "replaces" not in said
    assert "--straighten: need a tolerance < " in said
    assert "half of the shortest distance between two vertices, got 100 cm" in said
