"""The workbench as its page, and others, ask it."""

import http.client
import json
import signal
import socket
import subprocess
import sys

import pytest

from forficula.design import design_from_text, load_design
from forficula.workbench.traffic import LARGEST
from tests.workbench.serving import SECONDS, serving

SQUARE = {
    "file_spec": 1.2,
    "frame_unit": "cm",
    "vertices_coords": [[0, 0], [4, 0], [8, 0], [8, 4], [4, 4], [0, 4]],
    "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [1, 4]],
    "edges_assignment": ["B", "B", "B", "B", "B", "B", "V"],
    "faces_vertices": [[0, 1, 4, 5], [1, 2, 3, 4]],
}
JSON = {"Content-Type": "application/json"}


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    with serving("letter-fold", folder=tmp_path_factory.mktemp("bench")) as it:
        yield it


def sent(name, text):
    return [{"name": name, "text": text}]


@pytest.mark.parametrize(
    "headers",
    [
        # a name of another's that leads to this machine
        {"Host": "workbench.example"},
        {"Host": "workbench.example:80"},
        {"Origin": "https://elsewhere.example"},
        {"Origin": "null"},
        {"Sec-Fetch-Site": "cross-site"},
        # another port of this machine
        {"Sec-Fetch-Site": "same-site"},
    ],
)
def test_requests_of_other_pages_are_refused(served, headers):
    for method, what in (("POST", "design"), ("GET", "")):
        status, content = served.request(method, what, "{}" if method == "POST" else None, JSON | headers)
        assert status == 403
        assert json.loads(content)["refused"].startswith("this workbench answers requests ")
        assert b"letter-fold" not in content


def test_its_own_page_is_answered(served):
    origin = {"Origin": f"http://127.0.0.1:{served.port}", "Sec-Fetch-Site": "same-origin"}
    assert served.request("POST", "design", "{}", JSON | origin)[0] == 200
    status, page = served.request("GET", headers={"Sec-Fetch-Site": "none"})
    assert status == 200
    assert b"wasm-unsafe-eval" in page
    assert b"'unsafe-eval'" not in page


def test_requests_without_the_secret_address_find_nothing(served):
    for path in ("/", "/design", "/wrong/", f"{'x' * 22}/design"):
        assert served.request("GET", path)[0] == 404
    assert served.request("GET", "results/1/report.html")[0] == 404
    assert served.request("GET", "results/../../etc/passwd")[0] == 404


@pytest.mark.skipif(sys.platform != "linux", reason="only there every address of 127/8 is this machine's")
def test_it_listens_on_one_address_of_this_machine_alone(served):
    socket.create_connection(("127.0.0.1", served.port), timeout=5).close()
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection(("127.0.0.2", served.port), timeout=5)


def test_requests_larger_than_a_design_are_refused(served):
    connection = http.client.HTTPConnection("127.0.0.1", served.port, timeout=SECONDS)
    path = served.address.partition(str(served.port))[2]
    connection.putrequest("POST", f"{path}design")
    connection.putheader("Content-Type", "application/json")
    connection.putheader("Cookie", served.cookie)
    connection.putheader("Content-Length", str(LARGEST + 1))
    connection.endheaders()
    assert connection.getresponse().status == 400
    connection.close()


@pytest.mark.parametrize(
    ("method", "body", "kind", "status", "why"),
    [
        ("POST", "{}", "text/plain", 415, "need application/json"),
        ("POST", "no JSON", "application/json", 400, "Invalid JSON"),
        ("POST", '{"path": "/etc/passwd"}', "application/json", 400, "path: "),
        (
            "POST",
            '{"files": [{"name": "../a.toml", "text": ""}]}',
            "application/json",
            400,
            "name: need a file name of ",
        ),
        ("PUT", "{}", "application/json", 405, "need GET or POST, got PUT"),
    ],
)
def test_requests_that_its_page_cannot_send_are_refused(served, method, body, kind, status, why):
    result, content = served.request(method, "design", body, {"Content-Type": kind})
    assert result == status
    assert why in json.loads(content)["refused"]


def test_the_response_for_a_design_has_its_keys_its_file_and_its_command(served):
    output = served.ask("design", settings={"tendon.0.stiffness": "0.6 N/cm"})
    design = load_design("letter-fold", {"tendon.0.stiffness": "0.6 N/cm"})
    assert design_from_text(output["text"]).hash == design.hash
    assert output["command"] == 'forficula run letter-fold --set tendon.0.stiffness="0.6 N/cm"'
    values = {key["key"]: key["value"] for key in output["keys"]}
    assert values["tendon.0.stiffness"] == "0.6 N/cm"
    assert values["tendon.1.stiffness"] == served_value("letter-fold", "tendon.1.stiffness")


def served_value(name, key):
    from forficula.design.files.design_keys import design_keys

    return next(item.value for item in design_keys(load_design(name)) if item.fact.key == key)


@pytest.mark.parametrize(
    ("values", "refused"),
    [
        ({"settings": {"tendon.0.stiffness": "-1 N/cm"}}, "tendon.0.stiffness: need >= 0, got -1 N/cm"),
        ({"settings": {"tendon.0.stiffness": "3"}}, "tendon.0.stiffness: "),
        ({"settings": {"tendon.0.stifness": "1 N/cm"}}, "tendon.0.stifness: unknown key"),
        ({"design": "/etc/passwd"}, "design: need "),
        ({"files": sent("a.toml", "based_on = ")}, "a.toml: "),
        ({"files": sent("a.toml", 'based_on = "binder2025"\nvein.diameter = "5 cm"')}, "a.toml: vein.diameter: "),
        ({"files": sent("a.toml", 'based_on = "binder2025"\ntendon.law = "x.toml"')}, "a.toml: tendon.law: x.toml: "),
        ({"files": sent("a.exe", "")}, "need a file that ends with .toml"),
        ({"files": sent("a.fold", "{")}, "a.fold: "),
    ],
)
def test_invalid_designs_are_refused_with_the_message_of_the_package(served, values, refused):
    output = served.ask("design", **values)
    assert output["refused"].startswith(refused)
    assert "/tmp" not in output["refused"]


def test_a_dropped_fold_file_is_a_design(served):
    files = sent("door.fold", json.dumps(SQUARE))
    output = served.ask("design", files=files)
    assert output["name"] == "door"
    assert output["command"] == "forficula run door.fold"
    assert {key["key"] for key in output["keys"] if key["chosen"]} >= {"facet.thickness"}
    assert "mountain" not in served.ask("pattern", files=files)["said"]
    assert "creases are not joints" in served.ask("model", files=files)["live"]["refused"]


def test_a_drawing_without_a_unit_takes_that_of_the_page(served):
    files = sent("door.fold", json.dumps({key: value for key, value in SQUARE.items() if key != "frame_unit"}))
    assert "refused" not in served.ask("design", files=files)
    (first, *_) = served.ask("model", files=files)["warnings"]
    assert first.startswith("door.fold: the file states no unit of length")
    assert "unit" in served.ask("design", files=files, unit="3")["refused"]
    output = served.ask("design", files=files, unit="1 mm")
    assert output["command"] == 'forficula run door.fold --unit "1 mm"'
    x = next(key["value"] for key in output["keys"] if key["key"] == "pattern.vertices_x")
    assert json.loads(x) == ["0 cm", "0.4 cm", "0.8 cm", "0.8 cm", "0.4 cm", "0 cm"]


def test_a_design_is_dropped_with_the_files_that_it_names(served):
    head = 'based_on = "miura-sheet"\ntendon = []\nsupport = []\nmeasure = []\n'
    design = {"name": "mine.toml", "text": f'{head}[pattern]\nkind = "fold-file"\npath = "door.fold"\n'}
    files = [design, {"name": "door.fold", "text": json.dumps(SQUARE)}]
    output = served.ask("design", files=files)
    assert output.get("name") == "mine", output
    assert served.ask("design", files=files[:1])["refused"].startswith("mine.toml: ")


def test_the_model_is_the_one_that_the_package_builds_for_a_page(served):
    from forficula.show.page.data.live_data import live_data
    from forficula.show.page.live_page import start_clip

    output = served.ask("model", settings={"tendon.0.stiffness": "0.6 N/cm"})
    design = load_design("letter-fold", {"tendon.0.stiffness": "0.6 N/cm"})
    clip = start_clip(design)
    expected = live_data(design, [reading.measure for reading in clip.readings], clip.mesh.anchors.tolist())
    assert output["live"] == json.loads(json.dumps(expected))


def lines(served, what, **values):
    status, content = served.request("POST", what, json.dumps(values), JSON)
    assert status == 200
    return [json.loads(line) for line in content.splitlines()]


def test_a_landscape_reports_progress_and_is_stored_as_a_page(served):
    *steps, last = lines(served, "landscape", design="binder2025-joint")
    assert any("drawing" in step["doing"] for step in steps)
    status, page = served.request("GET", last["done"])
    assert status == 200
    assert b"<title>binder2025-joint: landscape</title>" in page


def test_a_fold_path_is_preceded_by_a_picture_and_grows(served):
    files = sent("door.fold", json.dumps(SQUARE))
    first, *parts, last = lines(served, "fold", files=files)
    assert first["picture"]["clips"][0]["pointCount"] == 6
    assert [name for name in first["picture"]["points"] if name] == [f"vertex {number}" for number in range(6)]
    assert last == {"done": True}
    assert [part["path"]["complete"] for part in parts] == [False] * (len(parts) - 1) + [True]
    path = parts[-1]["path"]
    assert path["reached"]
    # the picture has the mesh
    assert "triangles" not in path["clips"][0]


def test_a_dragged_vertex_is_held_by_the_force_that_the_package_computes(served):
    from forficula.design import load_design
    from forficula.show.page.data.shape_mesh import shape_mesh
    from forficula.show.page.data.shown_path import shown_path
    from forficula.statics import quasi_static_path, start_drag
    from forficula.structure import structure_of

    structure = structure_of(load_design("letter-fold"))
    path = shown_path(quasi_static_path(structure))
    near = path.point(0.25)
    anchors = shape_mesh(structure).anchors.tolist()
    drawn, tip = next(
        (drawn, anchor) for drawn, anchor in enumerate(anchors) if structure.points[anchor].name == "facet2_vertex3"
    )
    # on the arc about the panel's joint
    target = path.positions[path.index(0.3)][tip]
    assert lines(served, "fold")[-1] == {"done": True}
    drag = {"share": 0.25, "weights": {drawn: 1.0}, "target": target.tolist(), "begins": True}
    output = served.ask("drag", **drag)
    assert output["text"] == start_drag(structure, tip, near=near).to(target).text
    assert output["text"].endswith("N holds the point here.")
    # a design whose path is not computed
    refused = served.ask("drag", **drag, settings={"tendon.0.stiffness": "0.6 N/cm"})["refused"]
    assert refused == "the fold path of this design is not computed yet; drag it once it is"
    assert served.ask("drag", **drag | {"weights": {999: 1.0}})["refused"].startswith("weights: need points from 0 to ")


TWICE = SQUARE | {
    "vertices_coords": SQUARE["vertices_coords"] + [[x + 20, y] for x, y in SQUARE["vertices_coords"]],
    "edges_vertices": SQUARE["edges_vertices"] + [[one + 6, other + 6] for one, other in SQUARE["edges_vertices"]],
    "edges_assignment": 2 * SQUARE["edges_assignment"],
    "faces_vertices": SQUARE["faces_vertices"] + [[corner + 6 for corner in face] for face in SQUARE["faces_vertices"]],
}


@pytest.mark.parametrize(
    ("sheet", "pictured", "why"),
    [
        ({}, False, "it.fold: vertices_coords: need a list, but the key is missing"),
        (SQUARE | {"edges_vertices": [], "faces_vertices": []}, False, "it.fold: edges_"),
        (SQUARE | {"edges_assignment": ["B"] * 6 + ["C"]}, False, "it.fold: pattern: need a mountain or a valley"),
        (SQUARE | {"edges_assignment": ["B"] * 6 + ["U"]}, True, "it: need a drive that folds it"),
        # two sheets that nothing joins
        (TWICE, True, 'the drive "fold" does not move the sheet; a part can move without any force'),
    ],
)
def test_a_sheet_that_cannot_be_folded_ends_in_one_line(served, sheet, pictured, why):
    *pictures, last = lines(served, "fold", files=sent("it.fold", json.dumps(sheet)))
    assert [list(line) for line in pictures] == [["picture"]] * pictured
    assert last["refused"].startswith(why)
    assert "\n" not in last["refused"]


def test_a_fold_path_that_is_superseded_stops_and_its_process_continues(served):
    wide = json.dumps({"design": "miura-sheet", "settings": {"pattern.columns": "12", "pattern.rows": "12"}})
    path = served.address.partition(str(served.port))[2] + "fold"
    kept = []
    # a process that a busy machine does not let run within a second is replaced
    while True not in kept and len(kept) < 3:
        connection = http.client.HTTPConnection("127.0.0.1", served.port, timeout=SECONDS)
        connection.request("POST", path, wide, JSON | {"Cookie": served.cookie})
        assert b"picture" in connection.getresponse().readline()
        before = children(served.process.pid)
        connection.sock.shutdown(socket.SHUT_RDWR)
        connection.close()
        assert lines(served, "fold", files=sent("door.fold", json.dumps(SQUARE)))[-1] == {"done": True}
        kept.append(children(served.process.pid) == before)
    assert True in kept


def children(parent):
    """Processes that a process has started."""
    listed = subprocess.run(["ps", "-o", "pid=", "--ppid", str(parent)], capture_output=True, text=True, check=True)
    return set(listed.stdout.split())


def test_what_cannot_be_surveyed_says_why(served):
    (last,) = lines(served, "landscape", settings={"tendon.0.stiffness": "-1 N/cm"})
    assert last["refused"] == "tendon.0.stiffness: need >= 0, got -1 N/cm"


def test_a_task_ends_when_its_page_is_closed(served):
    slow = json.dumps({"design": "binder2025", "settings": {"protocol.timestep": "0.0005 ms"}})
    connection = http.client.HTTPConnection("127.0.0.1", served.port, timeout=SECONDS)
    connection.request(
        "POST", served.address.partition(str(served.port))[2] + "run", slow, JSON | {"Cookie": served.cookie}
    )
    assert b"doing" in connection.getresponse().readline()
    # hours of work
    connection.sock.shutdown(socket.SHUT_RDWR)
    connection.close()
    assert (
        "done"
        in lines(
            served,
            "run",
            settings={"protocol.stages": '[{name="s", drive="none", until="time", hold="0 s", time_limit="10 ms"}]'},
        )[-1]
    )


@pytest.mark.parametrize(("by", "at_work"), [("SIGINT", True), ("SIGTERM", False), ("SIGHUP", False)])
def test_ctrl_c_ends_it_in_the_midst_of_work_with_one_line_and_leaves_nothing(
    tmp_path, tmp_path_factory, monkeypatch, by, at_work
):
    """SIGTERM, and SIGHUP from a closed terminal, have the same effect as Ctrl-C."""
    number = getattr(signal, by, None)
    if number is None or signal.getsignal(number) == signal.SIG_IGN:
        pytest.skip("a job in the background ignores it, and not every system has it")
    temporary = tmp_path_factory.mktemp("temporary")
    monkeypatch.setenv("TMPDIR", str(temporary))
    with serving("letter-fold", folder=tmp_path) as served:
        connection = http.client.HTTPConnection("127.0.0.1", served.port, timeout=SECONDS)
        if at_work:
            slow = json.dumps({"design": "binder2025", "settings": {"protocol.timestep": "0.0005 ms"}})
            connection.request(
                "POST", served.address.partition(str(served.port))[2] + "run", slow, JSON | {"Cookie": served.cookie}
            )
            connection.getresponse().readline()
        errors, code = served.interrupt(number)
        connection.close()
    assert code == 130
    assert errors.splitlines() == ["forficula: stopped"]
    assert list(tmp_path.iterdir()) == []
    assert list(temporary.iterdir()) == []


def test_a_port_that_is_taken_is_named(capsys):
    from forficula.cli import main

    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        with pytest.raises(SystemExit) as end:
            main(["open", "letter-fold", "--no-browser", "--port", str(port)])
    assert end.value.code == 1
    assert capsys.readouterr().err.startswith(f"forficula: --port: {port} is not available: ")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--port", "0"], "--port: need 1 to 65535, got 0"),
        (["--port", "8000", "--out", "a.html"], "--port: --out writes a file, which is not served"),
        (["--set", "tendon.0.stiffness=-1 N/cm"], "tendon.0.stiffness: need >= 0, got -1 N/cm"),
    ],
)
def test_what_cannot_be_opened_is_refused_in_one_line(arguments, message, capsys):
    from forficula.cli import main

    with pytest.raises(SystemExit):
        main(["open", "letter-fold", *arguments])
    assert capsys.readouterr().err == f"forficula: {message}\n"
