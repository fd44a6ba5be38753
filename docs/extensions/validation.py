"""Directive validation: the claims of the validation tests, whether they hold, and the numbers that they compared.

`make test` and `make validation` write the results of the tests to `_build/validation.xml`, in the format of JUnit. If
this file is missing or older than the sources, the build runs the validation tests.
"""

from __future__ import annotations

import ast
import json
import os
import re
import subprocess
import sys
import time
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

DOCS = Path(__file__).parents[1]
ROOT = DOCS.parent
TESTS = ROOT / "tests" / "validation"
RESULTS = DOCS / "_build" / "validation.xml"
FAILED = RESULTS.with_suffix(".failed")
_PATIENCE = 1200  # s
_LOG = logging.getLogger(__name__)
_COLUMNS = ("quantity", "forficula", "reference", "difference", "allowed")
_SUMMARY = ("topic", "claims", "tested", "hold", "comparisons")
# comparisons of a test with equal values of these are one row
_ONE = ("what", "by", "unit", "above", "below")
_CURVE = ("over", "ours_all", "theirs_all")


@dataclass
class Claim:
    """Claim of a test, and the results of its cases.

    Attributes:
        sentence: name of the test in words.
        held: whether each case that ran passed.
        agreements: comparisons that the fixtures `agree` and `holds` recorded.
    """

    sentence: str
    held: list[bool] = field(default_factory=list)
    agreements: list[dict[str, Any]] = field(default_factory=list)


def claims() -> dict[str, tuple[str, dict[str, Claim]]]:
    """Return by module its docstring and its claims by the name of the test, without results."""
    modules = {}
    for path in sorted(TESTS.glob("test_*.py")):
        tree = ast.parse(path.read_text("utf-8"))
        functions = [node.name for node in tree.body if isinstance(node, ast.FunctionDef)]
        modules[path.stem] = (
            ast.get_docstring(tree) or "",
            {
                name: Claim(sentence=name.removeprefix("test_").replace("_", " "))
                for name in functions
                if name.startswith("test_")
            },
        )
    return modules


def fresh() -> bool:
    """Return whether there are results, and no source is younger."""
    sources = [*(ROOT / "src").rglob("*.py"), *(ROOT / "src").rglob("*.toml"), *(ROOT / "tests").rglob("*.py")]
    return RESULTS.exists() and RESULTS.stat().st_mtime > max(path.stat().st_mtime for path in sources)


def begin_tests(_: Sphinx) -> None:
    """Start the tests, which run while Sphinx reads other pages."""
    if not fresh():
        _LOG.info("running the validation tests")
        RESULTS.parent.mkdir(exist_ok=True)
        for path in (RESULTS, FAILED):
            path.unlink(missing_ok=True)
        subprocess.Popen([sys.executable, __file__], stdin=subprocess.DEVNULL)


def run_tests() -> None:
    """Run the tests, and write the file of results, or the file of reasons, once all of them have ended."""
    partial = RESULTS.with_suffix(".part")
    command = [sys.executable, "-m", "pytest", str(TESTS), "-q", "-p", "no:cacheprovider", "-n", "auto"]
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "FORFICULA_REPEATABLE": "1"}
    done = subprocess.run(
        [*command, f"--junitxml={partial}"],
        cwd=ROOT,
        env=environment,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    if done.returncode:
        FAILED.write_text(done.stdout[-4000:] + done.stderr[-4000:], "utf-8")
    else:
        partial.replace(RESULTS)


def wait_for_tests() -> None:
    """Wait until there are results; `begin_tests` has removed earlier ones."""
    end = time.monotonic() + _PATIENCE
    while not RESULTS.exists():
        if FAILED.exists():
            raise RuntimeError(f"validation tests: {FAILED.read_text('utf-8')}")
        if time.monotonic() > end:
            raise RuntimeError(f"validation tests: no results in {_PATIENCE} s")
        time.sleep(0.2)


def results() -> dict[str, tuple[str, dict[str, Claim]]]:
    """Return all claims with the results of the tests."""
    modules = claims()
    for case in ET.parse(RESULTS).getroot().iter("testcase"):
        module = case.get("classname", "").rpartition(".")[2]
        name = re.sub(r"\[.*", "", case.get("name", ""), flags=re.S)
        if module not in modules or name not in modules[module][1] or case.find("skipped") is not None:
            continue
        claim = modules[module][1][name]
        claim.held.append(case.find("failure") is None and case.find("error") is None)
        claim.agreements += [
            json.loads(item.get("value", "")) for item in case.iter("property") if item.get("name") == "agreement"
        ]
    for _, named in modules.values():
        for claim in named.values():
            claim.agreements = worst_of_each(claim.agreements)
    return modules


def worst_of_each(agreements: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return one comparison for each description: the one nearest to its bound, with the curve of any of them."""
    rows: dict[tuple[Any, ...], dict[str, Any]] = {}
    for agreement in agreements:
        key = tuple(agreement.get(name) for name in _ONE)
        before = rows.setdefault(key, agreement)
        if before is agreement:
            continue
        curve = {name: one[name] for one in (agreement, before) for name in _CURVE if name in one}
        worst = agreement if agreement["strain"] > before["strain"] else before
        rows[key] = worst | curve | {"count": before["count"] + agreement["count"]}
    return list(rows.values())


class ValidationDirective(SphinxDirective):
    """Show all claims: a summary, and a section for each module of tests."""

    def run(self) -> list[nodes.Node]:
        self.env.note_reread()
        wait_for_tests()
        # modules with numbers first
        modules = dict(sorted(results().items(), key=lambda item: not _agreements(item[1][1])))
        every = [claim for _, named in modules.values() for claim in named.values()]
        ran = [claim for claim in every if claim.held]
        held = sum(all(claim.held) for claim in ran)
        rows = sum(len(claim.agreements) for claim in ran)
        numbers = sum(agreement["count"] for claim in ran for agreement in claim.agreements)
        conclusion = (
            f"**{held} of {len(ran)} tested claims hold.** Their tests have {sum(len(claim.held) for claim in ran)}"
            f" cases, which compared {numbers:,} numbers. The tables below show {rows} comparisons, each with the"
            " number that is nearest to its bound."
        )
        if len(ran) < len(every):
            conclusion += (
                f" {len(every) - len(ran)} more claims, marked with a dot, were not tested, because this machine lacks"
                " what they need."
            )
        sections = [self._section(module, *parts) for module, parts in modules.items()]
        return [*self._text(conclusion), _summary(modules), *sections]

    def _section(self, module: str, about: str, named: dict[str, Claim]) -> nodes.section:
        section = nodes.section(ids=[nodes.make_id(module)], names=[module])
        section += nodes.title("", _title(module))
        self.state.document.note_explicit_target(section)
        section += self._text(about)
        compared = [claim for claim in named.values() if claim.agreements]
        if compared:
            section += _table(compared)
        for number, agreement in enumerate(_agreements(named)):
            if "over" in agreement:
                section += self._curve(agreement, f"{module}-{number}")
        items = nodes.bullet_list(classes=["claims"])
        for claim in sorted(named.values(), key=lambda claim: not claim.held):
            if not claim.agreements:
                words = nodes.paragraph("", "", _mark(claim), nodes.Text(claim.sentence))
                items += nodes.list_item("", words, classes=[] if claim.held else ["waits"])
        if items.children:
            section += items
        return section

    def _text(self, markdown: str) -> list[nodes.Node]:
        parsed = nodes.Element()
        self.state.nested_parse(StringList(markdown.splitlines(), "validation"), 0, parsed)
        return list(parsed.children)

    def _curve(self, agreement: dict[str, Any], name: str) -> nodes.figure:
        from matplotlib.figure import Figure

        path = RESULTS.parent / "curves" / f"{name}.svg"
        path.parent.mkdir(exist_ok=True)
        unit = f" ({agreement['unit']})" if agreement["unit"] else ""
        drawn = Figure(figsize=(4.6, 2.8), layout="constrained")
        axes = drawn.subplots()
        axes.plot(agreement["over"][1], agreement["theirs_all"], "-", color="0.65", lw=4, label=agreement["by"])
        axes.plot(agreement["over"][1], agreement["ours_all"], "-", color="#8a4b08", lw=1.2, label="forficula")
        axes.set_xlabel(agreement["over"][0])
        axes.set_title(agreement["what"] + unit, loc="left", fontsize="medium")
        axes.spines[["top", "right"]].set_visible(False)
        axes.legend(frameon=False, fontsize="small")
        drawn.savefig(path)
        alt = f"{agreement['what']} over {agreement['over'][0]}: the curve of forficula and that of {agreement['by']}"
        image = nodes.image(uri=f"/_build/curves/{path.name}", alt=alt, classes=["drawn"])
        return nodes.figure("", image)


def _title(module: str) -> str:
    return module.removeprefix("test_").replace("_", " ").capitalize()


def _agreements(named: dict[str, Claim]) -> list[dict[str, Any]]:
    """Return the comparisons of all claims of a module."""
    return [agreement for claim in named.values() for agreement in claim.agreements]


def _summary(modules: dict[str, tuple[str, dict[str, Claim]]]) -> nodes.table:
    """Return a table of all modules: numbers of claims, of claims tested and held, and of comparisons."""
    group = nodes.tgroup("", *(nodes.colspec(colwidth=20) for _ in _SUMMARY), cols=len(_SUMMARY))
    group += nodes.thead("", nodes.row("", *(_cell(text) for text in _SUMMARY)))
    body = nodes.tbody()
    for module, (_, named) in modules.items():
        ran = [claim for claim in named.values() if claim.held]
        counts = (len(named), len(ran), sum(all(claim.held) for claim in ran), len(_agreements(named)))
        link = nodes.reference("", _title(module), refid=nodes.make_id(module), internal=True)
        topic = nodes.entry("", nodes.paragraph("", "", link))
        body += nodes.row("", topic, *(_cell(str(count)) for count in counts))
    group += body
    return nodes.table("", group)


def _mark(claim: Claim) -> nodes.Node:
    if not claim.held:
        return nodes.inline("", "\N{MIDDLE DOT} ", classes=["waits"])
    if all(claim.held):
        return nodes.inline("", "\N{CHECK MARK} ", classes=["held"])
    return nodes.inline("", "FAILS: ", classes=["missed"])


def _table(claims: Sequence[Claim]) -> nodes.table:
    group = nodes.tgroup("", *(nodes.colspec(colwidth=20) for _ in _COLUMNS), cols=len(_COLUMNS))
    group += nodes.thead("", nodes.row("", *(_cell(text) for text in _COLUMNS)))
    body = nodes.tbody()
    for claim in claims:
        words = nodes.paragraph("", "", _mark(claim), nodes.Text(claim.sentence))
        body += nodes.row("", nodes.entry("", words, morecols=len(_COLUMNS) - 1), classes=["claim"])
        for agreement in claim.agreements:
            body += nodes.row("", *(_cell(text) for text in _cells(agreement)))
    group += body
    return nodes.table("", group, classes=["agreements"])


def _cells(agreement: dict[str, Any]) -> tuple[str, ...]:
    """Return the cells of a comparison, or of a bound."""
    unit = f" {agreement['unit']}" if agreement["unit"] else ""
    what = agreement["what"] + (f", worst of {agreement['count']}" if agreement["count"] > 1 else "")
    by = f" ({agreement['by']})" if agreement["by"] else ""
    if "theirs" in agreement:
        difference = (
            f"{abs(agreement['ours'] - agreement['theirs']):.1e}{unit}"
            if agreement["ours"] != agreement["theirs"]
            else "0"
        )
        allowed = f"{agreement['allowed']:.1e}{unit}" if agreement["allowed"] else "0"
        return what, f"{agreement['ours']:.6g}{unit}", f"{agreement['theirs']:.6g}{unit}{by}", difference, allowed
    bounds = [
        f"{sign} {agreement[side]:.4g}"
        for side, sign in (("above", ">"), ("below", "<"))
        if agreement[side] is not None
    ]
    return what, f"{agreement['ours']:.4g}{unit}", agreement["by"], "", " and ".join(bounds) + unit


def _cell(text: str) -> nodes.entry:
    return nodes.entry("", nodes.paragraph("", text))


def setup(app: Sphinx) -> dict[str, object]:
    app.connect("config-inited", lambda app, _: begin_tests(app))
    app.add_directive("validation", ValidationDirective)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}


if __name__ == "__main__":
    run_tests()
