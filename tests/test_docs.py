"""Checks of the documentation that need no build: names, commands, options, keys, links, words."""

import ast
import importlib.util
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

import forficula as ff
from forficula.cli import app
from forficula.design.files.key_table import key_facts
from forficula.design.files.kinds import KINDS
from forficula.study.files.study_file import StudyFile

DOCS = Path(__file__).parents[1] / "docs"
PAGES = sorted(path for path in DOCS.rglob("*.md") if "_build" not in path.parts and "gallery" not in path.parts)
PYTHON = DOCS / "reference" / "python.md"
README = DOCS.parent / "README.md"
# options of commands that are followed by a key and a value
SETTING = ("--set", "--over")

every_page = pytest.mark.parametrize("page", PAGES, ids=lambda path: path.relative_to(DOCS).as_posix())


def loaded(name):
    """Import a module of the documentation, which is not a package."""
    path = DOCS / f"{name}.py"
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


cells = loaded("extensions/cells")
measurements = loaded("extensions/measurements")
check_pages = loaded("check_pages")
check_links = loaded("check_links")
check_language = loaded("check_language")
sys.modules["cells"] = cells  # the name by which walk imports it
walk = loaded("walk")


@pytest.fixture(scope="module")
def keys():
    """Return every key of a design or of a study, and every section; entries of lists have no number."""
    facts = [fact for model in (StudyFile, *KINDS.values()) for fact in key_facts("", model)]
    whole = {re.sub(r"\.0(?=\.|$)", "", fact.key) for fact in facts}
    return whole | {".".join(key.split(".")[:depth]) for key in whole for depth in range(1, 5)}


def commands_of(page):
    """Return commands of a page as lists of words: those it runs and expects to succeed, and those it shows."""
    text = page.read_text("utf-8")
    run = [cell for cell in cells.cells_of(text) if cell.kind == "command" and cell.options.get("status") != "1"]
    texts = re.findall(r"^    (forficula .*)$", text, re.M) + re.findall(r"`(forficula [a-z]+ [^`]*)`", text)
    shown = [cells.Cell(kind="command", name="", text=text.replace("\n", " "), options={}) for text in texts]
    return [words for cell in (*run, *shown) for words in cell.commands]


def test_every_public_name_is_described_once_and_nothing_else():
    described = re.findall(r"^\.\. auto\w+:: (?:forficula\.)?([\w.]+)$", PYTHON.read_text("utf-8"), re.M)
    modules = {"pattern": ff.pattern, "material": ff.material, "make": ff.make, "results": ff.results}
    public = {name for name in ff.__all__ if name not in modules}
    public |= {f"{module}.{name}" for module, contents in modules.items() for name in contents.__all__}
    assert sorted(described) == sorted(public)


@pytest.mark.parametrize("page", [*PAGES, README], ids=lambda path: path.stem)
def test_commands_in_pages_have_existing_names_and_options(page):
    for words in commands_of(page):
        assert words[0] == "forficula", words
        if words[1] in ("COMMAND", "--install-completion", "..."):
            continue
        command = app[words[1]]
        command = command[words[2]] if len(words) > 2 and words[2] in command else command
        options = {name for argument in command.assemble_argument_collection() for name in argument.names}
        used = {word.split("=")[0] for word in words[2:] if word.startswith("--")}
        assert used <= options | {"--help", "--json", "--quiet"}, words


@every_page
def test_keys_that_a_page_names_exist(page, keys):
    text = page.read_text("utf-8")
    named = set(re.findall(r"\{key\}`([^`]+)`", text))
    for words in commands_of(page):
        named |= {words[place + 1].split("=")[0] for place, word in enumerate(words) if word in SETTING}
    without_numbers = {re.sub(r"\.\d+(?=\.|$)", "", name) for name in named}
    # keys of a part of an assembly begin with its name, and those of an entry of a list may have its name
    for part in re.findall(r"(?m)^\[part\.(\w+)\]", text):
        without_numbers = {
            re.sub(r"tendon\.\w+\.", "tendon.", name.removeprefix(f"{part}.")) for name in without_numbers
        }
    assert {name for name in without_numbers if name not in keys} == set()


@every_page
def test_python_cells_parse_and_call_existing_functions(page):
    for cell in cells.cells_of(page.read_text("utf-8")):
        if cell.kind == "python":
            assert_calls(cell.text)


@pytest.mark.parametrize("path", sorted((DOCS / "examples").glob("*.py")), ids=lambda path: path.stem)
def test_examples_parse_and_call_existing_functions(path):
    assert_calls(path.read_text("utf-8"))


def assert_calls(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "ff":
            assert hasattr(ff, node.attr), node.attr


@every_page
def test_pages_link_to_existing_pages_and_are_in_the_menu(page):
    text = page.read_text("utf-8")
    for target in re.findall(r"\]\(([^)#:]+\.md)(?:#[^)]*)?\)", text):
        assert (page.parent / target).is_file() or target.startswith("gallery/"), target
    menu = (DOCS / "index.md").read_text("utf-8")
    name = page.relative_to(DOCS).with_suffix("").as_posix()
    assert name == "index" or re.search(rf"^(?:.*<)?{name}>?$", menu, re.M)


def test_the_python_of_the_readme_runs_and_its_links_exist(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    text = README.read_text("utf-8")
    (code,) = re.findall(r"^```python\n(.*?)^```", text, re.M | re.S)
    exec(code, {})
    assert capsys.readouterr().out.startswith("<Outcome of binder2025: ")
    assert (tmp_path / "energy.pdf").is_file()
    for target in re.findall(r"\]\((?!http)([^)#]+)", text):
        assert (README.parent / target).exists(), target


def test_every_number_in_a_table_of_the_findings_is_computed_or_measured_with_this_version():
    page = (DOCS / "model" / "findings.md").read_text("utf-8")
    rows = [line for line in measurements.not_measured(page).splitlines() if line.startswith("|")]
    for row in rows:  # numbers that the page computes have a role
        assert not re.search(r"\d", re.sub(r"\{(number|key)\}`[^`]*`", "", row)), row
    blocks = measurements.measured_in(page)
    assert sum(line.startswith("|") for block in blocks for line in block.text.splitlines()) > 20
    names = {"run": ff.examples(), "study": ff.examples("studies")}
    for block in blocks:
        of_this_version = (ff.__version__, measurements.SAME_RUNS.get(ff.__version__))
        assert block.version in of_this_version, f"{block.command}: measure again, or state why its numbers remain"
        program, command, name, *_ = block.command.split()
        assert program == "forficula"
        assert name in names[command]


def test_a_cell_has_its_options_and_commands():
    page = "```{command}\n:quiet:\n:shared:\n:status: 2\nforficula run a \\\n  --out b  # why\n```\n"
    (first, second) = cells.cells_of(page + "\n```{file} a.toml\nx = 1\n```\n")
    assert (first.kind, first.options) == ("command", {"quiet": "", "shared": "", "status": "2"})
    assert first.commands == [["forficula", "run", "a", "--out", "b"]]
    assert (second.kind, second.name, second.text) == ("file", "a.toml", "x = 1\n")


def test_loads_from_other_hosts_and_broken_links_are_reported(tmp_path):
    (tmp_path / "there.html").write_text("<p id='here'>text</p>", "utf-8")
    (tmp_path / "style.css").write_text("@font-face { src: url(https://fonts.example/a.woff2) }", "utf-8")
    (tmp_path / "index.html").write_text(
        "<script src='https://cdn.example/a.js'></script><style>p { background: url(//x.example/y.png) }</style>"
        "<a href='https://doi.example/1'>out</a><a href='there.html#here'>in</a><a href='there.html#gone'>in</a>"
        "<img src='missing.png'><img src='data:image/png;base64,AA'>",
        "utf-8",
    )
    assert sorted(check_pages.faults(tmp_path)) == [
        "index.html: loads //x.example/y.png from another host",
        "index.html: loads https://cdn.example/a.js from another host",
        "index.html: missing.png: does not exist",
        "index.html: there.html#gone: has no anchor gone",
        "style.css: loads https://fonts.example/a.woff2 from another host",
    ]


def test_a_link_exists_or_is_gone_or_was_not_checked():
    def line(link, status, message=""):
        return json.dumps({"filename": "a.md", "lineno": 3, "uri": link, "status": status, "info": message})

    unresolved = "Max retries exceeded with url: /1 (Caused by NameResolutionError(...))"
    exist, gone, refused, unchecked = check_links.sorted_links(
        [
            line("https://a.example/1", "working"),
            line("https://a.example/2", "broken", "404 Client Error: Not Found for url"),
            line("https://b.example/1", "broken", "403 Client Error: Forbidden for url"),
            line("https://c.example/1", "broken", unresolved),
            line("https://c.example/2", "timeout"),
            line("../reference/design-file.html#earwig-fan-vein-density", "broken"),
        ]
    )
    assert exist == 1
    assert gone == ["a.md:3: https://a.example/2: 404 Client Error: Not Found for url"]
    assert dict(refused) == {"b.example": {"https://b.example/1"}}
    assert dict(unchecked) == {"c.example": {"https://c.example/1", "https://c.example/2"}}


def test_a_walk_runs_a_page_step_by_step_and_stops_at_an_unexpected_exit_status(tmp_path):
    page = (
        "Text\n\n    echo one > a.txt  # why\n    cat a.txt\n\n```{file} b.toml\nx = 1\n```\n\n"
        "```{command}\n:status: 2\nforficula run a\n```\n\n```{picture} a.txt\n:alt: words\n```\n\n"
        "```{python}\nx = 1\n```\n\n```{python}\nprint(x)\n```\n"
    )
    steps = walk.steps_of(page)
    assert [(step.line, step.status) for step in steps] == [(3, 0), (4, 0), (6, 0), (10, 2), (15, 0), (19, 0), (23, 0)]
    assert "x = 1\nprint(x)\n" in steps[-1].shell  # a cell has the names of earlier cells
    script = tmp_path / "walk.sh"
    script.write_text(
        walk.script_of("page.md", steps[:3]) + walk.script_of("page.md", [walk.Step(line=9, shell="false")])
    )
    done = subprocess.run(["bash", script], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (tmp_path / "b.toml").read_text() == "x = 1\n"
    assert (done.returncode, done.stderr) == (1, "page.md:9: ended with 1, not 0\n")


def test_words_that_readers_stumble_over_are_refused_in_text_and_names():
    source = """# what it tells

# it hangs
# on the size
def test_both_behave_alike():
    \"\"\"See theory.md and docs/model/no-such-page.md.\"\"\"
    told = "as of today"
"""
    assert sorted((line, word) for line, word, _ in check_language.faults("tests/a.py", source)) == [
        (1, "tells"),
        (3, "hangs\n# on"),
        (5, "alike"),
        (6, "docs/model/no-such-page.md"),
        (6, "theory.md"),
        (7, "told"),
    ]
    assert "as of" in [word for _, word, _ in check_language.faults("src/a.py", source)]


def test_code_in_a_page_and_released_versions_may_have_any_word():
    page = "It tells `told`, [x](told.md).\n\n```{command}\ntold\n```\n\n    told\n\nSo\nmany.\n"
    faults = [(line, word) for line, word, _ in check_language.faults("docs/a.md", page)]
    assert faults == [(1, "tells"), (9, "So\nmany")]
    changes = "# Changelog\n\n## Unreleased\n\n- new\n\n## 0.1.0\n\n- told\n"
    assert list(check_language.faults("CHANGELOG.md", changes)) == []
