from forficula.show.page.compare_page import compare_runs
from forficula.show.page.run_page import write_run_page

__all__ = ["compare_runs", "write_run_page"]
