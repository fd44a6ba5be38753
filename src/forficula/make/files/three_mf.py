"""One 3MF file with all printed parts, side by side on the bed.

3MF Core Specification 1.3: a package of XML in a ZIP file. Objects have their material as a base material. It is also
part of their names, because slicers ignore base materials.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from forficula.make.solid.mesh import Mesh

_CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
_TYPES = """\
<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
"""
_RELATIONS = """\
<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="model" Target="/3D/3dmodel.model" \
Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
"""
# the earliest date of ZIP files, so that the same parts always give the same bytes
_DATE = (1980, 1, 1, 0, 0, 0)
# colours in which slicers and viewers display materials, in turn; from Okabe and Ito, without black
_COLOURS = ("#56B4E9", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#0072B2")
# mm, between parts, for brims and fingers
GAP = 5.0
# mm, width of a common printer's bed; a longer part makes it wider
BED = 220.0


@dataclass(frozen=True, kw_only=True, eq=False)
class Item:
    """A printed part and its number of copies.

    Attributes:
        name: name of the part.
        material: material of the part.
        mesh: in print orientation, smallest x, y and z 0, mm.
        count: number of copies.
    """

    name: str
    material: str
    mesh: Mesh
    count: int = 1


def three_mf_bytes(items: Sequence[Item], title: str) -> bytes:
    """Return printed parts as a 3MF file, in mm, each copy at its own position on the bed; always the same bytes."""
    materials = list(dict.fromkeys(item.material for item in items))
    model = "\n".join([*_head(title, materials), *_objects(items, materials), *_build(items), "</model>", ""])
    package = io.BytesIO()
    with zipfile.ZipFile(package, "w", zipfile.ZIP_DEFLATED) as file:
        for name, text in (
            ("[Content_Types].xml", _TYPES),
            ("_rels/.rels", _RELATIONS),
            ("3D/3dmodel.model", model),
        ):
            entry = zipfile.ZipInfo(name, _DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            # fixed attributes, because the defaults depend on the operating system
            entry.create_system, entry.external_attr = 3, 0o644 << 16
            file.writestr(entry, text.encode())
    return package.getvalue()


def _head(title: str, materials: Sequence[str]) -> list[str]:
    """Return the lines before the objects. The base materials have the id 1."""
    return [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<model unit="millimeter" xml:lang="en-US" xmlns="{_CORE}">',
        f'<metadata name="Title">{_text(title)}</metadata>',
        '<metadata name="Application">forficula</metadata>',
        "<resources>",
        '<basematerials id="1">',
        *(
            f'<base name={quoteattr(name)} displaycolor="{_COLOURS[number % len(_COLOURS)]}"/>'
            for number, name in enumerate(materials)
        ),
        "</basematerials>",
    ]


def _objects(items: Sequence[Item], materials: Sequence[str]) -> list[str]:
    """Return the lines of the meshes, with ids from 2."""
    lines = []
    for number, item in enumerate(items, 2):
        name, material = quoteattr(f"{item.name}, {item.material}"), materials.index(item.material)
        lines += [
            f'<object id="{number}" type="model" name={name} pid="1" pindex="{material}">',
            "<mesh>",
            "<vertices>",
        ]
        lines += [f'<vertex x="{x:.7g}" y="{y:.7g}" z="{z:.7g}"/>' for x, y, z in item.mesh.points.tolist()]
        lines += ["</vertices>", "<triangles>"]
        lines += [f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in item.mesh.triangles.tolist()]
        lines += ["</triangles>", "</mesh>", "</object>"]
    return [*lines, "</resources>"]


def _build(items: Sequence[Item]) -> list[str]:
    """Return the lines that place every copy on the bed."""
    pieces = [(number, item) for number, item in enumerate(items, 2) for _ in range(item.count)]
    positions = places_on_bed([np.ptp(item.mesh.points, axis=0)[:2].tolist() for _, item in pieces])
    return [
        "<build>",
        *(
            f'<item objectid="{number}" transform="1 0 0 0 1 0 0 0 1 {x:.7g} {y:.7g} 0"/>'
            for (number, _), (x, y) in zip(pieces, positions.tolist(), strict=True)
        ),
        "</build>",
    ]


def _text(text: str) -> str:
    return quoteattr(text)[1:-1]


def places_on_bed(sizes: Sequence[Sequence[float]], gap: float = GAP, bed: float = BED) -> NDArray[np.float64]:
    """Return the smallest corners of boxes on shelves one behind the other, deepest boxes first, mm, (box, 2).

    The packing is not the tightest, and the depth of the bed is not limited, because pieces can be moved in the slicer.

    Args:
        sizes: sizes of the boxes along x and y, mm.
        gap: between any two, mm.
        bed: width of the shelves, mm; a longer box makes them wider.

    >>> places_on_bed([(100, 10), (100, 20), (100, 10)]).tolist()
    [[105.0, 0.0], [0.0, 0.0], [0.0, 25.0]]
    """
    places = np.zeros((len(sizes), 2))
    wide = max([bed, *(float(size[0]) for size in sizes)])
    # of every shelf: its front, and the end of its occupied part
    starts: list[float] = []
    occupied: list[float] = []
    end = 0.0
    for number in sorted(range(len(sizes)), key=lambda box: (-sizes[box][1], -sizes[box][0], box)):
        length, width = sizes[number][:2]
        shelf = next((index for index, x in enumerate(occupied) if x + length <= wide), len(occupied))
        if shelf == len(occupied):
            starts.append(end)
            occupied.append(0.0)
            end += width + gap
        places[number] = occupied[shelf], starts[shelf]
        occupied[shelf] += length + gap
    return places
