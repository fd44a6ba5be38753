"""Commands about materials, and tendons made of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from forficula.errors import InputError
from forficula.options import (
    DesignName,
    OpenReport,
    Out,
    OutIfGiven,
    Settings,
    check_folder,
    finish_folder,
    note_replaced,
    read_option,
    read_quantity,
    read_settings,
    read_stiffnesses,
)
from forficula.terminal import set_result


def material(
    *files: Annotated[str, Parameter(help="Files of a testing machine, each with one or more specimens.")],
    length: Annotated[
        str | None, Parameter(help='Length of every specimen, such as "60 mm", where the files do not state it.')
    ] = None,
    area: Annotated[
        str | None,
        Parameter(help='Cross-section of every specimen, such as "5 mm^2", where the files do not state it.'),
    ] = None,
    width: Annotated[
        str | None,
        Parameter(help='Folding tests: length of every crease, such as "20 mm", where the files do not state it.'),
    ] = None,
    thickness: Annotated[
        str | None, Parameter(help='Folding tests: thickness of every strip, such as "0.1 mm".')
    ] = None,
    lever: Annotated[
        str | None,
        Parameter(help='Folding tests with a travel or a force: distance of the force from the crease, "30 mm".'),
    ] = None,
    law: Annotated[
        str | None,
        Parameter(
            help="Fit only this law: linear, polynomial, kelvin-voigt, zener, prony or softening. By default all are"
            " fitted, and an information criterion selects one."
        ),
    ] = None,
    keep_first: Annotated[
        bool, Parameter(help="Include the first cycle of every specimen in the fit.", negative=())
    ] = False,
    band: Annotated[str, Parameter(help="Ignore reversals of the extension below this share of its range.")] = "5 %",
    out: Annotated[Out, Parameter(help="Output folder; its name is the name of the material.")] = Path("out/material"),
    open_report: OpenReport = False,
) -> None:
    """Fit a law for tendons to tensile tests, or a law for creases to folding tests of strips.

    Files with a column of angles or moments are folding tests; with --width, --thickness or --lever all files are.
    """
    from forficula.material.characterisation import AREA, BAND_SHARE, LENGTH, characterise
    from forficula.material.law.law_family import family_forms
    from forficula.material.machine.specimen_files import is_folding, read_specimens

    strip = {"width": width, "thickness": thickness, "lever": lever}
    if any(strip.values()) or is_folding(files):
        for name, value in (("length", length), ("area", area), ("law", law), ("keep-first", keep_first or None)):
            if value is not None:
                raise InputError(f"--{name}: is for tensile tests; these are folding tests")
        _crease(files, strip, out, show=open_report)
        return
    check_folder(out, "material")
    forms = None if law is None else read_option("--law", lambda: family_forms(law))
    read = read_specimens(
        files,
        length=None if length is None else read_quantity("--length", length, LENGTH),
        area=None if area is None else read_quantity("--area", area, AREA),
    )
    share = read_quantity("--band", band, BAND_SHARE)
    result = characterise(
        read.tests, name=out.resolve().name, source=read.source, drop_first=not keep_first, band=share, forms=forms
    )
    note_replaced(out, "material")

    from forficula.show.folder.material_folder import LAW_FILE, write_material
    from forficula.show.material.material_table import print_material

    print_material(result)
    write_material(result, out)
    if result.law is not None:
        print(f'use the law in a design with --set tendon.law="{out / LAW_FILE}" and --set tendon.area="5 mm^2"')
    finish_folder(out, "material", show=open_report)


def _crease(files: Sequence[str], strip: Mapping[str, str | None], out: Path, *, show: bool) -> None:
    """Fit a law for creases to folding tests."""
    from forficula.material.folding.crease_characterisation import characterise_crease
    from forficula.material.machine.specimen_files import read_strips
    from forficula.material.tensile.tensile_test import UNITS
    from forficula.show.folder.crease_folder import CREASE_LAW_FILE, write_crease
    from forficula.show.material.crease_table import print_crease

    check_folder(out, "law of creases")
    sizes = {key: read_quantity(f"--{key}", text, UNITS[key]) for key, text in strip.items() if text is not None}
    read = read_strips(files, **sizes)
    result = characterise_crease(read.tests, name=out.resolve().name, source=read.source)
    note_replaced(out, "law of creases")
    print_crease(result)
    write_crease(result, out)
    print(f'use the law in a design with --set crease.law="{out / CREASE_LAW_FILE}"')
    finish_folder(out, "law of creases", show=show)


def materials(
    name: Annotated[str, Parameter(help="Show the values and sources of this law of creases, or law file.")] = "", /
) -> None:
    """List the named materials of tendons and laws of creases with their sources."""
    from forficula.material.law.crease_law_file import load_crease_law, named_crease_laws
    from forficula.material.law.law_file import named_laws

    if name:
        from forficula.show.material.crease_law_table import crease_law_json, print_crease_law

        law = load_crease_law(name)
        print_crease_law(law)
        set_result(crease_law_json(law))
        return
    laws = {"tendons": named_laws(), "creases": named_crease_laws()}
    for use, named in laws.items():
        print(f"Laws of {use}")
        for law_name, source in named.items():
            print(f"  {law_name}\n    {source}")
    set_result([{"name": law, "source": source, "for": use} for use in laws for law, source in laws[use].items()])


def size(
    design: DesignName,
    /,
    *,
    material: Annotated[str, Parameter(help="A named material, or the path of a law file (.toml).")],
    stiffness: Annotated[str, Parameter(help='Stiffness of the tendon, such as "10 N/cm" or "10..60 N/cm step 10".')],
    length: Annotated[
        str | None,
        Parameter(help="Length of the unstretched tendon; default: length of the material's specimens."),
    ] = None,
    modulus: Annotated[
        str | None, Parameter(help='Modulus to use, such as "1 MPa", for a material whose modulus is a range.')
    ] = None,
    settings: Settings = None,
    out: Annotated[OutIfGiven, Parameter(help="File for the table (.csv).")] = None,
) -> None:
    """Compute the tendon thickness for a required stiffness."""
    from forficula.analysis.sizing import size_tendons
    from forficula.design import load_design
    from forficula.files import write_text
    from forficula.material.characterisation import LENGTH
    from forficula.material.law.law_file import load_law
    from forficula.material.law.law_keys import law_unit
    from forficula.material.law.material_law import known_moduli, with_linear_modulus
    from forficula.show.material.size_table import print_sizes, sizes_csv, sizes_json

    if out is not None and out.suffix != ".csv":
        raise InputError(f"--out: need a file that ends with .csv, got {out}")
    law = load_law(material)
    if modulus is not None:
        value = read_quantity("--modulus", modulus, law_unit("modulus.linear"))
        law = read_option("--modulus", lambda: with_linear_modulus(law, value))
    elif not law.no_tendon:
        read_option("--modulus", lambda: known_moduli(law))
    natural = None if length is None else read_quantity("--length", length, LENGTH)
    sizes = size_tendons(
        load_design(design, read_settings(settings)), law, read_stiffnesses("--stiffness", stiffness), length=natural
    )
    print_sizes(law, sizes)
    set_result(sizes_json(sizes))
    if out is not None:
        write_text(out, sizes_csv(sizes))
        print(f"\nwritten to {out}")
