"""Directives command, python, file, picture, live and show: cells of a page, and files that cells wrote."""

from __future__ import annotations

import json
import os
import re
import shutil
import time
from concurrent.futures import FIRST_EXCEPTION, Future, ThreadPoolExecutor, wait
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
# pages whose cells take longest: they begin first, so that the other pages keep all cores busy until the end
_LONGEST = ("named-designs", "tutorial", "how-to/build-and-measure", "how-to/export", "how-to/large-study")
_RUNNING: list[Future[None]] = []
_TITLE = re.compile(r"<title>(.*?)</title>", re.S)


def begin_cells(app: Sphinx) -> None:
    """Begin to run the cells of all pages, several pages at a time; Sphinx builds the gallery meanwhile.

    Sphinx itself would divide the pages among its processes by their names, and wait for the slower half.
    """
    paths = [path for path in app.srcdir.rglob("*.md") if "_build" not in path.parts]
    sources = {path.relative_to(app.srcdir).with_suffix("").as_posix(): path.read_text("utf-8") for path in paths}
    digest = sources_digest()
    pool = ThreadPoolExecutor(app.parallel)
    pages = (*_LONGEST, *sorted(sources.keys() - set(_LONGEST)))
    _RUNNING.extend(pool.submit(_run_cells, page, sources[page], digest) for page in pages)
    pool.shutdown(wait=False)


def _run_cells(page: str, source: str, digest: str) -> None:
    start = time.monotonic()
    if cells := cells_of(source):
        run_page(page, cells, digest)
        _LOG.info("the %d cells of %s took %.1f s", len(cells), page, time.monotonic() - start)


def wait_for_cells(*_: object) -> None:
    """Wait until all cells have run, or one has failed, which ends the build."""
    done, left = wait(_RUNNING, return_when=FIRST_EXCEPTION)
    for running in left:
        running.cancel()
    for running in done:
        running.result()


def show_cells(app: Sphinx, page: str, source: list[str]) -> None:
    """Take the results of the cells of a page that Sphinx is going to read."""
    if cells := cells_of(source[0]):
        app.env.temp_data["shown"] = run_page(page, cells, sources_digest())


def outdated(_: Sphinx, env: Any, __: set[str], ___: set[str], ____: set[str]) -> list[str]:
    """Return all pages if the package has changed since they were read, or if other cells are to run; else none."""
    now = f"{sources_digest()} {os.environ.get('FORFICULA_DOCS', '')}"
    before, env.made_of = getattr(env, "made_of", now), now
    return [] if before == now else sorted(env.found_docs)


def _language_of(file: str) -> str:
    """Return the language in which a file is shown; plain text for one without an ending, such as a Snakefile."""
    return Path(file).suffix.lstrip(".").replace("fold", "json") or "text"


class CellDirective(SphinxDirective):
    """Show a command, Python or a file, and its result."""

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
        language = _LANGUAGES.get(self.name) or _language_of(self.arguments[0])
        if "hidden" in self.options:
            return []
        source: nodes.Node = nodes.literal_block(text, text, language=language)
        if self.name == "file":
            caption = nodes.caption("", "", nodes.literal("", self.arguments[0]))
            source = nodes.container("", caption, source, literal_block=True, classes=["literal-block-wrapper"])
        blocks = [source]
        if shown.text and "quiet" not in self.options:
            blocks.append(nodes.container("", self._printed(shown.text), classes=["printed"]))
        if shown.picture:
            if "alt" not in self.options:
                raise self.error("a cell that ends with a figure needs :alt:, a description of the figure")
            uri = _uri(self.env.docname, shown.picture)
            blocks.append(nodes.image(uri=uri, alt=self.options["alt"], classes=["drawn"]))
        return blocks

    def _printed(self, text: str) -> nodes.literal_block:
        lines = text.splitlines()
        most = self.options.get("lines", len(lines))
        cut = [] if len(lines) <= most else ["..."]
        printed = "\n".join([*lines[:most], *cut])
        return nodes.literal_block(printed, printed, language="text")


def written(directive: Directive, page: str, path: str) -> bool:
    """Return whether a cell of a page wrote a file.

    A missing file is an error, unless a cell of the page was too costly to run.
    """
    if not (folder_of(page) / path).exists() and not (folder_of(page) / NOT_RUN).exists():
        raise directive.error(f"{path}: no cell of this page wrote it")
    return (folder_of(page) / path).exists()


class PictureDirective(Figure):
    """Show a picture that a cell of this page wrote."""

    def run(self) -> list[nodes.Node]:
        page = self.state.document.settings.env.docname
        if not written(self, page, self.arguments[0]):
            return []
        if "alt" not in self.options:
            raise self.error("needs :alt:, a description of the picture")
        self.arguments[0] = _uri(page, self.arguments[0])
        return super().run()


class LiveDirective(Directive):
    """Embed an HTML page that a cell of this page wrote."""

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
            f'<a href="{up}_live/{name}">Open this page in the full window</a></p>'
        )
        return [nodes.raw("", html, format="html")]


class ShowDirective(SphinxDirective):
    """Show a file that a cell of this page wrote: its text, or its rendered Markdown without the heading."""

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
            parsed = nodes.Element()
            markdown = StringList([line for line in lines if not line.startswith("# ")], str(path))
            self.state.nested_parse(markdown, 0, parsed)
            return list(parsed.children)
        if "from" in self.options:
            lines = lines[next(number for number, line in enumerate(lines) if line.startswith(self.options["from"])) :]
        text = "\n".join(lines[: self.options.get("lines", len(lines))])
        return [nodes.literal_block(text, text, language=path.suffix.lstrip("."))]


class NumberRole(SphinxRole):
    """Show a number from a file that a cell of this page wrote, by path, dotted key, factor and format."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        path, key, factor, form = self.text.split()
        value = json.loads((folder_of(self.env.docname) / path).read_text("utf-8"))
        for part in key.split("."):
            value = value[int(part)] if isinstance(value, list) else value[part]
        return [nodes.Text(format(value * float(factor), form))], []


def _uri(page: str, path: str) -> str:
    """Return the address of a file in the folder of a page, from the root of the documentation."""
    return "/" + (folder_of(page) / path).relative_to(DOCS).as_posix()


def copy_live_pages(app: Sphinx, error: Exception | None) -> None:
    """Copy the embedded pages into the output folder."""
    if error or app.builder.format != "html":
        return
    for name, (_, path) in getattr(app.env, "live_pages", {}).items():
        target = Path(app.outdir) / "_live" / name
        target.parent.mkdir(exist_ok=True)
        shutil.copyfile(path, target)


def forget_page(_: Sphinx, env: Any, page: str) -> None:
    lives = getattr(env, "live_pages", {})
    env.live_pages = {name: (source, path) for name, (source, path) in lives.items() if source != page}


def merge_pages(_: Sphinx, env: Any, __: set[str], other: Any) -> None:
    env.live_pages = {**getattr(env, "live_pages", {}), **getattr(other, "live_pages", {})}


def setup(app: Sphinx) -> dict[str, object]:
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    app.connect("env-get-outdated", outdated)
    app.connect("builder-inited", begin_cells, priority=100)  # before the gallery
    app.connect("env-before-read-docs", wait_for_cells)
    app.connect("source-read", show_cells)
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
