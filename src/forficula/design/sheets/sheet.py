"""A sheet that folds at its creases, of panels that are rigid or bend, and what is done to it."""

from __future__ import annotations

from functools import lru_cache
from typing import Annotated, Any, ClassVar, Self

from pydantic import Field, model_validator

from forficula.design.chosen import Choice, choices, with_choices
from forficula.design.design import Design
from forficula.design.named_protocol import NamedProtocol
from forficula.design.sheet_protocol import sheet_protocol
from forficula.design.sheets.sheet_checks import check_sheet
from forficula.design.sheets.sheet_course import SheetDrive, SheetMeasure, SheetProtocol, SheetTendon
from forficula.design.sheets.sheet_parts import Crease, FacetSection, Imperfection, Support, largest_extension
from forficula.design.sheets.sheet_places import facet_of
from forficula.pattern import CreasePattern, central_facet, facet_tree

# of the imperfection of a sheet, where another start is tried
_OTHER_START = 1.01


class SheetDesign(Design):
    """A sheet that folds at its creases, and what is done to it."""

    varied_key: ClassVar[str] = "crease.stiffness"
    weight_section: ClassVar[str] = "facet"
    rest_keys: ClassVar[tuple[str, ...]] = (
        "pattern",
        "crease",
        "support",
        "measure",
        "protocol.stages",
        "protocol.gravity",
    )

    source: Annotated[str, Field(description="where its values come from")] = ""
    pattern: Any
    facet: FacetSection = FacetSection()
    crease: Crease = Crease()
    imperfection: Imperfection = Imperfection()
    tendon: Annotated[tuple[SheetTendon, ...], Field(description="springs between two places, which only pull")] = ()
    support: Annotated[
        tuple[Support, ...],
        Field(description="what is held; hinged rigid facets need one: facet 0, or in loops the middle one"),
    ] = ()
    drive: Annotated[tuple[SheetDrive, ...], Field(description="what stages of the protocol switch on")] = ()
    measure: Annotated[tuple[SheetMeasure, ...], Field(description="what is watched, for goals and tables")] = ()
    protocol: SheetProtocol

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern, as built."""
        return _drawn(self.pattern)

    @property
    def held_facets(self) -> tuple[int, ...]:
        """Numbers of the facets that are held, of rigid ones."""
        if self.support or self.opens:
            return tuple(facet_of(self.sheet, support.of) for support in self.support)
        closes = any(link.closes for link in facet_tree(self.sheet))
        return (central_facet(self.sheet) if closes else 0,)

    @property
    def opens(self) -> bool:
        """Whether creases open between rigid facets."""
        return self.facet.kind == "rigid" and largest_extension(self.crease) > 0

    @property
    def chosen(self) -> tuple[Choice, ...]:
        """The values that a rule chooses, for they are not given."""
        return _choices(self.pattern, self.facet, self.crease)

    @property
    def has_stops_of_bodies(self) -> bool:
        """Whether its hinges are of rigid facets; where facets bend, stops of creases are springs."""
        return self.facet.kind == "rigid"

    def with_other_start(self) -> Self | None:
        """Return the design with an imperfection that is 1 % larger; None of a sheet that is as it is drawn."""
        if not self.imperfection.size:
            return None
        larger = {"size": _OTHER_START * self.imperfection.size}
        return self.model_copy(update={"imperfection": self.imperfection.model_copy(update=larger)})

    @property
    def named_protocol(self) -> NamedProtocol:
        """What the drives of the sheet act on, and the states and transitions that its stages lead to."""
        return sheet_protocol(self)

    def settled(self) -> Self:
        """The design with the values that a rule chooses."""
        return with_choices(self, self.chosen)

    def hash_values(self) -> dict[str, Any]:
        """The values but for what they are called, with those that a rule chooses."""
        settled = self.settled()
        return super(SheetDesign, settled).hash_values()

    @model_validator(mode="after")
    def _fits_together(self) -> SheetDesign:
        check_sheet(self)
        return self


@lru_cache(maxsize=64)
def _drawn(pattern: Any) -> CreasePattern:
    """The sheet of a pattern, which is asked for again and again while it is built."""
    sheet: CreasePattern = pattern.sheet
    return sheet


@lru_cache(maxsize=64)
def _choices(pattern: Any, facet: FacetSection, crease: Crease) -> tuple[Choice, ...]:
    """What is chosen for a sheet, which everything that names or builds its design asks for."""
    return choices(_drawn(pattern), facet, crease)
