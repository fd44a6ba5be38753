"""Files of parts, as read by independent programs."""

import io
import re
import struct
import zipfile

import lib3mf
import numpy as np
import trimesh

MODEL = "3D/3dmodel.model"


def read_three_mf(content):
    """A 3MF file in strict mode: the model, and the reader's warnings."""
    model = lib3mf.get_wrapper().CreateModel()
    reader = model.QueryReader("3mf")
    reader.SetStrictModeActive(True)
    reader.ReadFromBuffer(content)
    return model, [reader.GetWarning(number) for number in range(reader.GetWarningCount())]


def meshes_of(model):
    """Every mesh object of a 3MF file."""
    result = model.GetMeshObjects()
    while result.MoveNext():
        yield result.GetCurrentMeshObject()


def pieces_of(model):
    """Every piece on the bed of a 3MF file: its name, and its triangles in position, mm, (triangle, 3, 3)."""
    result = model.GetBuildItems()
    while result.MoveNext():
        item = result.GetCurrent()
        mesh = model.GetMeshObjectByID(item.GetObjectResource().GetResourceID())
        fields = np.array([list(row) for row in item.GetObjectTransform().Fields])
        points = np.array([list(point.Coordinates) for point in mesh.GetVertices()]) @ fields[:3] + fields[3]
        yield (
            mesh.GetName(),
            points[np.array([list(gettriangleindice.Indices) for gettriangleindice in mesh.GetTriangleIndices()])],
        )


def faults_of_three_mf(content):
    """Errors of a 3MF file, a sentence each."""
    model, warnings = read_three_mf(content)
    # the strict mode does not report them
    torn = [mesh.GetName() for mesh in meshes_of(model) if not (mesh.IsManifoldAndOriented() and mesh.IsValid())]
    return [*map(str, warnings), *(f"{name} is not manifold and oriented" for name in torn)]


def faults_of_stl(content):
    """Errors of an STL file, a sentence each."""
    mesh = trimesh.load(io.BytesIO(content), file_type="stl")
    tests = {
        "watertight": mesh.is_watertight,
        "of one winding": mesh.is_winding_consistent,
        "around a volume": mesh.is_volume,
    }
    return [f"is not {name}" for name, holds in tests.items() if not holds]


def with_a_flipped_triangle(content):
    """An STL or 3MF file with one inverted triangle."""
    if content[:2] != b"PK":
        record, at = "<12fH", 84
        values = struct.unpack_from(record, content, at)
        flipped = struct.pack(record, *values[:3], *values[3:6], *values[9:12], *values[6:9], values[12])
        return content[:at] + flipped + content[at + 50 :]
    changed = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(content)) as old, zipfile.ZipFile(changed, "w") as new:
        for name in old.namelist():
            text = old.read(name).decode()
            if name == MODEL:
                text, count = re.subn(r'v1="(\d+)" v2="(\d+)"', r'v1="\2" v2="\1"', text, count=1)
                assert count == 1
            new.writestr(name, text)
    return changed.getvalue()
