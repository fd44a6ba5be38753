"""Where the energy of a run went, and how much of it the integration lost."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.dynamics.record import Record
from forficula.serial import Joules, Key, Written
from forficula.structure import Structure

_ROUNDING = 1e-9
# of the energy that is stored: where less is exchanged, a few steps leave what counts for nothing
_SLIGHT = 1e-5
# of what folds by so much, rad, and of bars and membranes that are strained by so much, rounding takes its share
_FOLDED, _STRAINED = 1.0, 1e-4
# of what not every structure has
_Term = Annotated[Joules | None, Written.IF_KNOWN]
_STORES = ("tendon_energy", "membrane_energy", "hinge_energy", "spring_energy", "coupling_energy", "branch_energy")


@dataclass(frozen=True, kw_only=True)
class EnergyBalance:
    """Where the work went, J, from start to end of the run.

    Attributes:
        work: that the torques put in.
        tendon: change of the tendons' energy.
        membrane: change of the membrane's energy.
        kinetic: change of the kinetic energy.
        gravitational: change of the gravitational energy.
        hinge_damping: that the hinges' damping took.
        elastic_damping: that the tendons' and the membrane's damping took.
        stops: that stops and length limits took; with rigid couplings what these took, which should be none but for
            errors of the integration.
        friction: that the hinges' dry friction took; None where they have none.
        contacts: that contacts took, with their friction, and then rigid couplings; None where nothing touches.
        branches: change of the energy of the tendons' Maxwell branches; None where they have none.
        branch_damping: that the dampers in these branches took; None where there are none.
        yielding: that the tendons' yielding took; None where they never yield.
        letting_go: minus what their branches stored without work, where the tendon gave way and did not push; None
            where it never does.
        hinges: change of the energy of the hinges' springs; None where they have none.
        springs: change of the energy of springs between points; None where there are none.
        couplings: change of the energy of elastic couplings between joints; None where there are none.
        closures: that loops of bodies took where they were closed, and part of what is missing: closing them takes no
            work but for errors of the integration; None where there are none.
        drag: that air or water took; None in empty space.
        at_hand: what tendons stretched by their levers, hinges turned by 1 rad, or bars and membranes strained by 1e-4
            would hold, whichever is most; a billionth of it is rounding.
        stored: in tendons, membrane and springs at the start or the end, where there is more; 1e-5 of it is slight.
    """

    work: Joules
    tendon: Annotated[Joules, Key("tendon_energy_change")]
    membrane: Annotated[Joules, Key("membrane_energy_change")]
    kinetic: Annotated[Joules, Key("kinetic_energy_change")]
    gravitational: Annotated[Joules, Key("gravitational_energy_change")]
    hinge_damping: Joules
    elastic_damping: Joules
    stops: Joules
    friction: _Term = None
    contacts: _Term = None
    branches: Annotated[_Term, Key("branch_energy_change")] = None
    branch_damping: _Term = None
    yielding: _Term = None
    letting_go: _Term = None
    hinges: Annotated[_Term, Key("hinge_energy_change")] = None
    springs: Annotated[_Term, Key("spring_energy_change")] = None
    couplings: Annotated[_Term, Key("coupling_energy_change")] = None
    closures: _Term = None
    drag: _Term = None
    at_hand: Annotated[Joules, Written.NEVER] = 0.0
    stored: Annotated[Joules, Written.NEVER] = 0.0

    @property
    def missing(self) -> Joules:
        """Work that the account does not find, J: the error of the integration.

        Contacts only take energy. What they give is an error, too, and counts as missing.
        """
        stored = self.tendon + self.membrane + self.kinetic + self.gravitational
        of_law = (self.branches, self.branch_damping, self.yielding, self.letting_go, self.hinges, self.springs)
        taken = (self.friction, max(self.contacts or 0.0, 0.0), self.drag)
        others = sum(term or 0.0 for term in (*of_law, self.couplings, *taken))
        return self.work - stored - self.hinge_damping - self.elastic_damping - self.stops - others

    @property
    def exchanged(self) -> float:
        """Energy that torques, springs and weight gave or took, J."""
        springs = (self.tendon, self.membrane, self.branches or 0.0, self.hinges or 0.0, self.springs or 0.0)
        return sum(abs(term) for term in (self.work, *springs, self.gravitational, self.couplings or 0.0))

    @property
    def residual(self) -> Annotated[float, Written.FIRST]:
        """What is missing, as a share of the energy that was exchanged, or of a slight part of what is stored."""
        scale = max(self.exchanged, _ROUNDING * self.at_hand, _SLIGHT * self.stored)
        return abs(self.missing) / scale if scale else 0.0


def energy_balance(record: Record) -> EnergyBalance:
    """Account for a run's energy from its start to its end."""
    with np.errstate(over="ignore", invalid="ignore"):  # of what blew up
        change = {
            name: float(values[-1].sum() - values[0].sum())
            for name, values in record.series.items()
            if name.endswith(("_energy", "_work"))
        }
        ends = [
            sum(float(record.series[name][row].sum()) for name in _STORES if name in record.series) for row in (0, -1)
        ]
    return EnergyBalance(
        work=sum((float(last - first) for first, last in record.series["motor_work"][[0, -1]].T), 0.0),
        tendon=change["tendon_energy"],
        membrane=change["membrane_energy"],
        kinetic=change["kinetic_energy"],
        gravitational=change["gravitational_energy"],
        hinge_damping=-change["hinge_damping_work"],
        elastic_damping=-change["elastic_damping_work"],
        stops=-change["stop_work"],
        friction=_taken(change, "friction_work"),
        contacts=_taken(change, "contact_work"),
        branches=change.get("branch_energy"),
        branch_damping=_taken(change, "branch_damping_work"),
        yielding=_taken(change, "yield_work"),
        letting_go=_taken(change, "letting_go_work"),
        hinges=change.get("hinge_energy"),
        springs=change.get("spring_energy"),
        couplings=change.get("coupling_energy"),
        closures=_taken(change, "closure_work"),
        drag=_taken(change, "drag_work"),
        at_hand=_at_hand(record.structure),
        # of a run that blew up, which ends with no number, none
        stored=max((each for each in ends if np.isfinite(each)), default=0.0),
    )


def _at_hand(structure: Structure) -> float:
    """The most that a part would hold that moves as far as such parts do, J."""
    # levers no longer than half the tendon
    tendons = [
        each.law.stiffness[0] * (each.longest / 2) ** 2 for each in structure.tendons if np.isfinite(each.longest)
    ]
    hinges = [each.stiffness * _FOLDED**2 / 2 for each in structure.hinges]
    springs = [each.stiffness * (_STRAINED * each.rest_length) ** 2 / 2 for each in structure.springs]
    membranes = [
        each.law.youngs_modulus * each.law.thickness * (_STRAINED * structure.span) ** 2 / 2
        for each in structure.membranes
    ]
    return max([*tendons, *hinges, *springs, *membranes], default=0.0)


def _taken(change: dict[str, float], name: str) -> float | None:
    return -change[name] if name in change else None
