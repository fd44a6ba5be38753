"""Designs of pieces that nothing joins, for tests of contact: loose squares, and a strip above a facet."""

from forficula.design import design_from_text

SIDE, WIDTH, THICK, DENSITY, G = 0.05, 0.02, 1e-3, 1270.0, 9.81  # WIDTH of a strip
LAYER = SIDE**2 * THICK * DENSITY  # kg
_TEXT = """
name = "loose layers"
source = "a test"
[pattern]
kind = "fold-file"
vertices_x = {x}
vertices_y = {y}
vertices_z = {z}
edges = {edges}
assignment = "{letters}"
facets = {facets}
[facet]
kind = "bars"
thickness = "{thick} m"
density = "{density} kg/m^3"
youngs_modulus = "5 MPa"
bend_stiffness = "{bend} N m/rad/m"
[crease]
stiffness = "{crease} N m/rad/m"
rest_angle = "flat"
damping = "1e-3 N m s/rad/m"
{more}
[protocol]
timestep = "0.05 ms"
sample_interval = "1 ms"
gravity = "{g} m/s^2"
contact = true
"""
_STAGE = """
[[protocol.stages]]
name = "rest"
drive = "none"
until = "time"
time_limit = "{time} s"
"""


def loose_layers(squares, base=SIDE, *, time=0.05, more="", stages=None):
    """Return the design of a sheet of two panels at the height 0 and squares above it that nothing joins.

    Args:
        squares: side, x and y of the first corner, and height of each square, m.
        base: side of the sheet, m.
        time: of the only stage, s, if `stages` is None.
        more: further sections.
        stages: tables of the stages.
    """
    points = [(x * base, y * base, 0.0) for x, y in ((0, 0), (0.5, 0), (1, 0), (1, 1), (0.5, 1), (0, 1))]
    edges, facets = [[1, 4], [0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0]], [[0, 1, 4, 5], [1, 2, 3, 4]]
    for side, left, front, height in squares:
        first = len(points)
        points += [(left + x * side, front + y * side, height) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        corners = list(range(first, first + 4))
        edges += [[corners[k], corners[(k + 1) % 4]] for k in range(4)]
        facets.append(corners)
    letters = "V" + "B" * (len(edges) - 1)
    return _design(
        points, edges, letters, facets, more=more, stages=_STAGE.format(time=time) if stages is None else stages
    )


def strip_above_facet(panels, length, height, stiffness):
    """Return the design of a strip of panels, clamped with its middle surface at a height above the facet below.

    The facet is held a thickness below the height 0. A panel that is held ends at x = 0 and clamps the strip.

    Args:
        panels: number of panels of the strip.
        length: of the strip, m.
        height: of the clamp, m.
        stiffness: bending stiffness of the strip per width, N m; each crease has that of a panel.
    """
    size = length / panels
    points = [(x, y, -THICK) for x, y in ((-0.03, -0.02), (0.12, -0.02), (0.12, 0.04), (-0.03, 0.04))]
    low, high = (range(first, first + panels + 2) for first in (4, panels + 6))
    points += [((panel - 1) * size, y, height) for y in (0.0, WIDTH) for panel in range(panels + 2)]
    borders = [[0, 1], [1, 2], [2, 3], [3, 0], [low[0], high[0]], [low[-1], high[-1]]]
    borders += [[row[panel], row[panel + 1]] for row in (low, high) for panel in range(panels + 1)]
    edges = [[low[panel], high[panel]] for panel in range(1, panels + 1)] + borders
    facets = [[0, 1, 2, 3]]
    facets += [[low[panel], low[panel + 1], high[panel + 1], high[panel]] for panel in range(panels + 1)]
    # half a panel bends about the clamp
    clamp = f'[[crease.group]]\nname = "clamp"\nof = "crease 0"\nstiffness = "{2 * stiffness / size} N m/rad/m"\n'
    return _design(
        points,
        edges,
        "V" * panels + "B" * len(borders),
        facets,
        more=clamp + support("facet 0") + support("facet 1"),
        stages=_STAGE.format(time=0.05),
        crease=stiffness / size,
        bend=100 * stiffness / size,
    )


def _design(points, edges, letters, facets, *, more, stages, crease=0.1, bend=0.1):
    x, y, z = ("[" + ", ".join(f'"{value:.12g} m"' for value in axis) + "]" for axis in zip(*points, strict=True))
    values = {"x": x, "y": y, "z": z, "edges": edges, "facets": facets, "letters": letters, "more": more}
    text = _TEXT.format(**values, thick=THICK, density=DENSITY, g=G, crease=crease, bend=bend)
    return design_from_text(text + stages)


def support(part, axes="xyz"):
    """Return the section that holds a part along axes."""
    written = "" if part.startswith("facet") else f'axes = "{axes}"\n'
    return f'[[support]]\nof = "{part}"\n{written}'
