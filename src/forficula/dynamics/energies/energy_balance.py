"""Energy balance of a run, and the energy that the integration lost."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.dynamics.record import Record
from forficula.quantities import show_value
from forficula.serial import Joules, Key, Written
from forficula.structure import Structure

_ROUNDING = 1e-9
# share of the stored energy: below this exchange, a few steps leave only a negligible residual
_SLIGHT = 1e-5
# fold angle, rad, and strain of bars and membranes, that define the energy scale of rounding errors
_FOLDED, _STRAINED = 1.0, 1e-4
# term that not every structure has
_Term = Annotated[Joules | None, Written.IF_KNOWN]
_STORES = ("tendon_energy", "membrane_energy", "hinge_energy", "spring_energy", "coupling_energy", "branch_energy")


@dataclass(frozen=True, kw_only=True)
class EnergyBalance:
    """Energy balance of a run from its start to its end, J.

    Attributes:
        work: work of the motors.
        tendon: change of the tendons' energy.
        membrane: change of the membrane's energy.
        kinetic: change of the kinetic energy.
        gravitational: change of the gravitational energy.
        hinge_damping: dissipated by the hinges' damping.
        elastic_damping: dissipated by the damping of tendons and membrane.
        stops: dissipated by stops and length limits; includes the work of rigid couplings, which is 0 except for errors
            of the integration.
        friction: dissipated by the hinges' dry friction; None without friction.
        contacts: dissipated by contacts and their friction; includes the work of rigid couplings; None without contact.
        friction_springs: change of the energy of the springs by which friction holds facets and plates that touch; None
            without such friction.
        branches: change of the energy of the tendons' Maxwell branches; None without branches.
        branch_damping: dissipated by the dampers of these branches; None without branches.
        yielding: dissipated by the tendons' yielding; None if they never yield.
        crease_yielding: dissipated by creases that fold permanently; None if they never do.
        crease_branches: dissipated by the dampers of the creases' Maxwell branches; None without branches.
        crease_damage: dissipated by the wear of creases; None without wear.
        letting_go: minus the energy that branches stored without work while a slack tendon could not push; None if no
            tendon is clamped.
        hinges: change of the energy of the hinges' springs, with that of their Maxwell branches; None without springs.
        springs: change of the energy of springs between points; None without such springs.
        couplings: change of the energy of elastic couplings between joints; None without couplings.
        closures: work of the closures of loops of bodies; it counts as missing, because it should be 0 except for
            errors of the integration; None without loops.
        drag: dissipated by the drag of air or water; None in empty space.
        settling: lost between the states of rest that motions reach in quasi-static stages and the nearest equilibria;
            it counts as missing, because it should be 0 except for slight motions; None without such stages.
        at_hand: largest energy of tendons stretched by their levers, hinges turned by 1 rad, or bars and membranes
            strained by 1e-4; a billionth of it counts as rounding.
        stored: energy stored in tendons, membrane and springs at the start or the end, the larger of the two; 1e-5 of
            this energy is the least scale of the residual.
        slow: work of the drives in quasi-static stages, each counted as positive: a structure without losses returns
            all of this work when it is unloaded, so that its other exchanges add up to 0.
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
    friction_springs: Annotated[_Term, Key("friction_spring_energy_change")] = None
    branches: Annotated[_Term, Key("branch_energy_change")] = None
    branch_damping: _Term = None
    yielding: _Term = None
    crease_yielding: _Term = None
    crease_branches: Annotated[_Term, Key("crease_branch_damping")] = None
    crease_damage: _Term = None
    letting_go: _Term = None
    hinges: Annotated[_Term, Key("hinge_energy_change")] = None
    springs: Annotated[_Term, Key("spring_energy_change")] = None
    couplings: Annotated[_Term, Key("coupling_energy_change")] = None
    closures: _Term = None
    drag: _Term = None
    settling: _Term = None
    at_hand: Annotated[Joules, Written.NEVER] = 0.0
    stored: Annotated[Joules, Written.NEVER] = 0.0
    slow: Annotated[Joules, Written.NEVER] = 0.0

    def __repr__(self) -> str:
        """Work of the motors, exchanged energy, and missing energy."""
        work, exchanged, missing = (show_value(energy, "J") for energy in (self.work, self.exchanged, self.missing))
        return f"<EnergyBalance: work {work}, exchanged {exchanged}, missing {missing} ({100 * self.residual:.2g} %)>"

    @property
    def missing(self) -> Joules:
        """Return the work that the balance does not explain, J: the error of the integration.

        Real contacts only dissipate energy, so energy supplied by contacts counts as missing as well.
        """
        stored = self.tendon + self.membrane + self.kinetic + self.gravitational
        of_law = (
            self.branches,
            self.branch_damping,
            self.yielding,
            self.crease_yielding,
            self.crease_branches,
            self.crease_damage,
            self.letting_go,
            self.hinges,
            self.springs,
            self.friction_springs,
        )
        taken = (self.friction, max(self.contacts or 0.0, 0.0), self.drag)
        others = sum(term or 0.0 for term in (*of_law, self.couplings, *taken))
        return self.work - stored - self.hinge_damping - self.elastic_damping - self.stops - others

    @property
    def exchanged(self) -> float:
        """Return the energy that torques, springs and weight exchanged, or slow drives, if this is more, J."""
        springs = (self.tendon, self.membrane, self.branches or 0.0, self.hinges or 0.0, self.springs or 0.0)
        net = sum(abs(term) for term in (self.work, *springs, self.gravitational, self.couplings or 0.0))
        return max(net, self.slow)

    @property
    def residual(self) -> Annotated[float, Written.FIRST]:
        """Return the missing energy as a share of the exchanged energy, or of a small share of the stored energy."""
        scale = max(self.exchanged, _ROUNDING * self.at_hand, _SLIGHT * self.stored)
        return abs(self.missing) / scale if scale else 0.0


def energy_balance(record: Record) -> EnergyBalance:
    """Compute the energy balance of a run from its start to its end."""
    with np.errstate(over="ignore", invalid="ignore"):  # diverged runs
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
        friction=_loss(change, "friction_work"),
        contacts=_loss(change, "contact_work"),
        friction_springs=change.get("friction_spring_energy"),
        branches=change.get("branch_energy"),
        branch_damping=_loss(change, "branch_damping_work"),
        yielding=_loss(change, "yield_work"),
        crease_yielding=_loss(change, "crease_yield_work"),
        crease_branches=_loss(change, "crease_branch_work"),
        crease_damage=_loss(change, "crease_damage_work"),
        letting_go=_loss(change, "letting_go_work"),
        hinges=change.get("hinge_energy"),
        springs=change.get("spring_energy"),
        couplings=change.get("coupling_energy"),
        closures=_loss(change, "closure_work"),
        drag=_loss(change, "drag_work"),
        settling=_loss(change, "settling_work"),
        at_hand=_largest_part_energy(record.structure),
        # a diverged run has no finite energy at its end
        stored=max((energy for energy in ends if np.isfinite(energy)), default=0.0),
        slow=_slow_work(record),
    )


def _slow_work(record: Record) -> float:
    """Return the sum of the absolute work of the drives in every quasi-static stage, J."""
    work, half = record.series["motor_work"].sum(axis=1), float(record.design.protocol.timestep) / 2
    slow = [end for end in record.stages if end.stage.quasi_static]
    rows = [np.searchsorted(record.time, (end.start - half, end.end + half)) for end in slow]
    return float(sum(abs(work[last - 1] - work[first]) for first, last in rows))


def _largest_part_energy(structure: Structure) -> float:
    """Return the largest energy that a part stores after a typical motion, J."""
    # levers no longer than half the tendon
    tendons = [
        tendon.law.stiffness[0] * (tendon.longest / 2) ** 2
        for tendon in structure.tendons
        if np.isfinite(tendon.longest)
    ]
    hinges = [hinge.stiffness * _FOLDED**2 / 2 for hinge in structure.hinges]
    springs = [spring.stiffness * (_STRAINED * spring.rest_length) ** 2 / 2 for spring in structure.springs]
    membranes = [
        membrane.law.youngs_modulus * membrane.law.thickness * (_STRAINED * structure.span) ** 2 / 2
        for membrane in structure.membranes
    ]
    return max([*tendons, *hinges, *springs, *membranes], default=0.0)


def _loss(change: dict[str, float], name: str) -> float | None:
    return -change[name] if name in change else None
