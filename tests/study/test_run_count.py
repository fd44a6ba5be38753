from forficula.study.run_count import RunCount


def row(key, opened=False):
    return {"key": key, "opened": opened}


def numbers(tally):
    return tally.done, tally.needed


def test_torques_above_the_least_that_opens_are_done_without_being_run():
    tally = RunCount(done=3)
    tally.plan([["a10", "a20", "a30", "a40"], ["b10", "b20"]])
    assert numbers(tally) == (3, 9)
    tally.count(row("a10"))
    tally.count(row("a20", opened=True))
    assert numbers(tally) == (7, 9)
    tally.count(row("b10"))
    # run all the same, where another machine had it
    tally.count(row("a40"))
    assert numbers(tally) == (8, 9)


def test_what_results_ask_for_is_added_to_what_was_known():
    tally = RunCount(done=0)
    tally.plan([["a10", "a20"], ["b10"]])
    tally.count(row("a10"))
    tally.plan([["a20", "a15"], ["b10"]])
    assert numbers(tally) == (1, 4)


def test_what_is_not_asked_for_any_more_is_done_and_what_is_needed_does_not_shrink():
    tally = RunCount(done=0)
    tally.plan([["a10", "a20", "a30"]])
    tally.plan([["a10"]])
    assert numbers(tally) == (2, 3)


def test_a_run_that_two_points_share_counts_once():
    tally = RunCount(done=0)
    tally.plan([["a10", "a20"], ["a10", "a20"]])
    tally.count(row("a10", opened=True))
    assert numbers(tally) == (2, 2)


def test_points_that_come_later_are_needed_from_the_start_and_done_with_their_runs():
    tally = RunCount(done=0, later=5)
    assert numbers(tally) == (0, 5)
    tally.reach(3, done=1)
    # of three points one is done, one is no wing, and one has a run
    tally.plan([["a"]])
    assert numbers(tally) == (2, 5)
    tally.count(row("a"))
    tally.reach(2, done=0)
    tally.plan([["b10", "b20"], ["c10", "c20"]])
    assert numbers(tally) == (3, 7)
