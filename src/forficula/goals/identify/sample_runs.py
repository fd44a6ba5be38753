"""Runs of a sample: its design under every condition that a fact needs, built when it is needed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from forficula.design import Design, put, with_values
from forficula.errors import InputError
from forficula.structure import structure_of
from forficula.study.running.evaluate import row_key
from forficula.study.running.journal import Row
from forficula.study.study_designs import until_driven

Rows = Mapping[str, Row]
Values = Mapping[str, object]


@dataclass(frozen=True, kw_only=True)
class ConditionRun:
    """A run of a sample under a condition.

    Attributes:
        key: key of its row.
        design: design to run.
        values: values of the unknowns and of the condition, by key, as in a design file.
    """

    key: str
    design: Design
    values: Values


Wanted = dict[str, ConditionRun]


class SampleRuns:
    """Runs of a sample by condition. The design of each is built once."""

    def __init__(self, base: Design, values: Values) -> None:
        """Start with the values of a sample.

        Args:
            base: design with all known values.
            values: values of the unknowns, by key.

        Raises:
            InputError: the values are not allowed.
        """
        self._values = values
        self._design = with_values(base, values)
        self._stages = {transition.name: transition.stage for transition in structure_of(self._design).transitions}
        self._built: dict[tuple[str | None, tuple[tuple[str, object], ...]], ConditionRun | None] = {}

    def at(self, values: Values, until: str | None) -> ConditionRun | None:
        """Return the run under a condition; None if its values are not allowed.

        Args:
            values: values of the condition, by key, as in a design file.
            until: name of the transition after whose stage the run ends; None for the whole protocol.
        """
        name = until, tuple(sorted(values.items()))
        if name not in self._built:
            self._built[name] = self._build(values, until)
        return self._built[name]

    def _build(self, values: Values, until: str | None) -> ConditionRun | None:
        try:
            design = with_values(self._design, values)
        except InputError:
            return None
        if until is not None:
            stage = self._stages[until]
            assert stage is not None
            design = put(design, "protocol.stages", until_driven(design.protocol.stages, stage))
        return ConditionRun(key=row_key(design), design=design, values={**self._values, **values})
