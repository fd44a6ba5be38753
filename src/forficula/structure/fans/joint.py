"""The structure of a joint: two bars with a hinge and a tendon between them; the proximal bar is held."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from forficula.design import JointDesign
from forficula.quantities import show_value
from forficula.structure.appearance import Appearance
from forficula.structure.fans.vein import Vein
from forficula.structure.fans.vein_parts import bare_veins, vein_masses
from forficula.structure.protocol import with_protocol
from forficula.structure.structure import Structure

_LABEL = "hinge"


def joint_structure(design: JointDesign) -> Structure:
    """Build the bars, the hinge and the tendon of a joint, in the units of its design.

    The hinge lies along +y through the origin. As in a fan, folding has negative angles in the hinge's own sense.
    """
    veins = (joint_vein(design),)
    bare = bare_veins(design, veins, masses=vein_masses(design, veins), labels=[_LABEL])
    chosen = design.pattern
    appearance = Appearance(
        whole="joint",
        crease="crease",
        overbend="overbend",
        text=(
            f"A joint of two bars, {show_value(chosen.proximal_length, 'm')} up to its hinge, which is held, and"
            f" {show_value(chosen.distal_length, 'm')} beyond it"
        ),
        sizes={"proximal length": chosen.proximal_length, "distal length": chosen.distal_length},
        titles={"distal_angle": "hinge angle", "ring": "hinge angle"},
        pattern=chosen.sheet,
    )
    # closed forms use the actual hinge, not one with bars normal to its axis
    tendons = tuple(replace(tendon, ideal=None) for tendon in bare.tendons)
    return with_protocol(replace(bare, tendons=tendons, appearance=appearance), design)


def joint_vein(design: JointDesign) -> Vein:
    """Return the positions of a joint's bars in the flat sheet, and the sense in which they fold."""
    pattern = design.pattern.sheet
    proximal, distal = (
        pattern.vertices_coords[pattern.edges_vertices[pattern.edges_role.index(role)]]
        for role in ("proximal", "distal")
    )
    return Vein(
        places=(proximal[0], proximal[1], distal[1]),
        axes=(np.array([0.0, 1.0, 0.0]),),
        sense=1 if design.pattern.sense == "valley" else -1,
        fixed_base=True,
    )
