from forficula.pattern.crease_pattern import (
    ASSIGNMENTS,
    CreasePattern,
    big_little_big_residuals,
    creases_around,
    interior_vertices,
    kawasaki_residuals,
    maekawa_residuals,
    sector_angles,
)
from forficula.pattern.earwig import EarwigFan, Tangent, earwig_pattern, hub_points, ring_vertices, tips, vein_gaps
from forficula.pattern.fold_file import read_fold, read_folded_frames, write_fold
from forficula.pattern.kinematics import (
    closure_residual,
    degree4_fold_angles,
    fan_fold_angles,
    folded_coordinates,
    folded_frames,
    opposite_fold_angle,
)
from forficula.pattern.svg_file import write_svg

__all__ = [
    "ASSIGNMENTS",
    "CreasePattern",
    "EarwigFan",
    "Tangent",
    "big_little_big_residuals",
    "closure_residual",
    "creases_around",
    "degree4_fold_angles",
    "earwig_pattern",
    "fan_fold_angles",
    "folded_coordinates",
    "folded_frames",
    "hub_points",
    "interior_vertices",
    "kawasaki_residuals",
    "maekawa_residuals",
    "opposite_fold_angle",
    "read_fold",
    "read_folded_frames",
    "ring_vertices",
    "sector_angles",
    "tips",
    "vein_gaps",
    "write_fold",
    "write_svg",
]
