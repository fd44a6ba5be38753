"""Drawing of a crease pattern in the page of a workbench: its pure functions, in Node.js without a browser."""

import json
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from forficula.pattern import miura_pattern, vertex_checks
from tests.show.page.test_engine import node_path

ROOT = Path(__file__).parents[3]
SCRIPT = """import * as drawing from "./web/src/trace-pattern.js";
import * as geometry from "./web/src/trace-geometry.js";
import { readFileSync } from "node:fs";
const input = JSON.parse(readFileSync(0, "utf8"));
const { makeHistory, moved, snapped, vertexConditions, withEdge, withImages, withVertex, without } = drawing;
const square = [[0, 0], [10, 0], [10, 10], [0, 10]];
let pattern = { vertices: square, edges: [[0, 1], [1, 2], [2, 3], [3, 0]], letters: ["B", "B", "B", "B"] };
const output = {};
output.conditions = vertexConditions(input, input.matrix);
output.upwards = vertexConditions(input, null).length;
output.crossed = withEdge(withEdge(pattern, 0, 2, "M", 0.1), 1, 3, "V", 0.1);
output.split = withVertex(pattern, [5, 0], 0.1)[0];
const through = withVertex(output.split, [5, 10], 0.1)[0];
output.joined = withEdge(through, 4, 5, "M", 0.1);
output.twice = withEdge(output.joined, 4, 5, "V", 0.1);
output.merged = moved(output.joined, 4, [10, 0.05], 0.1);
output.lighter = without(output.joined, [4]);
const path = { vertices: [[0, 0], [1, 0], [2, 0]], edges: [[0, 1], [1, 2]], letters: ["M", "M"] };
output.withoutEdge = drawing.withoutEdge(path, 1);
output.snaps = [[4.95, 0.3], [9.9, 9.8], [5, 5.05], [2, 8]].map((point) => snapped(output.split, [[5, 5]], point, 0.5));
output.mirrored = withImages(output.joined, [geometry.imageOnSheet(null, geometry.mirror([10, 0], [10, -10]))], 0.1);
const quarter = (turn) => geometry.imageOnSheet(null, geometry.rotation([0, 0], (turn * Math.PI) / 2));
output.around = withImages(pattern, [1, 2, 3].map(quarter), 0.1);
const back = geometry.inverse(input.matrix);
output.back = input.vertices.map((point) => geometry.onSheet(back, geometry.onSheet(input.matrix, point)));
output.clockwise = geometry.clockwise([square[2], square[0], square[3], square[1]]);
const shown = [];
const history = makeHistory((now) => shown.push(now.vertices.length));
history.put(pattern);
history.put(output.split);
history.put(output.split);
history.undo();
history.redo();
history.undo();
history.undo();
history.undo();
history.put(pattern);
history.redo();
output.shown = shown;
process.stdout.write(JSON.stringify(output));
"""
MATRIX = [[2e-4, 1e-5, 0.01], [-2e-5, -2.2e-4, 0.2], [1e-4, 5e-5, 1]]


@pytest.fixture(scope="module")
def sheet():
    """A Miura pattern whose vertices are moved at random."""
    pattern = miura_pattern(4, 3, 0.03, 0.02, np.radians(70))
    moved = np.random.default_rng(3).normal(0, 5e-4, pattern.vertices_coords.shape) * [1, 1, 0]
    return replace(pattern, vertices_coords=pattern.vertices_coords + moved)


@pytest.fixture(scope="module")
def drawn(sheet):
    """Return what the functions return for this sheet, seen in perspective."""
    if node_path() is None:
        pytest.skip("Node.js is missing")
    lifted = np.column_stack([sheet.vertices_coords[:, :2], np.ones(len(sheet.vertices_coords))])
    pixels = np.linalg.solve(MATRIX, lifted.T)
    data = {
        "vertices": (pixels[:2] / pixels[2]).T.tolist(),
        "edges": sheet.edges_vertices.tolist(),
        "letters": list(sheet.edges_assignment),
        "matrix": MATRIX,
    }
    command = [node_path(), "--input-type=module", "-e", SCRIPT]
    done = subprocess.run(command, input=json.dumps(data).encode(), capture_output=True, cwd=ROOT, check=True)
    return data, json.loads(done.stdout)


def edges_of(pattern):
    """Return the edges as pairs of positions with their letters."""
    places = [tuple(np.round(place, 6).tolist()) for place in pattern["vertices"]]
    pairs = [tuple(sorted((places[one], places[other]))) for one, other in pattern["edges"]]
    assert len(set(pairs)) == len(pairs)
    return dict(zip(pairs, pattern["letters"], strict=True))


def test_conditions_of_flat_folding_are_those_of_the_package(sheet, drawn):
    _, output = drawn
    checks = vertex_checks(sheet)
    assert [item["vertex"] for item in output["conditions"]] == [check.vertex for check in checks]
    for item, check in zip(output["conditions"], checks, strict=True):
        assert item["creases"] == check.creases
        assert item["kawasaki"] == pytest.approx(abs(check.kawasaki), abs=1e-9)
        assert item["maekawa"] == check.maekawa
    assert output["upwards"] == len(checks)


def test_points_of_the_picture_and_of_the_sheet_are_inverse(drawn):
    data, output = drawn
    assert np.allclose(output["back"], data["vertices"], rtol=1e-9)


def test_an_edge_that_crosses_another_splits_both(drawn):
    _, output = drawn
    edges = edges_of(output["crossed"])
    assert [5, 5] in output["crossed"]["vertices"]
    assert sorted(edges.values()) == ["B"] * 4 + ["M"] * 2 + ["V"] * 2


def test_a_vertex_on_an_edge_splits_it_and_an_edge_drawn_twice_changes_its_kind(drawn):
    _, output = drawn
    assert len(output["split"]["edges"]) == 5
    assert edges_of(output["joined"])[(5, 0), (5, 10)] == "M"
    assert edges_of(output["twice"])[(5, 0), (5, 10)] == "V"
    assert len(output["twice"]["edges"]) == len(output["joined"]["edges"]) == 7


def test_a_vertex_that_is_moved_onto_another_becomes_one_with_it(drawn):
    _, output = drawn
    assert len(output["merged"]["vertices"]) == 5
    assert edges_of(output["merged"]) == {
        ((0, 0), (10, 0)): "B",
        ((10, 0), (10, 10)): "B",
        ((0, 0), (0, 10)): "B",
        ((5, 10), (10, 10)): "B",
        ((0, 10), (5, 10)): "B",
        ((5, 10), (10, 0)): "M",
    }


def test_deletion_removes_edges_without_vertices_and_vertices_without_edges(drawn):
    _, output = drawn
    assert len(output["lighter"]["vertices"]) == 5
    assert len(output["lighter"]["edges"]) == 4
    assert output["withoutEdge"] == {"vertices": [[0, 0], [1, 0]], "edges": [[0, 1]], "letters": ["M"]}


def test_clicks_snap_to_vertices_first_then_to_junctions_then_to_edges(drawn):
    _, output = drawn
    assert [(item["what"], item["point"]) for item in output["snaps"]] == [
        ("vertex", [5, 0]),
        ("vertex", [10, 10]),
        ("junction", [5, 5]),
        ("", [2, 8]),
    ]


def test_mirror_and_rotation_copy_edges_once(drawn):
    _, output = drawn
    mirrored, around = edges_of(output["mirrored"]), edges_of(output["around"])
    assert mirrored[(15, 0), (15, 10)] == "M"
    assert len(mirrored) == 13
    assert len(around) == 12
    assert len(output["around"]["vertices"]) == 9


def test_corners_are_ordered_clockwise_from_the_upper_left_one(drawn):
    _, output = drawn
    assert output["clockwise"] == [[0, 0], [10, 0], [10, 10], [0, 10]]


def test_steps_are_undone_and_done_again(drawn):
    _, output = drawn
    assert output["shown"] == [4, 5, 4, 5, 4, 0, 4]
