from forficula.study.running.run_study import RunCount


def numbers(count):
    return count.done, count.needed


def test_torques_above_the_least_opening_torque_count_as_completed():
    count = RunCount(done=3)
    count.plan([["a10", "a20", "a30", "a40"], ["b10", "b20"]])
    assert numbers(count) == (3, 9)
    count.count("a10")
    count.count("a20", needless=["a30", "a40"])
    assert numbers(count) == (7, 9)
    count.count("b10")
    # counted as if another machine had run it
    count.count("a40")
    assert numbers(count) == (8, 9)


def test_runs_that_results_require_are_added():
    count = RunCount(done=0)
    count.plan([["a10", "a20"], ["b10"]])
    count.count("a10")
    count.plan([["a20", "a15"], ["b10"]])
    assert numbers(count) == (1, 4)


def test_runs_no_longer_needed_count_as_completed():
    count = RunCount(done=0)
    count.plan([["a10", "a20", "a30"]])
    count.plan([["a10"]])
    assert numbers(count) == (2, 3)


def test_a_run_that_two_points_share_counts_once():
    count = RunCount(done=0)
    count.plan([["a10", "a20"], ["a10", "a20"]])
    count.count("a10", needless=["a20"])
    assert numbers(count) == (2, 2)


def test_later_points_count_as_needed_from_the_start():
    count = RunCount(done=0, later=5)
    assert numbers(count) == (0, 5)
    count.reach(3, done=1)
    # of three points one is completed, one is no valid wing, and one has a run
    count.plan([["a"]])
    assert numbers(count) == (2, 5)
    count.count("a")
    count.reach(2, done=0)
    count.plan([["b10", "b20"], ["c10", "c20"]])
    assert numbers(count) == (3, 7)
