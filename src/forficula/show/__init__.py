from forficula.show.folder.run_folder import write_run
from forficula.show.folder.study_folder import write_study
from forficula.show.progress import run_progress, study_progress
from forficula.show.run.angles_figure import draw_angles
from forficula.show.run.energies_figure import draw_energies
from forficula.show.run.folding_figure import draw_folding
from forficula.show.run.outcome_table import outcome_table, print_outcome, print_storage, print_strength
from forficula.show.structure.pattern_figure import draw_pattern
from forficula.show.study.study_table import print_study
from forficula.show.style import save_figure

__all__ = [
    "draw_angles",
    "draw_energies",
    "draw_folding",
    "draw_pattern",
    "outcome_table",
    "print_outcome",
    "print_storage",
    "print_strength",
    "print_study",
    "run_progress",
    "save_figure",
    "study_progress",
    "write_run",
    "write_study",
]
