"""Films have the requested size, length and speed, and show the wing where the record has it."""

import shutil
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from forficula.analysis import measure
from forficula.analysis.strength import strain_peaks
from forficula.design import load_design
from forficula.errors import InputError
from forficula.show.film.film import check_film, write_film
from forficula.show.film.film_clock import film_cuts, moment
from forficula.show.film.film_frame import FilmFrame
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import surface_at
from forficula.show.style import STRAIN_COLOURS
from forficula.study.running.runs import run
from tests.show.legible import colours
from tests.show.plates import plates_run

SIZE, RATE = (320, 180), 4
SETTLE = {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "20 ms"}
FOLD = {"name": "fold", "drive": "fold", "until": "folded", "hold": "0 s", "time_limit": "5 ms"}


@pytest.fixture(scope="module")
def cuts(reference_run, reference_outcome):
    return film_cuts(reference_run, reference_outcome)


@pytest.fixture(scope="module")
def frame(reference_run, cuts):
    return FilmFrame(reference_run, cuts, (640, 360))


def state(cuts, words):
    return next(cut for cut in cuts if cut.words == words and cut.first == cut.last)


@pytest.mark.parametrize("words", ["a flat", "b folded", "c opened"])
def test_the_wing_is_drawn_where_the_record_has_it(frame, cuts, reference_run, words):
    cut = state(cuts, words)
    with_wing = frame.draw(cut, cut.first).astype(int)
    surface = surface_at(reference_run, shape_of(reference_run.structure), cut.first)
    radius = surface.radii[0]
    places = frame._view.project(np.concatenate([surface.bars.reshape(-1, 3), surface.faces.reshape(-1, 3)]))
    pixels = frame._axes.transData.transform(places)
    thick = np.ptp(frame._axes.transData.transform([[0, 0], [radius, 0]])[:, 0]) + 2
    # only the wing: without the plots, the words and the scale bar
    present = np.argwhere(with_wing[::-1].sum(axis=2) < 720)[:, ::-1]
    left, right = pixels[:, 0].min() - thick, pixels[:, 0].max() + thick
    low, high = pixels[:, 1].min() - thick, pixels[:, 1].max() + thick
    inside = present[(present[:, 0] > left) & (present[:, 0] < right) & (present[:, 1] > low) & (present[:, 1] < high)]
    assert inside.min(axis=0) == pytest.approx(pixels.min(axis=0), abs=thick)
    assert inside.max(axis=0) == pytest.approx(pixels.max(axis=0), abs=thick)
    # every tip is a dark vein at the record's position
    for tip in frame._axes.transData.transform(frame._view.project(surface.bars[1::2, 1])):
        column, row = round(tip[0]), round(tip[1])
        around = with_wing[::-1][row - 3 : row + 4, column - 3 : column + 4]
        assert around.sum(axis=2).min() < 3 * 100


def test_pictures_differ_with_the_state_and_are_the_same_for_the_same_moment(frame, cuts):
    flat, folded = (frame.draw(cut, cut.first).copy() for cut in (state(cuts, "a flat"), state(cuts, "b folded")))
    again = frame.draw(state(cuts, "a flat"), state(cuts, "a flat").first)
    assert np.array_equal(flat, again)
    assert (flat != folded).any(axis=2).mean() > 0.05


def test_the_cursor_moves_on_the_plot_of_the_move(frame, cuts):
    fold = next(cut for cut in cuts if cut.words == "fold")
    places = []
    for share in (0.2, 0.8):
        frame.draw(fold, fold.first + share * (fold.last - fold.first))
        places.append([cursor.get_xdata()[0] for _, _, cursor in frame._cursors])
    (first, waiting), (second, still_waiting) = places
    assert (first, second) == pytest.approx([1e3 * share * (fold.last - fold.first) for share in (0.2, 0.8)])
    assert waiting == still_waiting == 0.0


def test_a_gif_is_as_large_and_as_long_as_its_film(tmp_path, reference_run, cuts):
    output = []
    write_film(reference_run, tmp_path / "wing.gif", size=SIZE, rate=RATE, progress=lambda *now: output.append(now))
    length = sum(cut.length for cut in cuts)
    with Image.open(tmp_path / "wing.gif") as film:
        assert film.size == SIZE
        durations, corners = [], set()
        for number in range(film.n_frames):
            film.seek(number)
            durations.append(film.info["duration"])
            corners.add(film.convert("RGB").getpixel((0, SIZE[1] - 1)))
    assert sum(durations) == pytest.approx(1e3 * length, abs=1e3 / RATE)
    # all pictures of a move differ; those of a held state are equal
    assert len(durations) > RATE * sum(cut.length for cut in cuts if cut.slowed)
    assert corners == {(255, 255, 255)}  # the background is white, whatever the palette
    assert output == [(number + 1, len(output)) for number in range(len(output))]
    assert len(output) == round(RATE * length)


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="there is no ffmpeg to write and read .mp4 with")
def test_an_mp4_has_the_pictures_that_were_asked_for(tmp_path, reference_run, cuts):
    write_film(reference_run, tmp_path / "wing.mp4", size=SIZE, rate=RATE)
    command = ["ffmpeg", "-loglevel", "error", "-i", tmp_path / "wing.mp4", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
    raw = np.frombuffer(subprocess.run(command, capture_output=True, check=True).stdout, dtype=np.uint8)
    pictures = raw.reshape(-1, SIZE[1], SIZE[0], 3).astype(int)
    assert len(pictures) == round(RATE * sum(cut.length for cut in cuts))
    # the first picture of the film equals the drawn one up to compression
    drawn = FilmFrame(reference_run, cuts, SIZE).draw(*moment(cuts, 0.0)).astype(int)
    assert abs(pictures[0] - drawn).mean() < 4
    assert abs(pictures[0] - pictures[len(pictures) // 2]).mean() > 4
    assert [path.name for path in tmp_path.iterdir()] == ["wing.mp4"]


@pytest.mark.parametrize(
    "values", [{"protocol.stages": [SETTLE]}, {"protocol.stages": [SETTLE, FOLD]}, {"protocol.timestep": "5 ms"}]
)
def test_every_run_can_be_filmed_whatever_the_wing_did(values):
    record = run(load_design("binder2025", values))
    cuts = film_cuts(record, measure(record))
    frame = FilmFrame(record, cuts, SIZE)
    for time in (0.0, 1e3):
        assert colours(frame.draw(*moment(cuts, time))) > 10  # not blank


@pytest.mark.parametrize("size", [(240, 240), (1282, 722), (854, 480)])
def test_a_picture_has_exactly_the_pixels_that_were_asked_for(reference_run, cuts, size):
    assert FilmFrame(reference_run, cuts, size).draw(*moment(cuts, 0.0)).shape == (size[1], size[0], 3)


def test_another_ending_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"need a file that ends with \.mp4 or \.gif, got .*wing\.avi"):
        check_film(tmp_path / "wing.avi")


def test_without_ffmpeg_one_line_says_what_to_install_and_a_gif_needs_none(tmp_path, monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda _: None)
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    with pytest.raises(
        InputError,
        match=r'an \.mp4 needs ffmpeg: pip install "forficula\[film\]"; or install ffmpeg .*, or write a \.gif',
    ):
        check_film(tmp_path / "wing.mp4")
    check_film(tmp_path / "wing.gif")


@pytest.mark.parametrize("name", ["wing.gif", "wing.mp4"])
def test_a_film_that_is_stopped_leaves_nothing(tmp_path, reference_run, name):
    if name.endswith("mp4") and shutil.which("ffmpeg") is None:
        pytest.skip("there is no ffmpeg")

    def stop(done, _):
        if done == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_film(reference_run, tmp_path / name, size=SIZE, rate=RATE, progress=stop)
    assert not list(tmp_path.iterdir())


def test_errors_of_ffmpeg_are_reported_and_no_file_is_left(tmp_path, reference_run, monkeypatch):
    broken = tmp_path / "ffmpeg"
    broken.write_text("#!/bin/sh\necho 'Unknown encoder libx264' >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setattr(shutil, "which", lambda _: str(broken))
    with pytest.raises(InputError, match="ffmpeg could not write the film: Unknown encoder libx264"):
        write_film(reference_run, tmp_path / "out" / "wing.mp4", size=SIZE, rate=RATE)
    assert not list((tmp_path / "out").iterdir())


@pytest.mark.parametrize("strain", [False, True])
def test_the_structure_moves_below_the_scales_of_colours_and_the_title(reference_run, cuts, strain):
    frame = FilmFrame(reference_run, cuts, (640, 360), strain=strain)
    figure, axes = frame._canvas.figure, frame._axes
    renderer = frame._canvas.get_renderer()
    scales = [item.get_tightbbox(renderer) for item in figure.axes if "energy of a tendon" in item.get_xlabel()]
    scales += [item.get_tightbbox(renderer) for item in figure.axes if "Green strain" in item.get_xlabel()]
    assert len(scales) == 1 + strain
    lowest = min(box.y0 for box in (*scales, frame._words.get_window_extent(renderer)))
    assert axes.get_window_extent(renderer).y1 <= lowest + 1


def pixels_of_scale(picture, scale):
    """Count the pixels of a picture, (row, column, 3) of bytes, near a colour of a scale, (colour, 3).

    Each colour of the picture is compared once: a picture has few colours and many pixels.
    """
    packed = picture.astype(np.uint32) @ np.array([1 << 16, 1 << 8, 1], dtype=np.uint32)
    colour, count = np.unique(packed, return_counts=True)
    distances = np.abs(np.stack([colour >> 16, colour >> 8 & 255, colour & 255], axis=1)[:, np.newaxis] - scale)
    return count[distances.max(axis=2).min(axis=1) < 8].sum()


def test_a_film_of_strains_colours_the_membrane_alone_and_needs_one(reference_run, cuts, frame, tmp_path):
    # the time of the largest strain
    peak = max((peak for peak in strain_peaks(reference_run) if peak.kind == "membranes"), key=lambda item: item.strain)
    fold = next(cut for cut in cuts if cut.stage is not None)
    strained = FilmFrame(reference_run, cuts, (640, 360), strain=True)
    assert strained._strains.vmax == pytest.approx(peak.strain, rel=0.01)
    # colours of large strains, below the colour bar and above the plots; other faces may hide the largest one
    scale = np.rint(255 * STRAIN_COLOURS(np.linspace(0.3, 1.0, 40))[:, :3])
    red, without = (
        max(pixels_of_scale(item.draw(fold, time)[60:220], scale) for time in np.linspace(fold.first, fold.last, 9))
        for item in (strained, frame)
    )
    assert red > 50 > without
    plates, _ = plates_run()
    with pytest.raises(InputError, match="strain: need a structure with a membrane"):
        write_film(plates, tmp_path / "plates.gif", size=SIZE, rate=RATE, strain=True)


def test_while_the_wing_moves_the_film_says_when_its_groups_of_hinges_are_half_way(frame, cuts):
    fold = next(cut for cut in cuts if cut.words == "fold" and cut.slowed is not None)
    frame.draw(fold, fold.first)
    assert frame._order.get_text() == "half-way: turn at 6 ms, ring at 26 ms"
    frame.draw(state(cuts, "b folded"), fold.last)
    assert not frame._order.get_text()
