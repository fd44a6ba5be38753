from forficula.study.files.study_file import load_study, named_studies
from forficula.study.running.cluster import dask_cluster, slurm_script
from forficula.study.running.run_study import collect, estimate, run_study
from forficula.study.study import Study
from forficula.study.tables.table_rows import json_rows, table_csv

__all__ = [
    "Study",
    "collect",
    "dask_cluster",
    "estimate",
    "json_rows",
    "load_study",
    "named_studies",
    "run_study",
    "slurm_script",
    "table_csv",
]
