"""How a validation test tells the documentation what it compares."""

import json
from collections.abc import Callable

import numpy as np
import pytest


def pytest_collection_modifyitems(items):
    for item in items:
        if "agree" in getattr(item, "fixturenames", ()):
            item.add_marker(pytest.mark.compares)


@pytest.fixture
def agree(record_property) -> Callable[..., None]:
    """Hold our value to another one, and record both for the page of validation.

    Called with what is compared, ours, theirs, `by` whom theirs is, its `unit`, and `rel` or `abs` as of
    `pytest.approx`. Of arrays the worst element is told; `over` a name and values of an axis both are drawn there.
    """

    def compare(what, ours, theirs, *, by, unit="", rel=None, abs=None, over=None):
        first, second = np.broadcast_arrays(np.asarray(ours, dtype=float), np.asarray(theirs, dtype=float))
        allowed = np.maximum(0.0 if rel is None else rel * np.abs(second), abs or 0.0)
        off = np.abs(first - second)
        # where nothing is allowed, anything is the worst
        worst = int(np.argmax(np.where(allowed > 0, off / np.where(allowed > 0, allowed, 1), np.where(off, np.inf, 0))))
        told = {
            "what": what,
            "ours": first.flat[worst],
            "theirs": second.flat[worst],
            "allowed": np.broadcast_to(allowed, first.shape).flat[worst],
            "count": first.size,
            "unit": unit,
            "by": by,
        }
        if over is not None:
            name, axis = over
            some = np.unique(np.linspace(0, len(axis) - 1, 200).astype(int))
            told |= {"over": [name, np.asarray(axis)[some].tolist()]}
            told |= {"ours_all": first[some].tolist(), "theirs_all": second[some].tolist()}
        record_property("agreement", json.dumps(told))
        assert first == pytest.approx(second, rel=rel, abs=abs)

    return compare
