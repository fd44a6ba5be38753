"""The table of a study as a notebook shows it. Only what makes one imports this, for xarray takes long to load."""

from __future__ import annotations

import xarray

from forficula.displayed import Displayed


class StudyTable(Displayed, xarray.Dataset):  # type: ignore[no-untyped-call]
    """An `xarray.Dataset` that shows its maps above its numbers."""

    __slots__ = ()
