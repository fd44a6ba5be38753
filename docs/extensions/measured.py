"""Directive measured: numbers that the build does not compute, with the command and the version that computed them.

    :::{measured} forficula study binder2025-choices
    :version: 0.1.0
    :took: 5 min on two cores

    | ... |
    :::

shows its content, and below it the command, the version and the time. If the documentation has another version, the
text adds that the numbers were not measured again, or that both versions compute the same runs. A test refuses tables
of findings outside such a block or of a version with other runs, so a release that changes results measures them again.
"""

from __future__ import annotations

from typing import ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from measurements import SAME_RUNS
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective
from sphinx.util.typing import OptionSpec


class MeasuredDirective(SphinxDirective):
    """Show measured numbers and the command that measured them."""

    has_content = True
    required_arguments = 1
    final_argument_whitespace = True
    option_spec: ClassVar[OptionSpec] = {
        "version": directives.unchanged_required,
        "took": directives.unchanged,
        "with": directives.unchanged,
    }

    def run(self) -> list[nodes.Node]:
        if "version" not in self.options:
            raise self.error("measured: needs :version:, the version that measured these numbers")
        block = nodes.container("", classes=["measured"])
        self.state.nested_parse(self.content, self.content_offset, block)
        origin = nodes.paragraph("", "", nodes.Text("Measured by "), nodes.literal("", self.arguments[0]))
        origin += nodes.Text("".join(f", {self.options[name]}" for name in ("with", "took") if name in self.options))
        version = self.options["version"]
        again = "" if version == self.config.release else f"; not measured again with {self.config.release}"
        if SAME_RUNS.get(self.config.release) == version and "optimise" not in self.arguments[0]:
            again = f", whose runs {self.config.release} repeats bit for bit"
        origin += nodes.Text(f", with forficula {version}{again}.")
        origin["classes"] = ["by"]
        block += origin
        return [block]


def setup(app: Sphinx) -> dict[str, object]:
    app.add_directive("measured", MeasuredDirective)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
