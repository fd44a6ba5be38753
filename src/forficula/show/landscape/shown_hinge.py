"""The one tendon whose hinge stands for all where only one is shown."""

from __future__ import annotations

from dataclasses import dataclass

from forficula.analysis.simulated_snap import crossed_hinge, hinge_name, inner_tendon
from forficula.statics import EnergyLandscape, HingeLandscape
from forficula.structure import crossing_tendons


@dataclass(frozen=True, kw_only=True)
class ShownHinge:
    """A tendon and the hinge that it lies across.

    Attributes:
        tendon: number of the tendon.
        hinge: number of the hinge.
        own: about its true axis.
        ideal: with both bars square to the axis; None where there are no bars to be so.
        name: what tables and sentences call the hinge, such as "second hinge" or "crease 0 (left)".
        whole: what they call the structure.
    """

    tendon: int
    hinge: int
    own: HingeLandscape
    ideal: HingeLandscape | None
    name: str
    whole: str

    @property
    def columns(self) -> tuple[tuple[str, HingeLandscape], ...]:
        """The ideal hinge, where there is one, and the true one, by name."""
        ideal = () if self.ideal is None else (("ideal hinge", self.ideal),)
        return (*ideal, (f"{self.name} of the {self.whole}", self.own))


def shown_hinge(landscape: EnergyLandscape, tendon: int | None = None) -> ShownHinge | None:
    """The hinge that a tendon lies across; that of an inner one where none is given; None where there is none."""
    structure = landscape.structure
    tendon = inner_tendon(structure) if tendon is None else tendon
    if tendon is None:
        return None
    place = crossing_tendons(structure).index(tendon)
    return ShownHinge(
        tendon=tendon,
        hinge=crossed_hinge(structure, tendon),
        own=landscape.tendons[place],
        ideal=landscape.ideal_hinges[place],
        name=hinge_name(structure, tendon),
        whole=structure.appearance.whole,
    )
