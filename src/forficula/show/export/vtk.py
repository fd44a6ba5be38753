"""A series of VTK files for ParaView: one .vtu file for each frame, by meshio, and a .pvd file with their times."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics import Record
from forficula.optional_module import optional_module
from forficula.show.export.scene import sampled, sampled_points
from forficula.show.structure.drawn_polygons import drawn_pieces, plate_polygons
from forficula.structure import Bar, Spring, Structure, Tendon, built_points, facet_triangles
from forficula.structure.membrane_stress import principal_strains, principal_stresses

_SERIES = ("tendon_energy", "tendon_pull", "spring_force", "spring_energy")


def meshio_module() -> Any:
    """Return meshio.

    Raises:
        InputError: it is not installed.
    """
    return optional_module("meshio", "vtk needs meshio", "forficula[export]")


def write_vtk(record: Record, times: Array, folder: Path, stem: str) -> None:
    """Write a .pvd file and, in a folder of the same name, a .vtu file for each time.

    Points are in the order of the record, in m with z up. Cells have the part to which they belong. Triangles of
    membranes have their largest principal Green strain and second Piola-Kirchhoff stress (Pa) and their energy density
    (J/m^3). Tendons and springs have energy (J) and, where the record has it, force (N); springs with a cross-section
    have stress (Pa). Values that do not exist for a cell are nan.

    Args:
        record: the run.
        times: times of the frames, s.
        folder: folder for the .pvd file.
        stem: name of the .pvd file without its ending.
    """
    meshio = meshio_module()
    structure = record.structure
    triangles, owners = _triangles(structure, record.triangles)
    lines, kinds = _lines(structure)
    points = sampled_points(record, times)
    (folder / stem).mkdir()
    names = [f"{stem}/{number:04d}.vtu" for number in range(len(times))]
    rows = {name: sampled(record, name, times) for name in _SERIES if name in record.series}
    for number, name in enumerate(names):
        values = dict(_membrane_values(structure, record.triangles, points[number]))
        cell_values: dict[str, tuple[Array, Array]] = {
            "part": (owners, kinds),
            **{key: (_padded(value, len(triangles)), np.full(len(lines), np.nan)) for key, value in values.items()},
            **{
                key: (np.full(len(triangles), np.nan), value)
                for key, value in _line_values(structure, {series: rows[series][number] for series in rows}).items()
            },
        }
        used = [place for place, block in enumerate((triangles, lines)) if len(block)]
        cells = [(("triangle", "line")[place], (triangles, lines)[place]) for place in used]
        data = {key: [blocks[place] for place in used] for key, blocks in cell_values.items()}
        meshio.write(folder / name, meshio.Mesh(points[number], cells, cell_data=data), binary=True)
    steps = "".join(
        f'    <DataSet timestep="{float(time)!r}" part="0" file={quoteattr(name)}/>\n'
        for time, name in zip(times, names, strict=True)
    )
    text = f'<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n  <Collection>\n{steps}  </Collection>\n'
    (folder / f"{stem}.pvd").write_text(f"{text}</VTKFile>\n", encoding="utf-8", newline="\n")


PARTS = {"membrane": 0, "facet": 1, "plate": 2, "bar": 3, "tendon": 4, "spring": 5}


def _padded(values: Array, count: int) -> Array:
    return np.concatenate([values, np.full(count - len(values), np.nan)])


def _triangles(structure: Structure, membrane: Indices) -> tuple[Indices, Array]:
    """Return all triangles, those of membranes first, and the part of each."""
    first = len(structure.points)
    blocks, owners = [membrane + first], [PARTS["membrane"]] * len(membrane)
    if not structure.membranes:
        facets, _ = facet_triangles(structure)
        blocks.append(facets)
        owners += [PARTS["facet"]] * len(facets)
    for plate in structure.plates:
        pieces = [
            (polygon[piece[0]], polygon[one], polygon[other])
            for polygon in plate_polygons(plate, built_points(structure))
            for piece in drawn_pieces(built_points(structure)[list(polygon)])
            for one, other in pairwise(piece[1:])
        ]
        blocks.append(np.array(pieces, dtype=np.int64).reshape(-1, 3))
        owners += [PARTS["plate"]] * len(pieces)
    return np.concatenate(blocks).reshape(-1, 3), np.array(owners, dtype=np.float64)


def _lines(structure: Structure) -> tuple[Indices, Array]:
    """Return bars, tendons and springs as lines, and the part of each."""
    groups: dict[str, Sequence[Bar | Tendon | Spring]] = {
        "bar": structure.bars,
        "tendon": structure.tendons,
        "spring": structure.springs,
    }
    ends = [part.points for parts in groups.values() for part in parts]
    kinds = [float(PARTS[name]) for name, parts in groups.items() for _ in parts]
    return np.array(ends, dtype=np.int64).reshape(-1, 2), np.array(kinds)


def _line_values(structure: Structure, rows: dict[str, Array]) -> dict[str, Array]:
    """Return values of bars, tendons and springs, (line,) each."""
    bars, tendons, springs = (len(parts) for parts in (structure.bars, structure.tendons, structure.springs))
    none = np.full(bars, np.nan)

    def joined(of_tendons: Array | None, of_springs: Array | None) -> Array:
        return np.concatenate(
            [
                none,
                np.full(tendons, np.nan) if of_tendons is None else of_tendons,
                np.full(springs, np.nan) if of_springs is None else of_springs,
            ]
        )

    values = {"line energy (J)": joined(rows.get("tendon_energy"), rows.get("spring_energy"))}
    force = rows.get("spring_force")
    if force is not None or "tendon_pull" in rows:
        values["line force (N)"] = joined(rows.get("tendon_pull"), force)
    areas = np.array([spring.area for spring in structure.springs])
    if force is not None and (areas > 0).any():
        stress = np.divide(force, areas, out=np.full(springs, np.nan), where=areas > 0)
        values["line stress (Pa)"] = joined(None, stress)
    return values


def _membrane_values(structure: Structure, triangles: Indices, points: Array) -> Iterator[tuple[str, Array]]:
    """Yield strain, stress and energy density of the membranes' triangles, (triangle,) each."""
    if not len(triangles):
        return
    built = np.concatenate([membrane.built for membrane in structure.membranes])
    now = points[len(structure.points) :]
    strain = principal_strains(built[triangles], now[triangles])
    stress = principal_stresses(structure.membranes[0].law, strain)
    yield "largest principal strain", strain[..., -1]
    yield "largest principal stress (Pa)", stress[..., -1]
    yield "energy density (J/m^3)", np.asarray(np.sum(stress * strain, axis=-1) / 2)
