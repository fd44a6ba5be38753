"""What a new study, goal or observations file starts from: a design of a kind, and a value of it that varies."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from textwrap import wrap

from forficula.design import Design, key_quantity, key_value, load_design
from forficula.design.kinds import KINDS, OTHER_REFERENCE
from forficula.errors import InputError
from forficula.files import check_new
from forficula.names import one_of
from forficula.quantities import Unit, format_quantity, show_quantity

_WIDTH = 116


@dataclass(frozen=True, kw_only=True)
class Start:
    """A design and a key of it whose values a template has.

    Attributes:
        kind: of the pattern of the design.
        name: of the design.
        design: the same.
        key: that varies.
    """

    kind: str
    name: str
    design: Design
    key: str

    def times(self, share: float) -> str:
        """So many times the design's own value, as a file has it, all digits of it."""
        return format_quantity(share * self._own, self._unit)

    @property
    def texts(self) -> dict[str, str]:
        """What every template names: kind, design, key, and half, once and twice its value."""
        low, own, high = (self.times(share) for share in (0.5, 1.0, 2.0))
        return {"kind": self.kind, "design": self.name, "key": self.key, "low": low, "value": own, "high": high}

    def about(self, share: float) -> str:
        """The same in a few digits."""
        return show_quantity(share * self._own, self._unit)

    @property
    def _own(self) -> float:
        return float(key_value(self.design, self.key))

    @property
    def _unit(self) -> Unit:
        quantity = key_quantity(self.key, type(self.design))
        assert quantity is not None
        return quantity.unit


def start_of(path: Path, kind: str) -> Start:
    """What a new file starts from.

    Args:
        path: of the file.
        kind: of the pattern of the design that it varies, one of `KINDS`.

    Raises:
        InputError: no such kind, or the file exists already, or is no .toml.
    """
    if kind not in KINDS:
        raise InputError(f"kind: need {one_of(KINDS, kind)}")
    check_new(path, ".toml")
    name = KINDS[kind].reference or OTHER_REFERENCE
    design = load_design(name)
    return Start(kind=kind, name=name, design=design, key=design.varied_key)


def commented(text: str) -> str:
    """A long comment on several lines, all but the first with their #."""
    return "\n# ".join(wrap(text, _WIDTH, break_long_words=False, break_on_hyphens=False))
