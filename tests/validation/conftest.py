"""Fixtures with which validation tests report their comparisons to the documentation."""

import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

# worst comparison of the running test for every compared quantity and reference
_TOLD: dict[tuple[Any, ...], dict[str, Any]] = {}


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item):
    _TOLD.clear()
    try:
        return (yield)
    finally:
        item.user_properties += [("agreement", json.dumps(item)) for item in _TOLD.values()]


def _tell(key: tuple[Any, ...], strain: float, report: dict[str, Any]) -> None:
    """Keep a comparison if it is nearer to its bound than earlier ones under the same words."""
    before = _TOLD.get(key)
    count = report["count"] + (0 if before is None else before["count"])
    if before is None or not strain <= before["strain"]:
        _TOLD[key] = report | {"strain": strain}
    _TOLD[key]["count"] = count


@pytest.fixture(scope="session")  # stateless, so property tests and fixtures of modules may use it
def agree() -> Callable[..., None]:
    """Compare a value with a reference value, and record both for the page of validation.

    Arguments are the name of the quantity, our value, the reference value, its source `by`, its `unit`, and the allowed
    difference: the larger one of the share `rel` of the reference and of `abs`; 0 if neither is given. For arrays, and
    for all comparisons of a test under the same words, the worst one is reported. With `over`, a name and values of an
    axis, both curves are drawn on the page.
    """

    def compare(what, ours, theirs, *, by, unit="", rel=None, abs=None, over=None):
        first, second = np.broadcast_arrays(np.asarray(ours, dtype=float), np.asarray(theirs, dtype=float))
        limits = np.maximum(0.0 if rel is None else rel * np.abs(second), 0.0 if abs is None else abs)
        allowed = np.broadcast_to(limits, first.shape)
        off = np.abs(first - second)
        # if no difference is allowed, any difference counts as infinite
        shares = np.where(allowed > 0, off / np.where(allowed > 0, allowed, 1), np.where(off == 0, 0, np.inf))
        worst = int(np.argmax(np.where(np.isnan(shares), np.inf, shares)))
        output = {
            "what": what,
            "ours": first.flat[worst],
            "theirs": second.flat[worst],
            "allowed": allowed.flat[worst],
            "count": first.size,
            "unit": unit,
            "by": by,
        }
        if over is not None:
            name, axis = over
            some = np.unique(np.linspace(0, len(axis) - 1, 200).astype(int))
            output |= {"over": [name, np.asarray(axis, dtype=float)[some].tolist()]}
            output |= {"ours_all": first[some].tolist(), "theirs_all": second[some].tolist()}
        _tell(("agree", what, by, unit), float(shares.flat[worst]), output)
        assert np.all(off <= allowed), (
            f"{what}: got {output['ours']}, {by}: {output['theirs']}; allowed difference {output['allowed']}"
        )

    return compare


@pytest.fixture(scope="session")
def holds() -> Callable[..., None]:
    """Check a value against bounds, and record both for the page of validation.

    Arguments are the name of the quantity, its value, one or both of the bounds `above` and `below`, its `unit`, and
    the source `by` of the bound. For arrays, and for all checks of a test under the same words, the value nearest to
    its bound is reported.
    """

    def hold(what, value, *, above=None, below=None, unit="", by=""):
        assert not (above is None and below is None), "needs a bound"
        values = np.asarray(value, dtype=float).ravel()
        beyond = np.full(values.shape, -np.inf)
        if above is not None:
            beyond = np.maximum(beyond, above - values)
        if below is not None:
            beyond = np.maximum(beyond, values - below)
        worst = int(np.argmax(np.where(np.isnan(beyond), np.inf, beyond)))
        output = {"what": what, "ours": values[worst], "above": above, "below": below}
        output |= {"count": values.size, "unit": unit, "by": by}
        _tell(("hold", what, by, unit, above, below), float(beyond[worst]), output)
        assert np.all(beyond < 0), f"{what}: {values[worst]}, needs > {above} and < {below}"

    return hold
