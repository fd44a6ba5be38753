"""Every refusal of a value in a design names the key, the value and the rule; wording is tested once per rule."""

import re

import pytest

from forficula.design import load_design
from forficula.design.files.design_keys import design_keys
from forficula.errors import InputError

ALLOWED = re.compile("need |write it such as |neither .* nor ")
DESIGNS = {name: load_design(name) for name in ("binder2025", "letter-fold", "miura-sheet", "binder2025-joint")}
# with values, except sections whose kind determines their keys
KEYS = [
    (name, key.fact.key)
    for name, design in DESIGNS.items()
    for key in design_keys(design)
    if key.value and not key.fact.key.startswith(("drive.", "measure.", "support.", "tendon.law."))
]


def refusal(name, key, value):
    """Return the message with which a value is refused, or None."""
    try:
        load_design(name, {key: value})
    except InputError as error:
        return str(error)
    return ""


@pytest.mark.parametrize("value", ["-3 parsec", "qqq", "-7e77"])
def test_every_refusal_names_the_key_the_value_and_what_is_allowed(value):
    names = {key: name for name, key in KEYS}
    messages = {key: refusal(name, key, value) for key, name in names.items()}
    refused = {key: message for key, message in messages.items() if message}
    assert len(refused) > len(messages) / 2
    for key, message in refused.items():
        assert len(message.splitlines()) == 1
        # a contradiction with another key begins with the design's name; a missing name is reported where it is used
        section = "" if key.endswith(".name") else key.rpartition(".")[0]
        assert re.match(rf"(\S+: )?{re.escape(section)}[.\w]*: ", message), message
        # as written, or counted or converted
        assert value in message or ", got " in message, message
    assert [message for message in refused.values() if not ALLOWED.search(message)] == []
