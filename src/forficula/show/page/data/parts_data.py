"""Data of parts for the script of their page: meshes, hinges, straps, and the motion of a run."""

from __future__ import annotations

import math
from collections import Counter
from typing import Any

import numpy as np

from forficula.analysis import measure
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.make.hinge.elastica import elastica
from forficula.make.hinge.hub import Root
from forficula.make.hinge.strap_shape import StrapPlace
from forficula.make.part import Part, PartSet
from forficula.names import listed
from forficula.show.make.part_facts import mass_text, material_text, part_masses, size_text
from forficula.show.make.part_looks import STOP_COLOUR, part_looks
from forficula.show.make.part_mesh import part_mesh
from forficula.show.make.part_poses import angle_range, apart
from forficula.show.page.data.packed_arrays import PackedArrays
from forficula.show.page.data.time_spans import run_spans, span_data
from forficula.show.page.playback import clip_data, make_clip
from forficula.structure import built_hinges

_BUDGET = 2_000_000  # bytes of the frames of a motion; the page keeps only their angles
# shapes of a slack strap, from straight to ends that coincide, and points along each shape
_BOWS, _POINTS = 33, 33


def parts_data(parts: PartSet, record: Record | None) -> dict[str, Any]:
    """Return parts as data for JSON.

    Args:
        parts: parts with at least one joint or panel.
        record: a run of the same design to play back; None for none.

    Raises:
        InputError: the record has another structure.
    """
    arrays = PackedArrays()
    looks, look_numbers = part_looks(parts)
    shifts = apart(parts)
    same: dict[str, int] = {}
    data = []
    masses = part_masses(parts)
    for part, look, shift in zip(parts.parts, look_numbers, shifts, strict=True):
        place = same.get(part.kind, 0)
        same[part.kind] = place + 1
        data.append(_part_data(parts, part, masses[part.name], arrays, place) | {"look": look, "apart": shift.tolist()})
    return {
        "kind": "parts",
        "name": parts.design.name,
        "text": parts_text(parts),
        "bodies": [body.parent for body in parts.structure.bodies],
        "parts": data,
        "looks": [{"name": look.name, "kind": look.kind, "colour": look.colour} for look in looks],
        "stopColour": STOP_COLOUR,
        "turns": _turns(parts),
        "joints": [
            {"turn": joint.hinge, "name": joint.name, "lower": joint.lower, "upper": joint.upper}
            for joint in parts.joints
        ]
        or [{"turn": 0, "name": "panels", "lower": angle_range(parts)[0], "upper": angle_range(parts)[1]}],
        "fold": None if parts.joints else _fold(parts, arrays),
        "bows": _bows(arrays),
        "motion": None if record is None else _motion(parts, record, arrays),
        "arrays": arrays.text(),
    }


def _part_data(parts: PartSet, part: Part, mass: float | None, arrays: PackedArrays, place: int) -> dict[str, Any]:
    """Return the data of a part: its facts, its body, and its mesh or the dimensions by which the script draws it."""
    data: dict[str, Any] = {
        "name": part.name,
        "count": part.count,
        "body": part.body,
        "facts": [material_text(part), mass_text(mass), f"{size_text(part)} mm"],
    }
    if part.kind == "strap":
        return data | {"strap": _strap_data(parts, parts.straps[place])}
    if part.kind == "root":
        return data | {"root": _root_data(parts.roots[place])}
    mesh = part_mesh(part, parts.joints)
    triangles = mesh.triangles.copy()
    # vertices of a triangle have similar indices, so their differences compress well
    triangles[:, 1:] -= triangles[:, :1]
    triangles[:, 1:] %= len(mesh.points)
    return data | {
        "mesh": {
            "points": arrays.places(mesh.points),
            "triangles": arrays.whole(triangles),
            "stops": mesh.stops,
            "edges": arrays.whole(mesh.edges),
        }
    }


def _turns(parts: PartSet) -> list[dict[str, Any]]:
    """Return every hinge as a rotation of its body against its parent about a line in the built shape."""
    structure = parts.structure
    origins, axes = built_hinges(structure)
    return [
        {
            "body": hinge.body,
            "parent": structure.bodies[hinge.body].parent,
            "origin": origin.tolist(),
            "axis": (hinge.sense * axis).tolist(),
            "built": hinge.built,
        }
        for hinge, origin, axis in zip(structure.hinges, origins, axes, strict=True)
        if hinge.flaps is None
    ]


def _fold(parts: PartSet, arrays: PackedArrays) -> dict[str, Any]:
    """Return the angles of all hinges along the fold path of thick panels, (pose, hinge), or as built."""
    built = np.array([[hinge.built for hinge in parts.structure.hinges]])
    return arrays.floats((built if parts.fold is None else parts.fold)[:, : len(_turns(parts))])


def _strap_data(parts: PartSet, place: StrapPlace) -> dict[str, Any]:
    joint = next(joint for joint in parts.joints if joint.tendon == place.tendon)
    return {
        "bodies": list(place.bodies),
        "ends": place.ends.tolist(),
        "across": place.across.tolist(),
        "up": place.up.tolist(),
        "axis": joint.frame[:, 1].tolist(),
        "width": place.strap.width,
        "thickness": place.strap.thickness,
        "rest": place.strap.rest_length,
        "eye": place.eye_diameter,
        "peg": place.peg_diameter,
    }


def _root_data(root: Root) -> dict[str, Any]:
    """Return a flexible rod: the points at which the hub holds it, where it bends, and where the bar holds it."""
    deep = 2 * root.make.root_diameter
    free = root.begins - root.make.root_length
    places = [root.at(at).tolist() for at in (free - deep, free, root.begins, root.begins + deep)]
    return {"body": root.body, "places": places, "diameter": root.make.root_diameter}


def _bows(arrays: PackedArrays) -> dict[str, Any]:
    """Return elasticas of length 1 whose ends are 1 - t^2 apart, t from 0 to 1, (bow, point, 2)."""
    shares = 1 - np.linspace(0, 1, _BOWS) ** 2
    return arrays.floats([elastica(1.0, float(share), _POINTS) for share in shares])


def _motion(parts: PartSet, record: Record, arrays: PackedArrays) -> dict[str, Any]:
    """Return the angles of all hinges over the frames of a run, with its states and stages."""
    names = [hinge.name for hinge in record.structure.hinges]
    if names != [hinge.name for hinge in parts.structure.hinges]:
        raise InputError(
            f"record: need a run of the design of the parts, {parts.design.name}, got one of"
            f" {record.design.name}, which has other hinges"
        )
    clip = make_clip(record, measure(record), budget=_BUDGET)
    played = clip_data(clip)
    angles = record.series["hinge_angle"][np.searchsorted(record.time, clip.time)]
    return {
        "time": arrays.doubles(clip.time),
        "angles": arrays.floats(angles[:, : len(_turns(parts))]),
        "name": played["name"],
        "marks": [
            {key: mark[key] for key in ("letter", "name", "time")} | {"readings": {}} for mark in played["marks"]
        ],
        "stages": played["stages"],
        "spans": [span_data(span) for span in run_spans(clip)],
        "free": [body.name for body in parts.structure.bodies if body.slides],
    }


def parts_text(parts: PartSet) -> str:
    """Return a sentence with the numbers of parts and the range of the joints."""
    counts = Counter({part.kind: 0 for part in parts.parts})
    for part in parts.parts:
        counts[part.kind] += part.count
    kinds = [f"{count} {kind}{'s' * (count != 1)}" for kind, count in counts.items()]
    low, high = angle_range(parts)
    if not parts.joints:
        return f"{listed(kinds).capitalize()}. The largest fold angle is {degrees(high)}."
    joints = f"{len(parts.joints)} joints turn" if len(parts.joints) != 1 else "The joint turns"
    return f"{listed(kinds).capitalize()}. {joints} from {degrees(low)} to {degrees(high)}."


def degrees(angle: float) -> str:
    """Return an angle, rad, as text in degrees."""
    return f"{math.degrees(angle):.4g}°".replace("-", "−")
