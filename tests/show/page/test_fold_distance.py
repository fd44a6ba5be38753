"""Distance of a run from the frames of a FOLD file, whatever their unit, position and order in time."""

import json
import re

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import forficula as ff
from forficula.dynamics import save_record
from forficula.show.page import compare_runs
from forficula.show.page.data.fold_distance import fold_distances, read_motion


@pytest.fixture(scope="module")
def frames_file(kresling_run, tmp_path_factory):
    path = tmp_path_factory.mktemp("frames") / "other.fold"
    ff.export(kresling_run, path)
    return path


@pytest.fixture(scope="module")
def run_folder(kresling_run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("runs") / "cell"
    folder.mkdir()
    save_record(kresling_run, folder / "record.nc")
    return folder


def changed(path, target, change):
    """Write a FOLD file with a change of its document."""
    document = json.loads(path.read_text())
    change(document)
    target.write_text(json.dumps(document))
    return target


def test_a_run_has_no_distance_from_its_own_frames(kresling_run, frames_file):
    distances = fold_distances(kresling_run, np.arange(len(kresling_run.time)), read_motion(frames_file))
    assert distances.max() <= 1e-4 * kresling_run.structure.span


def test_unit_position_and_order_of_the_frames_do_not_matter(kresling_run, frames_file, tmp_path):
    turn, rows = Rotation.from_rotvec([0.3, -1.1, 2.0]), np.arange(0, len(kresling_run.time), 50)

    def change(document):
        for frame in (document, *document["file_frames"]):
            moved = turn.apply(np.array(frame["vertices_coords"])) + np.array([1, 2, 3])
            frame["vertices_coords"] = (250 * moved).tolist()
        document["file_frames"].reverse()
        del document["frame_unit"]

    before, after = (
        fold_distances(kresling_run, rows, read_motion(path))
        for path in (frames_file, changed(frames_file, tmp_path / "moved.fold", change))
    )
    np.testing.assert_allclose(after, before, rtol=0, atol=1e-9)


def test_the_distance_is_the_root_mean_square_of_a_known_displacement(kresling_run, frames_file, tmp_path):
    height = 1e-3

    def change(document):
        first = document["file_frames"][0]
        # every second vertex up and the others down: no rotation makes this smaller by much
        for number, place in enumerate(first["vertices_coords"]):
            place[2] += height * (-1) ** number
        document["file_frames"] = [first]

    motion = read_motion(changed(frames_file, tmp_path / "moved.fold", change))
    assert fold_distances(kresling_run, np.array([0]), motion)[0] == pytest.approx(height, rel=1e-2)


def test_a_mirrored_shape_is_another_shape(kresling_run, frames_file, tmp_path):
    def change(document):
        for frame in document["file_frames"]:
            for place in frame["vertices_coords"]:
                place[0] *= -1

    motion = read_motion(changed(frames_file, tmp_path / "mirrored.fold", change))
    assert fold_distances(kresling_run, np.array([0]), motion)[0] > 0.05 * kresling_run.structure.span


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            lambda document: document.pop("file_frames"),
            'need frames of the class "foldedForm" in file_frames, got none',
        ),
        (
            lambda document: document["vertices_coords"][0].__setitem__(0, 1.0),
            "need the vertices of the run's pattern in the same order, got edges of other lengths",
        ),
    ],
)
def test_files_without_frames_or_of_other_patterns_are_refused(run_folder, frames_file, tmp_path, change, message):
    path = changed(frames_file, tmp_path / "bad.fold", change)
    with pytest.raises(ff.InputError, match=re.escape(message)):
        compare_runs([run_folder, path], tmp_path / "page.html")
    assert not (tmp_path / "page.html").exists()


def test_a_fold_file_alone_is_no_comparison(frames_file, tmp_path):
    with pytest.raises(ff.InputError, match="need the folder of a run beside FOLD files"):
        compare_runs([frames_file, frames_file], tmp_path / "page.html")


def test_a_pattern_of_another_run_is_refused(letter_run, frames_file, tmp_path):
    with pytest.raises(
        ff.InputError, match=r"^other\.fold: need the pattern of the run with 8 vertices, got one with 12$"
    ):
        ff.compare([letter_run, frames_file], tmp_path / "page.html")


def test_the_page_plays_the_run_and_plots_its_distance(watch_all, kresling_run, frames_file, tmp_path):
    ff.compare([kresling_run, frames_file], tmp_path / "page.html")
    opened = watch_all(tmp_path / "page.html")
    assert opened.messages == []
    assert opened.page.locator("#plots").get_by_text("distance to other.fold").count() > 0
    assert "root mean square after the best rotation" in opened.page.locator(".outcome").inner_text()
