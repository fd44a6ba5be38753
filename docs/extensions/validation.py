"""The table of the validation tests: what each claims, whether it holds, and what it compared.

The tests leave their results in `_build/validation.xml`, in JUnit's form: `make test` and `make validation` write it.
Where that file is missing or older than what it tells of, the build runs the validation tests itself.
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
_COLUMNS = ("what", "forficula", "beside it", "apart", "allowed")
# cases of a test differ in these, and tell of the same
_ONE = ("what", "by", "unit", "above", "below")
_CURVE = ("over", "ours_all", "theirs_all")


@dataclass
class Claim:
    """A test: its name as a sentence, and what came of its cases.

    Attributes:
        sentence: in words.
        held: of every case that ran.
        agreements: what it compared, as `agree` told.
    """

    sentence: str
    held: list[bool] = field(default_factory=list)
    agreements: list[dict[str, Any]] = field(default_factory=list)


def claims() -> dict[str, tuple[str, dict[str, Claim]]]:
    """By module the text at its head, and its claims by the name of the test, none of which has been run."""
    found = {}
    for path in sorted(TESTS.glob("test_*.py")):
        tree = ast.parse(path.read_text("utf-8"))
        named = [each.name for each in tree.body if isinstance(each, ast.FunctionDef) and each.name.startswith("test_")]
        found[path.stem] = (
            ast.get_docstring(tree) or "",
            {name: Claim(sentence=name.removeprefix("test_").replace("_", " ")) for name in named},
        )
    return found


def fresh() -> bool:
    """Whether there are results, and none of what they tell of is younger."""
    sources = [*(ROOT / "src").rglob("*.py"), *(ROOT / "src").rglob("*.toml"), *(ROOT / "tests").rglob("*.py")]
    return RESULTS.exists() and RESULTS.stat().st_mtime > max(path.stat().st_mtime for path in sources)


def begin_tests(_: Sphinx) -> None:
    """Let the tests run while other pages are read."""
    if not fresh():
        _LOG.info("running the validation tests")
        RESULTS.parent.mkdir(exist_ok=True)
        for path in (RESULTS, FAILED):
            path.unlink(missing_ok=True)
        subprocess.Popen([sys.executable, __file__], stdin=subprocess.DEVNULL)


def run_tests() -> None:
    """Run the tests; only when all is done is there a file of results, or of why not."""
    making = RESULTS.with_suffix(".part")
    command = [sys.executable, "-m", "pytest", str(TESTS), "-q", "-p", "no:cacheprovider", "-n", "auto"]
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "FORFICULA_REPEATABLE": "1"}
    done = subprocess.run(
        [*command, f"--junitxml={making}"],
        cwd=ROOT,
        env=environment,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    if done.returncode:
        FAILED.write_text(done.stdout[-4000:] + done.stderr[-4000:], "utf-8")
    else:
        making.replace(RESULTS)


def wait_for_tests() -> None:
    """Until there are results; those of before were removed as the tests began."""
    end = time.monotonic() + _PATIENCE
    while not RESULTS.exists():
        if FAILED.exists():
            raise RuntimeError(f"validation tests: {FAILED.read_text('utf-8')}")
        if time.monotonic() > end:
            raise RuntimeError(f"validation tests: no results in {_PATIENCE} s")
        time.sleep(0.2)


def results() -> dict[str, tuple[str, dict[str, Claim]]]:
    """All claims, with what the tests have left."""
    found = claims()
    for case in ET.parse(RESULTS).getroot().iter("testcase"):
        module = case.get("classname", "").rpartition(".")[2]
        name = re.sub(r"\[.*", "", case.get("name", ""), flags=re.S)
        if module not in found or name not in found[module][1] or case.find("skipped") is not None:
            continue
        claim = found[module][1][name]
        claim.held.append(case.find("failure") is None and case.find("error") is None)
        claim.agreements += [
            json.loads(each.get("value", "")) for each in case.iter("property") if each.get("name") == "agreement"
        ]
    for _, named in found.values():
        for claim in named.values():
            claim.agreements = worst_of_each(claim.agreements)
    return found


def worst_of_each(agreements: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """What cases of a test compared under the same words, once: the one nearest to its bound, with any's curve."""
    found: dict[tuple[Any, ...], dict[str, Any]] = {}
    for each in agreements:
        key = tuple(each.get(name) for name in _ONE)
        before = found.setdefault(key, each)
        if before is each:
            continue
        curve = {
            name: one[name] for one in (each, before) for name in ("over", "ours_all", "theirs_all") if name in one
        }
        worst = each if each["strain"] > before["strain"] else before
        found[key] = worst | curve | {"count": before["count"] + each["count"]}
    return list(found.values())


class ValidationDirective(SphinxDirective):
    """All claims, a section for each module of tests."""

    def run(self) -> list[nodes.Node]:
        self.env.note_reread()
        wait_for_tests()
        found = results()
        every = [claim for _, named in found.values() for claim in named.values()]
        ran = [claim for claim in every if claim.held]
        missed = [claim for claim in ran if not all(claim.held)]
        told = (
            f"{len(every)} claims; {len(ran)} were tested for this page, in {sum(len(each.held) for each in ran)} "
            f"cases, and {len(ran) - len(missed)} of them hold."
        )
        numbers = sum(each["count"] for claim in ran for each in claim.agreements)
        told += f" The tables show {sum(len(claim.agreements) for claim in ran)} comparisons of {numbers:,} numbers,"
        told += " of each the worst."
        if len(ran) < len(every):
            told += " Those with a dot were left out, for what they need is not on this machine."
        # those with numbers first
        found = dict(sorted(found.items(), key=lambda each: not any(claim.agreements for claim in each[1][1].values())))
        return [*self._text(told), *(self._section(module, *each) for module, each in found.items())]

    def _section(self, module: str, about: str, named: dict[str, Claim]) -> nodes.section:
        title = module.removeprefix("test_").replace("_", " ").capitalize()
        section = nodes.section(ids=[nodes.make_id(module)], names=[module])
        section += nodes.title("", title)
        self.state.document.note_explicit_target(section)
        section += self._text(about)
        compared = [claim for claim in named.values() if claim.agreements]
        if compared:
            section += _table(compared)
        for number, each in enumerate(each for claim in compared for each in claim.agreements):
            if "over" in each:
                section += self._curve(each, f"{module}-{number}")
        items = nodes.bullet_list(classes=["claims"])
        for claim in sorted(named.values(), key=lambda each: not each.held):
            if not claim.agreements:
                words = nodes.paragraph("", "", _mark(claim), nodes.Text(claim.sentence))
                items += nodes.list_item("", words, classes=[] if claim.held else ["waits"])
        if items.children:
            section += items
        return section

    def _text(self, markdown: str) -> list[nodes.Node]:
        inside = nodes.Element()
        self.state.nested_parse(StringList(markdown.splitlines(), "validation"), 0, inside)
        return list(inside.children)

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
        alt = f"{agreement['what']} over {agreement['over'][0]}: forficula's curve on that of {agreement['by']}"
        image = nodes.image(uri=f"/_build/curves/{path.name}", alt=alt, classes=["drawn"])
        return nodes.figure("", image)


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
        for each in claim.agreements:
            body += nodes.row("", *(_cell(text) for text in _told(each)))
    group += body
    return nodes.table("", group, classes=["agreements"])


def _told(each: dict[str, Any]) -> tuple[str, ...]:
    """The cells of a comparison, or of a bound that is held."""
    unit = f" {each['unit']}" if each["unit"] else ""
    what = each["what"] + (f", worst of {each['count']}" if each["count"] > 1 else "")
    by = f" ({each['by']})" if each["by"] else ""
    if "theirs" in each:
        apart = f"{abs(each['ours'] - each['theirs']):.1e}{unit}" if each["ours"] != each["theirs"] else "0"
        allowed = f"{each['allowed']:.1e}{unit}" if each["allowed"] else "0"
        return what, f"{each['ours']:.6g}{unit}", f"{each['theirs']:.6g}{unit}{by}", apart, allowed
    bounds = [f"{sign} {each[side]:.4g}" for side, sign in (("above", ">"), ("below", "<")) if each[side] is not None]
    return what, f"{each['ours']:.4g}{unit}", each["by"], "", " and ".join(bounds) + unit


def _cell(text: str) -> nodes.entry:
    return nodes.entry("", nodes.paragraph("", text))


def setup(app: Sphinx) -> dict[str, object]:
    app.connect("config-inited", lambda app, _: begin_tests(app))
    app.add_directive("validation", ValidationDirective)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}


if __name__ == "__main__":
    run_tests()
