"""Pages of results that consist of figures and tables."""

import re

import pytest
from matplotlib.figure import Figure
from rich.console import Group
from rich.table import Table
from rich.text import Text

from forficula.show.page.parts.html import remarks, section
from forficula.show.page.parts.rich_html import printed_result
from forficula.show.page.results_page import figure_sections, results_page, with_section
from forficula.show.style import describe, save_figures

HOSTILE = '</section></main><script>alert("1")</script>'


@pytest.fixture
def shown():
    """Terminal output: a verdict, a table under a line in italics, a table with a title, and sentences."""
    first, second = Table(), Table(title="Titled")
    first.add_column("", justify="left")
    first.add_column(Text(f"value {HOSTILE}"))
    first.add_row("stiffness", "10 N/cm")
    second.add_column("only")
    second.add_row(HOSTILE)
    parts = (Text("wing: it folds", style="bold"), Text("Sums", style="italic"), first, Text(), second, Table())
    return Group(*parts, Text("hinge.damping is large"), f"mind this {HOSTILE}")


def test_terminal_output_is_on_the_page(shown):
    result = printed_result(shown)
    assert result.heading == "wing: it folds"
    assert [re.search("<caption>(.*?)</caption>", table)[1] for table in result.tables] == ["Sums", "Titled"]
    assert "<td>10 N/cm</td>" in result.tables[0]
    assert result.sentences == ("hinge.damping is large", f"mind this {HOSTILE}")


def test_text_stays_text_and_the_figure_has_a_text_and_a_form_for_phones(shown, tmp_path):
    def draw(width):
        return describe(Figure(figsize=(width, 1)), f"A figure. {HOSTILE}")

    texts = save_figures({"fit": draw}, tmp_path)
    figures = figure_sections(tmp_path, {"other": "Not there", "fit": "The fit"}, texts)
    page = results_page("material", HOSTILE, printed_result(shown), figures)
    assert page.count("<script") == 1
    assert len(figures) == page.count("<img ") == page.count('srcset="data:image/svg+xml;base64,') == 1
    assert "A figure. &lt;/section&gt;" in page
    assert page.index("The fit") < page.index("10 N/cm") < page.index("<li>hinge.damping is large.</li>")
    assert "<p class=outcome>Wing: it folds.</p>" in page
    # nothing may be fetched
    assert re.findall(r'(?:src|href|srcset)="(?!data:)', page) == []


def test_a_section_that_is_added_again_replaces_the_first(shown):
    page = results_page("landscape", "wing", printed_result(shown), [])
    once = with_section(page, "map", section("Map", "<p>first</p>", name="map"))
    twice = with_section(once, "map", section("Map", "<p>second</p>", name="map"))
    assert once.count("<p>first") == twice.count("<p>second") == 1
    assert twice == once.replace("<p>first", "<p>second")
    assert once.replace('<section id="map"><h2>Map</h2><p>first</p></section>\n', "") == page


def test_remarks_are_sentences_but_for_the_keys_that_they_begin_with():
    assert remarks([]) == ""
    made = remarks(["the run moves", "tendon.area: too large.", "viscosity.linear, viscosity.cubic: one rate"])
    items = ("The run moves.", "tendon.area: too large.", "viscosity.linear, viscosity.cubic: one rate.")
    assert re.findall("<li>(.*?)</li>", made) == list(items)
