"""Runs of one compiled model with several protocols."""

from dataclasses import replace

from forficula.design import Design
from forficula.dynamics import Model, design_in_model_units
from forficula.structure import with_protocol


def on_protocol(model: Model, design: Design) -> Model:
    """Return the model with the protocol of a design that differs in its protocol only; both share the engine model."""
    return replace(
        model,
        design=design,
        structure=with_protocol(model.structure, design),
        in_units=with_protocol(model.in_units, design_in_model_units(design, model.units)),
    )
