"""Names of columns in the files of testing machines, in several languages."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from functools import cache
from typing import Literal

from forficula.errors import InputError
from forficula.material.machine.machine_units import is_unit
from forficula.quantities import as_written

# Names for each role, the better choice first: a travel relative to the specimen's length comes before a strain, which
# may refer to another gauge length, and both come before a position of the crosshead.
ROLES: dict[str, tuple[str, ...]] = {
    "time": (
        *("Prüfzeit", "Test time", "Time", "Zeit", "Elapsed time", "Running time", "Total time", "Versuchszeit"),
        *("Temps", "Temps de test", "System time sensor", "Systemzeit", "Time measurement", "t"),
    ),
    "travel": (
        *("Standardweg", "Standard travel", "Course standard", "Extension", "Tensile extension", "Verfahrweg"),
        *("Zugverlängerung", "Verlängerung", "Ausdehnung", "Displacement", "Tensile displacement", "Weg", "Travel"),
        *("Elongation", "Längenänderung", "Verformung", "Deformation", "Allongement", "Déplacement", "Stroke"),
        *("Standard extensometer", "Traversenweg", "Crosshead travel", "Crosshead displacement", "Crosshead"),
        *("Dehnung", "Strain", "Tensile strain", "Tensile strain (Extension)", "Nominelle Dehnung", "Nominal strain"),
        *("Zugdehnung", "Zugdehnung (Verlängerung)", "Strain / Deformation", "Engineering strain", "Déformation"),
    ),
    "position": (
        *("Traversenweg absolut", "Absolute crosshead travel", "Crosshead absolute", "Crosshead position"),
        *("Traverse absolue", "Course traverse absolue", "Traverse abs", "Position"),
    ),
    "force": (
        *("Standardkraft", "Standard force", "Kraft", "Force", "Load", "Last", "Prüfkraft", "Test force", "Zugkraft"),
        *("Tensile force", "Standard load cell", "Force standard", "Charge", "F", "Spannung", "Zugspannung", "Stress"),
        *("Primary load measurement", "Tensile stress", "Engineering stress", "Contrainte"),
    ),
}
_ANGLES = (
    *("Fold angle", "Folding angle", "Angle", "Bending angle", "Angle of rotation", "Rotation", "Twist angle"),
    *("Faltwinkel", "Biegewinkel", "Winkel", "Drehwinkel", "Verdrehwinkel", "Angle de pliage", "Angle de rotation"),
)
_MOMENTS = (
    *("Bending moment", "Folding moment", "Moment", "Torque", "Standard torque", "Biegemoment", "Drehmoment"),
    *("Faltmoment", "Standardmoment", "Moment de flexion", "Couple", "Moment per width", "Torque per width"),
)
# kind of test: a stretched specimen, or a strip that is folded at a crease
Test = Literal["tensile", "folding"]
# of a folding test, "travel" is an angle or else a travel of the machine, and "force" a moment or else a force
_ROLES: dict[Test, dict[str, tuple[str, ...]]] = {
    "tensile": ROLES,
    "folding": {
        "time": ROLES["time"],
        "travel": (*_ANGLES, *ROLES["travel"]),
        "position": ROLES["position"],
        "force": (*_MOMENTS, *ROLES["force"]),
    },
}
_ORDINARY: dict[Test, dict[str, str]] = {
    "tensile": {"time": "Time or Prüfzeit", "travel": "Extension or Standardweg", "force": "Load or Standardkraft"},
    "folding": {"travel": "Angle, or Extension or Standardweg", "force": "Moment, or Load or Standardkraft"},
}
_BRACKETED = re.compile(r"(.*?)[\s,_]*(?:\[([^\]]*)\]|\(([^)]*)\)|<([^>]*)>)\s*")
_APPENDED = re.compile(r"(.*?\S)(?:\s+in\s+|\s*/\s*|\s*,\s*|_|\s+)([^\s_,/]+(?:/[^\s_,/]+)?)\s*")


def name_key(name: str) -> str:
    """Return a name in the form in which names are compared: without case, punctuation and variants of umlauts."""
    text = re.sub(r"[^\x00-\x7f]+|[aou]e|\?+", "\N{INVERTED QUESTION MARK}", name.lower())
    return " ".join(re.sub(r"[^\w\N{INVERTED QUESTION MARK}]+|_+", " ", text).split())


def all_keys(name: str) -> tuple[str, str]:
    """Return the keys of a known name: with its umlauts, and with the dots of umlauts left out."""
    stripped = "".join(letter for letter in unicodedata.normalize("NFKD", name) if not unicodedata.combining(letter))
    return name_key(name), name_key(stripped)


@cache
def _rank(test: Test, role: str) -> dict[str, int]:
    """Return the known keys of a role with their ranks, 0 for the best choice."""
    return {key: rank for rank, name in reversed([*enumerate(_ROLES[test][role])]) for key in all_keys(name)}


def choose_columns(names: Sequence[str], test: Test = "tensile") -> dict[str, int]:
    """Find the columns that a test needs. A folding test may lack a time.

    Args:
        names: names of the columns, without units.
        test: kind of the test.

    Returns:
        The number of the best column for each of "time", "travel" or else "position", and "force".

    Raises:
        InputError: a role has no column, or two columns have the same name.
    """
    keys, columns = [name_key(name) for name in names], {}
    for role in _ROLES[test]:
        known = [(_rank(test, role)[key], column) for column, key in enumerate(keys) if key in _rank(test, role)]
        if known and not (role == "position" and "travel" in columns):
            column = min(known)[1]
            if keys.count(keys[column]) > 1:
                raise InputError(f"two columns are named {as_written(names[column])}; leave one of them out")
            columns[role] = column
    for role, examples in _ORDINARY[test].items():
        if role not in columns and not (role == "travel" and "position" in columns):
            shown = ", ".join(as_written(name) for name in names if name) or "none"
            raise InputError(f"need a column of {role}, such as {examples}, got {shown}")
    return columns


def columns_by_specimen(names: Sequence[str], test: Test = "tensile") -> list[dict[str, int]]:
    """Find the columns of every specimen in a table with specimens side by side.

    Force and travel have to be repeated under the same names for every specimen. Time may be shared by all of them.

    Args:
        names: of the columns, without their units.
        test: kind of the test.

    Returns:
        For each specimen the columns as `choose_columns` returns them; one entry where nothing is repeated.

    Raises:
        InputError: what `choose_columns` raises, or a name is repeated less often than another.
    """
    keys = [name_key(name) for name in names]
    first = choose_columns(
        [name if keys.index(key) == place else "" for place, (name, key) in enumerate(zip(names, keys, strict=True))],
        test,
    )
    counts = {role: keys.count(keys[column]) for role, column in first.items()}
    specimens = counts["force"]
    travel = counts["travel" if "travel" in counts else "position"]
    if specimens == 1 or travel != specimens or counts.get("time", 1) not in (1, specimens):
        return [choose_columns(names, test)]
    places = {role: [place for place, key in enumerate(keys) if key == keys[column]] for role, column in first.items()}
    return [
        {role: of_role[specimen if len(of_role) > 1 else 0] for role, of_role in places.items()}
        for specimen in range(specimens)
    ]


def split_unit(text: str) -> tuple[str, str]:
    """Split a name and its unit: "Kraft [kN]", "Force (N)", "force_N", "Weg in mm", "F / N".

    Returns:
        The name and the unit, "" without a unit. Text in round or angle brackets that is not a unit belongs to the
        name, as in "Tensile strain (Extension)"; square brackets always contain a unit.
    """
    if bracketed := _BRACKETED.fullmatch(text):
        square = bracketed[2] is not None
        unit = next(group for group in bracketed.groups()[1:] if group is not None).strip()
        if square or is_unit(unit):
            return bracketed[1].strip(), unit
    else:
        appended = _APPENDED.fullmatch(text)
        if appended and not is_role(text) and appended[2] not in ("1", "-") and is_unit(appended[2]):
            return appended[1].strip(), appended[2]
    return text.strip(), ""


def is_angle(name: str) -> bool:
    """Return whether a column has the name of an angle, so that a length cannot be its unit."""
    return name_key(name) in _keys(_ANGLES)


def is_moment(name: str) -> bool:
    """Return whether a column has the name of a moment, so that a force cannot be its unit."""
    return name_key(name) in _keys(_MOMENTS)


@cache
def _keys(names: Sequence[str]) -> frozenset[str]:
    return frozenset(key for name in names for key in all_keys(name))


def is_role(name: str, test: Test = "tensile") -> bool:
    """Return whether a name is a known name of a role."""
    return any(name_key(name) in _rank(test, role) for role in _ROLES[test])
