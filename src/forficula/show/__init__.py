from forficula.show.folding_figure import draw_folding
from forficula.show.pattern_figure import draw_pattern
from forficula.show.progress import run_progress, study_progress
from forficula.show.run_folder import write_run
from forficula.show.study_folder import write_study
from forficula.show.study_table import print_study
from forficula.show.style import save_figure
from forficula.show.table import outcome_table, print_outcome
from forficula.show.time_figures import draw_angles, draw_energies

__all__ = [
    "draw_angles",
    "draw_energies",
    "draw_folding",
    "draw_pattern",
    "outcome_table",
    "print_outcome",
    "print_study",
    "run_progress",
    "save_figure",
    "study_progress",
    "write_run",
    "write_study",
]
