"""Every number is, bit for bit, what it was when its digest was kept; see `digests.py`.

A few cases here, all of them, some two minutes, with FORFICULA_ALL_DIGESTS=1.
"""

import os
from functools import cache

import pytest

from tests.validation.digests import CASES, FEW, canary, differences, digests, kept_digests


@cache
def elsewhere():
    """What other libraries or another processor compute otherwise than where the digests were made."""
    return differences(kept_digests()["canary"], canary())


@pytest.mark.parametrize("case", CASES if os.environ.get("FORFICULA_ALL_DIGESTS") else FEW)
def test_numbers_are_those_that_were_kept(case):
    if elsewhere():
        pytest.skip(f"last bits depend on processor and libraries, and these are others: {'; '.join(elsewhere())}")
    assert differences(kept_digests()[case], digests(case)) == []


def test_every_case_was_kept():
    assert set(kept_digests()) == {"canary", *CASES}
