"""Rigid plates on the facets of a sheet, hinged at its creases in a tree, with tendons between places on them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.design import PlatesDesign, Stage, stage_drives
from forficula.design.plates import creases_by_edge
from forficula.design.protocol import read_goal
from forficula.design.sheet_places import SheetPlace, crease_role, creases_of, place_on
from forficula.errors import InputError
from forficula.material.law.tendon_law import TendonLaw
from forficula.pattern import CreasePattern, FacetLink, facet_tree
from forficula.structure.appearance import Appearance
from forficula.structure.course import Drive, Goal, Measure, Motor, RestState, Transition, Wording
from forficula.structure.crossing import tendon_crossing
from forficula.structure.goals import drive_of, goal_of
from forficula.structure.mass import mass_of
from forficula.structure.parts import GROUND, Body, Hinge, Plate, Point, Tendon
from forficula.structure.structure import Structure

# keys that matter to where plates rest beside those of their tendons
_STATIC_KEYS = ("pattern", "crease", "support", "measure", "protocol.stages", "protocol.gravity")


def plate_structure(design: PlatesDesign) -> Structure:
    """Build a plate on every facet and a hinge at every crease of a design's sheet, in the units of the design.

    Raises:
        InputError: plates without a mass.
    """
    pattern = design.sheet
    links = facet_tree(pattern, design.held_facet)
    number = {link.facet: place for place, link in enumerate(links)}
    origins = [pattern.vertices_coords[_origin(pattern, link)] for link in links]
    bodies = tuple(
        Body(
            name=f"facet{link.facet}",
            role="facet",
            parent=GROUND if link.parent is None else number[link.parent],
            position=origins[place] if link.parent is None else origins[place] - origins[number[link.parent]],
            frame=np.eye(3),
        )
        for place, link in enumerate(links)
    )
    points: list[Point] = []
    plates: list[Plate] = []
    for body, link in enumerate(links):
        corners = pattern.faces_vertices[link.facet]
        first = len(points)
        points += [
            Point(
                name=f"facet{link.facet}_vertex{vertex}",
                role="corner",
                body=body,
                place=pattern.vertices_coords[vertex] - origins[body],
            )
            for vertex in corners
        ]
        plates.append(
            Plate(
                body=body,
                points=tuple(range(first, first + len(corners))),
                thickness=design.facet.thickness,
                density=design.facet.density,
            )
        )
    hinges, edges = _hinges(design, pattern, links)

    def add(name: str, role: str, places: Sequence[SheetPlace]) -> tuple[int, int]:
        """Points at two places, by their numbers."""
        for end, place in zip(("from", "to"), places, strict=True):
            body = number[place.facet]
            points.append(Point(name=f"{name}_{end}", role=role, body=body, place=place.position - origins[body]))
        return len(points) - 2, len(points) - 1

    tendons = []
    for place, chosen in enumerate(design.tendon):
        ends = _ends(pattern, chosen)
        crossed = _edges_between(links, ends[0].facet, ends[1].facet)
        tendons.append(
            Tendon(
                name=chosen.name,
                role="tendon",
                points=add(f"tendon_{chosen.name}", "attachment", ends),
                law=TendonLaw(
                    rest_length=chosen.rest_length,
                    stiffness=(chosen.stiffness, 0.0, 0.0),
                    damping=(chosen.damping, 0.0, 0.0),
                ),
                longest=_longest(pattern, ends, crossed),
                gauge_length=chosen.rest_length,
                key=f"tendon.{place}",
            )
        )
    every = range(len(hinges))
    measures = [Measure(name="creases", kind="angle", hinges=tuple(every), signs=(1,) * len(every), label="fold angle")]
    for watched in design.measure:
        if watched.of is None:
            pair = add(f"measure_{watched.name}", "measured", _ends(pattern, watched))
            measures.append(Measure(name=watched.name, kind="distance", points=pair, label=watched.name))
        else:
            chosen_edges = creases_of(pattern, watched.of)
            # a valley counts as positive
            signs = tuple(1 if pattern.edges_assignment[edge] == "V" else -1 for edge in chosen_edges)
            turned = tuple(edges[edge] for edge in chosen_edges)
            measures.append(Measure(name=watched.name, kind="angle", hinges=turned, signs=signs, label=watched.name))
    built = Structure(
        name=design.name,
        bodies=bodies,
        points=tuple(points),
        plates=tuple(plates),
        hinges=hinges,
        tendons=tuple(tendons),
        measures=tuple(measures),
        span=float(np.ptp(pattern.vertices_coords, axis=0).max()),
        mass=1.0,
        gravity=design.protocol.gravity,
        appearance=Appearance(pattern=pattern),
    )
    crossed_by = [replace(tendon, crossing=tendon_crossing(built, tendon.points)) for tendon in tendons]
    return with_protocol(replace(built, tendons=tuple(crossed_by), mass=_largest_mass(design, built)), design)


def with_protocol(structure: Structure, design: PlatesDesign) -> Structure:
    """Plates with the drives, goals, states and transitions of a design's protocol."""
    motors, drives = _driven(structure, design)
    structure = replace(structure, motors=motors, drives=drives, goals=(), states=(), transitions=())
    states: list[RestState] = []
    transitions: list[Transition] = []
    goals: dict[str, Goal] = {}
    stages, bounds, last = design.protocol.stages, goal_of(structure, "time"), ""
    kinds = {measure.name: measure.kind for measure in structure.measures}
    keys = {drive.name: drive.key for drive in structure.drives}
    for number, stage in enumerate(stages):
        goal = goal_of(structure, stage.until)
        if goal.kind == "bounds":
            goals[goal.name] = goal
        if stage_drives(stage):
            bounds, last = goal, stage.name
            written, state = read_goal(stage.until), _state_after(stages, number)
            if goal.kind == "bounds" and written is not None and state is not None:
                drive = _together(structure, stage_drives(stage))
                if drive.name not in keys:
                    structure = replace(structure, drives=(*structure.drives, drive))
                    keys[drive.name] = drive.key
                transitions.append(
                    Transition(
                        name=stage.name,
                        drive=drive.name,
                        stage=number,
                        goal=goal.name,
                        state=state,
                        released=replace(goal, name=f"still {state}"),
                        measure=written.name,
                        kind=kinds.get(written.name, "angle"),
                        furthest="smallest" if written.relation == ">" else "largest",
                        begun=None,
                        wording=_wording(
                            state, " and ".join([*(each.state for each in transitions), state]), drive.key
                        ),
                    )
                )
        if stage.state is not None:
            states.append(
                RestState(
                    name=stage.state,
                    bounds=replace(bounds, name=stage.state, kind="bounds"),
                    missed=f"not {stage.state}",
                    unknown=f'after stage "{last or stage.name}"',
                )
            )
    return replace(
        structure,
        goals=tuple(goals.values()),
        states=tuple(states),
        stage_states=tuple(stage.state or "" for stage in stages),
        transitions=tuple(transitions),
    )


def drive_keys(design: PlatesDesign) -> tuple[str, ...]:
    """Keys of the values that say how strong the drives are."""
    return tuple(f"drive.{drive.name}.value" for drive in design.drive)


def static_keys(design: PlatesDesign) -> tuple[str, ...]:
    """Keys of what matters to where the plates rest, but for their tendons."""
    # without gravity they rest where they rest, however heavy they are
    return (*_STATIC_KEYS, "facet") if design.protocol.gravity else _STATIC_KEYS


def _wording(state: str, done: str, key: str) -> Wording:
    """How sentences speak of the way to a state, by the key of what drives it there."""
    return Wording(
        done=done,
        verb=f"get {state}",
        doing=f"getting {state}",
        stays=state,
        time=f"time to get {state}",
        noun=f"getting {state}",
        did=f"got {state}",
        if_stuck=f"Take a stronger drive ({key}), or lower what holds it back: crease.stiffness, or the tendons.",
        if_lost=(
            f"It got {state} under torque and did not stay so when released: tendons that pull it there or springs that"
            " rest there (crease.rest_angle) hold it."
        ),
    )


def _origin(pattern: CreasePattern, link: FacetLink) -> int:
    """The vertex in which a plate's axes begin: an end of the crease that it hangs on."""
    return pattern.faces_vertices[link.facet][0] if link.parent is None else link.tail


def _hinges(
    design: PlatesDesign, pattern: CreasePattern, links: Sequence[FacetLink]
) -> tuple[tuple[Hinge, ...], dict[int, int]]:
    """The hinges, in the order of their bodies, and their numbers by edge."""
    creases = creases_by_edge(design)
    hinges: list[Hinge] = []
    numbers: dict[int, int] = {}
    for body, link in enumerate(links):
        if link.edge is None or link.edge not in creases:
            continue
        crease = creases[link.edge]
        # the parent lies to the left of tail -> head: the plate on the right rises, a valley, about head -> tail
        along = pattern.vertices_coords[link.tail] - pattern.vertices_coords[link.head]
        length = float(np.linalg.norm(along))
        numbers[link.edge] = len(hinges)
        hinges.append(
            Hinge(
                name=f"crease{link.edge}",
                role=crease_role(pattern, link.edge),
                body=body,
                axis=along / length,
                sense=1 if pattern.edges_assignment[link.edge] == "V" else -1,
                lower=-crease.back_limit,
                upper=crease.fold_limit,
                stiffness=crease.stiffness * length,
                rest_angle=crease.rest_angle,
                damping=crease.damping * length,
                start=crease.start,
                label=f"crease {link.edge}",
            )
        )
    return tuple(hinges), numbers


def _ends(pattern: CreasePattern, chosen: object) -> tuple[SheetPlace, SheetPlace]:
    """The two places of a tendon or a distance."""
    return place_on(pattern, getattr(chosen, "from")), place_on(pattern, getattr(chosen, "to"))  # noqa: B009


def _edges_between(links: Sequence[FacetLink], one: int, other: int) -> list[int]:
    """Edges that lie on the way from one facet to another."""
    above = {link.facet: link for link in links}

    def way(facet: int) -> list[int]:
        edges = []
        while (edge := above[facet].edge) is not None:
            edges.append(edge)
            facet = above[facet].parent or 0
        return edges

    up, down = way(one), way(other)
    return [edge for edge in up if edge not in down] + [edge for edge in reversed(down) if edge not in up]


def _longest(pattern: CreasePattern, ends: tuple[SheetPlace, SheetPlace], crossed: Sequence[int]) -> float:
    """A length that the distance of two places cannot exceed, however the sheet folds.

    A way over the sheet from one to the other, straight from crease to crease, is as long in every folded state: here
    it goes where the straight line meets the creases, and is that line where it meets them all.
    """
    start, end = ends[0].position, ends[1].position
    way = [start]
    for edge in crossed:
        tail, head = pattern.vertices_coords[pattern.edges_vertices[edge]]
        along, line = head - tail, end - start
        turn = line[0] * along[1] - line[1] * along[0]
        share = (line[0] * (start - tail)[1] - line[1] * (start - tail)[0]) / turn if turn else 0.5
        way.append(tail + min(max(share, 0.0), 1.0) * along)
    return float(np.linalg.norm(np.diff([*way, end], axis=0), axis=1).sum())


def _largest_mass(design: PlatesDesign, structure: Structure) -> float:
    """Mass of the heaviest plate."""
    mass = max(mass_of(structure, body)[0] for body in range(len(structure.bodies)))
    if not 0 < mass < np.inf:
        raise InputError(
            f"facet.thickness and facet.density: need plates with a mass > 0 and finite, got {mass:g} kg, from"
            f" {design.facet.thickness:g} m and {design.facet.density:g} kg/m^3"
        )
    return mass


def _driven(structure: Structure, design: PlatesDesign) -> tuple[tuple[Motor, ...], tuple[Drive, ...]]:
    """Motors and drives: creases that the same drives act on share a motor."""
    numbers = {hinge.name: number for number, hinge in enumerate(structure.hinges)}
    acting = [{numbers[f"crease{edge}"] for edge in creases_of(design.sheet, drive.of)} for drive in design.drive]
    shared: dict[tuple[int, ...], list[int]] = {}
    for hinge in range(len(structure.hinges)):
        drives = tuple(number for number, hinges in enumerate(acting) if hinge in hinges)
        if drives:
            shared.setdefault(drives, []).append(hinge)
    motors = []
    for drives, hinges in shared.items():
        whole = [design.drive[number].of for number in drives if acting[number] == set(hinges)]
        name = whole[0] if whole else ", ".join(structure.hinges[hinge].name for hinge in hinges)
        motors.append(Motor(name=name, hinges=tuple(hinges)))
    rises = [design.protocol.rise if drive.rise is None else drive.rise for drive in design.drive]
    return tuple(motors), tuple(
        Drive(
            name=drive.name,
            shares=tuple(1.0 if number in drives else 0.0 for drives in shared),
            rise=rises[number],
            key=f"drive.{drive.name}.value",
            torque=drive.value,
            where=f"on {drive.of}" if drive.of.startswith("crease ") else f"on the {drive.of}",
        )
        for number, drive in enumerate(design.drive)
    )


def _together(structure: Structure, names: Sequence[str]) -> Drive:
    """The drives of a stage as one, which grow in proportion: of several, that of the first with the others' shares.

    One of no strength is no measure of the others: the first that has some is.
    """
    drives = [drive_of(structure, name) for name in names]
    lead = next((drive for drive in drives if drive.torque), drives[0])
    others = [drive for drive in drives if drive is not lead]
    if not others:
        return lead
    torques = [sum(each) for each in zip(*(drive.torques for drive in drives), strict=True)]
    return replace(
        lead,
        name=" and ".join(names),
        shares=tuple(torque / lead.torque if lead.torque else 0.0 for torque in torques),
        rise=max(drive.rise for drive in drives),
        where=f"{lead.where}, with {' and '.join(drive.name for drive in others)} in proportion",
    )


def _state_after(stages: Sequence[Stage], number: int) -> str | None:
    """The state that a driven stage leads to: its own, or that of the release which follows."""
    stage = stages[number]
    if stage.state is not None or number + 1 == len(stages) or stage_drives(stages[number + 1]):
        return stage.state
    return stages[number + 1].state
