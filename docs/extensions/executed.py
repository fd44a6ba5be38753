"""Directives of pages whose cells are run: command, python, picture and live."""

from __future__ import annotations

import json
import os
import re
import shutil
from pathlib import Path
from typing import Any, ClassVar

from cells import DOCS, NOT_RUN, Shown, cells_of, folder_of, run_page, sources_digest
from docutils import nodes
from docutils.parsers.rst import Directive, directives
from docutils.parsers.rst.directives.images import Figure
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective, SphinxRole
from sphinx.util.typing import OptionSpec

_LOG = logging.getLogger(__name__)
_LANGUAGES = {"command": "bash", "python": "python"}
_TITLE = re.compile(r"<title>(.*?)</title>", re.S)


def run_cells(app: Sphinx, page: str, source: list[str]) -> None:
    """Run all cells of a page before it is read."""
    cells = cells_of(source[0])
    if cells:
        _LOG.info("running the %d cells of %s", len(cells), page)
        app.env.temp_data["shown"] = run_page(page, cells, sources_digest())


def outdated(_: Sphinx, env: Any, __: set[str], ___: set[str], ____: set[str]) -> list[str]:
    """All pages where the package has changed since they were read, or where more is to be run."""
    now = f"{sources_digest()} {os.environ.get('FORFICULA_DOCS', '')}"
    before, env.made_of = getattr(env, "made_of", now), now
    return [] if before == now else sorted(env.found_docs)


class CellDirective(SphinxDirective):
    """A command or some Python, and what came of it."""

    has_content = True
    optional_arguments = 1
    final_argument_whitespace = True
    option_spec: ClassVar[OptionSpec] = {
        "status": directives.nonnegative_int,
        "shared": directives.flag,
        "lines": directives.positive_int,
        "quiet": directives.flag,
        "hidden": directives.flag,
        "costly": directives.flag,
        "alt": directives.unchanged,
    }

    def run(self) -> list[nodes.Node]:
        text = "\n".join(self.content)
        shown: Shown = self.env.temp_data["shown"].pop(0)
        language = _LANGUAGES.get(self.name) or Path(self.arguments[0]).suffix.lstrip(".").replace("fold", "json")
        if "hidden" in self.options:
            return []
        given: nodes.Node = nodes.literal_block(text, text, language=language)
        if self.name == "file":
            caption = nodes.caption("", "", nodes.literal("", self.arguments[0]))
            given = nodes.container("", caption, given, literal_block=True, classes=["literal-block-wrapper"])
        found = [given]
        if shown.text and "quiet" not in self.options:
            found.append(nodes.container("", self._printed(shown.text), classes=["printed"]))
        if shown.picture:
            if "alt" not in self.options:
                raise self.error("a cell that ends with a figure needs :alt:, what it shows")
            uri = _uri(self.env.docname, shown.picture)
            found.append(nodes.image(uri=uri, alt=self.options["alt"], classes=["drawn"]))
        return found

    def _printed(self, text: str) -> nodes.literal_block:
        lines = text.splitlines()
        most = self.options.get("lines", len(lines))
        cut = [] if len(lines) <= most else ["..."]
        printed = "\n".join([*lines[:most], *cut])
        return nodes.literal_block(printed, printed, language="text")


def written(directive: Directive, page: str, path: str) -> bool:
    """Whether a cell of a page wrote a file; none need where one was too costly to run, else it is an error."""
    if not (folder_of(page) / path).exists() and not (folder_of(page) / NOT_RUN).exists():
        raise directive.error(f"{path}: no cell of this page wrote it")
    return (folder_of(page) / path).exists()


class PictureDirective(Figure):
    """A picture that a cell of this page wrote."""

    def run(self) -> list[nodes.Node]:
        page = self.state.document.settings.env.docname
        if not written(self, page, self.arguments[0]):
            return []
        if "alt" not in self.options:
            raise self.error("needs :alt:, what it shows")
        self.arguments[0] = _uri(page, self.arguments[0])
        return super().run()


class LiveDirective(Directive):
    """A page that a cell of this page wrote, to be played in place."""

    required_arguments = 1
    final_argument_whitespace = True
    option_spec: ClassVar[OptionSpec] = {"height": directives.nonnegative_int}

    def run(self) -> list[nodes.Node]:
        env = self.state.document.settings.env
        path = folder_of(env.docname) / self.arguments[0]
        if not written(self, env.docname, self.arguments[0]):
            return []
        name = f"{env.docname}-{self.arguments[0]}".replace("/", "-")
        env.metadata[env.docname].setdefault("live", {})
        lives = getattr(env, "live_pages", None)
        if lives is None:
            lives = env.live_pages = {}
        lives[name] = (env.docname, str(path))
        title = _TITLE.search(path.read_text("utf-8"))
        up = "../" * env.docname.count("/")
        height = self.options.get("height", 640)
        html = (
            f'<p class="live"><iframe src="{up}_live/{name}" height="{height}" loading="lazy" '
            f'title="{title[1] if title else name}"></iframe>'
            f'<a href="{up}_live/{name}">Open it as a page of its own</a></p>'
        )
        return [nodes.raw("", html, format="html")]


class ShowDirective(SphinxDirective):
    """A file that a cell of this page wrote: its text, or what its Markdown says below its heading."""

    required_arguments = 1
    option_spec: ClassVar[OptionSpec] = {
        "from": directives.unchanged,
        "lines": directives.positive_int,
        "read": directives.flag,
    }

    def run(self) -> list[nodes.Node]:
        path = folder_of(self.env.docname) / self.arguments[0]
        if not written(self, self.env.docname, self.arguments[0]):
            return []
        lines = path.read_text("utf-8").splitlines()
        if "read" in self.options:
            inside = nodes.Element()
            read = StringList([line for line in lines if not line.startswith("# ")], str(path))
            self.state.nested_parse(read, 0, inside)
            return list(inside.children)
        if "from" in self.options:
            lines = lines[next(number for number, line in enumerate(lines) if line.startswith(self.options["from"])) :]
        text = "\n".join(lines[: self.options.get("lines", len(lines))])
        return [nodes.literal_block(text, text, language=path.suffix.lstrip("."))]


class NumberRole(SphinxRole):
    """A number out of a file that a cell of this page wrote: its path, its dotted key, a factor and a format."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        path, key, factor, form = self.text.split()
        value = json.loads((folder_of(self.env.docname) / path).read_text("utf-8"))
        for part in key.split("."):
            value = value[int(part)] if isinstance(value, list) else value[part]
        return [nodes.Text(format(value * float(factor), form))], []


def _uri(page: str, path: str) -> str:
    """Of a file in a page's folder, from the documentation's root."""
    return "/" + (folder_of(page) / path).relative_to(DOCS).as_posix()


def copy_live_pages(app: Sphinx, error: Exception | None) -> None:
    """Put the pages that are played in place beside the others."""
    if error or app.builder.format != "html":
        return
    for name, (_, path) in getattr(app.env, "live_pages", {}).items():
        there = Path(app.outdir) / "_live" / name
        there.parent.mkdir(exist_ok=True)
        shutil.copyfile(path, there)


def forget_page(_: Sphinx, env: Any, page: str) -> None:
    lives = getattr(env, "live_pages", {})
    env.live_pages = {name: where for name, where in lives.items() if where[0] != page}


def merge_pages(_: Sphinx, env: Any, __: set[str], other: Any) -> None:
    env.live_pages = {**getattr(env, "live_pages", {}), **getattr(other, "live_pages", {})}


def setup(app: Sphinx) -> dict[str, object]:
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    app.connect("env-get-outdated", outdated)
    app.connect("source-read", run_cells)
    app.connect("env-purge-doc", forget_page)
    app.connect("env-merge-info", merge_pages)
    app.connect("build-finished", copy_live_pages)
    for name in ("command", "python", "file"):
        app.add_directive(name, CellDirective)
    app.add_directive("picture", PictureDirective)
    app.add_directive("live", LiveDirective)
    app.add_directive("show", ShowDirective)
    app.add_role("number", NumberRole())
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
