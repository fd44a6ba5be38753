"""Modelling assumptions of a design, and variants of a design in which one of them is changed.

Only the list `ASSUMPTIONS` determines which keys of a design state an assumption. An assumption applies to every design
that has its key, whatever its structure is.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from forficula.analysis.scales import scale_of
from forficula.design import TORQUE, Design, key_value, put, stage_drives
from forficula.design.files.keys import is_key
from forficula.dynamics.stepping.timestep import resolving_timestep
from forficula.errors import InputError
from forficula.material.law.crease_law_file import CREASE_MOMENT
from forficula.material.law.law_file import load_law
from forficula.material.law.material_law import area_for
from forficula.names import one_of
from forficula.quantities import as_written, show_quantity, show_value
from forficula.structure import structure_of
from forficula.study.running.second_runs import half_step

# [chosen] rise time of a slow torque in units of the structure's time scale t*; 0.2 s for binder2025. Without a tendon
# or spring that defines t*, it is this fraction of the shortest time limit of a driven stage, here again 0.2 s.
_SLOW, _SHARE = 120, 0.2
# [chosen] as in binder2025-built: TPU and PETG by their data sheets, air at 20 deg C
_TPU, _AIR = 1200.0, {"medium.density": 1.2, "medium.viscosity": 1.8e-5}
_TENDON_LAW = "tpu-82a"
# [chosen] mass of a hinge as a fraction of the mass of a plain distal bar: 1.4 g of 2.5 g in binder2025-built
_HINGE_SHARE = 0.56
# [chosen] m, from a bar's surface to the middle of the strap on it: 3.1 mm above the axis of a bar of 5 mm
_STRAP = 0.6e-3
# [chosen] dry friction as a fraction of the smallest torque of the protocol: that of a pin of 2 mm with a coefficient
# of 0.3 under forces of a few newtons; in creases as a fraction of the moment of their springs at a fold of 90 deg
_FRICTION_SHARE = 0.05
_GRAVITY = 9.81  # m/s^2

_OF_HINGES = re.compile(r"(hinge|crease(\.group\.\d+)?)\.(damping|extension_damping)")
_OF_OTHERS = re.compile(r"tendon(\.\d+)?\.damping|membrane\.damping|facet\.stretch_damping")
_FRICTION = re.compile(r"hinge\.friction|crease(\.group\.\d+)?\.friction")
_OFFSETS = ("tendon.proximal_offset", "tendon.distal_offset")


@dataclass(frozen=True, kw_only=True)
class Variant:
    """A design with one modelling assumption changed.

    Attributes:
        label: the changed assumption, such as "torques rise over 0.2 s".
        design: design with the change.
    """

    label: str
    design: Design


@dataclass(frozen=True, kw_only=True)
class Assumption:
    """A modelling assumption that can be changed.

    Attributes:
        name: such as "slow rise".
        meaning: the assumption of the design and the changed assumption, in a sentence.
        change: returns the design with the change, or a clause that says why the assumption does not apply.
    """

    name: str
    meaning: str
    change: Callable[[Design], Variant | str]


def variant_of(assumption: Assumption, design: Design) -> Variant | str:
    """Return a design with a changed assumption, or a clause that says why the assumption does not apply."""
    try:
        variant = assumption.change(design.settled())
    except InputError as error:
        return str(error).removeprefix(f"{design.name}: ")
    if isinstance(variant, Variant):
        if idle := [text for text in variant.design.settled().idle if text not in design.idle]:
            return idle[0]
        if variant.design.hash == design.hash:
            return "the change has no effect on the design"
    return variant


def _values(tables: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Yield every value of a design with its dotted key; entries of a list have a number in the key."""
    for name, value in tables.items():
        if isinstance(value, Mapping):
            yield from _values(value, f"{prefix}{name}.")
        elif isinstance(value, list) and all(isinstance(item, Mapping) for item in value):
            for number, entry in enumerate(value):
                yield from _values(entry, f"{prefix}{name}.{number}.")
        else:
            yield f"{prefix}{name}", value


def _has(design: Design, key: str) -> bool:
    return is_key(key, type(design))


def _value(design: Design, key: str) -> Any:
    """Return the value of a key; None if the design does not have the key."""
    try:
        return key_value(design, key) if _has(design, key) else None
    except InputError:  # an optional section without defaults
        return None


def _scaled(design: Design, keys: re.Pattern[str], factor: float, what: str) -> Variant | str:
    """Scale every value other than 0 whose key matches."""
    values = {key: value for key, value in _values(design.si_tables()) if value and keys.fullmatch(key)}
    if not values:
        return f"the design has no {what}"
    label = f"{'half' if factor < 1 else 'twice'} the {what}"
    return Variant(label=label, design=design.with_values({key: factor * value for key, value in values.items()}))


def _slow_rise(design: Design) -> Variant | str:
    limits = [stage.time_limit for stage in design.protocol.stages if stage_drives(stage)]
    if not limits:
        return "the protocol drives nothing"
    scale = scale_of(structure_of(design))
    slow = _SLOW * scale.time if scale is not None and scale.time > 0 else _SHARE * min(limits)
    rise = float(f"{min(slow, *limits):.0e}")
    rises = _rises(design)
    slower = {key: rise for key, value in rises.items() if value < rise}
    if not slower:
        return f"the drives rise over {show_value(rise, 's')} or longer already"
    return Variant(label=f"drives rise over {show_value(rise, 's')}", design=_with_rises(design, slower, rises))


def _at_once(design: Design) -> Variant | str:
    rising = {key: 0.0 for key, value in _rises(design).items() if value}
    if not rising:
        return "the drives act at full strength at once already"
    return Variant(label="drives act at full strength at once", design=design.with_values(rising))


def _rises(design: Design) -> dict[str, float]:
    """Return the rise times of drives, s, by key: those of the drives of a sheet, or that of all drives."""
    values = dict(_values(design.si_tables()))
    common = float(values["protocol.rise"])
    drives = {key.rpartition(".")[0] for key in values if re.fullmatch(r"drive\.\d+\.kind", key)}
    if not drives:
        return {"protocol.rise": common}
    return {f"{drive}.rise": float(values.get(f"{drive}.rise", common)) for drive in sorted(drives)}


def _with_rises(design: Design, slower: Mapping[str, float], rises: Mapping[str, float]) -> Design:
    """Return the design with slower drives. Time limits of driven stages are extended by the same time."""
    longer = max(rise - rises[key] for key, rise in slower.items())
    limits = {
        f"protocol.stages.{number}.time_limit": stage.time_limit + longer
        for number, stage in enumerate(design.protocol.stages)
        if stage_drives(stage)
    }
    return design.with_values({**slower, **limits})


def _no_armature(design: Design) -> Variant | str:
    if not _value(design, "hinge.armature"):
        return "the hinges have no armature"
    return Variant(label="no armature", design=design.with_values({"hinge.armature": 0.0}))


def _tendon_height(design: Design) -> Variant | str:
    if not all(_has(design, key) for key in _OFFSETS):
        return "the tendons end at positions on facets" if _has(design, "tendon") else "the design has no tendons"
    offsets = [value for key, value in _values(design.si_tables()) if re.fullmatch(r"tendon(\.\d+)?\.\w+_offset", key)]
    if any(offsets):
        return Variant(label="tendons on the bars' axes", design=design.with_values(dict.fromkeys(_OFFSETS, 0.0)))
    height = float(_value(design, "vein.diameter")) / 2 + _STRAP
    label = f"tendons {show_value(height, 'm')} above the bars' axes"
    return Variant(label=label, design=design.with_values(dict.fromkeys(_OFFSETS, height)))


def _membrane_mass(design: Design) -> Variant | str:
    density = _value(design, "membrane.density")
    if density is None:
        return "the design has no membrane of its own"
    label, instead = ("membrane without mass", 0.0) if density else ("membrane with the mass of TPU", _TPU)
    return Variant(label=label, design=design.with_values({"membrane.density": instead}))


def _tendon_mass(design: Design) -> Variant | str:
    tables = dict(_values(design.si_tables()))
    tendons = sorted({match[1] for key in tables if (match := re.fullmatch(r"(tendon(\.\d+)?)\.density", key))})
    if not tendons:
        return "the tendons of this design have no key for a mass"
    if any(tables[f"{tendon}.density"] for tendon in tendons):
        for tendon in tendons:
            design = put(design, f"{tendon}.density", 0.0)
            if f"{tendon}.law.name" not in tables:  # an area belongs to a law or to a mass
                design = put(design, f"{tendon}.area", None)
        return Variant(label="tendons without mass", design=design)
    law, heavy = load_law(_TENDON_LAW), {}
    for tendon in tendons:
        length, stiffness = tables[f"{tendon}.rest_length"], tables.get(f"{tendon}.stiffness")
        heavy[f"{tendon}.density"] = _TPU
        if tables.get(f"{tendon}.area") is None:
            if not (length and stiffness):
                return "a tendon of no resting length or stiffness has no volume"
            heavy[f"{tendon}.area"] = area_for(law, length=length, stiffness=stiffness)
    return Variant(label="tendons with the mass of TPU", design=design.with_values(heavy))


def _hinge_mass(design: Design) -> Variant | str:
    added = _value(design, "vein.added_mass")
    if added is None:
        return "the creases of this design have no key for a mass"
    if added:
        return Variant(label="hinges without mass", design=design.with_values({"vein.added_mass": 0.0}))
    bar = float(_value(design, "vein.density")) * math.pi / 4 * float(_value(design, "vein.diameter")) ** 2
    mass = float(f"{_HINGE_SHARE * bar * float(_value(design, 'pattern.distal_length')):.2g}")
    return Variant(label=f"hinges of {1e3 * mass:.2g} g", design=design.with_values({"vein.added_mass": mass}))


def _medium(design: Design) -> Variant | str:
    if design.medium is not None:
        return Variant(label="empty space", design=design.with_values(dict.fromkeys(_AIR, 0.0)))
    return Variant(label="in air", design=design.with_values(_AIR))


def _weight(design: Design) -> Variant | str:
    if design.protocol.gravity:
        # without gravity, only a table needs its direction
        off = {"protocol.gravity": 0.0} | ({} if design.table else {"protocol.gravity_direction": "-z"})
        return Variant(label="no gravity", design=design.with_values(off))
    direction = design.protocol.gravity_direction
    label = "gravity across the sheet" if direction == "-z" else f"gravity along {direction}"
    return Variant(label=label, design=design.with_values({"protocol.gravity": _GRAVITY}))


def _dry_friction(design: Design) -> Variant | str:
    values = dict(_values(design.si_tables()))
    if rubbing := {key: 0.0 for key, value in values.items() if value and _FRICTION.fullmatch(key)}:
        return Variant(label="no dry friction", design=design.with_values(rubbing))
    if _has(design, "crease.friction"):
        moment, unit, where = math.pi / 2 * (values.get("crease.stiffness") or 0.0), CREASE_MOMENT, "crease"
        what = "creases have no stiffness, and their dry friction is a fraction of their moment"
    elif _has(design, "hinge.friction"):
        torques = [value for key, value in values.items() if re.fullmatch(r"protocol\.\w+_torque", key)]
        moment, unit, where = min((value for value in torques if value), default=0.0), TORQUE, "hinge"
        what = "protocol has no torque, and the dry friction is a fraction of the smallest torque"
    else:
        return "dry friction is only added to the hinges of fans and joints and to the creases of sheets"
    if not moment:
        return f"the {what}"
    friction = float(f"{_FRICTION_SHARE * moment:.2g}")
    label = f"dry friction of {show_quantity(friction, unit)} in every {where}"
    return Variant(label=label, design=design.with_values({f"{where}.friction": friction}))


def _contact(design: Design) -> Variant | str:
    if design.protocol.contact:
        keys = [key for key in dict(_values(design.si_tables())) if f".{key}".endswith(".contact.friction")]
        sections = {key.removesuffix(".friction"): "none" for key in keys}
        return Variant(label="no contact", design=design.with_values({"protocol.contact": False, **sections}))
    return Variant(label="contact between bodies", design=design.with_values({"protocol.contact": True}))


def _stop_time(design: Design, factor: float) -> Variant | str:
    free = design.model_copy(update={"protocol": design.protocol.model_copy(update={"contact": False})})
    if not math.isfinite(resolving_timestep(structure_of(free))):
        return "the structure has no stops that use stops.time_constant"
    label = f"stops of {'half' if factor < 1 else 'twice'} the time constant"
    return Variant(label=label, design=design.with_values({"stops.time_constant": factor * design.stops.time_constant}))


def _half_step(design: Design) -> Variant | str:
    if design.protocol.timestep == "auto":
        return "the timestep is not known before a run"
    return Variant(label="half the timestep", design=half_step(design))


def _other_start(design: Design) -> Variant | str:
    other = design.with_other_start()
    if other is None:
        return "the structure starts as it is drawn, without an imperfection to vary"
    return Variant(label="a slightly different start", design=other)


def _dampings(name: str, parts: str, keys: re.Pattern[str], label: str) -> tuple[Assumption, Assumption]:
    """Return two assumptions: a chosen viscous damping is half or twice as large."""

    def assumption(word: str, amount: str, factor: float) -> Assumption:
        return Assumption(
            name=f"{word} {name} damping",
            meaning=f"{parts} have a chosen viscous damping; instead they have {amount}.",
            change=lambda design: _scaled(design, keys, factor, label),
        )

    return assumption("half", "half of it", 0.5), assumption("twice", "twice as much", 2.0)


ASSUMPTIONS: tuple[Assumption, ...] = (
    Assumption(
        name="slow rise",
        meaning="The drives rise over the times that the design gives; instead they rise over 120 times the"
        " structure's time scale t*.",
        change=_slow_rise,
    ),
    Assumption(
        name="no rise",
        meaning="The drives rise over a time; instead they act at full strength at once.",
        change=_at_once,
    ),
    Assumption(
        name="armature",
        meaning="Motors add inertia to every hinge; instead they add none.",
        change=_no_armature,
    ),
    *_dampings("hinge", "Hinges and creases", _OF_HINGES, "damping of hinges"),
    *_dampings("other", "Tendons, membranes and facets", _OF_OTHERS, "damping of tendons and sheets"),
    Assumption(
        name="tendon height",
        meaning="Tendons act in the plane of the bars' axes; instead they lie on the bars, or the inverse.",
        change=_tendon_height,
    ),
    Assumption(
        name="membrane mass",
        meaning="The membrane has no mass; instead it has that of TPU, or the inverse.",
        change=_membrane_mass,
    ),
    Assumption(
        name="tendon mass",
        meaning="The tendons have no mass; instead they have that of straps of TPU, or the inverse.",
        change=_tendon_mass,
    ),
    Assumption(
        name="hinge mass",
        meaning="The hinges have no mass; instead each has 0.56 times the mass of a distal bar, or the inverse.",
        change=_hinge_mass,
    ),
    Assumption(
        name="medium",
        meaning="The structure moves in empty space; instead it moves in air, or the inverse.",
        change=_medium,
    ),
    Assumption(
        name="gravity",
        meaning="There is no gravity; instead gravity acts across the sheet, or the inverse.",
        change=_weight,
    ),
    Assumption(
        name="dry friction",
        meaning="Hinges and creases have viscous damping only; instead they have dry friction, too, or the inverse.",
        change=_dry_friction,
    ),
    Assumption(
        name="contact",
        meaning="Bodies pass through one another; instead they touch, or the inverse.",
        change=_contact,
    ),
    Assumption(
        name="stiffer stops",
        meaning="Stops yield with a time constant; instead they have half of this time constant.",
        change=lambda design: _stop_time(design, 0.5),
    ),
    Assumption(
        name="softer stops",
        meaning="Stops yield with a time constant; instead they have twice this time constant.",
        change=lambda design: _stop_time(design, 2.0),
    ),
    Assumption(
        name="timestep",
        meaning="The integrator uses the timestep of the design; instead it uses half of it.",
        change=_half_step,
    ),
    Assumption(
        name="start",
        meaning="The structure starts in the state that the design gives; instead it starts slightly differently.",
        change=_other_start,
    ),
)


def selected(names: Iterable[str] | None) -> tuple[Assumption, ...]:
    """Return the assumptions with these names, in the order of `ASSUMPTIONS`; for None all of them.

    Raises:
        InputError: an unknown name, or no name.
    """
    if names is None:
        return ASSUMPTIONS
    if isinstance(names, str) or not isinstance(names, Iterable):
        raise InputError(f"need a list of names of assumptions, got {as_written(names)}")
    requested, known = list(names), [assumption.name for assumption in ASSUMPTIONS]
    for name in requested:
        if name not in known:
            raise InputError(f"need {one_of(known, name)}")
    if not requested:
        raise InputError("need at least one name of an assumption, got none")
    return tuple(assumption for assumption in ASSUMPTIONS if assumption.name in requested)
