"""Parts as STEP files, by Open Cascade: a second geometry kernel, with true cylinders, for the same tree of solids."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.make.part import Part
from forficula.make.solid.mesh import MILLIMETRES
from forficula.make.solid.solids import Cut, Hull, Joined, Prism, Rod, Shared, Solid
from forficula.optional_module import optional_module
from forficula.pattern.thick.convex import convex_faces

# a fixed time, so that the same part always gives the same bytes
_TIME = "1980-01-01T00:00:00"
_GRAMS_PER_CM3 = 1e-3


def check_step() -> None:
    """Check that STEP files can be written, and otherwise say what to install.

    Raises:
        InputError: Open Cascade is not installed.
    """
    optional_module("OCP.STEPCAFControl", "STEP files need Open Cascade", "forficula[step]")


def write_step(part: Part, path: Path) -> None:
    """Write a part in its position in the flat structure, in the axes of the ground, in mm.

    The file has the part's name, its material and, if known, its density.

    Args:
        part: part to write.
        path: path of the file. It may be left incomplete after an error; the caller handles this.

    Raises:
        InputError: Open Cascade is not installed, or cannot write the file.
    """
    check_step()
    from OCP.APIHeaderSection import APIHeaderSection_MakeHeader
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.STEPCAFControl import STEPCAFControl_Writer
    from OCP.STEPControl import STEPControl_StepModelType
    from OCP.TCollection import TCollection_HAsciiString as Text

    with _silent():
        writer = STEPCAFControl_Writer()
        writer.SetNameMode(True)
        writer.SetMaterialMode(True)
        writer.Transfer(_document(part), STEPControl_StepModelType.STEPControl_AsIs)
        header = APIHeaderSection_MakeHeader(writer.ChangeWriter().Model())
        header.SetName(Text(part.name))
        header.SetTimeStamp(Text(_TIME))
        header.SetAuthorValue(1, Text(""))
        header.SetOrganizationValue(1, Text(""))
        header.SetOriginatingSystem(Text("forficula"))
        if writer.Write(str(path)) != IFSelect_ReturnStatus.IFSelect_RetDone:
            raise InputError(f"{path}: cannot be written as STEP")


def shape_of(solid: Solid) -> Any:
    """Evaluate a tree of solids with Open Cascade, mm; circles are exact.

    Raises:
        InputError: Open Cascade is not installed, or finds no result.
    """
    check_step()
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common, BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse

    match solid:
        case Rod():
            return _rod(solid)
        case Prism():
            return _prism(solid)
        case Hull():
            return _hull(solid)
        case Joined():
            return _combined(BRepAlgoAPI_Fuse(), solid.solids[:1], solid.solids[1:])
        case Shared():
            # with several tools at once, it would return the intersection with any of them
            shape = shape_of(solid.solids[0])
            for tool in solid.solids[1:]:
                shape = _operated(BRepAlgoAPI_Common(), [shape], [shape_of(tool)])
            return shape
        case Cut():
            return _combined(BRepAlgoAPI_Cut(), [solid.solid], solid.taken)


def shape_volume(shape: Any) -> float:
    """Return the volume of an evaluated solid, m^3."""
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps

    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, properties)
    return float(properties.Mass()) / MILLIMETRES**3


def shape_gap(one: Any, other: Any) -> float:
    """Return the smallest distance between two evaluated solids, m; 0 if they touch."""
    from OCP.BRepExtrema import BRepExtrema_DistShapeShape

    return float(BRepExtrema_DistShapeShape(one, other).Value()) / MILLIMETRES


def _document(part: Part) -> Any:
    """Return a document with a part, its name, material and density."""
    from OCP.TCollection import TCollection_ExtendedString as Name
    from OCP.TCollection import TCollection_HAsciiString as Text
    from OCP.TDataStd import TDataStd_Name
    from OCP.TDocStd import TDocStd_Document
    from OCP.XCAFDoc import XCAFDoc_DocumentTool

    document = TDocStd_Document(Name("part"))
    label = XCAFDoc_DocumentTool.ShapeTool_s(document.Main()).AddShape(shape_of(part.solid), False)
    TDataStd_Name.Set_s(label, Name(part.name))
    if part.stock.density is not None:
        material, density = Text(part.stock.name), part.stock.density * _GRAMS_PER_CM3
        XCAFDoc_DocumentTool.MaterialTool_s(document.Main()).SetMaterial(
            label, material, material, density, Text("density"), Text("g/cm3")
        )
    return document


def _combined(operation: Any, solids: Sequence[Solid], tools: Sequence[Solid]) -> Any:
    return _operated(operation, [shape_of(child) for child in solids], [shape_of(child) for child in tools])


def _operated(operation: Any, shapes: Sequence[Any], tools: Sequence[Any]) -> Any:
    """Return the result of a boolean operation on shapes and tools, with continuous faces united."""
    if not tools:
        return shapes[0]
    from OCP.OCP.collections import List_TopoDS_Shape

    for operands, assign in ((shapes, operation.SetArguments), (tools, operation.SetTools)):
        shape_list = List_TopoDS_Shape()
        for operand in operands:
            shape_list.Append(operand)
        assign(shape_list)
    operation.Build()
    if not operation.IsDone():
        raise InputError("Open Cascade finds no result of a boolean operation")
    operation.SimplifyResult()
    return _alone(operation.Shape())


def _alone(shape: Any) -> Any:
    """Return the only shape of a compound, or the compound if it has several."""
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopoDS import TopoDS_Iterator

    children = TopoDS_Iterator(shape)
    if shape.ShapeType() != TopAbs_ShapeEnum.TopAbs_COMPOUND or not children.More():
        return shape
    only = children.Value()
    children.Next()
    return shape if children.More() else only


def _rod(rod: Rod) -> Any:
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder
    from OCP.gp import gp_Ax2

    length = float(np.linalg.norm(rod.end - rod.start))
    axes = gp_Ax2(_point(rod.start), _direction((rod.end - rod.start) / length))
    return BRepPrimAPI_MakeCylinder(axes, rod.diameter / 2 * MILLIMETRES, length * MILLIMETRES).Shape()


def _prism(prism: Prism) -> Any:
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakePolygon
    from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
    from OCP.gp import gp_Vec

    normal = prism.frame[:, 2] * prism.height
    polygon = BRepBuilderAPI_MakePolygon()
    for corner in prism.outline @ prism.frame[:, :2].T + prism.origin - normal / 2:
        polygon.Add(_point(corner))
    polygon.Close()
    face = BRepBuilderAPI_MakeFace(polygon.Wire()).Face()
    return BRepPrimAPI_MakePrism(face, gp_Vec(*(normal * MILLIMETRES).tolist())).Shape()


def _hull(hull: Hull) -> Any:
    from OCP.BRepBuilderAPI import (
        BRepBuilderAPI_MakeFace,
        BRepBuilderAPI_MakePolygon,
        BRepBuilderAPI_MakeSolid,
        BRepBuilderAPI_Sewing,
    )
    from OCP.TopoDS import TopoDS

    sewn = BRepBuilderAPI_Sewing()
    for face in convex_faces(hull.corners):
        polygon = BRepBuilderAPI_MakePolygon()
        for corner in face:
            polygon.Add(_point(hull.corners[corner]))
        polygon.Close()
        sewn.Add(BRepBuilderAPI_MakeFace(polygon.Wire(), True).Face())
    sewn.Perform()
    return BRepBuilderAPI_MakeSolid(TopoDS.Shell(sewn.SewedShape())).Solid()


def _point(place: Array) -> Any:
    from OCP.gp import gp_Pnt

    return gp_Pnt(*(place * MILLIMETRES).tolist())


def _direction(along: Array) -> Any:
    from OCP.gp import gp_Dir

    return gp_Dir(*along.tolist())


@contextmanager
def _silent() -> Iterator[None]:
    """Suppress messages of Open Cascade on standard output."""
    from OCP.Message import Message

    messenger = Message.DefaultMessenger_s()
    printers = list(messenger.Printers())
    for printer in printers:
        messenger.RemovePrinter(printer)
    try:
        yield
    finally:
        for printer in printers:
            messenger.AddPrinter(printer)
