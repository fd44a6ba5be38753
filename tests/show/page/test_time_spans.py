from dataclasses import replace

import pytest

from forficula.analysis import measure
from forficula.show.page.data.time_spans import run_spans, shared_spans
from forficula.show.page.playback import make_clip


@pytest.fixture(scope="module")
def clips(short_run, slow_run):
    return [make_clip(record, measure(record)) for record in (short_run, slow_run)]


def test_a_run_has_spans_for_the_whole_and_for_each_driven_stage(clips):
    whole, fold, unfold = run_spans(clips[0])
    assert (whole.start, whole.end) == (clips[0].time[0], clips[0].time[-1])
    assert (whole.whole, fold.whole, unfold.whole) == (True, False, False)
    for span, end in zip((fold, unfold), (clips[0].stages[1], clips[0].stages[3]), strict=True):
        assert span.name == end.stage.name
        assert span.start < end.start < end.goal_time < span.end
        assert span.end - span.start < 0.5 * (whole.end - whole.start)


def test_compared_runs_are_aligned_at_the_start_of_folding_and_of_each_stage(clips):
    whole, folding, unfolding, *rest = shared_spans(clips)
    starts = [tuple(clip.stages[stage].start for clip in clips) for stage in (1, 3)]
    assert (whole.name, whole.origins) == ("whole runs", starts[0])
    assert (folding.origins, unfolding.origins) == (starts[0], starts[1])
    assert starts[1][0] != starts[1][1]
    # runs that settle equally long would look the same aligned at their own starts
    assert rest == []
    for clip, origin in zip(clips, unfolding.origins, strict=True):
        goal = clip.stages[3].goal_time - origin
        assert unfolding.start < 0 < goal < unfolding.end


def test_runs_that_settle_for_different_times_can_also_be_seen_from_their_starts(clips):
    later = replace(clips[1], stages=tuple(replace(end, start=end.start + 0.1) for end in clips[1].stages))
    assert [span.name for span in shared_spans([clips[0], later])][-1] == "whole runs from their start"


def test_a_run_without_unfolding_does_not_remove_the_span_of_folding(clips):
    folds_only = replace(clips[1], stages=clips[1].stages[:3])
    names = [span.name for span in shared_spans([clips[0], folds_only])]
    assert names == ["whole runs", "folding"]
    settles_only = replace(clips[1], stages=clips[1].stages[:1])
    assert [span.name for span in shared_spans([clips[0], settles_only])] == ["whole runs from their start"]
