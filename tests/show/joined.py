"""Two runs side by side as one run of one structure, whose parts are groups of bodies with mechanisms of their own."""

from dataclasses import replace

import numpy as np

from forficula.structure import GROUND, BodyGroup, Mechanism, mechanisms_of

KINDS = ("hinges", "springs", "tendons", "membranes", "couplings")
SERIES = ("point_position", "membrane_position", "hinge_angle", "tendon_energy", "tendon_length", "hinge_energy")


def joined_structure(parts):
    """One structure of several, by name; each is moved along y by its distance, m: (structure, distance)."""
    bodies, points, hinges, mechanisms, groups = [], [], [], [], []
    tables = {name: [] for name in ("bars", "plates", "facets", "springs", "tendons", "membranes", "couplings")}
    for name, (part, distance) in parts.items():
        first, start, turn = len(bodies), len(points), len(hinges)
        numbers = {kind: len(hinges if kind == "hinges" else tables[kind]) for kind in KINDS}

        def body(number, first=first):
            return GROUND if number == GROUND else number + first

        def on_points(item, start=start):
            return replace(item, points=tuple(point + start for point in item.points))

        shift = np.array([0.0, distance, 0.0])
        for item in part.bodies:
            moved = item.position + shift * (item.parent == GROUND)
            bodies.append(replace(item, name=f"{name}.{item.name}", parent=body(item.parent), position=moved))
        for item in part.points:
            moved = item.place + shift * (item.body == GROUND)
            points.append(replace(item, name=f"{name}.{item.name}", body=body(item.body), place=moved))
        for item in part.hinges:
            flaps = None if item.flaps is None else tuple(point + start for point in item.flaps)
            hinges.append(
                replace(item, name=f"{name}.{item.name}", role=f"{name}.{item.role}", body=body(item.body), flaps=flaps)
            )
        for item in part.bars:
            tables["bars"].append(replace(on_points(item), body=body(item.body)))
        for item in part.plates:
            tables["plates"].append(replace(on_points(item), body=body(item.body)))
        for kind in ("springs", "tendons"):
            tables[kind] += [replace(on_points(item), name=f"{name}.{item.name}") for item in getattr(part, kind)]
        for item in part.facets:
            tables["facets"].append(replace(on_points(item), inside=tuple(point + start for point in item.inside)))
        for item in part.membranes:
            carriers = np.where(item.bodies == GROUND, GROUND, item.bodies + first)
            tables["membranes"].append(replace(item, bodies=carriers, built=item.built + shift))
        for item in part.couplings:
            tables["couplings"].append(replace(item, hinges=tuple(hinge + turn for hinge in item.hinges)))
        groups.append(BodyGroup(name=name, bodies=tuple(range(first, len(bodies)))))
        mechanisms += [
            Mechanism(
                name=f"{name}: {mechanism.name}",
                **{kind: tuple(number + numbers[kind] for number in getattr(mechanism, kind)) for kind in KINDS},
            )
            for mechanism in mechanisms_of(part)
        ]
    whole = next(iter(parts.values()))[0]
    return replace(
        whole,
        bodies=tuple(bodies),
        points=tuple(points),
        hinges=tuple(hinges),
        masses=(),
        closures=(),
        limits=(),
        mechanisms=tuple(mechanisms),
        groups=tuple(groups),
        appearance=replace(whole.appearance, pattern=None, text=""),
        span=sum(part.span for part, _ in parts.values()),
        **{name: tuple(items) for name, items in tables.items()},
    )


def joined_run(parts):
    """One run of several, by name, at the times of the first: (record, distance along y in m)."""
    first = next(iter(parts.values()))[0]
    structure = joined_structure({name: (record.structure, distance) for name, (record, distance) in parts.items()})
    series = dict(first.series)
    for name in SERIES:
        columns = []
        for record, distance in parts.values():
            if name not in record.series:
                columns.append(np.zeros((len(first.time), len(record.structure.hinges))))
                continue
            values = record.series[name].reshape(len(record.time), -1)
            sampled = [np.interp(first.time, record.time, column) for column in values.T]
            sampled = np.array(sampled).reshape(values.shape[1], len(first.time)).T
            shape = (len(first.time), *record.series[name].shape[1:])
            sampled = sampled.reshape(shape)
            columns.append(sampled + np.array([0.0, distance, 0.0]) if name.endswith("_position") else sampled)
        series[name] = np.concatenate(columns, axis=1)
    return replace(first, structure=structure, series=series)
