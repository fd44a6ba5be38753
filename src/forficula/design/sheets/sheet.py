"""Designs of sheets that fold at their creases; the facets are rigid or bend."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Annotated, Any, ClassVar, Self

from pydantic import Field, model_validator

from forficula.design.chosen import Choice, choices, with_choices
from forficula.design.contact import WITHOUT_CONTACT, ContactSection, with_time_constant
from forficula.design.design import Design
from forficula.design.named_protocol import NamedProtocol
from forficula.design.sheet_protocol import sheet_protocol
from forficula.design.sheets.crease_sections import Crease, largest_extension
from forficula.design.sheets.crease_values import law_sentences
from forficula.design.sheets.sheet_checks import check_sheet, measured_units
from forficula.design.sheets.sheet_drives import SheetDrive, SheetMeasure, SheetProtocol, SheetTendon
from forficula.design.sheets.sheet_places import edge_of, facet_of
from forficula.design.sheets.sheet_sections import FacetSection, Imperfection, Support
from forficula.errors import InputError
from forficula.pattern import CreasePattern, central_facet, facet_tree
from forficula.pattern.thick.split_sheet import split_sheet
from forficula.quantities import Unit

# publications of the methods by which facets have a thickness
METHOD_PAPERS: Mapping[str, Mapping[str, str]] = {
    "offset": {"edmondson2014": "thick panels beside the plane of the hinges"},
    "tapered": {"tachi2011": "trimmed thick panels"},
    "hinge-shift": {"chen2015": "positions of the hinges of thick panels"},
    "split": {
        "ku2015": "two folds instead of one between thick panels",
        "chen2015": "heights of the hinges of thick panels",
    },
}
# factor of the imperfection of a sheet for a slightly different start
_OTHER_START = 1.01


class SheetDesign(Design):
    """A sheet that folds at its creases, with its protocol."""

    varied_key: ClassVar[str] = "crease.stiffness"
    weight_sections: ClassVar[tuple[str, ...]] = ("facet",)
    rest_keys: ClassVar[tuple[str, ...]] = (
        "pattern",
        "facet.thickness",
        "crease",
        "support",
        "measure",
        "protocol.stages",
        "protocol.gravity",
        "protocol.gravity_direction",
    )

    source: Annotated[str, Field(description="where the values of the design come from")] = ""
    pattern: Any
    facet: FacetSection = FacetSection()
    crease: Crease = Crease()
    imperfection: Imperfection = Imperfection()
    tendon: Annotated[tuple[SheetTendon, ...], Field(description="pull-only springs between two places")] = ()
    support: Annotated[
        tuple[Support, ...],
        Field(
            description="facets, edges or vertices that are held; if none is given, hinged rigid facets are held at"
            " facet 0, or at the central facet if they form loops"
        ),
    ] = ()
    drive: Annotated[tuple[SheetDrive, ...], Field(description="drives that stages of the protocol switch on")] = ()
    measure: Annotated[
        tuple[SheetMeasure, ...], Field(description="angles and distances that are recorded, for goals and tables")
    ] = ()
    contact: Annotated[
        ContactSection | None, Field(description="contact of facets and bars, if protocol.contact is true")
    ] = None
    protocol: SheetProtocol

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern, as built; with the strips of split folds."""
        if self.facet.thickness_method == "split" and self.facet.kind == "rigid":
            return _split(self.drawn_sheet, self.panel_thickness)
        return self.drawn_sheet

    @property
    def drawn_sheet(self) -> CreasePattern:
        """The crease pattern as built, without the strips of split folds."""
        return _drawn(self.pattern)

    @property
    def panel_thickness(self) -> float:
        """Thickness of the facets, m, of the design or by a rule."""
        if self.facet.thickness is not None:
            return self.facet.thickness
        return next(choice.value for choice in self.chosen if choice.key == "thickness")

    @property
    def turning_facets(self) -> dict[int, int]:
        """Edges about which facets of a rigid sheet turn on the ground, by the numbers of the facets."""
        on_edges = (edge_of(self.sheet, support.of) for support in self._rooted if support.kind == "edge")
        return {facet: edge for edge, facet in on_edges}

    @property
    def _rooted(self) -> tuple[Support, ...]:
        """Supports of a rigid sheet on which bodies begin: whole facets and edges; of hinged facets, only the first."""
        whole = [support for support in self.support if support.kind != "vertex" and support.whole]
        return tuple(whole if self.opens else whole[:1])

    @property
    def point_supports(self) -> tuple[tuple[int, Support], ...]:
        """Supports of a rigid sheet that hold single points of plates, each after its number."""
        rooted = [id(support) for support in self._rooted]
        return tuple((number, support) for number, support in enumerate(self.support) if id(support) not in rooted)

    @property
    def held_facets(self) -> tuple[int, ...]:
        """Numbers of the facets that are clamped or turn about an edge, of a sheet of rigid facets."""
        if self.support or self.opens:
            clamped = [facet_of(self.sheet, support.of) for support in self._rooted if support.kind == "facet"]
            return (*clamped, *self.turning_facets)
        closes = any(link.closes for link in facet_tree(self.sheet))
        return (central_facet(self.sheet) if closes else 0,)

    @property
    def opens(self) -> bool:
        """Whether creases open between rigid facets."""
        return self.facet.kind == "rigid" and largest_extension(self.crease) > 0

    @property
    def chosen(self) -> tuple[Choice, ...]:
        """The values that are not given and that a rule chooses."""
        return _choices(self.pattern, self.facet, self.crease)

    @property
    def method_papers(self) -> Mapping[str, str]:
        """Publication of the method that makes room for the thickness of facets."""
        return METHOD_PAPERS.get(self.facet.thickness_method or "", {})

    @property
    def law_sentences(self) -> tuple[str, ...]:
        """Sentences about laws of creases with chosen values, or for a sheet of another thickness."""
        return law_sentences(self.crease, self.settled().facet.thickness)

    @property
    def has_stops_of_bodies(self) -> bool:
        """Whether the facets are rigid; if facets bend, the stops of creases are springs."""
        return self.facet.kind == "rigid"

    def with_other_start(self) -> Self | None:
        """Return the design with an imperfection that is 1 % larger; None for a sheet without an imperfection."""
        if not self.imperfection.size:
            return None
        larger = {"size": _OTHER_START * self.imperfection.size}
        return self.model_copy(update={"imperfection": self.imperfection.model_copy(update=larger)})

    @property
    def named_protocol(self) -> NamedProtocol:
        """The drives of the sheet with what they act on, and the states and transitions of its stages."""
        return sheet_protocol(self)

    @property
    def measure_units(self) -> dict[str, Unit]:
        """Names of measures and of roles of creases that a bound may have, with their units."""
        return measured_units(self)

    def settled(self) -> Self:
        """Return the design with values that a rule chooses, and the section of contact where it acts, filled in."""
        chosen = with_choices(self, self.chosen)
        if self.contact is None and self.protocol.contact:
            return chosen.model_copy(update={"contact": ContactSection()})
        return chosen

    def with_contact_time(self, time_constant: float) -> Self:
        """Return the design with a time constant of contact, s, where it is "auto"; the same design where it is not."""
        section = self.settled().contact if self.protocol.contact else None
        if section is None or (changed := with_time_constant(section, time_constant)) is section:
            return self
        return self.model_copy(update={"contact": changed})

    @property
    def idle(self) -> tuple[str, ...]:
        """Sentences about given values that have no effect."""
        without = self.contact is not None and not self.protocol.contact
        return (*super().idle, *[WITHOUT_CONTACT] * without)

    def hash_values(self) -> dict[str, Any]:
        """Return the values that affect a run, including those that a rule chooses."""
        settled = self.settled()
        return super(SheetDesign, settled).hash_values()

    @model_validator(mode="after")
    def _fits_together(self) -> SheetDesign:
        check_sheet(self)
        return self


@lru_cache(maxsize=64)
def _drawn(pattern: Any) -> CreasePattern:
    """Return the sheet of a pattern; cached, because it is needed repeatedly while a sheet is built."""
    sheet: CreasePattern = pattern.sheet
    return sheet


@lru_cache(maxsize=64)
def _split(drawn: CreasePattern, thickness: float) -> CreasePattern:
    """Return a sheet with the strips of split folds."""
    try:
        return split_sheet(drawn, thickness).pattern
    except InputError as error:
        raise InputError(f"facet.thickness_method: {error}") from None


@lru_cache(maxsize=64)
def _choices(pattern: Any, facet: FacetSection, crease: Crease) -> tuple[Choice, ...]:
    """Return the choices for a sheet; cached, because the hash and the structure of a design need them."""
    return choices(_drawn(pattern), facet, crease)
