"""Small nets for tests: trusses, and sheets of bars and creases from their facets."""

from collections.abc import Sequence

import numpy as np
from scipy.linalg import null_space, orth
from scipy.sparse import csr_array, eye_array

from forficula.material.law.crease_law import CreaseLaw
from forficula.statics.net.energy import built_shape
from forficula.statics.net.net import Net, NetCreases, Springs
from forficula.statics.net.rigidity import rigidity_matrix
from forficula.statics.net.supports import rigid_motions


def truss(nodes, bars, *, stiffness, rest=None, held=(), masses=None, gravity=0.0):
    """Return bars between nodes; `held` lists nodes, or pairs of node and axis."""
    nodes = np.asarray(nodes, dtype=float)
    bars = np.asarray(bars, dtype=np.int64).reshape(-1, 2)
    free = np.ones(nodes.shape, dtype=bool)
    for item in held:
        free[item] = False
    length = np.linalg.norm(nodes[bars[:, 1]] - nodes[bars[:, 0]], axis=1)
    return Net(
        nodes=nodes,
        free=free,
        points=csr_array(eye_array(len(nodes))),
        masses=np.ones(len(nodes)) if masses is None else np.asarray(masses, dtype=float),
        springs=Springs(
            points=bars,
            stiffness=np.broadcast_to(np.asarray(stiffness, dtype=float), len(bars)).copy(),
            rest_length=length if rest is None else np.broadcast_to(np.asarray(rest, dtype=float), len(bars)).copy(),
        ),
        gravity=gravity,
    )


def sheet(nodes, facets: Sequence[Sequence[int]], *, axial=1e4, crease=1.0, facet=1e2, rest=0.0, held=()):
    """Return a sheet of counterclockwise triangles and quadrilaterals: bars of EA = `axial`, springs per crease length.

    The second result marks the net's creases that are diagonals of facets.
    """
    nodes = np.asarray(nodes, dtype=float)
    triangles, diagonals = [], set()
    for item in facets:
        if len(item) == 3:
            triangles.append(tuple(item))
            continue
        a, b, c, d = item
        if np.linalg.norm(nodes[a] - nodes[c]) > np.linalg.norm(nodes[b] - nodes[d]):
            a, b, c, d = b, c, d, a
        triangles += [(a, b, c), (a, c, d)]
        diagonals.add(frozenset((a, c)))
    third = {(t[i], t[(i + 1) % 3]): t[(i + 2) % 3] for t in triangles for i in range(3)}
    bars = sorted({tuple(sorted(edge)) for edge in third})
    inner = [(i, j) for i, j in bars if (i, j) in third and (j, i) in third]
    points = np.array([(i, j, third[i, j], i, j, third[j, i]) for i, j in inner], dtype=np.int64).reshape(-1, 6)
    flat = np.array([frozenset(edge) in diagonals for edge in inner], dtype=bool)
    length = np.linalg.norm(nodes[points[:, 1]] - nodes[points[:, 0]], axis=1)
    net = truss(nodes, bars, stiffness=1.0, held=held)
    stiffness = np.where(flat, facet, crease) * length
    law = CreaseLaw(stiffness=stiffness, rest_angle=np.where(flat, 0.0, rest))
    springs = Springs(
        points=net.springs.points, stiffness=axial / net.springs.rest_length, rest_length=net.springs.rest_length
    )
    creases = NetCreases(points=points, law=law)
    return Net(nodes=nodes, free=net.free, points=net.points, masses=net.masses, springs=springs, creases=creases), flat


def miura(columns, rows, *, side=1.0, other=1.0, acute=np.pi / 3, fold=0.0):
    """Return nodes and facets of a Miura sheet; `fold`: angle of its facets to the plane (Schenk and Guest 2013)."""
    height = side * np.sin(fold) * np.sin(acute)
    cosine = np.cos(fold) * np.tan(acute)
    across = other * cosine / np.sqrt(1 + cosine**2)
    along = side * np.sqrt(1 - np.sin(fold) ** 2 * np.sin(acute) ** 2)
    shift = other / np.sqrt(1 + cosine**2)
    i, j = np.meshgrid(np.arange(columns + 1), np.arange(rows + 1), indexing="ij")
    nodes = np.stack((across * i, along * j + shift * (i % 2), height * (j % 2)), axis=-1).reshape(-1, 3)
    number = np.arange((columns + 1) * (rows + 1)).reshape(columns + 1, rows + 1)
    corners = (number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:])
    return nodes, np.stack(corners, axis=-1).reshape(-1, 4).tolist()


def mechanisms(net, stiff):
    """Return the first-order mechanisms of a net as built without supports, orthonormal, without rigid motions.

    By shape (mechanism, node, 3).
    """
    loose = null_space(rigidity_matrix(net, built_shape(net), stiff).toarray(), rcond=1e-6)
    whole = rigid_motions(net.nodes).reshape(net.nodes.size, -1)
    return orth(loose - whole @ (whole.T @ loose), rcond=1e-6).T.reshape(-1, *net.nodes.shape)
