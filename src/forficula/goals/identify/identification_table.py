"""An identification as a notebook shows it. Only what makes one imports this, for xarray takes long to load."""

from __future__ import annotations

import xarray

from forficula.displayed import Displayed


class IdentificationTable(Displayed, xarray.Dataset):  # type: ignore[no-untyped-call]
    """An `xarray.Dataset` that a notebook shows with what it says."""

    __slots__ = ()
