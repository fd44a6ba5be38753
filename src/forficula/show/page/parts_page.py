"""Page of parts to make: the parts in 3-D, the bill of materials, the checks, and the sheet."""

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
    "solids at their nominal size: whether they overlap, their clearance, and where they stop",
    "straps that bend without twist, either taut or as an elastica",
    "forces by formulas for beams and columns, with the lowest strengths that data sheets report",
)
_UNCHECKED = (
    "printing: shrinkage, warping, the fit of your printer; print one joint first",
    "fatigue of hinges and straps, creep under lasting load, ageing",
    "bonding: glue between sheet and bars; layers of a print beyond the strength of the data sheet",
    "impact when a half snaps against its stop",
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
    """Write parts as one HTML file that works offline; the same parts give the same bytes.

    Args:
        parts: parts to make.
        checks: checks of these parts.
        path: path of the file.
        record: a run of the same design, to be played back.
        files: names of files beside the page, to which the page links.

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
    """Return parts as one page, as `write_parts_page` writes it; without solid parts there is no picture in 3-D."""
    title = f"{design_title(parts.design)}: parts to make"
    solid = bool(parts.parts)
    player = f'<div><div id="player"></div>{_moving_note(parts, record)}</div>' if solid else ""
    beside = f"<aside>{_bill(parts)}{_links(files)}</aside>" if solid or files else ""
    below = "".join(
        (
            section("The sheet", _drawn(parts.sheet), name="sheet"),
            section("Checks", _check_table(checks), name="checks"),
            section("Scope of the checks", *_scope_of_checks(), name="honest"),
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
    """Return a sentence on the parts and their mass."""
    sentences = [parts_text(parts)] if parts.parts else ["A sheet to cut."]
    if parts.parts:
        mass = total_mass(parts)
        sentences.append(
            f"Total mass {mass_text(mass)}." if mass is not None else "The density of a material is unknown."
        )
    return " ".join(sentences)


def _checked(checks: Sequence[Check]) -> str:
    """Return a sentence with the number of checks that fail, in red, as HTML."""
    if not checks:
        return "The parts are not checked yet; ff.make.check_parts checks them."
    failed, held = (sum(check.ok is item for check in checks) for item in (False, True))
    left = sum(check.ok is None for check in checks)
    rest = f" {left} could not be carried out." * (left > 0)
    if not failed:
        return f"All {held} checks pass.{rest}"
    several = f"{failed} of {failed + held} checks fail{'s' * (failed == 1)}; see below."
    return f"{red(several)}{rest}"


def _moving_note(parts: PartSet, record: Record | None) -> str:
    """Return a note on the motion in the picture and on what it leaves out."""
    if not parts.joints:
        return paragraph("The panels turn along the fold path of the sheet without thickness.", "note")
    several = len(parts.joints) > 1
    note = "Each joint turns independently, all by the same angle or to their stops; " if several else ""
    note += "slack straps are drawn as elasticas between pegs that turn freely, taut straps with their own thickness."
    note = note[:1].upper() + note[1:]
    if record is not None:
        note += (
            " The simulated run moves bars without thickness, so solids that would touch pass through one another here."
        )
    return paragraph(note, "note")


def _bill(parts: PartSet) -> str:
    """Return the table of parts and materials, in the order of the page's script."""
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
    foot = paragraph(f"Total mass: {mass_text(mass)}. Sizes are those of parts as they lie on the printer.")
    bill = table("Parts to print and to buy", ("part", "count", "mass of one"), rows)
    return section("Bill of materials", bill, foot, name="bill")


def _links(files: Sequence[str]) -> str:
    """Return links to files beside the page."""
    items = "".join(f'<li><a href="{escaped(quote(name))}">{escaped(name)}</a></li>' for name in files)
    return section("Files", f'<ul class="files">{items}</ul>', name="files") if items else ""


def _drawn(sheet: CutSheet | None) -> str:
    """Return the drawing of the sheet, as part of the page, with the meaning of its lines."""
    if sheet is None:
        return ""
    across, upwards = MILLIMETRES * sheet.size
    size = f"The finished sheet is {across:.1f} mm × {upwards:.1f} mm."
    legend = remarks([size, *(text for text in layer_texts(sheet).values()), *sheet.notes])
    drawing = f'<div class="sheet" role="img" aria-label="{escaped(f"The lines to cut and score. {size}")}">'
    return f"{drawing}{sheet_svg(sheet)}</div>{legend}"


def _check_table(checks: Sequence[Check]) -> str:
    """Return the table of checks, failed ones first."""
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
    return table("Failed checks come first", ("check", "result", "value", "limit"), rows, numbers=False)


def _scope_of_checks() -> list[str]:
    """Return paragraphs on the scope of the checks."""
    return [
        paragraph("Checked by computation:"),
        remarks(_CHECKED),
        paragraph("Not checked:"),
        remarks(_UNCHECKED),
    ]


def _every_value(parts: PartSet) -> str:
    """Return the table of all values of the design, collapsed."""
    return f"<details><summary>Every value</summary>{''.join(design_tables(parts.design))}</details>"
