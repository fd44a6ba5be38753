"""Loose square layers above a sheet of two panels, for tests of contact."""

from forficula.design import design_from_text

SIDE, THICK, DENSITY, G = 0.05, 1e-3, 1270.0, 9.81
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
bend_stiffness = "0.1 N m/rad/m"
[crease]
stiffness = "0.1 N m/rad/m"
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
    x, y, z = ("[" + ", ".join(f'"{value:.12g} m"' for value in axis) + "]" for axis in zip(*points, strict=True))
    values = {"x": x, "y": y, "z": z, "edges": edges, "facets": facets, "letters": "V" + "B" * (len(edges) - 1)}
    text = _TEXT.format(**values, thick=THICK, density=DENSITY, g=G, more=more)
    return design_from_text(text + (_STAGE.format(time=time) if stages is None else stages))


def support(part, axes="xyz"):
    """Return the section that holds a part along axes."""
    written = "" if part.startswith("facet") else f'axes = "{axes}"\n'
    return f'[[support]]\nof = "{part}"\n{written}'
