"""Random trees of bodies other than fans, with all parts that statics considers."""

from __future__ import annotations

import numpy as np

from forficula.material.law.tendon_law import TendonLaw
from forficula.structure import (
    GROUND,
    Bar,
    Body,
    Hinge,
    LengthLimit,
    Membrane,
    MembraneLaw,
    Plate,
    Point,
    Structure,
    Tendon,
    tendon_crossing,
)

LAW = MembraneLaw(youngs_modulus=1e6, poisson_ratio=0.3, thickness=1e-4, damping=0.0)


def rotation(random):
    """Return a random rotation."""
    axes, _ = np.linalg.qr(random.normal(size=(3, 3)))
    return axes * np.sign(np.linalg.det(axes))


def unit(random):
    vector = random.normal(size=3)
    return vector / np.linalg.norm(vector)


def tree(seed, bodies=6, *, gravity=0.0, membranes=True, law=None, limit=10.0):
    """Return branching bodies, on up to three hinges each, with tendons, limits and membranes between them."""
    random = np.random.default_rng(seed)
    parents = [GROUND, *(int(random.integers(-1, number)) for number in range(1, bodies))]
    frames = [rotation(random) for _ in parents]
    built = [
        Body(name=f"b{number}", role="body", parent=parent, position=random.uniform(-0.1, 0.1, 3), frame=frame)
        for number, (parent, frame) in enumerate(zip(parents, frames, strict=True))
    ]
    hinges = [
        Hinge(
            name=f"h{number}_{index}",
            role="hinge",
            body=number,
            axis=unit(random),
            sense=int(random.choice([-1, 1])),
            stiffness=float(random.uniform(0, 0.1)),
            rest_angle=float(random.uniform(-1, 1)),
            armature=1e-6,
        )
        for number in range(bodies)
        for index in range(random.integers(0, 4) if number else 1)
    ]
    points = [
        Point(name=f"p{number}_{index}", role="point", body=number, place=random.uniform(-0.1, 0.1, 3))
        for number in range(GROUND, bodies)
        for index in range(4)
    ]
    structure = Structure(
        name="tree",
        bodies=tuple(built),
        points=tuple(points),
        bars=(Bar(body=bodies - 1, end=random.uniform(0.05, 0.1, 3), diameter=0.01, density=1000.0, points=(0, 1)),),
        plates=(_plate(random),),
        hinges=tuple(hinges),
        span=0.3,
        mass=0.1,
        gravity=gravity,
    )
    spring = law or TendonLaw(rest_length=0.03, stiffness=(300.0, 2e3, 4e4))
    pairs = [(int(a), int(b)) for a, b in random.integers(0, len(points), (6, 2)) if a != b]
    tendons = tuple(
        Tendon(
            name=f"t{number}",
            role="tendon",
            points=pair,
            law=spring,
            longest=1.0,
            crossing=tendon_crossing(structure, pair),
        )
        for number, pair in enumerate(pairs)
    )
    limits = tuple(
        LengthLimit(name=f"l{number}", points=pair, built_length=0.1, most=0.01 * limit)
        for number, pair in enumerate(pairs[:3])
    )
    sheets = tuple(_sheet(structure, random, number) for number in range(3)) if membranes else ()
    parts = {"tendons": tendons, "limits": limits, "membranes": sheets}
    return Structure(**{**{name: getattr(structure, name) for name in structure.__dataclass_fields__}, **parts})


def _plate(random):
    """Return a triangle on the first body."""
    return Plate(body=0, points=(4, 5, 6), thickness=float(random.uniform(1e-3, 3e-3)), density=1000.0)


def _sheet(structure, random, number):
    """Return two or three triangles in a skew plane, on some of the bodies."""
    count = 4 + number % 2
    axes = rotation(random)[:, :2]
    flat = np.array([[0, 0], [0.05, 0], [0, 0.06], [0.05, 0.05], [0.09, 0.04]])[:count] + random.uniform(
        0, 0.01, (count, 2)
    )
    triangles = np.array([[0, 1, 2], [1, 3, 2], [1, 4, 3]])[: count - 2]
    return Membrane(
        name=f"m{number}",
        bodies=random.integers(-1, len(structure.bodies), count),
        places=random.uniform(-0.1, 0.1, (count, 3)),
        built=flat @ axes.T,
        triangles=triangles,
        law=LAW,
        margin=0.02,
    )
