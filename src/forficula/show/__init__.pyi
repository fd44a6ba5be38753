from .folder.run_folder import write_run as write_run
from .folder.study_folder import write_study as write_study
from .progress import run_progress as run_progress
from .progress import study_progress as study_progress
from .run.angles_figure import draw_angles as draw_angles
from .run.energies_figure import draw_energies as draw_energies
from .run.folding_figure import draw_folding as draw_folding
from .run.outcome_table import outcome_table as outcome_table
from .run.outcome_table import print_events as print_events
from .run.outcome_table import print_outcome as print_outcome
from .run.outcome_table import print_storage as print_storage
from .run.outcome_table import print_strength as print_strength
from .structure.pattern_figure import draw_pattern as draw_pattern
from .study.study_table import print_study as print_study
from .style import save_figure as save_figure

__all__ = [
    "draw_angles",
    "draw_energies",
    "draw_folding",
    "draw_pattern",
    "outcome_table",
    "print_events",
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
