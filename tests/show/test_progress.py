"""Progress of a study: runs done, their rate, the time left, and their outcomes."""

import io
from time import monotonic, sleep

import pytest
from rich.console import Console

from forficula.show import progress

FOLDED = {"status": "folded", "verdict": "reached", "outcome": "folded", "folded": True}
STUCK = {"status": "stuck at -134.6 deg", "verdict": "stuck", "outcome": "stuck on the way", "folded": False}
DIVERGED = {"status": "diverged at t = 0.3 s", "verdict": "diverged", "outcome": "diverged", "folded": None}


@pytest.fixture
def clock(monkeypatch):
    """A clock that is set by hand, s."""
    now = [0.0]
    monkeypatch.setattr(progress, "monotonic", lambda: now[0])
    return now


@pytest.fixture
def screen(monkeypatch):
    """Return what is written to a terminal, or to a file in place of one."""

    def show(*, is_terminal, width=110):
        sent = io.StringIO()
        console = Console(file=sent, force_terminal=is_terminal, width=width, highlight=False, _environ={})
        monkeypatch.setattr(progress, "Console", lambda **_: console)
        return sent

    return show


def test_a_line_every_ten_seconds_has_counts_rate_time_left_and_outcomes(screen, clock):
    sent = screen(is_terminal=False)
    with progress.study_progress() as output:
        for number, row in enumerate([FOLDED, STUCK, FOLDED, DIVERGED, FOLDED], start=1):
            clock[0] += 4
            output(number, 20, row)
    assert sent.getvalue() == "3 of 20 runs, 0.25 runs/s, 68 s left: 2 folded, 1 stuck on the way\n"


def test_the_rate_excludes_runs_of_earlier_sessions(screen, clock):
    sent = screen(is_terminal=False)
    with progress.study_progress() as output:
        for done in (1001, 1002):
            clock[0] += 6
            output(done, 1200, FOLDED)
    # 2 runs in 12 s, and 198 left
    assert sent.getvalue() == "1002 of 1200 runs, 0.167 runs/s, 20 min left: 2 folded\n"


@pytest.mark.parametrize(
    ("seconds", "words"), [(0.2, "0 s"), (90, "90 s"), (300, "5 min"), (6000, "100 min"), (36e3, "10 h")]
)
def test_the_time_left_is_in_the_unit_that_reads_well(screen, clock, seconds, words):
    sent = screen(is_terminal=False)
    with progress.study_progress() as output:
        clock[0] += 20
        output(1, 1 + seconds / 20, FOLDED)
    assert f", {words} left: " in sent.getvalue()


def test_the_bar_of_a_terminal_says_the_same(screen, clock):
    sent = screen(is_terminal=True)
    with progress.study_progress() as output:
        clock[0] += 4
        output(1, 5, STUCK)
    assert "1 of 5 runs, 0.25 runs/s, 16 s left: 1 stuck" in sent.getvalue()


def test_a_narrow_terminal_keeps_every_count(screen, clock):
    sent = screen(is_terminal=True, width=50)
    with progress.study_progress() as output:
        clock[0] += 4
        for number, row in enumerate([FOLDED, STUCK, DIVERGED], start=1):
            output(number, 12345, row)
    for count in ("1 folded", "1 stuck", "1 diverged"):
        assert count in " ".join(sent.getvalue().split())


def test_only_long_steps_are_announced(monkeypatch, capsys):
    monkeypatch.setattr(progress, "_PATIENCE", 0.05)
    announced, end = "", monotonic() + 60
    with progress.waiting("working out a number"):
        while not announced and monotonic() < end:
            sleep(0.02)
            announced = capsys.readouterr().err
    assert announced == "working out a number ...\n"
    monkeypatch.setattr(progress, "_PATIENCE", 0.5)  # s; a busy machine stops the timer before
    with progress.waiting("something else") as stop:
        stop()
        sleep(0.6)
    assert capsys.readouterr().err == ""


def test_wings_of_a_map_and_designs_are_counted_now_and_then(monkeypatch, capsys):
    clock = iter([0.0, 1.0, 6.0, 6.0, 7.0])
    monkeypatch.setattr(progress, "monotonic", lambda: next(clock))
    line = progress.map_progress("wing")
    for done in (256, 512, 768):
        line(done, 100_000)
    assert capsys.readouterr().err == "512 of 100000 wings of the map\n"
