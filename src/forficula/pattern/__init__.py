from forficula.pattern.crease_pattern import (
    ASSIGNMENTS,
    CreasePattern,
    big_little_big_residuals,
    creases_inside,
    interior_vertices,
    kawasaki_residuals,
    maekawa_residuals,
    sectors_between,
)
from forficula.pattern.drawings.drawing_file import read_drawing
from forficula.pattern.drawings.svg_file import write_svg
from forficula.pattern.facet_tree import FacetLink, central_facet, edges_between, facet_tree
from forficula.pattern.facts.flat_folding import (
    VertexCheck,
    flat_folding_faults,
    flat_folding_text,
    vertex_checks,
)
from forficula.pattern.facts.pattern_facts import Freedoms, PatternFacts, pattern_facts
from forficula.pattern.facts.rigid_folding import begins_as_assigned, folded_as_assigned, vertex_folds
from forficula.pattern.facts.rigidity import Rigidity, rigidity
from forficula.pattern.facts.vertex_closure import degree4_closure, vertex_freedoms, vertex_walk
from forficula.pattern.facts.vertex_creases import VertexCreases, vertex_creases
from forficula.pattern.facts.vertex_facts import VertexFacts, fault_words, vertex_facts
from forficula.pattern.families.earwig import (
    EarwigFan,
    Tangent,
    earwig_pattern,
    hub_points,
    ring_directions,
    ring_vertices,
    tips,
    vein_gaps,
    vein_roles,
)
from forficula.pattern.families.hinged_strip import strip_pattern
from forficula.pattern.families.kresling import (
    KreslingLengths,
    KreslingState,
    kresling_lengths,
    kresling_other_state,
    kresling_pattern,
)
from forficula.pattern.families.miura_ori import MiuraSize, miura_pattern, miura_size
from forficula.pattern.families.pleats import pleat_pattern
from forficula.pattern.families.vertex import vertex_pattern
from forficula.pattern.families.waterbomb import Apex, waterbomb_base, waterbomb_pattern
from forficula.pattern.families.yoshimura import yoshimura_pattern, yoshimura_tube
from forficula.pattern.files.fold_file import fold_pattern, read_fold, read_folded_frames
from forficula.pattern.files.fold_writer import write_fold
from forficula.pattern.files.pattern_file import PATTERN_FILES, read_pattern
from forficula.pattern.fold_angles import built_fold_angles, kept_as_built
from forficula.pattern.kinematics import (
    degree4_fold_angles,
    fan_fold_angles,
    folded_coordinates,
    folded_frames,
)
from forficula.pattern.triangulation import Triangulation, triangulated

__all__ = [
    "ASSIGNMENTS",
    "PATTERN_FILES",
    "Apex",
    "CreasePattern",
    "EarwigFan",
    "FacetLink",
    "Freedoms",
    "KreslingLengths",
    "KreslingState",
    "MiuraSize",
    "PatternFacts",
    "Rigidity",
    "Tangent",
    "Triangulation",
    "VertexCheck",
    "VertexCreases",
    "VertexFacts",
    "begins_as_assigned",
    "big_little_big_residuals",
    "built_fold_angles",
    "central_facet",
    "creases_inside",
    "degree4_closure",
    "degree4_fold_angles",
    "earwig_pattern",
    "edges_between",
    "facet_tree",
    "fan_fold_angles",
    "fault_words",
    "flat_folding_faults",
    "flat_folding_text",
    "fold_pattern",
    "folded_as_assigned",
    "folded_coordinates",
    "folded_frames",
    "hub_points",
    "interior_vertices",
    "kawasaki_residuals",
    "kept_as_built",
    "kresling_lengths",
    "kresling_other_state",
    "kresling_pattern",
    "maekawa_residuals",
    "miura_pattern",
    "miura_size",
    "pattern_facts",
    "pleat_pattern",
    "read_drawing",
    "read_fold",
    "read_folded_frames",
    "read_pattern",
    "rigidity",
    "ring_directions",
    "ring_vertices",
    "sectors_between",
    "strip_pattern",
    "tips",
    "triangulated",
    "vein_gaps",
    "vein_roles",
    "vertex_checks",
    "vertex_creases",
    "vertex_facts",
    "vertex_folds",
    "vertex_freedoms",
    "vertex_pattern",
    "vertex_walk",
    "waterbomb_base",
    "waterbomb_pattern",
    "write_fold",
    "write_svg",
    "yoshimura_pattern",
    "yoshimura_tube",
]
