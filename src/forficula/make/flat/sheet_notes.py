"""Legend of the files of a cut sheet."""

from __future__ import annotations

from forficula.make.flat.cut_lines import CutSheet, layer_texts


def legend_lines(sheet: CutSheet) -> list[str]:
    """Return title, size and kerf of a sheet, what to do with each of its layers, and further notes.

    One sentence or name per line, in ASCII except for names by the user.
    """
    wide, high = (f"{1e3 * length:.2f}" for length in sheet.size)
    kerf = (
        f"lines compensate for a cutter {1e3 * sheet.kerf:g} mm wide (kerf): switch this off in your program"
        if sheet.kerf
        else "lines do not compensate for the kerf: switch this on in your program"
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
