"""Results for goals on a Dask cluster are bitwise the same as on this machine."""

import pytest
import xarray

from forficula.design import load_design
from forficula.goals import goal_of
from forficula.goals.identify import observations_of
from forficula.goals.identify.run_identify import identify
from forficula.goals.optimise import optimise_goal
from forficula.goals.tolerance import assess_tolerance
from forficula.goals.tolerance.question_file import question_of
from forficula.goals.tolerance.tolerance_table import tolerance_table
from forficula.study import dask_cluster
from tests.letters import QUICK

distributed = pytest.importorskip("distributed", reason="Dask is not installed: pip install 'forficula[cluster]'")

DESIGN = load_design("letter-fold", QUICK)
STIFFNESS = {"tendon.left.stiffness": {"low": "0.4 N/cm", "high": "0.6 N/cm"}}


@pytest.fixture(scope="module")
def address():
    """A cluster of two workers with one thread each, in this process."""
    with (
        pytest.MonkeyPatch.context() as patch,
        distributed.LocalCluster(
            n_workers=2,
            threads_per_worker=1,
            processes=False,
            protocol="tcp://",
            dashboard_address="127.0.0.1:0",
            silence_logs="CRITICAL",
        ) as cluster,
    ):
        # otherwise runs as short as these would all be done in this process
        patch.setattr("forficula.study.running.cluster._LEAST_SECONDS", 0.05)
        yield cluster.scheduler_address


def optimised(folder, cluster):
    goal = goal_of(
        {
            "name": "closes",
            "design": DESIGN,
            "vary": STIFFNESS,
            "objectives": {"close_work": "least"},
            "search": {"runs": 8, "batch": 8},
        }
    )
    return optimise_goal(goal, folder, cluster=cluster).table


def tolerated(folder, cluster):
    question = question_of(DESIGN, {"facet.thickness": "1 %"})
    return tolerance_table(assess_tolerance(question, folder, minutes=0.01, cluster=cluster))


def identified(folder, cluster):
    fact = {"name": "soon", "quantity": "close_time", "until": "close", "absent": "2 s", "at_most": "0.3 s"}
    unknown = {"tendon.left.stiffness": {"distribution": "uniform", "low": "0.2 N/cm", "high": "1 N/cm"}}
    sampling = {"samples": 16, "directed": 0}
    tables = {"design": DESIGN, "unknown": unknown, "sampling": sampling, "fact": [fact]}
    return identify(observations_of(tables), folder, cluster=cluster)


@pytest.mark.parametrize("answer", [optimised, tolerated, identified])
def test_a_cluster_gives_the_same_rows_as_this_machine(answer, address, tmp_path):
    chunks = []
    with dask_cluster(address) as cluster:

        def counted(designs, until_last):
            chunks.append(len(designs))
            yield from cluster(designs, until_last)

        present = answer(tmp_path / "there", counted)
    assert sum(chunks) >= 8
    xarray.testing.assert_identical(present, answer(tmp_path / "here", None))
