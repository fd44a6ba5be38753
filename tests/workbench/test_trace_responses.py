"""Pictures that the page of a workbench sends: their scale, junctions and trace, and the pattern drawn on them."""

import base64
import io
import json

import numpy as np
import pytest
from PIL import Image, ImageDraw
from pydantic import ValidationError

from forficula.errors import InputError
from forficula.pattern import kawasaki_residuals, read_fold
from forficula.workbench.requests import Opened
from forficula.workbench.trace_requests import (
    DrawnPatternRequest,
    PictureRequest,
    ScaleRequest,
    StraightenRequest,
    TraceRequest,
)
from forficula.workbench.trace_responses import (
    drawn_pattern_response,
    junctions_response,
    scale_response,
    straightened_response,
    trace_response,
)

OPENED = Opened(design="letter-fold")
LENGTH = {"points": [[10, 20], [210, 20]], "size": "8 cm", "width": 300, "height": 240}
# four cells around one vertex, which deviates from Kawasaki's condition
DRAWN = {
    "name": "sketch.png",
    "vertices": [[0, 0], [100, 30], [200, 0], [212, 100], [220, 200], [110, 230], [10, 200], [5, 100], [112, 132]],
    "edges": [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 6], [6, 7], [7, 0], [7, 8], [8, 3], [1, 8], [8, 5]],
    "letters": list("BBBBBBBBMMMV"),
}


def content(picture, kind="PNG", **options):
    file = io.BytesIO()
    picture.save(file, kind, **options)
    return base64.b64encode(file.getvalue()).decode()


def drawing(width=400, height=300):
    """Draw a black frame of 300 x 200 pixels, with a red line across it."""
    picture = Image.new("RGB", (width, height), "white")
    pen = ImageDraw.Draw(picture)
    pen.rectangle((50, 50, 350, 250), outline="black", width=4)
    pen.line((200, 52, 200, 248), fill=(200, 30, 30), width=4)
    return picture


def test_two_points_and_their_distance_give_the_scale():
    response = scale_response(ScaleRequest(**LENGTH))
    assert (response["size"], response["pixel"]) == ("8 cm", "0.4 mm")
    # upwards in the picture is upwards on the sheet
    u, v, w = np.array(response["matrix"]) @ [10, 20, 1]
    assert np.allclose([u / w, v / w], [0.004, 0.0004 * (239 - 20)])


def test_four_corners_rectify_and_one_side_is_estimated_from_the_perspective():
    corners = [[50, 40], [260, 60], [240, 200], [30, 210]]
    request = LENGTH | {"points": corners}
    response = scale_response(ScaleRequest(**request | {"size": "30 x 20 cm"}))
    mapped = np.array(response["matrix"]) @ np.column_stack([corners, np.ones(4)]).T
    assert np.allclose((mapped[:2] / mapped[2]).T, [[0, 0.2], [0.3, 0.2], [0.3, 0], [0, 0]])
    assert response["estimated"] == ""
    assert scale_response(ScaleRequest(**request | {"size": "30 cm"}))["estimated"].startswith("the ")
    with pytest.raises(InputError, match="clockwise in the picture"):
        scale_response(ScaleRequest(**request | {"points": corners[::-1], "size": "30 cm"}))


@pytest.mark.parametrize(("size", "why"), [("", "need"), ("-3 cm", "need"), ("3 kg", "unit"), ("0 mm", "need > 0")])
def test_a_distance_that_is_no_length_is_refused(size, why):
    with pytest.raises(InputError, match=f"length: .*{why}"):
        scale_response(ScaleRequest(**LENGTH | {"size": size}))


def test_clicks_snap_to_junctions_of_a_picture_that_is_turned_by_its_exif_data():
    exif = Image.Exif()
    exif[0x0112] = 6  # the picture is displayed after a quarter turn clockwise
    response = junctions_response(PictureRequest(picture=content(drawing(), "JPEG", quality=95, exif=exif)))
    assert (response["width"], response["height"], response["reason"]) == (300, 400, "")
    # pixel (x, y) of the file is at (299 - y, x)
    expected = [[299 - y, x] for x in (51.5, 200, 348.5) for y in (51.5, 248.5)]
    assert len(response["points"]) == 6
    for point in expected:
        assert min(np.hypot(*np.subtract(known, point)) for known in response["points"]) < 1.5


@pytest.mark.parametrize(
    ("picture", "why"),
    [
        ("", "empty file"),
        (base64.b64encode(b"no picture").decode(), "need a PNG or JPEG picture, got another content"),
        (content(Image.new("CMYK", (200, 200)), "JPEG"), "got CMYK"),
        (content(Image.new("L", (9000, 9000))), "million pixels"),
        (content(Image.new("I;16", (200, 200))), "8 bits"),
        (content(drawing(), save_all=True, append_images=[Image.new("RGB", (400, 300))]), "animation"),
        (content(drawing())[:800], "cannot be read as a PNG or JPEG picture"),
    ],
)
def test_content_that_is_no_picture_to_trace_ends_in_one_line(picture, why):
    with pytest.raises(InputError, match=why) as refused:
        junctions_response(PictureRequest(picture=picture))
    assert "\n" not in str(refused.value)


def test_a_picture_without_lines_has_no_junctions_but_can_be_drawn_on():
    response = junctions_response(PictureRequest(picture=content(Image.new("RGB", (200, 150), "white"))))
    assert response["points"] == []
    assert response["reason"].startswith("need lines")


def test_the_inside_of_a_drawn_frame_is_no_sheet_without_lines():
    picture = Image.new("RGB", (400, 300), "white")
    ImageDraw.Draw(picture).rectangle((48, 48, 351, 251), outline="black", width=4)
    points = junctions_response(PictureRequest(picture=content(picture)))["points"]
    for corner in [(49.5, 49.5), (349.5, 49.5), (349.5, 249.5), (49.5, 249.5)]:
        assert min(np.hypot(*np.subtract(known, corner)) for known in points) < 0.5


def test_the_automatic_trace_gives_the_drawing_with_its_scale():
    response = trace_response(TraceRequest(picture=content(drawing()), size="30 cm", corners="none"))
    assert sorted(response["letters"]) == ["B"] * 6 + ["M"]
    assert len(response["vertices"]) == 6
    scale = scale_response(ScaleRequest(**response["scale"], width=400, height=300))
    extent = np.ptp(np.array(response["vertices"]), axis=0)[0]
    assert scale["matrix"][0][0] * extent == pytest.approx(0.3, rel=1e-9)


def test_a_drawn_pattern_becomes_a_fold_file_with_unit_and_picture_scale(tmp_path):
    response = drawn_pattern_response(DrawnPatternRequest(scale=LENGTH, **DRAWN), OPENED)
    (tmp_path / "drawn.fold").write_text(response["fold"])
    pattern = read_fold(tmp_path / "drawn.fold")
    assert "".join(pattern.edges_assignment) == "BBBBBBBBMMMV"
    assert len(pattern.faces_vertices) == 4
    # 220 x 230 pixels of 0.4 mm
    assert np.ptp(pattern.vertices_coords, axis=0) == pytest.approx([0.088, 0.092, 0])
    document = json.loads(response["fold"])
    assert document["frame_unit"] == "m"
    assert document["forficula:picture"]["metres_per_pixel"] == pytest.approx(0.0004)
    assert document["forficula:picture"]["name"] == "sketch.png"


def test_the_least_movement_makes_a_drawn_pattern_flat_foldable(tmp_path):
    response = straightened_response(StraightenRequest(scale=LENGTH, **DRAWN, tolerance="3 mm"), OPENED)
    assert response["flat"] == 1
    moved = np.linalg.norm(np.subtract(response["vertices"], DRAWN["vertices"]), axis=1)
    assert 0 < moved.max() < 3 / 0.4
    drawn = DRAWN | {key: response[key] for key in ("vertices", "edges", "letters")}
    again = drawn_pattern_response(DrawnPatternRequest(scale=LENGTH, **drawn), OPENED)
    (tmp_path / "flat.fold").write_text(again["fold"])
    assert kawasaki_residuals(read_fold(tmp_path / "flat.fold")) == pytest.approx(0, abs=1e-9)
    with pytest.raises(InputError, match="need a tolerance of at least"):
        straightened_response(StraightenRequest(scale=LENGTH, **DRAWN, tolerance="1 um"), OPENED)


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"edges": [[0, 1], [1, 2]], "letters": ["B", "B"]}, "need edges that enclose a face"),
        ({"edges": [*DRAWN["edges"], [0, 4]], "letters": [*DRAWN["letters"], "M"]}, r"edges_vertices\["),
        ({"edges": [*DRAWN["edges"], [0, 99]], "letters": [*DRAWN["letters"], "M"]}, "need edges between vertices"),
        ({"letters": ["B"]}, "a letter for every edge"),
    ],
)
def test_drawn_edges_that_are_no_pattern_are_refused(change, why):
    with pytest.raises(InputError, match=why):
        drawn_pattern_response(DrawnPatternRequest(scale=LENGTH, **DRAWN | change), OPENED)


def test_positions_that_no_picture_has_are_not_accepted():
    for position in ([float("nan"), 0], [1e300, 0], [1]):
        with pytest.raises(ValidationError):
            ScaleRequest(**LENGTH | {"points": [position, [0, 0]]})
