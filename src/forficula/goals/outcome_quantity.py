"""Quantities for limits, objectives and observations: numbers of a design, of its statics and of its runs, by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

from forficula.design import Design, key_quantity, key_value
from forficula.design.section import LENGTH, MASS, TIME, TORQUE
from forficula.errors import InputError, error_prefix
from forficula.names import near_name
from forficula.quantities import Unit
from forficula.serial import unit_suffix
from forficula.statics.path_dependence import refuse_path_dependence
from forficula.statics.tree.fold_path import refuse_fold_on_table
from forficula.structure import Structure, Transition, distances_of, drive_of, drive_unit, first_state, structure_of
from forficula.study.files.search_file import read_search

ENERGY = Unit(display="mJ", si="J", example="5 mJ")
FORCE = Unit(display="N", si="N", example="5 N")
ANGLE = Unit(display="deg", si="rad", example="150 deg")
SHARE = Unit(display="%", si="", example="95 %")
RATIO = Unit(display="times", si="", example="10 times")
_DRIVE_UNITS = {"N m": TORQUE, "N": FORCE, "m": LENGTH, "rad": ANGLE}

# where a quantity comes from: the design itself; its parts; its flat-folded sheet (ms); closed forms of hinges that
# tendons cross (ms); the energy along its fold (0.2 s); slowly growing drives (up to seconds); a run; a run with its
# whole record; several runs that search for the least value; runs of many variants within the tolerances
Source = Literal["design", "parts", "sheet", "hinges", "fold", "slow", "run", "record", "search", "neighbours"]
SOURCES: tuple[Source, ...] = (
    *("design", "parts", "sheet", "hinges", "fold", "slow", "run", "record", "search", "neighbours"),
)
STATIC: tuple[Source, ...] = ("parts", "sheet", "hinges", "fold", "slow")

PROBABILITY = "probability"


@dataclass(frozen=True, kw_only=True)
class OutcomeQuantity:
    """A number for limits and objectives.

    Attributes:
        name: name as in goal files; for a value of the design, its key.
        row_name: name in rows, without its unit: the same except for spaces in names of states.
        unit: display unit and SI unit.
        meaning: in words.
        source: how it is computed.
    """

    name: str
    row_name: str
    unit: Unit
    meaning: str
    source: Source

    @property
    def dimension(self) -> str:
        """Name in tables."""
        return self.name.replace(".", "_")

    @property
    def column(self) -> str:
        """Name in rows, with the SI unit."""
        return self.row_name + unit_suffix(self.unit.si)


def quantities_of(design: Design) -> Mapping[str, OutcomeQuantity]:
    """Return all quantities for goals of a design, by name; keys of the design are allowed in addition."""
    structure = structure_of(design)
    quantities = [_quantity("mass", MASS, "total mass of the structure", "parts")]
    if structure.appearance.pattern is not None:
        what = "of the sheet folded flat along all creases"
        quantities += [
            _quantity("folding_ratio", RATIO, f"area of the open sheet / outline area {what}", "sheet"),
            _quantity("folded_height", LENGTH, f"number of layers {what}, times the thickness", "sheet"),
        ]
    if any(tendon.crossing is not None for tendon in structure.tendons):
        quantities += [
            _quantity("hinge_barrier", ENERGY, "smallest barrier of a single hinge that a tendon crosses", "hinges"),
            _quantity("hinge_holding_torque", TORQUE, "smallest holding torque of such a hinge at its stop", "hinges"),
            _quantity("hinge_opening_torque", TORQUE, "largest torque of such a hinge against opening", "hinges"),
        ]
    if structure.rigid_fold is not None:
        quantities += [
            _quantity("barrier", ENERGY, "energy barrier along the fold from its first state", "fold"),
            _quantity("opening_barrier", ENERGY, "energy barrier along the fold back from its last state", "fold"),
            _quantity("holding_torque", TORQUE, "holding torque of the first state, on every turning hinge", "fold"),
        ]
    for transition in structure.transitions:
        quantities += _of_transition(structure, transition)
    quantities += _of_states(structure)
    quantities.append(
        _quantity("residual", SHARE, "largest fraction of the energy that the balance of a run misses", "run")
    )
    quantities.append(
        _quantity("package_area", SHARE, "smallest outline area of a named state / that at the start", "record")
    )
    quantities.append(_quantity("package_height", LENGTH, "height of the state with the smallest outline", "record"))
    if structure.transitions and drive_unit(structure, drive_of(structure, structure.transitions[0].drive)) == "N m":
        for step in read_search("least-torques", {}, design).steps:
            meaning = f"least torque with which {step.transition} succeeds, among those tried"
            quantities.append(_quantity(step.result_name, step.unit, meaning, "search"))
    quantities.append(
        _quantity(PROBABILITY, SHARE, "fraction of designs within the tolerances that work", "neighbours")
    )
    return {quantity.name: quantity for quantity in quantities}


def quantity_of(design: Design, name: str) -> OutcomeQuantity:
    """Return a quantity of a design by its name, or by a key of the design whose value has a unit.

    Raises:
        InputError: unknown name; the message has a similar one. Or statics cannot compute the quantity of this design.
    """
    known = quantities_of(design)
    if name in known:
        if known[name].source in ("hinges", "fold", "slow"):
            with error_prefix(f"{name}: "):
                refuse_path_dependence(structure_of(design), "quantities of statics")
                if known[name].source == "fold":
                    refuse_fold_on_table(structure_of(design))
        return known[name]
    if "." in name:
        key_unit = key_quantity(name, type(design))
        key_value(design, name)
        if key_unit is None:
            raise InputError(f"{name}: need a key whose value has a unit")
        meaning = f"the design's {name}"
        return OutcomeQuantity(name=name, row_name=name, unit=key_unit.unit, meaning=meaning, source="design")
    raise InputError(f"{name}: need a key of the design, or one of {', '.join(known)}{near_name(name, known)}")


def _quantity(name: str, unit: Unit, meaning: str, source: Source) -> OutcomeQuantity:
    return OutcomeQuantity(name=name.replace(" ", "_"), row_name=name, unit=unit, meaning=meaning, source=source)


def _of_transition(structure: Structure, transition: Transition) -> list[OutcomeQuantity]:
    """Return the quantities of a transition that runs and slowly growing drives give."""
    name, wording = transition.name, transition.wording
    unit = drive_unit(structure, drive_of(structure, transition.drive))
    quantities = [
        _quantity(f"{name}_time", TIME, wording.time, "run"),
        _quantity(f"{name}_work", ENERGY, f"work of {wording.noun}", "run"),
    ]
    if unit in _DRIVE_UNITS:
        what = "least slowly growing drive" if unit != "N m" else "least slowly growing torque"
        quantities.append(
            _quantity(f"slow_{name}", _DRIVE_UNITS[unit], f"{what} with which the structure {wording.does}", "slow")
        )
    if unit == "m":
        quantities.append(_quantity(f"slow_{name}_force", FORCE, f"largest force of slow {wording.noun}", "slow"))
        quantities.append(_quantity(f"{name}_force", FORCE, f"largest force of {wording.noun}", "record"))
    return quantities


def _of_states(structure: Structure) -> list[OutcomeQuantity]:
    """Return the quantities of named states that runs give: stored energy, and every recorded distance."""
    names = [
        first_state(structure, structure.stage_states),
        *(transition.state for transition in structure.transitions),
    ]
    recorded = [measure.name for measure in distances_of(structure)]
    return [
        quantity
        for state in dict.fromkeys(name for name in names if name)
        for quantity in (
            *_energies_of(structure, state),
            *(_quantity(f"{state}_{name}", LENGTH, f"{name}, {state}", "run") for name in recorded),
        )
    ]


def _energies_of(structure: Structure, state: str) -> list[OutcomeQuantity]:
    """Return all stored energy in a state, and that of the tendons. The energy of membranes needs whole records."""
    stored = _quantity(f"{state}_energy", ENERGY, f"all stored energy, {state}", "run")
    if not structure.tendons:
        return [stored]
    # the first of these names contains only the tendons' energy in rows of studies
    column = f"{state}_stored_energy"
    return [
        replace(stored, row_name=column, source="record" if structure.membranes else "run"),
        replace(
            stored,
            name=f"{state}_tendon_energy".replace(" ", "_"),
            row_name=f"{state}_energy",
            meaning=f"energy of the tendons, {state}",
        ),
    ]
