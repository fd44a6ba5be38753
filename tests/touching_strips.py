"""Strips of facets whose layers touch, for tests: folds, zigzags, two layers beside a spine, and a letter fold."""

from functools import cache

from forficula.design import design_from_text
from forficula.statics.net.driven.net_course import released
from forficula.statics.net.net_of import net_of, start_shape
from forficula.structure import structure_of

WIDTH = 0.02
STIFFNESS = 0.5 * WIDTH  # of a crease, N m/rad
LENGTH, LAYER, SPINE, THICK = 0.04, 0.037, 1.001e-3, 1e-3
FACETS = {
    "nodes": 'kind = "bars"\nyoungs_modulus = "1e9 Pa"\nthickness = "0.3 mm"\ndensity = "1 g/cm^3"',
    "plates": 'kind = "rigid"\nthickness = "0.3 mm"\ndensity = "1 g/cm^3"',
}
LENGTHS = {
    "fold": ["4 cm", "4 cm"],
    "zigzag": ["4 cm", "4 cm", "4 cm", "4 cm"],
    "strip": ["3.7 cm", "1.001 mm", "4 cm"],
    "letter": ["3.7 cm", "1.001 mm", "4 cm", "2.002 mm", "3.7 cm"],
    "flap": ["3.7 cm", "4 cm", "4 cm"],
}
HELD = {"fold": 0, "zigzag": 0, "strip": 2, "letter": 2, "flap": 1}
DRIVES = {
    "torque": '[[drive]]\nname = "fold"\nkind = "torque"\nof = "creases"\nvalue = "4 N cm"\nrise = "1 s"',
    # on both corners of the free edge of a strip
    "force": '[[drive]]\nname = "press"\nkind = "force"\nof = ["vertex 0", "vertex 4"]\ndirection = [0, 0, -1]\n'
    'value = "0.4 N"\nrise = "1 s"',
}
_TEXT = """
name = "strip"
source = "a test"
[pattern]
kind = "pleats"
panels = {count}
panel_lengths = {lengths}
width = "2 cm"
assignment = "{assignment}"
[facet]
{facets}
[crease]
stiffness = "0.5 N m/rad/m"
rest_angle = "{rest}"
damping = "2e-2 N m s/rad/m"
[contact]
thickness = "{thickness}"
[[support]]
of = "facet {held}"
{drive}
[protocol]
timestep = "0.2 ms"
sample_interval = "1 ms"
rest_speed = "0.5 deg/s"
window = "0.1 s"
contact = true
gravity = "0 m/s^2"
[[protocol.stages]]
name = "release"
drive = "none"
until = "rest"
state = "closed"
hold = "0 s"
time_limit = "5 s"
"""


def strip(kind, facets="nodes", *, rest="100 deg", thickness="1 mm", drive="torque"):
    """Return the design of a strip with its first facet, or its middle layer, held."""
    text = _TEXT.format(
        count=len(LENGTHS[kind]),
        lengths=str(LENGTHS[kind]).replace("'", '"'),
        facets=FACETS[facets],
        rest=rest,
        assignment="VM" if kind == "zigzag" else "V",
        thickness=thickness,
        held=HELD[kind],
        drive=DRIVES[drive],
    )
    return design_from_text(text)


@cache
def rest_of(kind, facets="nodes", **settings):
    """Return the structure, the net and the resting shape of a strip that is released flat."""
    structure = structure_of(strip(kind, facets, **settings))
    net = net_of(structure)
    return structure, net, released(net, start_shape(structure, net))[0]


def crease_angles(structure, angles):
    """Return the fold angles of the creases, without those of facet bends, rad, (crease,)."""
    return angles[..., [number for number, hinge in enumerate(structure.hinges) if hinge.name.startswith("crease")]]
