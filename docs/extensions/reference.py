"""Directives keys, commands and results, and the role key: reference pages that are generated from the package.

`{keys} earwig-fan` lists the keys of a kind of design, `{keys} study` those of a study file. `:section:` selects one
section, `:without:` omits sections. The role {key} links to the row of a key, and an unknown key stops the build.
`{commands}` lists all commands with their options and examples, `{results}` the keys of the JSON of all results.
"""

from __future__ import annotations

import re
import textwrap
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
from forficula.design.files.kinds import KEYED
from forficula.design.section import Section
from forficula.errors import InputError
from forficula.goals.clicks.fan_clicks import FanClicksFile
from forficula.goals.clicks.motion import MotionFile
from forficula.goals.goal_file import GoalFile
from forficula.goals.identify.observations_file import ObservationsFile
from forficula.results import KINDS as RESULTS
from forficula.results import json_schema
from forficula.study.files.study_file import StudyFile

_DESIGN_PAGE = "reference/design-file"
_STUDY_PAGE = "reference/study-file"
_HEADINGS = ("key", "allowed values", "if left out", "meaning")
_WIDTHS = (24, 22, 14, 40)
_EVERYWHERE = "* `--quiet`"
_PARAMETERS = "**Parameters**:"
_FILES: dict[str, type[Section]] = {
    "study": StudyFile,
    "goal": GoalFile,
    "observations": ObservationsFile,
    "clicks-of-a-fan": FanClicksFile,
    "clicks-of-a-film": MotionFile,
}
_NUMBER = re.compile(r"\.0\.")
_TYPES = {"string": "text", "boolean": "yes or no", "integer": "whole number", "null": "null", "array": "list"}


def facts_of(kind: str) -> list[KeyFact]:
    """Return the keys of a kind of design, or of a study, goal or observations file."""
    return key_facts("", {**KEYED, **_FILES}[kind])


def known_key(key: str) -> str | None:
    """Return the page that lists a key of any design or of a study; None for an unknown key."""
    for page, kinds in ((_DESIGN_PAGE, list(KEYED)), (_STUDY_PAGE, ["study"])):
        for kind in kinds:
            if any(fact.key == key or fact.key.startswith(f"{key}.") for fact in facts_of(kind)):
                return page
    return None


class KeysDirective(SphinxDirective):
    """Show keys, in one table for each section."""

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
        tables: list[nodes.Node] = []
        for section, facts in sections.items():
            if section:
                tables.append(nodes.rubric("", "", nodes.literal("", _header(section, kind))))
            tables.append(self._table(kind, facts))
        return tables

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
    """Link to the row of a key; an unknown key is an error."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        page = known_key(self.text)
        if page is None:
            raise InputError(f"{self.text}: unknown key, {self.get_location()}")
        kinds = (kind for kind in (*KEYED, "study") if any(fact.key == self.text for fact in facts_of(kind)))
        kind = next(kinds, None)
        up = "../" * self.env.docname.count("/")
        anchor = "" if kind is None else f"#{kind}-{_anchor(self.text)}"
        link = nodes.reference("", "", nodes.literal("", self.text), refuri=f"{up}{page}.html{anchor}", internal=True)
        return [link], []


class CommandsDirective(SphinxDirective):
    """Show all commands, each in a section."""

    def run(self) -> list[nodes.Node]:
        help_text = cli.generate_docs(output_format="markdown").replace("<", r"\<")
        # the name of the program that builds these pages
        help_text = re.sub(r" -m \S+", "", help_text)
        # sub-commands get sections, too
        sections = [text for text in re.split(r"^###? ", help_text, flags=re.M) if text.startswith("forficula ")]
        if len(sections) < 2:
            raise self.error("the command line has no commands")
        shown: list[nodes.Node] = []
        for text in sections:
            title, _, body = text.partition("\n")
            if title.startswith("forficula --"):
                continue
            # the page describes options of every command at its top
            lines = [line for line in body.splitlines() if not line.startswith(_EVERYWHERE)]
            if "".join(lines).endswith(_PARAMETERS):
                lines = lines[: lines.index(_PARAMETERS)]
            section = nodes.section(ids=[nodes.make_id(title)], names=[title.lower()])
            section += nodes.title("", "", nodes.literal("", title))
            self.state.document.note_explicit_target(section)
            self.state.nested_parse(StringList(lines, "commands"), self.content_offset, section)
            if examples := examples_of(title):
                section += nodes.paragraph("", "", nodes.strong("", "Examples"), nodes.Text(":"))
                section += nodes.literal_block(examples, examples, language="bash")
            shown.append(section)
        return shown


def examples_of(title: str) -> str:
    """Return the examples at the end of a command's help, one per line."""
    command = cli
    for name in title.split()[1:]:
        command = command[name]
    _, _, lines = (command.help_epilogue or "").partition("Examples:\n")
    return textwrap.dedent(lines)


class ResultsDirective(SphinxDirective):
    """Show the keys of the JSON of every kind of results, each in a section."""

    def run(self) -> list[nodes.Node]:
        shown: list[nodes.Node] = []
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
            shown.append(section)
        return shown


def _table_of(part: dict[str, Any]) -> list[str]:
    """Return the keys of a JSON object as a table in Markdown."""
    rows = [
        (f"`{key}`", _in_words(schema), schema.get("description", "")) for key, schema in part["properties"].items()
    ]
    if part.get("additionalProperties"):
        rows.append(("others", _in_words(part["additionalProperties"]), "by name"))
    cells = [" | ".join(text.replace("|", "\\|") for text in row) for row in (("key", "value", "meaning"), *rows)]
    return [f"| {cells[0]} |", "|---|---|---|", *(f"| {row} |" for row in cells[1:]), ""]


def _in_words(schema: dict[str, Any]) -> str:
    """Return the allowed values of a schema, in words."""
    if "$ref" in schema:
        return f"`{schema['$ref'].rpartition('/')[2]}`"
    if "anyOf" in schema:
        return " or ".join(dict.fromkeys(_in_words(option) for option in schema["anyOf"]))
    if "enum" in schema:
        return ", ".join(f'"{value}"' for value in schema["enum"])
    kind = schema.get("type", "anything")
    if isinstance(kind, list):
        return " or ".join(_TYPES.get(name, name) for name in kind if name != "null")
    if kind == "array":
        return f"list of {_in_words(schema['items'])}"
    if kind == "object":
        return f"{_in_words(schema.get('additionalProperties', {}))} by name"
    return _TYPES.get(kind, kind)


def setup(app: Sphinx) -> dict[str, object]:
    app.add_directive("keys", KeysDirective)
    app.add_directive("commands", CommandsDirective)
    app.add_directive("results", ResultsDirective)
    app.add_role("key", KeyRole())
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
