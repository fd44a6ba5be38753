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
from forficula.pattern.fold_file import fold_pattern, read_fold, read_folded_frames
from forficula.pattern.fold_writer import write_fold
from forficula.pattern.kinematics import (
    degree4_fold_angles,
    fan_fold_angles,
    folded_coordinates,
    folded_frames,
)
from forficula.pattern.pattern_file import PATTERN_FILES, read_pattern
from forficula.pattern.pleats import pleat_pattern
from forficula.pattern.svg_file import write_svg

__all__ = [
    "ASSIGNMENTS",
    "PATTERN_FILES",
    "CreasePattern",
    "EarwigFan",
    "FacetLink",
    "Tangent",
    "VertexCheck",
    "big_little_big_residuals",
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
    "maekawa_residuals",
    "pattern_text",
    "pleat_pattern",
    "read_drawing",
    "read_fold",
    "read_folded_frames",
    "read_pattern",
    "ring_vertices",
    "sectors_between",
    "tips",
    "vein_gaps",
    "vertex_checks",
    "write_fold",
    "write_svg",
]
