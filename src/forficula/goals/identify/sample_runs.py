"""The runs of a sample: its design under every condition that a fact asks for, built when it is asked for."""

from __future__ import annotations

from collections.abc import Mapping

from forficula.design import Design, put, with_values
from forficula.errors import InputError
from forficula.structure import structure_of
from forficula.study.evaluate import row_key
from forficula.study.journal import Row
from forficula.study.search import until_driven


class SampleRuns:
    """Designs of a sample by condition; each is built once.

    Attributes:
        design: of the sample.
    """

    def __init__(self, design: Design) -> None:
        self.design = design
        self._stages = {each.name: each.stage for each in structure_of(design).transitions}
        self._built: dict[tuple[str | None, tuple[tuple[str, object], ...]], tuple[str, Design] | None] = {}

    def at(self, values: Mapping[str, object], until: str | None) -> tuple[str, Design] | None:
        """The key of a row and its design; None where there is no such design.

        Args:
            values: of the condition, by key, as a design file has them.
            until: name of the transition with whose stage the run ends; None for the whole protocol.
        """
        name = until, tuple(sorted(values.items()))
        if name not in self._built:
            self._built[name] = self._build(values, until)
        return self._built[name]

    def _build(self, values: Mapping[str, object], until: str | None) -> tuple[str, Design] | None:
        try:
            design = with_values(self.design, dict(values))
        except InputError:
            return None
        if until is not None:
            stage = self._stages[until]
            assert stage is not None
            design = put(design, "protocol.stages", until_driven(design.protocol.stages, stage))
        return row_key(design), design


Rows = Mapping[str, Row]
