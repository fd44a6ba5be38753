"""What the files of a cut sheet say of themselves."""

from __future__ import annotations

from forficula.make.flat.cut_lines import CutSheet, layer_texts


def legend_lines(sheet: CutSheet) -> list[str]:
    """The title, the size and the kerf of a sheet, what is done with each of its layers, and what else is to be known.

    One sentence or name a line, in ASCII but for what the user named.
    """
    wide, high = (f"{1e3 * length:.2f}" for length in sheet.size)
    kerf = (
        f"lines make up for a cutter {1e3 * sheet.kerf:g} mm wide (kerf): switch off that of your program"
        if sheet.kerf
        else "lines make up for no kerf: let your program do so"
    )
    failed = [f"CHECK: {check.text}" for check in sheet.checks if check.ok is False]
    return [
        f"{sheet.name}: {sheet.title}" if sheet.title else sheet.name,
        f"millimetres, seen from the face; finished {wide} x {high}",
        kerf,
        *(f"layer {layer.upper()}: {text}" for layer, text in layer_texts(sheet).items()),
        "layer NOTE: these lines, not to be made",
        *sheet.notes,
        *failed,
    ]
