# Public names, each with the module that defines it. They are imported at first use, because MuJoCo and xarray are slow
# to import and not always needed.
from . import make as make
from . import material as material
from . import pattern as pattern
from . import results as results
from .analysis import Outcome as Outcome
from .analysis import Verdict as Verdict
from .analysis import measure as measure
from .analysis.run import Run as Run
from .calls import Progress as Progress
from .calls import assumptions as assumptions
from .calls import check_design as check_design
from .calls import compare as compare
from .calls import converge as converge
from .calls import examples as examples
from .calls import export as export
from .calls import figure as figure
from .calls import film as film
from .calls import identify as identify
from .calls import landscape as landscape
from .calls import load_run as load_run
from .calls import new_study as new_study
from .calls import optimise as optimise
from .calls import page as page
from .calls import pattern_facts as pattern_facts
from .calls import quasi_static_path as quasi_static_path
from .calls import run as run
from .calls import run_cycles as run_cycles
from .calls import run_study as run_study
from .calls import save as save
from .calls import sweep as sweep
from .calls import tolerance as tolerance
from .calls import trace as trace
from .calls import trace_clicks as trace_clicks
from .design import Design as Design
from .design import load_design as load_design
from .design import save_design as save_design
from .design import scale_design as scale_design
from .errors import InputError as InputError
from .statics import EnergyLandscape as EnergyLandscape
from .structure import structure_of as structure_of
from .study import Study as Study
from .study import load_study as load_study

__version__: str
