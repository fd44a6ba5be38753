"""The files that a characterised material leaves."""

from __future__ import annotations

import json
from pathlib import Path

from forficula.files import replacing_all, write_text
from forficula.material.characterisation import Characterisation
from forficula.material.law_file import save_law
from forficula.material.material_summary import material_summary
from forficula.show.cycles_figure import draw_cycles
from forficula.show.drift_figure import draw_drift
from forficula.show.law_figure import draw_fit
from forficula.show.modulus_figure import draw_moduli
from forficula.show.style import save_figure

LAW_FILE, FIT_FIGURE = "tendon_law.toml", "fit.png"


def write_material(material: Characterisation, folder: Path) -> None:
    """Write summary, law and figures; all of them, or none.

    Args:
        material: what to write.
        folder: made where it is missing; what an earlier material left there is replaced, its law and the figure of
            its fit removed where this one has none.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder) as unfinished:
        _write_files(material, unfinished)
    if material.law is None:
        for name in (LAW_FILE, FIT_FIGURE):
            (folder / name).unlink(missing_ok=True)


def _write_files(material: Characterisation, folder: Path) -> None:
    # what does not exist is null; not every reader of JSON knows NaN
    text = json.dumps(material_summary(material), indent=2, ensure_ascii=False, allow_nan=False)
    write_text(folder / "material.json", text + "\n")
    if material.law is not None:
        save_law(material.law, folder / LAW_FILE)
        save_figure(draw_fit(material), folder / FIT_FIGURE)
    save_figure(draw_cycles(material), folder / "cycles.png")
    save_figure(draw_moduli(material), folder / "modulus.png")
    save_figure(draw_drift(material), folder / "drift.png")
