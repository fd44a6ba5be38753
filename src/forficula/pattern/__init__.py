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
from forficula.pattern.drawing_file import read_drawing
from forficula.pattern.earwig import EarwigFan, Tangent, earwig_pattern, hub_points, ring_vertices, tips, vein_gaps
from forficula.pattern.facet_tree import FacetLink, edges_between, facet_tree
from forficula.pattern.flat_folding import VertexCheck, flat_folding_faults, pattern_text, vertex_checks
from forficula.pattern.fold_angles import built_fold_angles, kept_as_built
from forficula.pattern.fold_file import fold_pattern, read_fold, read_folded_frames
from forficula.pattern.fold_writer import write_fold
from forficula.pattern.kinematics import (
    degree4_fold_angles,
    fan_fold_angles,
    folded_coordinates,
    folded_frames,
)
from forficula.pattern.kresling import (
    KreslingLengths,
    KreslingState,
    kresling_lengths,
    kresling_other_state,
    kresling_pattern,
)
from forficula.pattern.miura_ori import MiuraSize, miura_pattern, miura_size
from forficula.pattern.pattern_file import PATTERN_FILES, read_pattern
from forficula.pattern.pleats import pleat_pattern
from forficula.pattern.svg_file import write_svg
from forficula.pattern.triangulation import Triangulation, triangulated
from forficula.pattern.vertex import vertex_pattern
from forficula.pattern.waterbomb import Apex, waterbomb_base, waterbomb_pattern
from forficula.pattern.yoshimura import yoshimura_pattern, yoshimura_tube

__all__ = [
    "ASSIGNMENTS",
    "PATTERN_FILES",
    "Apex",
    "CreasePattern",
    "EarwigFan",
    "FacetLink",
    "KreslingLengths",
    "KreslingState",
    "MiuraSize",
    "Tangent",
    "Triangulation",
    "VertexCheck",
    "big_little_big_residuals",
    "built_fold_angles",
    "creases_inside",
    "degree4_fold_angles",
    "earwig_pattern",
    "edges_between",
    "facet_tree",
    "fan_fold_angles",
    "flat_folding_faults",
    "fold_pattern",
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
    "pattern_text",
    "pleat_pattern",
    "read_drawing",
    "read_fold",
    "read_folded_frames",
    "read_pattern",
    "ring_vertices",
    "sectors_between",
    "tips",
    "triangulated",
    "vein_gaps",
    "vertex_checks",
    "vertex_pattern",
    "waterbomb_base",
    "waterbomb_pattern",
    "write_fold",
    "write_svg",
    "yoshimura_pattern",
    "yoshimura_tube",
]
