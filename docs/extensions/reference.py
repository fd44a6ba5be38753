"""What the package says of itself: keys of design and study files, and commands.

`{keys} earwig-fan` lists the keys of a kind of design, `{keys} study` those of a study file; `:section:` one section of
them, `:without:` all others. The role {key} links to a key's row, and an unknown key stops the build. `{commands}`
lists all commands with their options, `{results}` the keys of the JSON of all results.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective, SphinxRole
from sphinx.util.typing import OptionSpec

from forficula.cli import app as cli
from forficula.design.files.key_table import KeyFact, key_facts
from forficula.design.files.kinds import KINDS
from forficula.design.section import Section
from forficula.errors import InputError
from forficula.goals.goal_file import GoalFile
from forficula.goals.identify.observations_file import ObservationsFile
from forficula.results import KINDS as RESULTS
from forficula.results import json_schema
from forficula.study.files.study_file import StudyFile

_DESIGN_PAGE = "reference/design-file"
_STUDY_PAGE = "reference/study-file"
_HEADINGS = ("key", "may be", "if left out", "meaning")
_WIDTHS = (24, 22, 14, 40)
_EVERYWHERE = "* `--quiet`"
_PARAMETERS = "**Parameters**:"
_FILES: dict[str, type[Section]] = {"study": StudyFile, "goal": GoalFile, "observations": ObservationsFile}
_NUMBER = re.compile(r"\.0\.")
_TYPES = {"string": "text", "boolean": "yes or no", "integer": "whole number", "null": "null", "array": "list"}


def facts_of(kind: str) -> list[KeyFact]:
    return key_facts("", {**KINDS, **_FILES}[kind])


def known_key(key: str) -> str | None:
    """The page on which a key of any design or of a study stands; None for none."""
    for page, kinds in ((_DESIGN_PAGE, list(KINDS)), (_STUDY_PAGE, ["study"])):
        for kind in kinds:
            if any(fact.key == key or fact.key.startswith(f"{key}.") for fact in facts_of(kind)):
                return page
    return None


class KeysDirective(SphinxDirective):
    """Keys, a table for each section."""

    required_arguments = 1
    option_spec: ClassVar[OptionSpec] = {"section": directives.unchanged, "without": directives.unchanged}

    def run(self) -> list[nodes.Node]:
        kind, within = self.arguments[0], self.options.get("section", "")
        without = self.options.get("without", "").split()
        sections: dict[str, list[KeyFact]] = {}
        for fact in facts_of(kind):
            first = fact.key.split(".")[0] if "." in fact.key else ""
            if (not within or first == within) and first not in without:
                sections.setdefault(fact.key.rpartition(".")[0], []).append(fact)
        if not sections:
            raise self.error(f"{kind}: no keys in {within}")
        found: list[nodes.Node] = []
        for section, facts in sections.items():
            if section:
                found.append(nodes.rubric("", "", nodes.literal("", _header(section, kind))))
            found.append(self._table(kind, facts))
        return found

    def _table(self, kind: str, facts: Sequence[KeyFact]) -> nodes.table:
        group = nodes.tgroup("", *(nodes.colspec(colwidth=width) for width in _WIDTHS), cols=len(_WIDTHS))
        group += nodes.thead("", nodes.row("", *(_cell(nodes.Text(text)) for text in _HEADINGS)))
        body = nodes.tbody()
        for fact in facts:
            name = nodes.literal("", fact.key.rpartition(".")[2])
            if (anchor := f"{kind}-{_anchor(fact.key)}") not in self.state.document.ids:
                name["ids"].append(anchor)
                self.state.document.ids[anchor] = name
            default = nodes.literal("", fact.default) if fact.default not in ("", "needed") else fact.default
            body += nodes.row(
                "",
                _cell(name),
                _cell(nodes.Text(fact.allowed)),
                _cell(default if isinstance(default, nodes.Node) else nodes.Text(default)),
                _cell(nodes.Text(fact.meaning)),
            )
        group += body
        return nodes.table("", group, classes=["keys"])


def _header(section: str, kind: str) -> str:
    return f"[{section}]" if kind == "study" else _NUMBER.sub(".", f"[{section}]").replace(".0]", "]")


def _cell(node: nodes.Node) -> nodes.entry:
    return nodes.entry("", nodes.paragraph("", "", node))


def _anchor(key: str) -> str:
    return key.lower().replace(".", "-").replace("_", "-")


class KeyRole(SphinxRole):
    """A key by its name, which there must be; links to its row."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        page = known_key(self.text)
        if page is None:
            raise InputError(f"{self.text}: unknown key, {self.get_location()}")
        kind = next((each for each in (*KINDS, "study") if any(fact.key == self.text for fact in facts_of(each))), None)
        up = "../" * self.env.docname.count("/")
        anchor = "" if kind is None else f"#{kind}-{_anchor(self.text)}"
        link = nodes.reference("", "", nodes.literal("", self.text), refuri=f"{up}{page}.html{anchor}", internal=True)
        return [link], []


class CommandsDirective(SphinxDirective):
    """All commands, a section each."""

    def run(self) -> list[nodes.Node]:
        told = cli.generate_docs(output_format="markdown").replace("<", r"\<")
        # the program that builds these pages
        told = re.sub(r" -m \S+", "", told)
        # a sub-command of a command is a section, too
        sections = [text for text in re.split(r"^###? ", told, flags=re.M) if text.startswith("forficula ")]
        if len(sections) < 2:
            raise self.error("the command line tells no commands")
        found: list[nodes.Node] = []
        for text in sections:
            title, _, body = text.partition("\n")
            if title.startswith("forficula --"):
                continue
            # that of every command stands above
            lines = [line for line in body.splitlines() if not line.startswith(_EVERYWHERE)]
            if "".join(lines).endswith(_PARAMETERS):
                lines = lines[: lines.index(_PARAMETERS)]
            section = nodes.section(ids=[nodes.make_id(title)], names=[title.lower()])
            section += nodes.title("", "", nodes.literal("", title))
            self.state.document.note_explicit_target(section)
            self.state.nested_parse(StringList(lines, "commands"), self.content_offset, section)
            found.append(section)
        return found


class ResultsDirective(SphinxDirective):
    """The keys of the JSON of every kind of results, a section each."""

    def run(self) -> list[nodes.Node]:
        found: list[nodes.Node] = []
        for kind in (kind for kind in RESULTS if kind.shape):
            schema = json_schema(kind.json)
            title = f"{kind.name[0].upper()}{kind.name[1:]}"
            section = nodes.section(ids=[nodes.make_id(f"json-{kind.json}")], names=[f"json {kind.json}"])
            section += nodes.title("", title)
            lines = [f"{schema['description']} `forficula schema {kind.json}` prints the schema.", ""]
            lines += _table_of(schema)
            for name, part in schema.get("$defs", {}).items():
                if "properties" in part:
                    lines += [f"`{name}`: {part['description']}", "", *_table_of(part)]
            self.state.document.note_explicit_target(section)
            self.state.nested_parse(StringList(lines, "results"), self.content_offset, section)
            found.append(section)
        return found


def _table_of(part: dict[str, Any]) -> list[str]:
    """The keys of a table of JSON as a table in Markdown."""
    rows = [(f"`{key}`", _told(each), each.get("description", "")) for key, each in part["properties"].items()]
    if part.get("additionalProperties"):
        rows.append(("others", _told(part["additionalProperties"]), "by name"))
    cells = [" | ".join(text.replace("|", "\\|") for text in row) for row in (("key", "value", "meaning"), *rows)]
    return [f"| {cells[0]} |", "|---|---|---|", *(f"| {each} |" for each in cells[1:]), ""]


def _told(schema: dict[str, Any]) -> str:
    """What a value may be, in words."""
    if "$ref" in schema:
        return f"`{schema['$ref'].rpartition('/')[2]}`"
    if "anyOf" in schema:
        return " or ".join(dict.fromkeys(_told(each) for each in schema["anyOf"]))
    if "enum" in schema:
        return ", ".join(f'"{each}"' for each in schema["enum"])
    kind = schema.get("type", "anything")
    if isinstance(kind, list):
        return " or ".join(_TYPES.get(each, each) for each in kind if each != "null")
    if kind == "array":
        return f"list of {_told(schema['items'])}"
    if kind == "object":
        return f"{_told(schema.get('additionalProperties', {}))} by name"
    return _TYPES.get(kind, kind)


def setup(app: Sphinx) -> dict[str, object]:
    app.add_directive("keys", KeysDirective)
    app.add_directive("commands", CommandsDirective)
    app.add_directive("results", ResultsDirective)
    app.add_role("key", KeyRole())
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
