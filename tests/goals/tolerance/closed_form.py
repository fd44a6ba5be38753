"""Rows of runs whose margins are closed forms of the design's values, in place of a simulation."""

import time
from dataclasses import replace

import numpy as np
import pytest

from forficula.design import key_value
from forficula.goals.deviation import Deviation, deviation_widths
from forficula.goals.tolerance import Question, assess_tolerance
from forficula.goals.tolerance.plan import PLANS
from forficula.goals.tolerance.saved_plan import saved_plan
from forficula.structure import structure_of
from forficula.study.running.evaluate import row_key


def uniform(key, size=0.1):
    return Deviation(key=key, distribution="uniform", size=size, relative=True)


class ClosedForm:
    """Works if a function of the offsets is above 0; counts its runs, takes time, s, and can be interrupted."""

    def __init__(self, base, deviations, margin, *, untrusted=None, killed_after=None, pause=0.0):
        self.base, self.deviations, self.margin = base, deviations, margin
        self.untrusted, self.killed_after = untrusted or (lambda _: False), killed_after
        self.pause = pause
        self.own = np.array([key_value(base, deviation.key) for deviation in deviations])
        self.widths = deviation_widths(base, deviations)
        self.transitions = structure_of(base).transitions
        self.runs = 0

    def offsets(self, design):
        values = np.array([key_value(design, deviation.key) for deviation in self.deviations])
        return (values - self.own) / self.widths

    def __call__(self, designs, _until_last):
        for design in designs:
            if self.killed_after is not None and self.runs >= self.killed_after:
                raise KeyboardInterrupt
            self.runs += 1
            time.sleep(self.pause)
            yield self.row(design)

    def row(self, design):
        offsets = self.offsets(design)
        margin = float(np.clip(self.margin(offsets), -1, 1))
        works = margin > 0
        if self.untrusted(offsets):
            verdict, margin, works = "untrusted", -1.0, False
        else:
            verdict = "reached" if works else "stuck"
        last = self.transitions[-1]
        return {
            "key": row_key(design),
            "status": verdict,
            "verdict": verdict,
            "outcome": last.wording.done if works else f"did not {last.wording.verb}",
            "goal": last.name,
            **{transition.state: works or transition is not last for transition in self.transitions},
            **{f"{transition.name}_margin": margin if transition is last else 1.0 for transition in self.transitions},
        }


KEYS = ("tendon.left.stiffness", "tendon.left.rest_length", "crease.stiffness", "facet.thickness", "facet.density")
# of 4 factors 2 are kept, so that the screening is used
SMALL = replace(PLANS[2], kept=2, screened=8, rows=32, points=128, cells=5)
LINE = replace(PLANS[3], points=64)
FACTORS = [uniform(key) for key in KEYS]
WEIGHTS = np.array([0.0, 0.2, 0.0, -0.1, 0.0])

# no point of a bisection or a map lies on it
EDGE = 0.1493


def line(offsets):
    """Margin of a design: fails where the second is high and the fourth is low."""
    return EDGE - float(offsets @ WEIGHTS)


def question_about(design):
    return Question(design=design, deviations=tuple(FACTORS))


def assessed(design, folder, plan, margin, shard=(1, 1), **closed_form):
    """Result of a tolerance analysis with a plan that is in its folder."""
    question, cluster = question_about(design), ClosedForm(design, FACTORS, margin, **closed_form)
    folder.mkdir(exist_ok=True)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("forficula.goals.tolerance.saved_plan.PLANS", (plan,))
        saved_plan(folder, question, 5.0, 0, plan)
        return assess_tolerance(question, folder, shard=shard, cluster=cluster)
