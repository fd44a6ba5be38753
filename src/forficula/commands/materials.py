"""Commands about materials and the tendons made of them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from forficula.errors import InputError
from forficula.options import (
    DesignName,
    Out,
    OutIfGiven,
    Settings,
    check_folder,
    read_option,
    read_quantity,
    read_settings,
    read_stiffnesses,
    tell_replaced,
    tell_written,
)
from forficula.terminal import came_to


def material(
    *files: Annotated[str, Parameter(help="Exports of a testing machine, one or more specimens each.")],
    length: Annotated[
        str | None, Parameter(help='Length of every specimen, as in "60 mm", where the files do not give it.')
    ] = None,
    area: Annotated[str | None, Parameter(help='Area of its cross-section, as in "5 mm^2", likewise.')] = None,
    law: Annotated[
        str | None,
        Parameter(
            help="Fit this law only: linear, polynomial, kelvin-voigt, zener, prony or softening; by default all are"
            " fitted, and an information criterion chooses."
        ),
    ] = None,
    keep_first: Annotated[
        bool, Parameter(help="Let the first cycle of every specimen count, too.", negative=())
    ] = False,
    band: Annotated[
        str, Parameter(help="A turn back by less of the largest travel is noise, not the end of a cycle.")
    ] = "5 %",
    out: Annotated[Out, Parameter(help="Folder for the results; the material is named after it.")] = Path(
        "out/material"
    ),
) -> None:
    """Turn tensile tests into a material: cycles, moduli, drift, and a law that a tendon can have."""
    from forficula.material.characterisation import AREA, BAND_SHARE, LENGTH, characterise
    from forficula.material.law.law_family import family_forms
    from forficula.material.machine.specimen_files import read_specimens

    check_folder(out, "material")
    forms = None if law is None else read_option("--law", lambda: family_forms(law))
    read = read_specimens(
        files,
        length=None if length is None else read_quantity("--length", length, LENGTH),
        area=None if area is None else read_quantity("--area", area, AREA),
    )
    share = read_quantity("--band", band, BAND_SHARE)
    tell_replaced(out, "material")
    found = characterise(
        read.tests, name=out.resolve().name, source=read.source, drop_first=not keep_first, band=share, forms=forms
    )

    from forficula.show.folder.material_folder import write_material
    from forficula.show.material.material_table import print_material

    write_material(found, out)
    print_material(found)
    tell_written(out, "material")


def materials() -> None:
    """List the named materials, each with its source."""
    from forficula.material.law.law_file import named_laws

    for name, source in named_laws().items():
        print(f"{name}\n    {source}")
    came_to([{"name": name, "source": source} for name, source in named_laws().items()])


def size(
    design: DesignName,
    /,
    *,
    material: Annotated[str, Parameter(help="A named material, or the path of a law file (.toml).")],
    stiffness: Annotated[str, Parameter(help='Of the tendon, as in "10 N/cm" or "10..60 N/cm step 10".')],
    length: Annotated[
        str | None, Parameter(help="Of the unstretched tendon; that of the material's specimens if not given.")
    ] = None,
    modulus: Annotated[
        str | None, Parameter(help='Modulus of a material that is known as a range only, as in "1 MPa".')
    ] = None,
    settings: Settings = None,
    out: Annotated[OutIfGiven, Parameter(help="A .csv file for the table.")] = None,
) -> None:
    """Tell how thick a tendon of a material must be to have a stiffness."""
    from forficula.analysis.sizing import size_tendons
    from forficula.design import load_design
    from forficula.files import write_text
    from forficula.material.characterisation import LENGTH
    from forficula.material.law.law_file import load_law
    from forficula.material.law.law_keys import law_unit
    from forficula.material.law.material_law import chosen, known_moduli
    from forficula.show.material.size_table import print_sizes, sizes_csv, sizes_json

    if out is not None and out.suffix != ".csv":
        raise InputError(f"--out: need a file that ends with .csv, got {out}")
    law = load_law(material)
    if modulus is not None:
        value = read_quantity("--modulus", modulus, law_unit("modulus.linear"))
        law = read_option("--modulus", lambda: chosen(law, value))
    elif not law.no_tendon:
        read_option("--modulus", lambda: known_moduli(law))
    own = None if length is None else read_quantity("--length", length, LENGTH)
    sizes = size_tendons(
        load_design(design, read_settings(settings)), law, read_stiffnesses("--stiffness", stiffness), length=own
    )
    print_sizes(law, sizes)
    came_to(sizes_json(sizes))
    if out is not None:
        write_text(out, sizes_csv(sizes))
        print(f"\nwritten to {out}")
