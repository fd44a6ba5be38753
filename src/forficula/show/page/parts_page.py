"""The page of parts to make: the parts moving in 3-D, their bill, what is checked of them, and the sheet."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from urllib.parse import quote

from forficula.dynamics import Record
from forficula.files import write_text
from forficula.make.checks.check import Check
from forficula.make.flat.cut_lines import CutSheet, layer_texts
from forficula.make.flat.sheet_svg import sheet_svg
from forficula.make.part import PartSet
from forficula.make.solid.mesh import MILLIMETRES
from forficula.show.make.part_facts import (
    mass_text,
    material_text,
    part_masses,
    size_text,
    total_mass,
    value_text,
)
from forficula.show.page.data.parts_data import parts_data, parts_text
from forficula.show.page.page import page_html
from forficula.show.page.parts.design_rows import design_title
from forficula.show.page.parts.design_tables import design_tables
from forficula.show.page.parts.html import Cell, escaped, paragraph, red, remarks, section, table

_CHECKED = (
    "solids at their nominal size: whether they overlap, how far they are apart, where they stop",
    "straps as they are bent without a twist, taut or as an elastica",
    "forces by formulas of beams and columns, with the strengths of data sheets, each the least that is told",
)
_UNCHECKED = (
    "that it prints: shrinkage, warping, the fit of your printer; print one joint first",
    "fatigue of hinges and straps, creep of what is kept under load, ageing",
    "bonding: glue between sheet and bars, layers of a print beyond the strength that its data sheet gives",
    "impact where a half snaps against its stop",
)
_WORDS = {True: "passed", False: "failed", None: "not checked"}


def write_parts_page(
    parts: PartSet,
    checks: Sequence[Check],
    path: Path,
    record: Record | None = None,
    *,
    files: Sequence[str] = (),
) -> None:
    """Write parts as one HTML file that needs no network; the same parts give the same bytes.

    Args:
        parts: to make.
        checks: of them.
        path: of the file.
        record: of the same design, whose motion can be played.
        files: names of files beside the page, to which it links.

    Raises:
        InputError: the record is of another design, or the file cannot be written.
    """
    write_text(path, parts_page(parts, checks, record, files=files))


def parts_page(
    parts: PartSet,
    checks: Sequence[Check],
    record: Record | None = None,
    *,
    files: Sequence[str] = (),
) -> str:
    """Parts as one page, as `write_parts_page` writes it; where only the sheet is made, nothing moves."""
    title = f"{design_title(parts.design)}: parts to make"
    solid = bool(parts.parts)
    player = f'<div><div id="player"></div>{_moving_note(parts, record)}</div>' if solid else ""
    beside = f"<aside>{_bill(parts)}{_links(files)}</aside>" if solid or files else ""
    below = "".join(
        (
            section("The sheet", _drawn(parts.sheet), name="sheet"),
            section("Checks", _check_table(checks), name="checks"),
            section("What is checked, and what is not", *_honest(), name="honest"),
            section("Design", _every_value(parts), name="design"),
        )
    )
    sentence = f'<p class="outcome">{escaped(_sentence(parts))} {_checked(checks)}</p>'
    body = (
        f"<header><h1>{escaped(title)}</h1>{sentence}</header>\n"
        f'<main><div class="assembly">{player}{beside}</div>{below}</main>'
    )
    return page_html(title, body, parts_data(parts, record) if solid else None)


def _sentence(parts: PartSet) -> str:
    """What is to be made, and how heavy it is."""
    told = [parts_text(parts)] if parts.parts else ["A sheet to cut."]
    if parts.parts:
        mass = total_mass(parts)
        told.append(f"Together {mass_text(mass)}." if mass is not None else "Of a material the density is not known.")
    return " ".join(told)


def _checked(checks: Sequence[Check]) -> str:
    """How many checks fail, in red, as HTML."""
    if not checks:
        return "They are not checked yet: ff.make.check_parts does that."
    failed, held = (sum(check.ok is each for check in checks) for each in (False, True))
    left = sum(check.ok is None for check in checks)
    rest = f" {left} could not be carried out." * (left > 0)
    if not failed:
        return f"All {held} checks pass.{rest}"
    several = f"{failed} of {failed + held} checks fail{'s' * (failed == 1)}; see below."
    return f"{red(several)}{rest}"


def _moving_note(parts: PartSet, record: Record | None) -> str:
    """What is moved in the picture, and what is not."""
    several = len(parts.joints) > 1
    told = "Each joint turns by itself, all by the same angle or to their stops; " if several else ""
    told += "slack straps are drawn as elasticas between pegs that turn freely, taut ones with their own thickness."
    told = told[:1].upper() + told[1:]
    if record is not None:
        told += (
            " The simulated run moves bars without thickness: where solids would touch, they pass through one another."
        )
    return paragraph(told, "note")


def _bill(parts: PartSet) -> str:
    """Every part with what it is made of, in the order in which the script has them."""
    masses = part_masses(parts)
    rows: list[list[str | Cell]] = [
        [
            Cell(text=part.name, note=f"{material_text(part)}{', bought' * (not part.printed)}, {size_text(part)} mm"),
            str(part.count),
            mass_text(masses[part.name]),
        ]
        for part in parts.parts
    ]
    if not rows:
        return ""
    mass = total_mass(parts)
    foot = paragraph(f"Mass of all: {mass_text(mass)}. Sizes are of parts as they lie on the printer.")
    bill = table("What to print, and what to buy", ("part", "count", "mass of one"), rows)
    return section("Bill of materials", bill, foot, name="bill")


def _links(files: Sequence[str]) -> str:
    """Links to files beside the page."""
    items = "".join(f'<li><a href="{escaped(quote(name))}">{escaped(name)}</a></li>' for name in files)
    return section("Files", f'<ul class="files">{items}</ul>', name="files") if items else ""


def _drawn(sheet: CutSheet | None) -> str:
    """The drawing of the sheet, within the page, with what its lines mean."""
    if sheet is None:
        return ""
    across, upwards = MILLIMETRES * sheet.size
    size = f"The finished sheet is {across:.1f} mm × {upwards:.1f} mm."
    legend = remarks([size, *(text for text in layer_texts(sheet).values()), *sheet.notes])
    drawing = f'<div class="sheet" role="img" aria-label="{escaped(f"The lines of the cutter. {size}")}">'
    return f"{drawing}{sheet_svg(sheet)}</div>{legend}"


def _check_table(checks: Sequence[Check]) -> str:
    """What is checked, what fails first."""
    order = {False: 0, None: 1, True: 2}
    rows: list[list[str | Cell]] = [
        [
            Cell(text=f"{check.name}, {check.part}" if check.part else check.name, note=check.text),
            Cell(text=_WORDS[check.ok], marked=check.ok is False, failed=check.ok is False),
            value_text(check.value, check.unit),
            value_text(check.limit, check.unit),
        ]
        for check in sorted(checks, key=lambda check: order[check.ok])
    ]
    if not rows:
        return ""
    return table("What fails comes first", ("check", "result", "found", "limit"), rows, numbers=False)


def _honest() -> list[str]:
    """What the checks rest on, and what nobody has looked at."""
    return [
        paragraph("Checked, on the computer alone:"),
        remarks(_CHECKED),
        paragraph("Not checked:"),
        remarks(_UNCHECKED),
    ]


def _every_value(parts: PartSet) -> str:
    """The design's values, folded away: they are many, and most are told above."""
    return f"<details><summary>Every value</summary>{''.join(design_tables(parts.design))}</details>"
