from .compare_page import compare_runs as compare_runs
from .run_page import write_run_page as write_run_page
